"""Rules that put a stretch of text in other words: patterns in which ``{np}`` stands for a noun phrase, and so on."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Final

__all__ = ["CLAUSE_START", "DETERMINERS", "Rule", "compiled", "in_running_text", "put", "rules"]

_NUMBERS: Final = "one|two|three|four|five|six|seven|eight|nine|ten|eleven|twelve|\\d+"
DETERMINERS: Final = (
    f"the|an?|another|some|any|our|my|your|his|her|their|its|this|that|these|those|both|all|every|each|half|{_NUMBERS}"
)
CLAUSE_START: Final = r"(?:^|(?<=[.!?;:,(] )|(?<=- )|(?<=\n)|(?<=\band )|(?<=\bbut )|(?<=\bso )|(?<=\bplease ))"

_MACROS: Final = {
    "^": CLAUSE_START,
    "$": r"(?=\s*(?:[.!?;,:)\n]|- |$))",
    "end": r"(?=\s*(?:[.!?;\n]|$))",
    "np": rf"(?:(?:{DETERMINERS})\b(?: (?!(?:and|or|but)\b)[\w'-]+){{1,9}}?)",
    "new": rf"(?:(?:an?|another|some|{_NUMBERS})\b(?: (?!(?:and|or|but)\b)[\w'-]+){{1,9}}?)",
    "num": rf"(?:{_NUMBERS})",
    "I": r"(?:I|we)",
    "be": r"(?:is|are|was|were|am|be)",
    "on": r"(?:in|on|at|into|onto|by|under|beside|behind|near|next to|in front of|inside|outside|against|between)",
    "state": r"(?:on|off|open|closed|shut|running|switched on|switched off|lit)",
    "rest": r"[^.!?;\n]+?",
    "lead": r"[^.!?;:\n]+?",
}
_CONTRACTED: Final = (
    (r"\bcan't\b", "cannot"), (r"\bwon't\b", "will not"), (r"\bshan't\b", "shall not"), (r"n't\b", " not"),
    (r"(?<=\w)'d\b", " would"), (r"(?<=\w)'m\b", " am"), (r"(?<=\w)'re\b", " are"), (r"(?<=\w)'ve\b", " have"),
    (r"(?<=\w)'ll\b", " will"), (r"\blet's\b", "let us"),
    (r"\b(it|that|there|what|who|here|he|she|everything|nothing|whatever|where|one|two|which)'s\b", r"\1 is"),
    (r"\bit is got\b", "it has got"),
)  # fmt: skip
_MARKS: Final = (
    ("[‘’`]", "'"), ("[“”„]", '"'), (r"\s*(?:\.\.\.|…)\s*", " - "), (r"\s+(?:--|[–—-])\s+", " - "),
    (r"\bi\. ?e\. ?", "that is "), (r"\be\. ?g\. ?", "for example "), (r"[ \t]+", " "),
)  # fmt: skip


@dataclass(frozen=True)
class Rule:
    """A pattern of words and what they are put as, with ``\\1`` for what a group matched."""

    pattern: str
    plain: str


def rules(*pairs: tuple[str, str]) -> tuple[Rule, ...]:
    """Return rules from patterns and the words that they are put as."""
    return tuple(Rule(pattern, plain) for pattern, plain in pairs)


@lru_cache(maxsize=512)
def compiled(pattern: str) -> re.Pattern[str]:
    """Return a pattern with its macros written out, which ignores case."""
    for name, written in _MACROS.items():
        pattern = pattern.replace("{" + name + "}", written)
    return re.compile(pattern, re.IGNORECASE)


def put(text: str, applied: Sequence[Rule]) -> str:
    """Return a text with each rule applied in turn, wherever its pattern is found."""
    for rule in applied:
        text = compiled(rule.pattern).sub(rule.plain, text)
    return tidied(text)


def tidied(text: str) -> str:
    """Return a text without the marks and spaces that what was left out leaves behind."""
    text = re.sub(r"\s+([.!?;,:)])", r"\1", text)
    text = re.sub(r"\(\s*\)", "", text)
    text = re.sub(r",(?:\s*,)+", ",", text)
    text = re.sub(r"(^|[.!?;\n])\s*(?:[,:]|- )+\s*", r"\1 ", text)
    text = re.sub(r"(?:,| -)+\s*([.!?;]|$)", r"\1", text)
    return re.sub(r"[ \t]+", " ", text).strip()


def in_running_text(text: str) -> str:
    """Return a text with plain marks and without contractions."""
    for pattern, plain in (*_MARKS, *_CONTRACTED):
        text = re.sub(pattern, plain, text, flags=re.IGNORECASE)
    return text.strip()
