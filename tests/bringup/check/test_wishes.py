"""``mansion check`` agrees with the receipt of a building, and finds what was made untrue in it."""

import json
import shutil
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import msgspec
import pytest

from mansion_bringup.building.receipt import receipt
from mansion_bringup.check.shapes import outline_forms
from mansion_bringup.check.wishes import check_wishes
from mansion_bringup.edit_hooks import records
from mansion_bringup.editor import open_editor
from mansion_bringup.pipeline.build import build_building
from mansion_bringup.verify import verify_building
from mansion_msgs_py.building import Building, BuildingReport
from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.wishes import Scope, Wish, WishStatus, WishValue
from wish_cases import CASES
from wish_house import L_OUTLINE, building, layouts, program, scenes, wish

BRIEF = "a house with two bedrooms, a sofa in the living room and no gym"
OTHER: dict[str, WishStatus] = {"met": "not_met", "partly": "met", "not_met": "met", "not_understood": "met"}


def faults(told: Wish, asked: Wish | None = None) -> list[str]:
    floors = scenes()
    ledger = [msgspec.structs.replace(asked or told, status="", rooms=[], objects=[])]
    house = building(program(ledger), [told])
    return [fault.kind for fault in check_wishes(house, [told], layouts(floors), floors)]


@pytest.mark.parametrize("asked", [case[1] for case in CASES], ids=[case[0] for case in CASES])
def test_the_check_agrees_with_the_receipt_and_with_no_other_status(asked: Wish) -> None:
    told = receipt([asked], program([asked]), scenes())[0]
    assert faults(told, asked) == []
    assert faults(msgspec.structs.replace(told, status=OTHER[told.status]), asked) == ["WISH_STATUS"]
    assert faults(msgspec.structs.replace(told, status=""), asked) == ["WISH_STATUS"]


def ledger_faults(ledger: list[Wish], statuses: dict[str, WishStatus]) -> list[str]:
    """Return the faults of a ledger as it is told, some wishes of it with another status."""
    floors = scenes()
    told = [
        msgspec.structs.replace(entry, status=statuses.get(entry.id, entry.status))
        for entry in receipt(ledger, program(ledger), floors)
    ]
    return [fault.kind for fault in check_wishes(building(program(ledger), told), told, layouts(floors), floors)]


@pytest.mark.parametrize(("floors", "other"), [([2], "not_met"), ([1], "met"), ([], "met")])
def test_the_check_agrees_on_what_a_storey_holds_and_no_more(floors: list[int], other: WishStatus) -> None:
    ledger = [
        wish("room", WishValue(name="bedroom", type="bedroom", count=2), name="wish_1"),
        wish("room", WishValue(name="pottery_room", type="study_room", count=1), name="wish_2"),
        wish("only", scope=Scope(floors=floors), name="wish_3"),
    ]
    assert ledger_faults(ledger, {}) == []
    assert ledger_faults(ledger, {"wish_3": other}) == ["WISH_STATUS"]


@pytest.mark.parametrize(
    ("change", "kind"),
    [
        ({"rooms": ["F1/kitchen", "F1/nowhere"]}, "WISH_ROOM"),
        ({"objects": ["F1/kitchen/stove_9"]}, "WISH_OBJECT"),
        ({"text": "one two three four five six seven eight nine ten eleven twelve thirteen"}, "WISH_TEXT"),
        ({"span": (3, 900)}, "WISH_TEXT"),
        ({"span": (9, 4)}, "WISH_TEXT"),
    ],
)
def test_what_a_wish_states_is_true(change: dict[str, Any], kind: str) -> None:
    told = msgspec.structs.replace(wish("floors", WishValue(count=2)), status="met", **change)
    assert faults(told) == [kind]


def test_a_wish_of_the_ledger_is_not_lost_or_changed() -> None:
    asked = wish("floors", WishValue(count=2))
    easier = msgspec.structs.replace(asked, value=WishValue(count=2, area=1.0), status="met")
    assert faults(easier, asked) == ["WISH_LEDGER"]
    floors = scenes()
    house = building(program([asked]), [])
    assert [fault.kind for fault in check_wishes(house, None, layouts(floors), floors)] == ["WISH_LEDGER"]


def test_forms_are_told_from_their_recesses() -> None:
    assert outline_forms(L_OUTLINE, []) == {"L"}
    assert outline_forms([(0, 0), (12, 0), (12, 9), (8, 9), (8, 4), (4, 4), (4, 9), (0, 9)], []) == {"U", "courtyard"}
    assert outline_forms([(4, 0), (8, 0), (8, 5), (12, 5), (12, 9), (0, 9), (0, 5), (4, 5)], []) == {"T"}
    assert outline_forms([(0, 0), (8, 0), (8, 5), (12, 5), (12, 9), (4, 9), (4, 4), (0, 4)], []) == {"Z"}


