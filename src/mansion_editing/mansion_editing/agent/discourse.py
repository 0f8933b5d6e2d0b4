"""Instructions to facts: sentences in plain words, their clauses in order, and what each refers to in the discourse."""

import re
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from typing import Final

from mansion_editing.agent import sentence_patterns as english
from mansion_editing.agent.facts import (
    AbsentFact,
    Fact,
    MoveFact,
    ObjectDescription,
    ObjectFact,
    Scope,
    StateFact,
    each_place,
)
from mansion_editing.agent.noun_phrases import (
    NUMBERS,
    NounPhrase,
    has_state,
    is_known,
    read_move,
    read_noun_phrase,
    read_place,
    rooms_named,
    typical_asset,
)
from mansion_editing.agent.path_phrases import path_facts
from mansion_editing.state import SceneState
from mansion_language.colours import COLOUR_WORDS
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["MOST_CLAUSES", "MOST_FACTS", "parse_instruction", "plain_sentences"]

MOST_CLAUSES: Final = 24
MOST_FACTS: Final = 60


def parse_instruction(state: SceneState, instruction: str) -> list[Fact]:
    """Return the facts that an instruction asks for, in its order.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for what is no instruction, ``NOT_FOUND`` for words that name nothing, ``INFEASIBLE`` for
        more than is allowed. Nothing is guessed: an instruction is understood whole or refused.
    """
    _refuse_unsupported(instruction)
    said = [_clauses_of(sentence) for sentence in plain_sentences(instruction)]
    number = sum(len(clauses) for clauses in said)
    if not number:
        raise _not_understood(instruction)
    if number > MOST_CLAUSES:
        raise MansionError(
            ErrorCode.INFEASIBLE, f"the instruction asks for {number} things; at most {MOST_CLAUSES} in one go"
        )
    reader = _Discourse(state)
    asked = [clauses for clauses in said if not _asks_nothing(state, clauses)] or said
    for clauses in asked:
        reader.read_sentence(clauses)
    if not reader.facts:
        raise _not_understood(instruction)
    if len(reader.facts) > MOST_FACTS:
        raise MansionError(
            ErrorCode.INFEASIBLE, f"the instruction asks for {len(reader.facts)} facts; at most {MOST_FACTS} in one go"
        )
    return list(dict.fromkeys(reader.facts))


def _not_understood(text: str) -> MansionError:
    """Return the error for words that are no request."""
    return MansionError(
        ErrorCode.INVALID_PAYLOAD, f"not understood: {text[:120]!r}; {english.EXAMPLES}", path="$.instruction"
    )


def _refuse_unsupported(instruction: str) -> None:
    """Refuse an instruction that asks for what no tool does, rather than do a part of it.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD``, naming the words and what is accepted.
    """
    text = " ".join(instruction.split())
    for pattern, reason in english.UNSUPPORTED:
        match = pattern.search(text)
        if match:
            words = match.groupdict().get("word") or match.group()
            raise MansionError(
                ErrorCode.INVALID_PAYLOAD,
                f"not understood: {words.strip(' ,.;:')[:80]!r}: {reason}; {english.EXAMPLES}",
                path="$.instruction",
                details={"words": words[:80]},
            )


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
    whole = " ".join(english.SENTENCE_ENDS.sub(" ;; ", text.replace("’", "'").replace("`", "'")).split())
    out: list[str] = []
    for part in whole.split(";;"):
        sentence = _plain(part)
        if not sentence or (out and english.REPETITION.match(sentence)):
            continue
        for plain in _paraphrased(sentence):
            joined = _joined(out[-1], plain) if out else None
            out = [*out, plain] if joined is None else [*out[:-1], joined]
    return out


def _plain(text: str) -> str:
    """Drop courtesies, reasons and openings of a sentence; open contractions and replace expressions by plain ones."""
    for pattern, plain in english.CONTRACTIONS:
        text = re.sub(pattern, plain, text, flags=re.IGNORECASE)
    text = english.QUESTION.sub(lambda m: f"there is{m[2]}" if m[1] else f"{m[3]} can {m[4]}", text.strip(" ,.?!"))
    text = english.REASONS.sub("", english.COURTESIES.sub("", text))
    for pattern, plain in english.EXPRESSIONS:
        text = re.sub(pattern, plain, text, flags=re.IGNORECASE)
    text = " ".join(text.replace(" ,", ",").split()).strip(' ,.;!?"')
    before = ""
    while before != text:
        before, text = text, english.OPENINGS.sub("", text).strip(" ,")
    return text


