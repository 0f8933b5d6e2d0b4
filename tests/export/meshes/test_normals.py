"""Corner normals: flat faces stay flat, fine curves become smooth, equal corners are one."""

import numpy as np

from mansion_export.meshes.model import Material
from mansion_export.meshes.normals import corner_normals
from mansion_export.meshes.solids import Box, boxes_surface


def cylinder(sides: int) -> tuple[np.ndarray, np.ndarray]:
    angles = np.linspace(0, 2 * np.pi, sides, endpoint=False)
    ring = np.column_stack([np.cos(angles), np.sin(angles)])
    points = np.concatenate([np.column_stack([ring, np.zeros(sides)]), np.column_stack([ring, np.ones(sides)])])
    i = np.arange(sides)
    j = (i + 1) % sides
    faces = np.concatenate([np.column_stack([i, j, j + sides]), np.column_stack([i, j + sides, i + sides])])
    return points, faces


def test_a_box_keeps_flat_faces_with_24_corners():
    box = boxes_surface([Box((0, 0, 0), (1, 2, 3))], Material("m", (1, 1, 1)))
    points, normals, faces = corner_normals(box.vertices, box.faces)
    assert len(points) == 24
    assert np.allclose(np.abs(normals).max(axis=1), 1.0)
    assert faces.shape == (12, 3)


def test_a_round_side_is_smooth_and_a_hexagonal_one_is_not():
    points, normals, _ = corner_normals(*cylinder(24))
    assert len(points) == 48
    assert np.allclose(normals[:, :2], points[:, :2], atol=0.05)
    assert len(corner_normals(*cylinder(6))[0]) == 24


def test_faces_are_the_same_triangles_and_those_without_area_go():
    points, faces = cylinder(12)
    degenerate = np.concatenate([faces, [[0, 0, 1]]])
    out, _, joined = corner_normals(points, degenerate)
    assert np.allclose(out[joined], points[faces])
