"""Things that come to a place and stand there next to each other: ``the dolls on the bed, side by side``."""

from collections.abc import Sequence

import msgspec

from mansion_editing.instructions.phrases.each_other import EACH_OTHER
from mansion_editing.instructions.phrases.places import merged
from mansion_editing.instructions.statements import Add, Amount, Ensure, Move, Place, Statement, Things

__all__ = ["brought_together"]

_THEM = Things(refers="last", definite=True, plural=True, amount=Amount(number=0))


def brought_together(statements: Sequence[Statement]) -> list[Statement]:
    """Return statements in which what goes ``on the bed next to each other`` goes there and is then put together."""
    out: list[Statement] = []
    for statement in statements:
        place = statement.place if isinstance(statement, Add | Ensure | Move) else Place()
        anchor = place.anchor
        there = None if anchor is None or anchor.noun != EACH_OTHER.noun else anchor.place
        if there is None or not isinstance(statement, Add | Ensure | Move):
            out.append(statement)
            continue
        goal = there if place.rooms is None else merged(there, Place(rooms=place.rooms))
        together = Place(relation="beside", anchor=EACH_OTHER)
        out += [
            msgspec.structs.replace(statement, place=goal),
            Move(things=_THEM, place=together, quote=statement.quote),
        ]
    return out
