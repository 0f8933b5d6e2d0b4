"""Requests for buildings as people may write them: plausible ones, odd ones and absurd ones, each from its number."""

import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from mansion_knowledge.base import KnowledgeBase, default_knowledge
from mansion_knowledge.types import BuildingType, RoomType
from mansion_msgs_py.request import BuildRequest
from mansion_world.mixture import load_mixture
from mansion_world.sampling import sample

__all__ = ["CLASSES", "DrawnRequest", "draw"]

CLASSES = ("plausible", "odd", "absurd")

SHARES = (70, 20, 10)
"""Of the classes, in per cent."""

USUAL = {
    "flat": 5, "house": 6, "townhouse": 3, "villa": 2, "bungalow": 2, "studio_flat": 2, "penthouse": 1,
    "apartment_building": 3, "office": 8, "coworking": 2, "clinic": 5, "dental_clinic": 2, "hospital": 4,
    "hotel": 5, "hostel": 2, "student_dormitory": 2, "nursing_home": 2, "school": 5, "kindergarten": 3,
    "university": 2, "shopping_mall": 4, "supermarket": 2, "restaurant_building": 2, "library_building": 2,
    "museum": 1, "gym_building": 1, "mixed_use": 1, "community_center": 1,
}  # fmt: skip
"""Buildings that most people ask for, with their shares; the other types follow now and then."""

RARE = 0.12
"""Share of plausible requests for any of the other building types."""

NUMBERS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve")

FURNITURE = (
    "a piano", "two sofas", "a bunk bed", "a large dining table", "a fish tank", "four desks", "a bookcase",
    "a treadmill", "a billiard table", "ten chairs", "a printer", "a fridge", "a wardrobe", "a vending machine",
    "a whiteboard", "three armchairs", "a washing machine", "a safe", "a coat rack", "a projector",
)  # fmt: skip

STYLES = ("modern", "victorian", "industrial", "scandinavian", "minimalist", "art deco", "rustic", "luxury", "japandi")

OUTLINES = ("L-shaped", "U-shaped", "T-shaped", "H-shaped", "square", "long narrow", "courtyard", "plus-shaped")

RELATIONS = ("next to", "beside", "away from", "opposite", "far from", "above", "directly below", "connected to")

WISHES = (
    "without a lift", "with two staircases", "with a lift", "no stairs", "with wheelchair access",
    "with wide corridors", "with as many windows as possible", "with no windows", "for 12 people",
    "for forty people", "with an open plan",
    "with a flat roof", "with a courtyard", "with high ceilings", "with separate entrances", "with a basement",
    "all on one level", "with a double-height hall", "with a private bathroom for every bedroom", "with thick walls",
)  # fmt: skip

PLACES = (
    "on the ground floor", "on the top floor", "upstairs", "in the basement", "on every floor", "on the second floor",
)  # fmt: skip


@dataclass(frozen=True)
class DrawnRequest:
    """A request with its number and class."""

    number: int
    kind: str
    request: BuildRequest


def draw(number: int, seed: int) -> DrawnRequest:
    """Return the request of a number: its class, its words and its options follow from both arguments alone."""
    rng = random.Random(f"{seed}/{number}")
    kind = rng.choices(CLASSES, SHARES)[0]
    makers: dict[str, Callable[[random.Random], BuildRequest]] = {
        "plausible": _plausible,
        "odd": _odd,
        "absurd": _absurd,
    }
    return DrawnRequest(number, kind, makers[kind](rng))


def _plausible(rng: random.Random) -> BuildRequest:
    if rng.random() < 0.25:
        return sample(rng.randrange(100_000), rng.randrange(1_000), load_mixture()).request
    building = _building(rng)
    floors = _floors(building, rng)
    parts = [_named(building, floors, rng)]
    rooms = _rooms(building, rng)
    if rooms:
        parts.append(f"with {_listed([_counted(room, rng) for room in rooms])}")
    text = " ".join(parts)
    if rng.random() < 0.2:
        text += f", {_area_in_words(building, rng)}"
    text += "".join(_sentence(rooms, rng) for _ in range(rng.choice((0, 0, 0, 1, 1, 2))))
    return BuildRequest(description=text, seed=rng.randrange(1_000), **_numbers(building, rng))


