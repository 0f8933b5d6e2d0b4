"""Instructions to facts: the clauses of each sentence."""

import re
from typing import Final

from mansion_editing.agent.clause_reader import ClauseReader
from mansion_editing.agent.clauses import Clause, clauses_of
from mansion_editing.agent.facts import Fact
from mansion_editing.agent.limits import refuse_beyond
from mansion_editing.agent.phrases import rooms_named
from mansion_editing.agent.spoken import not_understood
from mansion_editing.agent.things import is_known
from mansion_editing.agent.turns import rephrased
from mansion_editing.agent.wording import sentences
from mansion_editing.state import SceneState
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["MOST_CLAUSES", "MOST_FACTS", "parse_instruction"]

MOST_CLAUSES: Final = 24
MOST_FACTS: Final = 60


def parse_instruction(state: SceneState, instruction: str) -> list[Fact]:
    """Return the facts that an instruction asks for, in its order.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for what is no instruction, ``NOT_FOUND`` for words that name nothing, ``INFEASIBLE`` for
        more than is allowed. Nothing is guessed: an instruction is understood whole or refused.
    """
    refuse_beyond(instruction)
    said = [clauses_of(sentence) for sentence in rephrased(sentences(instruction))]
    number = sum(len(clauses) for clauses in said)
    if not number:
        raise not_understood(instruction)
    if number > MOST_CLAUSES:
        raise MansionError(
            ErrorCode.INFEASIBLE, f"the instruction asks for {number} things; at most {MOST_CLAUSES} in one go"
        )
    reader = ClauseReader(state)
    asked = [clauses for clauses in said if not _is_talk(state, clauses)] or said
    for clauses in asked:
        reader.sentence(clauses)
    if not reader.facts:
        raise not_understood(instruction)
    if len(reader.facts) > MOST_FACTS:
        raise MansionError(
            ErrorCode.INFEASIBLE, f"the instruction asks for {len(reader.facts)} facts; at most {MOST_FACTS} in one go"
        )
    return list(dict.fromkeys(reader.facts))


def _is_talk(state: SceneState, clauses: list[Clause]) -> bool:
    """Whether a sentence asks for nothing: it has no clause, and names no room and nothing of the catalogue."""
    pieces = [clause.words.get("x", "") for clause in clauses if not clause.kind]
    if len(pieces) != len(clauses):
        return False
    words = {word for piece in pieces for word in re.findall(r"[a-z]+", piece.lower())}
    return not any(is_known(state, word) or rooms_named(state, word, None) for word in words)
