"""What an instruction takes from earlier ones: what "it" and "there" mean, and doing the same again elsewhere."""

from collections.abc import Sequence
from typing import Any

import msgspec

from mansion_editing.editor import Answered, SceneEditor
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.descriptions import rooms_of
from mansion_editing.instructions.meaning.room_words import room_order
from mansion_editing.instructions.paraphrases.reading import read_in_other_words
from mansion_editing.instructions.statements import (
    Add,
    Amount,
    Ensure,
    History,
    Instruction,
    Mention,
    Place,
    Rooms,
    Statement,
    Things,
)
from mansion_editing.state import SceneState
from mansion_msgs_py.editing.changes import Transaction
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["amended", "brief_of", "context_of", "is_taken_back", "remember", "repeated"]

MOST_STEPS_BACK = 20
"""How many instructions that only repeat one another are gone back through."""


def brief_of(editor: SceneEditor) -> str:
    """Return the brief that the building was made from."""
    building = editor.store.building
    return building.program.description or building.request.description


def context_of(editor: SceneEditor) -> Context:
    """Return what the user's last edit was about, which "it" and "there" may mean; empty before the first."""
    landed = editor.store.edit_log.landed_by(editor.who)
    asked = editor.answered
    if asked is not None and asked.edits == len(landed):
        return Context(asked.things, asked.rooms, asked.noun)
    last = _last(editor)
    if last is None:
        return Context()
    state = editor.state
    there = [found for change in last.changes if (found := state.find(change.id)) is not None]
    objects = [change.after or change.before for change in last.changes]
    rooms = dict.fromkeys(item.room for item in objects if item is not None)
    kinds = {item.category for item in objects if item is not None}
    noun = kinds.pop().replace("_", " ") if len(kinds) == 1 else ""
    return Context(tuple(item.id for _, item in there), tuple(rooms), noun)


def remember(editor: SceneEditor, context: Context) -> None:
    """Keep what a question was about, which the next instruction may refer to; an edit is told by the log."""
    edits = len(editor.store.edit_log.landed_by(editor.who))
    editor.answered = Answered(edits, context.things, context.rooms, context.noun)


def _last(editor: SceneEditor) -> Transaction | None:
    log = editor.store.edit_log
    landed = log.landed_by(editor.who)
    return log.transaction(landed[-1]) if landed else None


def is_taken_back(statement: Statement, editor: SceneEditor) -> bool:
    """Whether words ask for the whole last edit to be taken back: ``undo``, ``put it back``.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for something to be put back that the last edit did not touch.
    """
    if not isinstance(statement, History) or statement.what not in ("undo", "restore"):
        return False
    things = statement.things
    if statement.what == "undo" or things is None or things.refers == "last":
        return True
    last = _last(editor)
    names = [change.id.rsplit("/", 1)[-1] for change in last.changes] if last is not None else []
    words = things.noun.split()[-1:]
    if not names or not all(any(word in name for word in words) for name in names):
        raise MansionError(ErrorCode.NOT_FOUND, f"the last edit was not about the {things.noun}; nothing to put back")
    return True


def repeated(instruction: Instruction, editor: SceneEditor) -> Instruction:
    """Return an instruction with the statements of an earlier one in place of ``the same upstairs`` or ``one more``.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` where there is no earlier instruction, or no next room.
    """
    statements: list[Statement] = []
    for statement in instruction.statements:
        if isinstance(statement, History) and statement.what == "repeat":
            statements += _again(statement, _earlier(editor), editor.state)
        else:
            statements.append(statement)
    return msgspec.structs.replace(instruction, statements=statements)


def amended(statement: History, editor: SceneEditor) -> list[Statement]:
    """Return the statements of the last instruction at the place, or with the things, that were meant.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` where there is no earlier instruction, or it has none of that kind.
    """
    earlier = _earlier(editor)
    if statement.things is not None:
        changed = [_with_things(one, statement.things) for one in earlier]
    else:
        changed = [_elsewhere(one, statement.place or Place()) for one in earlier]
    if changed == earlier:
        raise MansionError(ErrorCode.NOT_FOUND, f"the last instruction is the same with {statement.quote!r}")
    return [msgspec.structs.replace(one, quote=statement.quote) for one in changed]


