"""Walls are closed meshes: renderers show no seam, and simulators no leak."""

from collections import Counter

import msgspec
import numpy as np
import pytest

from mansion_export.meshes.walls import WallBodies, wall_surfaces
from mansion_msgs_py.scene import Wall


def corners(surfaces):
    """All triangles of a wall, corner by corner, (n, 3, 3)."""
    return np.concatenate([each.vertices[each.faces] for each in surfaces])


def volume(triangles):
    return float(np.einsum("ij,ij->i", triangles[:, 0], np.cross(triangles[:, 1], triangles[:, 2])).sum()) / 6


def test_every_edge_of_a_wall_belongs_to_two_triangles_that_run_opposite_ways(ground):
    bodies = WallBodies(ground)
    for wall in ground.walls:
        triangles = np.round(corners(wall_surfaces(wall, bodies)), 6)
        edges = Counter((tuple(t[i]), tuple(t[(i + 1) % 3])) for t in triangles.tolist() for i in range(3))
        assert set(edges.values()) == {1}
        assert all((end, start) in edges for start, end in edges)


def test_a_wall_has_the_volume_of_its_boxes_so_that_its_faces_look_outwards(ground):
    bodies = WallBodies(ground)
    for wall in ground.walls:
        boxes = sum(float(np.prod(box.size)) for box in bodies.boxes(wall))
        (low, high), faces = bodies.stretch(wall), bodies.faces(wall)
        mitred = float((faces[1] - faces[0]).mean() - (high - low)) * wall.thickness * wall.height
        assert volume(corners(wall_surfaces(wall, bodies))) == pytest.approx(boxes + mitred, rel=1e-6)


def test_the_outer_and_the_inner_faces_of_two_walls_meet_where_they_make_a_corner(ground):
    outline = [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0], [0.0, 3.0]]
    walls = [
        Wall(id=f"F1/wall_{i}", segment=(tuple(start), tuple(end)), thickness=0.2, height=2.5, exterior=True)
        for i, (start, end) in enumerate(zip(outline, outline[1:] + outline[:1]))
    ]
    bodies = WallBodies(msgspec.structs.replace(ground, walls=walls, doors=[], windows=[]))
    inner, outer = (
        {tuple(spot) for wall in walls for spot in wall_surfaces(wall, bodies)[face].vertices.round(6)[:, :2].tolist()}
        for face in (0, 1)
    )
    assert inner == {(0.1, 0.1), (3.9, 0.1), (3.9, 2.9), (0.1, 2.9)}
    assert outer - inner == {(-0.1, -0.1), (4.1, -0.1), (4.1, 3.1), (-0.1, 3.1)}


def test_left_and_right_faces_carry_the_materials_of_their_rooms(ground):
    bodies = WallBodies(ground)
    wall = next(wall for wall in ground.walls if not wall.exterior and wall.left and wall.right)
    wall = msgspec.structs.replace(wall, left_material="blue_wall", right_material="white_wall")
    left, right, _ = wall_surfaces(wall, bodies)
    (ax, ay), (bx, by) = wall.segment
    to_left = np.array([-(by - ay), bx - ax]) / np.hypot(bx - ax, by - ay)
    beside = left.vertices[:, :2] @ to_left - np.array([ax, ay]) @ to_left
    assert beside == pytest.approx(np.full(len(beside), wall.thickness / 2))
    assert left.material != right.material