def _building(rng: random.Random) -> BuildingType:
    known = default_knowledge()
    if rng.random() < RARE:
        return known.buildings[rng.choice(sorted(known.buildings))]
    return known.buildings[rng.choices(list(USUAL), list(USUAL.values()))[0]]


def _floors(building: BuildingType, rng: random.Random) -> int | None:
    usual, most = building.floors
    if rng.random() < 0.35:
        return None
    return min(rng.choice((usual, usual + 1, rng.randint(1, max(most, 2)))), 12)


def _named(building: BuildingType, floors: int | None, rng: random.Random) -> str:
    noun = rng.choice(building.synonyms) if building.synonyms else building.name.replace("_", " ")
    words = []
    if rng.random() < 0.2:
        words.append(rng.choice(STYLES))
    if rng.random() < 0.12:
        words.append(rng.choice(OUTLINES))
    if floors is not None:
        number = NUMBERS[floors] if floors < len(NUMBERS) else str(floors)
        words.append(f"{number}-{rng.choice(('storey', 'story', 'floor'))}")
    head = " ".join([*words, noun])
    article = "an" if head[0].lower() in "aeiou" or head.startswith(("L-", "H-")) else "a"
    return f"{article} {head}"


def _rooms(building: BuildingType, rng: random.Random) -> list[RoomType]:
    """Return some rooms that the type usually has, and now and then one that suits it."""
    known = default_knowledge()
    names = sorted({entry.room_type for entries in building.storeys.values() for entry in entries})
    count = min(rng.choice((0, 1, 2, 2, 3, 4, 6)), len(names))
    chosen = rng.sample(names, count)
    if rng.random() < 0.3:
        chosen.append(rng.choice(_kindred(building, known)))
    return [known.rooms[name] for name in dict.fromkeys(chosen) if name in known.rooms]


def _kindred(building: BuildingType, known: KnowledgeBase) -> list[str]:
    """Return the rooms of all buildings of the same family."""
    alike = [other for other in known.buildings.values() if other.family == building.family]
    return sorted({entry.room_type for each in alike for entries in each.storeys.values() for entry in entries})


def _counted(room: RoomType, rng: random.Random) -> str:
    name = rng.choice((room.name.replace("_", " "), room.name.replace("_", " "), *room.synonyms))
    count = rng.choice((1, 1, 1, 1, 2, 2, 3, 4, 6))
    if count == 1:
        size = f" of {rng.uniform(room.least, room.most):.0f} m2" if rng.random() < 0.12 else ""
        return f"{'an' if name[0] in 'aeiou' else 'a'} {name}{size}"
    return f"{NUMBERS[count]} {name if name.endswith('s') else name + 's'}"


def _listed(names: Sequence[str]) -> str:
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


def _area_in_words(building: BuildingType, rng: random.Random) -> str:
    least, usual = building.floor_area
    area = round(rng.uniform(0.8 * least, 2.0 * usual))
    feet = round(area * 10.764)
    return rng.choice((f"about {area} m2", f"{area} square metres per floor", f"{feet} square feet a floor"))


def _sentence(rooms: Sequence[RoomType], rng: random.Random) -> str:
    """Return a further sentence: a wish for the building, for a room's place, size or furniture, or a relation."""
    names = [room.name.replace("_", " ") for room in rooms] or ["entrance hall"]
    name, other = rng.choice(names), rng.choice([*names, "kitchen", "staircase", "lift", "entrance"])
    return rng.choice(
        (
            f" {rng.choice(WISHES)}".replace(" ", ", ", 1),
            f". Put the {name} {rng.choice(PLACES)}",
            f". The {name} has {rng.choice(FURNITURE)}",
            f". The {name} is {rng.choice(RELATIONS)} the {other}",
            f". The {name} should be at least {rng.randint(5, 60)} m2",
            f". {rng.choice(FURNITURE).capitalize()} in every {name}",
            f". No {other}",
            f". The {name} gets {rng.choice(('blue', 'white', 'dark green'))} walls",
        )
    )


