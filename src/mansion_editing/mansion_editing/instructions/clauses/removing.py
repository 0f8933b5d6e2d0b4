"""Things that go, and rooms and furniture that are cleared."""

from collections.abc import Sequence

import msgspec

from mansion_editing.instructions.clauses.items import Item, NotUnderstood, joined_places
from mansion_editing.instructions.clauses.moving import Moving
from mansion_editing.instructions.phrases.word_sets import AWAY, STAYING_AS_IT_IS
from mansion_editing.instructions.phrases.words import MODALS
from mansion_editing.instructions.statements import Amount, Clear, Mention, Place, Remove, Statement, Things

__all__ = ["Removing"]


class Removing(Moving):
    """Reads ``remove``, ``clear`` and ``tidy``."""

    def _remove(self, at: int, place: int) -> tuple[list[Statement], int]:
        taking = self.text(at) in ("take", "pull", "move", "put", "get", "collect", "gather")
        if self.text(place) in ("from", "out", "off") and not taking:
            place = self._fronted(place)
        items = self.items(place)
        end = items[-1].end
        end = self._rubbish(end) or end
        wholly = self.text(end) in ("completely", "totally", "entirely")
        if self.text(at) == "clear" and self.text(at + 1) == "out" and wholly and all(i.is_room for i in items):
            return self._cleared_out(at, items, end + 1)
        holders = all(self.lexicon.encloses(i.phrase.noun.words) for i in items)
        if (self.text(at), self.text(at + 1)) == ("clear", "out") and holders and not _leaves(items[-1]):
            return self._clear(at, place)
        top = all(self.lexicon.stands(i.phrase.noun.words) for i in items) and not _leaves(items[-1])
        if (self.text(at), self.text(at + 1)) == ("clear", "off") and top:
            return self._clear(at, place)  # "clear off the table": not the table itself
        if taking and any(p.goal and not p.source for p in items[-1].places):
            return self._move(at, place)
        if self.text(at) == "put" and any(_holds(p.place) for p in items[-1].places if not (p.source or p.relative)):
            return self._move(at, place)  # "put away the mugs in the cupboard"
        if self.text(at) == "put":
            return self._put_away(items, self.quote(at, end)), end
        while self.text(end) in AWAY:
            end += 1
        more, end = self.places(end)
        end, besides = self.exceptions(end)
        late, end = self.places(end + 1) if besides and self.text(end) == "," else ((), end)
        more = (*more, *late)
        out: list[Statement] = []
        quote = self.quote(at, end)
        for item in items:
            if item.is_room:
                raise NotUnderstood(place, end)
            gone = self._removed(items, item, more, besides, quote)
            out.append(_taken_from(gone) if taking else gone)
        return out, end

    def _cleared_out(self, at: int, rooms: Sequence[Item], end: int) -> tuple[list[Statement], int]:
        """Return that furniture leaves rooms, and with it what is loose: ``clear out the bedroom completely``."""
        if self.exceptions(end)[1] or self._only_stays(end) is not None:
            raise NotUnderstood(at, self.boundary(at))
        quote = self.quote(at, end)
        out: list[Statement] = []
        for room in rooms:
            place = Place(rooms=room.rooms())
            whole = Things(noun="furniture", amount=Amount(kind="all", number=0), definite=True, place=place)
            out += [Remove(things=whole, quote=quote), Clear(place=place, quote=quote)]
        return out, end

    def _clear(self, at: int, place: int) -> tuple[list[Statement], int]:
        place += self.text(place) in ("up", "out", "off", "away")
        top = self._top_of(place)
        items = self.items(top or place)
        end = items[-1].end
        item = items[0]
        it = self._cleared_it(at, item, top=bool(top)) if len(items) == 1 else None
        if it is not None:
            return it
        comes_from = any(p.source or p.place.relation in ("on", "in") for p in item.places)
        furniture = item.phrase.noun.words == ("furniture",)  # it goes itself: "clear all furniture"
        out_of = any(p.source and self.text(p.start) == "out" for p in items[-1].places) and not item.is_room
        several = comes_from and not item.is_room and item.phrase.plural
        if item.phrase.noun.kind == "anything" or furniture or several or out_of:
            return self._remove(at, place)
        if self.text(end) == "of" or (
            item.places and item.places[-1].start and self.words[item.places[-1].start].text == "of"
        ):
            return self._cleared_of(at, item)
        wholly = self.text(end) in ("completely", "totally", "entirely")
        if wholly and self.text(at) in ("empty", "clear") and all(each.is_room for each in items):
            return self._cleared_out(at, items, end + 1)
        while self.text(end) in ("up", "out", "off", "completely", "totally", "entirely"):
            end += 1
        end, spare = self.exceptions(end)
        staying = self._only_stays(end)
        spare, end = (staying[0], staying[1]) if staying is not None and not spare else (spare, end)
        quote = self.quote(at, end)
        wholly = self.text(at) in ("empty", "vacate")
        return [Clear(place=self._emptied(each, wholly=wholly), spare=spare, quote=quote) for each in items], end

    def _top_of(self, at: int) -> int:
        """Return where furniture is named after ``the top of``; 0 where no such words stand there."""
        place = at + (self.text(at) == "the")
        named = self.text(place) in ("top", "surface", "tops") and self.text(place + 1) == "of"
        return place + 2 if named and self.phrase(place + 2) is not None else 0

    def _cleared_it(self, at: int, item: Item, *, top: bool) -> tuple[list[Statement], int] | None:
        """Read ``clear it``, ``clear the top of it``: what was named before is emptied, or goes where it is loose."""
        plain = item.phrase.refers == "last" and not (item.phrase.noun.words or item.places)
        if not plain or item.phrase.amount.number or self.text(item.end) in ("of", *AWAY):
            return None
        end, spare = self.exceptions(item.end)
        staying = self._only_stays(end)
        spare, end = (staying[0], staying[1]) if staying is not None and not spare else (spare, end)
        wholly = self.text(at) in ("empty", "vacate") and not top
        place = Place(relation="" if wholly else "on", anchor=item.phrase.things())
        return [Clear(place=place, spare=spare, quote=self.quote(at, end))], end

    def _only_stays(self, at: int, *, placed: bool = True) -> tuple[tuple[Things, ...], int] | None:
        """Read ``: only the laptop may remain``, ``, only the candles stay on it``; with the place where it is told."""
        place = at
        while self.text(place) in (",", ":", "-", "and", "but", "so", "that"):
            place += 1
        but = self.text(place) == "nothing" and self.text(place + 1) in ("but", "except")
        if not (but or self.text(place) in ("only", "just")) or self.item(place + 1 + but) is None:
            return None
        items = self._listed_up_to_verb(place + 1 + but)
        end = items[-1].end
        while self.text(end) in MODALS or self.text(end) in ("be", "is", "are", "to"):
            end += 1
        if self.text(end) not in ("stay", "remain", "left", "kept", "stand", "lie"):
            return None
        end += 1
        while self.text(end) in STAYING_AS_IT_IS and not self.places(end)[0]:
            end += 1
        places, stop = self.places(end)
        anchor = joined_places(list(places))[0].anchor
        on_it = anchor is not None and anchor.refers == "last" and not anchor.noun
        end = stop if placed and (on_it or all(item.phrase.definite for item in items)) else end
        return tuple(self._all(item.phrase.things()) for item in items), end

    def _listed_up_to_verb(self, at: int) -> list[Item]:
        """Read things joined by commas and ``and`` that a verb follows: ``the mug and one cup may stay``."""
        found: list[Item] = []
        while at and (item := self.item(at)) is not None:
            found.append(item)
            at = self.conjunction(item.end)
        return found

    def _tidy(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``tidy the hall``, which by itself asks for nothing that can be checked."""
        items = self.items(place)
        if any(p.source for item in items for p in item.places):
            return self._remove(at, place)
        end = items[-1].end
        end += self.text(end) in ("clean", "down", "properly", "up")
        end += 2 * ((self.text(end), self.text(end + 1)) in (("a", "bit"), ("a", "little")))
        staying = self._only_stays(end)
        if staying is not None:
            quote = self.quote(at, staying[1])
            return [Clear(place=self._emptied(each), spare=staying[0], quote=quote) for each in items], staying[1]
        rooms = items[0].rooms() if items[0].is_room else None
        return [Mention(rooms=rooms, quote=self.quote(at, end))], end

    def _cleared_of(self, at: int, item: Item) -> tuple[list[Statement], int]:
        """Read ``clear the lobby of chairs``."""
        joint = next(k for k in range(item.phrase.end, len(self.words)) if self.text(k) == "of")
        where = Item(item.phrase, tuple(p for p in item.places if p.end <= joint), joint)
        gone = self.items(joint + 1)
        end = gone[-1].end
        return self._gone_from(where, gone, self.quote(at, end)), end


def _holds(place: Place) -> bool:
    """Whether a place is in furniture."""
    return place.relation == "in" and place.anchor is not None


def _taken_from(gone: Statement) -> Statement:
    """Return a removal whose "away from" tells where things are: what is taken away from a desk is on it."""
    if not isinstance(gone, Remove) or gone.things.place is None or not gone.things.place.outside:
        return gone
    place = msgspec.structs.replace(gone.things.place, outside=False, relation="")
    return msgspec.structs.replace(gone, things=msgspec.structs.replace(gone.things, place=place))


def _leaves(item: Item) -> bool:
    """Whether things leave a place: ``the wardrobe from the hall``."""
    return any(place.source for place in item.places)
