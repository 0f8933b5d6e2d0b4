"""Doors and lids are whole pieces at the front or the top; nothing else moves."""

import numpy as np
import pytest

from mansion_assets.catalogue import load_catalogue
from mansion_export.meshes.asset_surfaces import asset_surfaces
from mansion_export.simulator_files import write_stl
from mansion_msgs_py.scene import SceneObject
from mansion_skills.vision.articulation import hinges_of, part_of, read_stl


def openable(asset: str, category: str) -> SceneObject:
    known = load_catalogue().asset(asset)
    return SceneObject(
        id="F1/room/it_1",
        room="F1/room",
        category=category,
        asset=asset,
        position=(0.0, 0.0, 0.0),
        rotation=0.0,
        size=known.size,
        openable=True,
    )


def triangles_of(asset: str) -> np.ndarray:
    parts = asset_surfaces(asset, load_catalogue(), "")
    return np.concatenate([part.vertices[part.faces] for part in parts])


@pytest.mark.parametrize(
    ("asset", "category", "moving"), [("Fridge_28", "fridge", {0}), ("storage_cabinet_2", "storage_cabinet", {0, 1})]
)
def test_the_doors_of_furniture_lie_at_its_front(asset: str, category: str, moving: set[int]) -> None:
    kind, triangles = openable(asset, category), triangles_of(asset)
    part = part_of(triangles, kind)
    assert set(part.tolist()) == {-1, *moving}
    doors = triangles[part >= 0]
    assert doors[..., 1].min() > kind.size[1] / 2 - 0.13
    assert np.ptp(doors[..., 2]) > 0.6 * kind.size[2]
    assert np.ptp(triangles[part < 0][..., 1]) > 0.7 * kind.size[1]


def test_a_leaf_swings_out_of_the_furniture() -> None:
    kind = openable("storage_cabinet_2", "storage_cabinet")
    for hinge in hinges_of(kind):
        across = -hinge.pivot[0]
        turn = np.radians(hinge.angle)
        assert across * np.sin(turn) > 0, "the free edge moves to the front"


def test_what_opens_nowhere_has_no_parts() -> None:
    kind, triangles = openable("Book_13", "book"), triangles_of("Book_13")
    assert hinges_of(kind) == ()
    assert (part_of(triangles, kind) == -1).all()
    assert part_of(np.zeros((0, 3, 3)), kind).size == 0


def test_meshes_are_read_as_they_were_written() -> None:
    surface = asset_surfaces("Fridge_28", load_catalogue(), "")[0]
    read = read_stl(write_stl(surface))
    assert np.allclose(read, surface.vertices[surface.faces], atol=1e-5)
