"""Textures repeat without a seam, are the same on every run, and every material has a set."""

import io
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from mansion_assets.catalogue import load_catalogue
from mansion_assets.materials import material_set, set_names, set_of, texture_set, textures
from mansion_assets.meshes import mesh
from mansion_scene.structure.materials import library

PLAIN_FAMILIES = ("glass", "screen", "light")


@pytest.fixture(autouse=True)
def no_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Keep the user's cache out of it."""
    monkeypatch.setenv("MANSION_MATERIALS_CACHE", str(tmp_path))
    texture_set.cache_clear()
    return tmp_path


def _seam(field: np.ndarray, axis: int) -> tuple[float, float]:
    """Return the mean step over the tile's border and the largest mean step between neighbours within it."""
    lines = np.moveaxis(field, axis, 0)
    inner = np.abs(np.diff(lines, axis=0)).reshape(len(lines) - 1, -1).mean(axis=1)
    return float(np.abs(lines[0] - lines[-1]).mean()), float(inner.max())


@pytest.mark.parametrize("name", [name for name in set_names() if not material_set(name).fitted])
def test_a_tile_goes_on_over_its_borders_as_within(name: str) -> None:
    drawn = textures.draw(name)
    for field in (drawn.shade, drawn.height, drawn.roughness):
        for axis in (0, 1):
            border, within = _seam(field, axis)
            assert border <= 1.1 * within + 1e-9, (name, axis)


@pytest.mark.parametrize("name", set_names())
def test_a_set_has_its_size_in_texels_and_keeps_the_colour_that_it_is_given(name: str) -> None:
    chosen, made = material_set(name), texture_set(name)
    base = np.asarray(Image.open(io.BytesIO(made.base)).convert("RGB"))
    assert base.shape == (chosen.pixels[1], chosen.pixels[0], 3)
    assert all(64 <= density <= 2100 for density in chosen.density)
    if not made.own_colours:
        shown = base.reshape(-1, 3).mean(axis=0) / 255.0 * made.tint((0.5, 0.35, 0.2))
        assert np.abs(shown - (0.5, 0.35, 0.2)).max() < 0.02


def test_the_same_set_is_the_same_bytes_from_the_procedure_and_from_the_cache(no_cache: Path) -> None:
    first = texture_set("herringbone_floor")
    assert len(list(no_cache.iterdir())) == 1
    texture_set.cache_clear()
    again = texture_set("herringbone_floor")
    for file in no_cache.iterdir():
        file.write_bytes(b"broken")
    texture_set.cache_clear()
    assert first == again == texture_set("herringbone_floor")


def test_a_cache_that_cannot_be_written_is_no_fault(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("MANSION_MATERIALS_CACHE", str(tmp_path / "file"))
    assert texture_set("plaster").base


def test_every_material_of_rooms_and_of_assets_has_a_set_or_is_plain_by_intent() -> None:
    names = set(library())
    catalogue = load_catalogue([])
    for category in catalogue.categories:
        names |= {part.material.name for part in mesh(catalogue.by_category(category)[-1])}
    bare = {name for name in names if not set_of(name)}
    assert {name for name in bare if name.partition("_")[0] not in PLAIN_FAMILIES} <= {"button_light"}
    assert {set_of(name) for name in names} <= {"", *set_names()}
