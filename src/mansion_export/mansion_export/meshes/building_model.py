"""A floor and a building as models: slabs, walls, ceilings, roof, openings, cores and objects."""

import zlib
from collections.abc import Iterator, Sequence
from functools import lru_cache

from shapely.geometry import Polygon

from mansion_assets.catalogue import Asset, Catalogue, load_catalogue
from mansion_assets.materials import art
from mansion_export.exterior import (
    chimney_parts,
    entrance_parts,
    feature_parts,
    plot_parts,
    roof_parts,
    sign_parts,
    trim_parts,
)
from mansion_export.meshes.asset_surfaces import asset_surfaces
from mansion_export.meshes.core_meshes import core_parts
from mansion_export.meshes.materials import hex_color, named, surface_material
from mansion_export.meshes.model import Material, Model, Node, Part, Surface, assemble, named_by_content
from mansion_export.meshes.opening_meshes import door_parts, window_parts
from mansion_export.meshes.solids import Box, boxes_surface, polygon_surface
from mansion_export.meshes.walls import WallBodies, wall_surfaces
from mansion_export.presentation import floor_name, room_title
from mansion_msgs_py.scene import FloorScene, SceneObject, StairDetails
from mansion_msgs_py.shapes import Ring

__all__ = ["building_models", "floor_model", "object_parts", "slab_polygon"]

FINISH = 0.02
"""Thickness of the floor finish on the slab, metres."""


