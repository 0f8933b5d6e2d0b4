"""What the catalogue holds and that its parts fit together."""

import json
from pathlib import Path

import pytest

from mansion_assets.catalogue import load_catalogue
from mansion_msgs_py.errors import MansionError

CATALOGUE = load_catalogue()
TEST_MESH = b"glTF"


def test_there_are_enough_categories_and_room_types() -> None:
    assert len(CATALOGUE.categories) >= 300
    furnished = [t for t in CATALOGUE.room_types if CATALOGUE.room_program(t).floor]
    assert len(furnished) >= 120


def test_every_program_names_existing_categories_with_assets_that_meet_its_bounds() -> None:
    for room_type in CATALOGUE.room_types:
        card = CATALOGUE.room_program(room_type)
        for item in card.floor:
            assets = CATALOGUE.choose_from(item.category, item.extent)
            assert assets, (room_type, item.name)
            assert all(a.mount == "floor" for a in assets), (room_type, item.name)
        for hang in card.wall:
            assert {a.mount for a in CATALOGUE.choose_from(hang.category)} == {"wall"}, hang.category
        for hang in card.ceiling:
            assert {a.mount for a in CATALOGUE.choose_from(hang.category)} == {"ceiling"}
        for rug in card.rugs:
            assert all(a.size[2] <= 0.02 for a in CATALOGUE.choose_from(rug.category))
        assert set(card.arrangements) <= set(CATALOGUE.arrangements)


def test_items_relate_only_to_items_of_their_own_program() -> None:
    for room_type in CATALOGUE.room_types:
        card = CATALOGUE.room_program(room_type)
        names = {item.name for item in card.floor}
        assert len(names) == len(card.floor)
        for item in card.floor:
            targets = {relation.target for relation in item.relative}
            assert targets <= names - {item.name}, (room_type, item.name)
            assert not item.paired or item.paired in names
            assert isinstance(item.count, int) or not item.count.each or item.count.each in names


def test_arrangements_name_receptacles_and_small_things() -> None:
    for arrangement in CATALOGUE.arrangements.values():
        for category in arrangement.on:
            assert any(a.receptacle for a in CATALOGUE.by_category(category)), category
        for entry in (*arrangement.slots, *arrangement.seats, *arrangement.scatter):
            names = [entry.category] if isinstance(entry.category, str) else entry.category
            assert all(CATALOGUE.by_category(name) for name in names), (arrangement.name, names)


def test_sizes_are_plausible() -> None:
    for asset in CATALOGUE.assets.values():
        assert all(
            0.0029 < side < 4.3
            or asset.category in ("garage_car", "pool_basin", "ice_rink", "van", "truck", "fire_engine")
            for side in asset.size
        ), asset.key
        if asset.mount == "floor":
            assert asset.size[2] <= (3.0 if asset.category == "fire_engine" else 2.51), asset.key
        if asset.pickupable and asset.asset_id is None:
            assert max(asset.size) <= 1.0, asset.key


def test_surfaces_and_volumes_lie_within_the_asset() -> None:
    for asset in CATALOGUE.assets.values():
        w, d, h = asset.size
        for s in asset.surfaces:
            assert abs(s.x) + s.w / 2 <= w / 2 + 1e-3, asset.key
            assert abs(s.y) + s.d / 2 <= d / 2 + 1e-3, asset.key
            assert -h / 2 - 1e-3 <= s.z <= h / 2 + 1e-3, asset.key
        for v in asset.volumes:
            assert abs(v.x) + v.w / 2 <= w / 2 + 1e-3, asset.key
            assert abs(v.y) + v.d / 2 <= d / 2 + 1e-3, asset.key
            assert abs(v.z) + v.h / 2 <= h / 2 + 1e-3, asset.key


def test_ai2_thor_assets_carry_their_real_ids() -> None:
    real = [a for a in CATALOGUE.assets.values() if a.asset_id is not None]
    assert len(real) > 1400
    assert CATALOGUE.asset("Fridge_1").thor_type == "Fridge"
    assert CATALOGUE.asset("Fridge_1").openable


@pytest.mark.parametrize(
    ("asked", "program"),
    [
        ("Meeting Room 2", "meeting_room"),
        ("conference_room", "meeting_room"),
        ("mens_restroom", "restroom"),
        ("staff kitchen", "kitchen"),
        ("patient_rooms", "patient_room"),
        ("xyzzy", "generic_room"),
        ("organic_chemistry_laboratory", "laboratory"),
        ("elevator_shaft", "void"),
    ],
)
def test_unknown_room_types_resolve_to_what_resembles_them(asked: str, program: str) -> None:
    assert CATALOGUE.room_program(asked).room_type == program


def test_a_missing_asset_is_named_with_its_neighbours() -> None:
    with pytest.raises(MansionError, match="Fridge_1"):
        CATALOGUE.asset("Fridge_01")


def _folder(path: Path, name: str, kind: str, record: object) -> Path:
    (path / kind).mkdir(parents=True, exist_ok=True)
    (path / kind / name).write_text(json.dumps(record), encoding="utf-8")
    return path


def test_a_user_folder_adds_an_asset_and_puts_it_into_rooms(tmp_path: Path) -> None:
    record = {
        "key": "my_robot",
        "category": "robot_arm",
        "size": [0.4, 0.4, 1.0],
        "glb": "arm.glb",
        "rooms": ["laboratory"],
    }
    _folder(tmp_path, "arm.json", "assets", record)
    (tmp_path / "assets" / "arm.glb").write_bytes(TEST_MESH)
    catalogue = load_catalogue([tmp_path])
    assert catalogue.asset("my_robot").glb is not None
    assert any(i.category == "robot_arm" for i in catalogue.room_program("laboratory").floor)


def test_a_user_folder_adds_a_room_type(tmp_path: Path) -> None:
    room = {"room_type": "drone_hangar", "floor": [{"name": "bench", "category": "workbench", "global": "edge"}]}
    catalogue = load_catalogue([_folder(tmp_path, "r.json", "rooms", room)])
    assert catalogue.room_program("drone_hangar").how == "exact"


def test_a_bad_record_is_refused_with_file_and_path(tmp_path: Path) -> None:
    record = {"key": "x", "category": "x", "size": [1, 1, -1], "recipe": "table"}
    _folder(tmp_path, "bad.json", "assets", record)
    with pytest.raises(MansionError, match=r"bad\.json") as caught:
        load_catalogue([tmp_path])
    assert caught.value.info.path == "$.size[2]"


def test_a_missing_glb_and_a_missing_folder_are_refused(tmp_path: Path) -> None:
    record = {"key": "x", "category": "x", "size": [1, 1, 1], "glb": "none.glb"}
    _folder(tmp_path, "x.json", "assets", record)
    with pytest.raises(MansionError, match=r"none\.glb"):
        load_catalogue([tmp_path])
    with pytest.raises(MansionError, match="no catalogue folder"):
        load_catalogue([tmp_path / "nowhere"])
