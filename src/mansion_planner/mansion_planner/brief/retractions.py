"""Leave out what a brief names and takes back: "a library, no, a bookshop", "a sauna (scrap that)", "forget the bar".

What is named last takes the place of the first, with its number where it has none of its own.
"""

from collections.abc import Sequence
from dataclasses import replace

from mansion_planner.brief.corrections import FILLERS, PAUSES, WEAK, sign_at, taken_back_by
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.relation_rooms import Relation

__all__ = ["without_retractions", "without_taken_back"]

_KINDS = {"room": "place", "building": "place", "object": "thing", "unknown": "thing"}
_ARTICLES = frozenset({"a", "an", "the", "one"})
_LEADS = frozenset({"in", "on", "at", "for", "of"})
_NEEDS_PAUSE = WEAK - {("actually",)}
"""Signs that only a pause after them tells from "no bookshop" and "rather a bookshop"."""
_WHOLE = frozenset((verb, "that") for verb in ("scrap", "scratch", "strike", "forget", "cancel")) | {("no", "wait")}
"""Signs that take back what the sentence before names, too."""
_WITHDRAWING = (
    *[(verb,) for verb in ("forget", "scrap", "scratch", "cancel", "skip", "drop", "strike")],
    *[(verb,) for verb in ("remove", "delete", "ditch", "cut", "omit", "replace")],
    ("take", "out"),
    ("get", "rid", "of"),
    ("do", "without"),
    ("forget", "about"),
    ("never", "mind"),
    ("leave", "out"),
    *[(verb, "that", ",", "no") for verb in ("forget", "scrap", "scratch", "cancel", "strike")],
    *[(*lead, "no") for lead in (("on", "second", "thought"), ("on", "reflection"), ("actually",), ("wait",))],
    *[(*lead, ",", "no") for lead in (("on", "second", "thought"), ("on", "reflection"), ("actually",), ("wait",))],
)
_LAST_WITHDRAWING = frozenset(words[-1] for words in _WITHDRAWING)
"""Words that those end with; nearly all tokens follow none of them."""
"""Words before the name of what was named earlier and is not wanted any more."""
_REACH = 30
"""Tokens between what is named and its withdrawal, at most."""


def without_retractions(reading: Reading, phrases: Sequence[Phrase]) -> list[Phrase]:
    """Return the phrases without those that are taken back; the words that take them back are read."""
    phrases = _without_withdrawn(reading, phrases)
    found: list[Phrase] = []
    begins = {phrase.begin: number for number, phrase in enumerate(phrases)}
    number = 0
    while number < len(phrases):
        phrase = phrases[number]
        start, dropped = _instead(reading, phrase.last)
        later = begins.get(start, -1) if start else -1
        if dropped and phrase.head in _KINDS:
            reading.take(phrase.first, start)
            number += 1
            continue
        if later <= number or not _alike(phrase, phrases[later]):
            found.append(phrase)
            number += 1
            continue
        new = phrases[later]
        reading.take(phrase.first, new.first)
        if reading.word(new.last) in PAUSES and reading.word(new.last + 1) in _LEADS:
            new = replace(new, last=new.last + 1)  # "a sofa, no, an armchair, in the hall"
        if phrase.counted and not new.counted:
            new = replace(new, count=phrase.count, counted=True)
        if reading.word(new.last) == "instead":
            reading.take(new.last, new.last + 1)
        phrases = [*phrases[:later], new, *phrases[later + 1 :]]
        number = later
    return found


def _without_withdrawn(reading: Reading, phrases: Sequence[Phrase]) -> list[Phrase]:
    """Return the phrases without what a later one withdraws: "a cafe ... (scrap the cafe)", "never mind the glass".

    The later one stays if it names a room, which is not wanted then; of a thing nothing is left to say.
    """
    dropped: set[int] = set()
    for number, phrase in enumerate(phrases):
        words = _withdrawing(reading, phrase.first) or int(_is_dropped_after_all(reading, phrase))
        earlier = _named_before(reading, phrases, number) if words else None
        if earlier is None or earlier in dropped:
            continue
        dropped.add(earlier)
        reading.take(phrases[earlier].first, phrases[earlier].last)
        if reading.word(phrase.first - 1) == "no":
            reading.take(phrase.first - words, phrase.first - 1)
        if phrase.head != "room":
            dropped.add(number)
            reading.take(phrase.first - words, phrase.last)
    _take_withdrawn_words(reading, phrases)
    return [phrase for number, phrase in enumerate(phrases) if number not in dropped]


