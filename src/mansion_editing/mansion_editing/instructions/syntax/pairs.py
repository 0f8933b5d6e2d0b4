"""Clauses that ask for one thing together, put as one order: ``wheel it out of the hall and park it in the shed``."""

import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Final, TypeAlias

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.verb_words import BY_WORDS
from mansion_editing.instructions.syntax.clauses import Clause, clauses_of
from mansion_editing.instructions.syntax.noun_groups import end_of_noun_group
from mansion_editing.instructions.syntax.requests import names_something
from mansion_editing.instructions.syntax.tagged_words import TaggedWord, joined, tagged
from mansion_language.colours import COLOUR_WORDS
from mansion_language.inflection import plural, singular

__all__ = ["with_pairs_joined", "without_misread_pairs"]

_Joined: TypeAlias = tuple[int, str] | None
"""The number of the clause after those that are put as one order, and the order."""
_Rule: TypeAlias = Callable[[Sequence[Clause], int, Sequence[TaggedWord], Lexicon], "tuple[int, str] | None"]
_OUT: Final = (["out", "of"], ["off"], ["from"], ["down", "from"], ["out", "from"], ["off", "of"])
_IT: Final = frozenset(["it", "them", "those", "that", "these"])
_SETTING: Final = frozenset(["add", "bring", "move", "set", "take", "leave"])
_MISSING: Final = (
    ["where", "it", "is", "missing"], ["where", "there", "is", "none"], ["where", "they", "are", "missing"],
    ["where", "one", "is", "missing"], ["where", "it", "is", "lacking"], ["where", "there", "is", "not"],
    ["where", "there", "are", "none"], ["where", "missing"], ["where", "needed"],
)  # fmt: skip


def with_pairs_joined(text: str, lexicon: Lexicon) -> str:
    """Return a text with clauses that ask for one thing only together put as one order.

    Parameters
    ----------
    text : str
        In running text, without contractions.
    """
    return _joined_by(_RULES, text, lexicon)


def without_misread_pairs(text: str, lexicon: Lexicon) -> str:
    """Return a text with those clauses put as one order that would ask for something else if they were read alone.

    Examples
    --------
    ``No lights on upstairs`` does not take lights away.
    """
    return _joined_by(_MISREAD, text, lexicon)


def _joined_by(rules: Sequence[_Rule], text: str, lexicon: Lexicon) -> str:
    words = tagged(text, lexicon)
    clauses = clauses_of(words)
    out: list[str] = []
    at = end = 0
    while at < len(clauses):
        found = next((pair for rule in rules if (pair := rule(clauses, at, words, lexicon)) is not None), None)
        if found is None:
            at += 1
            continue
        following, order = found
        out += [text[end : words[clauses[at].start].start], order]
        end = words[clauses[following - 1].end - 1].end
        at = following
    return "".join([*out, text[end:]])


def _said(clause: Clause, words: Sequence[TaggedWord]) -> Sequence[TaggedWord]:
    return words[clause.start : clause.end]


def _texts(words: Sequence[TaggedWord]) -> list[str]:
    return [word.text for word in words]


