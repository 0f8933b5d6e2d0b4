"""Objects of a room: chosen from the catalogue, placed, and decorated (Algorithm 1, lines 12 and 13)."""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Protocol

import msgspec
import numpy as np
import shapely
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from mansion_assets.catalogue import Asset, Catalogue, RoomFurnishing, furnish_request, load_catalogue
from mansion_assets.catalogue.piece_counts import pieces
from mansion_assets.catalogue.records import Item
from mansion_assets.catalogue.requested_furniture import asked_counts, is_a
from mansion_geometry.randomness import item_seed
from mansion_knowledge.essentials import Need
from mansion_knowledge.furnished_as import furnished_as
from mansion_knowledge.object_kinds import answers
from mansion_msgs_py.placement import PlacedObject, PlacementOpening, PlacementResult, PlacementRoom
from mansion_msgs_py.program import Clutter, RequestedObject
from mansion_msgs_py.scene import Discard, Door, SceneObject, SceneRoom, Wall, Window
from mansion_msgs_py.shapes import Segment
from mansion_scene.clearance import clear_of_ways, floor_around
from mansion_scene.decor import decorate_room, scene_object
from mansion_scene.decor.frames import Ids
from mansion_scene.decor.small_objects import with_clutter
from mansion_scene.essentials import essential_items, essential_requests, essentials_of, lacking, left_out, slept_in_as
from mansion_scene.placement import place_room
from mansion_scene.requested_objects import (
    PART,
    asked_alone,
    extra_wishes,
    in_usual_order,
    named_as_asked,
    not_met,
    placeable,
    shortage,
    single_seats,
    with_displaced,
    with_extra,
    with_usual,
    within_reach,
    without_surplus_seats,
)

__all__ = ["FloorOpenings", "ItemChooser", "RoomFurnisher", "room_openings"]

ItemChooser = Callable[[SceneRoom, float, tuple[float, float]], Sequence[Item] | None]
"""Chooses the floor objects of a room, given the room, its net area and the sides of its bounding rectangle."""

_Trial = tuple[RoomFurnishing, PlacementResult]

_Place = Callable[[RoomFurnishing], PlacementResult]
"""Places what a room is to have."""

_HIGH_SILL = 1.5
"""From this sill on a window is for air: a shower may stand before it where there is no other place, metres."""

_EATEN_IN = 12.0
"""Area of a kitchen from which a table stands in it, square metres."""

_PANEL_WALL = 0.4  # metres of wall on each side of a lift's landing door


class FloorOpenings(Protocol):
    """The rooms, walls, doors and windows of a floor: its structure, or its finished scene."""

    @property
    def rooms(self) -> Sequence[SceneRoom]:
        """All rooms."""

    @property
    def walls(self) -> Sequence[Wall]:
        """All walls."""

    @property
    def doors(self) -> Sequence[Door]:
        """All doors."""

    @property
    def windows(self) -> Sequence[Window]:
        """All windows."""


def room_openings(structure: FloorOpenings, room: SceneRoom) -> tuple[list[PlacementOpening], list[PlacementOpening]]:
    """Return a room's doors and windows as openings in the boundary of its net interior."""
    boundary = Polygon(room.net_polygon, room.net_holes).boundary
    doors = [door for door in structure.doors if room.id in door.rooms]
    windows = [window for window in structure.windows if window.room == room.id]
    openings = [*(door.segment for door in doors), *(window.segment for window in windows)]
    segments = iter(_on_boundary(boundary, openings))
    return (
        [
            PlacementOpening(
                id=d.id, segment=next(segments), sill=0.0, is_open=d.kind == "open", is_outer=None in d.rooms
            )
            for d in doors
        ],
        [PlacementOpening(id=w.id, segment=next(segments), sill=w.sill) for w in windows],
    )


def _on_boundary(boundary: BaseGeometry, segments: Sequence[Segment]) -> list[Segment]:
    """Move segments from walls' centre lines on to the faces that bound a net interior."""
    if not segments:
        return []
    middles = shapely.line_interpolate_point(shapely.linestrings(np.array(segments)), 0.5, normalized=True)
    faces = shapely.line_interpolate_point(boundary, shapely.line_locate_point(boundary, middles))
    shifts = shapely.get_coordinates(faces) - shapely.get_coordinates(middles)
    return [
        ((round(ax + dx, 4), round(ay + dy, 4)), (round(bx + dx, 4), round(by + dy, 4)))
        for ((ax, ay), (bx, by)), (dx, dy) in zip(segments, shifts.tolist(), strict=True)
    ]


