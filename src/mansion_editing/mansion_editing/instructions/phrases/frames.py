"""Frames around a request, taken off it: clefts, suggestions, polite questions, what would be better elsewhere.

``It is the desk that needs a lamp`` asks for what ``the desk needs a lamp`` does, ``How about a rug?`` for what
``I would like a rug`` does, ``The vase would look better on the shelf`` for what ``The vase should be on the shelf``
does.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.phrases.verb_words import BY_WORDS, GERUNDS
from mansion_editing.instructions.phrases.words import (
    BE,
    DETERMINERS,
    MODALS,
    NEED,
    Word,
    next_mark,
    text_at,
    with_leading_marks,
)

__all__ = ["without_frames"]

_SPEAKERS: Final = frozenset("i we".split())
_CONTRACTED: Final = frozenset(["i'd", "we'd"])
_WISHED: Final = frozenset("want need like love prefer wish require miss missing lack lacking".split())
_PREDICATES: Final = MODALS | NEED | frozenset("has have should get go belong".split())
"""Verbs of a cleft's relative clause that ask for something."""
_FEASIBLE: Final = frozenset("ok okay possible alright fine feasible".split())
_BETTER: Final = frozenset("better nicer best good great nice well".split())
_SEEMING: Final = frozenset("look be feel fit go do suit sit stand".split())
_MUCH: Final = frozenset("much far even so a lot way really probably".split())
_PLACES: Final = frozenset(
    "on in under next beside by near behind at against above between opposite inside upstairs downstairs".split()
)
_COUNTED: Final = frozenset("a an another some two three four five six".split())
_ASKING: Final = frozenset("i we put place add please there hang stand set lay".split())
"""Words that a request after ``instead of the table`` begins with."""
_TURNING: Final = frozenset("move turn shift push pull place put rotate arrange position swivel set".split())
_BRINGING: Final = frozenset("add put place set stand install".split())
_ANYBODY: Final = frozenset("nobody i we you people everybody everyone".split())
_SELDOM: Final = frozenset("really never ever do does did not no longer".split())
_LONGER: Final = frozenset("any anymore more much at all longer".split())
_OPINIONS: Final = frozenset(
    "like likes love loves hate hates use uses used need needs want wants wanted needed liked dislike".split()
)
_LONGEST: Final = 14
"""Words before the verb of a cleft or a suggestion."""


def without_frames(words: Sequence[Word]) -> list[Word]:
    """Return words with the clauses of sentences as plain requests; what is put anew keeps the place of the frame."""
    out: list[Word] = []
    for sentence in with_leading_marks(words):
        for unframed in _FRAMES:
            sentence = unframed(sentence)
        out += sentence
    return out


def _said(words: Sequence[Word], at: int, count: int) -> tuple[str, ...]:
    return tuple(text_at(words, at + k) for k in range(count))


def _starts(words: Sequence[Word]) -> list[int]:
    """Return where clauses of a sentence may begin."""
    return [at for at, word in enumerate(words) if word.kind != "mark" and (not at or words[at - 1].kind == "mark")]


def _over(phrase: Sequence[Word], words: Sequence[Word]) -> list[Word]:
    """Return words that were put in another order, which all stand where the phrase does, so that it is quoted."""
    start, end = phrase[0].start, phrase[-1].end
    return [replace(word, start=start, end=end) for word in words]


def _new(texts: Sequence[str], like: Word) -> list[Word]:
    """Return words of the frame's plain equivalent, which stand where a word of the frame stood."""
    return [replace(like, text=text, raw=text, kind="word", plural=False, genitive=False) for text in texts]


def _without_cleft(words: list[Word]) -> list[Word]:
    """Return ``the desk needs a lamp`` for ``it is the desk that needs a lamp``."""
    for at in _starts(words):
        contracted = words[at].raw in ("it's", "its") and text_at(words, at) == "it"
        begin = at + 1 + (text_at(words, at + 1) == "is")
        if (
            text_at(words, at) != "it"
            or not (contracted or begin == at + 2)
            or text_at(words, begin) not in DETERMINERS
        ):
            continue
        stop = min(next_mark(words, begin), begin + _LONGEST)
        joint = next((k for k in range(begin + 2, stop) if words[k].text in ("that", "which")), 0)
        if joint and text_at(words, joint + 1) in _PREDICATES:
            return [*words[:at], *words[begin:joint], *words[joint + 1 :]]
    return words


