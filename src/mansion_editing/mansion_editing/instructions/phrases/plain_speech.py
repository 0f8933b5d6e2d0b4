"""Everyday wordings, put as plain requests: ``a kettle would be handy``, ``one mug per desk``, ``with its chair``."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.phrases.implied_requests import WANTS
from mansion_editing.instructions.phrases.rewritten_words import (
    COUNTED,
    PLACING,
    SPEAKERS,
    ends_at,
    like,
    over,
    said_at,
    sentence_start,
)
from mansion_editing.instructions.phrases.verb_words import BY_WORDS
from mansion_editing.instructions.phrases.words import (
    DETERMINERS,
    PREPOSITIONS,
    SENTENCE_ENDS,
    Word,
    next_mark,
    text_at,
    with_leading_marks,
)

__all__ = ["in_plain_words"]

_WELCOME: Final = frozenset(
    "handy useful helpful welcome practical convenient appreciated fantastic terrific brilliant super ideal sensible "
    "great perfect good fine".split()
)
"""What one says of something that one would like to have; ``nice`` and the like are adjectives of the thing too."""
_NO_PLACES: Final = frozenset("person head cent week day hour month night".split())
"""Words after ``per`` that are no places."""
_TAKING: Final = frozenset(
    "move take carry bring remove shift get relocate transfer push haul drag put leave go".split()
)
_OWN: Final = frozenset("its their".split())
_ALONG: Final = (("with", "it"), ("with", "them"), ("along", "with", "it"), ("along", "with", "them"))
_CERTAIN: Final = frozenset("the all both each every this that these those my our its their it them".split())
"""Words before things that are there, which may have others of their own."""
_GIVEN_AWAY: Final = (
    ("charity",), ("the", "tip"), ("the", "dump"), ("the", "skip"), ("the", "landfill"), ("the", "scrapyard"),
    ("the", "thrift", "shop"), ("the", "charity", "shop"), ("the", "flea", "market"), ("the", "recycling"),
)  # fmt: skip
"""Where things go that leave the building."""
_STANDING: Final = frozenset("stand hang sit lie go live".split())
_STAYING: Final = (("that",), ("which",), ("that", "will"), ("which", "will"))
_BELONGING: Final = frozenset("belong belongs go goes come comes".split())
_SPOTS: Final = frozenset("by near next beside at against behind under opposite between".split())
_FETCHING: Final = frozenset("take get bring fetch use borrow".split())
_WANTING: Final = frozenset("need want require".split())
_LONGEST: Final = 14


def in_plain_words(words: Sequence[Word]) -> list[Word]:
    """Return words with everyday wordings put plainly; what is put anew keeps the place of what it stands for."""
    out: list[Word] = []
    spared = False
    for sentence in with_leading_marks(_enough_there(_moved_from_elsewhere(list(words)))):
        if spared:
            sentence = _that_one(sentence)
        spared = _all_but_one(sentence) != sentence
        for plain in (*_READINGS, *WANTS):
            sentence = plain(sentence)
        out += sentence
    return out


def _that_one(words: list[Word]) -> list[Word]:
    """Return ``the other one should be on`` for ``that one should be on`` after ``every lamp except one``."""
    start = sentence_start(words)
    if said_at(words, start, ("that", "one")) != 2:
        return words
    return [*words[:start], *like(("the", "other"), words[start]), *words[start + 1 :]]


def _starts(words: Sequence[Word]) -> list[int]:
    """Return where clauses of a sentence may begin."""
    return [at for at, word in enumerate(words) if word.kind != "mark" and (not at or words[at - 1].kind == "mark")]


def _without_thanks(words: list[Word]) -> list[Word]:
    """Return ``a kettle next to the sink`` for ``a kettle next to the sink would be handy``."""
    for start in _starts(words):
        first = words[start]
        end = next_mark(words, start)
        would = next((k for k in range(start + 2, end - 2) if words[k].text == "would"), 0)
        pleased = would + 2 + (text_at(words, would + 2) in ("really", "very", "quite", "so"))
        counted = first.text in COUNTED or first.kind == "number"
        if counted and would and text_at(words, would + 1) == "be" and text_at(words, pleased) in _WELCOME:
            after = pleased + 1 + said_at(words, pleased + 1, ("there",), ("too",), ("here",))
            if ends_at(words, after):
                there = words[pleased + 1 : pleased + 2] if text_at(words, pleased + 1) == "there" else []
                last = replace(words[would - 1], end=words[pleased].end)
                return [*words[: would - 1], last, *there, *words[after:]]
    return words


def _for_each(words: list[Word]) -> list[Word]:
    """Return ``one mug for each desk`` for ``one mug per desk``."""
    at = next((k for k in range(1, len(words) - 1) if words[k].text == "per"), 0)
    following = words[at + 1] if at else None
    if following is None or following.kind != "word" or following.text in _NO_PLACES | DETERMINERS:
        return words
    return [*words[:at], *like(("for", "each"), words[at]), *words[at + 1 :]]


def _taken_along(words: list[Word]) -> list[Word]:
    """Return ``move the desk and its chair`` for ``move the desk with its chair``, ``with all of its chairs``."""
    start = sentence_start(words)
    asks = text_at(words, start) in _CERTAIN and any(word.text in _TAKING for word in words)
    for at in range(start, len(words)):
        verb = words[at].text in _TAKING and at + 1 < len(words)
        asks = asks or (verb and (words[at + 1].text in _CERTAIN or words[at + 1].kind == "number"))
    for at in range(start + 2, len(words) - 1 if asks else 0):
        own = at + 1
        own += said_at(words, own, ("all", "of"), ("all",), ("both", "of"), ("both",))
        new = text_at(words, at - 1) in ("each", "one") or text_at(words, own + 1) == "own"  # "each with its own chair"
        if words[at].text != "with" or text_at(words, own) not in _OWN or new:
            continue
        begin = at - (text_at(words, at - 1) == "together")
        begin -= text_at(words, begin - 1) == ","
        return [*words[:begin], *like(("and",), words[at]), *words[own:]]
    return words


def _coming_along(words: list[Word]) -> list[Word]:
    """Return ``put its chair beside it`` for ``its chair should go with it``."""
    start = sentence_start(words)
    go = next((k for k in range(start + 2, len(words)) if words[k].text in ("go", "come")), 0)
    subject = words[start : go - (text_at(words, go - 1) in ("should", "must", "can", "shall", "will"))]
    plain = 1 < len(subject) <= 4 and all(word.kind == "word" and word.text not in PREPOSITIONS for word in subject)
    length = said_at(words, go + 1, *_ALONG) if go and plain and text_at(words, start) in _OWN else 0
    if not length or not ends_at(words, go + 1 + length):
        return words
    pronoun = "it" if words[start].text == "its" else "them"
    put = [*like(("put",), words[start]), *subject, *like(("beside", pronoun), words[go])]
    return [*words[:start], *over(words[start : go + 1 + length], put), *words[go + 1 + length :]]


def _leaving_for_good(words: list[Word]) -> list[Word]:
    """Return ``the others can go`` for ``the others can go to charity``."""
    for at in range(2, len(words)):
        to = text_at(words, at) == "to" and text_at(words, at - 1) in ("go", "going")
        length = said_at(words, at + 1, *_GIVEN_AWAY) if to else 0
        if length and ends_at(words, at + 1 + length):
            return [*words[: at - 1], replace(words[at - 1], end=words[at + length].end), *words[at + 1 + length :]]
    return words


def _kept_of(words: list[Word]) -> list[Word]:
    """Return ``remove all but two of the six chairs`` for ``keep two of the six chairs, the other four can go``."""
    start = sentence_start(words)
    of = start + 2
    numbers = [words[k].kind for k in (start + 1, start + 4) if k < len(words)] == ["number", "number"]
    if text_at(words, start) != "keep" or not numbers or said_at(words, of, ("of", "the")) != 2:
        return words
    end = next_mark(words, start)
    if end - start > _LONGEST or any(word.text in ("and", "but", "in", "on") for word in words[end:]):
        return words
    rest = [word.text for word in words[end + 1 :] if word.kind in ("word", "number")]
    others = rest[:2] == ["the", "other"] or rest[:2] == ["the", "rest"] or rest[:2] == ["the", "others"]
    left = words[start + 4].value - words[start + 1].value
    told = [word.value for word in words[end + 1 :] if word.kind == "number"]
    if rest and not (others and rest[-1] == "go" and told in ([], [left])):
        return words
    removed = [*like(("remove", "all", "but"), words[start]), *words[start + 1 : end]]
    last = next((k for k in range(end + 1, len(words)) if words[k].text == "go"), end - 1)
    return [*words[:start], *over(words[start : last + 1], removed), *words[last + 1 :]]


def _in_its_place_last(words: list[Word]) -> list[Word]:
    """Return ``I want a lamp in its place`` for ``in its place I want a lamp``.

    Of several things, and before a further place, that is ``there``.
    """
    start = sentence_start(words)
    if said_at(words, start, ("in", "its", "place"), ("in", "their", "place")) != 3:
        return words
    begin = start + 3 + (text_at(words, start + 3) == ",")
    end = next_mark(words, begin)
    asks = text_at(words, begin) in SPEAKERS | {"put", "place", "please", "set", "add", "hang", "there"}
    if not asks or end - begin < 3:
        return words
    several = any(word.text == "and" for word in words[begin:end])
    further = several or (text_at(words, end) == "," and text_at(words, end + 1) in PREPOSITIONS - {"but", "with"})
    where = like(("there",), words[start]) if further else words[start : start + 3]
    return [*words[:start], *over(words[start:end], [*words[begin:end], *where]), *words[end:]]


def _place_last(words: list[Word]) -> list[Word]:
    """Return ``and a cup next to the laptop`` for ``and, next to the laptop, a cup``."""
    for at in range(2, len(words) - 4):
        pair = words[at].text == "and" and words[at + 1].text == ","
        place = at + 2
        if not pair or text_at(words, place) not in PREPOSITIONS - {"and", "but", "with", "for", "of"}:
            continue
        comma = next_mark(words, place)
        end = next_mark(words, comma + 1)
        things = words[comma + 1 : end]
        counted = bool(things) and (things[0].text in COUNTED or things[0].kind == "number")
        plain = all(word.text not in PREPOSITIONS for word in things)
        if text_at(words, comma) == "," and counted and plain:
            return [*words[: at + 1], *over(words[at + 1 : end], [*things, *words[place:comma]]), *words[end:]]
    return words


def _staying_behind(words: list[Word]) -> list[Word]:
    """Return ``move the lamp out of the hall, and a rug on the shelf in the hall`` for ``... that stays behind``."""
    for at in range(6, len(words) - 2):
        length = said_at(words, at, *_STAYING)
        stays = length and text_at(words, at + length) in ("stay", "remain") and words[at - 1].kind == "word"
        after = at + length + 2
        if (
            not stays
            or text_at(words, after - 1) != "behind"
            or not (ends_at(words, after) or words[after].text == "and")
        ):
            continue
        source = next((k + 1 for k in range(at - 3) if words[k].text in ("from", "of") and _is_source(words, k)), 0)
        end = next((k for k in range(source + 1, at) if words[k].text in PREPOSITIONS or ends_at(words, k)), at)
        if source and end < at:
            where = over(words[at:after], [*like(("in",), words[at]), *words[source:end]])
            return [*words[:at], *where, *words[after:]]
    return words


def _is_source(words: Sequence[Word], at: int) -> bool:
    """Whether ``from the hall`` or ``out of the hall`` begins at its last preposition."""
    out = words[at].text == "from" or text_at(words, at - 1) == "out"
    return out and text_at(words, at + 1) in DETERMINERS


def _brought_there(words: list[Word]) -> list[Word]:
    """Return ``on the counter put a tray`` for ``on the counter belong a tray and a mug``, ``on it goes a vase``."""
    start = sentence_start(words)
    stop = next_mark(words, start)
    verb = next((k for k in range(start + 2, stop - 1) if words[k].text in _BELONGING), 0)
    begins = text_at(words, start) in ("on", "in", "under", "beside", "above", "behind") or said_at(
        words, start, ("next", "to"), ("in", "front", "of")
    )
    counted = verb and (words[verb + 1].text in ("a", "an") or words[verb + 1].kind == "number")
    belongs = verb and words[verb].text.startswith("belong")
    begins = begins and (belongs or any(word.text in DETERMINERS | {"it"} for word in words[start:verb]))
    if not (begins and counted) or any((word.text,) in BY_WORDS for word in words[start:verb]):
        return words
    return [*words[:verb], *like(("put",), words[verb]), *words[verb + 1 :]]


def _laid(words: list[Word]) -> list[Word]:
    """Return ``on each table lay two books`` for ``on each table lay out two books``."""
    for at in range(2, len(words) - 2):
        counted = words[at + 2].kind == "number" or words[at + 2].text in COUNTED
        if words[at].text == "lay" and words[at + 1].text == "out" and counted:
            return [*words[:at], replace(words[at], end=words[at + 1].end), *words[at + 2 :]]
    return words


def _slid(words: list[Word]) -> list[Word]:
    """Return ``put a box under the table`` for ``slide a box under the table``, which tells of no box that is there."""
    for at in range(len(words) - 3):
        begins = not at or words[at - 1].kind == "mark" or words[at - 1].text in ("and", "please", "then")
        if begins and words[at].text == "slide" and words[at + 1].text in ("a", "an"):
            return [*words[:at], *like(("put",), words[at]), *words[at + 1 :]]
    return words


def _taken_out_and_furnished(words: list[Word]) -> list[Word]:
    """Return ``remove A from B and furnish B with C`` for ``take A out of B and furnish it with C``."""
    start = sentence_start(words)
    out = next((k for k in range(start + 2, len(words) - 5) if said_at(words, k, ("out", "of"))), 0)
    joint = next((k for k in range(out + 3, len(words) - 3) if words[k].text == "and"), 0) if out else 0
    room = words[out + 2 : joint]
    plain = bool(room) and room[0].text in DETERMINERS and all(word.kind == "word" for word in room)
    furnished = text_at(words, joint + 1) in ("furnish", "equip", "fill") and text_at(words, joint + 2) == "it"
    if text_at(words, start) != "take" or not (joint and plain and furnished):
        return words
    taken = [*like(("remove",), words[start]), *words[start + 1 : out], *like(("from",), words[out])]
    again = over(words[joint + 2 : joint + 3], room)
    return [*words[:start], *taken, *words[out + 2 : joint + 2], *again, *words[joint + 3 :]]


def _instead_in(words: list[Word]) -> list[Word]:
    """Return ``it should stand in the hall by the window`` for ``... in the hall instead, by the window``."""
    for at in range(4, len(words) - 2):
        spot = words[at].text == "instead" and words[at + 1].text == "," and words[at + 2].text in _SPOTS
        if spot and ends_at(words, next_mark(words, at + 2)) and text_at(words, at - 1) not in ("there", "place"):
            return [*words[: at - 1], replace(words[at - 1], end=words[at + 1].end), *words[at + 2 :]]
    return words


def _from_number_to_number(words: list[Word]) -> list[Word]:
    """Return ``exactly four shelves`` for ``shelves from six down to four``."""
    for at in range(1, len(words) - 3):
        if words[at].text not in ("from", "down") or not words[at - 1].plural:
            continue
        old = at + 1 + (text_at(words, at + 1) == "from")
        to = old + 1 + (text_at(words, old + 1) in ("down", "up"))
        numbers = [k for k in (old, to + 1) if k < len(words) and words[k].kind == "number"]
        if len(numbers) < 2 or text_at(words, to) != "to" or not ends_at(words, to + 2):
            continue
        first = at - 1
        while first > 0 and words[first - 1].kind == "word" and at - first < 3:
            first -= 1
        if any((word.text,) in BY_WORDS for word in words[first:at]):
            return words
        name = words[first + (words[first].text in DETERMINERS) : at]
        exactly = [*like(("there", "should", "be", "exactly"), words[first]), words[to + 1], *name]
        return [*words[:first], *over(words[first : to + 2], exactly), *words[to + 2 :]]
    return words


def _on_its_side(words: list[Word]) -> list[Word]:
    """Return ``a mug left of it`` for ``a mug to its left``, ``on its right``."""
    for at in range(1, len(words) - 2):
        side = words[at].text in ("to", "on") and words[at + 1].text in _OWN and words[at + 2].text in ("left", "right")
        if side and not (at + 3 < len(words) and words[at + 3].kind == "word" and words[at + 3].text != "and"):
            pronoun = "it" if words[at + 1].text == "its" else "them"
            new = over(words[at : at + 3], [words[at + 2], *like(("of", pronoun), words[at])])
            return [*words[:at], *new, *words[at + 3 :]]
    return words


def _could_stand(words: list[Word]) -> list[Word]:
    """Return ``the shelf should stand next to the desk`` for ``could the shelf stand next to the desk?``."""
    start = sentence_start(words)
    definite = text_at(words, start) == "could" and text_at(words, start + 1) in ("the", "my", "our")
    verb = next((k for k in range(start + 3, min(len(words), start + 6)) if words[k].text in _STANDING), 0)
    plain = all(word.kind == "word" and word.text not in PREPOSITIONS for word in words[start + 1 : verb])
    if not (definite and verb and plain) or text_at(words, verb + 1) not in PREPOSITIONS:
        return words
    should = like(("should",), words[start])
    end = len(words) - (words[-1].text == "?")
    return [*words[:start], *words[start + 1 : verb], *should, *words[verb:end]]


def _all_but_one(words: list[Word]) -> list[Word]:
    """Return ``all but one of the lamps in the hall`` for ``every lamp in the hall except one``."""
    for at in range(3, len(words)):
        length = said_at(words, at, ("except",), ("except", "for"), ("but",), ("apart", "from"))
        alone = length and text_at(words, at + length) == "one" and ends_at(words, at + length + 1)
        every = next((k for k in range(at - 2, -1, -1) if words[k].text in ("every", "each")), -1)
        clause = words[every:at]
        if not alone or every < 0 or any(word.kind == "mark" or word.text == "and" for word in clause):
            continue
        noun = next((k for k in range(every + 1, at) if words[k].text in PREPOSITIONS), at) - 1
        several = [replace(word, plural=k == noun) for k, word in enumerate(words[: at + length + 1])]
        one = [words[at + length], *like(("of", "the"), words[every])]
        begin = [*like(("all", "but"), words[every]), *one, *several[every + 1 : at]]
        return [*words[:every], *over(words[every : at + length + 1], begin), *words[at + length + 1 :]]
    return words


def _order_after_not(words: list[Word]) -> list[Word]:
    """Return ``don't remove the desk; clear it`` for ``don't remove the desk, only clear it``."""
    negated = any(word.text == "not" for word in words[: sentence_start(words) + 3])
    for at in range(3, len(words) - 2 if negated else 0):
        only = words[at].text == "," and words[at + 1].text in ("only", "just")
        if only and (words[at + 2].text,) in BY_WORDS:
            return [*words[:at], replace(words[at], text=";", raw=";"), *words[at + 2 :]]
    return words


def _only_of_them(words: list[Word]) -> list[Word]:
    """Return ``there should be exactly four kitchen chairs`` for ``kitchen chairs: only four of them``."""
    start = sentence_start(words)
    colon = next_mark(words, start)
    name = words[start:colon]
    number = colon + 2
    plain = 0 < len(name) <= 4 and name[-1].plural and all(word.kind == "word" for word in name)
    only = text_at(words, colon) == ":" and text_at(words, colon + 1) in ("only", "just", "exactly")
    if not (plain and only) or number >= len(words) or words[number].kind != "number":
        return words
    after = number + 1 + said_at(words, number + 1, ("of", "them"), ("of", "those"))
    after += text_at(words, after) == "please"
    if not ends_at(words, after):
        return words
    name = name[1:] if name[0].text in DETERMINERS else name
    exactly = [*like(("there", "should", "be", "exactly"), words[start]), words[number], *name]
    return [*words[:start], *over(words[start:after], exactly), *words[after:]]


def _no_longer_wanted(words: list[Word]) -> list[Word]:
    """Return ``bring all chairs in A to B`` for ``I don't want any chairs in A any more, bring them to B``."""
    start = sentence_start(words)
    begin = start + 3 + (text_at(words, start + 3) == "any")
    wanted = text_at(words, start) in SPEAKERS and "not" in [w.text for w in words[start + 1 : start + 3]]
    verb = next((k for k in range(start + 1, start + 4) if text_at(words, k) in ("want", "need")), 0)
    comma = next_mark(words, start)
    longer = next((k for k in range(begin, comma) if words[k].text in ("anymore", "longer") or _any_more(words, k)), 0)
    order = comma + 1 + (text_at(words, comma + 1) in ("and", "so", "please"))
    them = text_at(words, order) in _TAKING and text_at(words, order + 1) == "them"
    if not (wanted and verb and longer and them) or text_at(words, comma) not in (",", "-", ";"):
        return words
    begin = verb + 1 + (text_at(words, verb + 1) in ("any", "the"))
    things = words[begin : longer - (words[longer].text == "longer")]
    end = next_mark(words, order)
    whole = [words[order], *like(("all", "the"), words[order]), *things, *words[order + 2 : end]]
    return [*words[:start], *over(words[start:end], whole), *words[end:]]