def _paraphrased(text: str) -> list[str]:
    """Apply the paraphrases to one sentence; some make several sentences of it."""
    whole = english.FRAMES.sub("", re.sub(r"(?:\s*,)+", ",", text)).strip(" ,")
    fetch = english.FETCH.match(whole)
    if fetch:
        relation = "in" if english.ENCLOSED.search(fetch["y"].split(" in ")[0]) else "on"
        path = [f"there is a way to {fetch['z']}"] if fetch["z"] else []
        return [f"there is {fetch['x']} {relation} {fetch['y']}", *path]
    for pattern, plain in english.PARAPHRASES:
        whole = pattern.sub(plain, whole)
    parts = [" ".join(part.replace(" ,", ",").split()).strip(" ,") for part in whole.split(";;")]
    return [part for part in parts if part]


def _joined(before: str, text: str) -> str | None:
    """Return two sentences as one where the second completes the first (``clear X``, ``only Y may stay``)."""
    rest, cleared = english.REMAINDER.match(text), english.CLEARED.match(before)
    if rest and cleared:
        return f"remove everything from {cleared['place']} except {rest['kept']}"
    match = english.BRING_IT.match(text)
    had = re.match(r"^there is (?:an?|the|one) (.+)$", before, re.IGNORECASE) if match else None
    if match is None or had is None or not english.PLACED.search(had[1]):
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


def _clauses_of(sentence: str) -> list[Clause]:
    """Return the clauses of a plain sentence in their order."""
    for kind, pattern in english.SENTENCES:
        match = pattern.match(sentence)
        if match:
            return [Clause(kind, match.groupdict())]
    pieces = [piece.strip(" ,") for piece in english.CONJUNCTIONS.split(sentence)]
    return [clause for words in pieces if words for clause in _clauses(words)]


def _clauses(words: str) -> list[Clause]:
    fronted = english.FRONTED_PLACE.match(words)
    if fronted:
        return [Clause("place", {"loc": fronted["loc"].strip(" ,")}), *_clauses(fronted["rest"])]
    if english.EMPTY.match(words):
        return []
    bare = english.OBJECT_FIRST.sub(r"\1 should ", words)
    requested = bare != words
    for _ in range(3):
        match = english.REQUEST.match(bare)
        if match is None:
            break
        requested, bare = True, bare[match.end() :]
    for kind, pattern in english.CLAUSES:
        found = pattern.match(bare)
        if found:
            return [Clause(kind, {name: (text or "").strip() for name, text in found.groupdict().items()})]
    if requested:
        return [Clause("have", {"x": bare})]
    if re.match(rf"^{english.AT}", bare, re.IGNORECASE):
        return [Clause("place", {"loc": bare})]
    return [Clause("", {"x": bare})]


def _asks_nothing(state: SceneState, clauses: list[Clause]) -> bool:
    """Whether a sentence has no clause and names no room and no object of the catalogue."""
    pieces = [clause.words.get("x", "") for clause in clauses if not clause.kind]
    if len(pieces) != len(clauses):
        return False
    words = {word for piece in pieces for word in re.findall(r"[a-z]+", piece.lower())}
    return not any(is_known(state, word) or rooms_named(state, word, None) for word in words)