def _without_pseudo_cleft(words: list[Word]) -> list[Word]:
    """Return ``I want a chair`` for ``all I want is a chair``, ``the hall needs a bench`` likewise."""
    for at in _starts(words):
        length = (
            3
            if _said(words, at, 3) == ("the", "only", "thing")
            else 2
            if _said(words, at, 2) == ("the", "thing")
            else 1
        )
        if length == 1 and text_at(words, at) not in ("all", "what"):
            continue
        begin = at + length + (text_at(words, at + length) == "that")
        stop = min(next_mark(words, begin), begin + _LONGEST)
        copula = next((k for k in range(begin + 2, stop - 1) if words[k].raw in ("is", "are", "would")), 0)
        wishing = copula and words[copula - 1].text in _WISHED
        subject = (
            text_at(words, begin) in _SPEAKERS
            or text_at(words, begin) in DETERMINERS
            or words[begin].raw in _CONTRACTED
        )
        if wishing and subject and words[copula].raw != "would":
            return [*words[:at], *words[begin:copula], *words[copula + 1 :]]
    return words


def _without_missing(words: list[Word]) -> list[Word]:
    """Return ``there should be a rug in the hall`` for ``what is missing in the hall is a rug``."""
    for at in _starts(words):
        missing = at + 2 + (text_at(words, at + 2) == "still")
        stop = next_mark(words, at)
        if text_at(words, at) != "what" or text_at(words, missing - 1) not in ("is", "still"):
            contracted = words[at].raw in ("what's",)
            missing = at + 1 + (text_at(words, at + 1) == "still")
            if not contracted:
                continue
        if text_at(words, missing) not in ("missing", "lacking", "miss", "lack"):
            continue
        copula = next((k for k in range(missing + 1, stop - 1) if words[k].raw in ("is", "are")), 0)
        if copula and text_at(words, copula + 1) in _COUNTED:
            where = words[missing + 1 : copula]
            there = _new(("there", "should", "be"), words[at])
            moved = [*there, *words[copula + 1 : stop], *where]
            return [*words[:at], *_over(words[at:stop], moved), *words[stop:]]
    return words


def _without_only_thing(words: list[Word]) -> list[Word]:
    """Return ``the only thing on the desk should be a lamp`` for the like of ``a lamp is all that should be on it``."""
    for at in _starts(words):
        stop = next_mark(words, at)
        said = [word.text for word in words[at:stop]]
        if said[:4] == ["the", "only", "thing", "that"] and said[4:5] and said[4] in MODALS:
            copula = next((k for k in range(at + 6, stop - 1) if words[k].raw == "is"), 0)
            if copula and said[5] in ("be", "stay", "remain", "lie", "stand"):
                should = _new((said[4], "be"), words[copula])
                return [*words[: at + 3], *words[at + 6 : copula], *should, *words[copula + 1 :]]
        all_that = next((k for k in range(at + 1, stop - 3) if _said(words, k, 2) == ("is", "all")), 0)
        modal = all_that + 2 + (text_at(words, all_that + 2) == "that")
        if all_that and text_at(words, modal) in MODALS and text_at(words, modal + 1) in BE | {"lie", "stand"}:
            only = _new(("the", "only", "thing"), words[at])
            should = _new((text_at(words, modal), "be"), words[modal])
            moved = [*only, *words[modal + 2 : stop], *should, *words[at:all_that]]
            return [*words[:at], *_over(words[at:stop], moved), *words[stop:]]
    return words


def _without_suggestion(words: list[Word]) -> list[Word]:
    """Return ``move the desk`` for ``how about moving the desk``, ``I would like a rug`` for ``what about a rug``."""
    for at in _starts(words):
        pair = _said(words, at, 2)
        if pair in (("how", "about"), ("what", "about")):
            if text_at(words, at + 2) in GERUNDS or (at + 2 < len(words) and words[at + 2].raw in GERUNDS):
                return [*words[:at], *words[at + 2 :]]
            if text_at(words, at + 2) in _COUNTED:
                return [*words[:at], *_new(("i", "would", "like"), words[at]), *words[at + 2 :]]
        length = _length_of_plea(words, at)
        if length and (text_at(words, at + length),) in BY_WORDS:
            return [*words[:at], *_new(("please",), words[at]), *words[at + length :]]
    return words