def _any_more(words: Sequence[Word], at: int) -> bool:
    return said_at(words, at, ("any", "more"), ("any", "longer")) == 2


def _moved_from_elsewhere(words: list[Word]) -> list[Word]:
    """Return ``move two chairs from B to A`` for ``we need two more chairs in A; take them from B``."""
    stop = next((k for k, word in enumerate(words) if word.text in {*SENTENCE_ENDS, ",", "-"}), len(words))
    start = sentence_start(words)
    wanting = text_at(words, start) in SPEAKERS and text_at(words, start + 1) in _WANTING
    number = start + 2
    more = number + 1 < stop and words[number].kind == "number" and text_at(words, number + 1) == "more"
    place = next((k for k in range(number + 2, stop) if words[k].text in ("in", "for")), 0)
    order = stop + 1 + (text_at(words, stop + 1) in ("and", "please", "so"))
    fetched = text_at(words, order) in _FETCHING and text_at(words, order + 1) in ("them", "those")
    if not (wanting and more and place and fetched) or text_at(words, order + 2) not in ("from", "out"):
        return words
    end = next_mark(words, order)
    things = [words[number], *words[number + 2 : place]]
    moved = [*like(("move",), words[start]), *things, *words[order + 2 : end], *like(("to",), words[place])]
    return [*words[:start], *over(words[start:end], [*moved, *words[place + 1 : stop]]), *words[end:]]


