"""Pieces of triangles cover them, leave free what is free, and keep the budget."""

import numpy as np
import trimesh

from mansion_assets.convex import Box
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
