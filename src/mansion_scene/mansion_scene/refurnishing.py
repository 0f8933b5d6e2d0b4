"""A room of a finished floor furnished anew."""

from collections.abc import Sequence

from mansion_assets.catalogue import Catalogue
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.program import RequestedObject
from mansion_msgs_py.scene import Discard, FloorScene, SceneObject, SceneRoom

__all__ = ["furnish_room"]


def furnish_room(
    scene: FloorScene,
    room: SceneRoom,
    standing: Sequence[SceneObject],
    requested: Sequence[RequestedObject],
    seed: int,
    catalogue: Catalogue,
) -> tuple[list[SceneObject], list[Discard]]:
    """Return new objects for a room, and what could not be placed.

    Parameters
    ----------
    scene : FloorScene
        The floor, whose doors, windows and style count.
    room : SceneRoom
        The room as it is to be: its type says what it gets.
    standing : sequence of SceneObject
        What stays in it.
    requested : sequence of RequestedObject
        What it is to have, or with a count of 0 not to have, beside what its type usually has.
    seed : int
        Another one gives another choice and arrangement.
    """
    # The placement solver compiles its kernels when it is imported.
    with importing:
        from mansion_scene.room_contents import RoomFurnisher

    furnisher = RoomFurnisher(
        scene,
        seed=seed,
        style=scene.style,
        catalogue=catalogue,
        requested={room.id: list(requested)},
        building_type=scene.building_type,
        called=scene.called or "",
    )
    return furnisher.furnish(room, standing)
