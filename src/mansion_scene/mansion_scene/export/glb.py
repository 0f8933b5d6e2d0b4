"""Binary glTF of a floor and of a building."""

from collections.abc import Sequence

from mansion_msgs_py.scene import FloorScene
from mansion_scene.export.gltf import write_glb
from mansion_scene.export.meshes import building_models, floor_model

__all__ = ["building_glb", "floor_glb"]


def building_glb(scenes: Sequence[FloorScene], *, ceilings: bool = True) -> bytes:
    """Write all floors with stairs, shafts, doors, windows and objects as one binary glTF scene.

    Parameters
    ----------
    scenes : sequence of FloorScene
        In any order.
    ceilings : bool
        With ceilings and roof, as a robot sees it; without them, for a look from above.

    Returns
    -------
    bytes
        The ``.glb`` file, y up. Nodes carry our ids: ``building_id`` > ``floor_2`` > ``floor_2/objects`` >
        ``F2/meeting_room_1/office_chair_3``.
    """
    name = scenes[0].building_id if scenes else "building"
    return write_glb(building_models(scenes, ceilings=ceilings), name)


def floor_glb(scene: FloorScene, *, ceilings: bool = True) -> bytes:
    """Write one floor as binary glTF, its finished floor at its elevation; see `building_glb`."""
    return write_glb([floor_model(scene, ceilings=ceilings)], scene.building_id)
