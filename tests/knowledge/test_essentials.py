"""What rooms cannot be used without: stated for every room type, in things that the catalogue's words can name."""

import tomllib
from importlib.resources import files

import pytest

from mansion_knowledge import default_knowledge
from mansion_knowledge.essentials import needs_of, pieces_there, still_wanted

PASSED_THROUGH = {"hallway", "corridor", "lobby", "elevator_lobby", "atrium", "ballroom", "stage"}
LOOKED_AT = {"cinema_lobby", "museum_lobby", "school_lobby", "ship_hall"}


def test_every_room_type_but_those_whose_floor_is_used_needs_something() -> None:
    without = {name for name in default_knowledge().rooms if not needs_of(name)}
    assert without == PASSED_THROUGH


def test_rooms_that_building_or_name_furnishes_otherwise_need_something_too() -> None:
    text = files("mansion_knowledge").joinpath("data", "furnished_as.toml").read_text(encoding="utf-8")
    kinds = {rule["as"] for rule in tomllib.loads(text)["rule"]}
    assert {kind for kind in kinds if not needs_of(kind)} == LOOKED_AT
    assert [need.name for need in needs_of("restroom_with_urinals")] == ["toilet", "washbasin"]


@pytest.mark.parametrize(
    ("room_type", "names", "needs"),
    [
        ("bathroom", (), ["toilet", "washbasin", "shower or bathtub"]),
        ("bathroom", ("Shower Room 2",), ["shower"]),
        ("toilet", ("wc",), ["toilet", "washbasin"]),
        ("kitchen", (), ["cooker", "sink"]),
        ("private_office", (), ["desk or counter", "seat"]),
        ("no_such_type", (), []),
    ],
)
def test_a_room_needs_what_its_name_says_and_else_what_its_type_does(
    room_type: str, names: tuple[str, ...], needs: list[str]
) -> None:
    assert [need.name for need in needs_of(room_type, names)] == needs


@pytest.mark.parametrize(
    ("beds", "sleepers"),
    [
        ([("bed", 0.8)], 1),
        ([("bed", 1.4)], 2),
        ([("bed", 2.1)], 2),
        ([("single_bed", 0.95), ("single_bed", 0.95)], 2),
        ([("bunk_bed", 1.0)], 2),
        ([("sofa", 2.0)], 0),
    ],
)
def test_a_bed_is_for_as_many_as_it_is_wide(beds: list[tuple[str, float]], sleepers: int) -> None:
    (need,) = needs_of("master_bedroom")
    assert need.count == 2
    assert pieces_there(need, beds) == sleepers


def test_what_a_brief_does_not_want_is_not_needed() -> None:
    bathroom = needs_of("bathroom")
    assert [need.name for need in still_wanted(bathroom, ["toilet"])] == ["washbasin", "shower or bathtub"]
    assert len(still_wanted(bathroom, ["bathtub"])) == 3