def floor_model(
    scene: FloorScene,
    *,
    ceilings: bool = True,
    cabins: frozenset[str] | None = None,
    outside: Sequence[Part] = (),
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
    outside : sequence of Part
        What the floor shows to the street besides.
    catalogue : Catalogue, optional
        Where the assets are, when they are not all in the shipped one.
    """
    parts = [
        *_room_floors(scene),
        *_slab(scene),
        *_walls(scene),
        *(_ceilings(scene) if ceilings else ()),
        *door_parts(scene),
        *window_parts(scene),
        *core_parts(scene, cabins),
        *object_parts(scene, catalogue, ceilings=ceilings),
        *outside,
    ]
    title = floor_name(scene).capitalize()
    return named_by_content(assemble(f"floor_{scene.floor}", scene.floor, scene.elevation, parts, title))


def building_models(
    scenes: Sequence[FloorScene],
    *,
    ceilings: bool = True,
    roofs: bool | None = None,
    site: bool = True,
    catalogue: Catalogue | None = None,
) -> list[Model]:
    """Make the models of all floors, lowest first; lifts wait on the lowest floor that is above ground.

    Parameters
    ----------
    ceilings : bool
        Leave them out, and what hangs from them, for a view from above.
    roofs : bool, optional
        With roofs and chimneys; as `ceilings` when it is left out.
    site : bool
        With the plot around the building, and what stands before its doors.
    """
    ordered = sorted(scenes, key=lambda scene: scene.floor)
    ground = next((s.floor for s in ordered if s.floor >= 1), ordered[-1].floor if ordered else 1)
    models = []
    for number, scene in enumerate(ordered):
        here = frozenset(core.id for core in scene.cores) if scene.floor == ground else frozenset()
        outside: list[Part] = []
        if ceilings if roofs is None else roofs:
            above = ordered[number + 1] if number + 1 < len(ordered) else None
            covered = None if above is None else slab_polygon(above, above=False, openings=False)
            roof = list(roof_parts(scene, slab_polygon(scene, above=True, openings=above is not None), covered))
            outside += [*roof, *chimney_parts(scene, ordered[: number + 1], roof, covered)]
        plan = slab_polygon(scene, above=False, openings=False)
        if site and scene.floor >= 1:
            outside += trim_parts(scene, plan)
        if site and scene.floor == 1:
            outside += [*plot_parts(scene, plan), *entrance_parts(scene)]
            outside += [*feature_parts(scene), *sign_parts(scene)]
        models.append(floor_model(scene, ceilings=ceilings, cabins=here, outside=outside, catalogue=catalogue))
    return models


def _room_floors(scene: FloorScene) -> Iterator[Part]:
    """Yield the finish of each room's floor, which carries the room's label."""
    for room in scene.rooms:
        polygon = Polygon(room.polygon, room.holes)
        finish = surface_material(room.floor_material, "floor")
        at = polygon.centroid if polygon.contains(polygon.centroid) else polygon.representative_point()
        node = Node(
            room.id,
            room.id,
            "structure",
            room=room.id,
            label=(room_title(room), f"{room.area:.1f} m²"),
            label_at=(round(at.x, 3), round(at.y, 3), 1.0),
        )
        yield node, [polygon_surface(polygon, -FINISH, 0.0, finish)]


def _slab(scene: FloorScene) -> Iterator[Part]:
    """Yield the slab below a floor, and the landings of its stairs."""
    concrete = named("polished_concrete")
    thickness = max(scene.height - max((wall.height for wall in scene.walls), default=2.8), 0.1)
    name = f"F{scene.floor}/slab"
    bottom = -max(thickness, FINISH + 0.05)
    yield Node(name, name, "structure"), _prisms(slab_polygon(scene, above=False), bottom, -FINISH, concrete)
    for core in scene.cores:
        landing = core.details.floor_landing if isinstance(core.details, StairDetails) else []
        if len(landing) >= 3:
            name = f"{core.id}/landing"
            node = Node(name, f"F{scene.floor}/{name}", "structure", room=core.id)
            yield node, [polygon_surface(Polygon(landing), -FINISH, 0.0, concrete)]


def slab_polygon(scene: FloorScene, *, above: bool, openings: bool = True) -> Polygon:
    """Return the slab below or above a floor: the outer face of its walls, less the openings of its cores."""
    outer = max((wall.thickness for wall in scene.walls if wall.exterior), default=0.0)
    outline = Polygon(scene.outline, scene.holes)
    slab = outline.buffer(outer, join_style="mitre", mitre_limit=2.5)
    for core in scene.cores if openings else ():
        opening: Ring = []
        if core.details is not None:
            opening = core.details.ceiling_opening if above else core.details.floor_opening
        if len(opening) >= 3:
            slab = slab.difference(Polygon(opening))
    return slab


def _prisms(shape: Polygon, bottom: float, top: float, material: Material) -> list[Surface]:
    polygons = [shape] if shape.geom_type == "Polygon" else list(shape.geoms)
    return [
        polygon_surface(polygon, bottom, top, material)
        for polygon in polygons
        if polygon.geom_type == "Polygon" and polygon.area > 1e-4
    ]


def _walls(scene: FloorScene) -> Iterator[Part]:
    """Yield each wall, cut at its openings, each face in the material of its room."""
    bodies = WallBodies(scene)
    for wall in scene.walls:
        yield Node(wall.id, wall.id, "structure"), wall_surfaces(wall, bodies)


def _ceilings(scene: FloorScene) -> Iterator[Part]:
    """Yield the ceiling of each room, as a thin board below the slab."""
    for room in scene.rooms:
        if room.kind in ("stair", "elevator"):
            continue
        name = f"{room.id}/ceiling"
        top = room.ceiling_height
        board = polygon_surface(
            Polygon(room.net_polygon, room.net_holes),
            top - 0.02,
            top - 0.005,
            surface_material(room.ceiling_material, "ceiling"),
        )
        yield Node(name, name, "ceiling", room=room.id), [board]


def object_parts(scene: FloorScene, catalogue: Catalogue | None = None, *, ceilings: bool = True) -> Iterator[Part]:
    """Yield each object of a floor where it stands; objects of one asset and colour share a mesh.

    An object in another colour than its asset's shows that colour in the asset's main material; one whose asset the
    catalogue does not know, say a user's on another machine, is a box of its size.

    Parameters
    ----------
    scene : FloorScene
    catalogue : Catalogue, optional
        The shipped one when it is left out.
    ceilings : bool
        Leave out what hangs from ceilings.
    """
    known = catalogue or load_catalogue()
    for item in scene.objects:
        if item.mount == "ceiling" and not ceilings:
            continue
        asset = known.assets.get(item.asset)
        if asset is None:
            yield _object_node(item, f"box:{item.color}", (1.0, 1.0, 1.0)), _unit_box(item.color)
        else:
            color = "" if item.color in ("", asset.color) else item.color
            picture = _picture_of(item, asset)
            name = ":".join(filter(None, ("asset", asset.key, color, picture)))
            yield _object_node(item, name, asset.size), asset_surfaces(asset.key, known, color, picture)


def _picture_of(item: SceneObject, asset: Asset) -> str:
    """Return the material of what a painting shows, one of its own for each; empty for other objects."""
    if asset.parameters.get("face") != "art":
        return ""
    return art()[zlib.crc32(item.id.encode()) % len(art())]


def _object_node(item: SceneObject, mesh: str, size: tuple[float, float, float]) -> Node:
    w, d, h = (1.0 if abs(mine - its) < 1e-4 else mine / its for mine, its in zip(item.size, size))
    # What hangs from a ceiling goes when ceilings are hidden.
    group = "ceiling" if item.mount == "ceiling" else "objects"
    return Node(item.id, mesh, group, item.position, item.rotation, (w, d, h), item.room)


@lru_cache(maxsize=256)
def _unit_box(color: str) -> tuple[Surface, ...]:
    material = Material(f"color_{color.lstrip('#') or 'plain'}", hex_color(color))
    return (boxes_surface([Box((0.0, 0.0, 0.0), (1.0, 1.0, 1.0))], material),)