class _Discourse:
    """Reads clauses in order, and keeps what the next words may refer to.

    Attributes
    ----------
    facts : list of Fact
        Facts so far.
    """

    def __init__(self, state: SceneState) -> None:
        self.state = state
        self.facts: list[Fact] = []
        self._pending: list[tuple[str, NounPhrase]] = []
        self._last: NounPhrase | None = None
        self._frame: Scope | None = None
        self._clause: Clause | None = None

    def read_sentence(self, clauses: Iterable[Clause]) -> None:
        """Read one sentence."""
        early: list[str] = []
        self._frame, self._clause = None, None
        for clause in clauses:
            if clause.kind == "place" and self._clause is None:
                self._frame = read_place(self.state, clause.words["loc"]).where.completed(self._frame)
            elif not clause.kind and self._clause is None:
                early.append(clause.words["x"])
            elif not clause.kind or clause.kind == "place":
                self._read_ellipsis(clause)
            else:
                for words in early:
                    self._read(Clause(clause.kind, {**clause.words, "x": words, "loc": ""}))
                early = []
                self._read(clause)
                self._clause = clause
        for words in early:
            self._defer("have", read_noun_phrase(self.state, words))
        if early and self._pending and self._frame is None:
            raise _not_understood(", ".join(early))
        self._flush()

    def _read_ellipsis(self, clause: Clause) -> None:
        """Read a clause whose verb is elided: more objects, or the same at another place."""
        before = self._clause
        words = clause.words.get("loc") or clause.words["x"]
        if before is None:
            raise _not_understood(words)
        things = english.INDEFINITE.match(words) and not rooms_named(
            self.state, english.INDEFINITE.sub("", words), None
        )
        if before.kind in ("path", "reach") and things:
            self._have(words)
            return
        if before.kind in ("path", "reach"):
            self._read(replace(before, words={**before.words, "b": words}))
            return
        if before.kind == "clear":
            self._read(Clause("clear", {"y": words}))
            return
        state = re.match(r"^(?:be |is |are |stays? |kept |left )?(open|closed|shut|on|off)$", words)
        if state and self._last is not None:
            self._flush()
            self._switch(replace(self._last, placed=True), state[1])
            return
        bare = re.sub(r"^(?:the|in|on)\s+", "", words)
        if before.kind == "have" and words.lower().startswith("the ") and self._names_furniture(words):
            self._repeat_elsewhere(f"on {words}")
            return
        if clause.kind == "place" or rooms_named(self.state, bare, None):
            self._repeat_elsewhere(words if clause.kind == "place" else f"in {words}")
            return
        if before.kind in ("state", "unstate") and english.INDEFINITE.match(words):
            self._flush()
            self._have(words)
            return
        self._read(replace(before, words={**before.words, "x": words, "loc": ""}))

    def _names_furniture(self, words: str) -> bool:
        """Whether words name furniture, and so another receptacle for the last object."""
        last = self.facts[-1] if self.facts else None
        if self._pending or not isinstance(last, ObjectFact) or not last.where.receptacle:
            return False
        noun = read_noun_phrase(self.state, words).object.noun
        asset = typical_asset(self.state, noun)
        return asset is not None and bool(asset.surfaces) and not asset.pickupable

    def _repeat_elsewhere(self, words: str) -> None:
        """Repeat the last fact at another place, or narrow its place."""
        self._flush()
        place = read_place(self.state, words).where
        last = self.facts[-1] if self.facts else None
        if not isinstance(last, ObjectFact | AbsentFact):
            raise _not_understood(words)
        closer = not place.receptacle and not last.where.rooms and last.where.floor is None
        if closer:
            self.facts[-1] = replace(last, where=last.where.completed(place))
            return
        same = place if place.receptacle else place.on_receptacle_of(last.where)
        self.facts.append(replace(last, where=same))

    def _read(self, clause: Clause) -> None:
        words, kind = clause.words, clause.kind
        if kind in ("path", "reach"):
            self._flush()
            end = words.get("b") or words.get("c") or ""
            ways = path_facts(self.state, end, words.get("a", ""))
            self.facts += ways
            ends = tuple(way.end for way in ways if self.state.room(way.end))
            if ends:
                self._last = NounPhrase(ObjectDescription(""), Scope("room", "", ends), placed=True)
        elif kind == "have":
            self._have(f"{words['x']} {words.get('loc', '')}".strip())
        elif kind == "hold":
            self._hold(words)
        elif kind in ("absent", "no"):
            phrase = read_noun_phrase(self.state, f"{words['x']} {words.get('loc', '')}")
            if english.PRONOUN.match(words["x"]) and not phrase.object.noun:
                phrase = self._resolve_pronoun(phrase)
            self._defer(kind, phrase)
        elif kind == "absent_on":
            thing = read_noun_phrase(self.state, words["x"])
            where = read_place(self.state, f"on {words['y']}")
            self._defer("absent", replace(where, object=thing.object))
        elif kind == "clear":
            self._clear(words["y"])
        elif kind in ("state", "unstate"):
            word = words["v"].lower() if kind == "state" else english.OPPOSITES[english.STATES[words["v"].lower()]]
            self._defer(f"state {word}", read_noun_phrase(self.state, words["x"]))
        elif kind == "quality":
            self._qualify(words["v"].lower())
        elif kind == "move":
            self._move(f"{words['x']}{' ' + words['loc'] if words.get('loc') else ''}")
        elif kind == "swap":
            self._swap(words["x"], words["z"])
        else:
            self._read_sentence_pattern(kind, words)

    def _read_sentence_pattern(self, kind: str, words: dict[str, str]) -> None:
        """Read a sentence that matched a pattern as a whole."""
        self._flush()
        if kind == "only":
            facts, self._last = _only_facts(self.state, words["x"], words["y"])
            self.facts += facts
        elif kind == "exchange":
            moves = _exchange_facts(self.state, words["x"], words["z"])
            if moves is None:
                self._swap(words["x"], words["z"])
            else:
                self.facts += moves
        elif kind == "mention":
            bare = re.sub(r"^(?:in|on|at) ", "", words["y"])
            at = "in" if rooms_named(self.state, re.sub(r"^the ", "", bare), None) else "on"
            self._last = read_place(self.state, f"{at} {bare}")
        else:
            self._colour_some(words["n"], words["v"].lower())

    def _colour_some(self, number: str, word: str) -> None:
        """Read ``one of them should be green``: a colour for some of the objects of the last fact."""
        last = self.facts[-1] if self.facts else None
        if not isinstance(last, ObjectFact) or word not in COLOUR_WORDS:
            raise _not_understood(f"{number} of them {word}")
        part = replace(last.object, count=NUMBERS[number.lower()], colour=COLOUR_WORDS[word])
        self.facts.insert(-1, replace(last, object=part, exact=False))

    def _have(self, text: str) -> None:
        negated = english.NEGATED.match(text)
        if negated:
            self._defer("absent", read_noun_phrase(self.state, text[negated.end() :]))
            return
        match = english.CARRIER_WITH.match(text)
        if match is None:
            self._defer("have", read_noun_phrase(self.state, text))
            return
        self._with(match, read_noun_phrase(self.state, f"{match['a']}{match['loc'] or ''}"))

    def _with(self, match: re.Match[str], carrier: NounPhrase) -> None:
        """Read ``a table with two mugs on it``."""
        self._defer("have", carrier)
        self._flush()
        inward = (match["rel"] or "on") != "on"
        where = self._place_on_or_in(carrier, "in" if inward else "on")
        for words in re.split(r" and ", match["b"]):
            self._defer("have", replace(read_noun_phrase(self.state, words), where=where, placed=True))

    def _hold(self, words: dict[str, str]) -> None:
        holder = words.get("y") or "it"
        bare = re.sub(r"^(?:(?:the|every|each|all|both)\s+)+", "", holder, flags=re.IGNORECASE)
        place = read_place(self.state, f"in {holder}")
        if place.where.receptacle and not rooms_named(self.state, bare, None):
            asset = typical_asset(self.state, place.where.receptacle)
            inward = asset is not None and bool(asset.volumes) and asset.openable
            place = read_place(self.state, f"{'in' if inward else 'on'} {holder}")
        negated = english.NEGATED.match(words["x"])
        kind, text = ("absent", words["x"][negated.end() :]) if negated else ("have", words["x"])
        match = english.CARRIER_WITH.match(text)
        if match is not None and kind == "have":
            carrier = read_noun_phrase(self.state, f"{match['a']}{match['loc'] or ''}")
            self._with(match, replace(carrier, where=place.where, placed=True))
            return
        thing = read_noun_phrase(self.state, text)
        where = thing.where.completed(place.where) if thing.placed else place.where
        self._defer(kind, replace(thing, where=where, placed=True, each=place.each, anaphoric=place.anaphoric))

    def _clear(self, text: str) -> None:
        self._flush()
        phrase = read_place(self.state, f"on {text}")
        where = self._resolve_place(phrase)
        if not where.receptacle:
            raise _not_understood(f"clear {text}")
        self.facts.append(AbsentFact(ObjectDescription("", 0), replace(where, relation="on")))
        carrier = ObjectDescription(where.receptacle, 1, where.colour)
        self._last = NounPhrase(carrier, Scope("room", "", where.rooms, where.floor), placed=True)

    def _qualify(self, word: str) -> None:
        """Add a quality to the last fact: they must be red, it should be cold, it is open."""
        self._flush()
        last = self.facts[-1] if self.facts else None
        if word in english.STATES and self._last is not None:
            self._switch(replace(self._stateful_referent(word, self._last), placed=True), word)
        elif isinstance(last, ObjectFact) and word in COLOUR_WORDS:
            thing = replace(last.object, colour=COLOUR_WORDS[word])
            self.facts[-1] = replace(last, object=thing)
        elif isinstance(last, ObjectFact) and word in ("cold", "chilled", "cool"):
            self.facts[-1] = replace(last, object=replace(last.object, cold=True))
        else:
            raise _not_understood(word)

    def _move(self, text: str) -> None:
        parts = read_move(self.state, text)
        if parts is None:
            self._defer("move", read_noun_phrase(self.state, text))
            return
        phrase, goal = parts
        if not phrase.object.noun and not phrase.placed and self._last is not None:
            phrase = self._last
        if not goal.placed:
            raise _not_understood(f"move {text}")
        target = self._resolve_place(goal)
        for kind, waiting in self._pending:
            if kind == "move":
                where = waiting.where if waiting.placed else phrase.where
                self.facts.append(MoveFact(waiting.object.to_move(), where, target))
        self._pending = [entry for entry in self._pending if entry[0] != "move"]
        self._flush()
        self.facts.append(MoveFact(phrase.object.to_move(), self._resolve_place(phrase), target))
        self._last = replace(phrase, where=target)

    def _swap(self, old: str, new: str) -> None:
        self._flush()
        gone, come = read_noun_phrase(self.state, old), read_noun_phrase(self.state, new)
        where = self._resolve_place(gone if gone.placed else come)
        self.facts.append(AbsentFact(gone.object, where))
        self.facts.append(ObjectFact(replace(come.object, count=max(1, come.object.count)), where))
        self._last = replace(come, where=where)

    def _resolve_pronoun(self, phrase: NounPhrase) -> NounPhrase:
        """Return the antecedent of a pronoun, at the place given with the pronoun."""
        before = self._pending[-1][1] if self._pending else self._last
        if before is None or not before.object.noun:
            raise _not_understood("it")
        self._pending = self._pending[:-1]
        thing = replace(before.object, count=0)
        return replace(phrase if phrase.placed else before, object=thing)

    def _defer(self, kind: str, phrase: NounPhrase) -> None:
        whole = phrase.where.receptacle if kind in ("absent", "no") else phrase.object.every
        if not phrase.object.noun and not (whole and kind != "have"):
            before = self._pending[-1][1] if self._pending else self._last
            if before is None or not before.object.noun:
                raise _not_understood(kind)
            thing, last = phrase.object, before.object
            if kind.startswith("state ") and not phrase.placed:
                before = self._stateful_referent(kind[6:], before)
                last = before.object
            if not phrase.placed and kind.startswith(("state", "absent")):
                phrase = replace(phrase, where=before.where, placed=before.placed)
            colour, cold = thing.colour or last.colour, thing.cold or last.cold
            thing = replace(last, count=thing.count or last.count, colour=colour, cold=cold)
            phrase = replace(phrase, object=thing)
        self._pending.append((kind, phrase))
        if phrase.placed:
            self._flush()

    def _stateful_referent(self, word: str, before: NounPhrase) -> NounPhrase:
        """Return the last object, or its receptacle where only that can be open, or on."""
        where = before.where
        own = has_state(self.state, before.object.noun, word)
        if own or not where.receptacle or not has_state(self.state, where.receptacle, word):
            return before
        place = replace(where, relation="room", receptacle="", colour="", base="")
        return NounPhrase(ObjectDescription(where.receptacle, 1, where.colour), place, placed=True)

    def _flush(self) -> None:
        """Turn deferred phrases into facts; one without a place takes that of the next, or of the last."""
        if not self._pending:
            return
        final = self._pending[-1][1]
        place = final
        takes_up = self._pending[-1][0] in ("have", "no") and self._frame is None
        if not final.placed and takes_up and self._last is not None:
            place = replace(self._last, each="")
        for kind, phrase in self._pending:
            own = phrase if phrase.placed else replace(place, object=phrase.object)
            self._add_facts(kind, replace(own, exact=phrase.exact, more=phrase.more, most=phrase.most))
        self._pending = []

    def _add_facts(self, kind: str, phrase: NounPhrase) -> None:
        where = self._resolve_place(phrase)
        if kind == "have":
            least = 2 if phrase.object.every else 1
            thing = replace(phrase.object, count=phrase.object.count or least, every=False)
            if thing.cold and not where.receptacle:
                where = replace(where, relation="in", receptacle="fridge")
            if where.base:
                outer = replace(where, relation="on", receptacle=where.base, base="", colour="")
                self.facts.append(ObjectFact(ObjectDescription(where.receptacle, 1, where.colour), outer))
            for scope in each_place(self.state, where, phrase.each):
                self.facts.append(ObjectFact(thing, scope, exact=phrase.exact, more=phrase.more, most=phrase.most))
        elif kind in ("absent", "no"):
            self.facts.append(AbsentFact(phrase.object, where))
        elif kind.startswith("state "):
            self._switch(replace(phrase, where=where), kind[6:])
            return
        else:
            raise _not_understood(kind)
        self._last = replace(phrase, where=where)

    def _switch(self, phrase: NounPhrase, word: str) -> None:
        name, value = english.STATES[word.lower()]
        where = self._resolve_place(phrase)
        state = "open" if name == "open" else "on"
        self.facts.append(StateFact(phrase.object, where, state, value=value))  # type: ignore[arg-type]
        self._last = replace(phrase, where=where)

    def _resolve_place(self, phrase: NounPhrase) -> Scope:
        """Return a phrase's place with its pronouns and the sentence's leading place filled in."""
        where = phrase.where
        if phrase.anaphoric and self._last is not None:
            where = self._place_on_or_in(self._last, where.relation)
        return where.completed(self._frame)

    def _place_on_or_in(self, carrier: NounPhrase, relation: str) -> Scope:
        """Return the place on or in an object mentioned before; its own place when it carries nothing."""
        noun, own = carrier.object.noun, carrier.where
        asset = typical_asset(self.state, noun)
        carries = asset is not None and bool(asset.surfaces or asset.volumes)
        if not carries or (own.receptacle and noun in ("", own.receptacle)):
            return own
        return Scope("in" if relation == "in" else "on", noun, own.rooms, own.floor, carrier.object.colour)


