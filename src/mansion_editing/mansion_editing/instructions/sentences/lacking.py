"""Relative clauses after places that are each given one: ``on every table that has none yet``."""

from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.words import text_at
from mansion_editing.instructions.statements import Add, Amount, Ensure, Statement

__all__ = ["end_of_presence", "given_where_none_is", "lacking_at"]

_DENYING: Final = frozenset("not no none without lack lacking missing".split())
_OF_LACKING: Final = _DENYING | frozenset(
    "that which where on in still yet already do does did has have had got there is are been one any it a so far of "
    "its own their them".split()
)
_MEANT: Final = frozenset("one any none it".split())
_LONGEST: Final = 9

_OF_PRESENCE: Final = frozenset(
    "where there is are already one some another other others the stand lie hang it they has have been be do does"
    .split()
)  # fmt: skip


def lacking_at(reader: ClauseReader, at: int, clause: Sequence[Statement]) -> int:
    """Return the end of ``that has none yet``, ``which do not have a lamp``; 0 where the words say something else."""
    start = at + (reader.text(at) == ",")
    if reader.text(start) not in ("that", "which", "where", "without", "lacking", "still"):
        return 0
    nouns = {word for s in clause if isinstance(s, Add | Ensure) for word in s.things.noun.split()}
    end = start
    while reader.text(end) in _OF_LACKING | nouns:
        end += 1
    said = {word.text for word in reader.words[start:end]}
    meant = said & _MEANT or (nouns and nouns <= said)
    return end if said & _DENYING and meant and end - start <= _LONGEST and _ends(reader, end) else 0


def end_of_presence(reader: ClauseReader, at: int) -> int:
    """Return the end of ``, where there is already one``, which only tells of a place; 0 for other words."""
    start = at + (reader.text(at) == ",")
    end = start
    while reader.text(end) in _OF_PRESENCE:
        end += 1
    said = {word.text for word in reader.words[start:end]}
    told = reader.text(start) == "where" and said & {"already", "other", "another"} and not said & {"not", "no"}
    return end if told and _ends(reader, end) else 0


def _ends(reader: ClauseReader, at: int) -> bool:
    return at >= len(reader.words) or reader.words[at].kind == "mark" or text_at(reader.words, at) in ("and", "please")


def given_where_none_is(clause: Sequence[Statement], *, alone: bool = False) -> list[Ensure] | None:
    """Return statements that give one to each place that has none; None where they do not say that.

    Two for each that has none, or a red one for each that has none of any colour, cannot be said as what is there
    afterwards, which is what statements are checked by.

    Parameters
    ----------
    alone : bool
        Whether the place need not be one of several.
    """
    out: list[Ensure] = []
    for statement in clause:
        if not isinstance(statement, Add | Ensure) or not (statement.each or alone):
            return None
        things = statement.things
        if things.amount.kind != "some" or things.amount.number > 1:
            return None
        if things.colour or things.material or things.states or things.size:
            return None
        one = msgspec.structs.replace(things, amount=Amount(number=1), plural=False)
        out.append(Ensure(things=one, place=statement.place, each=statement.each, quote=statement.quote))
    return out or None
