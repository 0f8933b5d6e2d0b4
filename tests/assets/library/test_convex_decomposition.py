"""Pieces of triangles cover them, leave free what is free, and keep the budget."""

import numpy as np
import pytest
import trimesh

from mansion_assets.convex import Box, Hull, volume_of
from mansion_assets.library.convex_decomposition import boxes_of_cells, decomposed
from mansion_assets.piece_budget import budget_of


def table() -> trimesh.Trimesh:
    parts = [trimesh.creation.box((1.2, 0.7, 0.04))]
    parts[0].apply_translation((0, 0, 0.36))
    for x in (-0.55, 0.55):
        for y in (-0.3, 0.3):
            leg = trimesh.creation.box((0.05, 0.05, 0.72))
            leg.apply_translation((x, y, -0.02))
            parts.append(leg)
    return trimesh.util.concatenate(parts)


def test_boxes_hold_all_vertices() -> None:
    mesh = table()
    boxes = boxes_of_cells(mesh.vertices[mesh.faces])
    held = np.zeros(len(mesh.vertices), dtype=bool)
    for piece in boxes:
        assert isinstance(piece, Box)
        away = np.abs(mesh.vertices - np.array(piece.center)) - np.array(piece.size) / 2
        held |= (away < 1e-3).all(axis=1)
    assert held.all()


def test_what_is_below_a_table_stays_free_within_the_budget() -> None:
    mesh = table()
    pieces = decomposed(np.asarray(mesh.vertices), np.asarray(mesh.faces), (1.2, 0.7, 0.76), (), "cells")
    assert len(pieces) <= budget_of((1.2, 0.7, 0.76))
    for piece in pieces:
        assert isinstance(piece, Box)
        assert (np.abs(piece.center) > np.array(piece.size) / 2).any(), "a piece covers the middle below the top"


def test_convex_bodies_are_pieces_as_they_are() -> None:
    mesh = table()
    pieces = decomposed(np.asarray(mesh.vertices), np.asarray(mesh.faces), (1.2, 0.7, 0.76), (), "coacd")
    volumes = sorted(trimesh.Trimesh(piece.vertices, piece.faces).volume for piece in pieces if isinstance(piece, Hull))
    assert volumes == pytest.approx([0.05 * 0.05 * 0.72] * 4 + [1.2 * 0.7 * 0.04])


def test_more_bodies_than_the_budget_are_joined() -> None:
    balls = [trimesh.creation.icosphere(subdivisions=1, radius=0.02) for _ in range(60)]
    for number, ball in enumerate(balls):
        ball.apply_translation((0.05 * (number % 10), 0.05 * (number // 10), 0.0))
    mesh = trimesh.util.concatenate(balls)
    size = (0.49, 0.29, 0.04)
    pieces = decomposed(np.asarray(mesh.vertices), np.asarray(mesh.faces), size, (), "coacd")
    assert 1 <= len(pieces) <= budget_of(size)


def test_hulls_follow_a_curved_shape_and_stay_inside_its_extent() -> None:
    pytest.importorskip("coacd", reason="needs the extra convex")
    ring = trimesh.creation.annulus(0.3, 0.4, 0.5)
    pieces = decomposed(np.asarray(ring.vertices), np.asarray(ring.faces), (0.8, 0.8, 0.5), (), "coacd")
    assert 4 <= len(pieces) <= budget_of((0.8, 0.8, 0.5))
    hulls = [trimesh.Trimesh(piece.vertices, piece.faces) for piece in pieces if isinstance(piece, Hull)]
    assert sum(hull.volume for hull in hulls) == pytest.approx(ring.volume, rel=0.1)
    assert not any(hull.contains([[0.0, 0.0, 0.0]])[0] for hull in hulls if hull.is_watertight)
    points = np.concatenate([hull.vertices for hull in hulls])
    assert (points >= ring.bounds[0] - 1e-9).all()
    assert (points <= ring.bounds[1] + 1e-9).all()


def test_hulls_of_triangles_that_bound_no_solid_stay_inside_their_extent() -> None:
    pytest.importorskip("coacd", reason="needs the extra convex")
    mesh = table()
    sheet = mesh.submesh([range(8)], append=True)
    pieces = decomposed(np.asarray(sheet.vertices), np.asarray(sheet.faces), tuple(sheet.extents), (), "coacd")
    for piece in pieces:
        low, high = (
            (piece.vertices.min(axis=0), piece.vertices.max(axis=0))
            if isinstance(piece, Hull)
            else (np.array(piece.center) - np.array(piece.size) / 2, np.array(piece.center) + np.array(piece.size) / 2)
        )
        assert (low >= sheet.bounds[0] - 1e-3).all()
        assert (high <= sheet.bounds[1] + 1e-3).all()


@pytest.mark.parametrize("how", ["cells", "coacd"])
def test_a_flat_model_has_a_piece_with_a_volume(how: str) -> None:
    if how == "coacd":
        pytest.importorskip("coacd")
    corners = np.array([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]])
    pieces = decomposed(corners, np.array([[0, 1, 2], [0, 2, 3]]), (1.0, 1.0, 0.003), (), how)
    assert all(volume_of(piece) > 0.0 for piece in pieces)
