"""What somebody wants, and what there should be."""

from typing import Final

import msgspec

from mansion_editing.instructions.clauses.coordination import is_one_list
from mansion_editing.instructions.clauses.items import Item, NotUnderstood, joined_places
from mansion_editing.instructions.clauses.negations import Negations
from mansion_editing.instructions.clauses.subjects import Subjects
from mansion_editing.instructions.phrases.noun_phrases import NounPhrase
from mansion_editing.instructions.phrases.places import with_place
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import (
    AFTER_CHECKS,
    AFTER_MODALS,
    ANY_LONGER,
    BEFORE_REQUESTS,
    BEFORE_WISHES,
    EXISTENCE,
    OPINIONS,
    PEOPLE,
    PRAISE,
    RESTING_VERBS,
    ROLLING,
    SOMEBODY,
    THIRD_PERSON_WISHES,
    TOLD_EXISTENCE,
    WISHES,
)
from mansion_editing.instructions.phrases.words import BE, MODALS
from mansion_editing.instructions.statements import Amount, Forbid, Mention, Place, Statement, Things

__all__ = ["Wishes"]

_ALL: Final = Amount(kind="all", number=0)
_DISUSED: Final = frozenset("like use play watch read wear".split())
"""Verbs of what somebody does not do with a thing, which the next clause is about."""


