"""Questions and remarks with the order that depends on them: ``is there a lamp in every room? Add one where not``."""

from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.verb_words import BY_WORDS
from mansion_editing.instructions.syntax.clauses import Clause
from mansion_editing.instructions.syntax.noun_groups import end_of_noun_group
from mansion_editing.instructions.syntax.pairs.wording import (
    IT,
    Joined,
    names_only_room,
    said_in,
    texts_of,
    with_article,
    with_the,
)
from mansion_editing.instructions.syntax.tagged_words import TaggedWord, joined
from mansion_language.inflection import singular

__all__ = ["added_where_missing", "all_made_so", "asked_of_room", "supplied"]

_MISSING: Final = (
    ["where", "it", "is", "missing"], ["where", "there", "is", "none"], ["where", "they", "are", "missing"],
    ["where", "one", "is", "missing"], ["where", "it", "is", "lacking"], ["where", "there", "is", "not"],
    ["where", "there", "are", "none"], ["where", "missing"], ["where", "needed"],
)  # fmt: skip


def added_where_missing(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Put ``there should be a lamp in every room`` for ``is there one in every room? Add one where it is missing``."""
    if at + 1 >= len(clauses):
        return None
    asked, order = (said_in(clause, words) for clause in clauses[at : at + 2])
    texts = texts_of(order)
    exists = texts_of(asked[:2]) in (["is", "there"], ["are", "there"]) and len(asked) > 3
    every = any(word.text in ("every", "each", "all", "both") for word in asked)
    adding = BY_WORDS.get((order[0].verb,)) in ("add", "bring") and len(texts) > 2 and texts[1] in ("one", "some")
    if not (exists and every and adding and texts[2:] in _MISSING):
        return None
    return at + 2, f"there should be {joined(asked[2:])}"


def all_made_so(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Put ``all lockers should be shut`` for ``are all lockers shut? If one of them is not, shut it``."""
    if at + 2 >= len(clauses):
        return None
    asked, condition, order = (said_in(clause, words) for clause in clauses[at : at + 3])
    subject = end_of_noun_group(asked, 1)
    if asked[0].tag != "be" or subject < 3 or asked[1].text not in ("all", "both", "the", "every"):
        return None
    if condition[0].text != "if" or condition[-1].text not in ("not", "so") or len(condition) > 7:
        return None
    if order[0].form != "base" or len(order) != 2 or order[1].text not in IT or condition[-1].text == "so":
        return None
    return at + 3, f"{joined(asked[1:subject])} should be {joined(asked[subject:])}"


def asked_of_room(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Put ``how many beds are there in the hall? Is there ... in the hall?`` for ``hall: how many beds, and ...?``."""
    first = clauses[at]
    said = said_in(first, words)
    rest = [one for one in clauses[at + 1 :] if one.sentence == first.sentence]
    colon = first.end < len(words) and words[first.end].text == ":"
    if first.form != "fragment" or not rest or not colon or not names_only_room(said, lexicon):
        return None
    asked = []
    for one in rest:
        texts = texts_of(said_in(one, words))
        counts = texts[:2] == ["how", "many"]
        if not counts and texts[:2] not in (["is", "there"], ["are", "there"]):
            return None
        verb = " are there" if counts and not {"are", "is"} & {*texts} else ""
        asked.append(f"{joined(said_in(one, words))}{verb} in {with_the(said)}")
    return at + 1 + len(rest), "? ".join(asked)


def supplied(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Put ``put a guitar on the stand in the hall`` for ``there is a stand in the hall but no guitar. Fix that.``."""
    for last in range(at + 1, min(at + 3, len(clauses))):
        order = said_in(clauses[last], words)
        fixing = order[0].verb in ("fix", "change", "sort", "remedy", "mend", "correct") and len(order) <= 3
        if not (fixing and order[1:2] and order[1].text in ("that", "it", "this")):
            continue
        said = [*words[clauses[at].start : clauses[last - 1].end]]
        texts = texts_of(said)
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
        return last + 1, f"put {with_article(missing)} {where} the {joined(named)}"
    return None