def _carried(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> _Joined:
    """Put ``move both trolleys from the hall in the shed`` for ``wheel both trolleys out of the hall and park them``."""
    if at + 1 >= len(clauses) or clauses[at].form != "order" or clauses[at + 1].form != "order":
        return None
    first, second = (_said(clause, words) for clause in clauses[at : at + 2])
    carrying = BY_WORDS.get((first[0].verb,)) in ("move", "take", "bring")
    putting = BY_WORDS.get((second[0].verb,)) in _SETTING
    goal = len(second) > 3 and second[1].text in _IT and second[2].tag in ("preposition", "to")
    if not (carrying and putting and goal):
        return None
    leaving = [k for k in range(2, len(first)) if any(_texts(first[k : k + len(said)]) == said for said in _OUT)]
    if not leaving or any(word.text in ("to", "into", "onto") for word in first[leaving[0] :]):
        return None
    start = leaving[0]
    source = start + next(len(s) for s in sorted(_OUT, key=len, reverse=True) if _texts(first[start:])[: len(s)] == s)
    things = joined(first[1:start])
    if second[2].text in ("out", "off", "from", "up", "down", "back", "away"):
        return None
    return at + 2, f"move {things} from {joined(first[source:])} to {_aim(second[2:])}"


def _aim(goal: Sequence[TaggedWord]) -> str:
    """Return a goal without the preposition of a room: ``the shed`` for ``in the shed``."""
    plain = goal[0].text in ("in", "into", "to", "at")
    return joined(goal[1:]) if plain else joined(goal)


def _swapped_with_companions(
    clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon
) -> _Joined:
    """Put ``remove the chairs and replace the table by a desk`` for ``swap the table with its chairs for a desk``."""
    said = _said(clauses[at], words)
    if clauses[at].form != "order" or BY_WORDS.get((said[0].verb,)) not in ("swap", "replace"):
        return None
    texts = _texts(said)
    own = next((k for k in range(2, len(said) - 3) if texts[k] in ("with", "and") and texts[k + 1] in ("its", "their")), 0)
    new = next((k for k in range(own + 3, len(said) - 1) if texts[k] in ("for", "by", "with")), 0) if own else 0
    if not new:
        return None
    gone = joined([*said[own + 2 : new]])
    return at + 1, f"remove the {gone} and replace {joined(said[1:own])} by {joined(said[new + 1 :])}"


def _added_where_missing(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> _Joined:
    """Put ``there should be a lamp in every room`` for ``is there a lamp in every room? Add one where it is missing``."""
    if at + 1 >= len(clauses):
        return None
    asked, order = (_said(clause, words) for clause in clauses[at : at + 2])
    texts = _texts(order)
    exists = _texts(asked[:2]) in (["is", "there"], ["are", "there"]) and len(asked) > 3
    every = any(word.text in ("every", "each", "all", "both") for word in asked)
    adding = BY_WORDS.get((order[0].verb,)) in ("add", "bring") and len(texts) > 2 and texts[1] in ("one", "some")
    if not (exists and every and adding and texts[2:] in _MISSING):
        return None
    return at + 2, f"there should be {joined(asked[2:])}"


def _all_made_so(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> _Joined:
    """Put ``all lockers should be shut`` for ``are all lockers shut? If one of them is not, shut it``."""
    if at + 2 >= len(clauses):
        return None
    asked, condition, order = (_said(clause, words) for clause in clauses[at : at + 3])
    subject = end_of_noun_group(asked, 1)
    if asked[0].tag != "be" or subject < 3 or asked[1].text not in ("all", "both", "the", "every"):
        return None
    if condition[0].text != "if" or condition[-1].text not in ("not", "so") or len(condition) > 7:
        return None
    if order[0].form != "base" or len(order) != 2 or order[1].text not in _IT or condition[-1].text == "so":
        return None
    return at + 3, f"{joined(asked[1:subject])} should be {joined(asked[subject:])}"


def _exchanged(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> _Joined:
    """Put ``swap the desk and the bed`` for ``the desk where the bed is now, and the other way round``."""
    said: list[TaggedWord] = []
    for last in range(at, min(at + 3, len(clauses))):
        said = [*words[clauses[at].start : clauses[last].end]]
        texts = _texts(said)
        where = texts.index("where") if "where" in texts else 0
        where = where if where < clauses[at].end - clauses[at].start else 0
        be = next((k for k in range(where + 2, len(said)) if said[k].tag == "be"), 0) if where else 0
        if be and texts[-1] in ("about", "round", "around", "versa", "back") and {"way", "vice"} & {*texts[be:]}:
            start = 1 if said[0].form == "base" else 0
            one, other = said[start:where], said[where + 1 : be]
            if names_something(one, lexicon) and names_something(other, lexicon):
                return last + 1, f"swap {_definite(one)} and {_definite(other)}"
    return None


_ELABORATED: Final = frozenset(
    "warm fold make turn prepare freshen rearrange change decorate brighten dress refresh organise organize update do "
    "improve cheer liven ready fix arrange furnish set".split()
)
"""Verbs of what a colon tells in detail: ``warm the kitchen: ...``."""


def _told_in_detail(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> _Joined:
    """Put ``in the kitchen`` for ``warm the kitchen:``, of which what follows tells all."""
    clause = clauses[at]
    said = _said(clause, words)
    colon = clause.end < len(words) and words[clause.end].text == ":" and at + 1 < len(clauses)
    if not colon or clause.form != "order" or said[0].verb not in _ELABORATED:
        return None
    start = 1 + (said[1].tag == "preposition")
    end = end_of_noun_group(said, start)
    idle = all(word.tag in ("adverb", "adjective", "determiner", "preposition") or word.text == "bit" for word in said[end:])
    room = tuple(singular(word.text) for word in said[start:end] if word.tag in ("noun", "number"))
    if not room or not idle or not lexicon.is_own_room(room):
        return None
    return at + 1, f"in {_definite(said[start:end])}"


def _definite(words: Sequence[TaggedWord]) -> str:
    bare = words[0].tag in ("noun", "adjective")
    return f"the {joined(words)}" if bare else joined(words)


def _lined_with(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> _Joined:
    """Put ``put two benches along the wall in the hall`` for ``line the hall with two benches along the wall``."""
    said = _said(clauses[at], words)
    if clauses[at].form != "order" or said[0].verb not in ("line", "dress", "ring"):
        return None
    joint = end_of_noun_group(said, 1)
    if joint >= len(said) - 1 or said[joint].text != "with" or end_of_noun_group(said, joint + 1) == joint + 1:
        return None
    return at + 1, f"put {joined(said[joint + 1 :])} in {joined(said[1:joint])}"


def _instead_of_some(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> _Joined:
    """Put ``hang it in the hall and remove one of the maps in the hall`` for ``hang it in the hall instead of one``."""
    said = _said(clauses[at], words)
    texts = _texts(said)
    old = next((k for k in range(3, len(said) - 3) if texts[k : k + 2] == ["instead", "of"]), 0)
    if clauses[at].form != "order" or not old or said[old + 2].tag != "number" or texts[old + 3] != "of":
        return None
    place = next((k for k in range(old - 1, 1, -1) if texts[k] in ("in", "on", "at")), 0)
    if not place or BY_WORDS.get((said[0].verb,)) not in _SETTING:
        return None
    return at + 1, f"{joined(said[:old])} and remove {joined(said[old + 2 :])} {joined(said[place:old])}"


def _asked_of_room(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> _Joined:
    """Put ``how many beds are there in the hall? Is there a lamp in the hall?`` for ``hall: how many beds, and ...?``."""
    first = clauses[at]
    said = _said(first, words)
    rest = [one for one in clauses[at + 1 :] if one.sentence == first.sentence]
    colon = first.end < len(words) and words[first.end].text == ":"
    if first.form != "fragment" or not rest or not colon or not _is_room(said, lexicon):
        return None
    asked = []
    for one in rest:
        texts = _texts(_said(one, words))
        counts = texts[:2] == ["how", "many"]
        if not counts and texts[:2] not in (["is", "there"], ["are", "there"]):
            return None
        verb = " are there" if counts and not {"are", "is"} & {*texts} else ""
        asked.append(f"{joined(_said(one, words))}{verb} in {_definite(said)}")
    return at + 1 + len(rest), "? ".join(asked)


def _is_room(words: Sequence[TaggedWord], lexicon: Lexicon) -> bool:
    """Whether words name a room of the building, and nothing else."""
    named = [word for word in words if word.tag != "determiner"]
    return lexicon.is_own_room(tuple(singular(word.text) for word in named))


_RUNNING: Final = frozenset("run burn glow shine be".split())


def _contrasted(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> _Joined:
    """Put ``the lamps should be on and the pendants should be off`` for ``the lamps should burn, the pendants not``."""
    if clauses[at].form != "statement":
        return None
    told = _said(clauses[at], words)
    comma = next((k for k in range(len(told) - 1, 2, -1) if told[k].text == ","), 0)
    within = told[-1].text == "not" and comma > 0
    if within:
        told, other = told[:comma], told[comma + 1 :]
    elif at + 1 < len(clauses) and clauses[at + 1].form == "fragment":
        other = _said(clauses[at + 1], words)
    else:
        return None
    modal = next((k for k in range(1, len(told) - 1) if told[k].text in ("should", "must", "shall")), 0)
    running = bool(modal) and (told[modal + 1].verb in _RUNNING - {"be"} or _texts(told[modal + 1 : modal + 3]) == ["be", "on"])
    if not running or other[-1].text != "not" or not any(word.tag == "noun" for word in other):
        return None
    return at + 2 - within, f"{joined(told[:modal])} should be on and {joined(other[:-1])} should be off"


_ON: Final = frozenset("on running burning lit".split())


def _none_on(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> _Joined:
    """Put ``turn off all lights upstairs`` for ``no light on upstairs``, which takes none away."""
    said = _said(clauses[at], words)
    if _texts(said[:1]) == ["nothing"] and _texts(said[1:4]) in (["should", "be", "on"], ["must", "be", "on"]):
        return at + 1, f"turn off everything {joined(said[4:])}".strip()
    start = next((k for k, word in enumerate(said) if word.text == "no"), -1)
    end = end_of_noun_group(said, start + 1) if start >= 0 else 0
    told = start == 0 or _texts(said[:start]) in (["there", "should", "be"], ["there", "must", "be"])
    if not told or end <= start + 1 or end >= len(said) or said[end].text not in _ON:
        return None
    following = said[end + 1] if end + 1 < len(said) else None
    placed = following is not None and following.tag not in ("preposition", "adverb", "adjective", "mark", "joint")
    noun = tuple(singular(word.text) for word in said[start + 1 : end] if word.tag == "noun")
    if placed or not (lexicon.takes_state(noun, "on") or lexicon.gives_light(noun)):
        return None
    last = said[end - 1]
    things = [*said[start + 1 : end - 1], replace(last, raw=plural(singular(last.text)))]
    return at + 1, f"turn off all {joined(things)} {joined(said[end + 1 :])}".strip()


def _not_needed(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> _Joined:
    """Put ``remove the second toaster`` for ``we do not need the second toaster``."""
    said = _said(clauses[at], words)
    texts = _texts(said)
    denied = texts[:4] in (["we", "do", "not", "need"], ["i", "do", "not", "need"], ["we", "do", "not", "want"],
                           ["nobody", "needs"] + texts[2:4], ["no", "one", "needs"] + texts[3:4])  # fmt: skip
    start = 4 if texts[1:3] == ["do", "not"] else 3 if texts[:2] == ["no", "one"] else 2
    end = end_of_noun_group(said, start)
    definite = start < len(said) and said[start].text in ("the", "this", "that", "these", "those")
    if not denied or not definite or not names_something(said[start:end], lexicon):
        return None
    stop = next((k for k in range(end, len(said)) if said[k].text in ("any", "anymore", "at", "now")), len(said))
    if any(word.is_finite or word.tag == "to" for word in said[end:stop]):
        return None
    return at + 1, f"remove {joined(said[start:stop])}"


def _left_only(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> _Joined:
    """Put ``remove everything from the hall except the bench`` for ``leave only the bench in the hall``."""
    said = _said(clauses[at], words)
    stays = next((k for k in range(2, len(said) - 1) if said[k].verb in ("stay", "remain")), 0)
    if said[0].text == "only" and stays and said[stays - 1].tag == "modal" and said[stays + 1].text in ("in", "on"):
        where = joined(said[stays + 2 :])
        named = names_something(said[stays + 2 :], lexicon) and names_something(said[1 : stays - 1], lexicon)
        return (at + 1, f"remove everything from {where} except {joined(said[1 : stays - 1])}") if named else None
    if clauses[at].form != "order" or _texts(said[:2]) not in (["leave", "only"], ["keep", "only"]):
        return None
    place = next((k for k in range(3, len(said)) if said[k].text in ("in", "on")), 0)
    if not place or not names_something(said[place:], lexicon):
        return None
    return at + 1, f"remove everything from {joined(said[place + 1 :])} except {joined(said[2:place])}"


_COVERS: Final = ("plates", "forks", "knives", "glasses")
"""What a table is laid with for each person."""


_NAME: Final = r"[A-Z][\w' -]*?"
_RENAMED: Final = re.compile(
    rf"rename (.+?) (\d+)(?: ?(?:to|-) ?)(\d+) (?:to |as |into )?({_NAME}(?:, {_NAME})+(?:,? and {_NAME})?)"
    r"(?:,? (?:in that order|in this order|respectively))?$"
)


def _renamed_in_turn(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> _Joined:
    """Put ``rename room 1 to North and rename room 2 to South`` for ``rename rooms 1 to 2 North, South``."""
    if words[clauses[at].start].text != "rename":
        return None
    last = max(k for k, one in enumerate(clauses) if one.sentence == clauses[at].sentence)
    first, *rest = words[clauses[at].start : clauses[last].end]
    found = _RENAMED.match(joined([replace(first, raw="rename"), *rest]))
    if found is None:
        return None
    names = re.split(r",? and |, ", found[4])
    numbers = range(int(found[2]), int(found[3]) + 1)
    if len(names) != len(numbers):
        return None
    room = singular(found[1].split()[-1])
    kind = " ".join([*found[1].split()[:-1], room])
    orders = [f'rename {kind} {number} to "{name}"' for number, name in zip(numbers, names, strict=True)]
    return last + 1, " and ".join(orders)


def _made_of(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> _Joined:
    """Put ``change the floor of hall 1 to white tile`` for ``make hall 1's floor white tile``."""
    said = _said(clauses[at], words)
    part = next((k for k in range(2, len(said) - 1) if singular(said[k].text) in _SURFACES), 0)
    if clauses[at].form != "order" or said[0].verb != "make" or not part:
        return None
    room = joined(said[1:part])
    owned = room.removesuffix("'s")
    if owned == room or not lexicon.is_room(tuple(singular(w) for w in owned.lower().split() if not w.isdecimal() and w != "the")):
        return None
    look = [word for word in said[part + 1 :] if word.tag != "preposition"]
    return at + 1, f"change the {_SURFACES[singular(said[part].text)]} of {owned} to {joined(look)}"


def _kept_elsewhere(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> _Joined:
    """Leave out ``upstairs leave them`` after what goes downstairs, of which nothing else goes."""
    first = _said(clauses[at], words)
    gone = first[0].text == "no" or BY_WORDS.get((first[0].verb,)) == "remove"
    for last in range(at + 1, min(at + 3, len(clauses))):
        texts = _texts(_said(clauses[last], words))
        leaves = texts[1:3] in (["leave", "them"], ["keep", "them"]) and len(texts) < 6
        if gone and leaves and texts[0] in ("upstairs", "downstairs", "elsewhere"):
            return last + 1, joined(first)
    return None


def _table_laid(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> _Joined:
    """Put ``there should be four plates, four forks, ... on the table`` for ``lay the table for four``."""
    said = _said(clauses[at], words)
    persons = next((k for k in range(2, len(said) - 1) if said[k].text == "for" and said[k + 1].tag == "number"), 0)
    laying = clauses[at].form == "order" and said[0].verb in ("lay", "set") and said[1].text in ("the", "our", "my")
    colon = clauses[at].end < len(words) and words[clauses[at].end].text in (":", "-")
    table = end_of_noun_group(said, 1)
    if not (laying and persons) or colon or singular(said[table - 1].text) != "table" or said[table - 1].text == "tables":
        return None
    after = persons + 2 + (persons + 2 < len(said) and said[persons + 2].text in ("people", "persons", "guests"))
    if any(word.tag != "preposition" for word in said[after : after + 1]) or names_something(said[after:], lexicon) and not (
        said[after].text in ("in", "at")
    ):
        return None
    number = said[persons + 1].text
    covers = [f"{number} {cover}" if number not in ("one", "1") else f"one {singular(cover)}" for cover in _COVERS]
    where = joined([*said[1:persons], *said[after:]])
    return at + 1, f"there should be {', '.join(covers[:-1])} and {covers[-1]} on {where}"


_SURFACES: Final = {"floor": "floor", "wall": "walls", "ceiling": "ceiling"}


def _given_finishes(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> _Joined:
    """Put ``make the floor of the hall wooden and paint the walls white`` for ``give the hall a wooden floor ...``."""
    said = _said(clauses[at], words)
    end = end_of_noun_group(said, 1)
    if clauses[at].form != "order" or said[0].verb != "give" or not _is_room(said[1:end], lexicon):
        return None
    out: list[str] = []
    start = end
    while start < len(said):
        stop = next((k for k in range(start, len(said)) if singular(said[k].text) in _SURFACES), 0)
        look = [word for word in said[start:stop] if word.tag not in ("determiner", "joint", "mark")]
        if not stop or not look:
            return None
        part = _SURFACES[singular(said[stop].text)]
        room = joined(said[1:end])
        colour = part == "walls" or look[-1].text in COLOUR_WORDS
        way = f"paint the {part} of {room} {joined(look)}" if colour else f"change the {part} of {room} to {joined(look)}"
        out.append(way)
        start = stop + 1
    return (at + 1, " and ".join(out)) if out else None


def _spread(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> _Joined:
    """Put ``put five bears on the tables`` for ``five bears, spread over the tables``."""
    if at + 1 >= len(clauses) or clauses[at].form != "fragment" or clauses[at + 1].after != ",":
        return None
    new, order = (_said(clause, words) for clause in clauses[at : at + 2])
    over = order[0].text in ("spread", "scattered", "distributed") and order[1:2] and order[1].text in _OVER
    if not over or not names_something(new, lexicon) or new[0].tag not in ("number", "determiner", "noun", "adjective"):
        return None
    return at + 2, f"put {joined(new)} on {joined(order[2:])}"


_OVER: Final = frozenset("over across on among around".split())


def _in_place_of_those(
    clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon
) -> _Joined:
    """Leave out ``in their place:`` before what comes instead of what goes by the clause before."""
    texts = _texts(_said(clauses[at], words))
    said = texts in (["in", "their", "place"], ["in", "its", "place"], ["in", "their", "stead"])
    if not said or at + 1 >= len(clauses) or not at:
        return None
    following = _spread(clauses, at + 1, words, lexicon)
    if following is not None:
        return following
    return at + 2, f"add {joined(_said(clauses[at + 1], words))}" if clauses[at + 1].form == "fragment" else ""


def _swapped_topic(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> _Joined:
    """Put ``swap the red vase with the clock`` for ``red vase: swap places with the clock``."""
    if at + 1 >= len(clauses) or clauses[at].form != "fragment" or clauses[at + 1].form != "order":
        return None
    topic, order = (_said(clause, words) for clause in clauses[at : at + 2])
    texts = _texts(order)
    colon = words[clauses[at].end].text in (":", "-")
    if not colon or texts[:3] not in ([verb, "places", "with"] for verb in ("swap", "change", "exchange", "trade")):
        return None
    return at + 2, f"swap {_definite(topic)} with {joined(order[3:])}"


def _namely(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> _Joined:
    """Put ``remove the tables and the plant from the hall`` for ``remove the old stuff from the hall, i.e. ...``."""
    if at + 1 >= len(clauses) or clauses[at].form != "order":
        return None
    order, listed = (_said(clause, words) for clause in clauses[at : at + 2])
    if _texts(listed[:2]) != ["that", "is"] or len(listed) < 3:
        return None
    if listed[2].form == "base":
        return at + 2, joined(listed[2:])
    end = end_of_noun_group(order, 1)
    return (at + 2, f"{order[0].raw} {joined(listed[2:])} {joined(order[end:])}".strip()) if end > 1 else None


def _supplied(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> _Joined:
    """Put ``put a guitar on the stand in the hall`` for ``there is a stand in the hall but no guitar. Fix that.``."""
    for last in range(at + 1, min(at + 3, len(clauses))):
        order = _said(clauses[last], words)
        fixing = order[0].verb in ("fix", "change", "sort", "remedy", "mend", "correct") and len(order) <= 3
        if not (fixing and order[1:2] and order[1].text in ("that", "it", "this")):
            continue
        said = [*words[clauses[at].start : clauses[last - 1].end]]
        texts = _texts(said)
        but = next((k for k in range(3, len(said) - 1) if texts[k] == "but" and texts[k + 1] == "no"), 0)
        if texts[:1] != ["there"] or not but or said[1].tag != "be":
            return None
        missing = [word for word in said[but + 2 :] if word.text not in ("there", "on", "it", "in")]
        holder = end_of_noun_group(said, 2)
        noun = tuple(singular(word.text) for word in said[2:holder] if word.tag == "noun")
        if not missing or holder == 2 or not noun:
            return None
        where = "on" if lexicon.carries(noun) else "beside"
        named = [word for word in said[2:but] if word.text not in ("a", "an", ",")]
        return last + 1, f"put {_a(missing)} {where} the {joined(named)}"
    return None


def _a(words: Sequence[TaggedWord]) -> str:
    several = singular(words[-1].text) != words[-1].text
    article = "" if several else "an " if words[0].text[:1] in tuple("aeiou") else "a "
    return f"{article}{joined(words)}"


def _too_many(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> _Joined:
    """Put ``there should be exactly six chairs in the hall`` for ``eight chairs in the hall are too many, leave six``."""
    heading = clauses[at].form == "fragment" and names_something(_said(clauses[at], words), lexicon)
    told = at + 1 if heading and at + 1 < len(clauses) and words[clauses[at].start].tag != "number" else at
    counted = _counted(clauses, told, words, lexicon)
    if counted is None:
        return None
    number, named = counted
    for last in range(told, min(told + 4, len(clauses))):
        left = _left(_said(clauses[last], words), number, own=last == told)
        if left:
            return last + 1, f"there should be exactly {left} {named}"
        if last > told and clauses[last].form == "order":
            return None
    return None


def _counted(
    clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon
) -> tuple[TaggedWord, str] | None:
    """Return the number of things that a clause tells of, and these with their place: ``chairs in the hall``."""
    said = _said(clauses[at], words)
    there = next((k for k, word in enumerate(said) if word.tag == "there"), None)
    room = [*said[:there]] if there is not None and there and said[0].tag == "preposition" else []
    start = 0 if there is None else there + 2
    if there is None and clauses[at].form not in ("statement", "fragment"):
        return None
    if start >= len(said) or said[start].tag != "number":
        return None
    be = next((k for k in range(start + 1, len(said)) if said[k].tag in ("be", "modal")), len(said))
    named = [word for word in said[start + 1 : be] if word.tag not in ("adverb", "interjection")]
    if not names_something(named, lexicon) or not _objects(clauses, at, words, be - start):
        return None
    if not room and at and not any(word.tag == "preposition" for word in named):
        before = _said(clauses[at - 1], words)
        heading = clauses[at - 1].form == "fragment" and names_something(before, lexicon)
        in_it = f"in the {joined(before).lower()}" if before[0].tag == "noun" else f"in {joined(before).lower()}"
        return said[start], f"{joined(named)} {in_it if heading else ''}".strip()
    return said[start], f"{joined(named)} {joined(room).lower()}".strip()


def _objects(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], start: int) -> bool:
    """Whether a number is said to be too large, or a smaller one follows after a reason."""
    whole = words[clauses[at].start : clauses[min(at + 3, len(clauses) - 1)].end]
    texts = _texts(whole)
    return any(pair in (["too", "many"], ["too", "much"]) for pair in (texts[k : k + 2] for k in range(len(texts)))) or (
        "so" in texts or clauses[at].form == "existence"
    )


def _left(said: Sequence[TaggedWord], number: TaggedWord, *, own: bool) -> str:
    """Return the number that a clause says shall be left: ``leave 36``, ``so three``, ``halve them``; else nothing."""
    texts = [word.text for word in said if word.tag not in ("interjection",) and word.text not in ("just", "only", "so")]
    tail = _texts(said)
    if len(tail) > 2 and tail[-2] == "so" and said[-1].tag == "number":
        return tail[-1]
    if own:
        return ""
    if texts[:1] == ["halve"] or texts[:2] == ["half", "of"] or texts[:1] == ["half"]:
        value = _VALUES.get(number.text)
        whole = int(number.text) if number.text.isdecimal() else value
        return str(whole // 2) if whole else ""
    if len(texts) == 1 and said[-1].tag == "number":
        return texts[0]
    kept = len(texts) == 2 and texts[0] in ("leave", "keep") and said[-1].tag == "number"
    return texts[1] if kept else ""


_VALUES: Final = {
    word: value
    for value, word in enumerate(
        "zero one two three four five six seven eight nine ten eleven twelve thirteen fourteen fifteen sixteen "
        "seventeen eighteen nineteen twenty".split()
    )
}
_MISREAD: Final[tuple[_Rule, ...]] = (_none_on, _table_laid, _kept_elsewhere, _swapped_with_companions)
_RULES: Final[tuple[_Rule, ...]] = (
    _carried, _swapped_with_companions, _added_where_missing, _all_made_so, _exchanged, _too_many, _told_in_detail,
    _none_on, _not_needed, _left_only, _renamed_in_turn, _made_of, _table_laid, _given_finishes, _in_place_of_those, _spread, _contrasted, _swapped_topic, _namely, _supplied, _lined_with, _instead_of_some, _asked_of_room,
)  # fmt: skip