def _only_so_many_remain(words: list[Word]) -> list[Word]:
    """Return ``there should be at most four chairs`` for ``of the six chairs only four should remain``.

    After another sentence, and without a place of their own, they are those in the room of that sentence.
    """
    start = sentence_start(words)
    begin = start + (text_at(words, start) == "and")
    only = next((k for k in range(begin + 3, len(words) - 3) if words[k].text in ("only", "just")), 0)
    things = words[begin + 2 : only]
    if said_at(words, begin, ("of", "the"), ("of", "our")) != 2 or len(things) < 2 or things[0].kind != "number":
        return words
    number, end = words[only + 1], next_mark(words, only)
    stays = [word.text for word in words[only + 2 : end]]
    fewer = number.kind == "number" and number.value < things[0].value and all(w.kind == "word" for w in things[1:])
    if not fewer or stays[:1] not in (["should"], ["must"], ["shall"]) or stays[1:] not in (["remain"], ["stay"]):
        return words
    placed = any(word.text in PREPOSITIONS for word in things)
    where = like(("in", "that", "room"), words[begin]) if start and not placed else []
    most = [*like(("there", "should", "be", "at", "most"), words[begin]), number, *things[1:], *where]
    return [*words[:begin], *over(words[begin:end], most), *words[end:]]


