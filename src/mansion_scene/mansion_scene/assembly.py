"""The scene of one floor, assembled from its layout (Algorithm 1, lines 9 to 17)."""

from collections.abc import Callable
from typing import TYPE_CHECKING

import msgspec

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.outside import GroundArea
from mansion_msgs_py.program import GROUND_FLOOR
from mansion_msgs_py.scene import Discard, FloorScene, Light, SceneObject
from mansion_msgs_py.stages import FurnishRequest
from mansion_scene.lighting import choose_sky, room_lights, sun
from mansion_scene.spawn import place_spawn
from mansion_scene.structure import FloorStructure, build_structure
from mansion_scene.structure.grounds import ground_areas
from mansion_scene.structure.regions import ring_points

if TYPE_CHECKING:
    from mansion_assets.catalogue import Catalogue
    from mansion_scene.llm_furniture import ModelChooser

__all__ = ["ProgressReport", "furnish_floor"]

ProgressReport = Callable[[str, float], None]
"""Receives a description of the current step and the share of the floor that is done, 0 to 1."""


def furnish_floor(
    request: FurnishRequest, *, progress: ProgressReport | None = None, catalogue: "Catalogue | None" = None
) -> FloorScene:
    """Make the scene of one floor: structure, openings, objects, light, sky and the robot's start.

    Parameters
    ----------
    request : FurnishRequest
    progress : callable, optional
        Called with a description and the share done, before each room and at the end.
    catalogue : Catalogue, optional
        Catalogue with assets and room types of the user's own; by default the package's with what the libraries of
        the request have.

    Returns
    -------
    FloorScene
        The same bytes for the same request.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for a layout that is not a partition of its floor, ``INFEASIBLE`` where a room cannot be
        reached, a stair does not fit its core, or no free position is left for the robot; `details` names the stage.
    """
    report = progress or (lambda what, share: None)
    if catalogue is None and request.libraries:
        with importing:
            from mansion_assets.catalogue import load_catalogue
            from mansion_assets.library.folders import library_folders

        catalogue = load_catalogue(preferred=library_folders(request.libraries))
    try:
        report("walls and openings", 0.0)
        structure = build_structure(request)
        chooser = _chooser(request, catalogue)
        objects, discarded = _contents(request, structure, report, catalogue, chooser)
        scene = _scene(request, structure, objects, discarded)
        if chooser is not None:
            scene = msgspec.structs.replace(scene, sources=chooser.sources, llm=chooser.usage)
    except MansionError as error:
        raise error.at_stage("furnish_floor") from error
    report("furnished", 1.0)
    return scene


def _chooser(request: FurnishRequest, catalogue: "Catalogue | None") -> "ModelChooser | None":
    if request.planner != "llm":
        return None
    with importing:
        from mansion_scene.llm_furniture import ModelChooser

    return ModelChooser.of_request(request, catalogue)


def _contents(
    request: FurnishRequest,
    structure: FloorStructure,
    report: ProgressReport,
    catalogue: "Catalogue | None",
    chooser: "ModelChooser | None",
) -> tuple[list[SceneObject], list[Discard]]:
    # The placement solver compiles its kernels when it is imported.
    with importing:
        from mansion_scene.room_contents import RoomFurnisher

    furnisher = RoomFurnisher(
        structure,
        seed=request.seed,
        style=request.style,
        catalogue=catalogue,
        chooser=chooser,
        requested={f"F{request.floor.index}/{room.id}": room.objects for room in request.floor.rooms},
        building_type=request.building_type,
        called=request.called or "",
        clutter={
            f"F{request.floor.index}/{room.id}": room.clutter
            for room in request.floor.rooms
            if room.clutter is not msgspec.UNSET
        },
    )
    objects: list[SceneObject] = []
    discarded: list[Discard] = []
    for index, room in enumerate(structure.rooms):
        report(room.id, 0.1 + 0.85 * index / len(structure.rooms))
        placed, left = furnisher.furnish(room)
        objects.extend(placed)
        discarded.extend(left)
    return objects, discarded


def _grounds(request: FurnishRequest, structure: FloorStructure) -> list[GroundArea] | msgspec.UnsetType:
    """Return the parts of the plot that the brief asks for; not set on other floors, and where it asks for none."""
    outside = request.outside
    if isinstance(outside, msgspec.UnsetType) or request.floor.index != GROUND_FLOOR:
        return msgspec.UNSET
    areas = ground_areas(outside.grounds, structure.floor.outline, structure.doors, request.building_type)
    return areas or msgspec.UNSET


def _scene(
    request: FurnishRequest, structure: FloorStructure, objects: list[SceneObject], discarded: list[Discard]
) -> FloorScene:
    program, floor = request.floor, structure.floor
    hub = next(room for room in structure.rooms if room.id == floor.hub.id)
    sky = choose_sky(request.seed)
    center = floor.outline.centroid
    lights: list[Light] = [sun(sky, floor.floor, (center.x, center.y))]
    for room in structure.rooms:
        lights.extend(room_lights(room, objects))
    scene = FloorScene(
        building_id=request.building_id,
        floor=program.index,
        floors=len(request.floors),
        label=program.label or str(program.index),
        elevation=program.elevation,
        height=program.height,
        outline=ring_points(floor.outline.exterior),
        holes=[ring_points(hole) for hole in floor.outline.interiors],
        rooms=structure.rooms,
        walls=structure.walls,
        doors=structure.doors,
        windows=structure.windows,
        cores=structure.cores,
        objects=objects,
        lights=lights,
        sky=sky,
        spawn=place_spawn(hub, structure.doors, objects),
        structural_walls=list(program.structural_walls),
        discarded=discarded,
        downgrades=structure.downgrades,
        building_type=request.building_type,
        called=request.called,
        style=request.style,
        outside=request.outside,
        grounds=_grounds(request, structure),
        seed=request.seed,
    )
    _require_unique_ids(scene)
    return scene


def _require_unique_ids(scene: FloorScene) -> None:
    seen: set[str] = set()
    for group in (scene.rooms, scene.walls, scene.doors, scene.windows, scene.cores, scene.objects, scene.lights):
        for item in group:
            if item.id in seen:
                raise MansionError(ErrorCode.INTERNAL, f"the id {item.id} occurs twice in the scene")
            seen.add(item.id)