def _length_of_plea(words: Sequence[Word], at: int) -> int:
    """Return how many words ``would it be ok to``, ``why don't we``, ``I was wondering if you could`` are; else 0."""
    said = [word.text for word in words[at : at + 8]]
    if said[:1] and said[0] in ("would", "might", "could", "will") and said[1:3] == ["it", "be"]:
        return 5 if said[3:4] and said[3] in _FEASIBLE and said[4:5] == ["to"] else 0
    if said[:1] == ["why"]:
        length = 2 if said[1:2] == ["not"] else 0
        if (words[at + 1 : at + 2] and words[at + 1].raw in ("don't", "dont")) or said[1:3] == ["do", "not"]:
            length = 2 + (said[1] == "do")
        return length + (said[length : length + 1] in (["we"], ["you"]) if length else 0)
    wondering = next(
        (k for k in (1, 2) if words[at + k : at + k + 1] and words[at + k].raw in ("wonder", "wondering")), 0
    )
    asked = said[wondering + 1 : wondering + 4]
    if said[:1] == ["i"] and wondering and asked[:1] in (["if"], ["whether"]) and asked[1:2] in (["you"], ["we"]):
        return wondering + 4 if asked[2:3] and asked[2] in MODALS else 0
    chance = next((k for k in range(3) if said[k : k + 2] == ["any", "chance"]), -1)
    if (
        chance >= 0
        and said[chance + 2 : chance + 3] == ["you"]
        and said[chance + 3 : chance + 4] in (["can"], ["could"])
    ):
        return chance + 4
    return 0


def _without_preference(words: list[Word]) -> list[Word]:
    """Return ``the vase should be on the shelf`` for ``the vase would look better on the shelf``."""
    for at in _starts(words):
        stop = next_mark(words, at)
        better = next((k for k in range(at + 2, stop - 1) if words[k].text in _BETTER), 0)
        if not better:
            continue
        after = better + 1 + (text_at(words, better + 1) == "off")
        verb = better - 1
        while verb > at and words[verb].text in _MUCH:
            verb -= 1
        seems = words[verb].text in _SEEMING | BE or words[verb].raw in ("looks", "fits")
        comparing = words[better].text in ("better", "nicer", "best")
        would = text_at(words, verb - 1) in ("would", "will", "might")
        joint = verb - would
        definite = text_at(words, at) in ("the", "that", "this", "my", "our") or text_at(words, at) == "i"
        if seems and (would or comparing) and text_at(words, after) in _PLACES and definite and joint > at:
            should = _new(("should", "be"), words[joint])
            return [*words[:joint], *should, *words[after:]]
    return words


def _without_double_negation(words: list[Word]) -> list[Word]:
    """Return ``every bedroom should have a lamp`` for ``no bedroom should be without a lamp``."""
    for at in _starts(words):
        without = next((k for k in range(at + 3, next_mark(words, at)) if words[k].text == "without"), 0)
        modal = without - 2 + (text_at(words, without - 1) in MODALS)
        if text_at(words, at) != "no" or not without or text_at(words, modal) not in MODALS:
            continue
        if text_at(words, without - 1) in ("be", "stay", "remain", "go"):
            have = _new(("have",), words[without])
            return [*words[:at], *_new(("every",), words[at]), *words[at + 1 : modal + 1], *have, *words[without + 1 :]]
    return words


def _without_contrast(words: list[Word]) -> list[Word]:
    """Return ``turn on the lamp in the hall`` for ``turn on the lamp, not the candle, in the hall``."""
    for at in range(2, len(words) - 3):
        contrast = words[at].text == "," and words[at + 1].text == "not" and words[at + 2].text in ("the", "my", "our")
        end = next_mark(words, at + 1)
        if contrast and text_at(words, end) == "," and text_at(words, end + 1) in _PLACES | {"from", "to", "into"}:
            return [*words[:at], *words[end + 1 :]]
    return words


def _replaced_last(words: list[Word]) -> list[Word]:
    """Return ``I want a stool instead of the table`` for ``instead of the table I want a stool``."""
    for at in _starts(words):
        length = 2 if _said(words, at, 2) == ("instead", "of") else 3 * (_said(words, at, 3) == ("in", "place", "of"))
        if not length or text_at(words, at + length) not in DETERMINERS:
            continue
        stop = next_mark(words, at)
        asks = (k for k in range(at + length + 2, stop) if words[k].text in _ASKING or words[k].raw in _CONTRACTED)
        begin = next(asks, stop + 1 if text_at(words, stop) == "," else 0)
        end = next_mark(words, begin) if begin else 0
        if not begin or end <= begin:
            continue
        old = words[at + length : begin - (text_at(words, begin - 1) == ",")]
        instead = _new(("instead", "of"), words[end - 1])
        return [*words[:at], *_over(words[at:end], [*words[begin:end], *instead, *old]), *words[end:]]
    return words


