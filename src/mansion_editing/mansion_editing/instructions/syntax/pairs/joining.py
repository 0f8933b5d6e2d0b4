"""Clauses that ask for one thing together, put as one order: ``wheel it out of the hall and park it in the shed``."""

import re
from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.syntax.clauses import clauses_of
from mansion_editing.instructions.syntax.pairs.counts import too_many
from mansion_editing.instructions.syntax.pairs.orders import (
    carried,
    exchanged,
    in_place_of_those,
    instead_of_some,
    kept_elsewhere,
    namely,
    spread,
    swapped_topic,
    swapped_with_companions,
)
from mansion_editing.instructions.syntax.pairs.questions import (
    added_where_missing,
    all_made_so,
    asked_of_room,
    supplied,
)
from mansion_editing.instructions.syntax.pairs.rooms import (
    given_finishes,
    left_only,
    lined_with,
    made_of,
    renamed_in_turn,
    table_laid,
    told_in_detail,
)
from mansion_editing.instructions.syntax.pairs.states import contrasted, none_on, not_needed
from mansion_editing.instructions.syntax.pairs.wording import Rule
from mansion_editing.instructions.syntax.tagged_words import tagged

__all__ = ["with_pairs_joined", "without_misread_pairs"]


def with_pairs_joined(text: str, lexicon: Lexicon) -> str:
    """Return a text with clauses that ask for one thing only together put as one order.

    Parameters
    ----------
    text : str
        In running text, without contractions.
    """
    return _joined_by(_RULES, text, lexicon)


def without_misread_pairs(text: str, lexicon: Lexicon) -> str:
    """Return a text with those clauses put as one order that would ask for something else if they were read alone.

    Examples
    --------
    ``No lights on upstairs`` does not take lights away.
    """
    return _joined_by(_MISREAD, text, lexicon) if _SUSPECT.search(text) else text


def _joined_by(rules: Sequence[Rule], text: str, lexicon: Lexicon) -> str:
    words = tagged(text, lexicon)
    clauses = clauses_of(words)
    out: list[str] = []
    at = end = 0
    while at < len(clauses):
        found = next((pair for rule in rules if (pair := rule(clauses, at, words, lexicon)) is not None), None)
        if found is None:
            at += 1
            continue
        following, order = found
        out += [text[end : words[clauses[at].start].start], order]
        end = words[clauses[following - 1].end - 1].end
        at = following
    return "".join([*out, text[end:]])


_SUSPECT: Final = re.compile(
    r"\b(no|nothing)\b.*\b(on|running|burning|lit)\b|\b(lay|set) (the|our|my)\b|\b(its|their)\b"
    r"|\b(upstairs|downstairs|elsewhere) (leave|keep)\b",
    re.IGNORECASE | re.DOTALL,
)
"""Words without which none of these clauses is said."""
_MISREAD: Final[tuple[Rule, ...]] = (none_on, table_laid, kept_elsewhere, swapped_with_companions)

_RULES: Final[tuple[Rule, ...]] = (
    carried, swapped_with_companions, added_where_missing, all_made_so, exchanged, too_many, told_in_detail,
    none_on, not_needed, left_only, renamed_in_turn, made_of, table_laid, given_finishes, in_place_of_those, spread,
    contrasted, swapped_topic, namely, supplied, lined_with, instead_of_some, asked_of_room,
)  # fmt: skip
