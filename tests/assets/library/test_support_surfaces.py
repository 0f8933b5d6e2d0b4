"""Level faces with room above them carry things."""

import numpy as np
import pytest
import trimesh

from mansion_assets.library.support_surfaces import level_surfaces


def corners(*boxes: tuple[tuple[float, float, float], tuple[float, float, float]]) -> np.ndarray:
    found = []
    for size, center in boxes:
        mesh = trimesh.creation.box(size)
        mesh.apply_translation(center)
        found.append(mesh.vertices[mesh.faces])
    return np.concatenate(found)


def test_shelves_are_found_with_the_room_above_them() -> None:
    boards = [((0.8, 0.3, 0.02), (0.0, 0.0, z)) for z in (-0.5, 0.0, 0.5)]
    top, middle, low = level_surfaces(corners(*boards, ((0.8, 0.01, 1.02), (0.0, -0.145, 0.0))))
    assert [surface.kind for surface in (top, middle, low)] == ["top", "shelf", "shelf"]
    assert [surface.z for surface in (top, middle, low)] == pytest.approx([0.51, 0.01, -0.49], abs=1e-3)
    assert middle.clearance == pytest.approx(0.48, abs=0.02)
    assert middle.w == pytest.approx(0.78, abs=0.04)


def test_a_sloping_face_carries_nothing() -> None:
    mesh = trimesh.creation.box((0.8, 0.8, 0.05))
    mesh.apply_transform(trimesh.transformations.rotation_matrix(0.5, (1, 0, 0)))
    assert level_surfaces(mesh.vertices[mesh.faces]) == []
