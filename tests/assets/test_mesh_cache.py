"""Meshes and collision pieces come from the user's cache as they came from the recipe."""

from pathlib import Path

import msgspec
import numpy as np
import pytest

from mansion_assets import mesh_cache, meshes, registry
from mansion_assets.builder import Builder
from mansion_assets.catalogue import Asset, load_catalogue
from mansion_assets.convex import Box, Convex
from mansion_assets.meshes import MeshPart, collision_pieces, mesh

CHAIR = load_catalogue([]).by_category("chair")[0]
PLANT = load_catalogue([]).by_category("house_plant")[0]


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Keep the user's own cache out of it."""
    monkeypatch.setenv(mesh_cache.VARIABLE, str(tmp_path / "meshes"))
    _forget()
    return tmp_path / "meshes"


def _forget() -> None:
    meshes._built.cache_clear()
    meshes._closed_pieces.cache_clear()


def _files(folder: Path) -> list[Path]:
    return sorted(file for file in folder.rglob("*") if file.is_file())


def _same_parts(first: list[MeshPart], second: list[MeshPart]) -> bool:
    return len(first) == len(second) and all(
        (a.name, a.material) == (b.name, b.material)
        and np.array_equal(a.vertices, b.vertices)
        and np.array_equal(a.faces, b.faces)
        and np.array_equal(a.coordinates, b.coordinates)
        for a, b in zip(first, second)
    )


def _numbers(pieces: tuple[Convex, ...]) -> list[object]:
    return [piece if isinstance(piece, Box) else (piece.vertices.tolist(), piece.faces.tolist()) for piece in pieces]


@pytest.mark.parametrize("asset", [CHAIR, PLANT])
def test_a_kept_mesh_is_the_one_that_the_recipe_makes(asset: Asset, folder: Path) -> None:
    made, pieces = mesh(asset), collision_pieces(asset)
    assert [file.suffix for file in _files(folder)] == [".mesh", ".pieces"]
    _forget()
    assert _same_parts(made, mesh(asset))
    assert _numbers(collision_pieces(asset)) == _numbers(pieces)
    assert meshes._built.cache_info().currsize == 0


def test_a_broken_file_is_made_again(folder: Path) -> None:
    made, pieces = mesh(CHAIR), collision_pieces(CHAIR)
    whole = [file.read_bytes() for file in _files(folder)]
    for file in _files(folder):
        file.write_bytes(b"\x91broken")
    _forget()
    assert _same_parts(made, mesh(CHAIR))
    assert _numbers(collision_pieces(CHAIR)) == _numbers(pieces)
    assert [file.read_bytes() for file in _files(folder)] == whole


def test_a_cache_that_cannot_be_written_is_no_fault(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv(mesh_cache.VARIABLE, str(tmp_path / "file"))
    assert mesh(CHAIR)
    assert collision_pieces(CHAIR)


def test_a_recipe_from_elsewhere_is_not_kept_since_its_code_may_change(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    registry.recipe_named("chair")
    monkeypatch.setattr(registry, "_RECIPES", dict(registry._RECIPES))

    @registry.recipe("own_chair")
    def own_chair(build: Builder) -> None:
        build.box((-0.2, 0.2), (-0.2, 0.2), (-0.4, 0.4), "main")

    own = _as_recipe(CHAIR, "own_chair")
    assert mesh(own)
    assert collision_pieces(own)
    assert _files(folder) == []


def test_what_determines_a_shape_names_its_file(folder: Path) -> None:
    mesh(CHAIR)
    mesh(PLANT)
    first = _files(folder)
    assert len({file.parent for file in first}) == 1
    assert len({file.name for file in first}) == 2
    mesh(CHAIR)
    assert _files(folder) == first


def _as_recipe(asset: Asset, recipe: str) -> Asset:
    return msgspec.structs.replace(asset, recipe=recipe, parameters={})
