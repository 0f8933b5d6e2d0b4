"""Models become assets of a library that the catalogue reads; broken ones are refused with the reason."""

import json
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest

from mansion_assets.catalogue import load_catalogue
from mansion_assets.library.adding import Addition, add_models, models_below
from mansion_assets.library.faults import library_faults
from mansion_assets.library.preparing import AddOptions
from mansion_assets.library.source_model import SourceSurface
from mansion_assets.meshes import links, mesh
from mansion_msgs_py.errors import ErrorCode, MansionError
from sample_models import bar_glb, box, write_models


def no_picture(surfaces: Sequence[SourceSurface]) -> bytes:
    assert surfaces
    return b"picture"


def added(
    paths: Sequence[Path], library: Path, options: AddOptions | None = None, *, replace: bool = False
) -> list[Addition]:
    chosen = options or AddOptions(licence="CC0")
    return list(add_models(paths, library, chosen, load_catalogue([]), no_picture, replace=replace))


@pytest.fixture(scope="module")
def models(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("models") / "downloads"
    write_models(folder)
    return folder


@pytest.fixture(scope="module")
def shop(models: Path) -> Path:
    return models.parent / "shop"


@pytest.fixture(scope="module")
def results(models: Path, shop: Path) -> dict[str, Addition]:
    return {Path(result.file).stem: result for result in added([models], shop)}


def test_good_models_are_added_and_a_catalogue_reads_them(results: dict[str, Addition], shop: Path) -> None:
    good = {result.key for result in results.values() if result.status == "added"}
    assert good == {"shop.espresso_bar", "shop.wooden_chair", "shop.filing_cabinet", "shop.bookshelf_a1b2c3d4"}
    catalogue = load_catalogue([shop])
    assert {asset.key for asset in catalogue.assets.values() if asset.record} == good
    assert all(mesh(catalogue.asset(key)) for key in good)
    assert (shop / "assets" / "shop.espresso_bar.png").read_bytes() == b"picture"


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("cut", "cut off"),
        ("empty", "no triangle"),
        ("nowhere", "1 vertices that are not finite"),
        ("outside", "outside"),
        ("flat", "no extent"),
    ],
)
def test_a_broken_model_is_refused_with_the_reason(results: dict[str, Addition], name: str, reason: str) -> None:
    assert results[name].status == "refused"
    assert reason in results[name].reason


def test_a_library_has_no_faults_until_a_file_of_it_changes(models: Path, tmp_path: Path) -> None:
    library = tmp_path / "shop"
    added([models / "espresso_bar.glb"], library)
    assert not list(library_faults(library))
    (library / "assets" / "shop.espresso_bar.glb").write_bytes(bar_glb(1.9))
    assert any("sha256" in fault.message for fault in library_faults(library))


def test_a_size_in_millimetres_is_brought_to_metres_and_said_to_be_guessed(results: dict[str, Addition]) -> None:
    chair = results["wooden_chair"]
    assert chair.category == "chair"
    assert chair.size == pytest.approx((0.45, 0.45, 0.925), abs=1e-3)
    assert any("millimetres" in fact for fact in chair.guessed)


def test_annotations_state_category_height_front_and_licence(results: dict[str, Addition], shop: Path) -> None:
    shelf = results["a1b2c3d4e5f60718"]
    assert shelf.category == "bookshelf"
    assert shelf.size == pytest.approx((0.27, 0.9, 1.8), abs=1e-3)
    assert any(fact.startswith("front: turned by 90") for fact in shelf.stated)
    asset = load_catalogue([shop]).asset(shelf.key)
    assert (asset.author, asset.source) == ("Ann", "https://example.org/1")


def test_the_drawer_of_a_urdf_slides_to_the_front(results: dict[str, Addition], shop: Path) -> None:
    cabinet = load_catalogue([shop]).asset("shop.filing_cabinet")
    body, drawer = links(cabinet)
    assert cabinet.openable
    assert cabinet.mass == 30.0
    assert drawer.joint is not None
    assert drawer.joint.kind == "slide"
    np.testing.assert_allclose(drawer.joint.axis, (0.0, 1.0, 0.0), atol=1e-6)
    assert drawer.joint.travel == pytest.approx(0.35)
    assert body.pieces
    assert drawer.pieces


