"""Clauses that judge how something is, or tell what nobody can do with it: ``The hall is too cramped``.

They give the reason of a request and ask for nothing themselves. What they judge is what the request may be about.
"""

from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.verb_words import PARTICIPLES
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.words import (
    BE,
    DETERMINERS,
    MODALS,
    NEED,
    PERSONS,
    PREPOSITIONS,
    STATE_WORDS,
    VAGUE,
    Word,
    text_at,
)
from mansion_language.colours import COLOUR_WORDS

__all__ = ["cannot_do", "end_of_judged_predicate", "is_judgement"]

_COPULAS: Final = frozenset(
    "is are was were look looks seem seems feel feels smell smells sound sounds get gets".split()
)
_CONTRACTED: Final = frozenset("it's its that's they're this's he's she's i'm we're you're everything's".split())
"""A pronoun with its verb in one word."""
_BEGINNING: Final = frozenset("begins starts begin start tends tend".split())
_PERFECT: Final = frozenset("been seen become got gone had lost begun started stopped".split())
_UNABLE: Final = frozenset("can't cannot couldn't".split())
_ABILITIES: Final = frozenset("can could cannot able".split())
_DEGREES: Final = frozenset(
    "too so way far much very really quite rather pretty a bit little always a lot just".split()
)
_ASKING: Final = NEED | frozenset(
    "please let make wish prefer like love fancy expect missing belong deserve instead only another more less fewer "
    "exactly least most each every either or if unless when until except supposed due enough ask unwanted superfluous "
    "surplus unnecessary redundant needed necessary required wanted many few several spare welcome here there gone "
    "plenty ample sufficient suffice "
    "same without".split()
)
"""Words of a predicate by which it may ask for something."""
_TAILS: Final = frozenset("to for at in anyway anyhow now today lately these because since as".split())
"""Words that a predicate's adverbials begin with."""
_LONGEST: Final = 12


