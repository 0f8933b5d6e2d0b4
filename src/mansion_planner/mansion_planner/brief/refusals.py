"""Read what a brief names only to refuse it: "waived by the client", "not part of the programme", "but finally no".

What refuses stands right after the name, or in a later clause that points back to it: "this you may leave out".
"""

from collections.abc import Sequence

from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading

__all__ = ["refusal_after", "refused_before"]

_THINGS = ("room", "stair", "elevator", "object")
_COPULAS = frozenset("is are was were has have be been being will shall would to do does".split())
_ADVERBS = frozenset("express expressly explicit explicitly specifically finally definitely also already now".split())
_GIVEN_UP = frozenset(
    """
    waived excluded omitted cancelled canceled scrapped dropped shelved abandoned renounced forbidden prohibited banned
    disallowed vetoed ruled
    """.split()
)
_DEAR = frozenset({"expensive", "costly", "dear", "pricey"})
"""What is said of a thing that is not wanted for its price."""
_UNMADE = frozenset("coming come happening happen built made provided envisaged intended included installed".split())
_MAKING = frozenset("make build plan include put do want need have install draw add foresee provide".split())
_SUBJECTS = frozenset("we i they one you".split())
_BRIEFS = frozenset("programme program brief project scope plan design order contract work commission".split())
_CLOSING = frozenset({",", ")", "and", "but", "because", "since", "as", "either", "at", "this", "nor"})

_POINTERS = frozenset("one any it that them this these those which".split())
_TAILS = frozenset("inside indoors in there here either please again at all".split())
_LEAVING = (("leave", "out"), ("leave", "away"), ("leave", "aside"), ("skip",), ("omit",), ("drop",), ("forget",))
_MAY = frozenset("may can could should must might please".split())
_LAST = (("in", "the", "end"), ("after", "all"), ("finally",), ("at", "last"), ("eventually",), ("then",), ("sadly",))
_PROPOSALS = frozenset(
    """
    tell telling told ask asking asked suggest suggesting suggested propose proposing proposed insist insisting insisted
    urge urging urged advise advising advised recommend recommending recommended beg begging begged wished
    """.split()
)
"""Verbs of others, who want what the writer does not."""
_TOPICS = (("as", "for"), ("as", "to"), ("as", "regard"), ("regarding",), ("concerning",))


def refusal_after(reading: Reading, index: int) -> int:
    """Return where words that refuse what is named before token `index` end; `index` where there are none."""
    at = index
    while reading.word(at) in _COPULAS | _ADVERBS:
        at += 1
    if at > index and reading.word(at) in ("too", "far") and not _DEAR.isdisjoint(reading.words(at, at + 3)):
        end = next(k for k in range(at, at + 3) if reading.word(k) in _DEAR) + 1
        end += 3 * (reading.words(end, end + 3) == ("in", "the", "end"))
        return end if _closes(reading, end) else index
    if reading.word(at) in _GIVEN_UP:
        end = _agent_end(reading, at + 1)
        return end if _closes(reading, end) else index
    if reading.word(at) in ("not", "no"):
        after = _outside_end(reading, at + 1)
        if after == at + 1 and reading.word(at) == "not" and reading.word(after) in _UNMADE:
            after += 1
            return after if _closes(reading, after) else index
        return after if after > at + 1 and _closes(reading, after) else index
    if reading.words(at, at + 2) == ("out", "of") and at > index:
        end = _brief_end(reading, at + 2)
        return end if _closes(reading, end) else index
    if at == index and reading.word(at) in _SUBJECTS and reading.word(at + 1) == "not":
        end = at + 3
        return end if reading.word(at + 2) in _MAKING and _closes(reading, end) else index
    return index


def _outside_end(reading: Reading, index: int) -> int:
    """Return where "part of the programme", "belong to the brief", "in the scope" end; `index` for none of them."""
    for words in (("part", "of"), ("belong", "to"), ("in",), ("within",)):
        last = index + len(words)
        if reading.words(index, last) == words:
            end = _brief_end(reading, last)
            return end if end > last else index
    return index


def _brief_end(reading: Reading, index: int) -> int:
    """Return where "the programme", "our brief", "scope" end; `index` where a token begins none of them."""
    at = index + (reading.word(index) in ("the", "our", "this", "my"))
    return at + 1 if reading.word(at) in _BRIEFS else index


def _agent_end(reading: Reading, index: int) -> int:
    """Return where "by the client" ends; `index` where nobody is named."""
    if reading.word(index) != "by" or reading.kind(index + 1) == "number":
        return index
    at = index + 1 + (reading.word(index + 1) in ("the", "our", "a", "my"))
    return at + 1 if reading.kind(at) == "word" else index


def _closes(reading: Reading, index: int) -> bool:
    """Whether a statement is complete before a token: nothing follows that would make it one about a place."""
    return reading.breaks(index) or (reading.word(index) in _CLOSING and reading.word(index + 1) != "least")


def refused_before(reading: Reading, phrases: Sequence[Phrase]) -> dict[int, tuple[int, int]]:
    """Return the phrases that a later clause refuses, each with the tokens of both (first, last).

    "We discussed a terrace, but finally no", "a fountain was wished; this you may leave out", "they suggest a lift; we
    shan't". The words in between, where they name nothing else, only comment on it.
    """
    found: dict[int, tuple[int, int]] = {}
    for index in range(len(reading.tokens)):
        end = _pointing_end(reading, index) or _settled_end(reading, index)
        across = not end
        end = end or _unwilling_end(reading, index)
        number = _antecedent(reading, phrases, index, proposed=across) if end else None
        if number is None:
            continue
        phrase = phrases[number]
        between = [p for p in phrases if phrase.last <= p.first < index and p.head != "unknown"]
        reading.take(index if between else phrase.last, end)
        reading.take(_proposer(reading, phrases, number), phrase.first)
        found[number] = (phrase.first, end)
    return found


