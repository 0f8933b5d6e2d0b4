"""Clauses beside a request that only tell something, left out; what a pronoun takes up of them is put in its place."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Final

from mansion_editing.instructions.clauses.items import Item
from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.verb_words import PARTICIPLES
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import PEOPLE
from mansion_editing.instructions.phrases.words import (
    BE,
    COURTESIES,
    DETERMINERS,
    MODALS,
    PERSONS,
    PLURAL_PRONOUNS,
    PREPOSITIONS,
    PRONOUNS,
    SENTENCE_ENDS,
    STATE_WORDS,
    Word,
    split_words,
    text_at,
)
from mansion_language.colours import COLOUR_WORDS

__all__ = ["Left", "without_remarks"]

_JOINTS: Final = frozenset("and but so because since as then".split())
_CUTS: Final = frozenset([",", "-", ":", "(", ")"])
_LIMITING: Final = frozenset(
    "unless if only except without instead apart otherwise should must ought shall please let rather not-only every "
    "each all both either neither none nothing nobody's another other others rest same too enough fewer less more "
    "exactly least most missing lacking short surplus needed wanted required supposed everything anything".split()
)
"""Words that make a clause more than a remark."""
_WISHING: Final = frozenset(
    "want need like love prefer require lack miss wish expect fancy deserve demand ask order request insist suggest "
    "propose recommend appreciate use".split()
)
_GOING: Final = frozenset(
    "go belong move come leave stay remain stand hang sit lie become replace make-way get".split()
)
_REASONS: Final = (
    ("since",), ("as",), ("because",), ("seeing", "as"), ("seeing", "that"), ("now", "that"), ("given", "that"),
    ("given",), ("considering",), ("while",), ("when",), ("after",), ("before",), ("whenever",), ("although",),
    ("even", "though"), ("though",), ("once",),
)  # fmt: skip
_OCCASIONS: Final = (
    ("ahead", "of"), ("prior", "to"), ("because", "of"), ("due", "to"), ("owing", "to"), ("thanks", "to"),
    ("in", "view", "of"), ("in", "light", "of"), ("in", "preparation", "for"), ("in", "honour", "of"),
    ("in", "anticipation", "of"), ("in", "time", "for"), ("in", "the", "interest", "of"), ("for",), ("before",),
    ("after",), ("during",), ("until",), ("given",), ("with",), ("despite",), ("by", "way", "of"), ("as", "part", "of"),
    ("on", "account", "of"), ("on",), ("at",),
)  # fmt: skip
_DIMENSIONS: Final = frozenset("floor side left right wall corner middle window door top".split())
_PRONOUNS: Final = frozenset("it them they these those this that one ones both there its their".split())
_SINGULAR: Final = frozenset("it this that".split())


@dataclass(frozen=True)
class Left:
    """A text without a clause, and the clause."""

    text: str
    remark: str


_MOST_CUTS: Final = 30
"""Places at most at which a sentence is parted: its parts are as many as the pairs of them."""
_EACH: Final = frozenset("everybody everyone each every all per both".split())


def without_remarks(text: str, lexicon: Lexicon, floors: tuple[int, ...]) -> Iterator[Left]:
    """Yield a text without one of its clauses, for each that only tells something, the longest first."""
    words = split_words(text, lexicon.speller, lexicon.kept)
    found: list[tuple[int, int]] = []
    for first, last in _sentences(words):
        cuts = [at for at in range(first + 1, last) if _may_part(words, at)]
        if len(cuts) > _MOST_CUTS:
            continue
        ends = [first, *cuts, last]
        found += [(a, b) for a in ends for b in ends if a < b]
    for first, last in sorted(found, key=lambda part: part[0] - part[1]):
        part = _trimmed(words[first:last])
        if not part or len(part) == len(_trimmed(words)) or not _is_remark(part, lexicon):
            continue
        hard = last >= len(words) or words[last].kind == "mark" or words[last].text in ("and", "but", "so")
        if not hard and not _begins_dependent([word.text for word in part]):
            continue
        if any(word.kind == "number" for word in part) and any(word.text in _EACH for word in words):
            continue  # "there are eight of us, so a glass for everybody"
        left = _left_out(text, words, part, lexicon, floors)
        if left:
            yield Left(left, text[part[0].start : part[-1].end])


def _sentences(words: Sequence[Word]) -> Iterator[tuple[int, int]]:
    first = 0
    for at, word in enumerate(words):
        if word.kind == "mark" and word.text in SENTENCE_ENDS:
            if at > first:
                yield first, at
            first = at + 1
    if first < len(words):
        yield first, len(words)


def _may_part(words: Sequence[Word], at: int) -> bool:
    """Whether a clause may begin at a place: ``ahead of the wedding could you put``."""
    text, following = words[at].text, text_at(words, at + 1)
    asks = text in ("could", "can", "would", "will") and following == "you"
    return text in _CUTS or text in ("and", "but", "so", "please") or asks or (text in ("i", "we") and at > 1)


def _trimmed(words: Sequence[Word]) -> Sequence[Word]:
    start, end = 0, len(words)
    while start < end and (words[start].text in _CUTS | COURTESIES | {"and", "but"} or words[start].kind == "mark"):
        start += 1
    while end > start and (words[end - 1].text in _CUTS | COURTESIES or words[end - 1].kind == "mark"):
        end -= 1
    return words[start:end]


def _is_remark(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether a clause tells why, when or of what is, and asks for nothing."""
    texts = [word.text for word in words]
    if texts[:2] == ["that", "is"] and text_at(words, 2) in PREPOSITIONS:
        return False
    if texts[0] == "that" and text_at(words, 1) in DETERMINERS:
        return False  # "make sure that ... and that the fan runs"
    if words[0].raw.endswith("ed") and not lexicon.is_object((texts[0],)):
        return False  # "switched on so I can find it" is how the thing shall be
    if texts[0] in ("what", "whatever") and {*texts} & {"go", "out", "away", "leave"}:
        return False  # "what was there before can go"
    if _notes_deed(words, lexicon):
        return False
    limits = [text for at, text in enumerate(texts) if text != "more" or not _is_any_more(words, at)]
    if {*limits} & _LIMITING or any(word.text in COLOUR_WORDS for word in words):
        return False
    if _counts_things(words, lexicon):
        return False
    reason = next((len(said) for said in sorted(_REASONS, key=len, reverse=True) if _begins(texts, said)), 0)
    if reason and _is_telling(words[reason:], lexicon, reason=True):
        return True
    occasion = next((len(said) for said in sorted(_OCCASIONS, key=len, reverse=True) if _begins(texts, said)), 0)
    if occasion:
        return len(words) > occasion and not _names(words[occasion:], lexicon) and _verb_of(words, lexicon) is None
    if texts[:1] == ["to"] or texts[:2] == ["in", "order"]:
        return _is_purpose(words[1 if texts[0] == "to" else 3 :], lexicon)
    if texts[0] == "so" and len(words) > 2:
        return _is_purpose_clause(words[1 + (texts[1] == "that") :], lexicon)
    return _is_telling(words, lexicon, reason=False) or _is_call(words, lexicon)


