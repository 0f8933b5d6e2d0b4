"""Ask: questions about the building, answered from the scene in whole sentences."""

from collections import Counter
from collections.abc import Sequence

import msgspec

from mansion_editing.instructions.doing.changing import able, state_word
from mansion_editing.instructions.doing.work import Done, listed, whereabouts
from mansion_editing.instructions.meaning.choices import one_room_each
from mansion_editing.instructions.meaning.context import Context, ambiguous
from mansion_editing.instructions.meaning.descriptions import all_at, anchors_of, carried_by, rooms_of, things_of
from mansion_editing.instructions.meaning.doors import door_title, doors_meant, means_doors
from mansion_editing.instructions.meaning.room_words import room_title
from mansion_editing.instructions.meaning.wording import counted, place_words, title_of
from mansion_editing.instructions.phrases.places import with_place
from mansion_editing.instructions.statements import Amount, Ask, Place, Rooms, Things
from mansion_editing.state import SceneState
from mansion_editing.tools.paths import check_path
from mansion_language.colours import colour_of
from mansion_msgs_py.editing.questions import CheckPathArgs
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import Door, SceneObject

__all__ = ["answer", "holds"]


def answer(question: Ask, state: SceneState, context: Context) -> Done:
    """Answer a question; nothing is changed.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a question about rooms or things that are not there.
    """
    them = question.things is not None and question.things.refers == "last" and not question.things.noun
    if question.about == "count" and them and context.noun:
        here = question.place or (Place(rooms=Rooms(same=True, every=True)) if context.rooms else None)
        counted_things = Things(noun=context.noun, plural=True, amount=Amount(kind="all", number=0))
        question = msgspec.structs.replace(question, things=counted_things, place=here)
    if question.about == "exists" and them and context.noun and question.place and not _is_definite(question):
        question = msgspec.structs.replace(question, things=Things(noun=context.noun))
    if question.about in ("rooms", "area") or (question.about == "where" and question.things is None):
        return _of_rooms(question, state, context)
    if question.about == "reach":
        return _of_ways(question, state, context)
    if question.about == "state" and question.things is not None and means_doors(question.things):
        swung = [(door, "open" if door.is_open else "closed") for door in _doors(question, state, context)]
        return Done("; ".join(f"{door_title(state, door)} is {word}" for door, word in swung), context)
    found = _found(question, state, context)
    said = _said(question)
    reply = {"count": _count, "exists": _exists, "where": _where, "what": _what, "state": _states, "colour": _colours}[
        question.about
    ](question, found, said, state)
    rooms = tuple(dict.fromkeys(item.room for item in found))
    noun = "" if question.things is None else question.things.noun
    return Done(reply, context.followed([item.id for item in found], rooms, noun))


def _is_definite(question: Ask) -> bool:
    """Whether a question is about those that were mentioned, and not about any of the kind."""
    return question.things is not None and question.things.definite


def holds(question: Ask, state: SceneState, context: Context) -> bool:
    """Whether the answer to a question of yes or no is yes.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a question about rooms or things that are not there.
    """
    if question.place is not None and question.place.anchor is not None and question.about == "exists":
        things = question.things or Things(plural=True)
        return _is_so_many(len(all_at(state, things_of(state, things, context), question.place, context)), things)
    if question.about == "state" and question.things is not None and means_doors(question.things):
        return all(door.is_open == question.value for door in _doors(question, state, context))
    found = _found(question, state, context)
    if question.about == "state":
        name = question.state or "open"
        ready = [item for item in found if able(item, name)]
        if not ready:
            raise MansionError(ErrorCode.NOT_FOUND, f"there is no {_noun(question)}{_said(question)}")
        values = [bool(item.states.get(name, False)) == question.value for item in ready]
        one = question.things is not None and not question.things.plural
        if one and len(set(values)) > 1:
            raise ambiguous(_noun(question), [title_of(state, item) for item in ready], [item.id for item in ready])
        return all(values)
    return _is_so_many(len(found), question.things)


def _doors(question: Ask, state: SceneState, context: Context) -> list[Door]:
    """Return the doors that a question is about."""
    things = question.things or Things()
    place = question.place or (None if question.rooms is None else Place(rooms=question.rooms))
    return doors_meant(state, things if place is None else with_place(things, place), context)