def _with_things(statement: Statement, things: Things) -> Statement:
    own = getattr(statement, "things", None)
    if not isinstance(own, Things):
        return statement
    noun = own.noun if not things.noun or things.noun.endswith("one") else things.noun
    changed = msgspec.structs.replace(
        own,
        noun=noun,
        colour=things.colour or own.colour,
        material=things.material or own.material,
        place=things.place or own.place,
        ordinal=things.ordinal or own.ordinal,
    )
    return msgspec.structs.replace(statement, things=changed)


def _earlier(editor: SceneEditor) -> list[Statement]:
    log = editor.store.edit_log
    landed = log.landed_by(editor.who)
    for number in reversed(landed[-MOST_STEPS_BACK:]):
        read = read_in_other_words(log.transaction(number).what, editor.state, brief_of(editor))
        asked: list[Statement] = [s for s in read.statements if not isinstance(s, Mention)]
        if asked and not read.not_understood and not any(isinstance(s, History) for s in asked):
            return asked
    raise MansionError(ErrorCode.NOT_FOUND, "there is no earlier instruction of yours to repeat")


def _again(statement: History, earlier: Sequence[Statement], state: SceneState) -> list[Statement]:
    if statement.things is not None:
        return [_more_of(statement.things, earlier, statement.quote)]
    if statement.place is None or statement.place == Place():
        return [msgspec.structs.replace(one, quote=statement.quote) for one in earlier]
    place = statement.place
    if place.rooms is not None and place.rooms.same and place.rooms.next_to:
        place = Place(rooms=Rooms(words=_next_room(earlier, state)))
    return [msgspec.structs.replace(_elsewhere(one, place), quote=statement.quote) for one in earlier]


def _more_of(things: Things, earlier: Sequence[Statement], quote: str) -> Statement:
    """Return the last thing that was brought, once more."""
    last = next((one for one in reversed(earlier) if isinstance(one, Add | Ensure)), None)
    if last is None:
        raise MansionError(
            ErrorCode.NOT_FOUND, "your last instruction brought nothing of which there could be one more"
        )
    noun = things.noun or last.things.noun
    amount = Amount(kind="more", number=max(1, things.amount.number))
    more = msgspec.structs.replace(last.things, noun=noun, amount=amount, plural=amount.number > 1)
    return Add(things=more, place=last.place, each=last.each, quote=quote)


def _next_room(earlier: Sequence[Statement], state: SceneState) -> str:
    """Return the room of the same type that comes next after the one of an earlier instruction."""
    named = next((rooms for one in earlier if (rooms := _rooms_in(one)) is not None), None)
    ids = [] if named is None else rooms_of(state, named, Context())
    found = None if not ids else state.room(ids[-1])
    if found is None:
        raise MansionError(ErrorCode.NOT_FOUND, "the earlier instruction names no room; say which room is meant")
    alike = sorted((room for _, room in state.rooms() if room.room_type == found[1].room_type), key=room_order)
    at = [room.id for room in alike].index(found[1].id)
    if at + 1 >= len(alike):
        kind = found[1].room_type.replace("_", " ")
        raise MansionError(ErrorCode.NOT_FOUND, f"there is no {kind} after {found[1].id}")
    return alike[at + 1].id


def _rooms_in(value: Any) -> Rooms | None:
    if isinstance(value, Rooms):
        return value
    if isinstance(value, tuple | list):
        return next((rooms for part in value if (rooms := _rooms_in(part)) is not None), None)
    if isinstance(value, msgspec.Struct):
        return _rooms_in([getattr(value, name) for name in value.__struct_fields__])
    return None


def _elsewhere(statement: Statement, place: Place) -> Statement:
    """Return a statement with other rooms wherever it names rooms, else with them where it says where."""
    changed = _with_rooms(statement, place.rooms)
    if changed == statement and hasattr(statement, "place"):
        return msgspec.structs.replace(statement, place=place)
    result: Statement = changed
    return result


def _with_rooms(value: Any, rooms: Rooms | None) -> Any:
    if isinstance(value, Rooms) and rooms is not None:
        if not rooms.words and rooms.floors:
            return msgspec.structs.replace(value, floors=rooms.floors)
        return rooms
    if isinstance(value, tuple):
        return tuple(_with_rooms(part, rooms) for part in value)
    if not isinstance(value, msgspec.Struct):
        return value
    parts = {name: _with_rooms(getattr(value, name), rooms) for name in value.__struct_fields__}
    return msgspec.structs.replace(value, **parts)
