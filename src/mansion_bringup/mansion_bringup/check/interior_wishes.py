"""Checks that rooms hold what a description asks for, and that they are as high, finished and full as it says."""

import math
import re
from collections import Counter, defaultdict
from collections.abc import Mapping

from mansion_bringup.check.finished_building import FinishedBuilding, Judge, is_on
from mansion_knowledge.object_kinds import answers, noun_of, seats_of_row
from mansion_knowledge.object_qualities import has_quality
from mansion_language import is_plural
from mansion_msgs_py.scene import SceneRoom
from mansion_msgs_py.wishes import Wish, WishValue

__all__ = ["INTERIOR_JUDGES"]

SUBSTANCES = (
    r"\b(hard)?wood(en)?\b|timber|parquet|\bplanks?\b|laminate|panelling|\bdeck(ing)?\b|herringbone|\b(oak|walnut|pine|maple"
    r"|birch|bamboo|cherry|ash|beech|mahogany)\b",
    r"carpet",
    r"\btile[sd]?\b|ceramic|porcelain|terracotta",
    r"marble",
    r"granite",
    r"\bstone\b|slate|limestone",
    r"terrazzo",
    r"concrete|cement",
    r"vinyl|\blino(leum)?\b",
    r"rubber",
    r"resin|epoxy",
    r"brick",
    r"plaster|drywall",
)
"""Patterns of the words for one substance each."""

COLOURS = (
    r"\b(?:white|black|grey|beige|blue|green|red|yellow|cream|brown|pink|orange|navy|turquoise|purple|ivory|charcoal)\b"
)
WOODS = r"\b(?:oak|walnut|pine|maple|birch|bamboo|cherry|ash|beech|mahogany)\b"
SHADES = r"\b(?:dark|light|pale)\b"
"""Words of shades, which count where a material is wanted of no colour."""

CEILING_TOLERANCE = 0.10
"""Metres by which a ceiling may differ from the height asked for."""

CLUTTERED, TIDY = 5.0, 1.5
"""Things to a square metre of furniture: no fewer where clutter is wanted, no more where tidiness is."""


def _object(wish: Wish, finished: FinishedBuilding) -> str:
    if wish.scope.some:
        return _some_lack(wish, finished)
    counts = _things(wish, finished)
    wanted = _number(wish.value)
    have = min(counts.values(), default=0) if wish.scope.each else sum(counts.values())
    if not (wish.value.type and counts and have >= wanted):
        return f"{have} of {wanted} are there"
    if wish.value.exact and (wish.scope.room or wish.value.limit == "most"):
        named = _things(wish, finished, noun=noun_of(wish.value.type)).values()
        there = max(named) if wish.scope.each else sum(named)
        if there > wanted:
            return f"{there} are there, more than {wanted}"
    return next(
        (f"not enough of them are {word}" for word in wish.value.unheeded if not _are_so(wish, finished, word)), ""
    )


def _number(value: WishValue) -> int:
    """Return how many are wanted; without a number several, or one set of what comes in sets."""
    if value.count is not None:
        return value.count
    return 1 if is_plural(value.type.split("_")[-1]) else 2


def _some_lack(wish: Wish, finished: FinishedBuilding) -> str:
    """Say how many of several rooms have what is wanted in some of them, where these are too few."""
    value, some = wish.value, wish.scope.some
    wanted = math.ceil(_number(value) / some)
    having = 0
    for _, room in finished.wanted_in(wish):
        things = [thing for thing in finished.things_in(room) if value.type and _called_so(thing.category, value)]
        of_the_noun = [thing for thing in things if noun_of(thing.category) == noun_of(value.type)]
        plain = [seats_of_row(thing.category, thing.size[0]) for thing in things]
        over = value.exact and sum(seats_of_row(t.category, t.size[0]) for t in of_the_noun) > wanted
        good = [all(has_quality(t.category, t.size, t.material, word) for word in value.unheeded) for t in things]
        having += sum(plain) >= wanted and not over and sum(good) >= min(wanted, len(good))
    return f"{having} of {some} rooms have {wanted}" if having < some else ""


def _are_so(wish: Wish, finished: FinishedBuilding, word: str) -> bool:
    """Whether enough of the things of a wish are as a word says; in every place where the count is for each."""
    scope = wish.scope
    rooms = {room.id for _, room in finished.wanted_in(wish)} if scope.room else None
    numbers: dict[str, list[bool]] = defaultdict(list)
    for scene in finished.scenes:
        for thing in scene.objects:
            here = thing.room in rooms if rooms is not None else is_on(scene.floor, scope.floors)
            if here and wish.value.type and _called_so(thing.category, wish.value):
                place = (thing.room if scope.room else str(scene.floor)) if scope.each else ""
                numbers[place].append(has_quality(thing.category, thing.size, thing.material, word))
    wanted = _number(wish.value)
    return all(sum(fitting) >= min(wanted, len(fitting)) for fitting in numbers.values())