class Wishes(Subjects, Negations):
    """Reads ``I want``, ``there should be``, ``can you`` and ``make sure that``."""

    def _existential(self, at: int, *, asked: bool = False) -> tuple[list[Statement], int] | None:
        """Read ``there should be four chairs in the break room``.

        Parameters
        ----------
        asked : bool
            It follows "make sure" or "I want", so that it tells what shall be and not what is.
        """
        if self.text(at) != "there":
            return None
        place = at + 1
        contracted = self.words[at].raw in ("there's", "theres")
        while self.text(place) in MODALS or self.text(place) in EXISTENCE:
            if self.text(place) in ("no", "not") and self.text(place + 1) in ("more", "fewer", "less"):
                break
            place += 1
        if place == at + 1 and not contracted:
            return None
        between = {w.text for w in self.words[at:place]}
        negated = "not" in between or "no" in between
        past = bool(between & {"was", "were"}) and not asked
        told = not asked and between <= TOLD_EXISTENCE and (negated or self.text(place) == "no")
        if self.text(place) == "too" and self.text(place + 1) in ("many", "much") and not asked:
            much = self.items(place + 2)[-1]
            self.topic = self._framed_things(much)
            return [Mention(quote=self.quote(at, much.end))], much.end
        items = self.items(place)
        if self._is_way(items[0].phrase):
            return self._way(at, items[0].phrase.end)
        end = items[-1].end
        if past or any(item.is_room for item in items):
            return [Mention(quote=self.quote(at, end))], end
        following = self._state_after(items[-1], end, at)
        if following is not None:
            return following
        only = {"there", "is", "are", "already", "still", "currently"}
        affirmed = not asked and not negated and len(items) == 1 and (between or {"is"}) <= only
        if affirmed and items[0].phrase.amount.kind == "some":
            self.affirmed = self._all_of_mass(items[0].phrase, self._framed_things(items[0]))
        if told or (not asked and items[0].phrase.amount.kind == "none" and between <= {"there", "is", "are"}):
            goal, _ = self._shared_goal(items, items[0])
            self.frame = Place(rooms=goal.rooms) if goal.rooms is not None else self.frame
            return [Mention(quote=self.quote(at, end))], end
        if len(items) == 1 and between <= only:
            self.topic = self._framed_things(items[0])
        out: list[Statement] = []
        for item in items:
            out += self._there(item, self._shared_goal(items, item), self.quote(at, end), negated=negated)
        return out, end

    def _inverted(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``on the counter are two tomatoes``, ``in the hall stands a plant``: what is there."""
        places, end = self.places(at)
        if not places and self.frame != Place():
            end = at
        elif not places or any(p.source or p.goal for p in places):
            return None
        word = self.words[end] if end < len(self.words) else None
        if word is None or word.raw not in RESTING_VERBS:
            return None
        item = self.item(end + 1, places=False)
        if item is None or item.is_room or item.phrase.definite or item.phrase.refers or item.phrase.noun.unknown:
            return None
        number = item.phrase.amount.number
        if item.phrase.amount.kind != "some" or not number or self.conjunction(item.end):
            return None
        place, each = self._framed(joined_places(places))
        things = with_place(item.phrase.things(), place)
        self.topic = self.affirmed = things
        quote = self.quote(at, item.end)
        return self._there(item, (place, each), quote), item.end

    def _all_of_mass(self, phrase: NounPhrase, things: Things) -> Things:
        """Return all that is told to be there where a noun has neither an article nor a number: ``there is beer``."""
        bare = not phrase.definite and not phrase.plural and self.text(phrase.start) in phrase.noun.words
        return msgspec.structs.replace(things, amount=Amount(kind="all", number=0), plural=True) if bare else things

    def _framed_things(self, item: Item) -> Things:
        """Return things with their place and that which the sentence began with."""
        place, _ = self._framed(joined_places(list(item.places)))
        return item.phrase.things() if place == Place() else with_place(item.phrase.things(), place)

    def _desired(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``I want``, ``can you``, ``is it possible to``, ``let us`` and what follows."""
        place = at
        who = self.text(place)
        if who in ("i", "we", "you", "one", "they"):
            return self._desired_by(at)
        if who == "it":
            return self._would_be_good(at)
        if who == "what" and self.text(place + 1) in ("i", "we") and self.text(place + 3) == "is":
            return self._wanted(at, place + 4)
        if who in MODALS and self.text(place + 1) == "it" and self.text(place + 3) == "possible":
            return self._wanted(at, place + 4 + (self.text(place + 4) == "for"))
        if who in MODALS and self.text(place + 1) in ("you", "we", "i", "somebody", "someone", "anybody", "anyone"):
            place += 2
            while self.text(place) in BEFORE_REQUESTS:
                place += 1
            if self.text(place) in ("have", "get") and who in ("can", "could", "may", "might"):
                return self._wanted(at, place + 1)
            return self.read(place)
        if who in MODALS and self.text(place + 1) == "there":
            return self._existential(place + 1, asked=True)
        if who in MODALS and self.text(place + 1) not in ("not", "it"):
            found = self._asked_of_subjects(at, place + 1)
            if found is not None:
                return found
        if self.words[at].raw == "let's":
            return self.read(place + 1)
        if who == "let" and self.text(place + 1) in ("us", "me", "there"):
            return self.read(place + 1 + (self.text(place + 1) != "there"))
        return None

    def _asked_of_subjects(self, at: int, place: int) -> tuple[list[Statement], int] | None:
        """Read ``could the frame and the vase from it please stand on the dresser`` after its modal verb."""
        subjects: list[Item] = []
        while (item := self.item(place)) is not None:
            subjects.append(self._named(item, subjects))
            place = self.conjunction(item.end)
            if not place:
                break
        if not subjects or place:
            return None
        shared = subjects[-1].places if not any(item.places for item in subjects[:-1]) else ()
        end = subjects[-1].end
        while self.text(end) in BEFORE_REQUESTS and self.text(end) not in AFTER_MODALS:
            end += 1
        if self.text(end) not in AFTER_MODALS or not all(s.phrase.definite or len(subjects) == 1 for s in subjects):
            return None
        out: list[Statement] = []
        stop = end
        for item in subjects:
            whole = item if item.places or not shared else Item(item.phrase, shared, item.end)
            found = self._predicate(Item(whole.phrase, whole.places, end), end, at)
            if found is None:
                return None
            out += found[0]
            stop = found[1]
        return out, stop

    def _would_be_good(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``it would be nice if there was a bench``, ``it would be good to have two lamps``."""
        place = at + 1
        while self.text(place) in MODALS or self.text(place) in BE or self.text(place) in ("really", "very", "d"):
            place += 1
        if place == at + 1 or self.text(place) not in PRAISE or "not" in (w.text for w in self.words[at:place]):
            return None
        place += 1
        if self.text(place) == "to":
            return self._wanted(at, place)
        if self.text(place) not in ("if", "that") or not self.words[place + 1 :]:
            return None
        asked = self.text(place + 1) in ("you", "we", "somebody", "someone") and self.text(place + 2) in MODALS
        return self.read(place + 3) if asked else self._check(at, place + 1)

    def _desired_by(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``I want``, ``we do not need``, ``I think that`` and what follows."""
        place = at + 1
        while self.text(place) in MODALS or self.text(place) in BEFORE_WISHES:
            place += 1
        place += self.text(place) == "rather" and self.text(place + 1) != "not"
        if self.text(place) in OPINIONS:
            return self.read(place + 1 + (self.text(place + 1) in ("that", "you")) + (self.text(place + 2) == "to"))
        disliked = self.text(place + 1) in _DISUSED and "would" not in (w.text for w in self.words[at:place])
        if self.text(place) == "not" and disliked:
            items = self.items(place + 2)
            self.topic = items[0].things()
            end = items[-1].end
            while self.text(end) in ANY_LONGER:
                end += 1
            return [Mention(quote=self.quote(at, end))], end
        if self.text(place) == "not" and self.text(place + 1) in ("want", "like", "wish"):
            return self._unwanted(at, place + 2)
        longer = {"anymore", "longer"} & {w.text for w in self.words} or "any more" in self.quote(at, len(self.words))
        if self.text(place) == "not" and self.text(place + 1) == "need" and longer:
            return self._unwanted(at, place + 2)
        if self.text(place) == "not":
            raise NotUnderstood(at, self.boundary(at))
        if self.text(place) == "rather" and self.text(place + 1) == "not":
            return self._unwanted(at, place + 2)
        pleased = self.text(place) == "be" and self.text(place + 1) in ("glad", "happy", "grateful", "pleased")
        if pleased and self.text(place + 2) in ("of", "with", "about", "for"):
            return self._wanted(at, place + 3)
        if self.text(place) in ("was", "am", "were", "are") and self.text(place + 1) in ("hoping", "looking"):
            return self._wanted(at, place + 2)
        if self.text(place) in WISHES:
            return self._wanted(at, place + 1)
        if {"could", "can"} & {w.text for w in self.words[at:place]}:
            with_it = self.text(place) == "do" and self.text(place + 1) == "with"
            if self.text(place) == "use" or with_it:
                return self._wanted(at, place + 1 + with_it)
        if self.text(at) == "you" and place > at + 1:
            return self.read(self.skip(place))
        return None

    def _going(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``the nurse must be able to walk from the lobby to the lab``."""
        if self.text(at) in ("there", "make", "check", "ensure", "verify"):
            return None
        if self.text(at) == "one" and self.text(at + 1) == "go":
            return None  # "two chairs stay, one goes to the hall"
        subject = self.item(at)
        if subject is not None and subject.phrase.noun.kind == "object" and not self._is_way(subject.phrase):
            rolls = not subject.phrase.definite and subject.phrase.noun.words[-1] in ROLLING and not subject.places
            return self._reaching(at, at) if rolls else None
        return self._reaching(at, at)

    def _of_persons(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``the officer on duty wants a phone on the desk``: what persons want, who are no part of the scene."""
        if self.text(at) == "nobody" or (self.text(at) in ("no", "none") and self.text(at + 1) in ("one", "of")):
            return None
        wanted = self._of_persons_in_room(at)
        if wanted is not None:
            return wanted
        for place in range(at + 1, min(at + 8, len(self.words))):
            word = self.words[place]
            before = self.words[at:place]
            if self.lexicon.is_way(word.text) and {"have", "has", "need"} & {w.text for w in before}:
                return self._way(at, place + 1)
            if word.raw in ("like", "love") and "would" in {w.text for w in before}:
                return self._wanted(at, place + 1)
            known = any(self.lexicon.is_own_room((w.text,)) or self.lexicon.is_object((w.text,)) for w in before)
            if known and not {"would", "have", "has"} & {w.text for w in self.words[at : place + 2]}:
                return None
            if word.raw == "asked" and self.text(place + 1) == "for":
                return self._wanted(at, place + 2)
            having = {"have", "has", "need"} & {w.text for w in before}
            if having:
                continue
            if word.kind == "mark" or word.text in BE:
                return None
            if word.raw in THIRD_PERSON_WISHES and self.item(at) is None:
                return self._wanted(at, place + 1)
        return None

    def _of_persons_in_room(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``the guests in guest room 3 want two pillows on their bed``: what they want is in that room."""
        place = at + (self.text(at) in ("the", "our", "my", "a", "an"))
        if self.text(place) not in PEOPLE:
            return None
        places, end = self.places(place + 1)
        rooms = joined_places(places)[0].rooms
        verb = self.words[end].raw if end < len(self.words) else ""
        would = verb == "would" and self.text(end + 1) in ("like", "love")
        asked = self.text(end) in ("ask", "asked") and self.text(end + 1) == "for"
        if rooms is None or not (would or asked or verb in THIRD_PERSON_WISHES | {"want", "need", "require"}):
            return None
        self.frame = Place(rooms=rooms)
        return self._wanted(at, end + 1 + (would or asked))

    def _unwanted(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``we do not want any chairs in the lobby``: they are to go."""
        while self.text(place) in ("to", "see", "have", "find", "there", "be") or self.text(place) in ANY_LONGER:
            place += 1
        place += 2 * (self.text(place) == "you" and self.text(place + 1) == "to")
        verb = verb_at(self.words, place, self.lexicon)
        if verb is not None:
            return self._negated_verb(at, *verb)
        items = self.items(place)
        named = self.words[place : items[-1].end]
        end = items[-1].end
        while self.text(end) in ANY_LONGER:
            end += 1
        quote = self.quote(at, end)
        if {"new", "more", "further", "additional", "another", "extra"} & {w.text for w in named}:
            goals = [self._framed(self._shared_goal(items, item))[0] for item in items]
            things = [msgspec.structs.replace(item.phrase.things(), amount=_ALL) for item in items]
            return [Forbid(things=one, place=goal, quote=quote) for one, goal in zip(things, goals, strict=True)], end
        return [self._removed(items, item, (), (), quote) for item in items if not item.is_room], end

    def _wanted(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read what is wanted: a clause after ``to``, a thing with a predicate, or a thing."""
        place += self.text(place) in ("for", "me", "us") or (self.text(place) == "that" and not self._points_at(place))
        door = self._door_between(at, place)
        if door is not None:
            return door
        painted = self._surface_wanted(at, place)
        if painted is not None:
            return painted
        if self.text(place) == "nothing":
            nothing = self._nothing(place)
            if nothing is not None:
                return nothing
        if self.text(place) == "to" and self.text(place + 1) in ("have", "see", "get", "find"):
            place += 2
        elif self.text(place) == "to":
            return self._wanted_to_do(at, place + 1)
        if self.text(place) == "you" and self.text(place + 1) == "to":
            return self.read(place + 2)
        if self.text(place) == "you" and verb_at(self.words, place + 1, self.lexicon) is not None:
            return self.read(place + 1)
        if self.text(place) == "there":
            found = self._existential(place, asked=True)
            if found is not None:
                return found
        several = self._several_subjects(place)
        if several is not None and not {self.text(several[0]), self.words[several[0]].raw} & (MODALS | {"is", "are"}):
            return several[1]
        item = self.item(place)
        if item is None:
            raise NotUnderstood(place, self.boundary(place))
        if self._is_way(item.phrase):
            return self._way(at, item.phrase.end)
        if self.text(item.end) in ("to", "be") or self.predicate_follows(item.end):
            found = self._predicate(item, item.end, at)
            if found is not None:
                return found
        return self._wanted_things(at, place)

    def _wanted_to_do(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read what somebody wants to do: a clause, or ``some work on the desk, so ...``, which tells of it."""
        item = self.item(place + 1) if verb_at(self.words, place, self.lexicon) is None else None
        if item is None:
            return self.read(place)
        following = (self.text(item.end), self.text(item.end + 1))
        if following[0] not in (",", "so", "and", "but") or "so" not in following:
            raise NotUnderstood(at, self.boundary(at))
        self.topic = item.things()
        return [Mention(quote=self.quote(at, item.end))], item.end

    def _wanted_things(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read things that are wanted at their places."""
        items = self.items(place)
        end = items[-1].end
        out: list[Statement] = []
        for each in items:
            kind = each.phrase.amount.kind
            if kind in ("exactly", "at_least", "at_most", "none", "all"):
                out += self._there(each, self._shared_goal(items, each), self.quote(at, end))
            elif each.is_room:
                raise NotUnderstood(place, end)
            else:
                out.append(self._added(items, each, self.quote(at, end)))
        return out, end

    def _surface_wanted(self, at: int, place: int) -> tuple[list[Statement], int] | None:
        """Read ``the walls in the study to be light green``, ``the floor of the hall in oak``."""
        surface = self.surface(place)
        if surface is None:
            return None
        end = surface[1] + (self.text(surface[1]) == "to")
        while self.text(end) in ("be", "painted", "done", "look", "have"):
            end += 1
        colour = self.colour_at(end)
        if colour is None:
            return None
        return self._painted(surface[0], colour[0], colour[1], self.quote(at, colour[2])), colour[2]

    def _points_at(self, at: int) -> bool:
        """Whether ``that`` belongs to a thing ("I want that lamp on the desk") and begins no clause."""
        item = self.item(at)
        one = item is not None and item.phrase.noun.kind == "object" and not item.phrase.noun.plural
        return item is not None and one and not self.predicate_follows(item.end)

    def _want(self, at: int, place: int) -> tuple[list[Statement], int]:
        return self._wanted(at, place)

    def _check(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``make sure that ...``: a way, or a clause that shall be true."""
        while self.text(place) in AFTER_CHECKS:
            place += 1
        found_by = self._found_by_somebody(at, place)
        if found_by is not None:
            return found_by
        way = self._way_stays_free(at, place) or self._reaching(at, place)
        if way is not None:
            return way
        existential = self._existential(place, asked=True)
        if existential is not None:
            return existential
        several = self._several_subjects(place)
        if several is not None:
            return several[1]
        item = self.item(place)
        if item is not None:
            found = self._predicate(item, item.end, at)
            if found is not None:
                return found
        if verb_at(self.words, place, self.lexicon) is not None:
            return self.read(place)
        items = self.items(place)
        end = items[-1].end
        out: list[Statement] = []
        for each in items:
            if self._is_way(each.phrase):
                return self._way(at, each.phrase.end)
            out += self._there(each, self._shared_goal(items, each), self.quote(at, end))
        return out, end

    def _several_subjects(self, at: int) -> tuple[int, tuple[list[Statement], int]] | None:
        """Read ``the lamp and the fan are off``, where all of the list is the subject; and where its verb is."""
        subjects = self.subjects(at) or self._listed_before_to(at)
        if len(subjects) < 2 or not is_one_list(self.words, subjects):
            return None
        found = self._of_subjects(at, asked=True)
        return None if found is None else (subjects[-1].end, found)

    def _listed_before_to(self, at: int) -> list[Item]:
        """Read ``the hall and the kitchen`` before ``to have no chairs``; empty where no such words follow."""
        found: list[Item] = []
        while (item := self.item(at)) is not None:
            found.append(item)
            if self.text(item.end) == "to":
                return found
            at = self.conjunction(item.end)
            if not at or self.starts_clause(at):
                break
        return []

    def _found_by_somebody(self, at: int, place: int) -> tuple[list[Statement], int] | None:
        """Read ``the robot will find a stapler on the desk``."""
        for k in range(place + 1, min(place + 6, len(self.words))):
            finding = self.text(k) in ("find", "see", "grab", "pick") and self.phrase(k + 1) is not None
            if finding and SOMEBODY & {w.text for w in self.words[place:k]}:
                return self._wanted(at, k + 1)
        return None
