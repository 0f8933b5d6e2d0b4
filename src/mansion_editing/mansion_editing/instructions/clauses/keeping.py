"""What is left as it is, or kept in a state."""

import msgspec

from mansion_editing.instructions.clauses.arranging import Arranging
from mansion_editing.instructions.clauses.items import Item, NotUnderstood, joined_places
from mansion_editing.instructions.clauses.removing import Removing
from mansion_editing.instructions.clauses.staying import Staying
from mansion_editing.instructions.clauses.too_many import TooMany
from mansion_editing.instructions.clauses.wishes import Wishes
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import (
    ALL_THE_REST,
    KEPT_AS_IT_IS,
    LEFT_ALONE,
    LEFT_AS_IT_IS,
    LEFT_SO,
)
from mansion_editing.instructions.phrases.words import STATE_WORDS
from mansion_editing.instructions.statements import (
    Amount,
    Clear,
    Keep,
    Mention,
    Move,
    Paint,
    Place,
    Remove,
    SetState,
    Statement,
    Things,
)

__all__ = ["Keeping"]


class Keeping(Staying, Wishes, TooMany, Arranging, Removing):
    """Reads ``leave``, ``keep`` and ``let``."""

    def _staying(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``only the candles may stay on it``, an exception to what was cleared before."""
        whole = self._only_stays(at, placed=False)
        places, end = ((), 0) if whole is None else self.places(whole[1])
        place = joined_places(list(places))[0] if places else self.frame
        if whole is not None and place.anchor is not None and place.anchor.noun and place.relation in ("on", "in"):
            return [Clear(place=place, spare=whole[0], quote=self.quote(at, end))], end
        staying = self._only_stays(at)
        if staying is None or self.places(staying[1])[0]:
            return None
        return [Keep(things=things, quote=self.quote(at, staying[1])) for things in staying[0]], staying[1]

    def _leave(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``leave the sofa alone``, ``leave the door open``, ``leave two mugs on the desk``."""
        if self.text(place) == "nothing":
            nothing = self._nothing(place)
            if nothing is not None:
                return nothing
        if self.text(place) == "only":
            only = self._only_left(at, place + 1)
            if only is not None:
                return only
        left = self._left_over(at, place)
        if left is not None:
            return left
        rest = self._end_of_rest_left(place)
        if rest:
            return [Mention(quote=self.quote(at, rest))], rest
        way = self._way_stays_free(at, place, kept=True)
        if way is not None:
            return way
        items = self.items(place)
        return self._others_elsewhere(at, items) or self._left_so(at, items) or self._left_there(at, place, items)

    def _end_of_rest_left(self, at: int) -> int:
        """Return the end of ``all else as it is``, ``the rest there`` that is left; 0 for other words."""
        rest = at
        while self.text(rest) in ALL_THE_REST:
            rest += 1
        if rest > at and self.text(rest) in LEFT_ALONE:
            while self.text(rest) in LEFT_AS_IT_IS:
                rest += 1
            if self.phrase(rest) is None:
                return rest
        others_there = self._rest_there(at)
        if not others_there or others_there <= at + 1:
            return 0
        there = self.places(others_there)[1]
        while self.text(there) in LEFT_AS_IT_IS:
            there += 1
        return there if there >= len(self.words) or self.words[there].kind == "mark" else 0

    def _left_so(self, at: int, items: list[Item]) -> tuple[list[Statement], int] | None:
        """Read ``leave the door open``, ``leave both lamps on in the hall``."""
        end = self._past_there(items[-1].end)
        stated = end
        while self.text(stated) in LEFT_SO:
            stated += 1
        if self.text(stated) not in STATE_WORDS or not (stated == end or self.phrase(stated + 1) is None):
            return None
        state, value = STATE_WORDS[self.text(stated)]
        where, stop = self.places(stated + 1)
        quote = self.quote(at, stop)
        placed = [Item(i.phrase, (*i.places, *where), stop) for i in items]
        return [self._state_of(placed, i, state, (), quote, value=value) for i in placed], stop

    def _past_there(self, at: int) -> int:
        return at + (self.text(at) in ("inside", "there", "here"))

    def _left_there(self, at: int, place: int, items: list[Item]) -> tuple[list[Statement], int]:
        """Read ``leave the sofa alone``, and ``leave two mugs on the desk``, which puts them there."""
        where_they_are = [i for i in items if i.phrase.definite and i.places and i.places[-1].place.former is not None]
        if where_they_are and self.text(at) in ("leave", "keep") and where_they_are == items[-1:]:
            stays = [*items[:-1], Item(items[-1].phrase, items[-1].places[:-1], items[-1].end)]
            quote = self.quote(at, items[-1].end)
            return [Keep(things=self._kept(i), quote=quote) for i in stays], items[-1].end
        item, end = items[0], self._past_there(items[-1].end)
        if item.phrase.amount.of and self.text(at) == "leave":
            raise NotUnderstood(at, end)  # "leave two of the three sofas in the hall": what becomes of the third?
        alone = end
        while self.text(alone) in KEPT_AS_IT_IS:
            alone += 1
        goal = item.goal()[0].rooms
        fetched = item.phrase.refers == "last" and not item.phrase.noun.words and goal is not None and bool(goal.words)
        if fetched and alone == end and len(items) == 1:
            return self._add(at, place)  # "take the ladder and leave it in the hall"
        there = item.phrase.definite and self.text(end - 1) == "there"  # "leave the brown one in there"
        if there or alone > end or (item.phrase.definite and not any(p.place.relation for p in item.places)):
            quote = self.quote(at, alone)
            return [Keep(things=self._kept(i), quote=quote) for i in items], alone
        return self._add(at, place)

    def _only_left(self, at: int, place: int) -> tuple[list[Statement], int] | None:
        """Read ``leave only the vase on the table``: all else that lies there goes."""
        items = self.items(place)
        where, _ = self._framed(joined_places(list(items[-1].places)))
        if where.relation not in ("on", "in") or where.anchor is None or not all(i.phrase.definite for i in items):
            return None
        quote = self.quote(at, items[-1].end)
        return [Clear(place=where, spare=tuple(item.phrase.things() for item in items), quote=quote)], items[-1].end

    def _only_kept(self, at: int, place: int) -> tuple[list[Statement], int] | None:
        """Read ``keep just laptop + lamp on it``: what furniture is cleared of is all but these."""
        items = self.items(place)
        if not all(self._are_those_there(item.phrase) for item in items):
            return None
        where = joined_places(list(items[-1].places))[0]
        quote = self.quote(at, items[-1].end)
        spare = tuple(self._all(self._as_those_there(item.phrase)) for item in items)
        if where == Place() and self.frame.anchor is None:
            return [Keep(things=things, quote=quote) for things in spare], items[-1].end
        where, _ = self._framed((where, False))
        if where.relation not in ("on", "in") or where.anchor is None:
            return None
        return [Clear(place=where, spare=spare, quote=quote)], items[-1].end

    def _others_elsewhere(self, at: int, items: list[Item]) -> tuple[list[Statement], int] | None:
        """Read ``leave one chair at the table and put the other one ...``: all but one of those there."""
        phrase, end = items[0].phrase, items[0].end
        after = self.conjunction(end) or self.skip(end)
        verb = verb_at(self.words, after, self.lexicon)
        other = None if verb is None else self.phrase(verb[1])
        number = phrase.amount.number
        if len(items) > 1 or phrase.definite or not number or phrase.amount.kind not in ("some", "exactly"):
            return None
        if other is None or other.refers != "others" or other.noun.words not in ((), phrase.noun.words):
            return None
        said, stop = self.read(after)
        one = not other.plural
        amount = Amount(kind="all_but", number=number, of=number + 1 if one else 0)
        place, _ = self._framed(joined_places(list(items[0].places)))
        rest = Things(noun=" ".join(phrase.noun.words), amount=amount, definite=True, plural=True)
        rest = rest if place == Place() else msgspec.structs.replace(rest, place=place)
        quote = self.quote(at, stop)
        out: list[Statement] = []
        for statement in said:
            if not isinstance(statement, Move | Remove | SetState | Paint) or statement.things.refers != "others":
                return None
            out.append(msgspec.structs.replace(statement, things=rest, quote=quote))
        return out, stop

    def _keep(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``keep the door closed``, ``keep the sofa``, ``keep the desk free of mugs``."""
        left = self._left_over(at, place)
        if left is not None:
            return left
        if self.text(place) in ("only", "just"):
            only = self._only_kept(at, place + 1)
            if only is not None:
                return only
        item = self.item(place)
        if item is None:
            raise NotUnderstood(at, self.boundary(at))
        if self._is_way(item.phrase):
            return self._way_stays_free(at, place, kept=True) or self._way(at, item.phrase.end)
        found = (
            self._predicate(item, item.end, at)
            if self.text(item.end) in STATE_WORDS or self.predicate_follows(item.end)
            else None
        )
        if found is not None:
            return found
        if self._is_bare(item.phrase):
            items = self.items(place)
            if not all(self._are_those_there(i.phrase) for i in items):
                raise NotUnderstood(at, items[-1].end)
            quote = self.quote(at, items[-1].end)
            return [Keep(things=self._bare_kept(i), quote=quote) for i in items], items[-1].end
        if (item.phrase.definite or item.phrase.refers) and self.text(item.end) not in (
            "as",
            "where",
            "alone",
            "untouched",
        ):
            items = self.items(place)
            quote = self.quote(at, items[-1].end)
            return [Keep(things=self._kept(i), quote=quote) for i in items], items[-1].end
        if item.phrase.definite or item.phrase.refers:
            return self._leave(at, place)
        if not item.phrase.definite:
            items = self.items(place)
            quote = self.quote(at, items[-1].end)
            return [s for i in items for s in self._there(i, self._shared_goal(items, i), quote)], items[-1].end
        raise NotUnderstood(at, self.boundary(at))

    def _let(self, at: int, place: int) -> tuple[list[Statement], int]:
        if self.text(place) in ("us", "me"):
            return self.read(place + 1)
        if self.text(place) == "there":
            found = self._existential(place, asked=True)
            if found is not None:
                return found
        surface = self.surface(place)
        colour = self.colour_at(surface[1] + 1) if surface is not None and self.text(surface[1]) == "be" else None
        if surface is not None and colour is not None:
            return self._painted(surface[0], colour[0], colour[1], self.quote(at, colour[2])), colour[2]
        item = self.item(place)
        if item is not None:
            found = self._predicate(item, item.end, at)
            if found is not None:
                return found
            if self.text(item.end) in ("stay", "remain", "be"):
                return self._leave(at, place)
        raise NotUnderstood(at, self.boundary(at))