def _out_of_and_into(words: list[Word]) -> list[Word]:
    """Return ``move the rug from A into B`` for ``I want the rug out of A and into B``."""
    start = sentence_start(words)
    out = next((k for k in range(start + 2, len(words) - 5) if said_at(words, k, ("out", "of"))), 0)
    joint = next((k for k in range(out + 3, len(words) - 2) if words[k].text == "and"), 0) if out else 0
    wanted = text_at(words, start) in SPEAKERS and text_at(words, start + 1) in _WANTING
    certain = wanted and text_at(words, start + 2) in _CERTAIN
    source = words[out + 2 : joint]
    plain = joint and all(word.kind == "word" and word.text not in PREPOSITIONS for word in source)
    if not (certain and plain) or text_at(words, joint + 1) not in ("into", "in", "onto", "on", "to"):
        return words
    moved = [*like(("move",), words[start]), *words[start + 2 : out], *like(("from",), words[out])]
    return [*words[:start], *moved, *source, *words[joint + 1 :]]


def _put_in_its_place(words: list[Word]) -> list[Word]:
    """Return ``put two beds in its place`` for ``two beds please, in its place``."""
    start = sentence_start(words)
    at = next((k for k in range(start + 2, len(words)) if said_at(words, k, ("in", "its", "place"))), 0)
    last = at - (text_at(words, at - 1) == ",")
    last -= text_at(words, last - 1) == "please"
    things = words[start:last]
    counted = bool(things) and (things[0].text in COUNTED or things[0].kind == "number")
    plain = all(word.kind != "mark" and word.text not in PREPOSITIONS | DETERMINERS for word in things[1:])
    if not (at and counted and plain and len(things) <= 4) or any((word.text,) in BY_WORDS for word in things[:-1]):
        return words
    return [*words[:start], *over(words[start:last], [*like(("put",), words[start]), *things]), *words[at:]]


