"""What is said of a subject: that it is on, gone, red, on the desk, or has something."""

from typing import Final

import msgspec

from mansion_editing.instructions.clauses.colours import Colours
from mansion_editing.instructions.clauses.items import Item, NotUnderstood, joined_places
from mansion_editing.instructions.clauses.outcomes import at_receiver
from mansion_editing.instructions.clauses.states import States
from mansion_editing.instructions.clauses.ways import Ways
from mansion_editing.instructions.phrases.places import ReadPlace, with_place
from mansion_editing.instructions.phrases.verb_words import Deed
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import (
    ANY_LONGER,
    BEFORE_PREDICATES,
    BEING_SOMEWHERE,
    FAILING,
    JOINING,
    PRAISE,
    STAYING_AS_IT_IS,
    WANTING,
)
from mansion_editing.instructions.phrases.words import BE, HAVE, MODALS, STATE_WORDS
from mansion_editing.instructions.statements import (
    Amount,
    AmountKind,
    Clear,
    Ensure,
    Furnish,
    Keep,
    Mention,
    Move,
    Place,
    Reach,
    Remove,
    Rename,
    Replace,
    Rooms,
    SetState,
    Statement,
    Things,
    Turn,
)

__all__ = ["Predicates"]

_CARRYING: Final = frozenset("carry bear store".split())
_GETTING: Final = frozenset("need require get lack deserve miss use".split())
"""Verbs by which something comes besides what is there."""


