"""Where sentences end, and words in them that ask for nothing: reasons, purposes, what was."""

from collections.abc import Callable, Iterable, Sequence
from typing import Final

from mansion_editing.instructions.phrases.word_sets import AFTER_PURPOSES, AFTER_REASONS, PAST_VERBS, PEOPLE, RELATIVES
from mansion_editing.instructions.phrases.words import (
    ADVERBS,
    BE,
    DETERMINERS,
    MODALS,
    PERSONS,
    PREPOSITIONS,
    SENTENCE_ENDS,
    Word,
    next_mark,
    text_at,
)
from mansion_editing.instructions.statements import Finish, Paint, Statement
from mansion_language.colours import COLOUR_WORDS

__all__ = ["end_of_background", "end_of_purpose", "is_background", "is_told", "split_sentences"]

_CLAUSES: Final = frozenset("and but so then while or".split())
_ASKING: Final = frozenset("not no never none without please should must want need half both every each all".split())
_OFTEN: Final = frozenset("always often constantly forever usually mostly".split())


def split_sentences(words: Sequence[Word]) -> Iterable[tuple[list[Word], bool]]:
    """Yield sentences, each with whether a question mark ends it."""
    sentence: list[Word] = []
    for word in words:
        if word.kind == "mark" and word.text in SENTENCE_ENDS:
            if sentence:
                yield sentence, word.text == "?"
            sentence = []
        else:
            sentence.append(word)
    if sentence:
        yield sentence, False


def end_of_background(words: Sequence[Word], at: int) -> int:
    """Return the end of a reason or a purpose that begins at a place: ``because ...``, ``so that ...``."""
    first = words[at].text
    following = words[at + 1].text if at + 1 < len(words) else ""
    reason = first in ("because", "otherwise") or (first in ("since", "as") and following in AFTER_REASONS)
    purpose = (first == "so" and following in AFTER_PURPOSES) or (first == "in" and following in ("case", "order"))
    if [w.text for w in words[at : at + 4]] == ["you", "are", "at", "it"]:
        return min(at + 5, len(words))
    if first == "while" and following in ("you", "we", "i"):
        stop = next((k for k in range(at, len(words)) if words[k].text == ","), len(words) - 1)
        return stop + 1
    if first in ("for", "before", "during", "after", "when") and at == 0:
        comma = next((k for k in range(at, min(len(words), at + 9)) if words[k].text in (",", ":")), None)
        return at if comma is None else comma
    told = _end_of_aside(words, at)
    if told > at:
        return told
    words_after = [w.text for w in words[at : at + 9]]
    if (
        first == "if"
        and following in ("something", "anything", "it", "there")
        and {"way", "block", "blocked", "blocking"} & set(words_after)
    ):
        return len(words)
    if not (reason or purpose):
        return at
    end = at + 1
    while end < len(words) and not (words[end].kind == "mark" and words[end].text in (",", ";", ")")):
        end += 1
    return end


def _end_of_aside(words: Sequence[Word], at: int) -> int:
    """Return the end of ``for reading``, ``it is always in the way``.

    Words with a number, a negation, a colour or another clause ask for something and are none.
    """
    end = next((k for k in range(at, len(words)) if words[k].kind == "mark" or words[k].text in _CLAUSES), len(words))
    aside = words[at:end]
    texts = [word.text for word in aside]
    if any(w.kind in ("number", "ordinal") or w.text in _ASKING or w.text in COLOUR_WORDS for w in aside):
        return at
    purpose = len(aside) == 2 and at > 0 and texts[0] == "for" and aside[1].raw.endswith("ing")
    joined = 2 + sum(word in ADVERBS or word in _OFTEN for word in texts[2:-3])
    bothers = texts[:1] in (["it"], ["they"], ["that"], ["this"]) and texts[1:2] in (["is"], ["are"])
    in_the_way = bothers and texts[-3:] == ["in", "the", "way"] and joined == len(texts) - 3
    return end if purpose or in_the_way else at


_WISHING: Final = frozenset("want need please rather".split()) | MODALS - {"will", "can"}
_GOING: Final = frozenset(
    "go leave vanish disappear belong stay remain come move get make keep let may might can could would will shall "
    "ought has have had one two both all other others rest same too instead only just more less enough plenty do "
    "does".split()
)
"""Words of requests and of what refers to things, which a clause that only tells something has not."""


_NOT_TOLD: Final = frozenset("there if unless where which".split())
"""First words of clauses that say under what condition or of which of several something is asked."""


