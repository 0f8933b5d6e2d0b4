"""What a statement says, one by one: nouns, rooms, numbers, colours and the rest, each with its part."""

from collections.abc import Iterator
from typing import Any, NamedTuple

import msgspec

from mansion_editing.instructions.statements import Amount, Furnish, Place, Rename, Rooms, Statement, Things

__all__ = ["Leaf", "leaves_of"]


class Leaf(NamedTuple):
    """One thing that a statement says.

    Attributes
    ----------
    part : str
        ``noun``, ``anchor`` (a noun that tells a place), ``room``, ``floor``, ``colour``, ``material``, ``name``,
        ``amount``, ``number``, or the name of the field.
    """

    part: str
    value: str | float | bool


def leaves_of(statement: Statement) -> list[Leaf]:
    """Return what a statement says, without its quote and what it leaves open."""
    return list(dict.fromkeys(_leaves(statement, "noun")))


def _leaves(value: msgspec.Struct, noun: str) -> Iterator[Leaf]:
    plain = {field.name: field.default for field in msgspec.structs.fields(value)}
    for name, default in plain.items():
        found: Any = getattr(value, name)
        if name == "quote" or (found == default and not (isinstance(found, bool) and default is msgspec.NODEFAULT)):
            continue
        yield from _of_field(value, name, found, noun)


def _of_field(owner: msgspec.Struct, name: str, found: Any, noun: str) -> Iterator[Leaf]:
    if isinstance(found, Amount):
        yield from _amount(found)
    elif isinstance(found, dict):
        yield from (Leaf(state, value) for state, value in sorted(found.items()))
    elif isinstance(found, tuple) and name == "floors":
        yield from (Leaf("floor", float(floor)) for floor in found)
    elif isinstance(found, tuple):
        for one in found:
            yield from _leaves(one, "anchor")
    elif isinstance(found, msgspec.Struct):
        inner = "anchor" if isinstance(owner, Place | Rooms) or name in ("place", "facing", "start") else noun
        yield from _leaves(found, inner)
    elif isinstance(owner, Things) and name == "noun":
        yield Leaf(noun, found)
    elif name in ("definite", "plural"):
        return
    else:
        yield Leaf(
            _part(owner, name), float(found) if isinstance(found, int) and not isinstance(found, bool) else found
        )


def _amount(amount: Amount) -> Iterator[Leaf]:
    if amount.kind != "some":
        yield Leaf("amount", amount.kind)
    for number in (amount.number, amount.of):
        if number > 1:
            yield Leaf("number", float(number))


def _part(owner: msgspec.Struct, name: str) -> str:
    if name in ("words", "next_to", "owned") or (isinstance(owner, Furnish) and name == "kind"):
        return "room"
    if name in ("within", "degrees", "area", "number"):
        return "number"
    return "name" if isinstance(owner, Rename) and name == "name" else name