def _is_so_many(count: int, things: Things | None) -> bool:
    """Whether a number is what words say: at most and exactly so many, otherwise so many or more."""
    if things is None:
        return count > 0
    amount = things.amount
    if amount.kind in ("at_most", "exactly"):
        return count <= amount.number and (amount.kind == "at_most" or count == amount.number)
    return count >= max(1, amount.number)


def _found(question: Ask, state: SceneState, context: Context) -> list[SceneObject]:
    things = question.things or Things(plural=True)
    found = things_of(state, things, context)
    place = question.place
    if place is None:
        return _in(question.rooms, found, state, context)
    if place.rooms is not None:
        one_room_each(state, place.rooms, context, lambda room: any(item.room == room for item in found))
    if place.anchor is not None and not anchors_of(state, place, context):
        raise MansionError(ErrorCode.NOT_FOUND, f"there is nothing {place_words(place)}: no such thing is there")
    if question.about == "what" and not things.noun and place.anchor is not None:
        relations = [place.relation] if place.relation in ("on", "in") else []
        there = [i for a in anchors_of(state, place, context) for r in relations for i in carried_by(state, a, r)]
        if relations:
            return list({item.id: item for item in there}.values())
    return all_at(state, found, place, context)


def _in(rooms: Rooms | None, found: list[SceneObject], state: SceneState, context: Context) -> list[SceneObject]:
    if rooms is None:
        return found
    inside = set(one_room_each(state, rooms, context, lambda room: any(item.room == room for item in found)))
    return [item for item in found if item.room in inside]


def _said(question: Ask) -> str:
    rooms = None if question.rooms is None else Place(rooms=question.rooms)
    place = question.place or rooms
    return f" {place_words(place)}" if place is not None else ""


def _noun(question: Ask) -> str:
    things = question.things
    if things is None or not things.noun:
        return "thing"
    return " ".join(word for word in (things.colour, things.material, things.noun) if word)


def _count(question: Ask, found: Sequence[SceneObject], said: str, state: SceneState) -> str:
    verb = "is" if len(found) == 1 else "are"
    if not found:
        return f"There are {counted(0, _noun(question))}{said or ' in the building'}."
    by_room = {room: sum(item.room == room for item in found) for room in dict.fromkeys(i.room for i in found)}
    if len(by_room) == 1 and said:
        return f"There {verb} {counted(len(found), _noun(question))}{said}{_by_kind(found)}."
    spread = ", ".join(f"{number} in {room_title(state, room)}" for room, number in by_room.items())
    return f"There {verb} {counted(len(found), _noun(question))}{said or ' in the building'}: {spread}."


def _by_kind(found: Sequence[SceneObject]) -> str:
    """Return how many of each kind things are, where a word fits several kinds: servers' racks and racks for shoes."""
    kinds = Counter(item.category.replace("_", " ") for item in found)
    return f": {', '.join(counted(number, kind) for kind, number in kinds.items())}" if len(kinds) > 1 else ""


def _exists(question: Ask, found: Sequence[SceneObject], said: str, state: SceneState) -> str:
    if not found:
        return f"No, there is no {_noun(question)}{said or ' in the building'}."
    verb = "is" if len(found) == 1 else "are"
    word = "Yes" if _is_so_many(len(found), question.things) else "No"
    none = _places_without(question, found, state)
    if none and word == "Yes":
        told = f"{counted(len(found), _noun(question))}: {listed(found)}"
        return f"Not everywhere: there {verb} {told}; none {', '.join(none)}."
    return f"{word}, there {verb} {counted(len(found), _noun(question))}{said}: {listed(found)}."


def _places_without(question: Ask, found: Sequence[SceneObject], state: SceneState) -> list[str]:
    """Return words for the rooms or storeys of a question about all of them where nothing of the kind is."""
    rooms = None if question.place is None else question.place.rooms
    if rooms is None or not rooms.every or rooms.same:
        return []
    having = {item.room for item in found}
    if rooms.words or len(rooms.floors) < 2:
        return [f"in {room_title(state, room)}" for room in rooms_of(state, rooms, Context()) if room not in having]
    storeys = {_floor_of(state, room) for room in having}
    return [f"on floor {floor}" for floor in rooms.floors if floor not in storeys]


