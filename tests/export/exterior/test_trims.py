"""Trims lie on the outer faces of walls: a plinth at the ground, surrounds and railings at windows."""

import msgspec
import numpy as np
import pytest
from shapely.geometry import LineString, Point, Polygon

from mansion_export.exterior.trims import RAILING, trim_parts
from mansion_export.meshes.building_model import slab_polygon
from mansion_export.meshes.model import Surface
from mansion_knowledge import default_knowledge
from mansion_msgs_py.scene import FloorScene
from mansion_scene.structure.materials import library


def in_material(scene: FloorScene, facade: str) -> FloorScene:
    walls = [msgspec.structs.replace(wall, right_material=facade) if wall.exterior else wall for wall in scene.walls]
    return msgspec.structs.replace(scene, walls=walls)


def trims(scene: FloorScene) -> dict[str, Surface]:
    slab = slab_polygon(scene, above=False, openings=False)
    return {surface.material.name: surface for _, surfaces in trim_parts(scene, slab) for surface in surfaces}


def test_every_trim_is_of_a_material_of_the_library() -> None:
    listed = default_knowledge().groups.trims
    assert set(listed) <= set(library())
    assert {name for pair in listed.values() for name in pair if name} <= set(library())


def test_surrounds_and_plinth_lie_on_the_outer_faces(building: list[FloorScene]) -> None:
    ground = in_material(building[0], "red_brick")
    found = trims(ground)
    assert set(found) >= {"stone_cladding", "white_render"}
    slab = slab_polygon(ground, above=False, openings=False)
    for surface in found.values():
        assert all(slab.exterior.distance(Point(*vertex[:2])) < 0.06 for vertex in surface.vertices)
    assert np.ptp(found["stone_cladding"].vertices[:, 2]) == pytest.approx(0.52)


def test_the_plinth_is_open_at_doors_to_the_outside(building: list[FloorScene]) -> None:
    ground = in_material(building[0], "red_brick")
    ways = [LineString(door.segment) for door in ground.doors if None in door.rooms]
    assert ways
    plinth = trims(ground)["stone_cladding"]
    assert all(way.distance(Point(*vertex[:2])) > 0.3 for way in ways for vertex in plinth.vertices)


def test_glass_facades_have_none(building: list[FloorScene]) -> None:
    ground = in_material(msgspec.structs.replace(building[0], building_type="office"), "glass_panels")
    assert trims(ground) == {}


def test_a_low_window_upstairs_has_a_railing_before_it(building: list[FloorScene]) -> None:
    upper = in_material(building[1], "timber_cladding")
    assert "painted_steel" not in trims(upper)
    low = [msgspec.structs.replace(window, sill=0.2) for window in upper.windows]
    railing = trims(msgspec.structs.replace(upper, windows=low))["painted_steel"]
    assert railing.vertices[:, 2].max() == pytest.approx(RAILING, abs=0.03)
    slab = Polygon(slab_polygon(upper, above=False, openings=False).exterior)
    assert not any(slab.contains(Point(*vertex[:2])) for vertex in railing.vertices)
