"""What a plain word means in a kind of building: "the kitchen" of a restaurant is a commercial one."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

from mansion_knowledge import BuildingType
from mansion_planner.brief.facts import AdjacencyFact, BriefFacts, ObjectFact, RoomFact

__all__ = ["as_meant_in", "with_main_room"]

_MEANT = {
    "kitchen": ("commercial_kitchen",), "open_kitchen": ("commercial_kitchen",), "dining_room": ("restaurant",),
    "dining_area": ("restaurant",), "dining_space": ("restaurant",), "entrance_hall": ("lobby",),
    "living_dining_room": ("living_room",), "living_and_dining_room": ("living_room",),
    "lounge_diner": ("living_room",),
    "shower_room": ("shower_area",), "shower": ("shower_area",), "showers": ("shower_area",),
    "private_room": ("resident_room", "patient_room"), "single_room": ("resident_room", "patient_room"),
    "child_room": ("childrens_area",), "kid_room": ("childrens_area",), "lounge": ("living_room",),
    "showroom": ("car_showroom",), "kitchenette": ("kitchen",), "sleeping_area": ("bedroom",),
    "hall": ("assembly_hall", "conference_hall"), "guest_room": ("hotel_room",), "bedroom": ("hotel_room",),
    "gym": ("home_gym",), "dressing_room": ("walk_in_closet",),
    "playroom": ("kindergarten_classroom",), "treatment_room": ("dental_room",), "garage": ("apparatus_bay",),
    "storage_room": ("stock_room",), "storage": ("stock_room",), "store_room": ("stock_room",),
    "stall": ("food_stall",), "seating": ("restaurant", "cafeteria", "cafe"),
    "seating_area": ("restaurant", "cafeteria", "cafe"), "library": ("library_room",),
    "cinema_hall": ("home_theater",), "library_room": ("reading_room",),
}  # fmt: skip
"""Plain names of rooms, and what they are where a building has that for its guests, the likeliest first."""

_BY_TYPE = frozenset({"guest_room", "gym", "dressing_room", "library", "cinema_hall", "library_room"})
"""Those of them that mean so under any name: the "en-suite guest room" of a hotel, the "fitness room" of a villa."""

_OF_EVERY_HOME = frozenset({"kitchen", "bedroom", "home_gym", "walk_in_closet", "library_room", "home_theater"})
"""What a home has for those who live there, even where its usual rooms are fewer."""

_SHARED_BATHS = frozenset({"bathroom", "restroom", "shower_area", "toilet"})
"""Rooms that guests share where a brief asks for them: their bedrooms have none of their own."""

_OF_GUESTS = frozenset({"bedroom"})
"""Rooms that guests of a hotel have as well."""

_WHERE_NOBODY_SLEEPS = frozenset({"education", "office", "culture", "retail", "food", "civic", "worship", "industry"})
"""Families of buildings in which a bathroom is a toilet."""

_PRIVATE = frozenset({"bedroom", "master_bedroom", "living_room"})

_USERS = frozenset("man woman boy girl gent lady male female pupil student visitor customer public".split())
"""Whose toilets in a public building have several cubicles: "toilets for boys and girls"."""


def as_meant_in(building: BuildingType, facts: BriefFacts) -> BriefFacts:
    """Return facts in which rooms with a plain name are of the kind that the building has of its own.

    Names stay, but the only room of the kind that guests enter by is that one, unless it has an area of its own.
    Rooms within units are those of a home, and so are rooms on storeys that a home shares; where the brief names the
    building's own kind as well, it tells the two apart.

    Examples
    --------
    >>> from mansion_knowledge import default_knowledge
    >>> from mansion_planner.brief.facts import Span
    >>> restaurant = default_knowledge().buildings["restaurant_building"]
    >>> facts = BriefFacts(rooms=[RoomFact("kitchen", "kitchen", Span(0, 7, "kitchen"))])
    >>> [(room.name, room.room_type) for room in as_meant_in(restaurant, facts).rooms]
    [('kitchen', 'commercial_kitchen')]
    """
    meanings = _meanings_in(building, facts)
    if meanings is None:
        return facts
    kind = meanings.kind
    return replace(
        facts,
        rooms=[meanings.room(room) for room in facts.rooms],
        excluded=[(kind(name), span) for name, span in facts.excluded],
        excluded_on=[(kind(name), floor, span) for name, floor, span in facts.excluded_on],
        adjacent=[meanings.relation(fact) for fact in facts.adjacent],
        apart=[meanings.relation(fact) for fact in facts.apart],
        objects=[meanings.furniture(fact) for fact in facts.objects],
        heights=[replace(fact, room_type=kind(fact.room_type)) for fact in facts.heights],
        materials=[replace(fact, room_type=kind(fact.room_type)) for fact in facts.materials],
    )


def with_main_room(building: BuildingType, facts: BriefFacts) -> BriefFacts:
    """Return facts in which the only room of the kind that a public hall is there for is that hall, whatever its name.

    The "storage hall" of a warehouse is what all else stands around; one of a stated area, or on an upper storey, stays
    a room beside others.
    """
    main = [room for room in facts.rooms if room.room_type == building.hub]
    if building.family == "home" or building.parti != "hall" or [room.count for room in main] != [1]:
        return facts
    own = main[0]
    if own.name == building.hub or own.area or own.suite or own.each or any(ref.last != 1 for ref in own.floors):
        return facts
    hall = replace(own, name=building.hub, label=own.label or own.name.replace("_", " "))

    def name(called: str) -> str:
        return building.hub if called == own.name else called

    def relation(fact: AdjacencyFact) -> AdjacencyFact:
        return replace(fact, first_name=name(fact.first_name), second_name=name(fact.second_name))

    return replace(
        facts,
        rooms=[hall if room is own else room for room in facts.rooms],
        adjacent=[relation(fact) for fact in facts.adjacent],
        apart=[relation(fact) for fact in facts.apart],
        objects=[replace(fact, room=name(fact.room)) for fact in facts.objects],
    )


@dataclass(frozen=True)
class _Meanings:
    """What plain names of rooms mean in a building.

    Attributes
    ----------
    kinds : mapping of str to str
        The kind of room that each plain name means.
    hub : str
        The building's hub where the brief names one room of its kind, without an area: that room is the hub. Otherwise
        empty.
    """

    kinds: Mapping[str, str]
    hub: str

    def kind(self, name: str) -> str:
        return self.kinds.get(name, name)

    def name(self, own: str) -> str:
        return self.hub if self.hub and self.kind(own) == self.hub else own

    def room(self, room: RoomFact) -> RoomFact:
        plain = room.room_type if room.room_type in _BY_TYPE else room.name
        if plain not in self.kinds:
            return room
        label = room.label or room.name.replace("_", " ")
        return replace(room, room_type=self.kind(plain), name=self.name(room.name), label=label)

    def relation(self, fact: AdjacencyFact) -> AdjacencyFact:
        first = self.kind(fact.first) if fact.first_name in ("", fact.first) else fact.first
        second = self.kind(fact.second) if fact.second_name in ("", fact.second) else fact.second
        return replace(fact, first=first, second=second)

    def furniture(self, fact: ObjectFact) -> ObjectFact:
        if fact.room not in ("", fact.room_type) and fact.room_type not in _BY_TYPE:
            return fact
        return replace(fact, room_type=self.kind(fact.room_type), room=self.name(fact.room))


def _meanings_in(building: BuildingType, facts: BriefFacts) -> _Meanings | None:
    """Return what plain names mean in a building, or ``None`` where all mean what they say."""
    own = {entry.room_type for entries in building.storeys.values() for entry in entries} | {building.hub}
    own |= _OF_EVERY_HOME if building.family == "home" else set()
    stated = {room.room_type for room in facts.rooms}
    kinds = {plain: next((kind for kind in found if kind in own), "") for plain, found in _MEANT.items()}
    meant = {plain: kind for plain, kind in kinds.items() if kind and kind not in stated}
    if building.family in _WHERE_NOBODY_SLEEPS and not stated & (_PRIVATE | {"toilet", "restroom"}):
        meant["bathroom"] = "restroom"
    if building.family != "home":
        of_users = (room.name for room in facts.rooms if room.room_type == "toilet" and not room.area)
        meant |= {name: "restroom" for name in of_users if name.split("_")[0] in _USERS}
    if stated & _SHARED_BATHS:
        meant.pop("bedroom", "")
    private = _PRIVATE - _OF_GUESTS if building.family == "lodging" else _PRIVATE
    at_home = {room.floors for room in facts.rooms if room.room_type in private and room.name not in meant}
    shared = building.family != "home" and any(room.name in meant and room.floors in at_home for room in facts.rooms)
    if not meant or shared:
        return None
    entered = [room for room in facts.rooms if meant.get(room.name, room.name) == building.hub]
    is_hub = [room.count for room in entered] == [1] and not entered[0].area
    return _Meanings(meant, building.hub if is_hub else "")