def _beside_in_its_place(words: list[Word]) -> list[Word]:
    """Return ``put a shelf along the wall instead`` for ``put a shelf along the wall in its place``."""
    for at in range(4, len(words) - 2):
        if not said_at(words, at, ("in", "its", "place"), ("in", "their", "place")) or not ends_at(words, at + 3):
            continue
        put = next((k for k in range(at - 1, -1, -1) if words[k].text in PLACING or words[k].kind == "mark"), 0)
        placed = any(word.text in _SPOTS | {"along"} for word in words[put + 1 : at])
        if words[put].text in PLACING and placed:
            return [*words[:at], *over(words[at : at + 3], like(("instead",), words[at])), *words[at + 3 :]]
    return words


def _enough_there(words: list[Word]) -> list[Word]:
    """Return ``two mats in A are plenty. Remove the others`` for ``two mats are plenty. Remove the others in A``."""
    for stop in range(4, len(words) - 5):
        start = next((k + 1 for k in range(stop - 1, -1, -1) if words[k].kind == "mark"), 0)
        are = stop - 2
        things = words[start:are]
        enough = words[are].text in ("is", "are") and words[stop - 1].text in ("enough", "plenty", "sufficient")
        counted = (
            enough and len(things) > 1 and things[0].kind == "number" and all(w.kind == "word" for w in things[1:])
        )
        if words[stop].text not in SENTENCE_ENDS or not counted or any(w.text in PREPOSITIONS for w in things):
            continue
        end = next_mark(words, stop + 1)
        other = next((k for k in range(stop + 2, end) if said_at(words, k, ("the", "other"), ("the", "rest"))), end)
        place = other + 2 + (other + 2 < end and words[other + 2].kind == "number")
        if (
            place + 2 > end
            or text_at(words, place) != "in"
            or any(w.text in PREPOSITIONS for w in words[place + 1 : end])
        ):
            continue
        there = over(words[are - 1 : are], words[place:end])
        last = replace(words[place - 1], end=words[end - 1].end)
        return [*words[:are], *there, *words[are : place - 1], last, *words[end:]]
    return words


_READINGS: Final[tuple[Callable[[list[Word]], list[Word]], ...]] = (
    _order_after_not,
    _all_but_one,
    _no_longer_wanted,
    _leaving_for_good,
    _kept_of,
    _staying_behind,
    _without_thanks,
    _for_each,
    _coming_along,
    _taken_along,
    _in_its_place_last,
    _place_last,
    _brought_there,
    _laid,
    _taken_out_and_furnished,
    _slid,
    _instead_in,
    _from_number_to_number,
    _on_its_side,
    _could_stand,
    _only_of_them,
    _only_so_many_remain,
    _out_of_and_into,
    _put_in_its_place,
    _beside_in_its_place,
)
