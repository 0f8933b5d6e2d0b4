import json
from pathlib import Path
from xml.etree import ElementTree

import pytest
from msgspec.structs import replace
from trimesh.creation import box

import sample_floors
from mansion_assets.catalogue import preferring
from mansion_export.glb import building_glb
from mansion_export.licences import PROJECT, licence_lines, licence_records, xml_notice
from mansion_export.mjcf import floor_mjcf
from mansion_export.sdf import world_sdf
from mansion_export.thor.house import house
from mansion_msgs_py.scene import FloorScene
from mansion_scene.assembly import furnish_floor

RECORD = {"asset": "shop.crate", "licence": "CC-BY-4.0", "author": "Ann -- & Co", "source": "crate.glb"}
LINE = "shop.crate: licence CC-BY-4.0, by Ann -- & Co, from crate.glb"


@pytest.fixture(scope="module")
def shop(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("shop")
    (folder / "assets").mkdir()
    (folder / "assets" / "crate.glb").write_bytes(box((0.5, 0.5, 0.5)).export(file_type="glb"))
    facts = {"key": "shop.crate", "category": "crate", "size": (0.5, 0.5, 0.5), "glb": "crate.glb"}
    facts |= {name: value for name, value in RECORD.items() if name != "asset"}
    (folder / "assets" / "crate.json").write_text(json.dumps(facts))
    return folder


@pytest.fixture(scope="module")
def scene() -> FloorScene:
    """Return a floor of which one object is the user's."""
    made = furnish_floor(sample_floors.office())
    first = made.objects[0]
    own = replace(first, asset="shop.crate", category="crate", size=(0.5, 0.5, 0.5))
    return replace(made, objects=[own, *made.objects[1:8]])


def document(glb: bytes) -> dict[str, object]:
    size = int.from_bytes(glb[12:16], "little")
    found: dict[str, object] = json.loads(glb[20 : 20 + size])
    return found


def test_the_project_is_named_once_and_each_own_asset_with_its_own_licence(scene: FloorScene, shop: Path) -> None:
    with preferring([shop]):
        records = licence_records([scene, scene])
    assert records == [RECORD]
    assert licence_lines(records) == [PROJECT, LINE]
    assert licence_records([scene]) == []


def test_what_has_no_licence_says_so(scene: FloorScene, shop: Path, tmp_path: Path) -> None:
    (tmp_path / "assets").mkdir()
    for file in (shop / "assets").iterdir():
        (tmp_path / "assets" / file.name).write_bytes(file.read_bytes().replace(b"CC-BY-4.0", b""))
    with preferring([tmp_path]):
        assert licence_records([scene])[0]["licence"] == "not stated"


def test_formats_carry_the_licences(scene: FloorScene, shop: Path) -> None:
    with preferring([shop]):
        asset = document(building_glb([scene]))["asset"]
        texts = [floor_mjcf(scene).xml, world_sdf([scene]).xml]
        provenance = house(scene)["metadata"]["mansion"]
    assert isinstance(asset, dict)
    assert asset["copyright"] == f"{PROJECT}; {LINE}"
    assert asset["extras"]["licences"] == [RECORD]
    assert (provenance["copyright"], provenance["licences"]) == (PROJECT, [RECORD])
    for text in texts:
        ElementTree.fromstring(text)
        assert "shop.crate: licence CC-BY-4.0, by Ann - - & Co, from crate.glb" in text


def test_the_stage_of_usd_carries_them(scene: FloorScene, shop: Path, tmp_path: Path) -> None:
    usd = pytest.importorskip("pxr.Usd")
    from mansion_export.usd import building_usd

    with preferring([shop]):
        (tmp_path / "building.usdc").write_bytes(building_usd([scene]))
    stage = usd.Stage.Open(str(tmp_path / "building.usdc"))
    said = stage.GetRootLayer().customLayerData["mansion"]
    assert said["copyright"] == f"{PROJECT}; {LINE}"
    assert dict(said["licences"]["shop.crate"]) == RECORD


def test_a_comment_holds_any_name_of_an_author() -> None:
    odd = RECORD | {"author": "---\x00\n-->"}
    assert ElementTree.fromstring(f"{xml_notice([odd])}<a/>").tag == "a"
