"""Things that move by a length: ``1 m to the left``, ``half a metre closer to the window``."""

from typing import Final, Literal, TypeAlias

from mansion_editing.instructions.clauses.items import Item
from mansion_editing.instructions.clauses.outcomes import Outcomes
from mansion_editing.instructions.phrases.distances import read_length
from mansion_editing.instructions.phrases.places import read_place
from mansion_editing.instructions.statements import Move, Place, Shift, Spot, Statement, Things

__all__ = ["Shifting"]

_Way: TypeAlias = Literal["left", "right", "front", "behind", "north", "south", "east", "west", "towards", "away"]

_WAYS: Final[dict[str, _Way]] = {
    "left": "left", "right": "right", "forward": "front", "forwards": "front", "ahead": "front", "back": "behind",
    "backward": "behind", "backwards": "behind", "north": "north", "south": "south", "east": "east", "west": "west",
}  # fmt: skip
_SPOTS: Final[dict[str, Spot]] = {"window": "window", "door": "door", "wall": "wall", "corner": "corner"}
_Goal: TypeAlias = tuple[_Way, Things | None, Spot, int]


class Shifting(Outcomes):
    """Reads how far and which way something moves."""

    def _shifted(self, at: int, place: int) -> tuple[list[Statement], int] | None:
        """Read ``move the armchair 1 m to the left``; None where the words tell no length and direction."""
        item = self.item(place, places=False)
        if item is None or item.is_room:
            return None
        places = []
        end = item.end
        nearer = self._nearer(at, item)
        if nearer is not None:
            return nearer
        while True:
            found = self._length_and_way(end)
            if found is not None:
                break
            read = read_place(self.words, end, self.lexicon, self.floors)
            if read is None or read.goal or read.source:
                return None
            places.append(read)
            end = read.end
        metres, (way, mark, spot, stop) = found
        things = Item(item.phrase, tuple(places), end).things()
        quote = self.quote(at, stop)
        return [
            Shift(things=self._all_if_plural(things), metres=metres, way=way, mark=mark, spot=spot, quote=quote)
        ], stop

    def _nearer(self, at: int, item: Item) -> tuple[list[Statement], int] | None:
        """Read ``a bit closer to the sofa`` without a length: it comes near it."""
        end = item.end
        while self.text(end) in ("a", "little", "bit", "tad", "slightly", "somewhat", "over", "much", "right"):
            end += 1
        if self.text(end) not in ("closer", "nearer") or read_length(self.words, end + 1) is not None:
            return None
        way = self._way_at(end)
        if way is None or read_length(self.words, way[3]) is not None or way[2] in ("wall", "corner"):
            return None
        place = Place(spot=way[2]) if way[1] is None else Place(relation="near", anchor=way[1])
        things = self._all_if_plural(item.phrase.things())
        return [Move(things=things, place=place, quote=self.quote(at, way[3]))], way[3]

    def _length_and_way(self, at: int) -> tuple[float, _Goal] | None:
        """Read a length and a direction, in either order."""
        length = read_length(self.words, at)
        if length is not None:
            way = self._way_at(length[1])
            return None if way is None else (length[0], way)
        way = self._way_at(at)
        length = None if way is None else read_length(self.words, way[3])
        if way is None or length is None:
            return None
        return length[0], (way[0], way[1], way[2], length[1])

    def _way_at(self, at: int) -> _Goal | None:
        place = at
        while self.text(place) in ("further", "farther", "more", "over"):
            place += 1
        toward = self.text(place) in ("closer", "nearer", "towards", "toward")
        away = self.text(place) == "away" and self.text(place + 1) == "from"
        if toward or away:
            place += 1 + (self.text(place + 1) in ("to", "from"))
            goal = "towards" if toward else "away"
            return self._mark_at(place, "towards" if goal == "towards" else "away")
        place += 2 * (self.text(place) in ("to", "towards") and self.text(place + 1) in ("the", "its"))
        way = _WAYS.get(self.text(place))
        return None if way is None else (way, None, "", place + 1)

    def _mark_at(self, at: int, way: _Way) -> _Goal | None:
        place = at + (self.text(at) in ("the", "a", "its"))
        spot = _SPOTS.get(self.text(place))
        if spot is not None:
            return way, None, spot, place + 1
        mark = self.item(at)
        return None if mark is None or mark.is_room else (way, mark.things(), "", mark.end)
