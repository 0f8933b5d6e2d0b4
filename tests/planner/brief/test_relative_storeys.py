"""Storeys that are told from another one lie above that one, and what each of them has is counted on each."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.plan import plan_building


@pytest.mark.parametrize(
    ("text", "floors"),
    [
        ("A hotel with five floors. Each of the four floors above the ground floor has eight bedrooms", [2, 3, 4, 5]),
        ("A hostel with 4 storeys. Lobby at street level, on each of the three storeys above it a bedroom", [2, 3, 4]),
        ("A shop at ground level and on each of the three levels overhead two bedrooms", [2, 3, 4]),
        ("Clinic on 3 floors. Entrance level: lobby. Each of the two levels over it: six bedrooms", [2, 3]),
        ("School, three storeys. Every one of the two upper storeys has five bedrooms", [2, 3]),
        ("Hotel, three storeys, the two storeys above the lobby floor have 6 bedrooms each", [2, 3]),
        (
            "A hotel of five storeys. The second floor has a gym. Each of the three storeys above it: a bedroom",
            [3, 4, 5],
        ),
        ("A house with 3 floors. First floor: lobby. On all floors above the first: a bedroom", [2, 3]),
        ("A hospital with a basement; each of the three floors above ground has a bedroom", [1, 2, 3]),
        ("A 4-storey house: a cafe on the ground floor, a bedroom on each of the three further floors", [2, 3, 4]),
        ("A car park of 6 storeys; each level over the entrance level has a bedroom", [2, 3, 4, 5, 6]),
    ],
)
def test_what_each_storey_above_has_is_on_those(text: str, floors: list[int]) -> None:
    program = plan_building(BuildRequest(description=text)).program
    wish = next(wish for wish in program.wishes if wish.value.name == "bedroom")
    assert (wish.scope.floors, wish.scope.each) == (floors, True)


def test_the_words_that_tell_the_storeys_are_read() -> None:
    text = "A hotel with five floors. Each of the four floors above has eight guest rooms"
    assert read_brief(text, default_knowledge()).unread == []


def test_an_area_after_above_is_no_storey() -> None:
    facts = read_brief("A house. All floors above 30 m2 have a bedroom", default_knowledge())
    assert [ref.kind for room in facts.rooms for ref in room.floors] == ["every"]


@pytest.mark.parametrize(
    ("text", "room", "floors"),
    [
        ("Gym. A climbing hall on the ground floor. Above the ground floor is one more floor: a sauna.", "sauna", [2]),
        ("Museum, three floors. The foyer is on the ground floor; over the first floor is an archive.", "archive", [3]),
        ("Clinic with a pharmacy downstairs. Above the pharmacy we want four exam rooms.", "exam_room", [2]),
        ("Two storeys. Downstairs a bakery with a shop. Over the bakery I live: kitchen, bath.", "kitchen", [2]),
        ("House, two floors. On the ground floor a garage. Above the garage there is a studio.", "studio", [2]),
        ("Library, two floors. On first floor, above the ground floor: gallery. Ground floor: cafe.", "gallery", [2]),
        ("Practice. The archive and a staff room can go down in the basement.", "staff_room", [0]),
        ("Club of two storeys. The boat hall (160 m2) has to be at water level. Upstairs a bar.", "boat_hall", [1]),
    ],
)
def test_what_lies_above_something_is_on_the_storey_above(text: str, room: str, floors: list[int]) -> None:
    program = plan_building(BuildRequest(description=text)).program
    assert [f.index for f in program.floors if any(r.id.startswith(room) for r in f.rooms)] == floors


@pytest.mark.parametrize(
    "text",
    [
        "School. On the ground floor a canteen. Above the kitchen counter hang three lamps. Two floors.",
        "House of two floors. On the ground floor a kitchen. Above the fireplace a painting.",
    ],
)
def test_what_hangs_above_furniture_tells_no_storey(text: str) -> None:
    reading = read_brief(text, default_knowledge())
    assert all(ref.kind != "upper" for thing in reading.objects for ref in thing.floors)