def is_told(words: Sequence[Word], named: Callable[[Word], bool]) -> bool:
    """Whether a clause with a subject and a verb only tells something: ``Grandma is visiting``, ``My back hurts``.

    Parameters
    ----------
    named : callable
        Tells whether a word names a thing or a room, which a clause that asks for something does.
    """
    texts = [word.text for word in words]
    if len(words) < 2 or words[0].kind != "word" or texts[0] in PREPOSITIONS | _NOT_TOLD:
        return False
    if any(w.text in _ASKING | _GOING or w.text in COLOUR_WORDS or named(w) for w in words):
        return False
    if any(word.kind in ("number", "ordinal", "level", "id") for word in words):
        return False
    return any(w.text in BE or _is_inflected(w) for w in words[1:])


def _is_inflected(word: Word) -> bool:
    return word.kind == "word" and (word.raw.endswith(("ed", "ing")) or (word.plural and not word.genitive))


def is_background(words: Sequence[Word]) -> bool:
    """Whether words tell of people and of what was, and ask for nothing."""
    texts = [w.text for w in words]
    if not texts:
        return False
    if texts[0] in ("is", "are", "look") and len(words) <= 6:
        return True
    if words[0].raw in ("it's", "its", "they're", "that's") and len(words) <= 4:
        return True
    if "short" in texts and any(word.kind == "number" for word in words):
        return False  # "we are two chairs short"
    people = PERSONS | RELATIVES
    past = any(w.raw.endswith("ed") or w.raw in PAST_VERBS for w in words)
    return texts[0] in people and past and "not" not in texts[:3] and not set(texts) & _WISHING


_SUITING: Final = frozenset("match fit suit".split())
_FORMER: Final = frozenset("carpet carpeting tile parquet laminate linoleum lino vinyl concrete wallpaper".split())
"""What floors and walls are covered with; a rug is a thing that lies on them."""
_JOINING: Final = frozenset("and but then or".split())
_LONGEST_SUBJECT: Final = 3


def end_of_purpose(words: Sequence[Word], at: int, clause: Sequence[Statement]) -> int:
    """Return the end of a purpose or a contrast after a clause that has said what shall be; 0 for other words.

    Parameters
    ----------
    clause : sequence of Statement
        What the clause asks for.
    """
    at += text_at(words, at) == ","
    end = next((k for k in range(at, next_mark(words, at)) if words[k].text in _JOINING), next_mark(words, at))
    if not clause or (end < len(words) and words[end].text in _JOINING):
        return 0
    said = words[at:end]
    coloured = all(isinstance(s, Paint | Finish) and (s.colour or s.material) for s in clause)
    laid = all(isinstance(s, Finish) for s in clause)
    held = (coloured and _suits(said)) or _spares_people(said) or (laid and _is_former(said))
    return end if held else 0


def _suits(said: Sequence[Word]) -> bool:
    """Whether words say what a colour goes with: ``so that it matches the sofa``, ``to go with the curtains``."""
    verb = 1
    if text_at(said, 0) == "so":
        verb += (text_at(said, 1) == "that") + 1
        if text_at(said, verb - 1) not in ("it", "they"):
            return False
    elif text_at(said, 0) != "to":
        return False
    length = 1 + (text_at(said, verb) in ("go", "fit") and text_at(said, verb + 1) == "with")
    suits = text_at(said, verb) in _SUITING or length > 1
    named = text_at(said, verb + length) in DETERMINERS and verb + length + 1 < len(said)
    return suits and named and not any(word.text in COLOUR_WORDS or word.text == "not" for word in said)


def _spares_people(said: Sequence[Word]) -> bool:
    """Whether words say what people no longer have to do: ``so that guests needn't walk through the hall``."""
    start = 1 + (text_at(said, 1) == "that")
    denied = next((k for k in range(start, min(len(said), start + _LONGEST_SUBJECT + 2)) if said[k].text == "not"), 0)
    subject = {word.text for word in said[start:denied]} - {"do", "need"}
    people = subject & (PERSONS | PEOPLE | {"they", "one", "nobody", "you"})
    obliged = said[denied].raw == "needn't" if denied else False
    obliged = obliged or text_at(said, denied - 1) == "need"
    obliged = obliged or (text_at(said, denied + 1) in ("have", "need") and text_at(said, denied + 2) == "to")
    return text_at(said, 0) == "so" and bool(denied and people and obliged)


def _is_former(said: Sequence[Word]) -> bool:
    """Whether words name the covering that a new one comes for: ``in place of that grey carpet``."""
    length = {("instead", "of"): 2, ("in", "place"): 3, ("rather", "than"): 2}.get((text_at(said, 0), text_at(said, 1)))
    if length is None or (length == 3 and text_at(said, 2) != "of"):
        return False
    named = [word.text for word in said[length:] if word.text not in DETERMINERS | {"old", "present", "worn"}]
    return bool(named) and named[-1] in _FORMER and all(word in COLOUR_WORDS for word in named[:-1])
