"""Small objects on and in the receptacles of a room, fewer or more of them as its clutter is to be."""

import math
from collections.abc import Sequence

import msgspec
import numpy as np
from msgspec.structs import replace

from mansion_assets.catalogue import Asset, Catalogue, Surface, Volume
from mansion_assets.catalogue.records import Arrangement, Scatter, Slot
from mansion_assets.catalogue.requested_furniture import laid_categories
from mansion_geometry.randomness import item_generator
from mansion_msgs_py.program import Clutter
from mansion_msgs_py.scene import SceneObject
from mansion_msgs_py.shapes import Point, Size3
from mansion_scene.decor.frames import Ids, scene_object, to_floor, to_local

__all__ = ["Shelf", "Spot", "shelves_of", "small_objects", "spot_of", "with_clutter"]

_GAP = 0.008
"""Least distance between neighbours, metres."""

_TRIES = 24


class Spot(msgspec.Struct, frozen=True):
    """The place of a small object: centre in the receptacle's frame, degrees, half extents of its turned rectangle."""

    x: float
    y: float
    turn: float
    half_w: float
    half_d: float


class Shelf:
    """A surface, or the floor of an inner volume, and the places taken on it.

    Parameters
    ----------
    carrier : Surface or Volume
    most : float
        Greatest share of the area that objects may cover.

    Attributes
    ----------
    spots : list of Spot
        Places taken.
    overhead : list of (Spot, float)
        Objects that hang above, and the height below each, metres.
    """

    def __init__(self, carrier: Surface | Volume, most: float = 0.6) -> None:
        self.inside = isinstance(carrier, Volume)
        self.kind = carrier.kind
        self.x, self.y = carrier.x, carrier.y
        self.half_w, self.half_d = carrier.w / 2, carrier.d / 2
        if isinstance(carrier, Volume):
            self.z, self.clearance, self.round = carrier.z - carrier.h / 2, carrier.h, False
        else:
            self.z, self.clearance, self.round = carrier.z, carrier.clearance, carrier.round
        self.spots: list[Spot] = []
        self.overhead: list[tuple[Spot, float]] = []
        self._free = most * carrier.w * carrier.d
        self._cursor = -self.half_w

    def place_at(self, size: Size3, x: float, y: float, turn: float) -> Spot | None:
        """Take the place at (x, y) in the receptacle's frame, or return None where it is not free."""
        spot = spot_of(size, x, y, turn)
        if size[2] > self.clearance - 0.005 or not self._holds(spot) or self._hits(spot):
            return None
        if any(size[2] > room - 0.005 and _meet(spot, other) for other, room in self.overhead):
            return None
        area = 4 * spot.half_w * spot.half_d
        if area > self._free + 1e-9 and self.spots:
            return None
        self._free -= area
        self.spots.append(spot)
        return spot

    def place_randomly(self, size: Size3, rng: np.random.Generator, turns: float = 25.0) -> Spot | None:
        """Take a random free place, with a rotation of up to `turns` degrees; None after 24 tries."""
        for _ in range(_TRIES):
            a, b, c = rng.random(3)
            turn = (2 * c - 1) * turns
            probe = spot_of(size, 0.0, 0.0, turn)
            rx, ry = self.half_w - probe.half_w, self.half_d - probe.half_d
            if rx < 0 or ry < 0:
                turn += 90.0
                probe = spot_of(size, 0.0, 0.0, turn)
                rx, ry = self.half_w - probe.half_w, self.half_d - probe.half_d
                if rx < 0 or ry < 0:
                    turn = 0.0 if size[0] <= 2 * self.half_w and size[1] <= 2 * self.half_d else 90.0
                    probe = spot_of(size, 0.0, 0.0, turn)
                    rx, ry = self.half_w - probe.half_w, self.half_d - probe.half_d
            if rx < 0 or ry < 0:
                return None
            spot = self.place_at(size, self.x + (2 * a - 1) * rx, self.y + (2 * b - 1) * ry, turn)
            if spot is not None:
                return spot
        return None

    def place_in_line(self, size: Size3) -> Spot | None:
        """Take the next place of a row from left to right along the front; None where the row is full."""
        if size[1] > 2 * self.half_d or size[0] > 2 * self.half_w:
            return None
        x = self.x + self._cursor + size[0] / 2
        y = self.y + max(-self.half_d + size[1] / 2, self.half_d - size[1] / 2 - 0.03)
        self._cursor += size[0] + 0.012
        if self._cursor > self.half_w + 0.012 + 1e-9:
            return None
        return self.place_at(size, x, y, 0.0)

    def _holds(self, spot: Spot) -> bool:
        dx, dy = abs(spot.x - self.x), abs(spot.y - self.y)
        if self.round:
            corner = (dx + spot.half_w) / self.half_w, (dy + spot.half_d) / self.half_d
            return math.hypot(*corner) <= 1.0
        return dx + spot.half_w <= self.half_w + 1e-6 and dy + spot.half_d <= self.half_d + 1e-6

    def _hits(self, spot: Spot) -> bool:
        return any(_meet(spot, other) for other in self.spots)

    def note_overhead(self, spot: Spot, room: float) -> None:
        """Note something above the surface that leaves `room` metres of height below it."""
        self.overhead.append((spot, room))

    def point(self, u: float, v: float) -> Point:
        """Return the point at (u, v) in [0, 1] from the left back corner."""
        return self.x + (2 * u - 1) * self.half_w, self.y + (2 * v - 1) * self.half_d


