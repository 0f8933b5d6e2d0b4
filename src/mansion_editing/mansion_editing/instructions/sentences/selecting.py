"""Which of several things is meant, told afterwards: ``the salt shaker to the hall; take the one on the counter``."""

import re
from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_editing.instructions.phrases.places import with_place
from mansion_editing.instructions.statements import Mention, Move, Place, Remove, Statement

__all__ = ["with_those_taken"]

_TAKING: Final = re.compile(r"(?:and |so |please |then )*(?:take|use|choose|pick) the ones?\b", re.IGNORECASE)


def with_those_taken(statements: Sequence[Statement]) -> list[Statement]:
    """Return statements in which ``take the one from the counter`` tells which thing moves, and removes nothing."""
    out: list[Statement] = []
    for statement in statements:
        at = next((k for k in range(len(out) - 1, -1, -1) if not isinstance(out[k], Mention)), -1)
        last = out[at] if at >= 0 else None
        told = isinstance(statement, Remove) and statement.things.place is not None
        if isinstance(last, Move) and isinstance(statement, Remove) and told and _names_one_of(statement, last):
            place = statement.things.place or Place()
            things = with_place(msgspec.structs.replace(last.things, place=None), place)
            out[at] = msgspec.structs.replace(last, things=things)
        else:
            out.append(statement)
    return out


def _names_one_of(statement: Remove, last: Move) -> bool:
    same = statement.things.noun == last.things.noun and bool(last.things.noun)
    return same and _TAKING.match(statement.quote) is not None
