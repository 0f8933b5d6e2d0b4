"""Clauses about people and what happens, which are the occasion of a request: ``The auditors come on Monday``.

They name nothing of the building, or have a subject that is no part of it, and a verb that asks for nothing.
"""

from collections.abc import Sequence
from dataclasses import replace
from itertools import takewhile
from typing import Final

from mansion_editing.instructions.phrases.lexicon import HYPERNYMS, Lexicon
from mansion_editing.instructions.phrases.verb_words import BY_WORDS
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import EVENTS, OPEN_TO_ALL, PEOPLE
from mansion_editing.instructions.phrases.words import (
    ADVERBS,
    BE,
    CONJUNCTIONS,
    COURTESIES,
    DETERMINERS,
    MODALS,
    PERSONS,
    PREPOSITIONS,
    PRONOUNS,
    STATE_WORDS,
    Word,
)
from mansion_editing.instructions.sentences.bystanding import tells_what_becomes
from mansion_language.colours import COLOUR_WORDS

__all__ = ["counts_people", "is_circumstance"]

_OBLIGING: Final = frozenset(
    "should must shall ought would might please let supposed wanted needed required rather "
    "insist suggest recommend propose beg urge".split()
)
"""Words by which something is asked for, whoever the subject is."""

_WISHING: Final = frozenset(
    "want need like love prefer require lack miss wish expect ask order demand fancy deserve belong have get has take "
    "use missing due".split()
)
"""Verbs whose object may be what is asked for."""

_LIMITING: Final = frozenset(
    "only just exactly least most more less fewer enough instead except without another same other others rest "
    "everything nothing none one ones them those these anything something all both each every half neither either "
    "plenty ample sufficient "
    "again back away if unless when until than otherwise anymore longer".split()
)
"""Words that tell how much or which of something is meant."""

_TIMES: Final = frozenset(
    "from since after during before until by on in at as next this last tomorrow today tonight yesterday recently "
    "currently usually sometimes".split()
)
_SOMEBODY: Final = frozenset("i we he she they you it people nobody somebody someone everybody everyone".split())
_ORDERED: Final = BE | frozenset("stay remain go come keep move stand hang lie sit disappear vanish leave".split())
_HAPPENED: Final = frozenset(
    "was were had did came went got said bought forgot left broke told gave took made saw found lost fell began "
    "thought knew brought sent spent meant kept heard ran won sold caught spoke grew drew flew slept sat stood".split()
)
_NEEDING: Final = frozenset("need want require lack miss like deserve".split())
_OCCASIONS: Final = frozenset(
    "monday tuesday wednesday thursday friday saturday sunday weekend morning afternoon tonight today tomorrow noon "
    "midnight january february march april may june july august september october november december christmas easter "
    "season shift emergency holiday manager caretaker janitor facility".split()
) | (EVENTS - {"meeting", "conference"})
"""Words of remarks without a verb: ``Rehearsal at five``, ``duty manager here``."""

_HABITS: Final = frozenset("always constantly often forever time".split())
"""Words of complaints about what others do: ``the cleaners leave them open all the time``."""

_ABSTRACT: Final = frozenset(
    "workplace landmark target reference space peace quiet calm help rest sleep privacy order exercise time break "
    "place".split()
)
"""What somebody may need that is no thing."""

_DEPARTMENTS: Final = frozenset(
    "housekeeping reception security maintenance catering management administration logistics accounting".split()
)
"""Rooms' names without an article, where they mean those who work there."""

_SHORTEST: Final = 4
"""Words of a clause that begins with a number."""

_DOING: Final = frozenset("start begin arrive visit open close work play meet move come return join".split())
"""Verbs with persons as subject and no object: ``a colleague starts on Monday``."""