def _meet(spot: Spot, other: Spot) -> bool:
    return (
        abs(spot.x - other.x) < spot.half_w + other.half_w + _GAP
        and abs(spot.y - other.y) < spot.half_d + other.half_d + _GAP
    )


def spot_of(size: Size3, x: float, y: float, turn: float) -> Spot:
    """Return the place that an object of this size takes, rotated by `turn` degrees."""
    angle = math.radians(turn)
    c, s = abs(math.cos(angle)), abs(math.sin(angle))
    return Spot(x, y, turn, (c * size[0] + s * size[1]) / 2, (s * size[0] + c * size[1]) / 2)


def shelves_of(surfaces: tuple[Surface, ...], volumes: tuple[Volume, ...]) -> list[Shelf]:
    """Return the shelves of a receptacle: its surfaces, then the floors of its inner volumes."""
    return [Shelf(s) for s in surfaces] + [Shelf(v, 0.75) for v in volumes]


_OPEN = ("top", "shelf", "ledge")
"""Kinds of surface on which anything may be put down."""

_REACHED = (0.3, 1.6)
"""Heights of such surfaces, metres."""

_SEAT_REACH = 0.6
"""Greatest distance from a chair to the edge of its table, metres."""

_MATCHED = ("plate", "fork", "butter_knife", "glass", "wine_glass", "cup", "monitor", "keyboard", "mouse", "tray")
"""Categories of which a receptacle shows one variant only."""


def small_objects(
    catalogue: Catalogue,
    arrangements: Sequence[Arrangement],
    placed: Sequence[SceneObject],
    ids: Ids,
    room_id: str,
    seed: int,
    hung: Sequence[SceneObject] = (),
    asked: Sequence[Asset] = (),
) -> list[SceneObject]:
    """Return the small objects of a room.

    Parameters
    ----------
    arrangements : sequence of Arrangement
        Arrangements in order of preference; the first that names a receptacle's category is used.
    placed : sequence of SceneObject
        Receptacles and chairs, from the floor and from the walls.
    hung : sequence of SceneObject
        Wall and ceiling objects, below which less height is left.
    asked : sequence of Asset
        Things that the brief asks for; they are put down before the rest, each where such things usually are.

    Notes
    -----
    Each object lies wholly on its surface or in its box, 8 mm from its neighbours at least, and below the next board.
    """
    seats = [o for o in placed if "seat" in catalogue.asset(o.asset).tags]
    out: list[SceneObject] = []
    tables: dict[str, _Filler] = {}
    for obj in placed:
        asset = catalogue.asset(obj.asset)
        arrangement = next((a for a in arrangements if obj.category in a.on), None)
        if asset.receptacle and (arrangement is not None or asked):
            rng = item_generator(seed, "small", obj.id)
            tables[obj.id] = table = _Filler(catalogue, obj, asset, rng, ids, room_id, arrangement)
            table.note_hung(hung)
    _put_down(asked, list(tables.values()), item_generator(seed, "asked", room_id))
    for table in tables.values():
        if table.arrangement is not None and table.rng.random() < table.arrangement.p:
            table.fill(table.arrangement, seats)
        out += table.objects
    return out


def _put_down(asked: Sequence[Asset], tables: "Sequence[_Filler]", rng: np.random.Generator) -> None:
    """Put each thing on the table that suits it best and has fewest of the others, where it fits."""
    for asset in asked:
        for table in sorted(tables, key=lambda table: (not table.suits(asset), len(table.objects), -table.top)):
            if table.put_down(asset, rng):
                break


