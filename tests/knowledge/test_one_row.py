"""A room type of the user's own is one row: it is planned, furnished, coloured, labelled and exported as its kin is."""

import json
from pathlib import Path

import pytest

from mansion_assets.catalogue import load_catalogue
from mansion_bringup.pipeline.build import build_building
from mansion_export.plan.palette import room_tint
from mansion_knowledge import default_knowledge, is_class, kin_of, load_knowledge, uses_of
from mansion_knowledge.base import FOLDERS
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest

BRIEF = "A one-storey house with a living room, a kitchen, two bedrooms and an onsen."


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder of knowledge that every stage sees, with one row."""
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine/room_types.csv").write_text("name,synonyms,kin\nonsen,hot spring,bathroom\n")
    monkeypatch.setenv(FOLDERS, str(tmp_path / "mine"))
    return tmp_path


def test_what_a_row_leaves_out_is_its_kins(folder: Path) -> None:
    onsen, bathroom = default_knowledge().rooms["onsen"], default_knowledge().rooms["bathroom"]
    assert (onsen.least, onsen.usual, onsen.most, onsen.zone) == (4.0, 6.0, 16.0, "service")
    assert onsen.wet and onsen.near == bathroom.near
    assert onsen.synonyms == ("hot spring",)
    assert kin_of("onsen") == "bathroom"
    assert is_class("onsen", "wet")
    assert uses_of("onsen") == uses_of("bathroom")
    assert room_tint("onsen", "") == room_tint("bathroom", "")
    assert load_catalogue().room_program("onsen").room_type == "bathroom"


def test_one_row_is_planned_furnished_and_exported(folder: Path) -> None:
    built = build_building(BuildRequest(description=BRIEF, seed=3), folder / "house", formats=["thor"])
    floor = built.path / "floors/floor_1"
    topology, scene, house = (
        json.loads((floor / f"{name}.json").read_text()) for name in ("topology", "scene", "house")
    )
    assert [node["id"] for node in topology["nodes"] if node["room_type"] == "onsen"] == ["onsen"]
    room = next(room for room in scene["rooms"] if room["room_type"] == "onsen")
    things = {thing["category"] for thing in scene["objects"] if thing["room"] == room["id"]}
    assert things >= {"toilet", "washbasin"}
    plan = (floor / "plan.svg").read_text()
    assert room_tint("bathroom", "") in plan and ">Onsen<" in plan
    assert [entry["roomType"] for entry in house["rooms"] if entry["name"] == "Onsen"] == ["Bathroom"]


@pytest.mark.parametrize(
    ("row", "fault"), [("onsen,,nowhere", "'nowhere' is not a room type"), ("onsen,,onsen", "is kin of itself")]
)
def test_a_kin_that_cannot_be_is_named(tmp_path: Path, row: str, fault: str) -> None:
    (tmp_path / "room_types.csv").write_text(f"name,synonyms,kin\n{row}\n")
    with pytest.raises(MansionError, match=fault):
        load_knowledge([tmp_path])


def test_the_kin_of_a_row_decides_and_not_what_its_name_was_known_as(folder: Path) -> None:
    (folder / "mine/room_types.csv").write_text("name,synonyms,kin\ntea_room,tearoom,living_room\n")
    assert load_catalogue([folder]).room_program("tea_room").room_type == "living_room"


def test_a_later_folder_takes_names_from_the_room_types_before_it(folder: Path) -> None:
    (folder / "room_types.csv").write_text("name,synonyms,kin\nsento,public bath;hot spring,bathroom\n")
    assert "hot spring" in default_knowledge().rooms["onsen"].synonyms
    rooms = load_knowledge([folder]).rooms
    assert rooms["sento"].synonyms == ("public bath", "hot spring")
    assert rooms["onsen"].synonyms == ()


def test_two_rows_of_a_file_with_the_same_synonym_are_refused(tmp_path: Path) -> None:
    (tmp_path / "room_types.csv").write_text("name,synonyms,kin\nonsen,hot spring,bathroom\nsento,hot spring,pool\n")
    with pytest.raises(MansionError, match="'sento': 'hot spring' is a name of 'onsen' too"):
        load_knowledge([tmp_path])
