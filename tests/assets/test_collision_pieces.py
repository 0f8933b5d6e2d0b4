"""Collision pieces are convex, few, within the asset, and where its mesh is."""

import numpy as np
import pytest

from mansion_assets.catalogue import Asset, load_catalogue
from mansion_assets.convex import Box, Convex, Hull, bounding_box, volume_of
from mansion_assets.mass_properties import mass_properties
from mansion_assets.meshes import collision_pieces, free_room, mesh
from mansion_assets.piece_budget import budget_of, simplified

CATALOGUE = load_catalogue()
ONE_OF_EACH = [CATALOGUE.by_category(name)[-1] for name in CATALOGUE.categories]

ROUNDER = 1.03
"""A hull of eight or twelve sides reaches this much beyond a mesh whose sides are no multiple of four."""


def bounds(piece: Convex) -> tuple[np.ndarray, np.ndarray]:
    if isinstance(piece, Hull):
        return piece.vertices.min(axis=0), piece.vertices.max(axis=0)
    return np.array(piece.center) - np.array(piece.size) / 2, np.array(piece.center) + np.array(piece.size) / 2


def depth(piece: Convex, points: np.ndarray) -> np.ndarray:
    """Return how far points lie outside the nearest face plane of a piece, negative within it."""
    if isinstance(piece, Box):
        return (np.abs(points - np.array(piece.center)) - np.array(piece.size) / 2).max(axis=1)
    a, b, c = (piece.vertices[piece.faces[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    lengths = np.linalg.norm(normals, axis=1)
    whole = lengths > 1e-12
    normals = normals[whole] / lengths[whole][:, None]
    return (points @ normals.T - np.einsum("ij,ij->i", a[whole], normals)).max(axis=1)


def is_free(asset: Asset, *points: tuple[float, float, float]) -> bool:
    return all((depth(piece, np.array(points)) > 0.0).all() for piece in collision_pieces(asset))


def test_every_asset_has_at_most_the_pieces_of_its_size_and_all_lie_within_its_box() -> None:
    for asset in ONE_OF_EACH:
        pieces = collision_pieces(asset)
        assert 1 <= len(pieces) <= budget_of(asset.size), asset.key
        half = np.array(asset.size) / 2 * ROUNDER + 1e-3
        for piece in pieces:
            low, high = bounds(piece)
            assert (low >= -half).all() and (high <= half).all(), (asset.key, piece)


def test_every_hull_is_convex_closed_and_has_a_volume() -> None:
    for asset in ONE_OF_EACH:
        for piece in collision_pieces(asset):
            if isinstance(piece, Hull):
                assert depth(piece, piece.vertices).max() < 2e-3, asset.key
                edges = np.sort(piece.faces[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
                _, counts = np.unique(edges, axis=0, return_counts=True)
                assert (counts == 2).all(), asset.key
            assert volume_of(piece) > 0.0, asset.key


def test_the_pieces_are_where_the_mesh_is() -> None:
    for asset in ONE_OF_EACH:
        points = np.concatenate([part.vertices for part in mesh(asset)])
        nearest = np.min([depth(piece, points) for piece in collision_pieces(asset)], axis=0)
        reach = 0.02 + 0.03 * max(asset.size)
        assert np.mean(nearest < reach) > 0.93, (asset.key, float(np.mean(nearest < reach)))


def test_one_reaches_under_a_table_into_a_shelf_and_below_a_bed() -> None:
    table, shelf, bed = (CATALOGUE.by_category(name)[-1] for name in ("dining_table", "bookshelf", "crib"))
    assert is_free(table, (0.0, 0.0, -0.1), (table.size[0] * 0.3, 0.0, -0.1))
    for surface in shelf.surfaces:
        assert is_free(shelf, (surface.x, surface.y, surface.z + 0.05))
    assert is_free(bed, (0.0, 0.0, -bed.size[2] / 2 + 0.05))


def test_room_for_objects_on_and_in_an_asset_is_not_taken_by_joining_pieces() -> None:
    boards = [Box((0.0, 0.0, z), (1.0, 0.4, 0.02)) for z in (*np.linspace(0.0, 0.35, 20), *np.linspace(0.65, 1.0, 20))]
    room = Box((0.0, 0.0, 0.5), (0.9, 0.4, 0.2))
    joined = simplified(boards, (1.0, 0.4, 1.0), [room])
    assert len(joined) <= budget_of((1.0, 0.4, 1.0))
    middle = np.array([[0.0, 0.0, 0.5]])
    free = [piece for piece in joined if depth(piece, middle)[0] < 0.0 and piece.size[2] > 0.05]
    assert free == []


@pytest.mark.parametrize("key", ["Fridge_1", "Microwave_1", "wardrobe_1", "Box_1", "filing_cabinet_1", "bin_1"])
def test_a_container_is_hollow(key: str) -> None:
    asset = CATALOGUE.asset(key)
    assert free_room(asset)
    for volume in asset.volumes:
        assert is_free(asset, (volume.x, volume.y, volume.z))


def test_a_physique_has_its_mass_where_the_pieces_are() -> None:
    low = bounding_box(np.array([-0.5, -0.5, 0.0]), np.array([0.5, 0.5, 0.1]))
    high = Box((0.0, 0.0, 0.95), (0.1, 0.1, 0.1))
    body = mass_properties([low, high], 10.0)
    assert body.mass == 10.0
    assert body.center[2] == pytest.approx((0.1 * 0.05 + 0.001 * 0.95) / 0.101)
    assert np.linalg.eigvalsh(body.inertia).min() > 0.0
