"""What was spoken of before: things that wait for their place, the last thing, and what pronouns stand for."""

from dataclasses import replace
from typing import Final

from mansion_editing.agent.distributing import distributed
from mansion_editing.agent.facts import AbsentFact, Fact, ObjectFact, Scope, StateFact, Thing
from mansion_editing.agent.limits import EXAMPLES
from mansion_editing.agent.phrases import Phrase
from mansion_editing.agent.scopes import merged
from mansion_editing.state import SceneState
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["OPPOSITES", "STATES", "Spoken", "not_understood"]

STATES: Final = {
    **dict.fromkeys(["open", "opened"], ("open", True)),
    **dict.fromkeys(["close", "closed", "shut"], ("open", False)),
    **dict.fromkeys(["on", "switched on", "turned on", "running", "lit", "activate", "start", "light"], ("on", True)),
    **dict.fromkeys(["off", "switched off", "turned off", "deactivate", "stop"], ("on", False)),
}  # fmt: skip
OPPOSITES: Final = {("open", True): "closed", ("open", False): "open", ("on", True): "off", ("on", False): "on"}


def not_understood(text: str) -> MansionError:
    return MansionError(ErrorCode.INVALID_PAYLOAD, f"not understood: {text[:120]!r}; {EXAMPLES}", path="$.instruction")


def _able(state: SceneState, noun: str, word: str) -> bool:
    """Whether things of a noun can be open, or on."""
    assets = [
        asset for category in state.vocabulary.nouns(noun)[:1] for asset in state.catalogue.by_category(category)[:1]
    ]
    name = STATES[word][0]
    return any(asset.openable if name == "open" else asset.toggleable for asset in assets)


class Spoken:
    """Facts so far, and what the next words may refer to."""

    def __init__(self, state: SceneState) -> None:
        self.state = state
        self.facts: list[Fact] = []
        self._waiting: list[tuple[str, Phrase]] = []
        self._last: Phrase | None = None
        self._frame: Scope | None = None

    def _meant(self, phrase: Phrase) -> Phrase:
        """Return the thing that a pronoun stands for, in the place that is given with it."""
        before = self._waiting[-1][1] if self._waiting else self._last
        if before is None or not before.thing.noun:
            raise not_understood("it")
        self._waiting = self._waiting[:-1]
        thing = replace(before.thing, count=0)
        return replace(phrase if phrase.placed else before, thing=thing)

    def _wait(self, kind: str, phrase: Phrase) -> None:
        whole = phrase.where.receptacle if kind in ("absent", "no") else phrase.thing.every
        if not phrase.thing.noun and not (whole and kind != "have"):
            before = self._waiting[-1][1] if self._waiting else self._last
            if before is None or not before.thing.noun:
                raise not_understood(kind)
            thing, last = phrase.thing, before.thing
            if kind.startswith("state ") and not phrase.placed:
                before = self._able(kind[6:], before)
                last = before.thing
            if not phrase.placed and kind.startswith(("state", "absent")):
                phrase = replace(phrase, where=before.where, placed=before.placed)
            colour, cold = thing.colour or last.colour, thing.cold or last.cold
            thing = replace(last, count=thing.count or last.count, colour=colour, cold=cold)
            phrase = replace(phrase, thing=thing)
        self._waiting.append((kind, phrase))
        if phrase.placed:
            self._flush()

    def _able(self, word: str, before: Phrase) -> Phrase:
        """Return what of the last thing and its receptacle can be open, or on."""
        where = before.where
        if _able(self.state, before.thing.noun, word) or not where.receptacle:
            return before
        if not _able(self.state, where.receptacle, word):
            return before
        place = replace(where, relation="room", receptacle="", colour="", base="")
        return Phrase(Thing(where.receptacle, 1, where.colour), place, True)

    def _flush(self) -> None:
        """Turn what waits into facts; things without a place stand where the next, or the last, one does."""
        if not self._waiting:
            return
        final = self._waiting[-1][1]
        place = final
        takes_up = self._waiting[-1][0] in ("have", "no") and self._frame is None
        if not final.placed and takes_up and self._last is not None:
            place = replace(self._last, each="")
        for kind, phrase in self._waiting:
            own = phrase if phrase.placed else replace(place, thing=phrase.thing)
            self._fact(kind, replace(own, exact=phrase.exact, more=phrase.more, most=phrase.most))
        self._waiting = []

    def _fact(self, kind: str, phrase: Phrase) -> None:
        where = self._resolved(phrase)
        if kind == "have":
            least = 2 if phrase.thing.every else 1
            thing = replace(phrase.thing, count=phrase.thing.count or least, every=False)
            if thing.cold and not where.receptacle:
                where = replace(where, relation="in", receptacle="fridge")
            if where.base:
                outer = replace(where, relation="on", receptacle=where.base, base="", colour="")
                self.facts.append(ObjectFact(Thing(where.receptacle, 1, where.colour), outer))
            for scope in distributed(self.state, where, phrase.each):
                self.facts.append(ObjectFact(thing, scope, phrase.exact, phrase.more, phrase.most))
        elif kind in ("absent", "no"):
            self.facts.append(AbsentFact(phrase.thing, where))
        elif kind.startswith("state "):
            self._switch(replace(phrase, where=where), kind[6:])
            return
        else:
            raise not_understood(kind)
        self._last = replace(phrase, where=where)

    def _switch(self, phrase: Phrase, word: str) -> None:
        name, value = STATES[word.lower()]
        where = self._resolved(phrase)
        state = "open" if name == "open" else "on"
        self.facts.append(StateFact(phrase.thing, where, state, value))  # type: ignore[arg-type]
        self._last = replace(phrase, where=where)

    def _resolved(self, phrase: Phrase) -> Scope:
        """Return a phrase's place with its pronouns and the sentence's leading place filled in."""
        where = phrase.where
        if phrase.back and self._last is not None:
            where = self._within(self._last, where.relation)
        return merged(where, self._frame) if self._frame is not None else where

    def _within(self, carrier: Phrase, relation: str) -> Scope:
        """Return the place on or in a thing that was spoken of; its own place when it carries nothing."""
        noun = carrier.thing.noun
        carries = any(
            asset.surfaces or asset.volumes
            for category in self.state.vocabulary.nouns(noun)[:1]
            for asset in self.state.catalogue.by_category(category)[:1]
        )
        if not carries or (carrier.where.receptacle and noun in ("", carrier.where.receptacle)):
            return carrier.where
        own = carrier.where
        return Scope("in" if relation == "in" else "on", noun, own.rooms, own.floor, carrier.thing.colour)