_AFTER_ALL = frozenset({("sorry", ","), ("well", ","), ("wait", ","), ("no", "wait"), ("oh", "wait"), ("no", ",")})
"""What stands before "no garage" where a garage was wanted before."""


def _is_dropped_after_all(reading: Reading, phrase: Phrase) -> bool:
    """Whether "no sauna after all", "no sauna any more" or "sorry, no sauna" takes back what stands before."""
    if reading.word(phrase.begin - 1) != "no":
        return False
    after = reading.words(phrase.last, phrase.last + 2) in (("after", "all"), ("any", "more"))
    lead = reading.words(phrase.begin - 3, phrase.begin - 1)
    return after or reading.word(phrase.last) == "anymore" or lead in _AFTER_ALL


def _take_withdrawn_words(reading: Reading, phrases: Sequence[Phrase]) -> None:
    """Take a word that no phrase is made of where it is withdrawn, and where it is told first: "with glass ..."."""
    named = {index for phrase in phrases for index in range(phrase.first, phrase.last)}
    for index in range(len(reading.tokens)):
        article = reading.word(index - 1) in ("the", "that", "a")
        words = _withdrawing(reading, index - article)
        if not words or index in named or reading.kind(index) != "word":
            continue
        earlier = [at for at in range(max(index - _REACH, 0), index - words) if reading.word(at) == reading.word(index)]
        if earlier and earlier[-1] not in named:
            reading.take(earlier[-1], earlier[-1] + 1)
            reading.take(index - article - words, index + 1)


def _withdrawing(reading: Reading, index: int) -> int:
    """Return of how many tokens the words are that withdraw what begins at a token; 0 where none do."""
    if reading.word(index - 1) not in _LAST_WITHDRAWING:
        return 0
    lengths = [len(words) for words in _WITHDRAWING if reading.words(index - len(words), index) == words]
    length = max(lengths, default=0)
    return 0 if reading.word(index - length - 1) == "not" else length


def _named_before(reading: Reading, phrases: Sequence[Phrase], number: int) -> int | None:
    """Return the phrase before that names the same thing; none where there is none near by."""
    phrase = phrases[number]
    for earlier in range(number - 1, -1, -1):
        other = phrases[earlier]
        if phrase.first - other.last > _REACH:
            return None
        if other.head == phrase.head and other.head in ("room", "object") and other.name == phrase.name:
            return earlier
    return None


def _alike(old: Phrase, new: Phrase) -> bool:
    return _KINDS.get(old.head, "") == _KINDS.get(new.head, "-") and old.name != new.name


def _instead(reading: Reading, index: int) -> tuple[int, bool]:
    """Return where what is wanted instead begins, its article and number left out; 0 where nothing is taken back.

    Second is whether nothing takes the place of what is taken back: "a sauna, scrap that."
    """
    at = _after_pauses(reading, index)
    ended = reading.word(at) == "." and any(
        reading.words(at + 1, at + 1 + len(sign)) == sign for sign in (*_WHOLE, ("no", ",", "wait"))
    )
    at += ended
    paused, first, sure, whole = at > index, at, False, False
    while (sign := sign_at(reading.tokens, at)) is not None:
        after = _after_pauses(reading, at + len(sign))
        sure = sure or sign not in _NEEDS_PAUSE or after > at + len(sign)
        whole = whole or sign in _WHOLE
        at = after
    if at == first or not paused or not sure:
        return 0, False
    if whole and (reading.breaks(at) or reading.word(at) == ")"):
        return at, True
    while reading.word(at) in _ARTICLES or reading.kind(at) == "number":
        at += 1
    return at, False


def _after_pauses(reading: Reading, index: int) -> int:
    dots = reading.words(index, index + 2) == (".", ".")
    while reading.word(index) in PAUSES | FILLERS or (dots and reading.word(index) == "."):
        index += 1
    return index


def without_taken_back(reading: Reading, phrases: Sequence[Phrase], relations: Sequence[Relation]) -> list[Relation]:
    """Return the relations without those that the next one takes the place of.

    "A kitchen next to the boardroom - on second thought next to the reception" lies beside the reception.
    """
    found: list[Relation] = []
    for relation in relations:
        before = found[-1] if found else None
        end = max((phrases[n].last for n in before.rights), default=0) if before is not None else 0
        sign = taken_back_by(reading.tokens, end, relation.first) if 0 < end < relation.first else None
        named = any(end <= phrase.first < relation.first for phrase in phrases)
        if before is not None and sign is not None and not named:
            found.pop()
            reading.take(before.first, relation.first)
            relation = replace(relation, lefts=before.lefts)
        found.append(relation)
    return found
