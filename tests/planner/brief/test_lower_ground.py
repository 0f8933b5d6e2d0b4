"""The lower ground floor is the basement, in short as well; storeys are told by the one that they lie above."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.plan import plan_building


def _facts(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


def _storeys_of(text: str) -> dict[str, list[int]]:
    """Return the storeys that the wishes for rooms of a planned brief name."""
    wishes = plan_building(BuildRequest(description=text)).program.wishes
    return {wish.value.name: wish.scope.floors for wish in wishes if wish.kind == "room"}


@pytest.mark.parametrize(
    "text",
    [
        "A gym on three levels. Lower ground: a sauna. Ground: reception",
        "A townhouse with the sauna on the lower ground floor and the kitchen on the ground floor",
        "An office with a lower ground floor (LG) holding the sauna, the cafe on the ground floor",
        "LG: sauna and plant room. G: lobby and shop. 1-3: two flats each",
        "LG/F: sauna; G/F: shop; 1/F: offices",
        "An office with a basement for the sauna; reception on the ground floor",
        "A house with a cellar containing a sauna, two bedrooms upstairs",
    ],
)
def test_rooms_of_the_lower_ground_floor_lie_in_the_basement(text: str) -> None:
    assert _storeys_of(text)["sauna"] == [0]


def test_the_floors_above_it_keep_their_numbers() -> None:
    assert _storeys_of("LG: sauna. G: lobby and shop. 1-3: two flats each")["flat"] == [2, 3, 4]


def test_a_cellar_for_people_is_where_nobody_lives() -> None:
    facts = _facts("We search a house with cellar for four persons, two floors")
    assert [people.count for people in facts.occupants] == [4]


def test_a_style_of_that_name_is_no_storey() -> None:
    assert not _facts("A house in LG style with three bedrooms").basements


@pytest.mark.parametrize(
    ("text", "storey"),
    [
        ("A lab, two floors. On ground floor: reception. On first floor, above the ground floor: sauna", 2),
        ("A house of three storeys. On the first floor, so directly above ground floor, is a sauna", 2),
        ("A house: the first floor (directly above the ground floor) has a sauna, the ground floor a kitchen", 2),
        ("An institute with three storeys; on the third floor, the highest, a sauna", 3),
        ("A hotel with the sauna on the first floor. The bar is on the second floor", 1),
    ],
)
def test_what_tells_a_storey_by_another_names_one_storey(text: str, storey: int) -> None:
    assert _storeys_of(text)["sauna"] == [storey]


@pytest.mark.parametrize(
    ("text", "floors"),
    [
        (
            "A hotel: a ground floor and three bedroom storeys over it. The bedroom storeys have ten rooms each",
            [2, 3, 4],
        ),
        ("An office with a ground floor and three floors above. The three floors are the same: ten offices", [2, 3, 4]),
        ("A hotel with ground floor and two guest floors. The guest floors are identical: ten rooms each", [2, 3]),
        ("A hotel of 4 floors. Floors 2 to 4 are identical, each with ten rooms", [2, 3, 4]),
        ("A hotel with two floors. The two floors have ten rooms each", [1, 2]),
    ],
)
def test_storeys_above_the_ground_floor_are_spoken_of_together(text: str, floors: list[int]) -> None:
    wishes = plan_building(BuildRequest(description=text)).program.wishes
    rooms = next(wish for wish in wishes if wish.kind == "room" and wish.value.count == 10)
    assert (rooms.scope.floors, rooms.scope.each) == (floors, True)


@pytest.mark.parametrize(
    "text",
    [
        "Villa of two floors. Upstairs four bedrooms. The laundry makes noise, so put it on the ground floor",
        "House of two storeys. A laundry too, but keep it downstairs. Three bedrooms upstairs",
    ],
)
def test_a_room_named_before_is_put_somewhere(text: str) -> None:
    assert _storeys_of(text)["laundry"] == [1]


def test_what_toilets_are_kept_away_from_does_not_place_them() -> None:
    text = (
        "A library on three floors. At the third floor a depot, that must not be adjacent to the toilets. "
        "The toilets are at every floor."
    )
    assert _storeys_of(text)["toilet"] == [1, 2, 3]