def _numbers(building: BuildingType, rng: random.Random) -> dict[str, float | int]:
    """Return what the command line may say besides the brief."""
    least, usual = building.floor_area
    options: dict[str, float | int] = {}
    if rng.random() < 0.2:
        options["floors"] = rng.randint(1, 6)
    if rng.random() < 0.25:
        options["floor_area"] = float(round(rng.uniform(least, 1.8 * usual)))
    elif rng.random() < 0.1:
        options["area"] = float(round(rng.uniform(least, 4.0 * usual)))
    return options


def _odd(rng: random.Random) -> BuildRequest:
    """Return a request with rooms of any buildings, odd sizes and wishes that hardly go together."""
    known = default_knowledge()
    building = known.buildings[rng.choice(sorted(known.buildings))]
    names = rng.sample(sorted(known.rooms), rng.randint(1, 7))
    rooms = [known.rooms[name] for name in names]
    sized = [
        f"{_counted(room, rng)}" if rng.random() < 0.6 else f"a {rng.randint(2, 150)} m2 {room.name.replace('_', ' ')}"
        for room in rooms
    ]
    text = f"{_named(building, rng.choice((None, rng.randint(1, 9))), rng)} with {_listed(sized)}"
    text += "".join(_sentence(rooms, rng) for _ in range(rng.randint(0, 4)))
    options = _numbers(building, rng)
    if rng.random() < 0.2:
        options = {"floor_area": float(rng.choice((15, 25, 40, 60, 90, 900, 2_000)))}
    return BuildRequest(description=text, seed=rng.randrange(1_000), **options)


def _absurd(rng: random.Random) -> BuildRequest:
    """Return a request that no architect would take: too small, too large, or against itself."""
    known = default_knowledge()
    building = known.buildings[rng.choice(list(USUAL))]
    noun = building.name.replace("_", " ")
    room = known.rooms[rng.choice(sorted(known.rooms))].name.replace("_", " ")
    few, many = rng.randint(1, 3), rng.randint(20, 90)
    text = rng.choice(
        (
            f"a {noun} with a {room} of 0.5 m2",
            f"a one-storey {noun} with {many} {room}s",
            f"a 20-storey {noun} with a {room} on every floor",
            f"a {noun} of {few * 5} m2 with {few + 3} bedrooms and {few + 2} bathrooms",
            f"a {noun} with {many} rooms on {few} floors",
            f"a {few}-storey {noun} with {few + 2} floors and no rooms",
            f"a {noun} without a {room} and with two {room}s",
            f"a {noun} with a {many * 10} m2 {room} and a floor of {many} m2",
            f"a single-storey {noun} with a basement, an attic and the {room} on the fourth floor",
            f"a {noun} that is 3 m wide with {many // 4} {room}s",
            f"a {room}",
            f"nothing but {many // 3} {room}s",
            f"a {noun} with {many} toilets for {many * 10} people",
            f"a {noun} with the {room} above itself and below the {room}",
            f"a windowless {noun} with {few} doors and a {room} inside a {room}",
            f"a {noun} 2 m2",
        )
    )
    options: dict[str, float | int] = {}
    if rng.random() < 0.25:
        options["floor_area"] = float(rng.choice((1, 6, 12, 20, 5_000)))
    if rng.random() < 0.25:
        options["floors"] = rng.choice((1, 2, 20, 40))
    return BuildRequest(description=text, seed=rng.randrange(1_000), **options)