def _notes_deed(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether a note says what is to be done with a thing: ``wardrobe added opposite``, ``chair pushed in``."""
    bare = words[0].kind == "word" and words[0].text not in DETERMINERS and _is_thing(words[0], lexicon)
    return bare and any(word.raw.endswith("ed") or (word.raw,) in PARTICIPLES for word in words[1:4])


def _is_any_more(words: Sequence[Word], at: int) -> bool:
    """Whether ``more`` is that of ``any more`` or counts persons: ``two more people``."""
    return text_at(words, at - 1) == "any" or text_at(words, at + 1) in PERSONS | PEOPLE


def _begins_dependent(texts: Sequence[str]) -> bool:
    """Whether a clause begins with what only introduces another one: ``ahead of the wedding could you``."""
    return any(_begins(texts, said) for said in (*_REASONS, *_OCCASIONS, ("to",), ("in", "order", "to")))


def _begins(texts: Sequence[str], said: tuple[str, ...]) -> bool:
    return tuple(texts[: len(said)]) == said


def _counts_things(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether a number stands before a thing of the catalogue."""
    for at, word in enumerate(words):
        one_of = word.text == "one" and text_at(words, at + 1) == "of"
        if word.kind == "number" and not one_of and any(_is_thing(after, lexicon) for after in words[at + 1 : at + 4]):
            return True
    return False


def _is_purpose(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether ``to cheer people up`` tells what for, with a verb of its own and no thing to be brought."""
    if not words or words[0].text in DETERMINERS | PREPOSITIONS or words[0].kind != "word" or words[0].plural:
        return False
    return not _names(words[1:], lexicon) and not lexicon.is_own_room((words[0].text,)) and words[0].text not in BE


def _is_purpose_clause(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether ``so that the kids can reach it`` tells what somebody can do then."""
    able = next((k for k in range(1, len(words)) if words[k].text in ("can", "could", "do", "will", "may")), 0)
    return (
        bool(able)
        and able < len(words) - 1
        and not _names(words[able + 1 :], lexicon)
        and not any(word.text in STATE_WORDS for word in words[able + 1 :])
    )


def _is_telling(words: Sequence[Word], lexicon: Lexicon, *, reason: bool) -> bool:
    """Whether a clause with a subject and a verb in the indicative asks for nothing."""
    texts = [word.text for word in words]
    if len(words) < 2 or texts[0] in ("there", "not", "no", "which", "who", "where", "whose", "what", "do"):
        return False
    if verb_at(words, 0, lexicon) is not None and not (reason and texts[0] in DETERMINERS):
        return False
    verb = _verb_of(words, lexicon)
    if verb is None or verb == 0:
        return False
    subject, rest = words[:verb], words[verb:]
    if any(word.kind == "mark" for word in words):
        return False
    if {word.text for word in rest[:4]} & _WISHING:
        return False
    if {"would", "could"} & {*texts} and texts[0] in ("i", "we"):
        return False
    if any(word.text in STATE_WORDS and word.text not in ("on", "off", "close", "open") for word in rest):
        return False
    if any(first in ("has", "have", "had", "is", "are") and second == "to" for first, second in pairwise(texts[verb:])):
        return False
    pronoun = subject[0].text in PRONOUNS | {"one", "all"}
    if not pronoun and (not _names(subject, lexicon) or subject[0].text in PERSONS):
        return rest[0].text not in ("must", "should")
    return _describes(rest, lexicon)


def _describes(rest: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether what is said of a thing or a room says how it is, not where it shall be or what becomes of it."""
    texts = [word.text for word in rest]
    first = texts[0]
    if first in MODALS and not (len(texts) > 1 and (texts[1] == "not" or rest[0].text == "cannot")):
        return False
    if ("to", "be") in pairwise(texts):
        return False
    if {*texts[:3]} & _GOING and not rest[0].raw.endswith("ed"):
        return False
    if first in BE:
        told = [text for text in texts[1:] if text not in ("very", "so", "really", "quite", "rather", "far", "just")]
        if not told or told[0] in PREPOSITIONS | DETERMINERS | STATE_WORDS.keys():
            return False
        if (told[0],) in PARTICIPLES or any((word.raw,) in PARTICIPLES for word in rest[1:3]):
            return False
    return not ({"no", "not"} & {*texts} and _names(rest, lexicon))


_DAYS: Final = frozenset("day time night week season hour".split())
_ASKED: Final = frozenset("what how why who where which do does did is are can could would should".split())
"""Words of questions, which may be what is asked."""


def _is_call(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether a few words without a verb call something out that is no thing: ``Story time``, ``Big day tomorrow``."""
    texts = {word.text for word in words}
    if len(words) == 2 and words[1].text in _DAYS:  # "Laundry day"
        return True
    if (
        texts & (_ASKED | DETERMINERS)
        or not 2 <= len(words) <= 6
        or _names(words, lexicon)
        or any(word.kind != "word" for word in words)
    ):
        return False
    if texts & (STATE_WORDS.keys() | {"away", "out", "not", "no"} | _PRONOUNS | _WISHING):
        return False
    return verb_at(words, 0, lexicon) is None and words[0].text not in PREPOSITIONS


def _verb_of(words: Sequence[Word], lexicon: Lexicon) -> int | None:
    """Return the place of the finite verb; None where there is none."""
    for at in range(1, len(words)):
        word, before = words[at], words[at - 1]
        if word.kind != "word" or word.genitive:
            continue
        if word.text in BE - {"be", "being", "been"} or word.text in MODALS or word.raw in _IRREGULAR:
            return at
        if word.text == "not" and word.raw != "not":  # "cannot"
            return at
        if at == 1 and before.text in ("i", "we", "you", "they") and word.text not in PREPOSITIONS:
            return at
        people = before.plural and not _is_thing(before, lexicon)
        if people and word.text not in PREPOSITIONS | DETERMINERS | _JOINTS:
            return at
        third = word.plural and not _is_thing(word, lexicon) and before.text not in PREPOSITIONS | DETERMINERS
        if third or (word.raw.endswith("ed") and before.text not in DETERMINERS | PREPOSITIONS):
            return at
    return None


_IRREGULAR: Final = frozenset(
    "has have had was were did came went got said bought forgot left broke told gave took made saw found lost fell "
    "began thought knew brought sent spent meant kept heard ran won sold caught spoke grew wore tore stole "
    "burst".split()
)


def _is_thing(word: Word, lexicon: Lexicon) -> bool:
    return (
        word.kind == "word"
        and word.text not in PERSONS | PEOPLE | MODALS
        and (lexicon.is_object((word.text,)) or word.text in _DIMENSIONS)
    )


def _names(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether words name a thing of the catalogue or a room of the building."""
    return any(
        word.kind == "id" or _is_thing(word, lexicon) or lexicon.is_own_room((word.text,))
        for word in words
        if word.text not in PERSONS | PEOPLE
    )


def _left_out(text: str, words: Sequence[Word], part: Sequence[Word], lexicon: Lexicon, floors: tuple[int, ...]) -> str:
    """Return a text without a clause; empty where what follows takes up something of it that is not certain."""
    before, after = text[: part[0].start], text[part[-1].end :]
    later = [word for word in words if word.start > part[-1].start]
    reader = ClauseReader(part, lexicon, floors, lambda first, last: "")
    things, rooms = _named(reader)
    if things or rooms:
        taken = _taken_up(after, later, part, things, text)
        if taken is None:
            return ""
        after = taken
    if rooms and not _names_room(later, lexicon):
        room = rooms[0]
        said = text[part[room[0]].start : part[room[1].end - 1].end]
        rest = after.lstrip(" ,.;:!-)")
        if len(rooms) > 1 or not rest:
            return ""
        after = f" in {said}, {rest}"
    return re.sub(r"^[\s,.;:!?-]+", "", f"{before}{after}").rstrip(" ,;:-")


def _named(reader: ClauseReader) -> tuple[list[tuple[int, Item]], list[tuple[int, Item]]]:
    """Return the things and the rooms that a clause names, each with where it begins."""
    things: list[tuple[int, Item]] = []
    rooms: list[tuple[int, Item]] = []
    at = 0
    while at < len(reader.words):
        item = reader.item(at)
        if item is None or item.end <= at or item.phrase.refers:
            at += 1
            continue
        (rooms if item.is_room else things).append((at, item))
        at = item.end
    return things, rooms


def _names_room(words: Sequence[Word], lexicon: Lexicon) -> bool:
    spans = (tuple(w.text for w in words[at : at + n]) for at in range(len(words)) for n in (1, 2, 3))
    return any(lexicon.is_own_room(span) for span in spans)


def _taken_up(
    after: str, later: Sequence[Word], part: Sequence[Word], things: Sequence[tuple[int, Item]], text: str
) -> str | None:
    """Return what follows a clause with the thing that it names for its first pronoun; None where that is uncertain."""
    pronouns = [word for word in later if word.text in _PRONOUNS and word.kind == "word"]
    if not pronouns:
        return after
    first = pronouns[0]
    offset = part[-1].end
    listed = _list_of(part, things, text) if first.text in PLURAL_PRONOUNS else ""
    if listed:
        return f"{after[: first.start - offset]}{listed}{after[first.end - offset :]}"
    things = things[:1] if things and things[0][0] == 0 else things
    if first.text not in _SINGULAR | PLURAL_PRONOUNS or len(things) != 1:
        return None if things else after
    at, item = things[0]
    one_of = part[at].text == "one" and text_at(part, at + 1) == "of"
    plural = item.phrase.noun.plural and not one_of
    if not (item.phrase.definite or one_of) or plural != (first.text in PLURAL_PRONOUNS):
        return None
    said = text[part[at].start : part[item.end - 1].end]
    return f"{after[: first.start - offset]}{said}{after[first.end - offset :]}"


def _list_of(part: Sequence[Word], things: Sequence[tuple[int, Item]], text: str) -> str:
    """Return the words of a list of things that a clause begins with; empty where it names one or other things."""
    joined = all(part[at - 1].text == "and" and before[1].end == at - 1 for before, (at, _) in pairwise(things))
    if len(things) < 2 or things[0][0] or not joined or not all(item.phrase.definite for _, item in things):
        return ""
    return text[part[0].start : part[things[-1][1].end - 1].end]
