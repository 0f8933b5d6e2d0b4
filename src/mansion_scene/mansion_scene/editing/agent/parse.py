"""Instructions to facts, by rules: clauses by their verbs, then things and places by their words."""

import re
from typing import Final

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_scene.editing.agent.facts import (
    AbsentFact,
    Fact,
    MoveFact,
    ObjectFact,
    PathFact,
    Scope,
    StateFact,
    Thing,
)
from mansion_scene.editing.agent.phrases import Phrase, read_phrase
from mansion_scene.editing.references import place_named
from mansion_scene.editing.state import SceneState

__all__ = ["MOST_CLAUSES", "parse_instruction"]

MOST_CLAUSES: Final = 24

_THERE = r"(?:that )?(?:there )?(?:is|are|be|exists|exist|should be|must be|has to be|have to be|needs to be|will be)"
_SEE = r"(?:please )?(?:make sure|ensure|check|verify|see|provide|confirm)?(?: that)?"
_VERBS: Final[tuple[tuple[str, str], ...]] = (
    ("path", rf"{_SEE}(?: there (?:is|are|should be|must be))?(?: also)? ?"
        r"(?:a |an |the )?(?:clear |free |open )?(?:way|path|route|access|connection)\b"),
    ("path", rf"{_SEE} ?(?:the |a )?(?:robot|one|you|people|someone|anyone) "
        r"(?:can|could|is able to|should be able to) (?:get|go|walk|drive|reach|travel|move)\b"),
    ("absent", r"(?:please )?(?:make sure|ensure) (?:that )?(?:there (?:is|are)) (?:no|not any|none of)\b"),
    ("absent", r"there (?:should|must) (?:be no|not be any)\b"),
    ("absent", r"(?:please )?(?:remove|delete|take away|get rid of|throw away|discard|take)\b"),
    ("clear", r"(?:please )?(?:clear|empty|tidy)(?: off| out| up)?\b"),
    ("state:open:1", r"(?:please )?(?:open)\b"),
    ("state:open:0", r"(?:please )?(?:close|shut)\b"),
    ("state:on:1", r"(?:please )?(?:turn on|switch on|power on)\b"),
    ("state:on:0", r"(?:please )?(?:turn off|switch off|power off)\b"),
    ("move", r"(?:please )?(?:move|relocate|transfer|carry)\b"),
    ("have", rf"(?:please )?(?:make sure|ensure|check|verify|see to it|guarantee)(?: {_THERE})?\b"),
    ("have", r"there (?:is|are|should be|must be|has to be|have to be|needs to be|shall be)\b"),
    ("have", r"(?:please )?(?:put|place|add|provide|set|lay|leave|bring|supply|stock|i need|we need|i want)\b"),
)  # fmt: skip
_SPLIT: Final = re.compile(
    r"(?:\s*[,;]\s*(?:and\s+)?(?:then\s+)?|\s+and\s+(?:then\s+)?|\s+then\s+|\.\s+|\n+)"
)


def parse_instruction(state: SceneState, instruction: str) -> list[Fact]:
    """Return the facts that an instruction asks for, in its order.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for what is no instruction, ``NOT_FOUND`` for words that name nothing, ``INFEASIBLE`` for
        more than is allowed. Nothing is guessed: an instruction is understood whole or refused.
    """
    clauses = _clauses(" ".join(instruction.split()))
    if not clauses:
        raise _not_understood(instruction)
    if len(clauses) > MOST_CLAUSES:
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"the instruction asks for {len(clauses)} things; at most {MOST_CLAUSES} in one go",
        )
    facts: list[Fact] = []
    waiting: list[tuple[str, Phrase]] = []
    for verb, rest in clauses:
        if verb == "have":
            waiting.append((verb, _have(state, rest)))
            if waiting[-1][1].placed:
                facts += _flush(waiting)
            continue
        facts += _flush(waiting)
        facts.append(_fact(state, verb, rest))
    return facts + _flush(waiting)


def _clauses(text: str) -> list[tuple[str, str]]:
    """Return (verb, the rest) pairs; a piece without a verb continues the clause before it."""
    out: list[tuple[str, str]] = []
    for piece in _SPLIT.split(text.strip(" .;,!")):
        words = piece.strip()
        if not words:
            continue
        inverted = re.match(
            r"^((?:on|in|inside)\b.+?),? there (?:is|are|should be|must be) (.+)$", words, re.I
        )
        if inverted:
            words = f"there is {inverted[2]} {inverted[1]}"
        for verb, pattern in _VERBS:
            match = re.match(pattern, words, re.IGNORECASE)
            if match:
                out.append((verb, words[match.end() :].strip()))
                break
        else:
            if not out:
                raise _not_understood(text)
            out.append((out[-1][0], words))
    return out