def _without_loss(words: list[Word]) -> list[Word]:
    """Return ``I want a rug`` for ``I'm missing a rug``."""
    for at in _starts(words):
        verb = at + 1 + (text_at(words, at + 1) in BE)
        missing = words[at].raw in ("i'm", "we're", "im") or verb == at + 2
        said = words[verb].raw if text_at(words, at) in _SPEAKERS and missing and verb < len(words) else ""
        if said == "missing" and text_at(words, verb + 1) in _COUNTED:
            return [*words[: at + 1], *_new(("want",), words[verb]), *words[verb + 1 :]]
    return words


def _without_opinion(words: list[Word]) -> list[Word]:
    """Leave out what somebody thinks of one thing: ``the rug that nobody likes``, ``the mug I hate``."""
    for at in range(2, len(words)):
        begin = at + (words[at].text in ("that", "which", "who"))
        if text_at(words, begin) not in _ANYBODY or words[at - 1].plural or words[at - 1].kind != "word" or begin == at:
            continue
        verb = begin + 1
        while text_at(words, verb) in _SELDOM:
            verb += 1
        after = verb + 1
        while text_at(words, after) in _LONGER:
            after += 1
        said = words[verb].raw if verb < len(words) else ""
        ends = after >= len(words) or words[after].kind == "mark" or words[after].text in _PLACES | {"and", "from"}
        if said in _OPINIONS and ends and words[at - 1].text not in ("one", "it", "all", "every"):
            return [*words[:at], *words[after:]]
    return words


def _resulting(words: list[Word]) -> list[Word]:
    """Return ``the sofa should face the TV`` for ``move the sofa so that it faces the TV``."""
    for at in _starts(words):
        verb = at + (text_at(words, at) == "please")
        stop = next_mark(words, verb)
        so = next((k for k in range(verb + 2, stop - 2) if words[k].text == "so"), 0)
        it = so + 1 + (text_at(words, so + 1) == "that")
        if text_at(words, verb) not in _TURNING or not so or text_at(words, it) not in ("it", "they"):
            continue
        named = words[verb + 1 : so]
        plain = named[0].text in DETERMINERS and not any(w.text in _PLACES | {"to", "from", "into"} for w in named)
        contracted = words[it].raw in ("it's", "they're")
        said = words[it + (not contracted)]
        if plain and said.raw in ("faces", "face", "looks", "look"):
            return [*words[:at], *named, *_new(("should",), words[so]), *words[it + 1 :]]
        if plain and (contracted or said.raw in ("is", "are", "stands", "stand")):
            should = _new(("should", "be"), words[so])
            return [*words[:at], *named, *should, *words[it + 2 - contracted :]]
    return words


def _each_last(words: list[Word]) -> list[Word]:
    """Return ``add a table next to each of the armchairs`` for ``for each of the armchairs add a table next to it``."""
    for at in _starts(words):
        each = text_at(words, at + 1) in ("each", "every")
        stop = next_mark(words, at)
        verb = next((k for k in range(at + 3, stop) if (words[k].text,) in BY_WORDS and words[k].text in _BRINGING), 0)
        it = next((k for k in range(verb + 2, stop) if words[k].text == "it"), 0)
        if text_at(words, at) != "for" or not each or not verb or it != stop - 1:
            continue
        end = verb - (text_at(words, verb - 1) == "please")
        moved = [*words[verb:it], *words[at + 1 : end]]
        return [*words[:at], *_over(words[at:stop], moved), *words[stop:]]
    return words


def _as_heading(words: list[Word]) -> list[Word]:
    """Return ``the kitchen: two mugs`` for ``the kitchen needs the following: two mugs``."""
    for at in _starts(words):
        colon = next_mark(words, at)
        said = [word.text for word in words[at:colon]]
        needs = next((k for k in range(1, len(said)) if said[k] in ("need", "require", "get")), 0)
        if text_at(words, colon) == ":" and needs and said[needs + 1 :] in (["the", "following"], ["this"], ["these"]):
            return [*words[: at + needs], *words[colon:]]
    return words


_FRAMES: Final[tuple[Callable[[list[Word]], list[Word]], ...]] = (
    _without_opinion,
    _without_cleft,
    _without_double_negation,
    _without_contrast,
    _replaced_last,
    _without_loss,
    _each_last,
    _as_heading,
    _resulting,
    _without_missing,
    _without_only_thing,
    _without_pseudo_cleft,
    _without_suggestion,
    _without_preference,
)