class _Filler:
    """One receptacle while it is filled."""

    def __init__(
        self,
        catalogue: Catalogue,
        obj: SceneObject,
        asset: Asset,
        rng: np.random.Generator,
        ids: Ids,
        room_id: str,
        arrangement: Arrangement | None = None,
    ) -> None:
        self.catalogue, self.obj, self.rng, self.arrangement = catalogue, obj, rng, arrangement
        self.ids, self.room_id = ids, room_id
        self.shelves = shelves_of(asset.surfaces, asset.volumes)
        self.objects: list[SceneObject] = []
        self.chosen: dict[str, Asset] = {}

    def note_hung(self, hung: Sequence[SceneObject]) -> None:
        """Note the objects that hang over this receptacle."""
        reach = math.hypot(self.obj.size[0], self.obj.size[1]) / 2
        for other in hung:
            away = math.dist(other.position[:2], self.obj.position[:2])
            if other.id == self.obj.id or away > reach + math.hypot(*other.size[:2]) / 2:
                continue
            x, y = to_local(self.obj, other.position)
            spot = spot_of(other.size, x, y, other.rotation - self.obj.rotation)
            foot = other.bottom
            for shelf in self.shelves:
                level = self.obj.position[2] + shelf.z
                if not shelf.inside and other.top > level:
                    shelf.note_overhead(spot, foot - level)

    @property
    def top(self) -> float:
        """Area of the largest surface, square metres."""
        return max((4 * shelf.half_w * shelf.half_d for shelf in self.shelves if not shelf.inside), default=0.0)

    def suits(self, asset: Asset) -> bool:
        """Tell whether things of the asset's category usually lie here."""
        return self.arrangement is not None and asset.category in laid_categories(self.arrangement)

    def put_down(self, asset: Asset, rng: np.random.Generator) -> bool:
        """Put a thing on an open surface at a fitting height; tell whether it fits."""
        for shelf in self.shelves:
            level = self.obj.position[2] + shelf.z
            if shelf.inside or shelf.kind not in _OPEN or not _REACHED[0] <= level <= _REACHED[1]:
                continue
            spot = shelf.place_randomly(asset.size, rng, 8.0)
            if spot is not None:
                self._put(shelf, asset, spot)
                return True
        return False

    def fill(self, arrangement: Arrangement, seats: Sequence[SceneObject]) -> None:
        """Fill slots, then place settings before chairs, then scatter the rest."""
        top = next((s for s in self.shelves if not s.inside), None)
        if top is not None:
            for slot in arrangement.slots:
                self._slot(top, slot)
            if arrangement.seats:
                for chair in seats:
                    self._seat(top, chair, arrangement.seats)
        for scatter in arrangement.scatter:
            self._scatter(scatter)

    def _asset(self, category: str | list[str]) -> Asset | None:
        names = [category] if isinstance(category, str) else category
        name = names[int(self.rng.integers(len(names)))]
        assets = [a for a in self.catalogue.by_category(name) if a.mount in ("surface", "floor")]
        assets = self.catalogue.favoured(assets)
        if not assets:
            return None
        drawn = assets[int(self.rng.integers(len(assets)))]
        return self.chosen.setdefault(name, drawn) if name in _MATCHED else drawn

    def _slot(self, shelf: Shelf, slot: Slot) -> None:
        present = self.rng.random() < slot.p
        jitter = self.rng.uniform(-slot.jitter, slot.jitter, 2)
        asset = self._asset(slot.category)
        if asset is None or not present:
            return
        x, y = shelf.point(slot.u, slot.v)
        for shift in (0.0, 0.04, -0.04, 0.09, -0.09):
            px = _clamp(x + jitter[0] + shift, shelf.x, shelf.half_w - asset.size[0] / 2 - 0.005)
            py = _clamp(y + jitter[1], shelf.y, shelf.half_d - asset.size[1] / 2 - 0.005)
            spot = shelf.place_at(asset.size, px, py, slot.turn)
            if spot is not None:
                self._put(shelf, asset, spot)
                return

    def _seat(self, shelf: Shelf, chair: SceneObject, slots: Sequence[Slot]) -> None:
        """Add a place setting before a chair that faces this receptacle."""
        x, y = to_local(self.obj, chair.position)
        heading = math.radians(chair.rotation - self.obj.rotation + 90.0)
        ahead = (math.cos(heading), math.sin(heading))
        entry = _entry(shelf, (x, y), ahead, chair.size[1] / 2 + _SEAT_REACH)
        if entry is None:
            return
        right = (ahead[1], -ahead[0])
        turn = math.degrees(heading) + 90.0
        for slot in slots:
            present = self.rng.random() < slot.p
            jitter = self.rng.uniform(-0.012, 0.012, 2)
            asset = self._asset(slot.category)
            if asset is None or not present:
                continue
            px = entry[0] + ahead[0] * (slot.v + jitter[0]) + right[0] * (slot.u + jitter[1])
            py = entry[1] + ahead[1] * (slot.v + jitter[0]) + right[1] * (slot.u + jitter[1])
            spot = shelf.place_at(asset.size, px, py, (turn + slot.turn) % 360.0)
            if spot is not None:
                self._put(shelf, asset, spot)

    def _scatter(self, scatter: Scatter) -> None:
        wanted = int(self.rng.integers(scatter.min, scatter.max + 1))
        shelves = [s for s in self.shelves if s.inside == scatter.inside]
        if not shelves or self.rng.random() >= scatter.p:
            return
        order = self.rng.permutation(len(shelves))
        row: Asset | None = None
        for number in range(wanted):
            if row is None or not scatter.line or number % 4 == 0:
                row = self._asset(scatter.category)
            if row is None:
                continue
            for step in range(len(shelves)):
                turn_of = (number // 4 if scatter.line else number) + step
                shelf = shelves[int(order[turn_of % len(shelves)])]
                spot = shelf.place_in_line(row.size) if scatter.line else shelf.place_randomly(row.size, self.rng)
                if spot is not None:
                    self._put(shelf, row, spot)
                    break

    def _put(self, shelf: Shelf, asset: Asset, spot: Spot) -> None:
        x, y = to_floor(self.obj, (spot.x, spot.y))
        z = self.obj.position[2] + shelf.z + asset.size[2] / 2
        self.objects.append(
            scene_object(
                asset,
                self.ids.new(asset.category),
                self.room_id,
                (x, y, z),
                self.obj.rotation + spot.turn,
                mount="inside" if shelf.inside else "surface",
                parent=self.obj.id,
            )
        )


def _clamp(value: float, center: float, reach: float) -> float:
    return center if reach <= 0 else min(max(value, center - reach), center + reach)


def _entry(
    shelf: Shelf, start: tuple[float, float], ahead: tuple[float, float], reach: float
) -> tuple[float, float] | None:
    """Return where a ray from a chair enters the surface, at most `reach` ahead."""
    for step in range(1, 61):
        distance = reach * step / 60
        x, y = start[0] + ahead[0] * distance - shelf.x, start[1] + ahead[1] * distance - shelf.y
        if shelf.round:
            within = math.hypot(x / shelf.half_w, y / shelf.half_d) <= 1.0
        else:
            within = abs(x) <= shelf.half_w and abs(y) <= shelf.half_d
        if within:
            return (x + shelf.x, y + shelf.y)
    return None


_FACTORS = {"sparse": 0.35, "dense": 2.5}
"""How many times as many scattered objects as usual there are."""


def with_clutter(arrangements: Sequence[Arrangement], clutter: Clutter) -> list[Arrangement]:
    """Return arrangements of small objects that lay out fewer or more than usual.

    Place settings stay as they are: a laid table is not clutter.

    Examples
    --------
    >>> shelf = Arrangement(name="shelf", on=["bookcase"], scatter=[Scatter(category="book", min=2, max=4, p=0.5)])
    >>> [(s.min, s.max, s.p) for s in with_clutter([shelf], "dense")[0].scatter]
    [(5, 10, 0.875)]
    >>> [(s.min, s.max, s.p) for s in with_clutter([shelf], "sparse")[0].scatter]
    [(1, 1, 0.25)]
    """
    return [
        replace(
            arrangement,
            p=_likelihood(arrangement.p, clutter),
            slots=[_slot(slot, clutter) for slot in arrangement.slots],
            scatter=[_scatter(scatter, clutter) for scatter in arrangement.scatter],
        )
        for arrangement in arrangements
    ]


def _slot(slot: Slot, clutter: Clutter) -> Slot:
    """Return a slot as it is filled; what is there always, as a screen on its desk, stays."""
    return slot if slot.p >= 1.0 else replace(slot, p=_likelihood(slot.p, clutter))


def _scatter(scatter: Scatter, clutter: Clutter) -> Scatter:
    factor = _FACTORS[clutter]
    least, most = (round(factor * number) for number in (scatter.min, scatter.max))
    return replace(scatter, min=least, max=max(most, 1), p=_likelihood(scatter.p, clutter))


def _likelihood(p: float, clutter: Clutter) -> float:
    """Return how likely something is laid out: half as likely as usual, or in one of three attempts."""
    return 1.0 - (1.0 - p) ** 3 if clutter == "dense" else p / 2
