"""Numbers of things that are told, and how many of them shall be left: ``eight chairs are too many, leave six``."""

from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.syntax.clauses import Clause
from mansion_editing.instructions.syntax.pairs.wording import Joined, said_in, texts_of
from mansion_editing.instructions.syntax.requests import names_something
from mansion_editing.instructions.syntax.tagged_words import TaggedWord, joined

__all__ = ["too_many"]


def too_many(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon) -> Joined:
    """Put ``there should be exactly six chairs in the hall`` for ``eight chairs in the hall are too many, so six``."""
    heading = clauses[at].form == "fragment" and names_something(said_in(clauses[at], words), lexicon)
    told = at + 1 if heading and at + 1 < len(clauses) and words[clauses[at].start].tag != "number" else at
    counted = _counted(clauses, told, words, lexicon)
    if counted is None:
        return None
    number, named = counted
    for last in range(told, min(told + 4, len(clauses))):
        left = _left(said_in(clauses[last], words), number, own=last == told)
        if left:
            return last + 1, f"there should be exactly {left} {named}"
        if last > told and clauses[last].form == "order":
            return None
    return None


def _counted(
    clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], lexicon: Lexicon
) -> tuple[TaggedWord, str] | None:
    """Return the number of things that a clause tells of, and these with their place: ``chairs in the hall``."""
    said = said_in(clauses[at], words)
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
        before = said_in(clauses[at - 1], words)
        heading = clauses[at - 1].form == "fragment" and names_something(before, lexicon)
        in_it = f"in the {joined(before).lower()}" if before[0].tag == "noun" else f"in {joined(before).lower()}"
        return said[start], f"{joined(named)} {in_it if heading else ''}".strip()
    return said[start], f"{joined(named)} {joined(room).lower()}".strip()


def _objects(clauses: Sequence[Clause], at: int, words: Sequence[TaggedWord], start: int) -> bool:
    """Whether a number is said to be too large, or a smaller one follows after a reason."""
    whole = words[clauses[at].start : clauses[min(at + 3, len(clauses) - 1)].end]
    texts = texts_of(whole)
    return any(
        pair in (["too", "many"], ["too", "much"]) for pair in (texts[k : k + 2] for k in range(len(texts)))
    ) or ("so" in texts or clauses[at].form == "existence")


def _left(said: Sequence[TaggedWord], number: TaggedWord, *, own: bool) -> str:
    """Return the number that a clause says shall be left: ``leave 36``, ``so three``, ``halve them``; else nothing."""
    texts = [
        word.text for word in said if word.tag not in ("interjection",) and word.text not in ("just", "only", "so")
    ]
    tail = texts_of(said)
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
