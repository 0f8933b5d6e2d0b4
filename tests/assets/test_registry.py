"""An asset of the package is one entry of the catalogue and at most one recipe, nothing else."""

import json
import shutil
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from mansion_assets import recipes, registry
from mansion_assets.catalogue import Catalogue, furnish_request, load_catalogue, loading
from mansion_assets.catalogue.search import search_assets
from mansion_assets.meshes import collision_boxes, mesh

RECIPE = """
from mansion_assets.builder import Builder
from mansion_assets.catalogue.receptacles import Receptacle, inset, surface
from mansion_assets.registry import receptacles, recipe


@receptacles("test_pedestal")
def _pedestal_top(size, parameters) -> list[Receptacle]:
    return [surface("top", inset(size, 0.02), size[2])]


@recipe("test_pedestal")
def pedestal(b: Builder) -> None:
    b.cyl(0, 0, (0, b.h), b.w / 2, b.mat())
"""
ENTRY = {
    "category": "drone_pedestal",
    "recipe": "test_pedestal",
    "synonyms": ["landing pad"],
    "sizes": [[0.6, 0.6, 0.9], [0.4, 0.4, 1.1]],
    "finishes": ["metal_steel"],
}
ROOM = {"room_type": "drone_room", "floor": [{"name": "pedestal", "category": "drone_pedestal", "count": 2}]}


@pytest.fixture
def extended(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Catalogue]:
    """Return a catalogue from a copy of the data with an entry more, and a folder with one recipe more."""
    data = tmp_path / "data"
    shutil.copytree(loading.DATA, data)
    (data / "categories" / "drones.json").write_text(json.dumps([ENTRY]), encoding="utf-8")
    (data / "rooms" / "drones.json").write_text(json.dumps([ROOM]), encoding="utf-8")
    (tmp_path / "recipes").mkdir()
    (tmp_path / "recipes" / "drones.py").write_text(RECIPE, encoding="utf-8")
    registry.recipe_names()
    monkeypatch.setattr(registry, "_RECIPES", dict(registry._RECIPES))
    monkeypatch.setattr(registry, "_RULES", dict(registry._RULES))
    monkeypatch.setattr(recipes, "__path__", [*recipes.__path__, str(tmp_path / "recipes")])
    monkeypatch.setattr(loading, "DATA", data)
    registry._load.cache_clear()
    loading._load.cache_clear()
    yield load_catalogue([])
    loading._load.cache_clear()
    sys.modules.pop("mansion_assets.recipes.drones", None)


def test_an_entry_and_a_recipe_give_an_asset_with_mesh_receptacles_and_words(extended: Catalogue) -> None:
    asset = extended.asset("drone_pedestal_1")
    points = np.concatenate([part.vertices for part in mesh(asset)])
    assert np.ptp(points, axis=0) == pytest.approx(asset.size)
    assert collision_boxes(asset)
    assert asset.receptacle and asset.surfaces[0].z == pytest.approx(0.45)
    assert search_assets(extended, "landing pad", 1)[0].asset.category == "drone_pedestal"
    wishes = furnish_request(extended, "drone_room", 20.0, seed=1)
    assert [(wish.category, wish.quantity) for wish in wishes.floor] == [("drone_pedestal", 2)]


def test_the_packages_own_catalogue_knows_nothing_of_it() -> None:
    assert "drone_pedestal" not in load_catalogue([]).categories


def test_every_category_names_a_recipe_and_a_receptacle_rule_that_exist() -> None:
    names = set(registry.recipe_names())
    for asset in load_catalogue([]).assets.values():
        assert asset.recipe in names, asset.key
        rule = asset.parameters.get("carrier", "none")
        assert rule == "none" or registry.receptacle_rule(rule) is not None, asset.key
