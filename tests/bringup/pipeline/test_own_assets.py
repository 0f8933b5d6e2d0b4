"""A building with an asset of the user's own: built, checked, edited and exported as any other."""

import json
from pathlib import Path

import pytest
from msgspec.structs import replace
from typer.testing import CliRunner, Result

from mansion_assets.catalogue.loading import FOLDERS
from mansion_bringup.cli.app import app
from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.scene import SceneObject
from sample_models import bar_glb, write_cabinet

BRIEF = "a small flat with a slush machine in the living room"


def run(*words: str) -> Result:
    result = CliRunner().invoke(app, list(words))
    assert result.exit_code == 0, result.output
    return result


@pytest.fixture(scope="module")
def flat(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("own")
    (folder / "models").mkdir()
    (folder / "models" / "slush_machine.glb").write_bytes(bar_glb())
    library = str(folder / "shop")
    run("assets", "add", str(folder / "models"), "--library", library, "--licence", "CC0")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv(FOLDERS, library)
        run("build", BRIEF, "-o", str(folder / "flat"), "--jobs", "1")
    return folder / "flat"


@pytest.fixture(autouse=True)
def library(flat: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv(FOLDERS, str(flat.parent / "shop"))
    return flat.parent / "shop"


def machine(flat: Path) -> SceneObject:
    (found,) = (item for item in BuildingFolder(flat).scene(1).objects if item.asset == "shop.slush_machine")
    return found


def test_a_new_category_is_asked_for_by_its_words_and_the_building_passes_the_check(flat: Path) -> None:
    assert machine(flat).category == "slush_machine"
    run("check", str(flat))


def test_an_edit_puts_a_thing_on_it_and_the_check_still_passes(flat: Path) -> None:
    run("edit", str(flat), "put a mug on the slush machine")
    mugs = [item for item in BuildingFolder(flat).scene(1).objects if item.parent == machine(flat).id]
    assert any("mug" in item.category for item in mugs)
    run("check", str(flat))


def test_exports_hold_its_mesh_and_its_pieces(flat: Path) -> None:
    from trimesh import load

    run("export", str(flat), "--to", "glb")
    run("export", str(flat), "--to", "mjcf")
    names = json.dumps(list(load(flat / "building.glb", force="scene").graph.nodes))
    assert "slush_machine" in names
    model = (flat / "floors" / "floor_1" / "model.xml").read_text()
    body = model[model.index(f'name="{machine(flat).id}"') :].partition("</body>")[0]
    # A case and a top that stands out in front of it are no one box.
    assert body.count('class="collision"') > 1, body


def test_a_stated_mass_and_the_drawer_of_a_urdf_reach_the_physics(tmp_path: Path, library: Path) -> None:
    from mansion_assets.catalogue import load_catalogue
    from mansion_export.articulation import assemblies
    from mansion_export.building_model import floor_model

    cabinets = tmp_path / "cabinets"
    run("assets", "add", str(write_cabinet(tmp_path / "models")), "--library", str(cabinets))
    catalogue = load_catalogue([library, cabinets])
    own = catalogue.asset("cabinets.filing_cabinet")
    scene = BuildingFolder(library.parent / "flat").scene(1)
    there = next(item for item in scene.objects if item.asset == "shop.slush_machine")
    scene = replace(scene, objects=[replace(there, asset=own.key, category=own.category, size=own.size)])
    model = floor_model(scene, catalogue=catalogue)
    made = assemblies(scene, {node.id: node for node in model.nodes}, catalogue)[there.id]
    (drawer,) = made.moving
    assert drawer.id.endswith("drawer_1")
    assert drawer.joint.travel == pytest.approx(0.35)
    assert made.mass + drawer.mass == pytest.approx(30.0)