def test_the_top_of_a_bar_carries_things(results: dict[str, Addition], shop: Path) -> None:
    bar = load_catalogue([shop]).asset("shop.espresso_bar")
    top = bar.surfaces[0]
    assert top.z == pytest.approx(bar.size[2] / 2, abs=2e-3)
    assert top.w == pytest.approx(1.6, abs=0.05)


def test_what_was_added_is_unchanged_the_second_time(results: dict[str, Addition], models: Path, shop: Path) -> None:
    again = added([models / "espresso_bar.glb"], shop)
    assert [result.status for result in again] == ["unchanged"]


def test_another_model_of_the_same_name_is_refused_unless_it_replaces(tmp_path: Path) -> None:
    model = tmp_path / "espresso_bar.glb"
    model.write_bytes(bar_glb())
    added([model], tmp_path / "shop")
    model.write_bytes(bar_glb(2.0))
    (refused,) = added([model], tmp_path / "shop")
    assert refused.status == "refused"
    assert "--replace" in refused.reason
    (replaced,) = added([model], tmp_path / "shop", replace=True)
    assert replaced.status == "replaced"
    assert load_catalogue([tmp_path / "shop"]).asset(replaced.key).size[0] == pytest.approx(2.0)


def test_the_budget_of_triangles_is_kept(tmp_path: Path) -> None:
    model = tmp_path / "bar.glb"
    model.write_bytes(bar_glb())
    (result,) = added([model], tmp_path / "shop", AddOptions(triangles=10))
    assert "24 triangles, more than the 10 allowed" in result.reason


def test_the_category_and_the_front_that_are_asked_for_are_taken(tmp_path: Path) -> None:
    model = tmp_path / "thing.glb"
    model.write_bytes(bar_glb())
    (result,) = added([model], tmp_path / "shop", AddOptions(category="pinball machine deluxe", front="+x"))
    assert result.size == pytest.approx((0.7, 1.6, 1.05), abs=1e-3)
    assert any(fact.startswith("category:") for fact in result.stated)


def test_a_folder_without_models_and_a_path_that_is_not_there_are_told(tmp_path: Path) -> None:
    for path in (tmp_path, tmp_path / "missing"):
        with pytest.raises(MansionError) as caught:
            models_below(path)
        assert caught.value.info.code == ErrorCode.NOT_FOUND


def test_records_state_their_content_and_what_was_guessed(results: dict[str, Addition], shop: Path) -> None:
    record = json.loads((shop / "assets" / "shop.wooden_chair.json").read_text())
    assert len(record["sha256"]) == 64
    assert record["licence"] == "CC0"
    assert record["guessed"]
    assert record["stated"] == ["licence: CC0"]


def test_the_colours_of_a_model_are_kept(tmp_path: Path) -> None:
    import trimesh

    model = tmp_path / "bar.glb"
    model.write_bytes(trimesh.Scene([box((1.0, 1.0, 0.5), (0, 0, 0), (200, 40, 40))]).export(file_type="glb"))
    (result,) = added([model], tmp_path / "shop")
    (part,) = mesh(load_catalogue([tmp_path / "shop"]).asset(result.key))
    # 200 and 40 of 255 are shares of linear light in glTF; a file holds them in whole steps.
    color = [int(part.material.color[i : i + 2], 16) for i in (1, 3, 5)]
    assert color == pytest.approx([228, 111, 111], abs=3)


def test_meshes_that_a_urdf_names_are_its_parts_and_others_beside_it_are_models(tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "tray.glb").write_bytes(bar_glb())
    (tmp_path / "bar.glb").write_bytes(bar_glb())
    (tmp_path / "chest.urdf").write_text("<robot><mesh filename='package://chest/parts/tray.glb'/></robot>")
    assert models_below(tmp_path) == [tmp_path / "bar.glb", tmp_path / "chest.urdf"]
