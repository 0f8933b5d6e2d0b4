import json
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from trimesh.creation import box

from mansion_assets.catalogue import furnish_request, load_catalogue, preferred_folders, preferring
from mansion_assets.catalogue.search import search_assets


def library(folder: Path, key: str, category: str, size: tuple[float, float, float] = (1.7, 0.8, 0.8)) -> Path:
    """Write a library of one asset, a box."""
    (folder / "assets").mkdir(parents=True)
    (folder / "assets" / f"{key}.glb").write_bytes(box((size[0], size[2], size[1])).export(file_type="glb"))
    record = {"key": key, "category": category, "size": size, "glb": f"{key}.glb", "materials": {"main": "own_pink_1"}}
    (folder / "assets" / f"{key}.json").write_text(json.dumps(record))
    return folder


def test_folders_are_preferred_within_the_block_and_in_its_thread_alone(tmp_path: Path) -> None:
    shop = library(tmp_path / "shop", "shop.sofa", "sofa")
    with preferring([shop]), ThreadPoolExecutor(1) as other:
        assert "shop.sofa" in load_catalogue().preferred
        assert other.submit(preferred_folders).result() == ()
        assert "shop.sofa" not in other.submit(load_catalogue).result().assets
    assert "shop.sofa" not in load_catalogue().assets


def test_two_catalogues_of_one_process_do_not_mix(tmp_path: Path) -> None:
    one, two = library(tmp_path / "one", "one.sofa", "sofa"), library(tmp_path / "two", "two.sofa", "sofa")
    with preferring([one]):
        first = load_catalogue()
        with preferring([two]):
            assert load_catalogue().preferred == {"two.sofa"}
        assert load_catalogue() is first


def test_an_asset_that_is_added_later_is_seen(tmp_path: Path) -> None:
    shop = library(tmp_path / "shop", "shop.sofa", "sofa")
    assert "shop.bench" not in load_catalogue(preferred=[shop]).assets
    library(tmp_path / "more", "shop.bench", "bench")
    for file in (tmp_path / "more" / "assets").iterdir():
        file.rename(shop / "assets" / file.name)
    assert "shop.bench" in load_catalogue(preferred=[shop]).preferred


@pytest.mark.parametrize("seed", range(4))
def test_rooms_take_the_preferred_variant(tmp_path: Path, seed: int) -> None:
    catalogue = load_catalogue([], preferred=[library(tmp_path / "shop", "shop.sofa", "sofa")])
    wishes = furnish_request(catalogue, "living_room", 24.0, seed=seed, room_id="F1/living_room")
    assert {a.key for a in wishes.floor_assets.values() if a.category == "sofa"} == {"shop.sofa"}


def test_what_does_not_go_into_the_room_gives_way_to_the_usual(tmp_path: Path) -> None:
    huge = library(tmp_path / "shop", "shop.sofa", "sofa", (9.0, 3.0, 0.8))
    catalogue = load_catalogue([], preferred=[huge])
    wishes = furnish_request(catalogue, "living_room", 24.0, seed=1, room_id="F1/living_room")
    sofas = {a.key for a in wishes.floor_assets.values() if a.category == "sofa"}
    assert sofas
    assert "shop.sofa" not in sofas


def test_a_search_gives_the_preferred_variant_first_unless_a_colour_says_otherwise(tmp_path: Path) -> None:
    catalogue = load_catalogue([], preferred=[library(tmp_path / "shop", "shop.sofa", "sofa")])
    assert search_assets(catalogue, "sofa", 1)[0].asset.key == "shop.sofa"
    found = search_assets(catalogue, "blue sofa", 1)[0].asset
    assert "blue" in found.material