def _not_understood(text: str) -> MansionError:
    return MansionError(
        ErrorCode.INVALID_PAYLOAD,
        f"not understood: {text[:120]!r}; say what is to be there "
        '("make sure there is a cola in the fridge on floor 2"), '
        'to be gone ("remove the pens from the table"), moved, opened, closed, switched, or reached',
        path="$.instruction",
    )


def _have(state: SceneState, rest: str) -> Phrase:
    phrase = read_phrase(state, re.sub(r"\b(?:to|for)\b", "in", rest, flags=re.IGNORECASE))
    if not phrase.thing.noun:
        raise _not_understood(rest)
    return phrase


def _flush(waiting: list[tuple[str, Phrase]]) -> list[Fact]:
    """Things without a place stand where the next thing with one does."""
    if not waiting:
        return []
    where = waiting[-1][1].where
    facts: list[Fact] = []
    for _, phrase in waiting:
        thing = phrase.thing
        count = max(1, thing.count)
        own = phrase.where if phrase.placed else where
        if thing.cold and not own.receptacle:
            own = Scope("in", "fridge", own.rooms, own.floor)
        facts.append(ObjectFact(Thing(thing.noun, count, thing.colour, thing.cold), own))
    waiting.clear()
    return facts


def _fact(state: SceneState, verb: str, rest: str) -> Fact:
    if verb == "path":
        return _path(state, rest)
    if verb == "move":
        return _move(state, rest)
    if verb == "clear":
        phrase = read_phrase(state, f"things on {rest}")
        if not phrase.where.receptacle:
            raise _not_understood(f"clear {rest}")
        return AbsentFact(
            Thing("", 0),
            Scope("on", phrase.where.receptacle, phrase.where.rooms, phrase.where.floor),
        )
    if verb == "absent":
        text = re.sub(r"\b(?:off|from|out of)\b", "on", rest, count=1, flags=re.IGNORECASE)
        phrase = read_phrase(state, text)
        if not phrase.thing.noun and not phrase.where.receptacle:
            raise _not_understood(f"remove {rest}")
        return AbsentFact(phrase.thing, phrase.where)
    _, name, value = verb.split(":")
    phrase = read_phrase(state, rest)
    if not phrase.thing.noun:
        raise _not_understood(rest)
    return StateFact(phrase.thing, phrase.where, "open" if name == "open" else "on", value == "1")


def _path(state: SceneState, rest: str) -> PathFact:
    text = rest.strip(" .")
    match = re.match(r"^(?:from (?P<start>.+?) )?(?:to|into|towards) (?P<end>.+)$", text, re.I)
    other = re.match(r"^(?:to (?P<end>.+?) )?from (?P<start>.+)$", text, re.I)
    plain = re.match(r"^(?P<end>.+)$", text)
    if not text:
        return PathFact()
    found = match or other or plain
    ends = {name: (found.groupdict().get(name) or "") if found else "" for name in ("start", "end")}
    if match and not ends["start"]:
        tail = re.match(r"^(.+?) from (.+)$", ends["end"], re.I)
        if tail:
            ends = {"end": tail[1], "start": tail[2]}
    named = {name: _place(state, words) for name, words in ends.items()}
    return PathFact(named["start"], named["end"])


def _place(state: SceneState, words: str) -> str:
    bare = re.sub(r"^(?:the|a|an|any)\s+", "", words.strip(" ,.;!?\"'"), flags=re.IGNORECASE)
    if bare.lower() in ("", "entrance", "main entrance", "front door"):
        return ""
    if re.match(r"^(?:every|each|all)\b", bare, re.IGNORECASE):
        return ""
    try:
        return (
            place_named(state, bare, "$.instruction")[1]
            if "/" in bare
            else _first_place(state, bare)
        )
    except MansionError as error:
        if error.code != ErrorCode.CONFLICT:
            raise
        return str(error.info.details["candidates"][0])


def _first_place(state: SceneState, words: str) -> str:
    floor, name = place_named(state, words, "$.instruction")
    is_core = any(core.id == name for core in state.scenes[floor].cores)
    return words if is_core else name


def _move(state: SceneState, rest: str) -> MoveFact:
    match = re.match(
        r"^(?P<what>.+?)(?: from (?P<source>.+?))? (?:to|onto|into|on to|in to) (?P<target>.+)$",
        rest,
        re.I,
    )
    if match is None:
        raise _not_understood(f"move {rest}")
    source = f" on {match['source']}" if match["source"] else ""
    phrase = read_phrase(state, match["what"] + source)
    inward = re.search(
        r"\b(?:into|in to)\b",
        rest[match.end("source") if match["source"] else match.end("what") : match.start("target")],
        re.I,
    )
    target = read_phrase(state, f"things {'in' if inward else 'on'} {match['target']}")
    if not phrase.thing.noun or not target.placed:
        raise _not_understood(f"move {rest}")
    thing = phrase.thing
    return MoveFact(
        Thing(thing.noun, max(1, thing.count), thing.colour), phrase.where, target.where
    )
