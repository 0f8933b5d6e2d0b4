"""Objects that the brief asks for in a room: which are missing, how they are tried again, and which do not fit."""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Literal

import msgspec
from shapely import MultiPolygon, Polygon, union_all

from mansion_assets.catalogue import Asset, Catalogue, HangRequest, RoomFurnishing, RugRequest
from mansion_assets.catalogue.piece_counts import pieces
from mansion_assets.catalogue.requested_furniture import is_rug
from mansion_geometry.object_footprints import footprint
from mansion_geometry.randomness import item_generator
from mansion_geometry.robot_body import BODY_RADIUS, ROBOT_RADIUS, ROBOT_REACH
from mansion_knowledge.object_kinds import added_for, answers, single_seat, single_seat_categories, substitutes
from mansion_msgs_py.placement import MatrixStructure, PairedStructure, PlacedObject, PlacementObject, SingleStructure
from mansion_msgs_py.program import RequestedObject
from mansion_msgs_py.scene import Discard, SceneObject

__all__ = [
    "PART",
    "Extra",
    "asked_alone",
    "extra_wishes",
    "in_usual_order",
    "named_as_asked",
    "not_met",
    "placeable",
    "shortage",
    "single_seats",
    "with_displaced",
    "with_extra",
    "with_usual",
    "within_reach",
    "without_surplus_seats",
]

PART = "__part"
"""Ends the name of the second half of a broken matrix."""

_HIGH = 2.3
"""Upper edge of what is hung over furniture because no lower stretch of wall is free, metres."""

_ROW_ENDS = 1
"""Most seats that pairs may have beyond what is asked for."""

_MOST_SMALL = 300
"""Most small things of a kind that a room gets on request."""


def shortage(counts: Mapping[str, int], assets: Sequence[Asset]) -> dict[str, int]:
    """Return the pieces by category that are asked for and not there."""
    short = {c: n - sum(pieces(c, asset) for asset in assets) for c, n in counts.items()}
    return {category: number for category, number in short.items() if number > 0}


def placeable(wishes: RoomFurnishing) -> list[Asset]:
    """Return the assets of all copies that a room is to have on its floor."""
    return [wishes.floor_assets[o.name] for o in wishes.floor for _ in range(o.quantity)]


def in_usual_order(wishes: RoomFurnishing) -> RoomFurnishing:
    """Return wishes in which what is asked for is placed in turn with the rest, as a room without requests is."""
    floor = [msgspec.structs.replace(o, first=False) for o in wishes.floor]
    return msgspec.structs.replace(wishes, floor=floor)


def asked_alone(wishes: RoomFurnishing) -> Iterator[RoomFurnishing]:
    """Yield ways to place what is asked for alone: as it is, with broken matrices, one by one, and anywhere."""
    asked = [o for o in wishes.floor if o.name in wishes.asked]
    yield _with_floor(wishes, asked)
    yield _with_floor(wishes, [part for o in asked for part in _broken(o)])
    yield _with_floor(wishes, [_single(o) for o in asked])
    anywhere = [msgspec.structs.replace(_single(o), global_="unconstrained", relative=[]) for o in asked]
    yield _with_floor(wishes, anywhere)


def with_usual(trial: RoomFurnishing, wishes: RoomFurnishing, share: float) -> RoomFurnishing:
    """Return a trial with the first `share` of the usual furniture of `wishes` added."""
    usual = [o for o in wishes.floor if o.name not in wishes.asked]
    return _with_floor(trial, [*trial.floor, *usual[: round(share * len(usual))]])


def _with_floor(wishes: RoomFurnishing, objects: Sequence[PlacementObject]) -> RoomFurnishing:
    """Return wishes for these floor objects, without relations to what is not among them."""
    names = {o.name for o in objects}
    floor = [
        msgspec.structs.replace(o, relative=[r for r in o.relative if r.target in names])
        for o in objects
        if not (isinstance(o.structure, PairedStructure) and o.structure.with_ not in names)
    ]
    assets = {o.name: wishes.floor_assets[o.name.removesuffix(PART)] for o in objects}
    return msgspec.structs.replace(wishes, floor=floor, floor_assets={**wishes.floor_assets, **assets})


