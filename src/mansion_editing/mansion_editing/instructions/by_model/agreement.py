"""Whether the rules and a model read the same in the same words: the same deed, on the same things and places."""

from collections.abc import Callable, Sequence
from typing import Final

from mansion_assets.catalogue.vocabulary import stems
from mansion_editing.instructions.by_model.leaves import Leaf, leaves_of
from mansion_editing.instructions.statements import Ask, Clear, Forbid, Keep, Remove, Statement, Things

__all__ = ["agree"]

_ALIKE: Final[tuple[frozenset[type], ...]] = (frozenset({Remove, Clear}), frozenset({Forbid, Keep}))
"""Statements that say the same in other words."""

_COMPARED: Final = (
    "noun",
    "anchor",
    "room",
    "floor",
    "colour",
    "number",
    "relation",
    "spot",
    "ordinal",
    "what",
    "state",
)
"""Parts that may be left out by one reader, as they follow, but not differ."""

_STRICT: Final = ("amount", "value", "outside", "each", "open", "on", "absolute", "name")
"""Parts that change the sense where only one reader has them."""

Same = Callable[[Sequence[str], Sequence[str]], bool]
"""Whether two names mean the same kind of thing."""


def agree(rules: Statement, model: Statement, same: Same) -> bool:
    """Whether two statements ask for the same.

    A part that only the rules read (a room, a number, a colour) is one that the model lost, and no agreement. One that
    only the model read may be what the rules do not know.
    """
    kinds = {type(rules), type(model)}
    if len(kinds) > 1 and not any(kinds <= pair for pair in _ALIKE):
        return False
    ours, theirs = leaves_of(rules), leaves_of(model)
    for part in _COMPARED:
        known, read = _values(ours, part), _values(theirs, part)
        if any(not any(_alike(part, one, other, same) for other in read) for one in known):
            return False
        if known and any(not any(_alike(part, one, other, same) for other in known) for one in read):
            return False
    return _mean_all(rules) == _mean_all(model) and all(_values(ours, p) == _values(theirs, p) for p in _STRICT)


def _mean_all(statement: Statement) -> bool:
    """Whether a statement is about all that its words fit, said so or by a bare plural."""
    things = getattr(statement, "things", None)
    if not isinstance(things, Things) or isinstance(statement, Ask | Keep | Forbid):
        return False
    amount = things.amount
    return amount.number < 2 and (amount.kind == "all" or (things.plural and amount.kind == "some"))


def _values(leaves: Sequence[Leaf], part: str) -> list[str | float | bool]:
    values = [leaf.value for leaf in leaves if leaf.part == part]
    # Whether all are meant is looked at apart: a bare plural says so too.
    return [value for value in values if value != "all"] if part == "amount" else values


def _alike(part: str, one: str | float | bool, other: str | float | bool, same: Same) -> bool:
    if one == other:
        return True
    if not (isinstance(one, str) and isinstance(other, str)):
        return False
    words = stems(one.replace("_", " ")), stems(other.replace("_", " "))
    if words[0] == words[1]:
        return True
    if part in ("noun", "anchor"):
        return same(*words)
    return part == "room" and (set(words[0]) <= set(words[1]) or set(words[1]) <= set(words[0]))
