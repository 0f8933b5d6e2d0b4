"""SetState, Paint and Reach: what things look like and whether they are open or on, and whether a way leads there."""

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.doing.work import Done, Work, listed
from mansion_editing.instructions.meaning.choices import able_ones, concerned, one_room_each, things_meant
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.descriptions import rooms_of
from mansion_editing.instructions.meaning.doors import doors_meant, means_doors
from mansion_editing.instructions.meaning.nouns import has_colour, has_material
from mansion_editing.instructions.meaning.wording import thing_words
from mansion_editing.instructions.statements import Paint, Reach, Rooms, SetState, Things
from mansion_editing.runs.policies import Unmet, ask
from mansion_editing.state import SceneState
from mansion_msgs_py.editing.questions import PathReport
from mansion_msgs_py.scene import SceneObject

__all__ = ["able", "ends_of", "paint", "reach", "set_state", "state_word"]

_WORDS = {("open", True): "open", ("open", False): "closed", ("on", True): "on", ("on", False): "off"}


_WHATEVER: Final = re.compile(r"\b(all|every|everything|any|each|whatever|no)\b", re.IGNORECASE)
"""Words that mean as many as there are, none among them; "close the curtains" says that there are some."""


_REMAINING: Final = re.compile(r"\b(remains?|stays?|leave|left|keep|kept)\b", re.IGNORECASE)


def state_word(state: str, *, value: bool) -> str:
    """Return the word for a state of a thing."""
    return _WORDS[state, value]


def able(item: SceneObject, state: str) -> bool:
    """Whether an object opens, or switches."""
    return item.openable if state == "open" else item.toggleable


def set_state(statement: SetState, state: SceneState, context: Context) -> Work:
    """Open, close or switch the things that words mean; of several for one thing, the one that is not so yet."""
    name, value = statement.state, statement.value
    if means_doors(statement.things):
        return (yield from _swing(statement, state, context))
    things = able_ones(state, statement.things, context, lambda item: able(item, name))
    word = state_word(name, value=value)
    found = concerned(state, things, context)
    if not found and things.amount.kind == "all" and things.noun and _WHATEVER.search(statement.quote):
        return Done(f"there was nothing to do: there is no {thing_words(things)}", context)
    ready = {item.id for item in found if able(item, name)}
    if found and not ready:
        what = "open or close" if name == "open" else "switch on or off"
        raise Unmet(f"{listed(found)} {'does' if len(found) == 1 else 'do'} not {what}")
    other = {item.id for item in found if item.id in ready and bool(item.states.get(name, False)) != value}
    preferred = other if len(other) == 1 else ready
    some = things.amount.kind == "some" and not things.amount.of
    unable = frozenset(item.id for item in found if some and item.id not in ready)
    meant = replace(context, kept=context.kept | unable)
    chosen = things_meant(state, things, meant, lambda item: item.id in preferred)
    chosen = [item for item in chosen if item.id in ready]
    if not chosen:
        raise Unmet(f"{thing_words(things)} cannot be {word}")
    left_out = [item for item in found if item.id not in ready]
    if left_out and things.amount.kind == "all" and things.amount.number > 1:
        raise Unmet(f"{listed(left_out)} cannot be {word}, only {listed(chosen)}")
    changing = [item for item in chosen if item.id in other]
    for item in changing:
        yield from ask(f"{item.id} should be {word}.", "SetState", {"object_id": item.id, name: value})
    rest = [item for item in chosen if item.id not in other]
    reply = f"{listed(changing)} {'is' if len(changing) == 1 else 'are'} now {word}" if changing else ""
    if rest:
        reply += "; " if reply else "there was nothing to do: "
        reply += f"{listed(rest)} {'is' if len(rest) == 1 else 'are'} {word} already"
    rooms = tuple(dict.fromkeys(item.room for item in chosen))
    return Done(reply, context.followed([item.id for item in chosen], rooms, things.noun))


def _swing(statement: SetState, state: SceneState, context: Context) -> Work:
    """Open or close doors of the building."""
    if statement.things.refers == "others" and _REMAINING.search(statement.quote):
        return Done("", context)
    if statement.state != "open":
        raise Unmet("a door opens and closes; it does not switch on or off")
    meant = doors_meant(state, statement.things, context)
    word = state_word("open", value=statement.value)
    changing = [door.id for door in meant if door.is_open != statement.value]
    for name in changing:
        yield from ask(f"{name} should be {word}.", "SetState", {"object_id": name, "open": statement.value})
    rest = [door.id for door in meant if door.id not in changing]
    told = [f"{listed(changing)} {'is' if len(changing) == 1 else 'are'} now {word}"] if changing else []
    told += [f"{listed(rest)} {'is' if len(rest) == 1 else 'are'} {word} already"] if rest else []
    return Done("; ".join(told), context)


def _some(chosen: list[SceneObject], things: Things) -> list[SceneObject]:
    if not chosen:
        raise Unmet(f"no {thing_words(things)} is left besides those that shall stay")
    return chosen


def paint(statement: Paint, state: SceneState, context: Context) -> Work:
    """Give things a colour, a material or both."""
    chosen = _some(things_meant(state, statement.things, context), statement.things)
    look = " ".join(word for word in (statement.colour, statement.material) if word)
    changed = []
    for item in chosen:
        coloured = not statement.colour or has_colour(item, statement.colour)
        if coloured and (not statement.material or has_material(item, statement.material)):
            continue
        arguments = {"object_id": item.id, "color": statement.colour, "material": statement.material}
        yield from ask(f"{item.id} should be {look}.", "PaintObject", {k: v for k, v in arguments.items() if v})
        changed.append(f"{item.id} (was {item.material.replace('_', ' ')})")
    reply = f"now {look}: {', '.join(changed)}" if changed else f"{listed(chosen)}: {look} already"
    rooms = tuple(dict.fromkeys(item.room for item in chosen))
    return Done(reply, context.followed([i.id for i in chosen], rooms, statement.things.noun))


def reach(statement: Reach, state: SceneState, context: Context) -> Work:
    """See that a robot gets from one place to another; furniture is not moved for it."""
    replies = []
    ends = ends_of(statement.end, state, context)
    for start in ends_of(statement.start, state, context):
        for end in ends:
            question = f"Does a way lead from {start or 'the entrance'} to {end or 'every room'}?"
            report: PathReport = yield from ask(question, "CheckPath", {"start": start, "end": end})
            if not report.reachable:
                raise Unmet(report.message)
            replies.append(report.message)
    return Done("; ".join(replies), context.followed((), [end for end in ends if state.room(end)], ""))


def ends_of(end: Things | Rooms | None, state: SceneState, context: Context) -> Sequence[str]:
    """Return the ids of rooms that an end of a way means, an empty one for the entrance or every room."""
    if end is None:
        return [""]
    if isinstance(end, Rooms):
        core = {"stair": "stairs", "staircase": "stairs", "stairwell": "stairs", "elevator": "elevator"}.get(end.words)
        if end.words == "entrance" and not rooms_of(state, end, context):
            return [""]
        if core is not None:
            return [f"{core} on floor {floor}" for floor in end.floors] or [core]
        return rooms_of(state, end, context) or one_room_each(state, end, context)
    return list(dict.fromkeys(item.room for item in things_meant(state, end, context)))
