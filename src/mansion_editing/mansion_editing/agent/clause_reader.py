"""Clauses to facts, read in order, with what was spoken of before in mind."""

import re
from collections.abc import Iterable
from dataclasses import replace
from typing import Final

from mansion_editing.agent.clauses import Clause
from mansion_editing.agent.facts import AbsentFact, MoveFact, ObjectFact, Scope, Thing
from mansion_editing.agent.phrases import Phrase, read_phrase, read_place, rooms_named
from mansion_editing.agent.scopes import merged, moved, on_that_of, parted
from mansion_editing.agent.spoken import OPPOSITES, STATES, Spoken, not_understood
from mansion_editing.agent.things import NUMBERS
from mansion_editing.agent.ways import read_way
from mansion_editing.agent.wholes import exchanged, only_things
from mansion_editing.state import SceneState
from mansion_editing.vocabulary import COLOUR_WORDS

__all__ = ["ClauseReader"]

_WITH: Final = re.compile(
    r"^(?P<a>.+?) with (?P<b>(?:a|an|one|two|three|four|five|six|some|another|no|cold|\d+)\b.+?)"
    r"(?: (?P<rel>on|in|inside|within)(?: (?:it|them|top))?)?(?P<loc> (?:in|on|at) (?!it\b|them\b|top\b).+)?$",
    re.IGNORECASE,
)
_NEW: Final = re.compile(r"^(?:an?|one|two|three|four|five|six|some|another|\d+) ", re.IGNORECASE)
_PRONOUN: Final = re.compile(r"^(?:it|them|that|this|these|those|both)\b", re.IGNORECASE)