class RoomFurnisher:
    """Furnishes the rooms of one floor, each from a seed of its own.

    Parameters
    ----------
    structure : FloorOpenings
    seed : int
        Seed of the building.
    style : str
        Style of the building; rooms of one style and seed prefer the same assets.
    catalogue : Catalogue, optional
        The package's own by default.
    chooser : callable, optional
        Chooses a room's floor objects; the room type's own list is used where it is absent or returns ``None``.
    requested : mapping of str to sequence of RequestedObject, optional
        By room, what the brief asks for in it.
    building_type : str
        A room may be furnished as another type because of it, see `furnished_as`.
    called : str
        What the brief calls the building, where that is no such type.
    clutter : mapping of str to {"sparse", "dense"}, optional
        The rooms in which fewer or more small objects than usual lie about.
    """

    def __init__(
        self,
        structure: FloorOpenings,
        *,
        seed: int,
        style: str = "",
        catalogue: Catalogue | None = None,
        chooser: ItemChooser | None = None,
        requested: Mapping[str, Sequence[RequestedObject]] | None = None,
        building_type: str = "",
        called: str = "",
        clutter: Mapping[str, Clutter] | None = None,
    ) -> None:
        self._structure = structure
        self._clutter = clutter or {}
        self._building_type = building_type
        self._called = called
        self._seed = seed
        self._style = style
        self._chooser = chooser
        self._requested = requested or {}
        self._catalogue = catalogue if catalogue is not None else load_catalogue()

    def furnish(self, room: SceneRoom, standing: Sequence[SceneObject] = ()) -> tuple[list[SceneObject], list[Discard]]:
        """Return a room's objects, large ones first, and what could not be placed.

        Parameters
        ----------
        standing : sequence of SceneObject
            What is in the room already; it keeps its place and its id, and is not among the objects returned.
        """
        asked = self._requested.get(room.id, ())
        kind = furnished_as(room.room_type, self._building_type, room.name, self._beside(room), self._called)
        room = msgspec.structs.replace(room, room_type=kind)
        net = Polygon(room.net_polygon, room.net_holes)
        slept_in = slept_in_as(room, self._structure.rooms, self._building_type)
        usual, room = room, msgspec.structs.replace(room, room_type=slept_in)
        items = None if self._chooser is None else self._chooser(room, net.area, _extent(net))
        objects, left = self._furnished(room, standing, items, asked)
        # What a model chooses is not overruled; the receipt tells what such a room lacks.
        needs = (essentials_of(room, asked) or essentials_of(usual, asked)) if items is None else []
        short = lacking(needs, [*standing, *objects])
        for frugality in range(3) if short else ():
            trial, trial_left = self._furnished_usably(room, standing, asked, needs, frugality)
            still = lacking(needs, [*standing, *trial])
            if sum(still.values()) < sum(short.values()) and not self._loses(asked, objects, trial):
                objects, left, short = trial, trial_left, still
            if not short:
                break
        return objects, [*left, *left_out(self._catalogue, room, short)]

    def _furnished_usably(
        self,
        room: SceneRoom,
        standing: Sequence[SceneObject],
        asked: Sequence[RequestedObject],
        needs: Sequence[Need],
        frugality: int,
    ) -> tuple[list[SceneObject], list[Discard]]:
        """Furnish a room with what it cannot be used without asked for, besides what the brief asks for.

        Parameters
        ----------
        frugality : int
            0 asks for what such rooms usually have, 1 for the smallest of its kind, 2 puts it before high windows too.
        """
        smallest = frugality > 0
        wanted = list(lacking(needs, standing))
        usual = self._catalogue.room_program(room.room_type).floor
        fitting = None if smallest else essential_items(self._catalogue, usual, wanted)
        more = essential_requests(self._catalogue, room.room_type, wanted, smallest=smallest)
        return self._furnished(room, standing, fitting, [*asked, *more], high_windows=frugality < 2)

    def _loses(
        self, asked: Sequence[RequestedObject], before: Sequence[SceneObject], after: Sequence[SceneObject]
    ) -> bool:
        """Tell whether a room has less of what the brief asks for than before."""
        counts = asked_counts(asked)
        short = [shortage(counts, [self._catalogue.asset(o.asset) for o in objects]) for objects in (before, after)]
        return sum(short[1].values()) > sum(short[0].values())

    def _furnished(
        self,
        room: SceneRoom,
        standing: Sequence[SceneObject],
        items: Sequence[Item] | None,
        asked: Sequence[RequestedObject],
        *,
        high_windows: bool = True,
    ) -> tuple[list[SceneObject], list[Discard]]:
        net = Polygon(room.net_polygon, room.net_holes)
        wishes = self._wishes(room, net, items, asked)
        counts = asked_counts(asked)
        free = floor_around(room, standing)
        if counts:
            compact = self._wishes(room, net, items, asked, compact=True)
            settled = [request for request in asked if request.exact or not request.count]
            usual = self._wishes(room, net, items, settled)
            place = partial(self._placed, free, high_windows=high_windows)
            trial = _until_met(place, counts, wishes, compact)
            wishes, result = _no_fewer_than_usual(place, asked, trial, usual)
        else:
            result = self._placed(free, wishes)
        placed = self._scene_objects(free, wishes, result.placements, counts, standing)
        left = [
            Discard(room=room.id, name=lost.name.removesuffix(PART), count=lost.count, reason=lost.reason)
            for lost in result.discarded
        ]
        if not counts:
            return [*placed, *self._decorated(room, net, wishes, placed, standing)], left
        small, short = self._decorated_as_asked(room, net, wishes, placed, standing, counts)
        categories = {name: asset.category for name, asset in wishes.floor_assets.items()}
        named = named_as_asked([*placed, *small], asked)
        return named, [*left, *not_met(self._catalogue, room.id, short, left, categories)]

    def _wishes(
        self,
        room: SceneRoom,
        net: Polygon,
        items: Sequence[Item] | None,
        asked: Sequence[RequestedObject],
        *,
        compact: bool = False,
    ) -> RoomFurnishing:
        furnishing = furnish_request(
            self._catalogue,
            room.room_type,
            net.area,
            seed=self._seed,
            style=self._style,
            room_id=room.id,
            extent=_extent(net),
            items=items,
            requested=asked,
            compact=compact,
            beside=self._beside(room),
        )
        clutter = self._clutter.get(room.id)
        if clutter is None:
            return furnishing
        return msgspec.structs.replace(furnishing, small=with_clutter(furnishing.small, clutter))

    def _beside(self, room: SceneRoom) -> tuple[str, ...]:
        """Return the types of the other rooms of the floor; a kitchen that one eats in is also a kitchen diner."""
        others = [other for other in self._structure.rooms if other.id != room.id]
        dined_in = any(other.room_type == "kitchen" and other.area >= _EATEN_IN for other in others)
        return (*(other.room_type for other in others), *(("kitchen_diner",) if dined_in else ()))

    def _placed(self, room: SceneRoom, wishes: RoomFurnishing, *, high_windows: bool = True) -> PlacementResult:
        doors, windows = room_openings(self._structure, room)
        windows = [window for window in windows if high_windows or window.sill < _HIGH_SILL]
        return place_room(
            PlacementRoom(
                room_id=room.id,
                room_type=room.room_type,
                polygon=room.net_polygon,
                holes=room.net_holes,
                objects=wishes.floor,
                doors=doors,
                windows=windows,
            ),
            seed=item_seed(self._seed, room.id),
        )

    def _scene_objects(
        self,
        room: SceneRoom,
        wishes: RoomFurnishing,
        placements: Sequence[PlacedObject],
        counts: Mapping[str, int],
        standing: Sequence[SceneObject],
    ) -> list[SceneObject]:
        """Return placed objects as those of the scene, rows of seats that are asked for seat by seat."""
        ids = Ids(room.id, (o.id for o in standing))
        objects: list[SceneObject] = []
        for placement in placements:
            row = wishes.asset_for(placement.name, placement.size)
            asked = any(number and answers(category, row.category) for category, number in counts.items())
            for asset, (x, y) in single_seats(self._catalogue, row, placement) if asked else [(row, placement.center)]:
                new = ids.new(asset.category)
                asset = _in_its_colour(self._catalogue, asset, item_seed(self._seed, room.id) + len(objects))
                objects.append(
                    scene_object(asset, new, room.id, (x, y, asset.size[2] / 2), placement.rotation, mount="floor")
                )
        return without_surplus_seats(within_reach(objects, Polygon(room.net_polygon, room.net_holes)), counts)

    def _decorated(
        self,
        room: SceneRoom,
        net: Polygon,
        wishes: RoomFurnishing,
        placed: Sequence[SceneObject],
        standing: Sequence[SceneObject],
        asked: Sequence[Asset] = (),
    ) -> list[SceneObject]:
        doors, _ = room_openings(self._structure, room)
        small = decorate_room(
            self._catalogue,
            wishes,
            room_id=room.id,
            net_polygon=room.net_polygon,
            net_holes=room.net_holes,
            ceiling_height=room.ceiling_height,
            doors=[_with_panels(door) for door in self._structure.doors if room.id in door.rooms],
            windows=[window for window in self._structure.windows if window.room == room.id],
            placed=placed,
            standing=standing,
            seed=self._seed,
            asked=asked,
            low_walls=[
                wall
                for wall in self._structure.walls
                if room.id in (wall.left, wall.right) and wall.height < room.ceiling_height - 0.5
            ],
        )
        return clear_of_ways(small, [*(o for o in standing if o.mount == "floor"), *placed], net, doors)

    def _decorated_as_asked(
        self,
        room: SceneRoom,
        net: Polygon,
        wishes: RoomFurnishing,
        placed: Sequence[SceneObject],
        standing: Sequence[SceneObject],
        counts: dict[str, int],
    ) -> tuple[list[SceneObject], dict[str, int]]:
        """Return what a room gets beyond its furniture, and by category how many pieces are short."""
        there = [self._catalogue.asset(o.asset) for o in placed]
        small = self._decorated(room, net, wishes, placed, standing)
        short = shortage(counts, [*there, *(self._catalogue.asset(o.asset) for o in small)])
        wanted = short
        for trial in range(3):
            if not short:
                break
            extra = extra_wishes(self._catalogue, wanted, short, seed=self._seed, room_id=room.id, trial=trial)
            further = with_extra(wishes, extra, counts, alone=trial == 2)
            again = self._decorated(room, net, further, placed, standing, extra.small)
            left = shortage(counts, [*there, *(self._catalogue.asset(o.asset) for o in again)])
            if sum(left.values()) < sum(short.values()):
                small, short = again, left
            wanted = with_displaced(self._catalogue, wanted, left)
        unwanted = [category for category, number in counts.items() if not number]
        return [o for o in small if not any(is_a(o.category, category) for category in unwanted)], short


