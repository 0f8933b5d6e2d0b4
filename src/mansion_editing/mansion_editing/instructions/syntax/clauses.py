"""The clauses of an instruction: where each begins and ends, how it is built, and what it depends on."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final, Literal, TypeAlias

from mansion_editing.instructions.phrases.words import SENTENCE_ENDS
from mansion_editing.instructions.syntax.noun_groups import end_of_noun_group, finite_verb_after
from mansion_editing.instructions.syntax.tagged_words import TaggedWord

__all__ = ["TURNING", "Clause", "Form", "clauses_of"]

Form: TypeAlias = Literal["order", "statement", "existence", "question", "dependent", "fragment"]


@dataclass(frozen=True)
class Clause:
    """A clause of a text.

    Attributes
    ----------
    form : str
        ``order``: begins with a verb ("put ..."); ``statement``: a subject with a finite verb; ``existence``:
        "there is ..."; ``question``: the finite verb comes before the subject; ``dependent``: after a subordinator;
        ``fragment``: has no verb.
    start, end : int
        Its words, without the joint or marks around it.
    verb : int
        The place of its finite or ordering verb; `start` of a fragment.
    subject, subject_end : int
        Where its subject begins and ends; before `start` where it shares the one of the clause before: ``the rug is
        old and has to go``.
    after : str
        The mark or joint that it follows: ``,``, ``and``; empty at the beginning of a sentence.
    sentence : int
        The number of its sentence.
    """

    form: Form
    start: int
    end: int
    verb: int
    subject: int
    subject_end: int
    after: str
    sentence: int

    @property
    def shares_subject(self) -> bool:
        """Whether its subject stands in the clause before."""
        return self.subject < self.start


TURNING: Final = frozenset("turn rotate swivel spin twist point angle orient".split())
"""Verbs that what a thing faces belongs to: ``turn it so that it faces the wall``."""
_MARKS: Final = frozenset([",", "-", ":", "(", ")", "–", "—"])
_IDLE: Final = frozenset(["interjection", "adverb"])
_PLEAS: Final = frozenset(["can", "could", "would", "will"])


def clauses_of(words: Sequence[TaggedWord]) -> list[Clause]:
    """Return the clauses of a text in order."""
    found: list[Clause] = []
    for number, (first, last) in enumerate(_sentences(words)):
        found += _in_sentence(words, first, last, number)
    return found


def _sentences(words: Sequence[TaggedWord]) -> Iterator[tuple[int, int]]:
    first = 0
    for at, word in enumerate(words):
        if word.tag == "mark" and word.text in SENTENCE_ENDS:
            if at > first:
                yield first, at
            first = at + 1
    if first < len(words):
        yield first, len(words)


def _in_sentence(words: Sequence[TaggedWord], first: int, last: int, number: int) -> Iterator[Clause]:
    at, after = first, ""
    before: Clause | None = None
    while at < last:
        while at < last and (words[at].text in _MARKS or words[at].tag == "joint" or words[at].text == "oh"):
            after = words[at].text
            at += 1
        if at >= last:
            return
        form, verb, subject = _opening(words[:last], at)
        subject_end = verb
        if before is not None and before.form == "statement" and _goes_on(words[:last], at, form):
            form, verb, subject, subject_end = "statement", at, before.subject, before.subject_end
        end = _end(words[:last], max(at, verb), form)
        before = Clause(form, at, end, verb, subject, subject_end, after, number)
        yield before
        at, after = end, ""


def _goes_on(words: Sequence[TaggedWord], at: int, form: Form) -> bool:
    """Whether a verb without a subject begins a clause, and no order."""
    if form not in ("fragment", "question") or not words[at].is_finite or words[at].form == "base":
        return False
    subject = at + 1 < len(words) and words[at + 1].tag in ("determiner", "possessive", "somebody", "pronoun")
    return form == "fragment" or (words[at].tag in ("be", "have") and not subject)


def _end(words: Sequence[TaggedWord], at: int, form: Form) -> int:
    """Return the end of a clause whose verb stands at a place: where a mark or a joint comes before another one."""
    for k in range(at + 1, len(words)):
        word, following = words[k], k + 1
        if _is_range(words, k):
            continue
        if word.text in ("(", ")", ":") or (word.text in _MARKS and form == "fragment"):
            return k
        if word.text == "so" and words[at].verb in TURNING:
            continue
        if word.text in _MARKS or word.tag == "joint":
            while following < len(words) and (words[following].tag == "joint" or words[following].text in _MARKS):
                following += 1
            begins, verb, _ = _opening(words, following) if following < len(words) else ("fragment", 0, 0)
            if begins == "statement" and word.text in ("and", "or") and _may_go_on(words, at, following, verb):
                begins = "fragment"
            shared = form == "statement" and word.text != "-" and following < len(words)
            if shared and _goes_on(words, following, begins):
                return k
            if (
                begins != "fragment"
                or word.text in ("-", "–", "—")
                or (word.text == "," and _is_vague(words[at + 1 : k]))
            ):
                return k
            if following < len(words) and _adds_one_more(words, following):
                return k
            if word.text == "," and form != "fragment" and _is_aside(words, following):
                return k
        elif word.tag == "subordinator" and word.text not in ("that", "where", "whether", "until") and k > at + 1:
            if _opening(words, k)[0] == "dependent" and not _tells_how_it_is(words, k):
                return k
        elif word.text in ("too", "please", "oh") and following < len(words) and (form != "question" or k > at + 3):
            if words[following].tag == "joint" or _opening(words, following)[0] in ("statement", "order"):
                return k + (word.text != "oh")
        elif word.tag == "modal" and word.text in _PLEAS and k + 1 < len(words) and words[k + 1].text == "you":
            return k
    return len(words)


def _is_range(words: Sequence[TaggedWord], at: int) -> bool:
    """Whether a dash stands between two numbers: ``rooms 1-4``."""
    if words[at].text not in ("-", "–") or at + 1 >= len(words):
        return False
    touching = words[at - 1].end == words[at].start and words[at].end == words[at + 1].start
    return touching and words[at - 1].tag == words[at + 1].tag == "number"


def _adds_one_more(words: Sequence[TaggedWord], at: int) -> bool:
    """Whether a further thing comes at the end, for which the verb before is meant again: ``and the bucket too``."""
    while words[at].tag in _IDLE:
        at += 1
        if at >= len(words):
            return False
    end = end_of_noun_group(words, at)
    last = [word.text for word in words[-2:] if word.text != "please"]
    return end > at and words[at].tag in ("determiner", "possessive") and last[-1:] in (["too"], ["also"], ["well"])


def _may_go_on(words: Sequence[TaggedWord], verb: int, following: int, other: int) -> bool:
    """Whether what follows ``and`` may be one more subject or object: ``let the sofa and the chair change places``."""
    if words[other].form == "base":
        return words[verb].tag in ("modal", "do") or words[verb].verb == "let"
    named = words[following].tag not in ("somebody", "pronoun")
    return words[other].form == "past" and words[other].text not in _ONLY_PAST and named


def _is_vague(words: Sequence[TaggedWord]) -> bool:
    """Whether what follows a verb names nothing: ``(sort) that out``, after which a comma begins what is meant."""
    return bool(words) and words[0].tag == "pronoun" and all(w.tag in ("pronoun", "preposition") for w in words)


def _tells_how_it_is(words: Sequence[TaggedWord], at: int) -> bool:
    """Whether ``as it is``, ``as they are`` ends what shall stay so."""
    said = [word.text for word in words[at : at + 3]]
    return said[:1] == ["as"] and said[-1] in ("is", "are", "was", "were")


def _is_aside(words: Sequence[TaggedWord], at: int) -> bool:
    """Whether words after a comma begin with neither a thing nor a place, and so go on with no list."""
    if at >= len(words):
        return False
    leaving_open = words[at].text in _LEAVING_OPEN and at + 1 < len(words) and words[at + 1].tag == "somebody"
    return leaving_open or words[at].tag in ("interjection", "relative")


def _opening(words: Sequence[TaggedWord], at: int) -> tuple[Form, int, int]:
    """Return how the clause at a place is built, the place of its verb and that of its subject."""
    start = at
    while at < len(words) and words[at].tag in _IDLE:
        at += 1
    if at >= len(words):
        return "fragment", start, start
    word = words[at]
    following = words[at + 1] if at + 1 < len(words) else None
    if word.tag == "verb" and word.form == "base":
        return "order", at, at
    if word.tag == "do" and following is not None and (following.tag == "not" or following.form == "base"):
        return "order", at, at
    if word.tag == "subordinator" and word.text in _CONDITIONS:
        verb = next((k for k in range(at + 1, min(len(words), at + 12)) if words[k].is_finite), None)
        return ("dependent", verb, at + 1) if verb is not None else ("fragment", start, start)
    if word.text in _GRANTED and following is not None and following.text in ("that", "as"):
        verb = finite_verb_after(words, at + 2)
        return ("dependent", verb, at + 2) if verb is not None else ("fragment", start, start)
    exists = following is not None and (following.is_finite or following.text == "used")
    if word.tag == "there" and exists:
        return "existence", at + 1, at
    if word.tag == "be" and following is not None and following.tag == "there":
        return "question", at, at + 1
    if word.tag in ("modal", "be", "do", "have") and end_of_noun_group(words, at + 1) > at + 1:
        return "question", at, at + 1
    if word.tag == "subordinator" or (word.text in _ALSO_SUBORDINATE and word.tag in ("preposition", "joint")):
        verb = finite_verb_after(words, at + 1 + (following is not None and following.text == "that"))
        return ("dependent", verb, at + 1) if verb is not None else _statement(words, at, start)
    return _statement(words, at, start)


_ONLY_PAST: Final = frozenset(
    "went came broke fell gave took saw wore drove began was were did ate drank stole".split()
)
"""Past forms that are no participles."""
_LEAVING_OPEN: Final = frozenset("whichever whatever however".split())
_GRANTED: Final = frozenset("seeing given considering granted now".split())
_CONDITIONS: Final = frozenset("if unless whether".split())
_ALSO_SUBORDINATE: Final = frozenset("since until before after".split())


def _statement(words: Sequence[TaggedWord], at: int, start: int) -> tuple[Form, int, int]:
    at = _after_places(words, at)
    if at < len(words) and at > start and words[at].tag == "verb" and words[at].form == "base":
        return "order", at, at  # "in the hall, put ..."
    if at > start and at + 1 < len(words) and words[at].tag == "there" and words[at + 1].is_finite:
        return "existence", at + 1, at
    verb = finite_verb_after(words, at)
    return ("fragment", start, start) if verb is None else ("statement", verb, at)


def _after_places(words: Sequence[TaggedWord], at: int) -> int:
    """Return the place after the places and adverbs that a clause begins with."""
    while at < len(words) and words[at].tag in ("preposition", "adverb", "interjection"):
        placing = words[at].tag == "preposition"
        end = end_of_noun_group(words, at + 1) if placing else at + 1
        while placing and end < len(words) and words[end].tag == "adverb" and words[end - 1].tag != "noun":
            end += 1  # "since last week"
        if placing and end == at + 1:
            return at
        at = end + (end + 1 < len(words) and words[end].text == ",")
    return at