def _only_facts(state: SceneState, words: str, place: str) -> tuple[list[Fact], NounPhrase]:
    """Return the facts of ``a mug and two books`` being all that is on a receptacle, and what `it` is then."""
    where = read_place(state, f"on {place}").where
    things = [
        read_noun_phrase(state, part).object for part in re.split(r",? and |, ", re.sub(r"^(?:only|just) ", "", words))
    ]
    facts: list[Fact] = [AbsentFact(ObjectDescription("", 0), where, tuple(replace(t, count=0) for t in things))]
    for thing in things:
        exact = thing.count > 0
        one = replace(thing, count=max(1, thing.count), every=False)
        facts.append(ObjectFact(one, where, exact=exact))
    carrier = ObjectDescription(where.receptacle, 1, where.colour)
    return facts, NounPhrase(carrier, Scope("room", "", where.rooms, where.floor), placed=True)


def _exchange_facts(state: SceneState, one: str, other: str) -> list[Fact] | None:
    """Return an exchange of two objects as two moves; None where one of them has no receptacle."""
    first, second = read_noun_phrase(state, one), read_noun_phrase(state, other)
    if not (first.where.receptacle and second.where.receptacle):
        return None
    return [
        MoveFact(first.object.to_move(), first.where, second.where),
        MoveFact(second.object.to_move(), second.where, first.where),
    ]