def _in_its_colour(catalogue: Catalogue, asset: Asset, seed: int) -> Asset:
    """Return the asset, or for a vehicle one of the same make: no two owners choose the same colour."""
    if "vehicle" not in asset.tags:
        return asset
    alike = [
        other
        for other in catalogue.by_category(asset.category)
        if (other.size, other.recipe, other.parameters) == (asset.size, asset.recipe, asset.parameters)
    ]
    return alike[seed % len(alike)]


def _until_met(place: _Place, counts: dict[str, int], wishes: RoomFurnishing, compact: RoomFurnishing) -> _Trial:
    """Place with less and less of what nobody asked for, until all that the brief asks for stands."""
    beyond = shortage(counts, placeable(wishes))
    goal = {category: number - beyond.get(category, 0) for category, number in counts.items()}

    def lost(trial: _Trial) -> int:
        return sum(shortage(goal, _standing(trial)).values())

    best: _Trial | None = None
    least = 0
    for number, trial_wishes in enumerate((in_usual_order(wishes), wishes, *asked_alone(compact))):
        trial = trial_wishes, place(trial_wishes)
        if best is None or lost(trial) < least:
            best, least, alone = trial, lost(trial), number > 1
        if not least:
            break
    assert best is not None
    for share in (0.6, 0.25) if alone else ():
        fuller = with_usual(best[0], compact, share)
        trial = fuller, place(fuller)
        if lost(trial) <= least:
            return trial
    return best


