"""Sentences of an instruction: brought to plain words by paraphrases, and divided into clauses by patterns."""

import re
from dataclasses import dataclass, field
from typing import Final

from mansion_editing.agent.sentence_patterns import (
    AT,
    CLAUSES,
    CLEARED,
    CONJUNCTIONS,
    CONTRACTIONS,
    COURTESIES,
    EMPTY,
    ENCLOSED,
    EXAMPLES,
    EXPRESSIONS,
    FETCH,
    FRAMES,
    FRONTED_PLACE,
    OPENINGS,
    PARAPHRASES,
    QUESTION,
    REASONS,
    REMAINDER,
    REPETITION,
    REQUEST,
    SENTENCE_ENDS,
    SENTENCES,
    UNSUPPORTED,
    VAGUE,
)
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["Clause", "clauses_of", "ignored_adjectives", "not_understood", "plain_sentences", "refuse_unsupported"]

_OBJECT_FIRST: Final = re.compile(
    r"^(?:i|we) (?:want|would like|need|expect|require) (.+?) to (?=(?:be|have|contain|hold|stand|lie|stay|remain|go|"
    r"reach)\b)",
    re.IGNORECASE,
)
_BRING_IT: Final = re.compile(
    r"^(?:bring|take|carry|put|move) (?:it|them) (?:over )?(?:to|on|onto|in|into) (.+)$", re.IGNORECASE
)

_PLACED: Final = re.compile(r" (?:on|onto|in|into|inside|at|next to|from|off|out of) ")


def not_understood(text: str) -> MansionError:
    """Return the error for words that are no request."""
    return MansionError(ErrorCode.INVALID_PAYLOAD, f"not understood: {text[:120]!r}; {EXAMPLES}", path="$.instruction")


def refuse_unsupported(instruction: str) -> None:
    """Refuse an instruction that asks for what no tool does, rather than do a part of it.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD``, naming the words and what is accepted.
    """
    text = " ".join(instruction.split())
    for pattern, reason in UNSUPPORTED:
        match = pattern.search(text)
        if match:
            words = match.groupdict().get("word") or match.group()
            raise MansionError(
                ErrorCode.INVALID_PAYLOAD,
                f"not understood: {words.strip(' ,.;:')[:80]!r}: {reason}; {EXAMPLES}",
                path="$.instruction",
                details={"words": words[:80]},
            )


def ignored_adjectives(text: str) -> list[str]:
    """Return the adjectives of an instruction that are understood but that no scene describes.

    Examples
    --------
    >>> ignored_adjectives("put a small new mug on the clean desk, then empty the bin")
    ['small', 'new', 'clean']
    """
    found = " ".join(match["words"].lower() for match in VAGUE.finditer(text))
    return list(dict.fromkeys(found.split()))


def plain_sentences(text: str) -> list[str]:
    """Return the sentences of an instruction in the plain forms that clause patterns match.

    Sentences that only repeat the one before are left out.

    Examples
    --------
    >>> plain_sentences("Could you please put a couple of mugs on top of the desk? Thanks!")
    ['put two mugs on the desk']
    >>> plain_sentences("Grab the pen on the desk and put it on the sideboard.")
    ['move the pen on the desk to the sideboard']
    """
    whole = " ".join(SENTENCE_ENDS.sub(" ;; ", text.replace("’", "'").replace("`", "'")).split())
    out: list[str] = []
    for part in whole.split(";;"):
        sentence = _plain(part)
        if not sentence or (out and REPETITION.match(sentence)):
            continue
        for plain in _paraphrased(sentence):
            joined = _joined(out[-1], plain) if out else None
            out = [*out, plain] if joined is None else [*out[:-1], joined]
    return out


