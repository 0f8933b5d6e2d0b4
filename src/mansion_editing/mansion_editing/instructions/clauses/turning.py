"""Things that turn: by degrees, or to face something."""

from typing import Final

from mansion_editing.instructions.clauses.items import Item, NotUnderstood, joined_places
from mansion_editing.instructions.clauses.outcomes import Outcomes
from mansion_editing.instructions.phrases.places import ReadPlace, read_place, with_place
from mansion_editing.instructions.phrases.word_sets import TOWARDS
from mansion_editing.instructions.statements import Statement, Turn

__all__ = ["Turning"]

_ROUND: Final = frozenset("around round about".split())
_WHOLLY: Final = frozenset("right all the way completely fully".split())
"""Words before ``around`` that a half turn is told by."""


class Turning(Outcomes):
    """Reads turns by degrees and towards things."""

    def _rotate(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``rotate the sofa by 90 degrees``, ``turn the armchair to the window``, ``face the bed to the door``."""
        item = self.item(place, places=False)
        if item is None:
            raise NotUnderstood(at, self.boundary(at))
        where, end = self._places_before_turn(item)
        things = Item(item.phrase, where, end).things()
        about = self._end_of_half_turn(end)
        if about:
            return [Turn(things=self._within_frame(things), degrees=180.0, quote=self.quote(at, about))], about
        while self.text(end) in ("by", "around", "through", "about", "round"):
            degrees = self._degrees(end + 1) or self._degrees(end + 2)
            if self.text(end) == "around" and degrees is None:
                return [Turn(things=self._within_frame(things), degrees=180.0, quote=self.quote(at, end + 1))], end + 1
            end += 1
        degrees = self._degrees(end)
        if degrees is not None:
            value, stop = degrees
            places, last = self.places(stop)
            if places:
                things = with_place(things, joined_places(places)[0])
            return [Turn(things=self._within_frame(things), degrees=value, quote=self.quote(at, last))], last
        while self.text(end) in TOWARDS:
            end += 1
        faced = self.faced_spot(end)
        if faced is not None:
            spot, stop = faced
            return [Turn(things=self._within_frame(things), spot=spot, quote=self.quote(at, stop))], stop
        goal = self.item(end)
        if goal is None or goal.is_room:
            raise NotUnderstood(at, self.boundary(at))
        return [Turn(things=self._within_frame(things), facing=goal.things(), quote=self.quote(at, goal.end))], goal.end

    def _end_of_half_turn(self, at: int) -> int:
        """Return the end of ``right around so that it faces the other way``, ``the other way round``; 0 for others."""
        end = at
        while self.text(end) in _WHOLLY:
            end += 1
        turned = self.text(end) in _ROUND
        end += turned
        facing = end
        while self.text(facing) in TOWARDS | {"look", "point", "and", "also"}:
            facing += 1
        facing += self.text(facing) == "the"
        if self.text(facing) not in ("other", "opposite") or self.text(facing + 1) not in ("way", "direction"):
            ends = turned and end > at + 1 and (end >= len(self.words) or self.words[end].kind == "mark")
            return end if ends else 0
        end = facing + 2
        return end + (self.text(end) in _ROUND)

    def _places_before_turn(self, item: Item) -> tuple[tuple[ReadPlace, ...], int]:
        found: list[ReadPlace] = []
        end = item.end
        while self.text(end) not in ("to", "towards", "toward", "around", "facing", "at"):
            read = read_place(self.words, end, self.lexicon, self.floors)
            if read is None or self._degrees(end + 1) is not None:
                break
            found.append(read)
            end = read.end
        return tuple(found), end

    def _degrees(self, at: int) -> tuple[float, int] | None:
        if at >= len(self.words):
            return None
        if self.text(at) in ("a", "one") and self.text(at + 1) in ("quarter", "half"):
            value = 90.0 if self.text(at + 1) == "quarter" else 180.0
            end = at + 2 + (self.text(at + 2) in ("turn", "circle"))
        elif self.words[at].kind == "number" and self.text(at + 1) in ("degree", "deg", "°"):
            value, end = self.words[at].value, at + 2
        else:
            return None
        if self.text(end) in ("clockwise", "right") or (self.text(end) == "to" and self.text(end + 2) == "right"):
            return -value, end + (3 if self.text(end) == "to" else 1)
        if self.text(end) in ("counterclockwise", "anticlockwise", "left", "counter-clockwise"):
            return value, end + 1
        if self.text(end) in ("counter", "anti") and self.text(end + 1) == "clockwise":
            return value, end + 2
        if self.text(end) == "to" and self.text(end + 2) == "left":
            return value, end + 3
        return value, end