@pytest.fixture(scope="module")
def sound(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return build_building(BuildRequest(description=BRIEF, seed=2), tmp_path_factory.mktemp("wishes") / "house").path


@pytest.fixture
def house(sound: Path, tmp_path: Path) -> Path:
    shutil.copytree(sound, tmp_path / "house")
    return tmp_path / "house"


def sofa_removed(folder: Path) -> None:
    for file in folder.glob("floors/*/scene.json"):
        scene = json.loads(file.read_text())
        sofas = {thing["id"] for thing in scene["objects"] if thing["category"] == "sofa"}
        gone = {thing["id"] for thing in scene["objects"] if thing["id"] in sofas or thing.get("parent") in sofas}
        scene["objects"] = [thing for thing in scene["objects"] if thing["id"] not in gone]
        file.write_text(json.dumps(scene))


def of_wishes(folder: Path) -> set[str]:
    return {fault.kind for fault in verify_building(folder) if fault.kind.startswith("WISH")}


def statuses(wishes: Iterable[Wish]) -> dict[str, str]:
    return {wish.text: wish.status for wish in wishes}


def test_a_built_house_states_of_its_wishes_what_is_true(house: Path) -> None:
    found = BuildingFolder(house).building.wishes
    assert statuses(found)["a sofa"] == "met"
    assert of_wishes(house) == set()


def test_an_object_that_is_gone_is_missed(house: Path) -> None:
    sofa_removed(house)
    assert of_wishes(house) == {"WISH_STATUS", "WISH_OBJECT"}


def test_a_status_that_someone_changed_is_noticed(house: Path) -> None:
    index = json.loads((house / "building.json").read_text())
    index["wishes"][0]["status"] = "not_met"
    (house / "building.json").write_text(json.dumps(index))
    assert of_wishes(house) == {"WISH_STATUS", "WISH_LEDGER"}


def test_records_are_derived_anew_after_an_edit(house: Path) -> None:
    before = BuildingFolder(house)
    assert records(house, {scene.floor: scene for scene in before.scenes()}) == {}
    sofa_removed(house)
    for name, data in records(house, {scene.floor: scene for scene in BuildingFolder(house).scenes()}).items():
        (house / name).write_bytes(data)
    for kind, name in ((Building, "building.json"), (BuildingReport, "report.json")):
        wishes = msgspec.json.decode((house / name).read_bytes(), type=kind).wishes
        assert statuses(wishes)["a sofa"] == "not_met"
    assert of_wishes(house) == set()


def test_an_edit_and_its_undoing_settle_the_wishes_anew(house: Path) -> None:
    (sofa,) = [wish.objects[0] for wish in BuildingFolder(house).building.wishes if wish.text == "a sofa"]
    editor = open_editor(house, physics="static", who="ann")
    editor.call("RemoveObject", {"object_id": sofa})
    assert statuses(BuildingFolder(house).building.wishes)["a sofa"] != "met"
    assert of_wishes(house) == set()
    editor.store.undo("ann")
    assert statuses(BuildingFolder(house).building.wishes)["a sofa"] == "met"
    assert of_wishes(house) == set()


def test_records_that_cannot_be_read_are_left_alone(tmp_path: Path) -> None:
    (tmp_path / "building.json").write_text("{}")
    assert records(tmp_path, {}) == {}


def test_a_room_that_becomes_another_is_no_longer_what_was_asked_for(house: Path) -> None:
    before = BuildingFolder(house)
    (bedrooms,) = [wish for wish in before.building.wishes if wish.text == "two bedrooms"]
    assert bedrooms.status == "met"
    editor = open_editor(house, physics="static", who="ann")
    editor.call("FurnishRoom", {"room_id": bedrooms.rooms[0], "room_type": "study"})
    (after,) = [wish for wish in BuildingFolder(house).building.wishes if wish.text == "two bedrooms"]
    assert after.status == "partly" and after.rooms == bedrooms.rooms[1:]
    assert verified(house) == []
    editor.call("Undo")
    assert statuses(BuildingFolder(house).building.wishes)["two bedrooms"] == "met"
    assert verified(house) == []


def test_a_room_with_another_name_is_still_what_was_asked_for(house: Path) -> None:
    (living,) = [r for r in BuildingFolder(house).scene(1).rooms if r.room_type == "living_room"]
    editor = open_editor(house, physics="static", who="ann")
    editor.call("RenameRoom", {"room_id": living.id, "name": "The Den"})
    editor.call("SetFinish", {"room_id": "the den", "part": "walls", "color": "green"})
    editor.call("FurnishRoom", {"room_id": "the den"})
    assert statuses(BuildingFolder(house).building.wishes)["a sofa"] == "met"
    assert verified(house) == []
    editor.call("ClearRoom", {"room_id": "the den"})
    assert statuses(BuildingFolder(house).building.wishes)["a sofa"] == "not_met"
    assert verified(house) == []


def verified(house: Path) -> list[str]:
    return [str(fault) for fault in verify_building(house)]
