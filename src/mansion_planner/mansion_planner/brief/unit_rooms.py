"""Read lists of the rooms of a unit: "with two bedrooms, a bathroom and a kitchen", "a bathroom in" each flat."""

from collections.abc import Sequence
from dataclasses import replace

from mansion_planner.brief.en_suite import bathroom_of_some
from mansion_planner.brief.persons import is_person
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import FLOOR_WORDS, Place, Reading
from mansion_planner.brief.units import Households

__all__ = ["UnitRooms"]

_LINKS = frozenset(
    """
    with of having has have consist consisting comprise comprising contain containing include including hold holding
    offer offering feature featuring get : ( = made
    """.split()
)
_STRONG = frozenset({"each", "every", "apiece"})
_BETWEEN = frozenset(
    """
    , which that them one is are there to should must will shall also just in its up by of all both they come need
    needs and - – own entrance for them us him her me
    """.split()
)
_JOINTS = frozenset(
    """
    , and & a an the one its their own plus + / with as well separate also both second third another further small
    large sharing share shared around - – one private
    """.split()
)
_BESIDE = frozenset({"adjoining", "adjacent", "attached", "alongside"})
"""What may end the entry of a room in a list: "kitchen with utility adjoining, toilet"."""
_SHARED_ROOMS = frozenset(
    """
    laundry_room bike_storage mail_room lobby waste_room common_room gym parking shared_kitchen garage shop cafe
    reception roof_terrace staff_room mechanical_room corridor housekeeping_room restaurant bar
    """.split()
)
"""Rooms of the whole house: they end a list of what a flat holds, unless the list is plainly of each."""

_OF_GUESTS = frozenset(
    """
    bathroom ensuite_bathroom toilet kitchen living_room bedroom walk_in_closet dressing_room home_office study_room
    entrance_hall
    """.split()
)
"""Rooms that a hotel room or another room for guests may have for itself."""

_READ_AS = {"kitchenette": "kitchen", "wet_room": "bathroom", "shower": "bathroom", "living_area": "living_room",
            "living_space": "living_room", "lounge": "living_room"}  # fmt: skip
"""Names that mean another room inside a unit than in a workplace."""

_REACH = 14
"""Tokens that may stand between a unit and the first of its rooms."""