def _plain(text: str) -> str:
    """Drop courtesies, reasons and openings of a sentence; open contractions and replace expressions by plain ones."""
    for pattern, plain in CONTRACTIONS:
        text = re.sub(pattern, plain, text, flags=re.IGNORECASE)
    text = QUESTION.sub(lambda m: f"there is{m[2]}" if m[1] else f"{m[3]} can {m[4]}", text.strip(" ,.?!"))
    text = REASONS.sub("", COURTESIES.sub("", text))
    for pattern, plain in EXPRESSIONS:
        text = re.sub(pattern, plain, text, flags=re.IGNORECASE)
    text = " ".join(text.replace(" ,", ",").split()).strip(' ,.;!?"')
    before = ""
    while before != text:
        before, text = text, OPENINGS.sub("", text).strip(" ,")
    return text


def _paraphrased(text: str) -> list[str]:
    """Apply the paraphrases to one sentence; some make several sentences of it."""
    whole = FRAMES.sub("", re.sub(r"(?:\s*,)+", ",", text)).strip(" ,")
    fetch = FETCH.match(whole)
    if fetch:
        relation = "in" if ENCLOSED.search(fetch["y"].split(" in ")[0]) else "on"
        path = [f"there is a way to {fetch['z']}"] if fetch["z"] else []
        return [f"there is {fetch['x']} {relation} {fetch['y']}", *path]
    for pattern, plain in PARAPHRASES:
        whole = pattern.sub(plain, whole)
    parts = [" ".join(part.replace(" ,", ",").split()).strip(" ,") for part in whole.split(";;")]
    return [part for part in parts if part]


def _joined(before: str, text: str) -> str | None:
    """Return two sentences as one where the second completes the first (``clear X``, ``only Y may stay``)."""
    rest, cleared = REMAINDER.match(text), CLEARED.match(before)
    if rest and cleared:
        return f"remove everything from {cleared['place']} except {rest['kept']}"
    match = _BRING_IT.match(text)
    had = re.match(r"^there is (?:an?|the|one) (.+)$", before, re.IGNORECASE) if match else None
    if match is None or had is None or not _PLACED.search(had[1]):
        return None
    return f"move the {had[1]} to {match[1]}"


@dataclass(frozen=True)
class Clause:
    """What a piece of a sentence asks for.

    Attributes
    ----------
    kind : str
        ``have``, ``hold``, ``absent``, ``absent_on``, ``no``, ``clear``, ``state``, ``unstate``, ``move``, ``swap``,
        ``path``, ``reach``, ``quality``; for whole sentences ``only``, ``exchange``, ``mention`` and ``some``;
        ``place`` for a place alone; empty for a noun phrase whose verb is in the clause before or after.
    words : dict of str to str
        Parts of the clause: `x` objects, `y` a receptacle or room, `loc` a place, `z` a replacement, `a` and `b` the
        ends of a path, `v` a state.
    """

    kind: str
    words: dict[str, str] = field(default_factory=dict)


def clauses_of(sentence: str) -> list[Clause]:
    """Return the clauses of a plain sentence in their order."""
    for kind, pattern in SENTENCES:
        match = pattern.match(sentence)
        if match:
            return [Clause(kind, match.groupdict())]
    pieces = [piece.strip(" ,") for piece in CONJUNCTIONS.split(sentence)]
    return [clause for words in pieces if words for clause in _clauses(words)]


def _clauses(words: str) -> list[Clause]:
    fronted = FRONTED_PLACE.match(words)
    if fronted:
        return [Clause("place", {"loc": fronted["loc"].strip(" ,")}), *_clauses(fronted["rest"])]
    if EMPTY.match(words):
        return []
    bare = _OBJECT_FIRST.sub(r"\1 should ", words)
    requested = bare != words
    for _ in range(3):
        match = REQUEST.match(bare)
        if match is None:
            break
        requested, bare = True, bare[match.end() :]
    for kind, pattern in CLAUSES:
        found = pattern.match(bare)
        if found:
            return [Clause(kind, {name: (text or "").strip() for name, text in found.groupdict().items()})]
    if requested:
        return [Clause("have", {"x": bare})]
    if re.match(rf"^{AT}", bare, re.IGNORECASE):
        return [Clause("place", {"loc": bare})]
    return [Clause("", {"x": bare})]