def is_circumstance(words: Sequence[Word], lexicon: Lexicon, *, followed: bool) -> bool:
    """Whether a clause tells of people or of what happens, and asks for nothing of the building.

    Parameters
    ----------
    followed : bool
        A request comes after it, for which what somebody cannot do is a reason.
    """
    words = _bare(words)
    if [word.text for word in words[:2]] in (["in", "case"], ["in", "order"], ["so", "that"], ["provided", "that"]):
        return False
    words = _from_subject(words, lexicon)
    texts = [word.text for word in words]
    if counts_people(words, lexicon):
        return True
    event = texts[:1] == ["open"] and texts[1:2] and texts[1] in OPEN_TO_ALL
    ordered = verb_at(words, 0, lexicon) is not None and not event
    if len(words) < 2 or ordered or texts[0] in ("there", "not", "no", "if", "unless"):
        return False
    if any(word.text in _OBLIGING or word.text in COLOUR_WORDS for word in words):
        return False
    if any(word.kind == "mark" and word.text != "-" for word in words) or tells_what_becomes(words):
        return False
    if texts[0] in _DEPARTMENTS and len(words) > 2 and not _names(words[1:], lexicon):
        return _verb_of(words, lexicon) == 1
    if not any(_names([word], lexicon) or word.kind == "id" for word in words):
        return _is_foreign(words, lexicon)
    verb = _verb_of(words, lexicon)
    if verb is None or _names_here(words[:verb], lexicon) or texts[0] in PRONOUNS - {"they"}:
        return False
    if "not" in texts and not followed:
        return False
    return _asks_nothing(words, verb, lexicon)


def _bare(words: Sequence[Word]) -> Sequence[Word]:
    start, end = 0, len(words)
    joints = COURTESIES | {"and", "but", "so", "because"}
    while start < end and (words[start].kind == "mark" or words[start].text in joints):
        start += 1
    while end > start and (words[end - 1].kind == "mark" or words[end - 1].text in COURTESIES):
        end -= 1
    return words[start:end]


def _from_subject(words: Sequence[Word], lexicon: Lexicon) -> Sequence[Word]:
    """Return words without a time before their subject, and with a subject where they have none.

    ``From August we will have a visitor``, ``Sold the bicycle``.
    """
    if len(words) > 1 and _is_past(words[0]) and words[1].text in DETERMINERS - {"a", "an", "some", "no"}:
        given = words[:-1] if words[0].raw == "gave" and words[-1].text == "away" else words
        return [replace(words[0], text="we", raw="we"), *given]
    if not words or words[0].text not in _TIMES:
        return words
    start = next((at for at in range(1, min(len(words), 6)) if words[at].text in _SOMEBODY), 0)
    return words[start:] if start and not _names(words[:start], lexicon) else words


def _is_past(word: Word) -> bool:
    """Whether a word alone tells what somebody did: ``Sold``, ``Donated``."""
    return word.raw in _HAPPENED - {"left", "saw", "found", "meant", "kept"} or word.raw in ("donated", "binned")


