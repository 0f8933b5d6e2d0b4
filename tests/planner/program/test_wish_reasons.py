"""The ledger says what is planned in the place of a room or a building that is another thing."""

import pytest

from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building


def reasons(text: str) -> dict[str, str]:
    wishes = plan_building(BuildRequest(description=text)).program.wishes
    return {wish.text: wish.reason for wish in wishes if wish.kind in ("room", "building_type")}


@pytest.mark.parametrize(
    ("text", "room"),
    [
        ("A villa with a car gallery and two bedrooms", "car gallery"),
        ("A university with a phonetics lab", "phonetics lab"),
        ("An aquarium with three galleries (coral, jellyfish, freshwater)", "coral"),
        ("A data centre with a UPS room", "UPS room"),
        ("A funeral home with a coffin showroom", "coffin showroom"),
        ("A clinic with a nurse room", "nurse room"),
        ("A hair salon with two tattoo cabins", "two tattoo cabins"),
        ("A loft with a single open space of 60 m2", "single open space"),
        ("A flat with two bedrooms, each with a den", "den"),
        ("A rescue centre with a bird nursery", "bird nursery"),
    ],
)
def test_a_room_that_stands_in_for_another_is_told_of(text: str, room: str) -> None:
    assert "planned and furnished like" in reasons(text)[room]


@pytest.mark.parametrize(
    ("text", "room"),
    [
        ("A house with a mudroom", "mudroom"),
        ("A rescue centre with a bird ward", "bird ward"),
        ("A hostel with 6 private rooms and 4 family rooms", "6 private rooms"),
        ("A museum with an art gallery", "art gallery"),
        ("A brewery with a barrel room", "barrel room"),
        ("A veterinary clinic with two theatres", "two theatres"),
        ("A care home with a living-kitchen", "living-kitchen"),
        ("A library with a story room", "story room"),
    ],
)
def test_a_room_that_is_what_its_name_says_is_not(text: str, room: str) -> None:
    assert reasons(text)[room] == ""


def test_a_tattoo_studio_is_told_to_be_planned_like_a_hair_salon() -> None:
    assert "hair salon" in reasons("Tattoo studio, 70 m2")["Tattoo studio"]


def test_an_accessible_toilet_of_a_list_is_one() -> None:
    program = plan_building(
        BuildRequest(description="A station with three toilets: ladies, gents, accessible.")
    ).program
    kinds = [wish.value.type for wish in program.wishes if wish.value.name == "accessible_toilet"]
    assert kinds == ["accessible_toilet"]


@pytest.mark.parametrize(
    ("text", "kind", "words"),
    [
        (
            "A school. The carpentry shop has a bench, the hairdressing one ten salon chairs.",
            "object",
            "hairdressing one",
        )
    ],
)
def test_what_was_not_understood_beside_a_statement_is_told_with_it(text: str, kind: str, words: str) -> None:
    wishes = plan_building(BuildRequest(description=text)).program.wishes
    assert any(words in " ".join(wish.value.unheeded) for wish in wishes if wish.kind == kind)


def test_an_area_above_ground_leaves_the_basement_out() -> None:
    text = "An office of seven storeys, 2800 m2 above ground. Below ground: parking."
    program = plan_building(BuildRequest(description=text)).program
    assert sum(floor.gross_floor_area for floor in program.floors if floor.index >= 1) == pytest.approx(2800, rel=0.1)
    assert next(wish.scope.floors for wish in program.wishes if wish.kind == "total_area") == [1, 2, 3, 4, 5, 6, 7]