class ClauseReader(Spoken):
    """Reads clauses in order; remembers the last thing and the last place."""

    def __init__(self, state: SceneState) -> None:
        super().__init__(state)
        self._clause: Clause | None = None

    def sentence(self, clauses: Iterable[Clause]) -> None:
        """Read one sentence."""
        early: list[str] = []
        self._frame, self._clause = None, None
        for clause in clauses:
            if clause.kind == "place" and self._clause is None:
                self._frame = merged(read_place(self.state, clause.words["loc"]).where, self._frame)
            elif not clause.kind and self._clause is None:
                early.append(clause.words["x"])
            elif not clause.kind or clause.kind == "place":
                self._continue(clause)
            else:
                for words in early:
                    self._read(Clause(clause.kind, {**clause.words, "x": words, "loc": ""}))
                early = []
                self._read(clause)
                self._clause = clause
        for words in early:
            self._wait("have", read_phrase(self.state, words))
        if early and self._waiting and self._frame is None:
            raise not_understood(", ".join(early))
        self._flush()

    def _continue(self, clause: Clause) -> None:
        """Read a piece without a verb of its own: more things, or the same at another place."""
        before = self._clause
        words = clause.words.get("loc") or clause.words["x"]
        if before is None:
            raise not_understood(words)
        things = _NEW.match(words) and not rooms_named(self.state, _NEW.sub("", words), None)
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
        if before.kind == "have" and words.lower().startswith("the ") and self._is_carrier(words):
            self._again(f"on {words}")
            return
        if clause.kind == "place" or rooms_named(self.state, bare, None):
            self._again(words if clause.kind == "place" else f"in {words}")
            return
        if before.kind in ("state", "unstate") and _NEW.match(words):
            self._flush()
            self._have(words)
            return
        self._read(replace(before, words={**before.words, "x": words, "loc": ""}))

    def _is_carrier(self, words: str) -> bool:
        """Whether words name furniture while the last thing stands on some: another place for it."""
        last = self.facts[-1] if self.facts else None
        if self._waiting or not isinstance(last, ObjectFact) or not last.where.receptacle:
            return False
        noun = read_phrase(self.state, words).thing.noun
        kinds = self.state.vocabulary.nouns(noun)[:1]
        assets = [a for kind in kinds for a in self.state.catalogue.by_category(kind)[:1]]
        return any(asset.surfaces and not asset.pickupable for asset in assets)

    def _again(self, words: str) -> None:
        """The things of the last clause at another place too, or at the place more closely."""
        self._flush()
        place = read_place(self.state, words).where
        last = self.facts[-1] if self.facts else None
        if not isinstance(last, ObjectFact | AbsentFact):
            raise not_understood(words)
        closer = not place.receptacle and not last.where.rooms and last.where.floor is None
        if closer:
            self.facts[-1] = replace(last, where=merged(last.where, place))
            return
        same = place if place.receptacle else on_that_of(place, last.where)
        self.facts.append(replace(last, where=same))

    def _read(self, clause: Clause) -> None:
        words, kind = clause.words, clause.kind
        if kind in ("path", "reach"):
            self._flush()
            end = words.get("b") or words.get("c") or ""
            ways = read_way(self.state, end, words.get("a", ""))
            self.facts += ways
            ends = tuple(way.end for way in ways if self.state.room(way.end))
            if ends:
                self._last = Phrase(Thing(""), Scope("room", "", ends), True)
        elif kind == "have":
            self._have(f"{words['x']} {words.get('loc', '')}".strip())
        elif kind == "hold":
            self._hold(words)
        elif kind in ("absent", "no"):
            phrase = read_phrase(self.state, f"{words['x']} {words.get('loc', '')}")
            if _PRONOUN.match(words["x"]) and not phrase.thing.noun:
                phrase = self._meant(phrase)
            self._wait(kind, phrase)
        elif kind == "absent_on":
            thing = read_phrase(self.state, words["x"])
            where = read_place(self.state, f"on {words['y']}")
            self._wait("absent", replace(where, thing=thing.thing))
        elif kind == "clear":
            self._clear(words["y"])
        elif kind in ("state", "unstate"):
            word = words["v"].lower() if kind == "state" else OPPOSITES[STATES[words["v"].lower()]]
            self._wait(f"state {word}", read_phrase(self.state, words["x"]))
        elif kind == "quality":
            self._qualify(words["v"].lower())
        elif kind == "move":
            self._move(f"{words['x']}{' ' + words['loc'] if words.get('loc') else ''}")
        elif kind == "swap":
            self._swap(words["x"], words["z"])
        else:
            self._whole(kind, words)

    def _whole(self, kind: str, words: dict[str, str]) -> None:
        """Read a sentence that is one wish as a whole."""
        self._flush()
        if kind == "only":
            facts, self._last = only_things(self.state, words["x"], words["y"])
            self.facts += facts
        elif kind == "exchange":
            moves = exchanged(self.state, words["x"], words["z"])
            if moves is None:
                self._swap(words["x"], words["z"])
            else:
                self.facts += moves
        elif kind == "mention":
            bare = re.sub(r"^(?:in|on|at) ", "", words["y"])
            at = "in" if rooms_named(self.state, re.sub(r"^the ", "", bare), None) else "on"
            self._last = read_place(self.state, f"{at} {bare}")
        else:
            self._some(words["n"], words["v"].lower())

    def _some(self, number: str, word: str) -> None:
        """Read ``one of them should be green``: a part of the things that were asked for last."""
        last = self.facts[-1] if self.facts else None
        if not isinstance(last, ObjectFact) or word not in COLOUR_WORDS:
            raise not_understood(f"{number} of them {word}")
        part = replace(last.thing, count=NUMBERS[number.lower()], colour=COLOUR_WORDS[word])
        self.facts.insert(-1, replace(last, thing=part, exact=False))

    def _have(self, text: str) -> None:
        if re.match(r"^(?:no|not any|none of)\b", text, re.IGNORECASE):
            bare = re.sub(r"^(?:no|not any|none of)\s+", "", text, flags=re.IGNORECASE)
            self._wait("absent", read_phrase(self.state, bare))
            return
        match = _WITH.match(text)
        if match is None:
            self._wait("have", read_phrase(self.state, text))
            return
        self._with(match, read_phrase(self.state, f"{match['a']}{match['loc'] or ''}"))

    def _with(self, match: re.Match[str], carrier: Phrase) -> None:
        """Read ``a table with two mugs on it``."""
        self._wait("have", carrier)
        self._flush()
        inward = (match["rel"] or "on") != "on"
        where = self._within(carrier, "in" if inward else "on")
        for words in re.split(r" and ", match["b"]):
            self._wait("have", replace(read_phrase(self.state, words), where=where, placed=True))

    def _hold(self, words: dict[str, str]) -> None:
        holder = words.get("y") or "it"
        bare = re.sub(r"^(?:(?:the|every|each|all|both)\s+)+", "", holder, flags=re.IGNORECASE)
        place = read_place(self.state, f"in {holder}")
        if place.where.receptacle and not rooms_named(self.state, bare, None):
            assets = [
                asset
                for category in self.state.vocabulary.nouns(place.where.receptacle)[:1]
                for asset in self.state.catalogue.by_category(category)[:1]
            ]
            inward = bool(assets and assets[0].volumes and assets[0].openable)
            place = read_place(self.state, f"{'in' if inward else 'on'} {holder}")
        kind = "have"
        text = words["x"]
        if re.match(r"^(?:no|not any)\b", text, re.IGNORECASE):
            kind, text = "absent", re.sub(r"^(?:no|not any)\s+", "", text, flags=re.IGNORECASE)
        match = _WITH.match(text)
        if match is not None and kind == "have":
            carrier = read_phrase(self.state, f"{match['a']}{match['loc'] or ''}")
            self._with(match, replace(carrier, where=place.where, placed=True))
            return
        thing = read_phrase(self.state, text)
        where = merged(thing.where, place.where) if thing.placed else place.where
        self._wait(kind, replace(thing, where=where, placed=True, each=place.each, back=place.back))

    def _clear(self, text: str) -> None:
        self._flush()
        phrase = read_place(self.state, f"on {text}")
        where = self._resolved(phrase)
        if not where.receptacle:
            raise not_understood(f"clear {text}")
        self.facts.append(AbsentFact(Thing("", 0), replace(where, relation="on")))
        carrier = Thing(where.receptacle, 1, where.colour)
        self._last = Phrase(carrier, Scope("room", "", where.rooms, where.floor), True)

    def _qualify(self, word: str) -> None:
        """Take what was said of the last things: they must be red, it should be cold, it is open."""
        self._flush()
        last = self.facts[-1] if self.facts else None
        if word in STATES and self._last is not None:
            self._switch(replace(self._able(word, self._last), placed=True), word)
        elif isinstance(last, ObjectFact) and word in COLOUR_WORDS:
            thing = replace(last.thing, colour=COLOUR_WORDS[word])
            self.facts[-1] = replace(last, thing=thing)
        elif isinstance(last, ObjectFact) and word in ("cold", "chilled", "cool"):
            self.facts[-1] = replace(last, thing=replace(last.thing, cold=True))
        else:
            raise not_understood(word)

    def _move(self, text: str) -> None:
        parts = parted(self.state, text)
        if parts is None:
            self._wait("move", read_phrase(self.state, text))
            return
        phrase, goal = parts
        if not phrase.thing.noun and not phrase.placed and self._last is not None:
            phrase = self._last
        if not goal.placed:
            raise not_understood(f"move {text}")
        target = self._resolved(goal)
        for kind, waiting in self._waiting:
            if kind == "move":
                where = waiting.where if waiting.placed else phrase.where
                self.facts.append(MoveFact(moved(waiting.thing), where, target))
        self._waiting = [entry for entry in self._waiting if entry[0] != "move"]
        self._flush()
        self.facts.append(MoveFact(moved(phrase.thing), self._resolved(phrase), target))
        self._last = replace(phrase, where=target)

    def _swap(self, old: str, new: str) -> None:
        self._flush()
        gone, come = read_phrase(self.state, old), read_phrase(self.state, new)
        where = self._resolved(gone if gone.placed else come)
        self.facts.append(AbsentFact(gone.thing, where))
        self.facts.append(ObjectFact(replace(come.thing, count=max(1, come.thing.count)), where))
        self._last = replace(come, where=where)