def _no_fewer_than_usual(
    place: _Place, asked: Sequence[RequestedObject], trial: _Trial, usual: RoomFurnishing
) -> _Trial:
    """Return a trial, or the room as it is without requests where that has more of what they are for.

    Who asks for a sofa does not want fewer than such a room has anyway. Rows of seats are left alone: they stand seat
    by seat only where they are asked for.
    """
    counts = asked_counts(request for request in asked if not request.exact)
    planned = placeable(usual)
    goal = {category: max(n, n and sum(pieces(category, a) == 1 for a in planned)) for category, n in counts.items()}
    if not shortage(goal, _standing(trial)):
        return trial
    other = usual, place(usual)
    least = asked_counts(asked)
    short, otherwise = (sum(shortage(least, _standing(one)).values()) for one in (trial, other))
    fewer, more = (sum(shortage(goal, _standing(one)).values()) for one in (trial, other))
    return other if otherwise <= short and more < fewer else trial


def _standing(trial: _Trial) -> list[Asset]:
    """Return the assets of what stands on the floor after a trial."""
    wishes, result = trial
    return [wishes.asset_for(placed.name, placed.size) for placed in result.placements]


def _extent(net: Polygon) -> tuple[float, float]:
    x0, y0, x1, y1 = net.bounds
    return x1 - x0, y1 - y0


def _with_panels(door: Door) -> Door:
    """Widen a lift's landing door by the wall that its call panel takes, so that nothing is hung there."""
    if door.kind != "sliding":
        return door
    (ax, ay), (bx, by) = door.segment
    dx, dy = (bx - ax) / door.width * _PANEL_WALL, (by - ay) / door.width * _PANEL_WALL
    return msgspec.structs.replace(
        door, segment=((ax - dx, ay - dy), (bx + dx, by + dy)), width=door.width + 2 * _PANEL_WALL
    )
