"""A clause that asks for something as a plain order: without courtesy, passive, purpose and relative clauses."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache
from importlib.resources import files
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.verb_words import BY_WORDS
from mansion_editing.instructions.syntax.clauses import TURNING
from mansion_editing.instructions.syntax.noun_groups import end_of_noun_group
from mansion_editing.instructions.syntax.plain_things import (
    with_colour_first,
    with_lamp_of_ceiling,
    with_one_for_each,
    without_alternatives,
    without_contrast,
    without_load,
    without_simile,
)
from mansion_editing.instructions.syntax.plain_wishes import (
    WAYS,
    as_caused,
    as_going,
    as_new,
    as_painted,
    as_running,
    end_of_place,
    with_lid_closed,
    with_place_after,
    with_seats,
    without_emphasis,
)
from mansion_editing.instructions.syntax.requests import names_something
from mansion_editing.instructions.syntax.tagged_words import TaggedWord
from mansion_editing.instructions.syntax.wished_states import with_wished_colour
from mansion_language.inflection import plural, singular

__all__ = ["plainly_asked"]

_ASKED: Final = frozenset("you we somebody someone anybody anyone i".split())
_IDLE: Final = frozenset(["adverb", "interjection"])
_KEPT_ADVERBS: Final = frozenset(
    "back upstairs downstairs there here together only instead again too also first".split()
)
_OBLIGING: Final = frozenset("must should shall can could may might ought".split())
_RESTING: Final = frozenset(
    "be stand lie sit hang leave put place keep have store forget drop dump park set rest end land wind get".split()
)
_PARTICLES: Final = frozenset("up down over out across along round around away back off through".split())
_GOALS: Final = frozenset("in into on onto to under next behind beside by between at near against inside".split())


def plainly_asked(words: Sequence[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return the words of a clause that asks for something in the words of a plain order, where that is known."""
    steps: tuple[Callable[[list[TaggedWord], Lexicon], list[TaggedWord]], ...] = (
        _without_edges, with_place_after, without_emphasis, with_seats, as_caused, as_running, as_painted, as_new,
        with_lid_closed, _without_added_clause, _with_companions, _without_comparison, without_simile,
        without_contrast, without_load, with_one_for_each, without_alternatives, with_colour_first,
        with_lamp_of_ceiling, _as_removed, _with_share, _with_part_after, _with_replaced_after, as_going, _as_obliged,
        with_wished_colour, _as_moved, _as_order, _as_new_things, _as_active, _without_relatives, _as_turned,
        _without_purpose, _with_plain_verb,
    )  # fmt: skip
    said = list(words)
    for step in steps:
        said = step(said, lexicon)
    return said


