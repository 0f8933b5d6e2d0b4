"""The knowledge base: complete, validated, and open to the user's records."""

from pathlib import Path

import pytest

from mansion_knowledge import default_knowledge, load_knowledge
from mansion_knowledge.types import parse_entry
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building

HEADER = "name,synonyms,least,usual,most,zone,floors,near,flags,finish,suite\n"


def test_it_holds_enough_types() -> None:
    knowledge = default_knowledge()
    assert len(knowledge.buildings) >= 50
    assert len(knowledge.rooms) >= 200
    assert sum(len(room.synonyms) for room in knowledge.rooms.values()) >= 600


def test_no_two_rooms_share_a_name() -> None:
    seen: dict[str, str] = {}
    for room in default_knowledge().rooms.values():
        for phrase in room.synonyms:
            assert seen.setdefault(phrase, room.name) == room.name, phrase


def test_every_style_has_a_material_for_every_finish() -> None:
    knowledge = default_knowledge()
    for style in knowledge.styles.values():
        for room in knowledge.rooms.values():
            assert style.floors[room.finish]


def test_every_building_type_can_be_planned() -> None:
    for building in default_knowledge().buildings.values():
        reply = plan_building(BuildRequest(description=building.synonyms[0]))
        assert reply.program.kind == building.name, building.synonyms[0]


def test_a_users_folder_adds_and_replaces_records(tmp_path: Path) -> None:
    (tmp_path / "room_types.csv").write_text(HEADER + "kiln_room,pottery kiln,6,9,20,service,ground,,,concrete,\n")
    (tmp_path / "building_types.toml").write_text(
        '[pottery]\nsynonyms = ["pottery studio"]\nfamily = "industry"\nfloors = [1, 2]\nfloor_area = [80, 120]\n'
        'hub = "workshop"\nparti = "hall"\npeople = 20\nsingle = ["kiln_room x2", "storage", "restroom:6"]\n'
    )
    knowledge = load_knowledge([tmp_path])
    reply = plan_building(BuildRequest(description="a pottery studio"), knowledge=knowledge)
    assert reply.program.kind == "pottery"
    assert sum(room.room_type == "kiln_room" for room in reply.program.floors[0].rooms) == 2


def test_building_types_are_grouped_by_family_and_by_words() -> None:
    groups = default_knowledge().groups
    assert groups.is_dwelling("single_family_house") and not groups.is_dwelling("office")
    assert "metal_panels" in groups.facades_of("warehouse_building")
    assert groups.facades_of("office") == groups.facades["other"][1]
    assert groups.facades_of("villa", "mediterranean") == groups.style_facades["mediterranean"]
    assert groups.facades_of("villa", "modern") == groups.facades_of("villa")
    assert groups.filler_of("worship") == groups.filler["other"]


@pytest.mark.parametrize("kind", ["house", "penthouse", "apartment_building", "tree house", "apartment building"])
def test_people_live_in_homes_and_in_blocks_of_flats(kind: str) -> None:
    assert default_knowledge().is_dwelling(kind)


@pytest.mark.parametrize("kind", ["media_house", "nursing home", "opera_house", "office", "hotel"])
def test_a_building_whose_name_sounds_like_a_home_is_none(kind: str) -> None:
    assert not default_knowledge().is_dwelling(kind)


def test_a_users_folder_extends_the_groups_of_building_types(tmp_path: Path) -> None:
    (tmp_path / "building_groups.toml").write_text('[facade.igloo]\nwords = ["igloo"]\nmaterials = ["white_render"]\n')
    groups = load_knowledge([tmp_path]).groups
    assert groups.facades_of("family_igloo") == ("white_render",)
    assert groups.filler == default_knowledge().groups.filler


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ('[filler]\nhome = ["nowhere"]\n', "'nowhere'"),
        ('[filler]\ncastle = ["storage"]\n', "'castle'"),
        ('[facade.igloo]\nwords = ["igloo"]\n', "materials"),
    ],
)
def test_faulty_groups_are_named(tmp_path: Path, text: str, fault: str) -> None:
    (tmp_path / "building_groups.toml").write_text(text)
    with pytest.raises(MansionError, match=fault):
        load_knowledge([tmp_path])


@pytest.mark.parametrize(
    ("row", "fault"),
    [
        ("x,,9,6,20,service,ground,,,concrete,", "least <= usual"),
        ("x,,3,6,20,secret,ground,,,concrete,", "'secret'"),
        ("x,,3,6,20,service,ground,,shiny,concrete,", "'shiny'"),
        ("x,,three,6,20,service,ground,,,concrete,", "three"),
        ("x,,3,6,20,service,ground,nowhere,,concrete,", "'nowhere'"),
    ],
)
def test_faulty_records_are_named(tmp_path: Path, row: str, fault: str) -> None:
    (tmp_path / "room_types.csv").write_text(HEADER + row + "\n")
    with pytest.raises(MansionError, match=fault):
        load_knowledge([tmp_path])


def test_a_missing_folder_is_named(tmp_path: Path) -> None:
    with pytest.raises(MansionError, match="no knowledge folder"):
        load_knowledge([tmp_path / "absent"])


def test_entries_are_parsed_or_refused() -> None:
    assert parse_entry("classroom:54 x3 +").count == 3
    with pytest.raises(ValueError, match="not of the form"):
        parse_entry("Class Room x")
