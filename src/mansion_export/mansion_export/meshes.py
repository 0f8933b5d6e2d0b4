"""A floor, and a building, as models."""

from collections.abc import Sequence

from mansion_assets.catalogue import Catalogue
from mansion_export.core_meshes import add_cores
from mansion_export.model import Model
from mansion_export.object_meshes import add_objects
from mansion_export.opening_meshes import add_doors, add_windows
from mansion_export.structure_meshes import add_ceilings, add_floors, add_roof, add_walls
from mansion_export.titles import floor_name
from mansion_msgs_py.scene import FloorScene

__all__ = ["building_models", "floor_model"]


def floor_model(
    scene: FloorScene,
    *,
    ceilings: bool = True,
    cabins: frozenset[str] | None = None,
    catalogue: Catalogue | None = None,
) -> Model:
    """Make the model of a floor: structure, openings, cores and objects.

    Parameters
    ----------
    scene : FloorScene
    ceilings : bool
        Leave them out, and what hangs from them, for a view from above.
    cabins : frozenset of str, optional
        Ids of the lifts whose cabin stands here; all when it is left out.
    catalogue : Catalogue, optional
        Where the assets are, when they are not all in the shipped one.
    """
    model = Model(f"floor_{scene.floor}", scene.floor, scene.elevation, title=floor_name(scene).capitalize())
    add_floors(model, scene)
    add_walls(model, scene)
    if ceilings:
        add_ceilings(model, scene)
    add_doors(model, scene)
    add_windows(model, scene)
    add_cores(model, scene, cabins)
    add_objects(model, scene, catalogue, ceilings=ceilings)
    return model


def building_models(
    scenes: Sequence[FloorScene], *, ceilings: bool = True, catalogue: Catalogue | None = None
) -> list[Model]:
    """Make the models of all floors, lowest first; lifts wait on the lowest floor that is above ground."""
    ordered = sorted(scenes, key=lambda scene: scene.floor)
    ground = next((s.floor for s in ordered if s.floor >= 1), ordered[-1].floor if ordered else 1)
    models = []
    for scene in ordered:
        here = frozenset(core.id for core in scene.cores) if scene.floor == ground else frozenset()
        model = floor_model(scene, ceilings=ceilings, cabins=here, catalogue=catalogue)
        if ceilings and scene is ordered[-1]:
            add_roof(model, scene)
        models.append(model)
    return models
