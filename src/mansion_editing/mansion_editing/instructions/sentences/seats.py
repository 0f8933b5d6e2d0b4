"""Tableware for each chair, which lies on the table and never on the chair."""

import re
from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.statements import Add, Ensure, Statement

__all__ = ["laid_on_seats"]

_TABLEWARE: Final = frozenset("plate fork knife spoon glass bowl cup mug napkin saucer placemat cutlery".split())
_FOR_EACH: Final = re.compile(r"\b(for (each|every|all)|per) ", re.IGNORECASE)
_SEATS: Final = frozenset("chair stool seat armchair bench".split())


def laid_on_seats(statements: Sequence[Statement]) -> list[str]:
    """Return the words by which tableware would come onto seats: which table is meant is not told."""
    return [
        one.quote
        for one in statements
        if isinstance(one, Add | Ensure)
        and one.place.anchor is not None
        and one.place.anchor.each
        and _FOR_EACH.search(one.quote)
        and one.things.noun.split()[-1:] != []
        and one.things.noun.split()[-1] in _TABLEWARE
        and one.place.anchor.noun.split()[-1:] != []
        and one.place.anchor.noun.split()[-1] in _SEATS
    ]
