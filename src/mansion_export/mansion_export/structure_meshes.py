"""Walls, floors, slabs and ceilings of a floor as nodes of a model."""

from shapely.geometry import Polygon

from mansion_export.appearance import named, surface_material
from mansion_export.model import Material, Model, Node, Surface
from mansion_export.plan.labels import room_title
from mansion_export.solids import WallBodies
from mansion_export.solids3d import polygon_surface
from mansion_export.wall_meshes import wall_surfaces
from mansion_msgs_py.scene import FloorScene, StairDetails
from mansion_msgs_py.shapes import Ring
from mansion_scene.structure.materials import facade_of

__all__ = ["add_ceilings", "add_floors", "add_roof", "add_walls", "slab_polygon"]

FINISH = 0.02
"""Thickness of the floor finish on the slab, metres."""


def add_walls(model: Model, scene: FloorScene) -> None:
    """Add each wall, cut at its openings, each face in the material of its room."""
    bodies = WallBodies(scene)
    for wall in scene.walls:
        model.add(Node(wall.id, wall.id, "structure"), wall_surfaces(wall, bodies))


def add_floors(model: Model, scene: FloorScene) -> None:
    """Add the finish of each room and the slab below, with the holes of stairs and lifts."""
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
        model.add(node, [polygon_surface(polygon, -FINISH, 0.0, finish)])
    slab = slab_polygon(scene, above=False)
    thickness = max(scene.height - max((wall.height for wall in scene.walls), default=2.8), 0.1)
    name = f"F{scene.floor}/slab"
    model.add(
        Node(name, name, "structure"), _parts(slab, -max(thickness, FINISH + 0.05), -FINISH, named("polished_concrete"))
    )
    for core in scene.cores:
        landing = core.details.floor_landing if isinstance(core.details, StairDetails) else []
        if len(landing) >= 3:
            name = f"{core.id}/landing"
            model.add(
                Node(name, f"F{scene.floor}/{name}", "structure", room=core.id),
                [polygon_surface(Polygon(landing), -FINISH, 0.0, named("polished_concrete"))],
            )


def slab_polygon(scene: FloorScene, *, above: bool) -> Polygon:
    """Return the slab below or above a floor: the outer face of its walls less the holes of its cores."""
    outer = max((wall.thickness for wall in scene.walls if wall.exterior), default=0.0)
    outline = Polygon(scene.outline, scene.holes)
    slab = outline.buffer(outer, join_style="mitre", mitre_limit=2.5)
    for core in scene.cores:
        opening: Ring = []
        if core.details is not None:
            opening = core.details.ceiling_opening if above else core.details.floor_opening
        if len(opening) >= 3:
            slab = slab.difference(Polygon(opening))
    return slab


def _parts(shape: Polygon, bottom: float, top: float, material: Material) -> list[Surface]:
    polygons = [shape] if shape.geom_type == "Polygon" else list(shape.geoms)
    return [
        polygon_surface(polygon, bottom, top, material)
        for polygon in polygons
        if polygon.geom_type == "Polygon" and polygon.area > 1e-4
    ]


def add_ceilings(model: Model, scene: FloorScene) -> None:
    """Add the ceiling of each room, as a thin board below the slab."""
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
        model.add(Node(name, name, "ceiling", room=room.id), [board])


def add_roof(model: Model, scene: FloorScene) -> None:
    """Add the flat roof above the top floor, with a low parapet."""
    top = max((wall.height for wall in scene.walls), default=2.8)
    slab = slab_polygon(scene, above=True)
    ring = slab.difference(slab.buffer(-0.2, join_style="mitre"))
    name = f"F{scene.floor}/roof"
    model.add(
        Node(name, name, "ceiling"),
        [
            *_parts(slab, top, top + 0.25, named("polished_concrete")),
            *_parts(ring, top + 0.25, top + 0.6, surface_material(facade_of(scene), "wall")),
        ],
    )
