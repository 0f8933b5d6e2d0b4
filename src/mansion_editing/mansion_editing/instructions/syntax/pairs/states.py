"""What shall be on or off, and what is not needed, in clauses that deny."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.syntax.clauses import Clause
from mansion_editing.instructions.syntax.noun_groups import end_of_noun_group
from mansion_editing.instructions.syntax.pairs.wording import Joined, said_in, texts_of
from mansion_editing.instructions.syntax.requests import names_something
from mansion_editing.instructions.syntax.tagged_words import TaggedWord, joined
from mansion_language.inflection import plural, singular

__all__ = ["contrasted", "none_on", "not_needed"]

_RUNNING: Final = frozenset("run burn glow shine be".split())


def contrasted(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Put ``the lamps should be on and the pendants should be off`` for ``the lamps should burn, the pendants not``."""
    if clauses[at].form != "statement":
        return None
    told = said_in(clauses[at], words)
    comma = next((k for k in range(len(told) - 1, 2, -1) if told[k].text == ","), 0)
    within = told[-1].text == "not" and comma > 0
    if within:
        told, other = told[:comma], told[comma + 1 :]
    elif at + 1 < len(clauses) and clauses[at + 1].form == "fragment":
        other = said_in(clauses[at + 1], words)
    else:
        return None
    modal = next((k for k in range(1, len(told) - 1) if told[k].text in ("should", "must", "shall")), 0)
    running = bool(modal) and (
        told[modal + 1].verb in _RUNNING - {"be"} or texts_of(told[modal + 1 : modal + 3]) == ["be", "on"]
    )
    if not running or other[-1].text != "not" or not any(word.tag == "noun" for word in other):
        return None
    return at + 2 - within, f"{joined(told[:modal])} should be on and {joined(other[:-1])} should be off"


_ON: Final = frozenset("on running burning lit".split())


def none_on(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Put ``turn off all lights upstairs`` for ``no light on upstairs``, which takes none away."""
    said = said_in(clauses[at], words)
    if texts_of(said[:1]) == ["nothing"] and texts_of(said[1:4]) in (["should", "be", "on"], ["must", "be", "on"]):
        return at + 1, f"turn off everything {joined(said[4:])}".strip()
    start = next((k for k, word in enumerate(said) if word.text == "no"), -1)
    end = end_of_noun_group(said, start + 1) if start >= 0 else 0
    told = start == 0 or texts_of(said[:start]) in (["there", "should", "be"], ["there", "must", "be"])
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


def not_needed(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Put ``remove the second toaster`` for ``we do not need the second toaster``."""
    said = said_in(clauses[at], words)
    texts = texts_of(said)
    denied = texts[:4] in (["we", "do", "not", "need"], ["i", "do", "not", "need"], ["we", "do", "not", "want"],
                           ["nobody", "needs", *texts[2:4]], ["no", "one", "needs", *texts[3:4]])  # fmt: skip
    start = 4 if texts[1:3] == ["do", "not"] else 3 if texts[:2] == ["no", "one"] else 2
    end = end_of_noun_group(said, start)
    definite = start < len(said) and said[start].text in ("the", "this", "that", "these", "those")
    if not denied or not definite or not names_something(said[start:end], lexicon):
        return None
    stop = next((k for k in range(end, len(said)) if said[k].text in ("any", "anymore", "at", "now")), len(said))
    if any(word.is_finite or word.tag == "to" for word in said[end:stop]):
        return None
    return at + 1, f"remove {joined(said[start:stop])}"
