"""Clauses beside a request that ask for nothing themselves: how something is or was, an exclamation, a purpose."""

import itertools
from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.verb_words import BY_WORDS, GERUNDS, PARTICIPLES
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import OPEN_TO_ALL, PEOPLE, RELATIVES
from mansion_editing.instructions.phrases.words import (
    BE,
    COURTESIES,
    DETERMINERS,
    MODALS,
    NEED,
    PERSONS,
    PREPOSITIONS,
    STATE_WORDS,
    Word,
)
from mansion_language.colours import COLOUR_WORDS

__all__ = [
    "asks_for_nothing",
    "begins_with_state",
    "fills_gaps",
    "gives_up_room",
    "is_exclamation",
    "is_habit",
    "is_purpose",
    "is_regret",
    "is_rhetorical",
    "lacks_a_place",
    "needs_the_space",
    "stands_wrong",
    "tells_what_becomes",
    "tells_whose",
    "notes_deed",
]

_ASKING: Final = MODALS | NEED | frozenset(
    "please let make wish prefer like love fancy expect missing belong deserve instead only just another more less "
    "fewer exactly least most each every all both half either or to too longer anymore if unless when until except "
    "wrong same supposed due ready nice good great better best ask demand than unwanted superfluous surplus "
    "unnecessary redundant wanted needed required enough plenty ample sufficient suffice "
    "insist suggest recommend propose beg urge".split()
)  # fmt: skip
"""Words of clauses that may ask for something, though their form only tells."""

_LACKING: Final = frozenset("no none nothing not never without broken defective dirty dark bare empty old ugly".split())
"""Words of complaints, which ask for something where no request follows that mends them."""

_NOT_OURS: Final = frozenset("a an part my mine ours hers his theirs yours concerned affected involved".split())
_OTHERS: Final = PEOPLE | frozenset("people nobody everyone everybody somebody child kid".split())
_THOSE: Final = frozenset("it them those these that this".split())
_OWN: Final = frozenset("mine yours his hers ours theirs".split())
_FILLING: Final = frozenset("add put place give bring supply provide fill".split())
_OF_GAPS: Final = _FILLING | frozenset(
    "in up to one ones it them a new only just where wherever whatever what those that which is are be missing lacking "
    "none not no yet still there have has do does the gap".split()
)
"""All words of a clause by which what is missing shall be filled in."""
_CONTRACTED: Final = frozenset("isn't aren't wasn't weren't".split())
_RESTING: Final = frozenset("stand sit lie hang rest live".split())
_COUNTED: Final = frozenset("a an some any several".split())
_SAID_BY_NOBODY: Final = frozenset("everything anything something all these those which that who".split())
_PAST: Final = frozenset("was were had did came got said bought forgot left broke told gave".split())
_DONE: Final = _PAST | frozenset("put let taken given made brought kept chosen hung built done been".split())
_HAVING: Final = frozenset("has have had".split())
_SWITCHED: Final = frozenset("switched turned powered left kept set standing wide".split())


def asks_for_nothing(words: Sequence[Word], lexicon: Lexicon, *, followed: bool) -> bool:
    """Whether a clause only tells how something is or was, or what somebody does.

    Parameters
    ----------
    followed : bool
        A request comes after it, for which a complaint is a reason.
    """
    words = _bare(words)
    words = words[:-2] if [word.text for word in words[-2:]] == ["at", "all"] else words
    verb = None if any(word.text == "," for word in words) else _finite_verb(words, lexicon)
    if verb is None or verb_at(words, 0, lexicon) is not None or not _is_subject(words[:verb], lexicon):
        return False
    texts = [word.text for word in words]
    plenty = texts[verb] in _HAVING and ("enough" in texts or "plenty" in texts)
    asking = bool(set(texts) & (_ASKING - {"enough", "plenty"} if plenty else _ASKING))
    asking = asking or any(word.raw.endswith("'d") for word in words)
    asking = asking or tells_what_becomes(words)
    if asking or (set(texts) & _LACKING and not followed and not _denies_kind(texts, verb)):
        return False
    if any(word.kind in ("number", "ordinal", "unit") for word in words[verb:]):
        return False
    return _only_tells(words, verb, lexicon)


def _bare(words: Sequence[Word]) -> Sequence[Word]:
    """Return words without the marks and courtesies around them."""
    start, end = 0, len(words)
    while start < end and (words[start].kind == "mark" or words[start].text in COURTESIES):
        start += 1
    while end > start and words[end - 1].kind == "mark":
        end -= 1
    return words[start:end]


def tells_what_becomes(words: Sequence[Word]) -> bool:
    """Whether words ask for another room or thing: ``the hall becomes an office``, but not ``the air becomes bad``."""
    texts = [word.text for word in words]
    return any(first == "become" and second in ("a", "an", "the", "our") for first, second in itertools.pairwise(texts))