def _where(question: Ask, found: Sequence[SceneObject], said: str, state: SceneState) -> str:
    if not found:
        return f"There is no {_noun(question)}{said or ' in the building'}."
    places = [f"{item.id} is {_in_full(item, state)}" for item in found[:12]]
    return "; ".join(places) + (f"; and {len(found) - 12} more." if len(found) > 12 else ".")


def _in_full(item: SceneObject, state: SceneState) -> str:
    room = room_title(state, item.room)
    if item.mount == "floor":
        return f"in {room}"
    return f"{whereabouts(item)} in {room}" if item.parent is not None else f"on the {item.mount} in {room}"


def _what(question: Ask, found: Sequence[SceneObject], said: str, state: SceneState) -> str:
    if not found:
        return f"There is nothing{said}."
    kinds: dict[str, int] = {}
    for item in found:
        kinds[item.name or item.category] = kinds.get(item.name or item.category, 0) + 1
    verb = "is" if len(found) == 1 else "are"
    where = f"{said.strip()[:1].upper()}{said.strip()[1:]} there" if said else "There"
    return f"{where} {verb} {', '.join(counted(number, kind) for kind, number in kinds.items())}: {listed(found)}."


def _states(question: Ask, found: Sequence[SceneObject], said: str, state: SceneState) -> str:
    name = question.state or "open"
    ready = [item for item in found if able(item, name)]
    if not ready:
        return f"There is no {_noun(question)}{said} that {'opens' if name == 'open' else 'switches'}."
    words = {item.id: state_word(name, value=bool(item.states.get(name, False))) for item in ready}
    wanted = state_word(name, value=question.value)
    yes = all(word == wanted for word in words.values())
    return f"{'Yes' if yes else 'No'}: {'; '.join(f'{key} is {word}' for key, word in words.items())}."


def _colours(question: Ask, found: Sequence[SceneObject], said: str, state: SceneState) -> str:
    if not found:
        return f"There is no {_noun(question)}{said or ' in the building'}."
    looks = [f"{item.id} is {_look(item)}" for item in found[:12]]
    return "; ".join(looks) + "."


def _look(item: SceneObject) -> str:
    family, _, shade = item.material.partition("_")
    return f"{colour_of(item.material) or shade or 'of no recorded colour'} ({family})" if family else "unrecorded"


def _of_rooms(question: Ask, state: SceneState, context: Context) -> Done:
    wanted = question.rooms or (question.place.rooms if question.place is not None else None) or Rooms(every=True)
    found = rooms_of(state, wanted, context)
    if question.things is not None:
        holding = {item.room for item in things_of(state, question.things, context)}
        found = [room for room in found if room in holding]
    if question.about == "area":
        found = one_room_each(state, wanted, context)
        rooms = [state.room(room) for room in found]
        areas = [f"{room_title(state, room[1].id)} has {room[1].area:.1f} m2" for room in rooms if room is not None]
        reply = "; ".join(areas) + "."
    elif not found:
        reply = f"There are no rooms called {wanted.words}." if wanted.words else "There are no such rooms."
    elif question.about == "where":
        reply = "; ".join(f"{room_title(state, room)} is on floor {_floor_of(state, room)}" for room in found) + "."
    else:
        reply = f"{counted(len(found), 'room')}: {', '.join(room_title(state, room) for room in found)}."
    return Done(reply, context.followed((), found, ""))


def _floor_of(state: SceneState, room: str) -> int:
    found = state.room(room)
    return 0 if found is None else found[0]


def _of_ways(question: Ask, state: SceneState, context: Context) -> Done:
    start = [""] if question.start is None else one_room_each(state, question.start, context)
    rooms = question.rooms or (question.place.rooms if question.place is not None else None)
    ends = [""] if rooms is None else one_room_each(state, rooms, context)
    if question.things is not None:
        ends = list(dict.fromkeys(item.room for item in things_of(state, question.things, context))) or ends
    replies = []
    for end in ends:
        report = check_path(state, CheckPathArgs(start=start[0], end=end))
        replies.append(f"{'Yes' if report.reachable else 'No'}: {report.message}")
    return Done("; ".join(replies) + ".", context.followed((), [end for end in ends if end], ""))
