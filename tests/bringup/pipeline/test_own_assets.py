"""A building with assets of the user's own: built, checked, edited and exported as any other, without the library."""

import json
import shutil
from pathlib import Path

import pytest
from msgspec.structs import replace
from typer.testing import CliRunner, Result

from mansion_assets.library.building_assets import catalogue_for
from mansion_bringup.cli.app import app
from mansion_msgs_py.building import BuildingReport
from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.codec import decode
from mansion_msgs_py.scene import SceneObject
from mansion_skills.world.floor_exports import MODEL, made
from sample_models import bar_glb, write_cabinet

BRIEF = "a small flat with an espresso bar in the living room"


def run(*words: str) -> Result:
    result = CliRunner().invoke(app, list(words))
    assert result.exit_code == 0, result.output
    return result


@pytest.fixture(scope="module")
def flat(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a flat built with the library ``shop``, which is gone by now."""
    folder = tmp_path_factory.mktemp("own")
    (folder / "models").mkdir()
    (folder / "models" / "espresso_bar.glb").write_bytes(bar_glb())
    library = str(folder / "shop")
    run("assets", "add", str(folder / "models"), "--library", library, "--licence", "CC0")
    result = run("build", BRIEF, "--assets", library, "-o", str(folder / "flat"), "--jobs", "1")
    assert "own assets: 1 x shop.espresso_bar" in result.output
    shutil.rmtree(library)
    return folder / "flat"


def bar(flat: Path) -> SceneObject:
    (found,) = (item for item in BuildingFolder(flat).scene(1).objects if item.asset == "shop.espresso_bar")
    return found


def test_a_new_category_is_asked_for_by_its_words_and_the_building_passes_the_check(flat: Path) -> None:
    assert bar(flat).category == "espresso_bar"
    assert bar(flat).room == "F1/living_room"
    run("check", str(flat))


def test_the_folder_holds_the_assets_that_it_shows_and_the_report_names_them(flat: Path) -> None:
    names = {file.name for file in (flat / "assets").iterdir()}
    assert names == {f"shop.espresso_bar{end}" for end in (".glb", ".json", ".pieces.json")}
    report = decode(BuildingReport, (flat / "report.json").read_bytes())
    assert isinstance(report.assets, list)
    assert [(use.asset, use.objects, use.library, use.licence) for use in report.assets] == [
        ("shop.espresso_bar", 1, "shop", "CC0")
    ]


def test_an_edit_puts_a_thing_on_it_and_the_check_still_passes(flat: Path) -> None:
    run("edit", str(flat), "put a mug on the espresso bar")
    mugs = [item for item in BuildingFolder(flat).scene(1).objects if item.parent == bar(flat).id]
    assert any("mug" in item.category for item in mugs)
    run("check", str(flat))


def test_exports_hold_its_mesh_and_its_pieces(flat: Path) -> None:
    from trimesh import load

    run("export", str(flat), "--to", "glb")
    names = json.dumps(list(load(flat / "building.glb", force="scene").graph.nodes))
    assert "espresso_bar" in names
    model = made(BuildingFolder(flat), 1, MODEL)["floors/floor_1/model.xml"].decode()
    body = model[model.index(f'name="{bar(flat).id}"') :].partition("</body>")[0]
    # A case and a top that stands out in front of it are no one box.
    assert body.count('class="collision"') > 1, body


def test_what_an_edit_brings_from_a_library_comes_into_the_folder(flat: Path, tmp_path: Path) -> None:
    copy = tmp_path / "flat"
    shutil.copytree(flat, copy)
    cabinets = str(tmp_path / "cabinets")
    run("assets", "add", str(write_cabinet(tmp_path / "models")), "--library", cabinets)
    run("edit", str(copy), "put a filing cabinet in the living room", "--assets", cabinets)
    assert (copy / "assets" / "cabinets.filing_cabinet.glb").is_file()
    report = decode(BuildingReport, (copy / "report.json").read_bytes())
    assert isinstance(report.assets, list)
    assert "cabinets.filing_cabinet" in {use.asset for use in report.assets}
    shutil.rmtree(cabinets)
    run("check", str(copy))


def test_a_library_that_is_not_there_is_named_with_those_that_are(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("MANSION_LIBRARIES", str(tmp_path))
    (tmp_path / "kitchen" / "assets").mkdir(parents=True)
    result = CliRunner().invoke(app, ["build", BRIEF, "--assets", "shop", "-o", str(tmp_path / "flat")])
    assert result.exit_code != 0
    said = result.output + str(result.exception)
    assert "there is no library 'shop'" in said
    assert "libraries: kitchen" in said
    assert not (tmp_path / "flat").exists()


def test_a_stated_mass_and_the_drawer_of_a_urdf_reach_the_physics(tmp_path: Path, flat: Path) -> None:
    from mansion_export.meshes.building_model import floor_model
    from mansion_export.physics.articulation import assemblies

    cabinets = tmp_path / "cabinets"
    run("assets", "add", str(write_cabinet(tmp_path / "models")), "--library", str(cabinets))
    catalogue = catalogue_for(flat, [str(cabinets)])
    own = catalogue.asset("cabinets.filing_cabinet")
    scene = BuildingFolder(flat).scene(1)
    there = bar(flat)
    scene = replace(scene, objects=[replace(there, asset=own.key, category=own.category, size=own.size)])
    model = floor_model(scene, catalogue=catalogue)
    made_of = assemblies(scene, {node.id: node for node in model.nodes}, catalogue)[there.id]
    (drawer,) = made_of.moving
    assert drawer.id.endswith("drawer_1")
    assert drawer.joint.travel == pytest.approx(0.35)
    assert made_of.mass + drawer.mass == pytest.approx(30.0)
