"""Rooms that a pronoun of a later clause means: ``rename the study to Den and paint it green``."""

from collections.abc import Sequence

from mansion_editing.instructions.statements import Finish, Furnish, Mention, Paint, Rename, Rooms, Statement, Surface

__all__ = ["painted_rooms"]


def painted_rooms(statements: Sequence[Statement]) -> list[Statement]:
    """Return statements in which ``paint it`` right after words about one room means its walls."""
    out: list[Statement] = []
    for statement in statements:
        last = next((one for one in reversed(out) if not isinstance(one, Mention)), None)
        room = _room_of(last)
        bare = isinstance(statement, Paint) and statement.things.refers == "last" and not statement.things.noun
        if room is not None and bare and isinstance(statement, Paint) and statement.things.place is None:
            part: Surface = "walls"
            out.append(
                Finish(
                    rooms=room, part=part, colour=statement.colour, material=statement.material, quote=statement.quote
                )
            )
        else:
            out.append(statement)
    return out


def _room_of(statement: Statement | None) -> Rooms | None:
    """Return the room that a statement is about; None for statements about things."""
    if isinstance(statement, Rename):
        return statement.room
    return statement.rooms if isinstance(statement, Finish | Furnish) else None