class UnitRooms:
    """Reads lists of rooms after and before what names their unit.

    Parameters
    ----------
    building : int, optional
        First token of the phrase that names the building itself.
    found : Households
        The units and what was read of them so far.
    """

    def __init__(
        self,
        reading: Reading,
        phrases: Sequence[Phrase],
        places: Sequence[Place],
        building: int | None,
        found: Households,
    ) -> None:
        self.reading, self.phrases, self.places, self.building = reading, phrases, places, building
        self.found = found

    def after(self, start: int, *, always: bool, guests: bool = False) -> tuple[list[Phrase], int]:
        """Return the rooms listed behind a token, and where the list ends.

        Parameters
        ----------
        always : bool
            The words before say already that the list is of each unit.
        guests : bool
            The units are rooms for guests, which hold few other rooms.
        """
        if self.reading.words(start, start + 2) == ("and", "the"):
            return [], start  # "between the resident rooms and the lounge"
        index, linked, strong, placed = self._linked(start)
        rooms: list[Phrase] = []
        closed = trailing = False
        while True:
            begin, joined = self._joints(index, first=not rooms)
            if len(rooms) == 1 and not always and self.reading.words(index, index + 2) == (",", "and"):
                break  # a list of two has no comma: what follows is a statement of its own
            room = self._room_at(begin)
            if room is None or (rooms and begin == index):
                break
            kind = self._kind(room)
            shared = kind in _SHARED_ROOMS or bool(rooms and closed and not strong)
            if (guests and kind not in _OF_GUESTS) or (not always and shared):
                break
            if rooms and self._is_elsewhere(room, placed=placed):
                break
            closed = closed or (joined and bool(rooms))
            room = self._for_each_bedroom(room, rooms)
            singled = bool(rooms) and self._singles_out(index, begin)
            if singled and room.room_type == rooms[-1].room_type:
                rooms[-1] = replace(rooms[-1], count=(rooms[-1].count or 0) + (room.count or 0))
                self.found.inner.add(room.first)
            else:
                rooms.append(replace(room, room_type=kind, known=room.known or room.name in _READ_AS))
            own = bathroom_of_some(self.reading, self.phrases, room) if singled else None
            rooms += [own] if own is not None else []
            index, each = self._after_room((own or room).last)
            trailing = trailing or each
            living = self._living_at(index)
            if living is not None:
                rooms.append(living)
                index = living.last
        if not (linked or strong or always or trailing) or not rooms:
            return [], start
        self.reading.take(start, index)
        return rooms, index

    def _for_each_bedroom(self, room: Phrase, rooms: list[Phrase]) -> Phrase:
        """Return an ensuite as many times as there are bedrooms before it: "3 bedrooms with ensuite"."""
        if room.room_type != "ensuite_bathroom" or room.counted or not rooms:
            return room
        owner, led = rooms[-1], self.reading.word(room.first - 1) == "with"
        own = led and owner.counted and owner.room_type.endswith("bedroom") and owner.last == room.first - 1
        return replace(room, count=owner.count, counted=True) if own else room

    def _kind(self, room: Phrase) -> str:
        """Return the type of a room in a unit; the hall of "a 3BHK flat: hall, kitchen" is its living room."""
        bhk = room.name == "hall" and "bhk" in self.reading.text.lower()
        return "living_room" if bhk else _READ_AS.get(room.name, room.room_type)

    def _linked(self, start: int) -> tuple[int, bool, bool, bool]:
        """Return where a list may begin, and whether a link, a word for each and a storey stand before it."""
        reading, index = self.reading, start
        linked = strong = placed = False
        opened = self._opened_list(start)
        if opened:
            return opened, True, strong, placed
        while index < len(reading.tokens) and index - start < _REACH:
            place = next((p for p in self.places if p.first <= index < p.last), None)
            if place is not None:
                index, placed = place.last, True
                continue
            word, kind = reading.word(index), reading.kind(index)
            floor = word in ("a", "per") and reading.word(index + 1) in FLOOR_WORDS
            if floor:
                index, placed = index + 2, True
                continue
            if kind == "unit" or (kind == "number" and self._in_measure(index)):
                index += 1
                continue
            if word == "for" and reading.kind(index + 1) == "number" and is_person(reading.word(index + 2)):
                index += 3  # "an apartment for 6 persons (three bedrooms, two baths)"
                continue
            if self._room_at(index) is not None or not (word in _LINKS or word in _STRONG or word in _BETWEEN):
                break
            linked = linked or (word in _LINKS and (word == "(" or not self._before_measure(index)))
            of_area = word in _STRONG and reading.kind(index - 1) == "unit"
            of_storeys = index == start and reading.word(index + 1) in (",", "and")  # "five dorm rooms each and a gym"
            strong = strong or (word in _STRONG and not (of_area or of_storeys) and reading.word(index + 1) != ",")
            index += 1
        return index, linked, strong, placed

    def _opened_list(self, start: int) -> int:
        """Return where the list of "a flat for the caretaker: ..." or of "ABOVE: flat. ..." begins, or 0."""
        reading = self.reading
        if reading.word(start) == "for":
            colon = next((i for i in range(start + 1, start + 6) if reading.word(i) == ":"), 0)
            return colon + 1 if colon and self._room_at(colon + 1) is not None else 0
        headed = reading.word(start) == "." and any(
            reading.word(i) == ":"
            for i in range(max(start - 5, 0), start)
            if reading.sentence[i] == reading.sentence[start]
        )
        return start + 1 if headed and self._room_at(start + 1) is not None else 0

    def _in_measure(self, index: int) -> bool:
        return any(self.reading.kind(i) == "unit" for i in range(index + 1, index + 3))

    def _before_measure(self, index: int) -> bool:
        """Whether "of" or "with" leads to an area: "three flats of about 65 m2"."""
        ahead = range(index + 1, index + 4)
        number = next((i for i in ahead if self.reading.kind(i) == "number"), None)
        return number is not None and self._in_measure(number) and self._room_at(index + 1) is None

    def _joints(self, index: int, *, first: bool) -> tuple[int, bool]:
        """Return the token after words that join the rooms of a list, and whether "and" is among them."""
        joined = False
        for _ in range(5):
            if self._room_at(index) is not None:
                break
            word = self.reading.word(index)
            ordinal = self.reading.kind(index) == "ordinal" or self._singles_out(index, index + 1)
            if not (word in _JOINTS or ordinal) or self.reading.breaks(index):
                break
            joined = joined or word in ("and", "&")
            index += 1
        return index, joined and not first

    def _singles_out(self, first: int, last: int) -> bool:
        """Whether "out of which" stands at tokens, which lead to some of the rooms named before."""
        return any(
            self.reading.word(at) in ("out", "of", "which", "them") and at in self.reading.taken
            for at in range(first, last)
        )

    def _room_at(self, index: int) -> Phrase | None:
        """Return the room that a phrase names at a token; "every room" speaks of one that is named before."""
        return next(
            (
                p for p in self.phrases
                if p.first <= index < p.noun_end and p.head == "room" and p.room_type
                and p.first not in self.found.units and p.first != self.building
                and (p.counted or p.determiner != "every")
            ),
            None,
        )  # fmt: skip

    def _after_room(self, index: int) -> tuple[int, bool]:
        """Return the token after the area and the "each" that follow a room, and whether there is an "each"."""
        reading = self.reading
        ahead = next((i for i in range(index, index + 4) if reading.kind(i) == "number"), None)
        if ahead is not None and self._in_measure(ahead) and all(
            reading.word(i) in ("of", "about", "with", "(", "around", "circa") for i in range(index, ahead)
        ):  # fmt: skip
            index = next(i for i in range(ahead, ahead + 3) if reading.kind(i) == "unit") + 1
            index += reading.word(index) == ")"
        if reading.word(index) == "for" and reading.kind(index + 1) == "number" and reading.kind(index + 2) == "mark":
            index += 2  # "a dining room for 16,"
        index += reading.word(index) in _BESIDE and reading.word(index + 1) in (",", "and")
        index = self._after_furniture(index)
        each = reading.word(index) in _STRONG and not self._room_at(index)
        return index + each, each

    def _after_furniture(self, index: int) -> int:
        """Return the token after the furniture that a room has: "a work area with three desks and an archive"."""
        joints: tuple[str, ...] = ("with",)
        while self.reading.word(index) in joints:
            things = (p for p in self.phrases if p.head == "object" and 0 <= p.first - index - 1 <= 1)
            thing = next(things, None)
            if thing is None:
                break
            index, joints = thing.last, ("and", ",")
        return index

    def _living_at(self, index: int) -> Phrase | None:
        """Return the living room of "open kitchen-living", which has no noun of its own."""
        reading = self.reading
        index += reading.word(index) in ("/", "-", "–", "+", "&", "and")
        if reading.word(index) != "living" or self._room_at(index) is not None:
            return None
        last = index + 1 + (reading.word(index + 1) in ("area", "space"))
        reading.take(index, last)
        return Phrase("room", index, index, last, last, "living_room", name="living_room", label="living room")

    def _is_elsewhere(self, room: Phrase, *, placed: bool) -> bool:
        """Whether a storey of its own follows a room, so that it is none of the unit's."""
        behind = next((p for p in self.places if 0 <= p.first - room.last <= 1 and p.led), None)
        if behind is None or behind.refs[0].kind == "every":
            return False
        return placed or room.room_type in _SHARED_ROOMS

    def before(self, end: int) -> list[Phrase]:
        """Return the rooms listed right before a token."""
        rooms: list[Phrase] = []
        while True:
            end -= self.reading.word(end - 1) in ("also", "too")
            room = next(
                (p for p in self.phrases if p.last == end and p.head == "room" and p.first not in self.found.units),
                None,
            )
            if room is None or room.first == self.building or room.first in self.found.inner:
                return rooms[::-1]
            rooms.append(replace(room, room_type=_READ_AS.get(room.name, room.room_type)))
            end = room.first
            while self.reading.word(end - 1) in ("and", ",", "&", "a", "an", "one") and not self.reading.breaks(
                end - 1
            ):
                end -= 1