def _denies_kind(texts: Sequence[str], verb: int) -> bool:
    """Whether a clause says what something is not, or whose: ``this is not a night club``, ``the box isn't hers``."""
    denied = next((at for at in range(verb, len(texts)) if texts[at] == "not"), len(texts))
    return texts[verb] in BE | {"not"} and " ".join(texts[denied + 1 : denied + 2]) in _NOT_OURS


def _is_subject(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether words before a verb name somebody, or something that is there already."""
    if not words or words[0].text in _SAID_BY_NOBODY or words[0].text in PREPOSITIONS | {"there", "not", "nothing"}:
        return False
    if any(word.kind == "mark" and word.text != "-" for word in words):
        return False
    counted = words[0].text in _COUNTED or words[0].kind == "number"
    return not (counted and _names(words, lexicon))


def _finite_verb(words: Sequence[Word], lexicon: Lexicon) -> int | None:
    """Return the place of the verb of a declarative clause; None where there is none."""
    for at in range(1, len(words)):
        word, before = words[at], words[at - 1]
        if word.kind != "word" or word.genitive:
            continue
        if word.text in BE - {"be", "being", "been"} or word.raw in _PAST | _HAVING | _CONTRACTED:
            return at
        third = word.plural and not _names([word], lexicon) and before.text not in PREPOSITIONS | {"the", "and"}
        person = at == 1 and before.text in ("i", "we", "you", "they") and word.text not in PREPOSITIONS
        if third or person or (word.raw.endswith("ed") and before.kind == "word" and at + 1 < len(words)):
            return at
    return None


def _only_tells(words: Sequence[Word], verb: int, lexicon: Lexicon) -> bool:
    """Whether a verb and what follows it describe, rather than say what shall be."""
    said = words[verb]
    thing = _names(words[:verb], lexicon)
    past = said.raw in _PAST or (said.raw.endswith("ed") and said.text not in BE)
    rest = words[verb + 1 :]
    if not past and said.text not in BE | _HAVING and said.raw not in _CONTRACTED:
        own = said.text == "keep" and bool(rest) and rest[0].text in ("its", "their", "the", "his", "her")
        asked = (said.text,) in BY_WORDS and said.text not in _RESTING | {"get", "have"} and not own
        if asked or (thing and said.text in _RESTING):
            return False
    if said.text in ("get", "have") and not past and any(w.text in _COUNTED for w in rest):
        return "already" in [w.text for w in rest]
    if said.text == "get" and not any(w.text in ("no", "past") for w in rest):
        return False
    if thing and said.text in BE and not past:
        told = rest[1:] if rest and rest[0].text in ("already", "still", "not", "now", "being") else rest
        if any((w.text,) in PARTICIPLES or (w.raw,) in PARTICIPLES for w in told[:2]):
            return False
        if [w.text for w in told] == ["in", "the", "way"]:
            return True
        if told and (told[0].text in PREPOSITIONS or told[0].text in _COUNTED):
            return rest[0].text == "not" or "already" in [w.text for w in rest]
    if any(w.text in STATE_WORDS for w in rest[-1:]) or any(w.text in COLOUR_WORDS for w in rest):
        return False
    return not any(w.text in STATE_WORDS and w.text not in ("on", "off") for w in rest)


def _names(words: Sequence[Word], lexicon: Lexicon) -> bool:
    return any(lexicon.is_object((w.text,)) or lexicon.is_own_room((w.text,)) for w in words if w.text not in PERSONS)


def begins_with_state(words: Sequence[Word]) -> bool:
    """Whether words without a subject begin with a state, which may be wished for: ``switched on so I can find it``."""
    if not words:
        return False
    first, following = words[0], words[1].text if len(words) > 1 else ""
    if following in DETERMINERS or (first.text == "open" and following in OPEN_TO_ALL):
        return False
    brought_to = first.raw.endswith("ed") or first.text in _SWITCHED
    if (first.raw,) in PARTICIPLES or (following in STATE_WORDS and brought_to):
        return True
    switched = first.text in ("on", "off")
    return first.text in STATE_WORDS and (not switched or following in ("", "so", "and", "before"))


def fills_gaps(words: Sequence[Word]) -> bool:
    """Whether words only say that what is missing shall be added: ``add one only where it is missing``."""
    texts = [word.text for word in words if word.text not in COURTESIES | {",", "so", "then", "and", "."}]
    texts = texts[1:] if texts[:1] in (["only"], ["just"]) else texts
    if texts[:1] == [] or texts[0] not in _FILLING or not {*texts} <= _OF_GAPS:
        return False
    lacking = [at for at, text in enumerate(texts) if text in ("missing", "lacking", "none", "not", "no")]
    where = next((at for at, text in enumerate(texts) if text.startswith(("wh", "that", "those"))), len(texts))
    if len(lacking) != 1 or lacking[0] < where:
        return texts == ["fill", "the", "gap"] or texts == ["fill", "in", "the", "gap"]
    return texts[lacking[0]] not in ("not", "no") or texts[lacking[0] + 1 :] in (
        ["have", "one"],
        ["one"],
        ["one", "yet"],
    )


def is_exclamation(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether words without a verb call something out that is no thing of the building: ``World cup final``."""
    words = _bare(words)
    if not words or len(words) > 6 or verb_at(words, 0, lexicon) is not None or words[0].text in PREPOSITIONS:
        return False
    texts = [word.text for word in words]
    timed = len(words) > 2 and texts[-2] == "at" and words[-1].kind == "number"
    words = words[:-2] if timed else words
    if {*texts} & (_ASKING | _LACKING | STATE_WORDS.keys() | COLOUR_WORDS.keys() | {"out", "away", "off"}):
        return False
    if any(word.kind != "word" for word in words) or texts[0] in _COUNTED | {"the"}:
        return False
    return not _names(words[-1:], lexicon)


def is_habit(words: Sequence[Word]) -> bool:
    """Whether words tell what others do with what was named: ``people do buy those``, ``nobody ever uses it``."""
    words = _bare(words)
    texts = [word.text for word in words]
    start = texts[:1] in (["the"], ["our"])
    if not 3 <= len(words) - start <= 6 or texts[start] not in _OTHERS or texts[-1] not in _THOSE:
        return False
    middle = texts[start + 1 : -1]
    return not {*middle} & (_ASKING | BE | {"not", "have", "get"}) and all(word.kind == "word" for word in words)


def is_regret(words: Sequence[Word]) -> bool:
    """Whether words regret what was done: ``we should never have bought that sofa``."""
    texts = [word.text for word in _bare(words)]
    if texts[:1] not in (["i"], ["we"], ["you"], ["they"], ["somebody"], ["someone"]) or "have" not in texts[2:5]:
        return False
    at = texts.index("have")
    done = _bare(words)[at + 1 : at + 2]
    past = any(word.raw in _DONE or (word.raw.endswith("ed") and word.kind == "word") for word in done)
    before = set(texts[1:at])
    return past and before in ({"should", "never"}, {"should", "not"}, {"should", "really", "not"})


_STANDING: Final = frozenset("is are was were stand look face point sit hang lie be".split())
_WRONG: Final = frozenset("side way end direction place spot".split())


def stands_wrong(words: Sequence[Word]) -> Sequence[Word]:
    """Return the subject of ``the head end is on the wrong side``, ``it faces the wrong way``; empty for others."""
    words = [word for word in _bare(words) if word.text not in ("now", "currently", "still", "round", "around")]
    texts = [word.text for word in words]
    at = texts.index("wrong") if "wrong" in texts else 0
    verb = next((k for k in range(at - 1, 0, -1) if texts[k] in _STANDING), 0)
    ends = texts[at + 1 : at + 2] and texts[at + 1] in _WRONG and len(texts) == at + 2
    between = texts[verb + 1 : at] in (["the"], ["on", "the"], ["in", "the"], ["at", "the"], ["to", "the"])
    plain = all(word.kind != "mark" for word in words) and not {*texts} & (MODALS | {"not", "no", "if", "and", "or"})
    return words[:verb] if verb and ends and between and plain else []


def needs_the_space(words: Sequence[Word]) -> bool:
    """Whether somebody needs ``the space`` or the floor that a request makes free: ``we need the space for plates``."""
    texts = [word.text for word in _bare(words)]
    needing = texts.index("need") if "need" in texts else 0
    subject = [word for word in _bare(words)[:needing] if word.text not in ("the", "our", "my")]
    somebody = len(subject) == 1 and subject[0].text in PERSONS | RELATIVES | PEOPLE | {"they"}
    after = texts[needing + 1 : needing + 4]
    plain = all(word.kind == "word" for word in _bare(words)) and not {*texts} & {"more", "from", "in", "not"}
    return somebody and plain and after[:2] in (["the", "space"], ["the", "floor"]) and after[2:] in ([], ["for"])


def needs_doing(words: Sequence[Word]) -> bool:
    """Whether words say what happens to things that a request was about: ``they need airing``, ``it needs a rest``.

    What the editor can do itself ("it needs cleaning") is asked for.
    """
    words = _bare(words)
    if len(words) != 3 or words[0].text not in ("it", "they", "these", "those") or words[1].text != "need":
        return False
    done = words[2].raw
    return done.endswith("ing") and done not in GERUNDS


def keeps_doors_free(words: Sequence[Word]) -> bool:
    """Whether words forbid to stand in the way of doors, where nothing is ever put: ``it must not block the door``."""
    texts = [word.text for word in _bare(words)]
    way = any(texts[k : k + 3] == ["in", "the", "way"] for k in range(len(texts)))
    blocking = any(text in ("block", "obstruct") for text in texts)
    subject = texts[:1] and texts[0] in ("it", "they", "that", "do", "not", "nothing", "none")
    denied = "not" in texts or texts[:1] == ["nothing"]
    return bool(subject) and denied and (way or blocking) and bool({*texts} & {"door", "doorway", "entrance", "exit"})


def tells_whose(words: Sequence[Word]) -> bool:
    """Whether words only say whose something is: ``it's Ann's``, ``the umbrella is mine``, ``they are the guests'``."""
    words = _bare(words)
    if len(words) < 2 or words[0].text not in _THOSE | {"the", "they", "one"}:
        return False
    owner = words[-1]
    being = words[0].raw.endswith(("'s", "'re")) or any(word.raw in ("is", "are") for word in words[1:-1])
    plain = all(word.kind == "word" and word.text not in PREPOSITIONS | {"not"} for word in words)
    return being and plain and len(words) <= 6 and (owner.genitive or owner.raw in _OWN)


def lacks_a_place(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether words say that something cannot be done somewhere: ``there is nowhere to sit in there``."""
    texts = [word.text for word in _bare(words)]
    verb = next((k for k in (1, 2) if texts[k : k + 1] and texts[k] in ("nowhere", "no")), 0)
    end = verb + 1 + (texts[verb : verb + 1] == ["no"])
    lacking = texts[verb:end] == ["nowhere"] or texts[verb + 1 : end] in (["place"], ["space"], ["room"])
    told = texts[:1] == ["there"] and verb > 0 and lacking and texts[end : end + 1] == ["to"]
    plain = all(word.kind == "word" for word in _bare(words)) and not {*texts} & {"and", "but", "not", "so"}
    thing = any(lexicon.is_object((text,)) and not lexicon.is_own_room((text,)) for text in texts[end + 2 :])
    return told and plain and len(texts) > end + 1 and not thing


def gives_up_room(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether words say that a room is needed no longer: ``the box room can go``, ``we no longer need the study``."""
    words = _bare(words)
    texts = [word.text for word in words]
    going = texts[-2:] in (["can", "go"], ["may", "go"], ["must", "go"], ["has", "go"])
    needed = {"longer", "anymore"} & {*texts} and {"need", "needed", "use", "used"} & {*texts, *(w.raw for w in words)}
    plain = all(word.kind in ("word", "number", "ordinal") for word in words) and not {*texts} & {"and", "but", "if"}
    rooms = [k for k in range(len(texts)) for n in (1, 2, 3) if lexicon.is_own_room(tuple(texts[k : k + n]))]
    return plain and bool(rooms) and (going or bool(needed))


def is_rhetorical(words: Sequence[Word]) -> bool:
    """Whether a question wants no answer: ``What is a cash register doing in a library?``."""
    texts = [word.text for word in words]
    return texts[:1] in (["what"], ["why"]) and texts[1:2] in (["is"], ["are"]) and "doing" in [w.raw for w in words]


def is_purpose(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether ``so that ...`` says what people or a thing can then do, and no number, state or thing that shall be."""
    texts = [word.text for word in words]
    if texts[:2] != ["so", "that"] or len(words) < 4 or "," in texts:
        return False
    rest = words[2:]
    able = next((k for k, word in enumerate(rest) if word.text in ("can", "could")), 0)
    said = [word for at, word in enumerate(rest) if at != able]  # a can is a thing too
    named = any(lexicon.is_object((w.text,)) and not lexicon.is_own_room((w.text,)) for w in said)
    people = rest[0].text in PERSONS | RELATIVES | {"it", "they", "you"} or (
        1 < able <= 7 and rest[0].text in ("the", "our", "my", "a", "every", "nobody") and not named
    )
    states = STATE_WORDS.keys() - ({"on"} if able and rest[able - 1].text != "be" else set())
    if any(w.kind in ("number", "ordinal") or w.text in states or w.text in COLOUR_WORDS for w in rest):
        return False
    texts = texts[:-1] if able and texts[-1] in ("there", "here") else texts
    return people and not ({*texts} & {"there", "only", "no", "not", "just", "all", "each", "every"})


def notes_deed(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether a note says what is to be done: ``wardrobe added opposite``, ``what was there before can go``."""
    words = _bare(words)
    texts = [word.text for word in words]
    if texts[:1] in (["what"], ["whatever"]) and {*texts} & {"go", "out", "away", "leave"}:
        return True
    bare = (
        len(words) > 1 and words[0].kind == "word" and words[0].text not in DETERMINERS and _names(words[:1], lexicon)
    )
    return bare and any((word.raw,) in PARTICIPLES or word.raw in ("pushed", "pulled") for word in words[1:3])
