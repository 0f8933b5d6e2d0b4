"""PlaceOnSurface and PlaceInContainer: bring a new object to the surface, the container or the room that it is for."""

from mansion_assets.catalogue import Asset
from mansion_editing.physics.engine import PhysicsEngine
from mansion_editing.state import SceneState
from mansion_editing.tools.destinations import Accept, AtReceptacle, InRoom
from mansion_editing.tools.floor_places import stand_on_floor
from mansion_editing.tools.floor_wishes import place_as_wished
from mansion_editing.tools.hanging import hang
from mansion_editing.tools.painting import recoloured
from mansion_editing.tools.perception import object_named
from mansion_editing.tools.placing_wishes import wish_of
from mansion_editing.tools.resting import settle_on
from mansion_msgs_py.editing.objects import PlaceInContainerArgs, PlaceOnSurfaceArgs
from mansion_msgs_py.scene import SceneObject, SceneRoom
from mansion_scene.decor.frames import scene_object

__all__ = ["place_in_container", "place_on_surface", "put_in_room"]


def place_on_surface(
    state: SceneState, args: PlaceOnSurfaceArgs, engine: PhysicsEngine, accept: Accept | None = None
) -> SceneObject:
    """Put a new object on a receptacle, or furniture on the floor of a room.

    Parameters
    ----------
    accept : callable, optional
        Judges a place on the floor before it is taken.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for an unknown asset or receptacle, ``INFEASIBLE`` with the reason where it finds no place.
    """
    asset = state.catalogue.asset(args.asset_id)
    room = state.room(args.receptacle_id)
    wish = wish_of(state, args)
    if room is not None:
        floor = room[0]
        placed = put_in_room(state, _new(state, asset, *room, args.color, args.name), InRoom(*room, wish, accept))
    else:
        floor, receptacle = object_named(state, args.receptacle_id, "$.receptacle_id")
        new = _new(state, asset, floor, receptacle, args.color, args.name)
        placed = settle_on(state, new, AtReceptacle(floor, receptacle, inside=False, wish=wish), engine)
    state.add(floor, placed)
    return placed


def put_in_room(state: SceneState, thing: SceneObject, where: InRoom) -> SceneObject:
    """Return an object on a wall, the ceiling or the floor of a room, as it is made for; the state is not changed.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` with the reason where it finds no place.
    """
    if thing.mount in ("wall", "ceiling"):
        return hang(state, thing, where)
    if where.wish.binding:
        return place_as_wished(state, thing, where)
    return stand_on_floor(state, thing, where)


def place_in_container(state: SceneState, args: PlaceInContainerArgs, engine: PhysicsEngine) -> SceneObject:
    """Put a new object into a container, its door open while it is placed.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for an unknown asset or container, ``INFEASIBLE`` with the reason where it finds no place.
    """
    asset = state.catalogue.asset(args.asset_id)
    floor, container = object_named(state, args.container_id, "$.container_id")
    new = _new(state, asset, floor, container, args.color, args.name)
    placed = settle_on(state, new, AtReceptacle(floor, container, inside=True), engine)
    state.add(floor, placed)
    return placed


def _new(
    state: SceneState, asset: Asset, floor: int, place: SceneRoom | SceneObject, colour: str, name: str
) -> SceneObject:
    """Return a new object in the room that is, or that has, its place; where exactly is found later."""
    room = place.room if isinstance(place, SceneObject) else place.id
    new = scene_object(asset, state.new_id(floor, room, asset.category), room, (0.0, 0.0, 0.0), 0.0, name=name)
    return recoloured(new, colour)