def _no_object(wish: Wish, finished: FinishedBuilding) -> str:
    places = [place for place, count in _things(wish, finished).items() if count]
    if not places and re.search(r"(^|_)carpets?$", wish.value.name):
        rooms = finished.wanted_in(wish) if wish.scope.room else finished.rooms(wish.scope.floors)
        places = [room.id for _, room in rooms if "carpet" in room.floor_material]
    return f"{places[0]} has one" if places else ""


def _things(wish: Wish, finished: FinishedBuilding, *, noun: str = "") -> dict[str, int]:
    """Return how many objects of the wish's category each place has: a room where one is named, a storey elsewhere.

    With a noun, those alone that people count by it.
    """
    scope = wish.scope
    placed: Counter[str] = Counter()
    for scene in finished.scenes:
        for thing in scene.objects:
            if noun and not (noun_of(thing.category) == noun and answers(wish.value.type, thing.category)):
                continue
            if wish.value.type and _called_so(thing.category, wish.value):
                placed[thing.room] += seats_of_row(thing.category, thing.size[0])
    if scope.room:
        return {room.id: placed[room.id] for _, room in finished.wanted_in(wish)}
    return {
        f"storey {scene.floor}": sum(placed[room.id] for room in scene.rooms)
        for scene in finished.scenes
        if is_on(scene.floor, scope.floors)
    }


def _called_so(category: str, value: WishValue) -> bool:
    """Whether a category is of a wish's kind, or of its noun where that kind is a special one of the noun."""
    if answers(value.type, category):
        return True
    noun = re.escape(category.split("_")[-1])
    return "_" in value.type and re.fullmatch(rf"{noun}(e?s)?", value.name) is not None


def _height(wish: Wish, finished: FinishedBuilding) -> str:
    heights = [room.ceiling_height for room in _of_type(wish, finished)]
    wanted = wish.value.height or 0.0
    if heights and all(abs(height - wanted) <= CEILING_TOLERANCE + 1e-6 for height in heights):
        return ""
    return f"ceilings are {min(heights):.2f} to {max(heights):.2f} m high" if heights else "there is no such room"


def _material(wish: Wish, finished: FinishedBuilding) -> str:
    told = [entry for entry in finished.ledger if entry.kind == "material" and entry.value.type == wish.value.type]
    elsewhere = {entry.scope.room_type for entry in told if entry.scope.room_type} - {wish.scope.room_type}
    surfaces = [
        room.wall_material if wish.value.type == "wall" else room.floor_material
        for room in _of_type(wish, finished)
        if room.room_type not in elsewhere
    ]
    fitting = sum(_made_of(surface, wish.value.name) for surface in surfaces)
    strict = wish.scope.each or bool(wish.scope.room_type)
    enough = fitting == len(surfaces) if strict else 2 * fitting > len(surfaces)
    return "" if fitting and enough else f"{fitting} of {len(surfaces)} rooms have it"


def _made_of(surface: str, wanted: str) -> bool:
    """Whether one substance and one of the colours that are wanted are in both texts."""
    here, there = (text.lower().replace("_", " ").replace("gray", "grey") for text in (surface, wanted))
    named = [pattern for pattern in SUBSTANCES if re.search(pattern, there)]
    if named:
        colours = re.findall(COLOURS, there) or re.findall(SHADES, there)
        coloured = not colours or any(re.search(rf"\b{colour}\b", here) for colour in colours)
        trees = re.findall(WOODS, there)
        coloured = coloured and (not trees or any(re.search(rf"\b{tree}\b", here) for tree in trees))
        return coloured and any(re.search(pattern, here) for pattern in named)
    return any(re.search(rf"\b{re.escape(word)}\b", here) for word in there.split())


def _clutter(wish: Wish, finished: FinishedBuilding) -> str:
    own = {entry.scope.room_type for entry in finished.ledger if entry.kind == "clutter"} - {wish.scope.room_type}
    rooms = {room.id for room in _of_type(wish, finished) if room.room_type not in own}
    objects = [thing for scene in finished.scenes for thing in scene.objects if thing.room in rooms]
    carried = sum(1 for thing in objects if thing.parent)
    ground = sum(math.prod(thing.size[:2]) for thing in objects if thing.receptacle and not thing.parent)
    if not ground:
        return "nothing is there to lay things on"
    within = carried >= CLUTTERED * ground if wish.value.name == "dense" else carried <= TIDY * ground
    return "" if within else f"{carried} things lie on {ground:.1f} m2 of furniture"


def _of_type(wish: Wish, finished: FinishedBuilding) -> list[SceneRoom]:
    kind = wish.scope.room_type
    return [room for _, room in finished.rooms(wish.scope.floors) if not kind or room.room_type == kind]


INTERIOR_JUDGES: Mapping[str, Judge] = {
    "object": _object,
    "no_object": _no_object,
    "height": _height,
    "material": _material,
    "clutter": _clutter,
}
"""For each kind of wish for what rooms hold and are like, what judges it."""
