"""Checks of statements about what things and rooms are like: SetState, Paint, Reach and those of rooms."""

from mansion_editing.instructions.checking.differences import Differences
from mansion_editing.instructions.checking.finding import Finding, numbers_meant
from mansion_editing.instructions.doing.work import listed
from mansion_editing.instructions.meaning.choices import able_ones, concerned
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.descriptions import rooms_of, things_of
from mansion_editing.instructions.meaning.doors import doors_meant, means_doors
from mansion_editing.instructions.meaning.nouns import has_colour, has_material
from mansion_editing.instructions.meaning.wording import thing_words
from mansion_editing.instructions.statements import (
    Finish,
    Furnish,
    Paint,
    Reach,
    Rename,
    Reshape,
    Rooms,
    SetState,
    Things,
)
from mansion_editing.state import SceneState
from mansion_editing.tools.paths import check_path
from mansion_language.colours import COLOUR_WORDS
from mansion_msgs_py.editing.questions import CheckPathArgs
from mansion_msgs_py.scene import SceneObject
from mansion_scene.structure.materials import library

__all__ = ["check_paint", "check_reach", "check_rooms", "check_state"]


def check_state(
    statement: SetState, before: SceneState, after: SceneState, context: Context, diff: Differences
) -> Finding:
    """Check that the things meant are open, closed, on or off, and that nothing else of them changed."""
    name, value = statement.state, statement.value
    if means_doors(statement.things):
        return _check_doors(statement, before, after, context, diff)
    things = able_ones(before, statement.things, context, lambda item: _has(item, name))
    fitting = [item for item in concerned(before, things, context) if _has(item, name)]
    now = [found[1] for item in fitting if (found := after.find(item.id)) is not None]
    good = {item.id for item in now if bool(item.states.get(name, False)) == value}
    changed = [item.id for item in fitting if item.id in diff.changed]
    reason = _number_fault(things, fitting, good, changed)
    others = [key for key in changed if not _only_state(*diff.changed[key], name)]
    if others:
        reason = f"{listed(others)} changed in more than this"
    return Finding(reason, set(changed))


def _check_doors(
    statement: SetState, before: SceneState, after: SceneState, context: Context, diff: Differences
) -> Finding:
    """Check that the doors meant are open or closed, and no others that the words fit have changed."""
    if statement.things.refers == "others":
        return Finding()  # they remain as they are: none may have changed
    meant = {door.id for door in doors_meant(before, statement.things, context)}
    now = [door for scene in after.scenes.values() for door in scene.doors if door.id in meant]
    wrong = [door.id for door in now if door.is_open != statement.value]
    return Finding(f"{listed(wrong)} did not change" if wrong or len(now) != len(meant) else "", meant & diff.doors)


def _has(item: SceneObject, state: str) -> bool:
    return item.openable if state == "open" else item.toggleable


def _only_state(old: SceneObject, new: SceneObject, name: str) -> bool:
    rest = [{key: value for key, value in item.states.items() if key != name} for item in (old, new)]
    return rest[0] == rest[1] and (old.material, old.color, old.name) == (new.material, new.color, new.name)


def _number_fault(things: Things, fitting: list[SceneObject], good: set[str], changed: list[str]) -> str:
    low, high = numbers_meant(things, fitting)
    if not fitting and things.amount.kind == "all":
        return ""
    if len(good) < max(1, low):
        return f"{len(good)} of {len(fitting)} {thing_words(things)} are as they should be"
    wrong = [name for name in changed if name not in good]
    if wrong:
        return f"{listed(wrong)} changed, but not to this"
    return f"{listed(changed)} changed, though {high} were meant" if len(changed) > high else ""


def check_paint(
    statement: Paint, before: SceneState, after: SceneState, context: Context, diff: Differences
) -> Finding:
    """Check that the things meant have the colour and the material."""
    fitting = concerned(before, statement.things, context)
    now = [found[1] for item in fitting if (found := after.find(item.id)) is not None]
    good = {
        item.id
        for item in now
        if (not statement.colour or has_colour(item, statement.colour))
        and (not statement.material or has_material(item, statement.material))
    }
    changed = [item.id for item in fitting if item.id in diff.changed]
    return Finding(_number_fault(statement.things, fitting, good, changed), set(changed))


def check_reach(
    statement: Reach, before: SceneState, after: SceneState, context: Context, diff: Differences
) -> Finding:
    """Check that ways lead there in the scene as it is."""
    for start in _ends(statement.start, after, context):
        for end in _ends(statement.end, after, context):
            report = check_path(after, CheckPathArgs(start=start, end=end))
            if not report.reachable:
                return Finding(report.message)
    return Finding()


def _ends(end: Things | Rooms | None, state: SceneState, context: Context) -> list[str]:
    if end is None:
        return [""]
    if isinstance(end, Rooms):
        return rooms_of(state, end, context)[: None if end.every else 1]
    return list(dict.fromkeys(item.room for item in things_of(state, end, context)))[: None if end.plural else 1]


def check_rooms(
    statement: Rename | Finish | Furnish | Reshape,
    before: SceneState,
    after: SceneState,
    context: Context,
    diff: Differences,
) -> Finding:
    """Check that the rooms are what the words ask for; which rooms may differ is all that they say of the others."""
    words = statement.room if isinstance(statement, Rename) else statement.rooms
    rooms = set() if words is None else set(rooms_of(before, words, context))
    if isinstance(statement, Rename):
        named = [found[1].name for room in rooms if (found := after.room(room)) is not None]
        return Finding("" if statement.name in named else f"no room is called {statement.name}", set(), rooms)
    if isinstance(statement, Finish):
        return Finding(_finish_fault(statement, after, rooms), set(), rooms | _floors(rooms))
    inside = {name for name, item in {**diff.removed, **diff.added}.items() if item.room in rooms}
    inside |= {name for name, (old, new) in {**diff.moved, **diff.changed}.items() if {old.room, new.room} <= rooms}
    if isinstance(statement, Furnish):
        return Finding("", inside, rooms)
    return Finding("" if diff.rooms else "the storey is as it was", diff.ids, set(diff.rooms))


def _floors(rooms: set[str]) -> set[str]:
    """Return the structure of the storeys of rooms: the faces of walls are part of it."""
    return {f"floor {room.split('/', 1)[0].removeprefix('F')}" for room in rooms}


def _finish_fault(statement: Finish, after: SceneState, rooms: set[str]) -> str:
    for room in sorted(rooms):
        found = after.room(room)
        if found is None:
            return f"{room} is gone"
        part = {"walls": found[1].wall_material, "floor": found[1].floor_material, "ceiling": found[1].ceiling_material}
        name = part[statement.part]
        known = library().get(name)
        told = {*name.split("_"), *(known.keywords if known is not None else ())}
        asked = [COLOUR_WORDS.get(word, word) for word in f"{statement.colour} {statement.material}".lower().split()]
        if not name or not any({word, word.rstrip("s"), f"{word}s"} & told for word in asked):
            return f"the {statement.part} of {room} is {part[statement.part] or 'as it was'}"
    return ""
