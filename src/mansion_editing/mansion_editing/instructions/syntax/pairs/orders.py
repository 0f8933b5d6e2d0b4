"""Orders of two clauses: what is taken and put, swapped, or comes instead of others."""

from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.verb_words import BY_WORDS
from mansion_editing.instructions.syntax.clauses import Clause
from mansion_editing.instructions.syntax.noun_groups import end_of_noun_group
from mansion_editing.instructions.syntax.pairs.wording import IT, SETTING, Joined, said_in, texts_of, with_the
from mansion_editing.instructions.syntax.requests import names_something
from mansion_editing.instructions.syntax.tagged_words import TaggedWord, joined

__all__ = [
    "carried",
    "exchanged",
    "in_place_of_those",
    "instead_of_some",
    "kept_elsewhere",
    "namely",
    "spread",
    "swapped_topic",
    "swapped_with_companions",
]

_OUT: Final = (["out", "of"], ["off"], ["from"], ["down", "from"], ["out", "from"], ["off", "of"])


def carried(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Put ``move both carts from the hall to the shed`` for ``wheel both carts out of the hall, park them there``."""
    if at + 1 >= len(clauses) or clauses[at].form != "order" or clauses[at + 1].form != "order":
        return None
    first, second = (said_in(clause, words) for clause in clauses[at : at + 2])
    carrying = BY_WORDS.get((first[0].verb,)) in ("move", "take", "bring")
    putting = BY_WORDS.get((second[0].verb,)) in SETTING
    goal = len(second) > 3 and second[1].text in IT and second[2].tag in ("preposition", "to")
    if not (carrying and putting and goal):
        return None
    leaving = [k for k in range(2, len(first)) if any(texts_of(first[k : k + len(said)]) == said for said in _OUT)]
    if not leaving or any(word.text in ("to", "into", "onto") for word in first[leaving[0] :]):
        return None
    start = leaving[0]
    source = start + next(len(s) for s in sorted(_OUT, key=len, reverse=True) if texts_of(first[start:])[: len(s)] == s)
    things = joined(first[1:start])
    if second[2].text in ("out", "off", "from", "up", "down", "back", "away"):
        return None
    return at + 2, f"move {things} from {joined(first[source:])} to {_aim(second[2:])}"


def _aim(goal: Sequence[TaggedWord]) -> str:
    """Return a goal without the preposition of a room: ``the shed`` for ``in the shed``."""
    plain = goal[0].text in ("in", "into", "to", "at")
    return joined(goal[1:]) if plain else joined(goal)


def swapped_with_companions(
    clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon
) -> Joined:
    """Put ``remove the chairs and replace the table by a desk`` for ``swap the table with its chairs for a desk``."""
    said = said_in(clauses[at], words)
    if clauses[at].form != "order" or BY_WORDS.get((said[0].verb,)) not in ("swap", "replace"):
        return None
    texts = texts_of(said)
    own = next(
        (k for k in range(2, len(said) - 3) if texts[k] in ("with", "and") and texts[k + 1] in ("its", "their")), 0
    )
    new = next((k for k in range(own + 3, len(said) - 1) if texts[k] in ("for", "by", "with")), 0) if own else 0
    if not new:
        return None
    gone = joined([*said[own + 2 : new]])
    return at + 1, f"remove the {gone} and replace {joined(said[1:own])} by {joined(said[new + 1 :])}"


def exchanged(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Put ``swap the desk and the bed`` for ``the desk where the bed is now, and the other way round``."""
    said: list[TaggedWord] = []
    for last in range(at, min(at + 3, len(clauses))):
        said = [*words[clauses[at].start : clauses[last].end]]
        texts = texts_of(said)
        where = texts.index("where") if "where" in texts else 0
        where = where if where < clauses[at].end - clauses[at].start else 0
        be = next((k for k in range(where + 2, len(said)) if said[k].tag == "be"), 0) if where else 0
        if be and texts[-1] in ("about", "round", "around", "versa", "back") and {"way", "vice"} & {*texts[be:]}:
            start = 1 if said[0].form == "base" else 0
            one, other = said[start:where], said[where + 1 : be]
            if names_something(one, lexicon) and names_something(other, lexicon):
                return last + 1, f"swap {with_the(one)} and {with_the(other)}"
    return None


def instead_of_some(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Put ``hang it in the hall and remove one of the maps in the hall`` for ``hang it in the hall instead of one``."""
    said = said_in(clauses[at], words)
    texts = texts_of(said)
    old = next((k for k in range(3, len(said) - 3) if texts[k : k + 2] == ["instead", "of"]), 0)
    if clauses[at].form != "order" or not old or said[old + 2].tag != "number" or texts[old + 3] != "of":
        return None
    place = next((k for k in range(old - 1, 1, -1) if texts[k] in ("in", "on", "at")), 0)
    if not place or BY_WORDS.get((said[0].verb,)) not in SETTING:
        return None
    return at + 1, f"{joined(said[:old])} and remove {joined(said[old + 2 :])} {joined(said[place:old])}"


def kept_elsewhere(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Leave out ``upstairs leave them`` after what goes downstairs, of which nothing else goes."""
    first = said_in(clauses[at], words)
    gone = first[0].text == "no" or BY_WORDS.get((first[0].verb,)) == "remove"
    for last in range(at + 1, min(at + 3, len(clauses))):
        texts = texts_of(said_in(clauses[last], words))
        leaves = texts[1:3] in (["leave", "them"], ["keep", "them"]) and len(texts) < 6
        if gone and leaves and texts[0] in ("upstairs", "downstairs", "elsewhere"):
            return last + 1, joined(first)
    return None


def spread(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Put ``put five bears on the tables`` for ``five bears, spread over the tables``."""
    if at + 1 >= len(clauses) or clauses[at].form != "fragment" or clauses[at + 1].after != ",":
        return None
    new, order = (said_in(clause, words) for clause in clauses[at : at + 2])
    over = order[0].text in ("spread", "scattered", "distributed") and order[1:2] and order[1].text in _OVER
    if not over or not names_something(new, lexicon) or new[0].tag not in ("number", "determiner", "noun", "adjective"):
        return None
    return at + 2, f"put {joined(new)} on {joined(order[2:])}"


_OVER: Final = frozenset("over across on among around".split())


def in_place_of_those(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Leave out ``in their place:`` before what comes instead of what goes by the clause before."""
    texts = texts_of(said_in(clauses[at], words))
    said = texts in (["in", "their", "place"], ["in", "its", "place"], ["in", "their", "stead"])
    if not said or at + 1 >= len(clauses) or not at:
        return None
    following = spread(clauses, at + 1, words, lexicon)
    if following is not None:
        return following
    return at + 2, f"add {joined(said_in(clauses[at + 1], words))}" if clauses[at + 1].form == "fragment" else ""


def swapped_topic(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Put ``swap the red vase with the clock`` for ``red vase: swap places with the clock``."""
    if at + 1 >= len(clauses) or clauses[at].form != "fragment" or clauses[at + 1].form != "order":
        return None
    topic, order = (said_in(clause, words) for clause in clauses[at : at + 2])
    texts = texts_of(order)
    colon = words[clauses[at].end].text in (":", "-")
    if not colon or texts[:3] not in ([verb, "places", "with"] for verb in ("swap", "change", "exchange", "trade")):
        return None
    return at + 2, f"swap {with_the(topic)} with {joined(order[3:])}"


def namely(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Put ``remove the tables and the plant from the hall`` for ``remove the old stuff from the hall, i.e. ...``."""
    if at + 1 >= len(clauses) or clauses[at].form != "order":
        return None
    order, listed = (said_in(clause, words) for clause in clauses[at : at + 2])
    if texts_of(listed[:2]) != ["that", "is"] or len(listed) < 3:
        return None
    if listed[2].form == "base":
        return at + 2, joined(listed[2:])
    end = end_of_noun_group(order, 1)
    return (at + 2, f"{order[0].raw} {joined(listed[2:])} {joined(order[end:])}".strip()) if end > 1 else None
