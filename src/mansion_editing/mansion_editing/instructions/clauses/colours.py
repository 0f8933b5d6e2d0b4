"""Colours and materials of things, walls, floors and ceilings."""

from typing import Final

from mansion_editing.instructions.clauses.items import Item, NotUnderstood, joined_places
from mansion_editing.instructions.clauses.outcomes import Outcomes
from mansion_editing.instructions.phrases.nouns import MATERIALS
from mansion_editing.instructions.phrases.places import merged
from mansion_editing.instructions.phrases.word_sets import BEFORE_COLOUR_WORDS, BEFORE_SURFACES
from mansion_editing.instructions.statements import Finish, Paint, Place, Rooms, Statement, Surface
from mansion_language.colours import COLOUR_WORDS

__all__ = ["Colours"]

_PART: Final[dict[str, Surface]] = {"wall": "walls", "floor": "floor", "ceiling": "ceiling", "flooring": "floor"}


_COVERINGS: Final = frozenset(
    "parquet carpet tile linoleum vinyl laminate terrazzo hardwood marble flooring floor concrete".split()
)
"""Words for what covers floors."""


class Colours(Outcomes):
    """Reads what is painted, and its colour."""

    def colour_at(self, at: int) -> tuple[str, str, int] | None:
        """Read a colour or a material: ``dark red``, ``oak parquet``."""
        place = at
        while self.text(place) in BEFORE_COLOUR_WORDS:
            place += 1
        colour = material = ""
        start = place
        while self.text(place) in COLOUR_WORDS or self.text(place) in MATERIALS:
            word = self.text(place)
            if word in COLOUR_WORDS:
                colour = COLOUR_WORDS[word]
            else:
                material = MATERIALS[word]
            place += 1
        if place == start:
            return None
        place += self.text(place) in ("colour", "color", "flooring", "floor", "wallpaper")
        return colour, material, place

    def _covering_at(self, at: int) -> tuple[str, str, int] | None:
        """Read what a floor is covered with: ``oak parquet``, ``grey carpet``, ``new tiles``."""
        colour = self.colour_at(at)
        if colour is None or not colour[1] or self.words[colour[2] - 1].text not in _COVERINGS:
            return None
        return colour

    def _covered(self, item: Item, place: int, at: int) -> tuple[list[Statement], int] | None:
        """Read ``the library gets a grey carpet``: its floor takes it."""
        covering = self._covering_at(place + 1)
        own = item.is_room or self.lexicon.is_own_room(item.phrase.noun.words)
        if covering is None or not own:
            return None
        end = covering[2]
        places, stop = self.places(end)
        if places and any(p.place.anchor is not None or p.place.rooms is not None for p in places):
            return None
        end = stop
        finish = Finish(
            rooms=item.rooms(), part="floor", colour=covering[0], material=covering[1], quote=self.quote(at, end)
        )
        return [finish], end

    def _laid(self, at: int, place: int) -> tuple[list[Statement], int] | None:
        """Read ``lay oak parquet in the living room``; with an article it is a thing (``a carpet``)."""
        covering = None if self.text(place) in ("a", "an", "the") else self._covering_at(place)
        if covering is None:
            return None
        places, end = self.places(covering[2])
        rooms = joined_places(places)[0].rooms if places else self.frame.rooms
        if any(p.place.anchor is not None for p in places):
            return None
        rooms = Rooms(same=True) if rooms is None else rooms
        finish = Finish(rooms=rooms, part="floor", colour=covering[0], material=covering[1], quote=self.quote(at, end))
        return [finish], end

    def _paint(self, at: int, place: int) -> tuple[list[Statement], int]:
        items = self.items_or_surfaces(place)
        if items is None:
            raise NotUnderstood(at, self.boundary(at))
        subject, end = items
        colour = self.colour_at(end)
        if colour is None:
            raise NotUnderstood(at, self.boundary(at))
        stop = colour[2]
        return self._painted(subject, colour[0], colour[1], self.quote(at, stop)), stop

    def items_or_surfaces(self, at: int) -> tuple[tuple[Surface, Rooms] | list[Item], int] | None:
        """Read ``the walls of the lobby``, ``the kitchen floor``, or objects."""
        surface = self.surface(at)
        if surface is not None:
            return surface
        try:
            items = self.items(at)
        except NotUnderstood:
            return None
        return items, items[-1].end

    def surface(self, at: int) -> tuple[tuple[Surface, Rooms], int] | None:
        place = at
        its = at < len(self.words) and self.words[at].raw in ("its", "their") and self.text(at + 1) in _PART
        while self.text(place) in BEFORE_SURFACES:
            place += 1
        if self.text(place) in _PART:
            part, end = _PART[self.text(place)], place + 1
            end += self.text(end) in ("colour", "color", "finish", "material", "covering", "paint")
            places, end = self.places(end)
            rooms = joined_places(places)[0].rooms if places else self.frame.rooms
            rooms = Rooms(same=True) if rooms is None and its else rooms
            return None if rooms is None else ((part, rooms), end)
        for length in (4, 3, 2, 1):
            head = place + length
            if self.text(head) not in _PART or (self.text(head) == "floor" and self.words[head - 1].kind == "ordinal"):
                continue
            span = tuple(w.text for w in self.words[place:head])
            if self.lexicon.is_room(span) or (
                len(span) > 1 and span[-1].isdecimal() and self.lexicon.is_room(span[:-1])
            ):
                end = head + 1
                end += self.text(end) in ("colour", "color", "finish", "material", "covering")
                places, end = self.places(end)
                rooms = Rooms(words=" ".join(span))
                more = joined_places(places)[0].rooms
                rooms = rooms if more is None else merged(Place(rooms=rooms), Place(rooms=more)).rooms or rooms
                return (_PART[self.text(head)], rooms), end
        return None

    def _painted(
        self, subject: "tuple[Surface, Rooms] | list[Item]", colour: str, material: str, quote: str
    ) -> list[Statement]:
        if isinstance(subject, tuple):
            part, rooms = subject
            return [Finish(rooms=rooms, part=part, colour=colour, material=material, quote=quote)]
        out: list[Statement] = []
        for item in subject:
            if item.phrase.noun.kind in ("room", "both") and self.lexicon.is_own_room(item.phrase.noun.words):
                out.append(Finish(rooms=item.rooms(), part="walls", colour=colour, material=material, quote=quote))
            else:
                out.append(
                    Paint(
                        things=self._within_frame(self._all_if_plural(item.things())),
                        colour=colour,
                        material=material,
                        quote=quote,
                    )
                )
        return out