def _is_foreign(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether words without any name of the building have nothing to do with it."""
    timed = words[-2].text == "at" and words[-1].kind == "number"
    words = words[:-2] if timed and len(words) > 2 else words
    texts = [word.text for word in words]
    would = "would" in texts or any(word.raw.endswith("'d") for word in words)
    wishing = {*texts} & (_WISHING | MODALS | {"be"}) - (frozenset() if would else frozenset(["love", "like"]))
    told = texts[-1:] == ["it"] and texts[0] not in ("i", "we", "you", "it")
    if {*texts} & PRONOUNS and wishing - {"have", "has", "will", "get"} and not told:
        return False
    if {*texts} & _NEEDING and (texts[0] in ("i", "we", "you") or not {*texts} & _ABSTRACT):
        return told and not {*texts} & (_NEEDING - {"like"})
    if (words[0].kind == "number" and len(words) < _SHORTEST) or texts[0] in PREPOSITIONS - {"of"}:
        return False
    verb = _verb_of(words, lexicon)
    if verb is not None and {*texts} & _HABITS and texts[0] not in ("i", "we", "you", *PRONOUNS):
        return True
    if verb is not None:
        return not {*texts} & {"one", "ones", "those", "these", "them", "everything", "instead", "another"}
    plain = all(word.kind == "word" for word in words) and texts[0] not in DETERMINERS | PREPOSITIONS
    unsaid = _LIMITING | PRONOUNS | (STATE_WORDS.keys() - {"on"}) | {"not", "no", "out"}
    timely = {*texts} & (_OCCASIONS | PEOPLE | PERSONS | OPEN_TO_ALL)
    rest = texts[1:] if texts[0] == "open" and texts[1] in OPEN_TO_ALL else texts
    return plain and bool(timely) and not {*rest} & unsaid


def _verb_of(words: Sequence[Word], lexicon: Lexicon) -> int | None:
    """Return the place of the finite verb of a declarative clause; None where there is none."""
    for at in range(1, len(words)):
        word, before = words[at], words[at - 1]
        if word.kind != "word" or word.genitive:
            continue
        if word.text in BE - {"be", "being", "been"} or word.text in MODALS or word.raw in _HAPPENED:
            return at
        if word.raw in ("has", "have", "had") or (word.text == "not" and word.raw != "not"):
            return at
        if before.raw.endswith(("'ll", "'ve", "'d", "'re", "'m", "'s")) and before.text in _SOMEBODY:
            return at
        if at == 1 and before.text in ("i", "we", "you", "they") and word.text not in PREPOSITIONS:
            return at
        people = before.plural and before.text in PEOPLE | PERSONS
        if people and word.text not in PREPOSITIONS | CONJUNCTIONS | ADVERBS:
            return at
        third = word.plural and not _names([word], lexicon) and before.text not in PREPOSITIONS | DETERMINERS
        if third and before.text not in ("and", ","):
            return at
        if word.raw.endswith("ed") and before.kind == "word" and before.text not in DETERMINERS | PREPOSITIONS:
            return at
    return None


def _asks_nothing(words: Sequence[Word], verb: int, lexicon: Lexicon) -> bool:
    """Whether a clause that names something of the building only tells what people do."""
    texts = [word.text for word in words]
    subject = words[:verb]
    if {*texts} & _LIMITING or texts[0] == "you" or {*texts} & (_NEEDING - {"like"}):
        return False
    joints = [at for at in range(verb + 1, len(words) - 1) if words[at].text in ("and", "but", "so")]
    if any(not _goes_on_telling(words[:verb], words[at + 1 :], lexicon) for at in joints):
        return False
    counted = [at for at, word in enumerate(words) if word.kind == "number" and at + 1 < len(words)]
    if any(_is_thing(words[at + 1 : at + 2], lexicon) for at in counted):
        return False
    if {word.text for word in words[verb + 1 :]} & STATE_WORDS.keys() - {"on", "off", "open", "close"}:
        return False
    main = verb
    while main + 1 < len(words) and (
        words[main].text in MODALS | {"not", "be", "been", "being"} or _is_aux(words, main) or _goes_on(words, main)
    ):
        main += 1
    said = words[main]
    perfect = any(word.raw in ("has", "have", "had", "was", "were") for word in words[verb:main])
    past = said.raw in _HAPPENED or (said.raw.endswith("ed") and said.kind == "word")
    doing = said.raw.endswith("ing")
    if said.text in _NEEDING or (said.text == "do" and words[main + 1 : main + 2] and words[main + 1].text == "with"):
        return False
    if said.text in _WISHING and not perfect:
        return not _is_thing_after(words, main + 1, lexicon)
    if said.text in _ORDERED and _names_rest(words, main, lexicon) and said.text not in ("sit", "come", "is", "are"):
        return False
    if past or perfect or doing:
        return True
    head = subject[: _end_of_head(subject)]
    person = head[-1].text in PERSONS | PEOPLE | _SOMEBODY or not _names(head, lexicon)
    asked = (said.text,) in BY_WORDS and said.text not in _DOING | {"sit", "find", "use"}
    return person and not asked


def _goes_on_telling(subject: Sequence[Word], part: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether what follows a conjunction is no clause, or one that asks for nothing either."""
    first = part[0]
    if first.plural and not _names([first], lexicon) and first.kind == "word":
        return not _names(part, lexicon) or _asks_nothing([*subject, *part], len(subject), lexicon)
    verb = _verb_of(part, lexicon)
    return verb is None or is_circumstance(part, lexicon, followed=True)


def _is_aux(words: Sequence[Word], at: int) -> bool:
    following = words[at + 1]
    return words[at].raw in ("has", "have", "had", "is", "are", "was", "were", "am") and following.raw.endswith(
        ("ed", "ing", "en")
    )


def _goes_on(words: Sequence[Word], at: int) -> bool:
    """Whether a verb only says that something happens again and again: ``keeps tripping``."""
    return words[at].text == "keep" and words[at + 1].raw.endswith("ing")


def _is_thing_after(words: Sequence[Word], at: int, lexicon: Lexicon) -> bool:
    """Whether what follows a verb is a thing or a room, or something that is to be done."""
    while at < len(words) and words[at].text in DETERMINERS | {"new", "proper", "to", "for", "no", "not"}:
        if words[at].text == "to":
            return True
        at += 1
    end = at
    while end < len(words) and words[end].text not in PREPOSITIONS and words[end].kind == "word" and end < at + 4:
        end += 1
    return _is_thing(words[at:end], lexicon)


def _is_thing(words: Sequence[Word], lexicon: Lexicon) -> bool:
    return any(
        lexicon.is_object((word.text,)) or lexicon.is_room((word.text,))
        for word in words
        if word.text not in PERSONS | PEOPLE
    )


def _names_rest(words: Sequence[Word], at: int, lexicon: Lexicon) -> bool:
    return _names(words[at + 1 :], lexicon)


def _names(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether words name a thing of the catalogue, or a room or a storey of the building."""
    return any(
        word.text == "floor" or lexicon.is_object((word.text,)) or lexicon.is_own_room((word.text,))
        for word in words
        if word.text not in PERSONS | PEOPLE | MODALS
    )


def _end_of_head(subject: Sequence[Word]) -> int:
    """Return where what belongs to the head of a subject begins: ``in a wheelchair`` of a client."""
    return next((at for at, word in enumerate(subject) if at and word.text in PREPOSITIONS), len(subject))


def _names_here(subject: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether the head of a subject is a thing or a room that the building has."""
    stop = _end_of_head(subject)
    head = subject[:stop][-1:]
    pair = tuple(word.text for word in subject[:stop][-2:])
    rooms = lexicon.is_own_room(pair) and len(pair) == 2
    return rooms or any(
        word.text not in PERSONS | PEOPLE
        and (lexicon.is_here(word.text) or lexicon.is_own_room((word.text,)) or word.text in HYPERNYMS | {"floor"})
        for word in head
    )


_WHO: Final = frozenset("we you us".split())
_BEFORE: Final = BE | ADVERBS | frozenset("there already about roughly around will".split())
"""Words between a subject and its number."""

_ASKING: Final = frozenset(
    "short too missing more less fewer without enough no not none instead only another each per all both".split()
)
"""Words that tell of a number that shall be another one: ``we're two short``."""


def counts_people(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether a clause says of people how many they are, where and when, and nothing of any thing."""
    at = next((k for k, word in enumerate(words) if word.kind == "number"), len(words))
    if at == len(words) or any(word.kind != "word" for word in [*words[:at], *words[at + 1 :]]):
        return False
    said = [word.text for word in words[:at] if word.text not in _BEFORE]
    being = any(word.text in BE or word.raw.endswith(("'re", "'ll")) for word in words[:at])
    rest = list(words[at + 1 :])
    of_them = rest[:1] != [] and rest[0].text == "of" and rest[1:2] != [] and rest[1].text in _WHO
    rest = rest[2:] if of_them else rest
    people = list(takewhile(lambda word: word.text in PEOPLE | PERSONS | {"people"}, rest))
    rest = rest[len(people) :]
    named = of_them or (bool(people) and "there" in {word.text for word in words[:at]})
    if not being or not (said in (["we"], ["you"]) or (said == [] and named)):
        return False
    follows = not rest or rest[0].text in PREPOSITIONS | ADVERBS
    telling = not {word.text for word in rest} & (_ASKING | MODALS)
    return follows and telling and not any(lexicon.is_object((word.text,)) for word in rest)
