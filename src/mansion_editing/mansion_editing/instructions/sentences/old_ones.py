"""Things that go before others come or are counted: ``put a new bin in the hall and remove the old one``."""

import re
from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_editing.instructions.statements import (
    Add,
    Ensure,
    Mention,
    Move,
    Place,
    Remove,
    Replace,
    Statement,
    Things,
)

__all__ = [
    "with_companions_first",
    "with_former_ones_first",
    "with_last_of_them_first",
    "with_old_ones_first",
    "with_replacements",
]

_OLD: Final = re.compile(r"\bthe (?:old|existing|previous|former|current|present)\b", re.IGNORECASE)


def with_old_ones_first(statements: Sequence[Statement]) -> list[Statement]:
    """Return statements in which ``the old one`` goes, from where the new one comes to, before that is there."""
    out = list(statements)
    for at, new in enumerate(out):
        old = next((k for k in range(at + 1, len(out)) if not isinstance(out[k], Mention)), at)
        goes = out[old]
        if not isinstance(new, Add | Ensure) or not isinstance(goes, Remove | Move) or not _is_old_one(goes, new):
            continue
        place = None if new.place == Place() else new.place
        things = msgspec.structs.replace(goes.things, place=place) if _is_there(goes.things.place) else goes.things
        first = msgspec.structs.replace(goes, things=things)
        first = msgspec.structs.replace(first, or_new=False) if isinstance(first, Move) else first
        brought = Add(things=new.things, place=new.place, each=new.each, quote=new.quote)
        return [*out[:at], first, brought, *out[at + 1 : old], *with_old_ones_first(out[old + 1 :])]
    return out


def with_replacements(statements: Sequence[Statement]) -> list[Statement]:
    """Return ``replace the clock by a painting`` for ``remove the clock and hang a painting where it was``."""
    out: list[Statement] = []
    for statement in statements:
        last = out[-1] if out else None
        new = _comes_in_its_place(statement)
        if new is not None and isinstance(last, Remove):
            out[-1] = Replace(things=last.things, by=new, quote=f"{last.quote}; {statement.quote}")
        else:
            out.append(statement)
    return out


def _comes_in_its_place(statement: Statement) -> Things | None:
    """Return what is new where something stood, also in notes: ``remove the fridge, two plants in its place``."""
    if isinstance(statement, Add | Ensure) and statement.place.former is not None:
        return statement.things
    if not isinstance(statement, Remove) or statement.things.definite or statement.things.place is None:
        return None
    return msgspec.structs.replace(statement.things, place=None) if statement.things.place.former is not None else None


def with_companions_first(statements: Sequence[Statement]) -> list[Statement]:
    """Return what stands around furniture before that furniture goes or moves: ``the table and its chairs``."""
    out = list(statements)
    for at in range(1, len(out)):
        owner, own = out[at - 1], out[at]
        if not isinstance(own, Remove | Move) or type(owner) is not type(own) or owner.quote != own.quote:
            continue
        anchor = None if own.things.place is None else own.things.place.anchor
        if isinstance(owner, Remove | Move) and anchor is not None and anchor.noun == owner.things.noun:
            out[at - 1], out[at] = own, owner
    return out


def with_former_ones_first(statements: Sequence[Statement]) -> list[Statement]:
    """Return statements in which what stands somewhere goes before something comes ``where it stands now``."""
    out = list(statements)
    for at, new in enumerate(out):
        former = new.place.former if isinstance(new, Add | Ensure | Move) else None
        if former is None or not former.noun:
            continue
        goes = next((k for k in range(at + 1, len(out)) if _takes_away(out[k], former.noun)), 0)
        if goes:
            return [*out[:at], out[goes], new, *out[at + 1 : goes], *out[goes + 1 :]]
    return out


def _takes_away(statement: Statement, noun: str) -> bool:
    return isinstance(statement, Remove | Move) and statement.things.noun == noun


def with_last_of_them_first(statements: Sequence[Statement]) -> list[Statement]:
    """Return removals of one clause that count things with the greatest place first: ``the second and the third``."""
    out = list(statements)
    counted = [at for at, s in enumerate(out) if isinstance(s, Remove) and s.things.ordinal > 0]
    for quote in {out[at].quote for at in counted}:
        places = [at for at in counted if out[at].quote == quote]
        ordered = sorted((out[at] for at in places), key=_ordinal, reverse=True)
        for at, statement in zip(places, ordered, strict=True):
            out[at] = statement
    return out


def _ordinal(statement: Statement) -> int:
    return statement.things.ordinal if isinstance(statement, Remove) else 0


def _is_there(place: Place | None) -> bool:
    """Whether nothing is said of where something is, or only that it is where the new one comes: ``from it``."""
    return place is None or (place.anchor is not None and place.anchor.refers == "last" and not place.anchor.noun)


def _is_old_one(goes: Remove | Move, new: Add | Ensure) -> bool:
    """Whether what goes was there before something new of its kind comes."""
    things, place = goes.things, new.place
    named = things.definite and bool(things.noun) and things.noun == new.things.noun and not things.refers
    refers = place.anchor is not None and bool(place.anchor.refers)
    same = place.rooms is not None and place.rooms.same
    return (
        named and bool(_OLD.search(goes.quote)) and not (refers or same) and new.things.amount.kind in ("some", "more")
    )
