"""Decoration of a furnished room: rugs, wall and ceiling objects, and small objects."""

from collections.abc import Sequence

from mansion_assets.catalogue import Asset, Catalogue, RoomFurnishing
from mansion_geometry.randomness import item_generator
from mansion_msgs_py.scene import Door, SceneObject, Wall, Window
from mansion_msgs_py.shapes import Ring
from mansion_scene.decor.ceiling_objects import ceiling_objects
from mansion_scene.decor.frames import Ids, room_polygon, wall_edges
from mansion_scene.decor.rugs import rugs
from mansion_scene.decor.small_objects import small_objects
from mansion_scene.decor.wall_objects import wall_objects

__all__ = ["decorate_room"]


def decorate_room(
    catalogue: Catalogue,
    furnishing: RoomFurnishing,
    *,
    room_id: str,
    net_polygon: Ring,
    net_holes: Sequence[Ring] = (),
    ceiling_height: float,
    doors: Sequence[Door] = (),
    windows: Sequence[Window] = (),
    placed: Sequence[SceneObject] = (),
    standing: Sequence[SceneObject] = (),
    seed: int,
    asked: Sequence[Asset] = (),
    low_walls: Sequence[Wall] = (),
) -> list[SceneObject]:
    """Return the objects that decorate a room, beyond its placed furniture.

    Parameters
    ----------
    furnishing : RoomFurnishing
        What `furnish_request` returns.
    net_polygon, net_holes : rings
        Between the faces of the walls.
    ceiling_height : float
        Clear height of the room, metres.
    doors, windows : sequences
        Doors and windows of this room at least; others are ignored.
    placed : sequence of SceneObject
        The placed furniture of the room.
    standing : sequence of SceneObject
        What is in the room besides, which keeps its place and gets nothing laid on it.
    seed : int
        Seed of the building; with `room_id` it determines the result.
    asked : sequence of Asset
        Small things that must lie somewhere in the room.
    low_walls : sequence of Wall
        Those around the room that do not reach its ceiling: parapets.

    Returns
    -------
    list of SceneObject
        Rugs, wall objects, ceiling objects, small objects, in this order, less those that fit nowhere.
    """
    room = room_polygon(net_polygon, net_holes)
    edges = wall_edges(net_polygon, net_holes)
    there = [*standing, *placed]
    ids = Ids(room_id, (o.id for o in there))
    rng = item_generator(seed, "decor", room_id)
    carpets = rugs(furnishing.rugs, room, edges, doors, there, ids, room_id, rng)
    hung = wall_objects(furnishing.wall, edges, doors, windows, ceiling_height, there, ids, room_id, rng, low_walls)
    lamps = ceiling_objects(
        catalogue, furnishing.ceiling, room, edges, ceiling_height, [*there, *hung], ids, room_id, rng
    )
    carriers = [*placed, *(o for o in hung if o.receptacle)]
    small = small_objects(catalogue, furnishing.small, carriers, ids, room_id, seed, [*standing, *hung, *lamps], asked)
    return [*carpets, *hung, *lamps, *small]