def _broken(obj: PlacementObject) -> list[PlacementObject]:
    """Return a matrix as two of half as many rows each; anything else as it is."""
    structure = obj.structure
    if not isinstance(structure, MatrixStructure) or max(structure.rows, structure.cols) < 2:
        return [obj]
    long = max(structure.rows, structure.cols)
    other = structure.rows * structure.cols // long
    parts = []
    for number, half in enumerate((long - long // 2, long // 2)):
        parts.append(
            msgspec.structs.replace(
                obj,
                name=f"{obj.name}{PART * number}",
                quantity=half * other,
                structure=MatrixStructure(rows=half, cols=other),
            )
        )
    return parts


def _single(obj: PlacementObject) -> PlacementObject:
    if not isinstance(obj.structure, MatrixStructure):
        return obj
    return msgspec.structs.replace(obj, structure=SingleStructure(), global_="unconstrained")


class Extra(msgspec.Struct, frozen=True, kw_only=True):
    """What a room gets on its walls, ceiling, floor covering and tables beyond its usual wishes."""

    hung: tuple[HangRequest, ...] = ()
    rugs: tuple[RugRequest, ...] = ()
    small: tuple[Asset, ...] = ()


def extra_wishes(
    catalogue: Catalogue, short: Mapping[str, int], left: Mapping[str, int], *, seed: int, room_id: str, trial: int
) -> Extra:
    """Return what would make up for a shortage.

    Parameters
    ----------
    left : mapping of str to int
        What the trial before could not place.
    trial : int
        0 draws the assets; 1 takes those that need least space, of stand-ins too for small things; 2 hangs what is
        left high, and lays rugs below furniture.
    """
    hung, rugs, small = list[HangRequest](), list[RugRequest](), list[Asset]()
    for requested, number in short.items():
        order = _assets_for(catalogue, requested, seed=seed, room_id=room_id, trial=trial)
        if not order:
            continue
        first = order[0]
        if is_rug(first):
            rugs.append(RugRequest(assets=tuple(order), count=number, free=trial < 2))
        elif first.mount == "surface":
            several = order[:1] if trial else order
            small += [several[k % len(several)] for k in range(min(number, _MOST_SMALL))]
        elif first.mount != "floor":
            place: Literal["spread", "free"] = "spread" if first.mount == "ceiling" else "free"
            high = min(left.get(requested, 0), number) if trial == 2 else 0
            levels = ((number - high, None), (high, _HIGH - first.size[2] / 2))
            hung += [HangRequest(asset=first, count=n, place=place, height=height) for n, height in levels if n]
    return Extra(hung=tuple(hung), rugs=tuple(rugs), small=tuple(small))


def with_displaced(catalogue: Catalogue, wanted: Mapping[str, int], left: Mapping[str, int]) -> dict[str, int]:
    """Return what to put down next: what was wanted, with the small things that took the places of like ones."""

    def small(category: str) -> bool:
        return any(asset.mount == "surface" for asset in catalogue.by_category(added_for(category))[:1])

    return {category: n + (left.get(category, 0) if small(category) else 0) for category, n in wanted.items()}


def _assets_for(catalogue: Catalogue, requested: str, *, seed: int, room_id: str, trial: int) -> list[Asset]:
    """Return assets that answer a request, in the order in which they are tried."""
    category = added_for(requested)
    assets = list(catalogue.by_category(category))
    if not trial:
        drawn = item_generator(seed, "asked", room_id, category).permutation(len(assets))
        return sorted((assets[int(i)] for i in drawn), key=lambda asset: asset.key not in catalogue.preferred)
    if assets and assets[0].mount == "surface":
        assets += [a for a in catalogue.choose_from(substitutes(requested)) if a.mount == "surface"]
    return sorted(assets, key=lambda a: (a.size[0] * max(a.size[1], a.size[2]), a.key))


def with_extra(wishes: RoomFurnishing, extra: Extra, asked: Iterable[str], *, alone: bool) -> RoomFurnishing:
    """Return wishes with further ones before the usual; `alone` leaves out what nobody asked for on the walls."""
    names = list(asked)
    usual = [w for w in wishes.wall if not alone or any(answers(c, w.asset.category) for c in names)]
    return msgspec.structs.replace(
        wishes,
        wall=[*(w for w in extra.hung if w.asset.mount == "wall"), *usual],
        ceiling=[*(w for w in extra.hung if w.asset.mount == "ceiling"), *wishes.ceiling],
        rugs=[*extra.rugs, *wishes.rugs],
    )


_REASONS = {
    "wall": "no stretch of wall is free for it",
    "ceiling": "no part of the ceiling is free for it",
    "surface": "nothing in the room has a free surface for it",
    "floor": "no free place keeps it clear of others, doors clear and everything reachable",
}


def not_met(
    catalogue: Catalogue, room_id: str, short: Mapping[str, int], lost: Sequence[Discard], categories: Mapping[str, str]
) -> list[Discard]:
    """Return a discard for what is short and none of `lost` tells yet.

    Parameters
    ----------
    lost : sequence of Discard
        What the placer could not place.
    categories : mapping of str to str
        From the placer's names to categories.
    """
    out = []
    for category, number in short.items():
        told = sum(d.count for d in lost if answers(category, categories.get(d.name, d.name)))
        if told < number:
            assets = catalogue.by_category(added_for(category))
            reason = _REASONS.get(assets[0].mount, _REASONS["floor"]) if assets else "the catalogue has no such thing"
            out.append(Discard(room=room_id, name=category, count=number - told, reason=reason))
    return out


def named_as_asked(objects: Sequence[SceneObject], requested: Iterable[RequestedObject]) -> list[SceneObject]:
    """Return objects of which those that answer a request are called what the brief calls them.

    Notes
    -----
    No more are renamed than are asked for; a special request ("armchair") has its pieces before a general one.
    """
    out, taken = list(objects), set[int]()
    for request in sorted(requested, key=lambda r: (len(substitutes(r.category)), r.words)):
        answering = [n for n, o in enumerate(out) if n not in taken and answers(request.category, o.category)]
        answering.sort(key=lambda n: out[n].category not in (request.category, added_for(request.category)))
        for number in answering[: request.count]:
            taken.add(number)
            thing = out[number]
            if request.words and request.words not in (thing.name.lower(), thing.category.replace("_", " ")):
                out[number] = msgspec.structs.replace(thing, name=request.words)
    return out


def single_seats(catalogue: Catalogue, row: Asset, placement: PlacedObject) -> list[tuple[Asset, tuple[float, float]]]:
    """Return a pair of seats as assets of their own, each with its centre; anything else as it is.

    The middle seats of longer rows are out of a robot's reach, so those stay whole.
    """
    number = pieces(row.category, row)
    singles = catalogue.by_category(single_seat(row.category)) if number == 2 else []
    if not singles:
        return [(row, placement.center)]
    width = row.size[0] / number
    fitting = [seat for seat in singles if seat.size[0] <= width + 1e-6] or singles
    seat = max(fitting, key=lambda s: (s.material == row.material, s.size[0]))
    angle = math.radians(placement.rotation)
    x, y = placement.center
    steps = [(k - (number - 1) / 2) * width for k in range(number)]
    return [(seat, (x + step * math.cos(angle), y + step * math.sin(angle))) for step in steps]


def within_reach(objects: Sequence[SceneObject], net: Polygon) -> list[SceneObject]:
    """Return a room's objects without the single seats that a robot on its free floor cannot reach."""
    singles = single_seat_categories()
    if not any(o.category in singles for o in objects):
        return list(objects)
    shapes = [footprint(o) for o in objects]
    free = net.difference(union_all(shapes)).buffer(-BODY_RADIUS)
    parts = list(free.geoms) if isinstance(free, MultiPolygon) else [free]
    way = max(parts, key=lambda part: part.area)
    near = ROBOT_RADIUS + ROBOT_REACH
    return [o for o, shape in zip(objects, shapes) if o.category not in singles or shape.distance(way) <= near]


def without_surplus_seats(objects: Sequence[SceneObject], counts: Mapping[str, int]) -> list[SceneObject]:
    """Return objects without the last seats of a row that are more than asked for."""
    singles = single_seat_categories()
    out = list(objects)
    for category, number in counts.items():
        there = [o for o in out if answers(category, o.category)]
        beyond = len(there) - number
        if number and 0 < beyond <= _ROW_ENDS:
            surplus = [o.id for o in there if o.category in singles][-beyond:]
            out = [o for o in out if o.id not in surplus]
    return out
