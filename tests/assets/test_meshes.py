"""Meshes fit their boxes, carry what the catalogue says, and have collision boxes."""

from pathlib import Path

import numpy as np
import pytest

from mansion_assets.catalogue import Asset, load_catalogue
from mansion_assets.materials import material_set, set_of
from mansion_assets.meshes import collision_boxes, mesh
from mansion_assets.registry import recipe_names
from mansion_msgs_py.errors import MansionError

CATALOGUE = load_catalogue()
ONE_OF_EACH = [CATALOGUE.by_category(name)[-1] for name in CATALOGUE.categories]


def _vertices(asset: Asset) -> np.ndarray:
    return np.concatenate([part.vertices for part in mesh(asset)])


def test_every_recipe_that_a_category_names_exists() -> None:
    assert {asset.recipe for asset in CATALOGUE.assets.values()} <= set(recipe_names())


def test_every_category_has_a_mesh_that_fits_its_box_within_a_millimetre() -> None:
    for asset in ONE_OF_EACH:
        points = _vertices(asset)
        assert np.isfinite(points).all(), asset.key
        size = np.array(asset.size)
        assert np.abs(points.max(axis=0) - size / 2).max() < 1e-3, asset.key
        assert np.abs(points.min(axis=0) + size / 2).max() < 1e-3, asset.key


def test_meshes_have_named_parts_known_materials_and_moderate_counts() -> None:
    for asset in ONE_OF_EACH:
        parts = mesh(asset)
        assert sum(len(part.faces) for part in parts) <= 6000, asset.key
        assert all(part.name and part.material.name for part in parts)
        assert len({(part.name, part.material.name) for part in parts}) == len(parts)


def test_collision_boxes_stay_within_the_asset() -> None:
    for asset in ONE_OF_EACH:
        boxes = collision_boxes(asset)
        assert 1 <= len(boxes) <= 24, asset.key
        half = np.array(asset.size) / 2
        for box in boxes:
            reach = np.abs(np.array(box.center)) + np.array(box.size) / 2
            assert (reach <= half * 1.1 + 0.03).all(), (asset.key, box)


def test_a_surface_is_where_the_mesh_has_an_upward_face() -> None:
    missing = []
    for asset in ONE_OF_EACH:
        triangles = np.concatenate([p.vertices[p.faces] for p in mesh(asset)])
        for surface in asset.surfaces:
            near = np.abs(triangles[..., 2] - surface.z).max(axis=1) < 0.035
            low, high = triangles[near].min(axis=1), triangles[near].max(axis=1)
            inside = (
                (low[:, 0] < surface.x + surface.w / 4)
                & (high[:, 0] > surface.x - surface.w / 4)
                & (low[:, 1] < surface.y + surface.d / 4)
                & (high[:, 1] > surface.y - surface.d / 4)
            )
            if not inside.any():
                missing.append((asset.key, surface.kind, surface.z))
    assert missing == []


def test_a_container_leaves_its_inner_volume_free_of_solids() -> None:
    for key in ("Fridge_1", "Microwave_1", "wardrobe_1", "Box_1", "filing_cabinet_1"):
        asset = CATALOGUE.asset(key)
        for volume in asset.volumes:
            middle = np.array([volume.x, volume.y, volume.z])
            for box in collision_boxes(asset):
                apart = np.abs(middle - np.array(box.center)) > np.array(box.size) / 2 - 1e-6
                assert apart.any(), (key, box)


def test_the_same_asset_gives_the_same_mesh() -> None:
    first, second = (_vertices(CATALOGUE.asset("office_chair_1")) for _ in range(2))
    assert (first == second).all()


def test_a_users_glb_is_turned_and_fitted(tmp_path: Path) -> None:
    import trimesh

    path = tmp_path / "post.glb"
    solid = trimesh.creation.box((1.0, 4.0, 2.0))
    solid.apply_translation((0.0, 2.0, 5.0))
    trimesh.Scene(solid).export(path)
    asset = Asset(key="post", category="post", name="post", size=(0.5, 1.0, 2.0), glb=str(path))
    points = _vertices(asset)
    assert np.abs(points.max(axis=0) - [0.25, 0.5, 1.0]).max() < 1e-6


def test_an_unknown_recipe_is_an_error() -> None:
    asset = Asset(key="x", category="x", name="x", size=(1.0, 1.0, 1.0), recipe="nothing")
    with pytest.raises(MansionError, match="nothing"):
        mesh(asset)


def test_textures_lie_on_every_recipe_in_true_size_but_for_the_slant_of_round_faces() -> None:
    for asset in ONE_OF_EACH:
        for part in mesh(asset):
            corners = part.vertices[part.faces]
            sides = corners[:, 1:] - corners[:, :1]
            laid = part.coordinates[:, 1:] - part.coordinates[:, :1]
            area = np.linalg.norm(np.cross(sides[:, 0], sides[:, 1]), axis=1)
            flat = laid[:, 0, 0] * laid[:, 1, 1] - laid[:, 0, 1] * laid[:, 1, 0]
            seen = area > 1e-9
            assert part.coordinates.shape == (len(part.faces), 3, 2)
            name = set_of(part.material.name)
            if name and material_set(name).fitted:
                assert part.coordinates.min() == 0.0 and part.coordinates.max() == 1.0
                continue
            # A face turned by as much as (1, 1, 1) from the nearest axis keeps 0.577 of its area; none is mirrored.
            share = flat[seen] / area[seen]
            assert ((share > 0.57) & (share < 1.001)).all(), (asset.key, part.name)
            lengths = np.linalg.norm(laid, axis=-1), np.linalg.norm(sides, axis=-1)
            assert (lengths[0] <= lengths[1] + 1e-9).all(), (asset.key, part.name)


def test_the_grain_of_wood_runs_along_a_leg_and_along_a_table_top() -> None:
    part = next(p for p in mesh(CATALOGUE.asset("console_table_4")) if "legs" in p.name)
    upright = np.abs(np.ptp(part.vertices[part.faces][..., 2], axis=1)) > 0.1
    along = np.ptp(part.coordinates[upright][..., 0], axis=1)
    across = np.ptp(part.coordinates[upright][..., 1], axis=1)
    assert (along > across).all()
