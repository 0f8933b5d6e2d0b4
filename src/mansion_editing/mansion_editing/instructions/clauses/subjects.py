"""Clauses with a subject and a predicate: "the lamp should be on"."""

from collections.abc import Sequence

import msgspec

from mansion_editing.instructions.clauses.items import Item, NotUnderstood, joined_places
from mansion_editing.instructions.clauses.wanting import Lacks
from mansion_editing.instructions.phrases.loads import end_of_load
from mansion_editing.instructions.phrases.places import ReadPlace
from mansion_editing.instructions.phrases.word_sets import BEFORE_COLOURS
from mansion_editing.instructions.phrases.words import BE, MODALS
from mansion_editing.instructions.statements import Add, Amount, Clear, Ensure, Mention, Place, Rooms, Statement, Things

__all__ = ["Subjects"]


class Subjects(Lacks):
    """Reads subjects, and what is said of them."""

    def _with_predicate(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``the lamp should be on``, ``the lobby needs two chairs``, ``nothing should be on the table``."""
        if self.text(at) == "nothing":
            return self._nothing(at)
        number = self._number_should_be(at) or self._only_thing(at)
        if number is not None:
            return number
        coming = self._coming(at)
        if coming is not None:
            return coming
        surface = self.surface(at)
        if surface is not None:
            end = surface[1]
            while self.text(end) in MODALS or self.text(end) in BEFORE_COLOURS:
                end += 1
            colour = self.colour_at(end)
            if colour is not None and end > surface[1] - 1:
                return self._painted(surface[0], colour[0], colour[1], self.quote(at, colour[2])), colour[2]
        return self._of_subjects(at)

    def _of_subjects(self, at: int, *, asked: bool = False) -> tuple[list[Statement], int] | None:
        """Read one subject or several, and what is said of them.

        Parameters
        ----------
        asked : bool
            It follows "make sure" or "I want", so that it tells what shall be and not what is.
        """
        subjects: list[Item] = []
        joined = self.text(at) in ("neither", "both", "either") and self.phrase(at + 1) is not None
        place = at + joined
        while True:
            item = self.item(place)
            if item is None:
                return None
            if any(read.source for read in item.places) and self.text(item.end) == ",":
                return None  # "all pens off the desk, the laptop can stay"
            item = self._with_load(item)
            subjects.append(self._named(item, subjects))
            after = self.conjunction(item.end)
            if self.predicate_follows(item.end) or self.text(item.end) in BE or not after or self.starts_clause(after):
                break
            place = after
        shared = all(s.phrase.definite or s.phrase.noun.plural or s.is_room for s in subjects)
        shared = shared or self.text(subjects[-1].end) in ("stay", "remain")
        shared = shared or self._go_there(subjects) or self._are_noted(subjects)
        subjects = self._at_one_place(subjects)
        last = subjects[-1].end
        follows = self.predicate_follows(last) or (asked and self.text(last) == "to")
        follows = follows or self._verb_of_lack(last, denied=False) is not None
        if len(subjects) > 1 and not (follows and (shared or joined)):
            return None
        denied = self.text(at) == "neither"
        lack = None if asked else self._told_to_lack(subjects, at, denied=denied) or self._told_empty(subjects, at)
        if lack is not None:
            return lack
        out: list[Statement] = []
        end = at
        for subject in subjects:
            found = self._predicate(subject, subjects[-1].end, at, denied=denied)
            if found is None:
                return None
            out += found[0]
            end = found[1]
        return out, end

    def _told_empty(self, subjects: Sequence[Item], at: int) -> tuple[list[Statement], int] | None:
        """Read ``the wardrobe is empty``, which tells how it is, before what is asked of it."""
        end = subjects[-1].end
        if len(subjects) > 1 or end >= len(self.words) or self.words[end].raw not in ("is", "are", "looks", "look"):
            return None
        end += 1 + (self.text(end + 1) in ("still", "quite", "completely", "totally", "so", "too", "now", "almost"))
        if self.text(end) not in ("empty", "bare") or not (
            end + 1 >= len(self.words) or self.words[end + 1].kind == "mark"
        ):
            return None
        item, quote = subjects[0], self.quote(at, end + 1)
        if not item.is_room:
            self.topic = item.things()
        return [Mention(rooms=item.rooms() if item.is_room else None, quote=quote)], end + 1

    def _with_load(self, item: Item) -> Item:
        """Return furniture that goes or comes with what is on it: ``the desk with everything on it``."""
        load = end_of_load(self.words, item.end) if item.phrase.definite and not item.is_room else 0
        goes = load and (self.text(load) in ("go", "leave", *MODALS) or self.conjunction(load))
        return Item(item.phrase, item.places, load) if goes else item

    def _at_one_place(self, subjects: list[Item]) -> list[Item]:
        """Return ``the cup and the glass in the cabinet`` as both in it; furniture is not on what small things are."""
        last = subjects[-1]
        alone = any(item.places or not item.phrase.definite or item.is_room for item in subjects[:-1])
        told = last.phrase.definite or (last.phrase.noun.plural and subjects[0].phrase.amount.kind == "all")
        if alone or not last.places or not told or last.is_room or any(p.goal for p in last.places):
            return subjects
        held = last.places[0].place.anchor is not None and not self.lexicon.stands(last.phrase.noun.words)
        if held and any(self.lexicon.stands(item.phrase.noun.words) for item in subjects[:-1]):
            return subjects
        return [*(Item(item.phrase, last.places, item.end) for item in subjects[:-1]), last]

    def _go_there(self, subjects: list[Item]) -> bool:
        """Whether new things, each with an article or a number, go somewhere: ``a plate and two forks go in it``."""
        end = subjects[-1].end
        places, _ = self.places(end + 1)
        new = all(
            item.phrase.amount.kind == "some" and item.phrase.amount.number > 0 and not self._is_bare(item.phrase)
            for item in subjects
        )
        known = any(item.phrase.definite or item.phrase.refers or item.is_room or item.places for item in subjects)
        return self.text(end) == "go" and bool(places) and not any(p.source for p in places) and new and not known

    def _are_noted(self, subjects: Sequence[Item]) -> bool:
        """Whether a list is written without articles, as in notes, and it is said what stays, goes or is misplaced."""
        end = subjects[-1].end
        said = self.text(end) in MODALS or self.text(end) in ("go", "leave", "disappear", "vanish")
        misplaced = (
            self.text(end) in ("has", "have") and self.text(end + 1) == "no" and self.text(end + 2) == "business"
        )
        named = [s for s in subjects if not (s.phrase.definite or s.phrase.noun.plural or s.is_room)]
        return (said or misplaced) and all(self._is_bare(item.phrase) and not item.places for item in named)

    def _coming(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``a desk with a lamp on it and an office chair come in``: new things."""
        new: list[tuple[Item, Item | None]] = []
        place = at
        while True:
            item = self.item(place)
            if item is None or item.is_room or item.phrase.definite or item.phrase.refers or item.phrase.noun.unknown:
                return None
            end, companion = item.end, None
            if self.text(end) == "with":
                companion = self._on_it(self.item(end + 1))
                if companion is None or not _is_on_it(companion):
                    return None
                end = companion.end
            new.append((item, companion))
            place = self.conjunction(end)
            if not place:
                break
        while self.text(end) in MODALS or self.text(end) in ("also", "then", "to", "now", "has", "have", "is", "are"):
            end += 1
        if self.text(end) != "come" and (self.text(end), self.text(end + 1)) != ("go", "in"):
            return None
        if self.text(end) == "go" and self.phrase(end + 2) is not None:
            return None  # "two apples go in the bowl"
        places, stop = self.places(end + 1)
        if not places and self.text(end + 1) not in ("in", "along", "inside"):
            return None
        stop = stop if places else end + 2
        goal, each = self._framed(joined_places(places) if places else (Place(), False))
        goal = Place(rooms=Rooms(same=True)) if goal == Place() else goal
        quote = self.quote(at, stop)
        out: list[Statement] = []
        for thing, companion in new:
            out.append(Add(things=thing.phrase.things(), place=goal, each=each, quote=quote))
            if companion is not None:
                on_it = joined_places(companion.places)[0]
                out.append(Add(things=companion.phrase.things(), place=on_it, quote=quote))
        return out, stop

    def _on_it(self, companion: Item | None) -> Item | None:
        """Return ``with a lamp`` as a lamp on what it comes with; what stands itself has a place of its own."""
        if companion is None or companion.places or self.lexicon.stands(companion.phrase.noun.words):
            return companion
        it = Things(refers="last", definite=True, amount=Amount(number=0))
        on_it = ReadPlace(Place(relation="on", anchor=it), companion.end, companion.end)
        return Item(companion.phrase, (on_it,), companion.end)

    def _only_thing(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``the only thing on the table should be a vase``."""
        if (
            self.text(at) != "the"
            or self.text(at + 1) != "only"
            or self.text(at + 2) not in ("thing", "object", "item")
        ):
            return None
        places, end = self.places(at + 3)
        while self.text(end) in MODALS or self.text(end) in BE:
            end += 1
        if not places or end == places[-1].end:
            return None
        kept = self.items(end)
        where, quote = joined_places(places)[0], self.quote(at, kept[-1].end)
        out: list[Statement] = [Ensure(things=item.phrase.things(), place=where, quote=quote) for item in kept]
        spare = tuple(self._all(item.phrase.things()) for item in kept)
        return [*out, Clear(place=where, spare=spare, quote=quote)], kept[-1].end

    def _number_should_be(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``the number of apples on the desk should be 2``."""
        place = at + (self.text(at) == "the")
        if self.text(place) != "number" or self.text(place + 1) != "of":
            return None
        item = self.item(place + 2)
        if item is None:
            return None
        end = item.end
        while self.text(end) in MODALS or self.text(end) in BE or self.text(end) in ("to", "exactly", "has"):
            end += 1
        if end >= len(self.words) or self.words[end].kind != "number":
            return None
        amount = Amount(kind="exactly", number=int(self.words[end].value))
        things = msgspec.structs.replace(item.phrase.things(), amount=amount, definite=False)
        return [Ensure(things=things, place=self._framed(item.goal())[0], quote=self.quote(at, end + 1))], end + 1

    def _nothing(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``nothing should be on the table except the vase``."""
        way = self._reaching(at, at)
        if way is not None:
            return way
        if self.text(at + 2) == "(":
            return [Mention(quote=self.quote(at, at + 2))], at + 2
        place = at + 1
        if self.text(place) in ("but", "except"):
            items = self.items(place + 1 + (self.text(place + 1) == "for"))
            goal, _ = self._framed(self._shared_goal(items, items[0]))
            if goal != Place():
                end = items[-1].end
                quote = self.quote(at, end)
                kept = tuple(self._all(item.phrase.things()) for item in items)
                there: list[Statement] = [
                    Ensure(things=item.phrase.things(), place=goal, quote=quote) for item in items
                ]
                return [*there, Clear(place=goal, spare=kept, quote=quote)], end
        spare: tuple[Things, ...] = ()
        place, spare = self.exceptions(place + (self.text(place) == "else"))
        bare = place == at + 1
        while (
            self.text(place) in MODALS
            or self.text(place) in BE
            or self.text(place) in ("else", "left", "remain", "lie", "stand")
        ):
            place += 1
        places, end = self.places(place)
        if bare and place == at + 1 and self.follows and places:
            raise NotUnderstood(at, end)  # "put two eggs in the fridge and nothing in the sink" empties nothing
        if not places:
            return None
        if not spare:
            end, spare = self.exceptions(end)
        return [Clear(place=self._framed(joined_places(places))[0], spare=spare, quote=self.quote(at, end))], end


def _is_on_it(item: Item) -> bool:
    """Whether something is on or in what was named before it: ``a lamp on it``."""
    anchor = joined_places(item.places)[0].anchor if item.places else None
    return anchor is not None and anchor.refers == "last" and not anchor.noun
