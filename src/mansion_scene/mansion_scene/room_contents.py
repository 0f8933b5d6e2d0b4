"""Objects of a room: chosen from the catalogue, placed, and decorated (Algorithm 1, lines 12 and 13)."""

from collections.abc import Callable, Sequence

import msgspec
from shapely.geometry import LineString, Polygon

from mansion_assets.catalogue import Catalogue, RoomFurnishing, furnish_request, load_catalogue
from mansion_assets.catalogue.records import Item
from mansion_geometry.randomness import item_seed
from mansion_msgs_py.placement import PlacedObject, PlacementOpening, PlacementRoom
from mansion_msgs_py.scene import Discard, Door, SceneObject, SceneRoom
from mansion_msgs_py.shapes import Segment
from mansion_scene.clearance import clear_of_ways
from mansion_scene.decor import decorate_room, scene_object
from mansion_scene.placement import place_room
from mansion_scene.structure import FloorStructure

__all__ = ["ItemChooser", "RoomFurnisher", "room_openings"]

ItemChooser = Callable[[SceneRoom, float, tuple[float, float]], Sequence[Item] | None]
"""Chooses the floor objects of a room, given the room, its net area and the sides of its bounding rectangle."""

_PANEL_WALL = 0.4  # metres of wall on each side of a lift's landing door


def room_openings(structure: FloorStructure, room: SceneRoom) -> tuple[list[PlacementOpening], list[PlacementOpening]]:
    """Return a room's doors and windows as openings in the boundary of its net interior."""
    net = Polygon(room.net_polygon, room.net_holes)
    doors = [
        PlacementOpening(id=door.id, segment=_on_boundary(net, door.segment), sill=0.0)
        for door in structure.doors
        if room.id in door.rooms
    ]
    windows = [
        PlacementOpening(id=window.id, segment=_on_boundary(net, window.segment), sill=window.sill)
        for window in structure.windows
        if window.room == room.id
    ]
    return doors, windows


def _on_boundary(net: Polygon, segment: Segment) -> Segment:
    """Move a segment from a wall's centre line on to the face that bounds a net interior."""
    line = LineString(segment)
    middle = line.interpolate(0.5, normalized=True)
    boundary = net.boundary
    face = boundary.interpolate(boundary.project(middle))
    dx, dy = face.x - middle.x, face.y - middle.y
    (ax, ay), (bx, by) = segment
    return (round(ax + dx, 4), round(ay + dy, 4)), (round(bx + dx, 4), round(by + dy, 4))


class RoomFurnisher:
    """Furnishes the rooms of one floor, each from a seed of its own.

    Parameters
    ----------
    structure : FloorStructure
    seed : int
        Seed of the building.
    style : str
        Style of the building; rooms of one style and seed prefer the same assets.
    catalogue : Catalogue, optional
        The package's own by default.
    chooser : callable, optional
        Chooses a room's floor objects; the room type's own list is used where it is absent or returns ``None``.
    """

    def __init__(
        self,
        structure: FloorStructure,
        *,
        seed: int,
        style: str = "",
        catalogue: Catalogue | None = None,
        chooser: ItemChooser | None = None,
    ) -> None:
        self._structure = structure
        self._seed = seed
        self._style = style
        self._chooser = chooser
        self._catalogue = catalogue if catalogue is not None else load_catalogue()

    def furnish(self, room: SceneRoom) -> tuple[list[SceneObject], list[Discard]]:
        """Return a room's objects, large ones first, and what could not be placed."""
        net = Polygon(room.net_polygon, room.net_holes)
        x0, y0, x1, y1 = net.bounds
        furnishing = furnish_request(
            self._catalogue,
            room.room_type,
            net.area,
            seed=self._seed,
            style=self._style,
            room_id=room.id,
            extent=(x1 - x0, y1 - y0),
            items=None if self._chooser is None else self._chooser(room, net.area, (x1 - x0, y1 - y0)),
        )
        doors, windows = room_openings(self._structure, room)
        result = place_room(
            PlacementRoom(
                room_id=room.id,
                room_type=room.room_type,
                polygon=room.net_polygon,
                holes=room.net_holes,
                objects=furnishing.floor,
                doors=doors,
                windows=windows,
            ),
            seed=item_seed(self._seed, room.id),
        )
        placed = _scene_objects(room, furnishing, result.placements)
        small = decorate_room(
            self._catalogue,
            furnishing,
            room_id=room.id,
            net_polygon=room.net_polygon,
            net_holes=room.net_holes,
            ceiling_height=room.ceiling_height,
            doors=[_with_panels(door) for door in self._structure.doors if room.id in door.rooms],
            windows=[window for window in self._structure.windows if window.room == room.id],
            placed=placed,
            seed=self._seed,
        )
        left = [
            Discard(room=room.id, name=lost.name, count=lost.count, reason=lost.reason) for lost in result.discarded
        ]
        return [*placed, *clear_of_ways(small, placed, net, doors)], left


def _with_panels(door: Door) -> Door:
    """Widen a lift's landing door by the wall that its call panel takes, so that nothing is hung there."""
    if door.kind != "sliding":
        return door
    (ax, ay), (bx, by) = door.segment
    dx, dy = (bx - ax) / door.width * _PANEL_WALL, (by - ay) / door.width * _PANEL_WALL
    return msgspec.structs.replace(
        door, segment=((ax - dx, ay - dy), (bx + dx, by + dy)), width=door.width + 2 * _PANEL_WALL
    )


def _scene_objects(room: SceneRoom, furnishing: RoomFurnishing, placements: list[PlacedObject]) -> list[SceneObject]:
    counts: dict[str, int] = {}
    objects = []
    for placement in placements:
        asset = furnishing.asset_for(placement.name, placement.size)
        counts[asset.category] = counts.get(asset.category, 0) + 1
        x, y = placement.center
        objects.append(
            scene_object(
                asset,
                f"{room.id}/{asset.category}_{counts[asset.category]}",
                room.id,
                (x, y, asset.size[2] / 2),
                placement.rotation,
                mount="floor",
            )
        )
    return objects
