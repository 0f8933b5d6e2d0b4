"""Storeys that the order of a brief tells."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.plan import plan_building


def storeys_of(text: str, room: str) -> list[int]:
    """Return the storeys that the plan has a room of that name on."""
    program = plan_building(BuildRequest(description=text)).program
    return [floor.index for floor in program.floors if any(entry.id.startswith(room) for entry in floor.rooms)]


@pytest.mark.parametrize(
    ("text", "room", "storeys"),
    [
        ("House of four storeys. At the top: a library. One down, a music room.", "music_room", [3]),
        ("House of four storeys. At the top: a library. One down, a gym. Below that, two studies.", "study", [2]),
        ("House of three storeys. From the bottom: garage, kitchen, bedroom.", "kitchen", [2]),
        ("House of three storeys. From the bottom: garage, kitchen, bedroom.", "bedroom", [3]),
        (
            "Five-storey office. Ground floor: cafe. Top floor: boardroom. The rest have an archive.",
            "archive",
            [2, 3, 4],
        ),
        ("Six-storey office. The bottom two are retail. The next three have an archive each.", "archive", [3, 4, 5]),
        ("Hotel. GF: lobby. 1F: spa. 2F: gym. Three storeys.", "spa", [2]),
        ("Clinic.\nGround - lobby\n1st - laboratory\n2nd - archive", "archive", [3]),
        ("Office, three storeys. Level 0: cafe. Level 1: archive. Level 2: gym.", "archive", [2]),
        ("G+3 office. Ground: cafe. Floors 1-2: archive. 3rd floor: gym.", "gym", [4]),
        ("Museum of three floors. The lowest has a cafe, the uppermost has an archive.", "archive", [3]),
        ("Villa with two floors. Below we want a gym. Above there are three bedrooms.", "gym", [1]),
    ],
)
def test_a_storey_is_told_from_the_one_before(text: str, room: str, storeys: list[int]) -> None:
    assert storeys_of(text, room) == storeys


def test_storeys_above_a_shop_come_on_top_of_it() -> None:
    facts = read_brief(
        "A shop on the ground floor. Above it come four storeys with two flats each.", default_knowledge()
    )
    assert facts.floors[0].value == 5


def test_rooms_that_are_on_some_storeys_only_are_on_no_other() -> None:
    text = "Five-storey department store. Toilets on the odd floors only."
    program = plan_building(BuildRequest(description=text)).program
    having = [f.index for f in program.floors if any(r.room_type in ("toilet", "restroom") for r in f.rooms)]
    assert having == [1, 3, 5]


def test_a_ground_storey_and_one_upper_storey_are_two() -> None:
    text = "Mountain hut. Ground storey: dining room, kitchen. Upper storey: four dormitories."
    assert len(plan_building(BuildRequest(description=text)).program.floors) == 2
