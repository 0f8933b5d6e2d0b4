"""Orders with a verb that no list has: what follows the verb tells whether things come, go or change places."""

import re
from typing import Final

from mansion_editing.instructions.paraphrases.patterns import CLAUSE_START, DETERMINERS
from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.verb_words import GERUNDS, PARTICIPLES, VERB_WORDS
from mansion_editing.instructions.phrases.words import FUNCTION_WORDS, UNRECORDED, VAGUE

__all__ = ["with_known_verbs"]

_OBJECTS: Final = rf"(?:(?:{DETERMINERS})\b(?: [\w'-]+)*?|it|them|both)"
_ORDER: Final = re.compile(
    rf"{CLAUSE_START}(?P<verb>[a-z]{{3,}})(?P<particle> (?:up|down|over|across|back|in|away|off|out))?"
    rf" (?P<object>{_OBJECTS})(?P<rest>(?: [^.!?;\n]*)?)(?=[.!?;\n]|$)",
    re.IGNORECASE,
)
_NEW: Final = re.compile(r"(?:an?|another|some|two|three|four|five|six|seven|eight|nine|ten|\d+)\b", re.IGNORECASE)
_GOAL: Final = re.compile(r"\b(?:to|into|onto|towards)\b")
_LEAVING: Final = re.compile(r"\b(?:away|out|off)\b(?! of\b)", re.IGNORECASE)
_RESTING: Final = re.compile(r"\b(?:on|in|at|by|next to|beside|under|near|between|behind|against|in front of)\b")
_NOT_VERBS: Final = FUNCTION_WORDS | VAGUE | UNRECORDED | VERB_WORDS | GERUNDS.keys()
_OTHER: Final = frozenset(
    "use see hear watch leave keep let ask tell know think hope wish count mind forget remember wait stay look like "
    "love hate follow read write learn try avoid imagine ignore print show delete destroy fly sail kill eat drink "
    "sing paint clean wash polish repair fix mend break burn dance play hide block touch check inspect measure weigh "
    "without despite during because although unless until while since before after only never".split()
)
"""Words that name another deed, or none."""


def with_known_verbs(text: str, lexicon: Lexicon) -> str:
    """Return a text in which orders with unknown verbs are put as ``put``, ``move`` and ``remove``.

    New things at a place are put there; things that are known and have a goal are moved to it. What is only known to be
    at a place is left as it is said: nothing tells what shall become of it.
    """

    def known(match: re.Match[str]) -> str:
        verb = match["verb"].lower()
        if verb in _NOT_VERBS or verb in _OTHER or (verb,) in PARTICIPLES or verb.endswith(("ing", "ed", "s")):
            return match.group()
        if lexicon.is_object((verb,)) or lexicon.is_room((verb,)):
            return match.group()
        deed = _deed(match["object"], f"{match['particle'] or ''} {match['rest']}")
        return f"{deed} {match['object']}{match['rest']}" if deed else match.group()

    return _ORDER.sub(known, text)


def _deed(named: str, rest: str) -> str:
    """Return the verb that what follows an unknown one stands for; empty where that is not certain."""
    first = rest.split(" and ")[0].split(",")[0]
    if _NEW.match(named):
        return "put" if _RESTING.search(first) or _GOAL.search(first) else ""
    return "move" if _GOAL.search(first) else ""
