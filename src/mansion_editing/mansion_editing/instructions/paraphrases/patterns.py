"""Rules that put a stretch of text in plain words: patterns in which ``{np}`` stands for a noun phrase, and so on."""

import re
import tomllib
from collections.abc import Iterable
from functools import cache
from importlib.resources import files
from typing import Final, NamedTuple

from mansion_editing.instructions.phrases.verb_words import BY_WORDS

__all__ = ["CLAUSE_START", "DETERMINERS", "in_plain_words", "in_running_text", "without_idioms"]

_NUMBERS: Final = r"one|two|three|four|five|six|seven|eight|nine|ten|eleven|twelve|\d+"
DETERMINERS: Final = (
    "the|an?|another|some|any|our|my|your|his|her|their|its|this|that|these|those|both|all|every|each|half|" + _NUMBERS
)
CLAUSE_START: Final = r"(?:^|(?<=[.!?;:,(] )|(?<=- )|(?<=\n)|(?<=\band )|(?<=\bbut )|(?<=\bso )|(?<=\bplease ))"

_NO_NAMES: Final = (
    "is|are|was|were|be|has|have|had|can|could|will|would|should|must|may|not|and|or|but|that|which|who|it|they|them|in"
    "|on|at|to|of|for|from|with|so|please|there|makes?|keeps?|looks?|needs?|gets?|takes?|stands?|goes|belongs?"
)
"""Words that no bare name has within it."""
_FURTHER_WORDS: Final = r"(?: (?!(?:and|or|but)\b)[\w'-]+){1,9}?"
_ORDERS: Final = "|".join(sorted(words[0] for words in BY_WORDS if len(words) == 1))
_MACROS: Final = {
    "^": CLAUSE_START,
    "$": r"(?=\s*(?:[.!?;,:)\n]|- |$))",
    "end": r"(?=\s*(?:[.!?;\n]|$))",
    "np": rf"(?:(?:{DETERMINERS})\b{_FURTHER_WORDS})",
    "new": rf"(?:(?:an?|another|some|{_NUMBERS})\b{_FURTHER_WORDS})",
    "known": (
        r"(?:(?:the|our|my|this|that(?! (?:the|our|my|it|they|there|all|both|every|an?))|these|those|both|all|every"
        rf"|her|his|their)\b{_FURTHER_WORDS})"
    ),
    "determiner": DETERMINERS,
    "num": f"(?:{_NUMBERS})",
    "I": "(?:I|we)",
    "be": "(?:is|are|was|were|am|be)",
    "on": "(?:in|on|at|into|onto|by|under|beside|behind|near|next to|in front of|inside|outside|against|between)",
    "state": "(?:on|off|open|closed|shut|running|switched on|switched off|lit)",
    "rest": r"[^.!?;\n]+?",
    "lead": r"[^.!?;:\n]+?",
    "bare": rf"(?:(?!(?:{DETERMINERS}|{_ORDERS}|{_NO_NAMES})\b)[a-z'-]+(?: (?!(?:{_NO_NAMES})\b)[a-z'-]+){{0,3}}?)",
    "order": f"(?:{_ORDERS})",
}
_CONTRACTED: Final = (
    (r"\bcan't\b", "cannot"), (r"\bwon't\b", "will not"), (r"\bshan't\b", "shall not"), (r"n't\b", " not"),
    (r"(?<=\w)'d\b", " would"), (r"(?<=\w)'m\b", " am"), (r"(?<=\w)'re\b", " are"), (r"(?<=\w)'ve\b", " have"),
    (r"(?<=\w)'ll\b", " will"), (r"\blet's\b", "let us"),
    (r"\b(it|that|there|what|who|here|he|she|everything|nothing|whatever|where|one|two|which|whoever)'s\b", r"\1 is"),
    (r"\bit is got\b", "it has got"), (r"(?<=\w)'s (?=been\b|got\b|gone\b)", " has "),
)  # fmt: skip
_MARKS: Final = (
    ("[‘’`]", "'"), ("[“”„]", '"'), (r"\s*(?:\.\.\.|…)\s*", " - "), (r"\s+(?:--|[–—-])\s+", " - "),
    (r"\bfourty\b", "forty"), (r"\bnot a single\b", "no"), (r"\bclose (?:up |by )?to\b", "near"),
    (r' & (?=(?:[^"]*"[^"]*")*[^"]*$)', " and "), (r"\bi\. ?e\. ?", "that is "), (r"\be\. ?g\. ?", "for example "),
    (r"[ \t]+", " "),
)  # fmt: skip


_ARTICLES: Final = re.compile(r"(?<=[a-z,] )(?:An?|The|Another|Some)\b")
"""Those that no longer begin a sentence."""
_IDIOMS: Final = "idioms"
"""The group of what would be misread rather than not understood."""


class _Rule(NamedTuple):
    pattern: re.Pattern[str]
    plain: str


def in_plain_words(text: str) -> str:
    r"""Return a text with each rule of ``data/plain_words.toml`` applied in turn, wherever its pattern is found.

    Examples
    --------
    >>> in_plain_words("a trio of chairs")
    'three chairs'
    """
    for name, group in _groups().items():
        if name != _IDIOMS:
            text = _tidied(_replaced(text, group))
    return text


def without_idioms(text: str) -> str:
    r"""Return a text in which set phrases that mean something else than their words are put plainly.

    Examples
    --------
    >>> without_idioms("Lights out in the hall!")
    'switch the lights off in the hall!'
    """
    plain = _replaced(text, _groups()[_IDIOMS])
    return text if plain == text else _tidied(plain)


def _replaced(text: str, rules: Iterable[_Rule]) -> str:
    for rule in rules:
        text = rule.pattern.sub(rule.plain, text)
    return text


def in_running_text(text: str) -> str:
    """Return a text with plain marks and without contractions."""
    for pattern, plain in (*_MARKS, *_CONTRACTED):
        text = re.sub(pattern, plain, text, flags=re.IGNORECASE)
    return text.strip()


@cache
def _groups() -> dict[str, tuple[_Rule, ...]]:
    """Return the groups of rules in the order of the file, compiled."""
    data = tomllib.loads(files(__package__).joinpath("data/plain_words.toml").read_text(encoding="utf-8"))
    words = data.pop("words")
    return {
        name: tuple(_compiled(pattern, plain, words) for pattern, plain in group["rules"])
        for name, group in data.items()
    }


def _compiled(pattern: str, plain: str, words: dict[str, str]) -> _Rule:
    """Return a rule with the words that its pattern names written out."""
    for name, written in (*words.items(), *_MACROS.items()):
        pattern = pattern.replace("{" + name + "}", written)
    return _Rule(re.compile(pattern, re.IGNORECASE), plain)


def _tidied(text: str) -> str:
    """Return a text without the marks and spaces that what was left out leaves behind."""
    text = re.sub(r"\s+([.!?;,:)])", r"\1", text)
    text = re.sub(r"\(\s*\)", "", text)
    text = re.sub(r",(?:\s*,)+", ",", text)
    text = re.sub(r"(^|[.!?;\n])\s*(?:[,:]|- )+\s*", r"\1 ", text)
    text = re.sub(r"(?:,| -)+\s*([.!?;]|$)", r"\1", text)
    text = _ARTICLES.sub(lambda match: match.group().lower(), text)
    return re.sub(r"[ \t]+", " ", text).strip()