def _pointing_end(reading: Reading, index: int) -> int:
    """Return where "don't put any", "there will not be one", "this you may leave out" end, which end a clause; or 0."""
    at = index
    if reading.word(at) == "there":
        at += 1
        while reading.word(at) in ("will", "shall", "is", "are", "be", "not"):
            at += 1
        denied = "not" in reading.words(index + 1, at)
        return at + 1 if denied and reading.word(at) in ("one", "any") and reading.breaks(at + 1) else 0
    if reading.word(at) == "not" and reading.word(at + 1) in _MAKING and reading.word(at + 2) in _POINTERS:
        end = at + 3
        while reading.word(end) in _TAILS:
            end += 1
        return end if reading.breaks(end) else 0
    return _leaving_end(reading, index) or _left_out_end(reading, index)


def _left_out_end(reading: Reading, index: int) -> int:
    """Return where "I do not, so leave it out", "so drop it", "but I don't" end, which end a clause; or 0."""
    at = index
    if reading.word(at) in ("i", "we", "me", "us"):
        at += 1
        at += reading.word(at) in ("do", "would", "will")
        if reading.word(at) != "not":
            return 0
        at += 1 + (reading.word(at + 1) in ("want", "need"))
        if reading.breaks(at):
            return at
        at += reading.word(at) in (",", "-", "–", ";")
    at += reading.word(at) in ("so", "please", "and", "therefore")
    at += reading.word(at) in ("please", "just")
    for words in _LEAVING:
        pointed = reading.word(at + 1) in ("it", "that", "them", "this")
        if (
            at > index
            and reading.word(at) == words[0]
            and pointed
            and reading.words(at + 2, at + 1 + len(words)) == words[1:]
        ):
            end = at + 1 + len(words)
            return end if _closes(reading, end) or reading.breaks(end) else 0
    return 0


def _leaving_end(reading: Reading, index: int) -> int:
    """Return where "this you may leave out", "you can skip it", "which please omit" end, which end a clause; or 0."""
    at, pointed = index, reading.word(index) in _POINTERS
    at += pointed
    start = at
    while reading.word(at) in _SUBJECTS | _MAY:
        at += 1
    if at == start or _MAY.isdisjoint(reading.words(start, at)):
        return 0
    for words in _LEAVING:
        if reading.word(at) != words[0]:
            continue
        end = at + 1
        if not pointed and reading.word(end) not in _POINTERS:
            return 0
        end += not pointed
        if reading.words(end, end + len(words) - 1) == words[1:]:
            end += len(words) - 1
            return end if _closes(reading, end) else 0
    return 0


def _settled_end(reading: Reading, index: int) -> int:
    """Return where "but finally no", "but in the end not" end, which end a sentence; or 0."""
    if reading.word(index) != "but":
        return 0
    at = index + 1
    for words in _LAST:
        if reading.words(at, at + len(words)) == words:
            at += len(words)
            break
    at += reading.word(at) == ","
    return at + 1 if reading.word(at) in ("no", "not") and reading.breaks(at + 1) else 0


def _unwilling_end(reading: Reading, index: int) -> int:
    """Return where "we shan't", "we will not" end, which end a sentence; or 0."""
    if reading.word(index) not in ("we", "i") or reading.word(index - 1) not in ("", ",", ";", "but", "and", ".", "–"):
        return 0
    if reading.word(index + 1) == "shan":
        end = index + 2
    elif reading.word(index + 1) in ("will", "shall", "do") and reading.word(index + 2) == "not":
        end = index + 3
    else:
        end = index + 2 if reading.word(index + 1) == "not" else 0
    return end if end and reading.breaks(end) else 0


def _antecedent(reading: Reading, phrases: Sequence[Phrase], index: int, *, proposed: bool) -> int | None:
    """Return what a clause at a token points back to: what its sentence is about, else what is named last.

    What is `proposed` by others may be named in the sentence before.
    """
    sentence = reading.sentence[index]
    for here in (sentence, sentence - 1):
        before = [
            n
            for n, p in enumerate(phrases)
            if p.last <= index and reading.sentence[p.first] == here and p.head in _THINGS
        ]
        if not before:
            continue
        if proposed:
            return before[-1] if _proposer(reading, phrases, before[-1]) < phrases[before[-1]].first else None
        if here != sentence:  # "a sauna was discussed; you may skip it", but not where several may be meant
            return before[0] if len(before) == 1 else None
        about = _topic_start(reading, reading.sentence.index(here))
        return next((n for n in before if phrases[n].first == about), before[-1])
    return None


def _proposer(reading: Reading, phrases: Sequence[Phrase], number: int) -> int:
    """Return where words begin that say who proposes a thing, "our dean wished", or where the thing itself does."""
    first = phrases[number].first
    start = reading.sentence.index(reading.sentence[first])
    start = max([start, *[p.last for p in phrases[:number] if p.head in (*_THINGS, "building")]])
    return start if not _PROPOSALS.isdisjoint(reading.words(start, first)) else first


def _topic_start(reading: Reading, start: int) -> int:
    """Return where what a sentence is about begins: after "as for", or at the sentence's own first word."""
    return next((start + len(t) for t in _TOPICS if reading.words(start, start + len(t)) == t), start)