def is_judgement(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether a clause only says how something is or was, or what somebody cannot do there.

    Notes
    -----
    A number, a colour, a state or a thing in the predicate may be what is asked for, and so is no judgement.
    """
    words = [word for word in words if word.text not in ("please", "well", "oh")]
    while words and (words[-1].kind == "mark" or words[-1].text in ("and", "so")):
        words = words[:-1]
    if len(words) < 3 or verb_at(words, 0, lexicon) is not None or text_at(words, 0) in {"if", "unless", "not"}:
        return False
    if any(word.kind == "mark" for word in words):
        return False
    if text_at(words, 0) == "there":
        return _is_mishap(words, lexicon)
    contracted = words[0].raw in _CONTRACTED
    return cannot_do(words) or any(
        _judges_from(words, at, lexicon) for at in range(0 if contracted else 1, min(len(words) - 1, _LONGEST))
    )


def end_of_judged_predicate(words: Sequence[Word], lexicon: Lexicon) -> tuple[int, int]:
    """Return where a predicate that only judges stands before ``and`` and what is asked of the same subject.

    ``is a hazard and`` of ``The rug in the hall is a hazard and has to go``; two zeros where there is none.
    """
    for joint in range(3, len(words) - 2):
        asked = words[joint + 1].text in MODALS - _ABILITIES or text_at(words, joint + 1) in ("has", "have", "need")
        if words[joint].text not in ("and", "so") or not asked or text_at(words, joint + 1) == "so":
            continue
        for at in range(1, joint - 1):
            if words[at].raw in _COPULAS | {"has", "have"} and _judges_from(words[:joint], at, lexicon):
                return at, joint + 1
    return 0, 0


def cannot_do(words: Sequence[Word]) -> bool:
    """Whether somebody cannot do something: ``I can't find anything in the pantry``."""
    if len(words) < 3:
        return False
    somebody = words[0].text in PERSONS | {"you", "they", "it"}
    verb = next((k for k in range(1, min(4, len(words))) if words[k].text in _ABILITIES | {"not"}), 0)
    denied = words[verb].raw in _UNABLE or text_at(words, verb + 1) in ("not", "hardly", "barely", "never")
    plain = not any(word.kind == "number" or word.text in COLOUR_WORDS for word in words)
    return somebody and bool(denied) and plain and not {word.text for word in words} & {"and", "so", "until", "unless"}


def _is_mishap(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether words tell of what is no thing of the catalogue: ``there's a puddle in the hall``."""
    verb = words[0].raw in ("there's", "theres") or text_at(words, 1) in ("is", "was")
    start = 1 + (text_at(words, 1) in ("is", "was"))
    end = next((k for k in range(start + 1, len(words)) if words[k].text in PREPOSITIONS), len(words))
    named = words[start + 1 : end]
    plain = (
        text_at(words, start) in ("a", "an", "some") and 0 < len(named) <= 2 and all(w.kind == "word" for w in named)
    )
    unknown = not any(lexicon.is_object((w.text,)) or w.text in _ASKING for w in named)
    return verb and plain and unknown and end < len(words) and _is_tail(words[end:], lexicon)


def _judges_from(words: Sequence[Word], verb: int, lexicon: Lexicon) -> bool:
    """Whether the word at a place is the verb of a judgement, before which its subject stands."""
    subject, said = words[:verb], words[verb]
    if any(word.text in MODALS | BE | {"not", "no", "nothing", "everything"} for word in subject[1:]):
        return False
    if said.raw in _BEGINNING and text_at(words, verb + 1) == "to":  # "begins to smell"
        return 0 < len(words) - verb - 2 <= 2 and not _names(words[verb + 2 :], lexicon)
    perfect = said.raw in ("has", "have") and _is_perfect(words, verb + 1)
    if not perfect and said.raw not in _COPULAS and not (verb == 0 and said.raw in _CONTRACTED):
        return False
    rest = words[verb + 1 + perfect :]
    degree = False
    while rest and rest[0].text in _DEGREES | {"not", "no", "already", "still", "a"}:
        degree = degree or rest[0].text in ("too", "so", "very", "really")
        rest = rest[1:]
    if said.raw in ("get", "gets") and (not rest or rest[0].text in DETERMINERS | {"to"} or _names(rest, lexicon)):
        return False
    stop = next((k for k in range(1, len(rest)) if rest[k].text in _TAILS), len(rest))
    return bool(rest) and _is_plain(rest[:stop], lexicon, told=perfect or degree) and _is_tail(rest[stop:], lexicon)


def _is_perfect(words: Sequence[Word], at: int) -> bool:
    return at < len(words) and words[at].raw in _PERFECT


def _is_plain(predicate: Sequence[Word], lexicon: Lexicon, *, told: bool) -> bool:
    """Whether a predicate only describes."""
    first = predicate[0]
    resulting = (first.raw,) in PARTICIPLES or (first.text,) in PARTICIPLES
    if (resulting and not told) or first.kind != "word":
        return False
    if first.text in PREPOSITIONS and not (told and first.text in STATE_WORDS):
        return False
    states = set() if told else STATE_WORDS.keys()
    if any(w.kind != "word" or w.text in COLOUR_WORDS or w.text in _ASKING | states | MODALS for w in predicate):
        return False
    return not _names(predicate, lexicon)


def _is_tail(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether what follows a judgement only says for what, when or in which room it is so."""
    texts = [word.text for word in words]
    if any(word.kind == "number" and "at" not in texts for word in words):
        return False
    if {*texts} & (MODALS | (_ASKING - {"here", "there", "these"}) | {"and", "but", "not", "no"}):
        return False
    if texts[:1] == ["to"] and {*texts} & {"be", "have", "get", "go"}:
        return False
    return not any(lexicon.is_object((text,)) and not lexicon.is_own_room((text,)) for text in texts if text != "bed")


def _names(words: Sequence[Word], lexicon: Lexicon) -> bool:
    named = (w.text for w in words if w.text not in VAGUE)
    return any(lexicon.is_object((text,)) or lexicon.is_own_room((text,)) for text in named)