class Predicates(States, Colours, Ways):
    """Reads predicates."""

    def _predicate(self, item: Item, end: int, at: int, *, denied: bool = False) -> tuple[list[Statement], int] | None:
        """Read what is said of a subject, or denied of it ("neither the lamp nor the radio should be on")."""
        place = end
        while self._is_before_predicate(place, end):
            place += 1
        negated = denied or any(word.text in ("not", "never", "no") for word in self.words[end:place])
        for reader in (self._said_become, self._said_missing, self._said_state, self._said_participle,
                       self._said_having, self._said_enough, self._said_gone, self._said_where, self._said_colour,
                       self._said_good):  # fmt: skip
            found = reader(item, place, at, negated)
            if found is not None:
                return found
        return None

    def _is_before_predicate(self, at: int, end: int) -> bool:
        """Whether a word between a subject, whose end is given, and what is said of it only joins them."""
        word = self.text(at)
        if word == "keep" and self.text(at + 1) in STATE_WORDS:
            return True
        if not (word in MODALS or word in BEFORE_PREDICATES or word in BE - {"stay", "remain"}):
            return False
        having = word in ("has", "have", "get") and self.text(at + 1) not in ("to", "be")
        if having and self._participle(at + 1) is None:
            return False
        if word in ("to", "only", "just", "no", "all", "both") and self.phrase(at + 1) is not None:
            return word == "to" and self.text(at - 1) not in BE and at != end
        return True

    def _said_become(self, item: Item, place: int, at: int, negated: bool) -> tuple[list[Statement], int] | None:
        """Read ``becomes a home gym``, ``is turned into an office``, ``shall be a library``, ``should become red``."""
        room = item.phrase.noun.kind in ("room", "both")
        if negated:
            return None
        turned = self.text(place) in ("turned", "turn", "made", "changed", "change", "transformed")
        turned = turned and self.text(place + 1) == "into"
        become = self.text(place) == "become" or turned
        place += (1 + turned) if become else 0
        kind = self.kind_of_room(place) if room and (become or self._shall_be(item.end, place)) else None
        if kind is not None:
            return [Furnish(rooms=item.rooms(), kind=kind[0], quote=self.quote(at, kind[1]))], kind[1]
        colour = self.colour_at(place) if become else None
        if colour is not None and self.phrase(place) is None:
            return self._painted([item], colour[0], colour[1], self.quote(at, colour[2])), colour[2]
        new = self.phrase(place) if become else None
        if new is None or new.noun.unknown or item.is_room or new.noun.kind == "room":
            return None
        quote = self.quote(at, new.end)
        return [Replace(things=self._all_if_plural(item.things()), by=new.things(), quote=quote)], new.end

    def _shall_be(self, start: int, end: int) -> bool:
        """Whether words before what a room is say that it is so from now on: ``is now``, ``shall be``, ``is to be``."""
        said = [word.text for word in self.words[start:end]]
        shall = bool(set(said) & MODALS) and said[-1:] == ["be"]
        return shall or said[-1:] == ["now"] or said[-2:] == ["to", "be"]

    def _said_state(self, item: Item, place: int, at: int, negated: bool) -> tuple[list[Statement], int] | None:
        found = self._state_after(item, place, at)
        if found is None:
            return None
        said, end = found
        if negated:
            turned = [s for s in said if isinstance(s, SetState)]
            said = [msgspec.structs.replace(s, value=not s.value) for s in turned]
        return said, end

    def _said_participle(self, item: Item, place: int, at: int, negated: bool) -> tuple[list[Statement], int] | None:
        found = self._participle(place)
        if found is None or negated or self._tells_of_past(item.end, place):
            return None
        deed, after = found
        if deed == "remove":
            places, end = self.places(after)
            things = self._all_if_plural(Item(item.phrase, (*item.places, *places), end).things())
            return [Remove(things=things, quote=self.quote(at, end))], end
        if deed == "clear":
            return self._said_cleared(item, after, at)
        if deed in ("move", "add"):
            return self._said_put(item, deed, after, at)
        return self._said_changed(item, deed, after, at)

    def _tells_of_past(self, start: int, end: int) -> bool:
        """Whether words before a participle say that it was done: ``were furnished like a nursery``."""
        said = {word.text for word in self.words[start:end]}
        return bool(said & {"was", "were"}) and not said & (MODALS | {"if"})

    def _said_cleared(self, item: Item, after: int, at: int) -> tuple[list[Statement], int]:
        """Read ``should be cleared of mugs``, ``must be empty but for the lamp``, up to the end of the participle."""
        if self.text(after) in ("of", "from"):
            gone = self.items(after + 1)
            return self._gone_from(item, gone, self.quote(at, gone[-1].end)), gone[-1].end
        after += self.text(after) in ("up", "out", "off")
        after, spare = self.exceptions(after)
        return [Clear(place=self._emptied(item), spare=spare, quote=self.quote(at, after))], after

    def _said_put(self, item: Item, deed: Deed, after: int, at: int) -> tuple[list[Statement], int]:
        """Read ``should be moved to the hall``, ``should be put on the desk``, up to the end of the participle."""
        if deed == "move" and self.text(after) == ":":
            self.topic = item.things()
            return [Mention(quote=self.quote(at, after))], after
        places, end = self._onward(after)
        if not places and self.text(after) not in ("there", "instead"):
            return [self._added([item], item, self.quote(at, after))], after
        whole = Item(item.phrase, (*item.places, *places), end)
        if deed == "add":
            return [self._added([whole], whole, self.quote(at, end))], end
        source, goal, _ = self._source_and_goal(whole.places)
        if places and self.text(places[0].start) in ("upstairs", "downstairs"):
            source, goal = joined_places(item.places)[0], joined_places(places)[0]
        things = item.phrase.things() if source == Place() else with_place(item.phrase.things(), source)
        return [Move(things=self._all_if_plural(things), place=goal, quote=self.quote(at, end))], end

    def _said_changed(self, item: Item, deed: Deed, after: int, at: int) -> tuple[list[Statement], int] | None:
        """Read ``should be replaced by a sofa``, ``painted red``, ``called Den``, up to the end of the participle."""
        if deed == "replace" and self.text(after) in ("with", "by"):
            new = self.items(after + 1)
            end = new[-1].end
            things = self._all_if_plural(item.things())
            return [Replace(things=things, by=new[0].phrase.things(), quote=self.quote(at, end))], end
        colour = self.colour_at(after) if deed == "paint" else None
        if colour is not None:
            return self._painted([item], colour[0], colour[1], self.quote(at, colour[2])), colour[2]
        if deed == "equip" and self.text(after) == "with":
            new = self.items(after + 1)
            quote, goal = self.quote(at, new[-1].end), self._receiver(item)
            return [self._given(n, goal, quote, each=item.phrase.each) for n in new], new[-1].end
        if deed == "rename":
            name, stop = self.name_at(after + (self.text(after) in ("to", "as")))
            return [Rename(room=item.rooms(), name=name, quote=self.quote(at, stop))], stop
        kind = self.phrase(after + 1) if deed == "furnish" and self.text(after) in ("as", "into", "like") else None
        if kind is None:
            return None
        words = " ".join((*filter(None, [kind.noun.owned]), *kind.noun.words))
        return [Furnish(rooms=item.rooms(), kind=words, quote=self.quote(at, kind.end))], kind.end

    def _said_having(self, item: Item, place: int, at: int, negated: bool) -> tuple[list[Statement], int] | None:
        """Read ``needs two chairs``, ``should have a clock``, ``must not contain any knives``."""
        word = self.text(place)
        if word == "do" and self.text(place + 1) == "with":
            return self._said_having(item, place + 1, at, negated)
        lacked = self._said_out_of_place(item, place, at) or self._said_alone_without(item, place, at, negated)
        if lacked is not None:
            return lacked
        if not self._is_having(place) or self.text(place + 1) == "to":
            return None
        wanted = self.item(place + 1) if word in ("want", "need") else None
        if wanted is not None and self._participle(wanted.end) is not None:
            return self._predicate(wanted, wanted.end, at)
        covered = self._covered(item, place, at)
        if covered is not None and not negated:
            return covered
        new = self.items(place + 1)
        if self._is_way(new[0].phrase):
            return self._way(at, new[0].phrase.end)
        end = new[-1].end
        while self.text(end) in ("on", "in", "inside") and self.text(end + 1) in ("it", "them", "there"):
            end += 2
        quote = self.quote(at, end)
        if negated:
            return self._gone_from(item, new, quote), end
        return self._had(item, word, new, quote), end

    def _is_having(self, at: int) -> bool:
        """Whether a word says that a subject has something, or needs it."""
        word, before = self.text(at), self.text(at - 1)
        used = word == "use" and before in ("could", "can")
        return word in HAVE | WANTING | _CARRYING or used or (word == "with" and before == "do")

    def _said_out_of_place(self, item: Item, place: int, at: int) -> tuple[list[Statement], int] | None:
        """Read ``has no business in the library``, and ``has nowhere to hang clothes`` of a room."""
        if self.text(place) not in ("has", "have"):
            return None
        if self.text(place + 1) == "no" and self.text(place + 2) in ("business", "place"):
            places, end = self.places(place + 3 + (self.text(place + 3) == "being"))
            gone = self._as_certain(item, Item(item.phrase, (*item.places, *places), end).things())
            return [Remove(things=self._all_if_plural(gone), quote=self.quote(at, end))], end
        end = self._lacks_use(place + 1) if item.is_room else 0
        return ([Mention(rooms=item.rooms(), quote=self.quote(at, end))], end) if end else None

    def _had(self, item: Item, verb: str, new: list[Item], quote: str) -> list[Statement]:
        """Return that a subject has or is given things; what it needs comes besides what is there."""
        goal = self._receiver(item)
        each = item.phrase.each or item.phrase.amount.kind == "all" or (item.phrase.plural and item.phrase.definite)
        out: list[Statement] = []
        for thing in new:
            own = thing.goal()[0]
            where = at_receiver(own, goal)
            if thing.phrase.amount.kind == "none":
                out += self._gone_from(item, [thing], quote)
            elif any(p.source for p in thing.places):
                out.append(self._given(thing, goal, quote, each=each))
            elif thing.phrase.definite and own != Place() and not thing.phrase.plural:
                out.append(Move(things=thing.phrase.things(), place=where, or_new=True, quote=quote))
            elif thing.phrase.amount.kind == "more" or (verb in _GETTING and not (each and _is_one(thing))):
                out.append(self._given(thing, goal, quote, each=each))
            else:
                out.append(Ensure(things=thing.phrase.things(), place=where, each=each, quote=quote))
        return out

    def _as_certain(self, item: Item, things: Things) -> Things:
        """Return a thing that is named without an article, as in notes, as the certain one that is there."""
        one = self._is_bare(item.phrase) and not item.phrase.noun.plural
        return msgspec.structs.replace(things, amount=Amount(number=0), definite=True) if one else things

    def _lacks_use(self, at: int) -> int:
        """Return the end of ``nowhere to hang clothes``, ``nothing to sit on``; 0 for other words."""
        if self.text(at) not in ("nowhere", "nothing") or self.text(at + 1) != "to":
            return 0
        end = at + 2
        while end < len(self.words) and self.words[end].kind == "word" and self.text(end) not in ("and", "so", "but"):
            end += 1
        return end

    def _said_alone_without(self, item: Item, place: int, at: int, negated: bool) -> tuple[list[Statement], int] | None:
        """Read ``is the only one without a wardrobe`` of a room, which tells what it lacks."""
        said = tuple(self.text(place + k) for k in range(3))
        if negated or not item.is_room or said not in (("the", "only", "one"), ("the", "only", "room")):
            return None
        end = place + 3
        denying = [("without", "a"), ("without", "an"), ("that", "has", "no"), ("which", "has", "no"), ("with", "no")]
        joint = next((j for j in denying if tuple(self.text(end + k) for k in range(len(j))) == j), None)
        lacking = None if joint is None else self.item(end + len(joint), places=False)
        if lacking is None or lacking.is_room or lacking.phrase.noun.kind != "object":
            return None
        things, quote = lacking.phrase.things(), self.quote(at, lacking.end)
        there = Place(rooms=item.rooms())
        self.topic = msgspec.structs.replace(things, amount=Amount(kind="more"), plural=False, place=there)
        return [Mention(quote=quote)], lacking.end

    def _said_gone(self, item: Item, place: int, at: int, negated: bool) -> tuple[list[Statement], int] | None:
        """Read ``must go``, ``should stay``, ``is no longer needed``, ``comes out of the hall``."""
        word = self.text(place)
        if word in ("stay", "remain") or (word == "be" and self.text(place + 1) == "left"):
            return self._said_to_stay(item, place, at, negated)
        if word in ("needed", "required", "wanted", "necessary"):
            needed = self._said_needed(item, place + 1, at, negated)
            if needed is not None:
                return needed
        if negated:
            return None
        if word in ("go", "disappear", "vanish", "leave"):
            return self._said_to_go(item, place, at)
        out = word == "come" and self.text(place + 1) == "out" and self._ends_with_out(place + 1)
        if out and item.phrase.definite:
            gone = self._all_if_plural(self._within_frame(item.things()))
            return [Remove(things=gone, quote=self.quote(at, place + 2))], place + 2
        if word not in BEING_SOMEWHERE:
            return None
        places, end = self._onward(place + 1)
        return ([self._brought(item, places, self.quote(at, end))], end) if places else None

    def _onward(self, at: int) -> tuple[tuple[ReadPlace, ...], int]:
        """Read places, and where something goes on from them: ``out of the bathroom and into the study``."""
        places, end = self.places(at)
        if places and all(p.source for p in places) and self.text(end) in ("and", ","):
            more, stop = self.places(end + 1)
            if more and more[0].goal:
                return (*places, *more), stop
        return places, end

    def _said_to_stay(self, item: Item, place: int, at: int, negated: bool) -> tuple[list[Statement], int] | None:
        """Read ``should stay on``, ``stays where it is``, ``may be left``; the verb is at a place."""
        word, end = self.text(place), place + 1
        if self.text(end) in STATE_WORDS and word in ("stay", "remain") and self.phrase(end + 1) is None:
            return self._said_state(item, end, at, negated)
        if negated:
            raise NotUnderstood(at, self.boundary(at))  # where it shall go is not told
        if self._is_bare(item.phrase) and word in ("stay", "remain"):
            return self._bare_stays(item, end, at)
        if item.phrase.amount.number and not item.phrase.definite:
            return self._remaining(item, place + 1 + (word == "be"), at)
        places, after = self.places(end)
        end = after if places and not any(p.goal for p in places) else end
        while self.text(end) in STAYING_AS_IT_IS:
            end += 1
        kept = Item(item.phrase, (*item.places, *(places if end == after else ())), end)
        return [Keep(things=self._all(kept.things()), quote=self.quote(at, end))], end

    def _said_needed(self, item: Item, end: int, at: int, negated: bool) -> tuple[list[Statement], int] | None:
        """Read ``is needed in the hall``, ``is no longer needed``, up to the end of the participle."""
        while self.text(end) in ANY_LONGER:
            end += 1
        if negated:
            return [Remove(things=self._all_if_plural(item.things()), quote=self.quote(at, end))], end
        places, end = self.places(end + (self.text(end) == ","))
        if not places or item.phrase.definite:
            return None
        whole = Item(item.phrase, (*item.places, *places), end)
        return self._there(whole, whole.goal(), self.quote(at, end)), end

    def _said_to_go(self, item: Item, place: int, at: int) -> tuple[list[Statement], int]:
        """Read ``must go``, ``goes into the hall``, ``leaves the kitchen``; the verb is at a place."""
        word = self.text(place)
        rubbish = self._rubbish(place + 1) if word == "go" else 0
        if rubbish:
            gone = self._within_frame(item.things())
            return [Remove(things=self._all_if_plural(gone), quote=self.quote(at, rubbish))], rubbish
        exchanged = self._goes_for(item, place + 1, at) if word == "go" else None
        if exchanged is not None:
            return exchanged
        left = self.item(place + 1) if word == "leave" else None
        whence = None if left is None else self._left_by(left)
        if left is not None and whence is not None:
            gone = self._all_if_plural(with_place(item.things(), whence))
            return [Remove(things=gone, quote=self.quote(at, left.end))], left.end
        places, end = self.places(place + 1)
        if places and not all(p.source and not p.goal for p in places):
            return [self._brought(item, places, self.quote(at, end))], end
        end += self.text(end) == "away" or self._ends_with_out(end)
        whole = Item(item.phrase, (*item.places, *places), end)
        gone = self._as_certain(item, self._within_frame(whole.things()))
        return [Remove(things=self._all_if_plural(gone), quote=self.quote(at, end))], end

    def _left_by(self, left: Item) -> Place | None:
        """Return the room or the furniture that something leaves; None for others."""
        if left.is_room:
            return Place(rooms=left.rooms())
        if not (left.phrase.definite and self.lexicon.carries(left.phrase.noun.words)):
            return None
        return Place(anchor=left.phrase.things(), rooms=joined_places(list(left.places))[0].rooms)

    def _goes_for(self, item: Item, at: int, start: int) -> tuple[list[Statement], int] | None:
        """Read ``the armchair goes for a beanbag``: something new comes in its place.

        Raises
        ------
        NotUnderstood
            Where it goes for what is there: whether that moves too is not told.
        """
        new = self.phrase(at + 1) if self.text(at) == "for" else None
        if new is None or new.noun.kind != "object" or new.noun.unknown or item.is_room:
            return None
        if new.definite or new.refers or new.amount.kind != "some":
            raise NotUnderstood(start, new.end)
        gone = self._all_if_plural(self._within_frame(item.things()))
        return [Replace(things=gone, by=new.things(), quote=self.quote(start, new.end))], new.end

    def _ends_with_out(self, at: int) -> bool:
        """Whether a clause ends with ``out``: ``the desk and the chair go out``."""
        ends = at + 1 >= len(self.words) or self.words[at + 1].kind == "mark" or self.text(at + 1) in JOINING
        return self.text(at) == "out" and ends

    def _bare_stays(self, item: Item, after: int, at: int) -> tuple[list[Statement], int]:
        """Read ``juice stays`` and ``monitor stays on it`` of things that are there, which adds none."""
        places, end = self.places(after)
        where = () if any(p.goal for p in places) else places
        end = end if where else after
        while self.text(end) in STAYING_AS_IT_IS:
            end += 1
        whole = Item(item.phrase, (*item.places, *where), end)
        return [Keep(things=self._bare_kept(whole), quote=self.quote(at, end))], end

    def _remaining(self, item: Item, after: int, at: int) -> tuple[list[Statement], int]:
        """Read ``only two chairs should remain in the hall``: what is more than that goes."""
        places, end = self.places(after)
        whole = Item(item.phrase, (*item.places, *places), end)
        kind: AmountKind = "at_most" if item.phrase.amount.kind == "exactly" else item.phrase.amount.kind
        things = msgspec.structs.replace(
            item.phrase.things(), amount=Amount(kind=kind, number=item.phrase.amount.number)
        )
        place, each = self._framed(whole.goal())
        return [Ensure(things=things, place=place, each=each, quote=self.quote(at, end))], end

    def _said_enough(self, item: Item, place: int, at: int, negated: bool) -> tuple[list[Statement], int] | None:
        """Read ``two chairs are enough in the hall``, ``one lamp will do``: what is more than that goes."""
        number = item.phrase.amount.number
        surplus = self._surplus(item, place, at)
        if surplus is not None and not negated:
            return surplus
        place -= self.text(place - 1) == "do" and place > item.end + 1
        enough = self.text(place) in ("enough", "sufficient", "plenty", "suffice") or self.text(place - 1) == "suffice"
        does = self.text(place) == "do" and self.text(place - 1) in ("will", "would")
        if negated or not number or item.phrase.definite or not (enough or does):
            return None
        places, end = self.places(place + 1)
        whole = Item(item.phrase, (*item.places, *places), end)
        things = msgspec.structs.replace(item.phrase.things(), amount=Amount(kind="at_most", number=number))
        goal, each = self._framed(whole.goal())
        if goal == Place() and not item.phrase.refers:
            return None
        return [Ensure(things=things, place=goal, each=each, quote=self.quote(at, end))], end

    def _surplus(self, item: Item, place: int, at: int) -> tuple[list[Statement], int] | None:
        """Read ``three chairs in the hall are one too many``, of which the next clause may say what becomes."""
        number, less = item.phrase.amount.number, self.words[place : place + 1]
        counted = bool(less) and less[0].kind == "number" and 0 < less[0].value < number
        if not counted or (self.text(place + 1), self.text(place + 2)) != ("too", "many") or item.phrase.definite:
            return None
        goal, each = self._framed(item.goal())
        if goal == Place():
            return None
        left = Amount(kind="at_most", number=number - int(less[0].value))
        whole = msgspec.structs.replace(item.phrase.things(), amount=Amount(number=number), plural=True)
        self.affirmed = with_place(whole, goal)
        things = msgspec.structs.replace(item.phrase.things(), amount=left)
        return [Ensure(things=things, place=goal, each=each, quote=self.quote(at, place + 3))], place + 3

    def _said_missing(self, item: Item, place: int, at: int, negated: bool) -> tuple[list[Statement], int] | None:
        """Read ``a glass is missing on the table``, which tells what the next clause is about."""
        told = not any(w.text in MODALS for w in self.words[item.end : place]) and not item.phrase.definite
        if self.text(place) != "missing" or negated or not told:
            return None
        places, end = self.places(place + 1)
        goal, _ = self._framed(joined_places([*item.places, *places]))
        number = max(1, item.phrase.amount.number)
        missing = msgspec.structs.replace(item.phrase.things(), amount=Amount(kind="more", number=number))
        self.topic = msgspec.structs.replace(missing, place=goal if goal != Place() else None)
        return [Mention(quote=self.quote(at, end))], end

    def _said_where(self, item: Item, place: int, at: int, negated: bool) -> tuple[list[Statement], int] | None:
        """Read ``should be on the desk``, ``should be reachable from the lobby``."""
        if self.text(place) in ("reachable", "accessible", "reached", "connected"):
            start: Things | Rooms | None = None
            end = place + 1
            if self.text(end) in ("from", "to"):
                found = self._end_of_way(end + 1)
                if found is not None:
                    start, end = found
            goal = item.rooms() if item.phrase.noun.kind in ("room", "both") else item.things()
            return [Reach(start=start, end=goal, quote=self.quote(at, end))], end
        if place == item.end or self.bothers(place):
            return None
        places, end = self.places(place)
        if not places:
            return None
        quote = self.quote(at, end)
        if negated:
            things = Item(item.phrase, places, end).things()
            if item.phrase.amount.kind in ("some",) and not item.phrase.definite:
                things = msgspec.structs.replace(things, amount=Amount(kind="all", number=0))
            return [Remove(things=things, quote=quote)], end
        whole = Item(item.phrase, places, end)
        if item.phrase.definite or item.phrase.refers or self._is_partitive(item.phrase):
            return [self._brought(item, places, quote)], end
        return self._there(whole, whole.goal(), quote), end

    def _said_good(self, item: Item, place: int, at: int, negated: bool) -> tuple[list[Statement], int] | None:
        """Read ``a mug would be nice``, and ``the desk is too bare``, which tells what comes next is about."""
        if self.text(place) in PRAISE:
            if negated or not any(w.text in MODALS for w in self.words[item.end : place]):
                return None
            return self._there(item, item.goal(), self.quote(at, place + 1)), place + 1
        if self.text(place) in ("face", "facing"):
            faced = self._said_to_face(item, place + 1, at)
            if faced is not None:
                return faced
            goal = self.item(place + 1)
            if goal is not None and not goal.is_room:
                quote = self.quote(at, goal.end)
                return [Turn(things=self._all_if_plural(item.things()), facing=goal.things(), quote=quote)], goal.end
        faced = self._said_to_look(item, place, at)
        if faced is not None:
            return faced
        verb = self.words[item.end].raw if item.end < len(self.words) else ""
        if verb in FAILING and place == item.end:
            self.topic = item.things()
            return [Mention(quote=self.quote(at, place + 1))], place + 1
        if self.text(item.end) not in ("is", "are", "look", "seem", "feel") or any(
            w.text in MODALS for w in self.words[item.end : place]
        ):
            return None
        stop = item.end + 1
        while (
            stop < len(self.words)
            and self.words[stop].kind == "word"
            and self.text(stop) not in ("and", "but", "so")
            and stop < item.end + 6
        ):
            stop += 1
        cramped = self._too_small(item.end + 1)
        if item.phrase.noun.kind in ("room", "both") and cramped:
            return [Mention(rooms=item.rooms(), quote=self.quote(at, cramped))], cramped
        told = self.words[item.end + 1 : stop]
        told = told[:-3] or told[:1] if self.bothers(stop - 3) else told
        named = any(self.lexicon.is_object((w.text,)) or self.lexicon.is_own_room((w.text,)) for w in told)
        scarce = {"enough", "sufficient"} & {w.text for w in told}
        if (
            not told
            or named
            or (negated and not scarce)
            or (stop < len(self.words) and self.words[stop].kind == "number")
        ):
            return None
        if item.is_room:
            self.frame = Place(rooms=item.rooms())
            return [Mention(rooms=item.rooms(), quote=self.quote(at, stop))], stop
        if item.phrase.refers != "last" or item.phrase.noun.words:
            self.topic = item.things()
        return [Mention(quote=self.quote(at, stop))], stop

    def _too_small(self, at: int) -> int:
        """Return the end of ``too narrow for one`` where ``so`` and a request follow; 0 for others."""
        if self.text(at) != "too" or self.text(at + 1) not in ("small", "narrow", "tight", "cramped", "full"):
            return 0
        end = at + 2
        if self.text(end) == "for" and self.text(end + 1) in ("one", "it", "that", "this", "them"):
            end += 2
        joint = end + (self.text(end) == ",")
        asked = self.text(joint) == "so" and verb_at(self.words, joint + 1, self.lexicon) is not None
        return end if asked else 0

    def _said_to_face(self, item: Item, place: int, at: int) -> tuple[list[Statement], int] | None:
        """Read ``the window`` that its front shall turn to; None for things."""
        faced = self.faced_spot(place)
        if faced is None:
            return None
        spot, end = faced
        return [Turn(things=self._all_if_plural(item.things()), spot=spot, quote=self.quote(at, end))], end

    def _said_to_look(self, item: Item, place: int, at: int) -> tuple[list[Statement], int] | None:
        """Read ``must look to the bed``, which its front shall turn to."""
        asked = any(word.text in MODALS for word in self.words[item.end : place])
        if not asked or self.text(place) != "look":
            return None
        if (self.text(place + 1), self.text(place + 2)) == ("out", "of"):
            return self._said_to_face(item, place + 3, at)
        if self.text(place + 1) not in ("to", "at", "towards", "toward"):
            return None
        spot = self._said_to_face(item, place + 2, at)
        if spot is not None:
            return spot
        goal = self.item(place + 2)
        if goal is None or goal.is_room:
            return None
        quote = self.quote(at, goal.end)
        return [Turn(things=self._all_if_plural(item.things()), facing=goal.things(), quote=quote)], goal.end

    def _said_colour(self, item: Item, place: int, at: int, negated: bool) -> tuple[list[Statement], int] | None:
        if negated or place == item.end:
            return None
        colour = self.colour_at(place)
        if colour is None:
            return None
        end = colour[2] + (self.text(colour[2]) == "one")  # "could the black chairs be white ones"
        return self._painted([item], colour[0], colour[1], self.quote(at, end)), end


def _is_one(item: Item) -> bool:
    """Whether ``a plant`` is spoken of, of which each of several has enough with one."""
    amount = item.phrase.amount
    return amount.kind == "some" and amount.number == 1 and not item.phrase.definite
