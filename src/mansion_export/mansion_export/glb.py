"""Binary glTF of a floor and of a building."""

from collections.abc import Sequence

from mansion_assets.catalogue import Catalogue
from mansion_export.cutaway import quarter_turns
from mansion_export.gltf import write_glb
from mansion_export.meshes import building_models, floor_model
from mansion_export.model import Model
from mansion_export.titles import building_title, floor_title
from mansion_msgs_py.scene import FloorScene

__all__ = ["building_glb", "floor_glb"]


def building_glb(
    scenes: Sequence[FloorScene],
    *,
    ceilings: bool = True,
    catalogue: Catalogue | None = None,
    models: Sequence[Model] | None = None,
) -> bytes:
    """Write all floors with stairs, shafts, doors, windows and objects as one binary glTF scene.

    Parameters
    ----------
    scenes : sequence of FloorScene
        In any order.
    ceilings : bool
        With ceilings and roof, as a robot sees it; without them, for a look from above.
    catalogue : Catalogue, optional
        Where the assets are, when they are not all in the shipped one.
    models : sequence of Model, optional
        Of these floors, lowest first, where `building_models` has made them already.

    Returns
    -------
    bytes
        The ``.glb`` file, y up. Nodes carry our ids: ``building_id`` > ``floor_2`` > ``floor_2/objects`` >
        ``F2/meeting_room_1/office_chair_3``.
    """
    name = scenes[0].building_id if scenes else "building"
    if models is None:
        models = building_models(scenes, ceilings=ceilings, catalogue=catalogue)
    return write_glb(models, name, building_title(scenes), quarter_turns(scenes))


def floor_glb(scene: FloorScene, *, ceilings: bool = True, catalogue: Catalogue | None = None) -> bytes:
    """Write one floor as binary glTF, its finished floor at its elevation; see `building_glb`."""
    return write_glb(
        [floor_model(scene, ceilings=ceilings, catalogue=catalogue)], scene.building_id, floor_title(scene)
    )