def _without_edges(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return words without the courtesies and adverbs around them."""
    start, end = 0, len(words)
    while start < end - 1 and (words[start].tag in _IDLE and words[start].text not in _KEPT_ADVERBS):
        start += 1 + (words[start + 1].text == "," if start + 1 < end else 0)
    while end > start + 1 and (words[end - 1].tag == "interjection" or words[end - 1].text in _LAST):
        end -= 1
    return words[start:end]


def _without_added_clause(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``the printer can go`` for ``the printer, which nobody uses, can go``."""
    start = next((k for k in range(1, len(words)) if words[k].text in ("which", "who") and words[k - 1].text == ","), 0)
    end = next((k for k in range(start + 1, len(words)) if words[k].text == ","), len(words)) if start else 0
    if not start or names_something(words[start:end], lexicon) or any(w.text in _OBLIGING for w in words[start:end]):
        return words
    return [*words[: start - 1], *words[end + 1 :]]


_LAST: Final = frozenset("please , anyway really though meanwhile accordingly then".split())
_OUT_OF_HERE: Final = frozenset("building house flat apartment premises hut station property home place".split())


def _as_removed(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``remove the screen`` for ``take the screen off the wall and out of the building``."""
    texts = [word.text for word in words]
    out = next(
        (k for k in range(2, len(words) - 3) if texts[k : k + 3] in (["out", "of", "the"], ["out", "of", "this"])), 0
    )
    carried = words[0].form == "base" and BY_WORDS.get((words[0].verb,)) in ("take", "move", "bring", "throw")
    if not carried or not out or texts[out + 3] not in _OUT_OF_HERE or out + 4 < len(words):
        return words
    end = out - (texts[out - 1] in ("and", ","))
    order = replace(words[0], text="remove", raw="remove", verb="remove")
    wall = next(
        (k for k in range(2, end) if texts[k] in ("off", "from") and texts[k + 1 : k + 3] == ["the", "wall"]), 0
    )
    if not wall:
        return [order, *words[1:end]]
    named = end_of_noun_group(words, 1)
    on_it = [replace(words[wall], text="on", raw="on"), *words[wall + 1 : wall + 3]]
    return [order, *words[1:named], *on_it, *words[named:wall]]


_WITH: Final = (["along", "with"], ["together", "with"])


def _with_companions(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``the desk and its chair go there`` for ``the desk, along with its chair, goes there``."""
    for at in range(2, len(words) - 3):
        said = [word.text for word in words[at : at + 2]]
        end = next((k for k in range(at, len(words)) if words[k].text == ","), 0)
        if said in _WITH and words[at - 1].text == "," and end:
            joint = replace(words[at], text="and", raw="and", tag="joint")
            return [*words[: at - 1], joint, *words[at + 2 : end], *words[end + 1 :]]
    return words


_ALIKE: Final = (["like", "the"], ["just", "like"], ["like", "those"], ["as", "the"], ["like", "that"], ["with", "the"])
_NO_LONGER: Final = (["any", "longer"], ["any", "more"], ["anymore"])


def _without_comparison(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return words without what only compares at their end: ``like the one in the bathroom``, ``any longer``."""
    texts = [word.text for word in words]
    for said in _NO_LONGER:
        if texts[0] == "no" and texts[-len(said) :] == said and len(words) > len(said):
            return _without_comparison(words[: -len(said)], lexicon)
    for at in range(2, len(words) - 2):
        alike = texts[at : at + 2] in _ALIKE and texts[at + 2] in ("one", "ones", "other", "others", "rest")
        alike = alike and (texts[at] != "with" or texts[at + 2] in ("other", "others"))
        if alike and not any(word.is_finite for word in words[at:]):
            return words[: at - (texts[at - 1] in ("same", ",", "just"))]
    return words


def _with_share(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``two more desks and two chairs`` for ``two more desks, each with a chair``."""
    at = next((k for k in range(2, len(words) - 2) if [w.text for w in words[k : k + 2]] == ["each", "with"]), 0)
    number = next((k for k in range(at) if words[k].tag == "number" and words[k - 1].text not in ("the", "of")), None)
    end = end_of_noun_group(words, at + 2)
    one = at and words[at + 2].text in ("a", "an", "one")
    if not one or number is None or words[number].text == "one" or end < len(words) or words[end - 1].tag != "noun":
        return words
    last = replace(words[end - 1], raw=plural(singular(words[end - 1].text)))
    joint = replace(words[at], text="and", raw="and", tag="joint")
    named = end_of_noun_group(words, number)
    where = words[named : at - (words[at - 1].text == ",")]
    return [*words[:named], joint, words[number], *words[at + 3 : end - 1], last, *where]


def _with_part_after(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``one of the three cabinets should be open`` for ``of the three cabinets one should be open``."""
    if words[0].text not in ("of", "from", "out") or len(words) < 4:
        return words
    first = 1 + (words[1].text == "of")
    end = end_of_noun_group(words, first)
    while end < len(words) and words[end].tag == "preposition":
        following = end_of_noun_group(words, end + 1)
        if following == end + 1:
            break
        end = following
    rest = words[end + (end < len(words) and words[end].text == ",") :]
    part = next((at for at, word in enumerate(rest) if word.tag in ("number", "pronoun") or word.text == "half"), None)
    if part is None or end == first or (part and rest[0].form != "base") or words[first].tag != "determiner":
        return words
    of = replace(words[0], text="of", raw="of", tag="preposition")
    return [*rest[: part + 1], of, *words[first:end], *rest[part + 1 :]]


_INSTEAD: Final = (["instead", "of"], ["in", "place", "of"], ["rather", "than"])


def _with_replaced_after(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``replace the tables by a bookcase`` for ``instead of the tables I'd rather have a bookcase``."""
    texts = [word.text for word in words]
    length = next((len(said) for said in _INSTEAD if texts[: len(said)] == said), 0)
    verb = next((at for at in range(length + 1, len(words)) if words[at].is_finite or words[at].form == "base"), 0)
    if not length or not verb:
        return words
    subject = verb - 1 if words[verb - 1].tag == "somebody" else verb
    new = verb + 1
    while new < len(words) and words[new].tag in ("verb", "adverb", "have", "modal"):
        new += 1
    counted = new < len(words) and (words[new].text in ("a", "an", "another", "some") or words[new].tag == "number")
    gone = [word for word in words[length:subject] if word.text != ","]
    if not counted or not gone or gone[0].text not in ("the", "our", "my", "those", "these", "one", "that", "this"):
        return words
    by = replace(words[0], text="by", raw="by", tag="preposition")
    return [
        replace(words[0], text="replace", raw="replace", tag="verb", verb="replace", form="base"),
        *gone,
        by,
        *words[new:],
    ]


def _as_obliged(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``the cart should be here`` for ``it would make sense for the cart to be here``."""
    at = next((k for k in range(2, len(words) - 3) if words[k].text == "for"), 0)
    if words[0].text != "it" or not at or not {"would", "should", "is"} & {word.text for word in words[1:at]}:
        return words
    end = end_of_place(words, end_of_noun_group(words, at + 1))
    if end >= len(words) - 1 or words[end].tag != "to":
        return words
    should = replace(words[end], text="should", raw="should", tag="modal")
    return [*words[at + 1 : end], should, *words[end + 1 :]]


_BETTER: Final = frozenset("better nicer use useful good well best lovely nice great fun perfect".split())


def _as_moved(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``the lamp should go by the sofa`` for ``by the sofa the lamp would be of use``, ``is needed by ...``."""
    verb = next((k for k in range(1, len(words)) if words[k].tag in ("modal", "be")), 0)
    start = end_of_place(words, 0)
    subject_end = end_of_noun_group(words, start)
    definite = (
        start < len(words)
        and words[start].tag in ("determiner", "possessive", "pronoun")
        and words[start].text not in _NEW
    )
    if not verb or not definite or subject_end > verb:
        return words
    rest = words[verb + 1 :]
    place = words[:start]
    if words[verb].text == "would" and {word.text for word in rest} & _BETTER:
        at = next((k for k, word in enumerate(rest) if word.text in _GOALS and k), len(rest))
        place = place or rest[at:]
    elif rest and rest[0].text in ("needed", "wanted", "required") and words[verb].tag == "be":
        place = place or rest[1:]
    else:
        return words
    if not place or place[0].text not in _GOALS or not names_something(place, lexicon):
        return words
    should = replace(words[verb], text="should", raw="should", tag="modal")
    go = replace(words[verb], text="go", raw="go", tag="verb", verb="go", form="base")
    return [*words[start:verb], should, go, *place]


_NEW: Final = frozenset("a an another some any no".split())


_DOING: Final = frozenset("do suffice help sort fix solve improve".split())
_NEEDED: Final = frozenset("needed required wanted called missing due welcome".split())


def _as_new_things(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``put two more benches`` for ``two more benches should sort that out``."""
    end = end_of_noun_group(words, 0)
    new = words[0].text in ("a", "an", "another", "some") or any(word.text == "more" for word in words[:end])
    several = words[0].tag == "number" and end > 1 and words[1].text != "of"
    verb = next((at for at in range(end, len(words)) if words[at].tag in ("modal", "be")), 0)
    if not end or not (new or several) or not verb or verb + 1 >= len(words):
        return words
    rest = words[_after_idle(words, verb + 1) :]
    if not new and rest and (rest[0].text == "do" or rest[0].verb == "suffice"):
        return words  # so many may be there already
    needed = words[verb].tag == "be" and bool(rest) and rest[0].text in _NEEDED
    if not rest or names_something(rest, lexicon) or not (needed or rest[0].verb in _DOING or rest[0].text == "do"):
        return words
    put = replace(words[0], text="add", raw="add", tag="verb", verb="add", form="base")
    return [put, *words[:verb]]


def _as_order(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``put the lamp there`` for ``could you please put the lamp there``, ``I need you to put ...``."""
    whoever = len(words) > 2 and (words[1].text == "whoever" or [w.text for w in words[1:4]] == ["one", "of", "you"])
    if words[0].tag == "modal" and whoever:
        orders = (k for k in range(2, len(words)) if words[k].form == "base" and (words[k].verb,) in BY_WORDS)
        at = next(orders, 0)
        return words[at:] if at else words
    if words[0].tag == "modal" and len(words) > 2 and words[1].text in _ASKED:
        at = _after_idle(words, 2)
        at = _after_idle(words, at + 1) if at < len(words) and words[at].verb == "mind" else at
        if at < len(words) and words[at].verb:
            return [_in_base(words[at]), *words[at + 1 :]]
    to = next((at for at, word in enumerate(words[:8]) if word.tag == "to"), 0)
    possible = [word.text for word in words[:3]] in ([modal, "it", "be"] for modal in ("would", "could", "might"))
    if possible and to and words[to + 1].form == "base" and (words[to + 1].verb,) in BY_WORDS:
        return words[to + 1 :]
    troubled = words[0].tag == "modal" and [w.text for w in words[2:5]] in (
        ["trouble", "you", "for"],
        ["ask", "you", "for"],
    )
    if troubled:
        return [replace(words[0], text="add", raw="add", tag="verb", verb="add", form="base"), *words[5:]]
    wish = next((at for at, word in enumerate(words[:5]) if word.verb in ("need", "want", "like", "ask")), None)
    if wish is not None and [word.text for word in words[wish + 1 : wish + 3]] in (["you", "to"], ["somebody", "to"]):
        return words[_after_idle(words, wish + 3) :]
    if words[0].tag == "to" and len(words) > 1 and words[1].form == "base":
        return words[1:]
    return words


def _after_idle(words: Sequence[TaggedWord], at: int) -> int:
    while at < len(words) and words[at].tag in _IDLE:
        at += 1
    return at


def _in_base(word: TaggedWord) -> TaggedWord:
    return replace(word, text=word.verb, raw=word.verb, form="base", tag="verb")


def _as_active(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``take the rug away`` for ``the rug has to be taken away``, ``could the rug be taken away``."""
    asked = words[0].tag == "modal"
    for at in range(1, len(words) - 1):
        done = words[at + 1]
        if words[at].text not in ("be", "get") or not done.verb or (done.verb,) not in BY_WORDS:
            continue
        start = 1 if asked else 0
        end = _end_of_subject(words, start, at, asked=asked)
        if end <= start or done.form not in ("participle", "past"):
            return words
        rest = [word for word in words[at + 2 :] if word.text != "please"]
        first = words[start] if words[start].tag == "noun" else replace(words[start], raw=words[start].text)
        return [_in_base(done), first, *words[start + 1 : end], *rest]
    return words


def _end_of_subject(words: Sequence[TaggedWord], start: int, be: int, *, asked: bool) -> int:
    """Return the end of the subject of a passive request whose ``be`` stands at a place; the start for none."""
    at = be
    while at > start and words[at - 1].tag in ("adverb", "interjection"):
        at -= 1
    if asked:
        return at
    obliged = words[at - 1].text in _OBLIGING or words[at - 1].tag == "to"
    if words[at - 1].tag == "to":
        at -= 1
        at -= words[at - 1].text == "got"
        obliged = words[at - 1].text in ("has", "have", "needs", "need", "is", "are", "ought")
    at -= 1
    while at > start and words[at - 1].tag in ("adverb", "interjection") and words[at - 1].text not in _KEPT_ADVERBS:
        at -= 1
    return at if obliged else start


def _without_relatives(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``the box on the counter`` for ``the box that somebody left on the counter``."""
    for at in range(1, len(words) - 1):
        named = words[at - 1].tag in ("noun", "pronoun", "number")
        bare = words[at].tag == "somebody" and words[at].text in ("i", "we", "you", "they", "she", "he")
        if not named or not (words[at].tag == "relative" or bare):
            continue
        verb = at if bare else at + 1
        while verb < len(words) and verb < at + 5 and not words[verb].is_finite:
            verb += 1
        while verb + 1 < len(words) and words[verb].tag in ("have", "be", "adverb"):
            if not (words[verb + 1].verb or words[verb + 1].tag in ("be", "adverb")):
                break
            verb += 1
        resting = verb < len(words) and (words[verb].verb in _RESTING or words[verb].tag in ("be", "have"))
        after = _after_idle(words, verb + 1)
        after += after < len(words) and words[after].text == "up"
        if resting and after < len(words) and words[after].tag == "preposition":
            return _without_relatives([*words[:at], *words[after:]], lexicon)
    return words


_LOOKING: Final = frozenset("face faces look looks point points".split())
_SEATS: Final = ("chair", "sofa", "stool", "bench", "seat", "couch", "recliner", "loveseat", "settee")


def _as_turned(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``turn the chair to the crib`` for ``turn the chair around so that it looks at the crib``."""
    so = next((k for k in range(2, len(words) - 2) if words[k].text == "so"), 0)
    if words[0].verb not in TURNING or not so:
        return words
    looks = next((k for k in range(so + 1, len(words) - 1) if words[k].text in _LOOKING), 0)
    subject = [word.text for word in words[so + 1 : looks] if word.text not in ("that", "can", "should", "will")]
    turned = subject in (["it"], ["they"], ["its", "front"]) or _sits_there(subject, words[1:so])
    if not looks or not turned or words[-1].text in ("way", "direction"):
        return words
    goal = looks + 1
    while goal < len(words) and (words[goal].tag in ("preposition", "to", "adverb")):
        goal += 1
    end = so - (words[so - 1].text in ("around", "round", "about", ","))
    to = replace(words[so], text="to", raw="to", tag="to")
    return [*words[:end], to, *words[goal:]] if goal < len(words) else words


def _sits_there(subject: Sequence[str], turned: Sequence[TaggedWord]) -> bool:
    """Whether a subject is who sits on the seat that turns, and so looks where it does: ``who sits in it``, ``I``."""
    seat = any(singular(word.text).endswith(_SEATS) for word in turned)
    alone = len(subject) == 1 and subject[0] in ("you", "i", "we", "one", "she", "he", "people")
    there = subject[-1:] in (["it"], ["there"], ["in"], ["on"])
    sits = len(subject) > 1 and bool({"sits", "sitting", "sit"} & {*subject}) and there
    return seat and (alone or sits)


def _without_purpose(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return an order without what it is for: ``to cheer us up``, ``for reading``, ``so that we see it``."""
    if words[0].form != "base":
        return words
    for at in range(3, len(words) - 1):
        rest = words[at + 1 :]
        to_do = words[at].tag == "to" and rest[0].form == "base" and words[at - 1].tag in ("noun", "adverb", "mark")
        for_doing = words[at].text == "for" and rest[0].form == "gerund"
        if (to_do or for_doing) and not names_something(rest, lexicon) and not _counts(rest):
            return words[: at - (words[at - 1].text in (",", "order"))]
    return words


def _counts(words: Sequence[TaggedWord]) -> bool:
    return any(word.tag in ("number", "pronoun", "preposition") for word in words)


def _with_plain_verb(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``put the knife in the drawer`` for ``lock the knife away in the drawer``."""
    if words[0].form != "base" or len(words) < 3:
        return words
    verb = words[0]
    plain = _deeds().get(verb.verb, "")
    known = plain or (verb.verb if (verb.verb,) in BY_WORDS else "")
    if known in ("swap", "switch") and words[-1].text in _PARTICLES and any(word.text == "and" for word in words):
        return [replace(verb, text="swap", raw="swap", verb="swap"), *words[1:-1]]
    aside = words[1].text in _PARTICLES
    start = 1 + aside
    end = end_of_noun_group(words, start)
    if end == start or not known:
        return words
    particle = words[end].text if end + 1 < len(words) else ""
    if particle == "in" and words[end + 1].tag == "preposition":
        words, particle = [*words[:end], *words[end + 1 :]], ""
    deed = BY_WORDS.get((known,))
    goal = _goal_from(words, end, _GOALS if deed == "add" else WAYS)
    carried = deed in ("move", "add", "bring", "take")
    wall = next(
        (k for k in range(end, len(words) - 2) if words[k].text in ("off", "from") and _is_wall(words, k + 2)), 0
    )
    if known == "take" and wall:
        on_it = [replace(words[wall], text="on", raw="on"), *words[wall + 1 : wall + 3]]
        remove = replace(verb, text="remove", raw="remove", verb="remove")
        return [remove, *words[1:end], *on_it, *words[end:wall], *words[wall + 3 :]]
    if carried and goal and (aside or particle in _PARTICLES) and not _leaves(words, end):
        rest = words[goal:] if particle in _PARTICLES else words[end:]
        put = known if known != "put" or words[goal].text != "to" else "move"
        return [replace(verb, text=put, raw=put, verb=put), *words[start:end], *rest]
    return [replace(verb, text=known, raw=known, verb=known), *words[1:]] if plain else words


def _is_wall(words: Sequence[TaggedWord], at: int) -> bool:
    return words[at].text in ("wall", "walls") and words[at - 1].text == "the"


def _goal_from(words: Sequence[TaggedWord], at: int, goals: frozenset[str]) -> int:
    """Return the place of the first preposition of a goal after an object, past its particles; 0 for none."""
    k = at
    while k < len(words) and words[k].text in _PARTICLES and k < at + 2:
        k += 1
    if k < len(words) and words[k].text in goals:
        return k
    later = (n for n in range(at, len(words)) if words[n].text in goals)
    return next(later, 0) if at < len(words) and words[at].text not in _PARTICLES else 0


def _leaves(words: Sequence[TaggedWord], at: int) -> bool:
    """Whether things come ``out of``, ``off`` or ``from`` somewhere."""
    return at + 1 < len(words) and (words[at].text in ("from", "off") or words[at + 1].text in ("of", "from"))


@cache
def _deeds() -> dict[str, str]:
    """Return the plainer verb of each that is said for it."""
    lines = files(__package__).joinpath("data/deeds.txt").read_text(encoding="utf-8").splitlines()
    rows = (line.split() for line in lines if line and not line.startswith("#"))
    return {verb: row[0] for row in rows for verb in row[1:]}
