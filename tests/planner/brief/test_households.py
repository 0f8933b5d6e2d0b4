"""What a brief says that each flat, suite or other unit holds."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import RoomFact


def units(text: str) -> list[RoomFact]:
    return [fact for fact in read_brief(text, default_knowledge()).rooms if fact.unit]


def held(fact: RoomFact) -> dict[str, int | None]:
    return {child.room_type: child.count for child in fact.suite}


@pytest.mark.parametrize(
    "said",
    [
        "three flats per floor. Every flat has two bedrooms and a bathroom.",
        "three flats per floor, each with two bedrooms and a bathroom.",
        "three flats per floor with two bedrooms and a bathroom each.",
        "three flats per floor (each 2 bedrooms, 1 bath).",
        "three flats a floor, each of two bedrooms and a bathroom.",
        "three flats per floor; each has two bedrooms and a bathroom.",
        "three flats per floor. Each flat: two bedrooms, a bathroom.",
        "three flats per floor, two bedrooms and a bathroom in each flat.",
        "three two-bedroom flats per floor, each with a bathroom.",
        "three flats per floor, the flats consisting of two bedrooms and a bathroom.",
    ],
)
def test_the_rooms_of_each_flat_are_said_in_many_ways(said: str) -> None:
    flats = units(f"An apartment building of four storeys with {said}")
    assert [(fact.count, fact.each, held(fact)) for fact in flats] == [(3, True, {"bedroom": 2, "bathroom": 1})]


def test_kinds_of_flats_that_share_a_noun_are_told_apart() -> None:
    flats = units("A block of flats with one 1-bed and two 2-bed flats per storey, each with a kitchen.")
    found = {fact.name: (fact.count, held(fact)) for fact in flats}
    assert found == {
        "one_bed_flat": (1, {"bedroom": 1, "kitchen": 1}),
        "two_bed_flat": (2, {"bedroom": 2, "kitchen": 1}),
    }


def test_flats_of_other_storeys_keep_one_name() -> None:
    flats = units("Three storeys. Storey 2: two flats, two bedrooms each. Storey 3: one flat with four bedrooms.")
    assert [(fact.name, fact.floors[0].first, held(fact)["bedroom"]) for fact in flats] == [
        ("flat", 2, 2),
        ("flat", 3, 4),
    ]


def test_per_floor_means_the_storeys_that_its_clause_opens_with() -> None:
    (flats,) = units("A residential building of six storeys.\nFloors 2-5: four flats per floor (each 2 bedrooms).\n")
    assert [(ref.kind, ref.first, ref.last) for ref in flats.floors] == [("range", 2, 5)]


def test_a_room_of_the_house_ends_the_list_of_what_a_flat_holds() -> None:
    facts = read_brief(
        "A block of flats. Ground floor: one flat with a bedroom and a bathroom, and a laundry.", default_knowledge()
    )
    assert {fact.room_type for fact in facts.rooms} == {"apartment", "laundry_room"}


def test_a_linen_room_is_no_part_of_a_hotel_room() -> None:
    facts = read_brief(
        "A hotel with ten guest rooms, each having its own bathroom, and a linen room.", default_knowledge()
    )
    rooms = {fact.name: held(fact) for fact in facts.rooms}
    assert rooms == {"guest_room": {"bathroom": 1}, "linen_room": {}}


@pytest.mark.parametrize(
    "text",
    [
        "a flat with two bedrooms",
        "a brewery with a malt loft",
        "a house with a flat roof",
        "a store with three shelving units",
    ],
)
def test_neither_the_building_nor_other_nouns_are_units(text: str) -> None:
    assert units(text) == []


def test_every_flat_without_a_number_of_flats_is_kept_for_those_that_are_added() -> None:
    facts = read_brief("An apartment building. Every flat has three bedrooms.", default_knowledge())
    assert [(fact.count, held(fact)) for fact in facts.households] == [(None, {"bedroom": 3})]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (
            "On each upper floor one 3BHK flat is there: three bedrooms out of which two are with attached bathroom, a "
            "kitchen with utility adjoining, and one toilet. Two floors.",
            {"bedroom": 3, "bathroom": 2, "kitchen": 1, "utility_room": 1, "toilet": 1},
        ),
        (
            "Every floor has one flat with three bedrooms, of which one has its own bathroom, a study and a kitchen.",
            {"bedroom": 3, "bathroom": 1, "home_office": 1, "kitchen": 1},
        ),
        (
            "Each floor has one flat with three bedrooms out of which the master bedroom is having attached bathroom, "
            "a kitchen and a toilet.",
            {"bedroom": 2, "master_bedroom": 1, "bathroom": 1, "kitchen": 1, "toilet": 1},
        ),
    ],
)
def test_the_list_of_a_flat_goes_on_after_those_singled_out(text: str, expected: dict[str, int]) -> None:
    facts = read_brief(f"An apartment building. {text}", default_knowledge()).rooms
    found: dict[str, int] = {}
    for child in facts[0].suite:
        found[child.room_type] = found.get(child.room_type, 0) + (child.count or 0)
    assert (len(facts), found) == (1, expected)


@pytest.mark.parametrize("text", ["a flat roof", "a flat simple rectangular plan", "flat green roof", "a flat site"])
def test_what_is_flat_is_no_dwelling(text: str) -> None:
    assert units(f"A club house of two storeys with a bar, and {text}.") == []


@pytest.mark.parametrize("text", ["a flat with a roof terrace", "a flat with plan chests"])
def test_a_flat_beside_a_roof_or_a_plan_stays_one(text: str) -> None:
    assert len(units(f"A club house of two storeys with a bar, and {text}.")) == 1


def test_each_after_rooms_of_several_storeys_gives_them_no_others() -> None:
    facts = read_brief("Hostel. The three upper floors get five dorm rooms each and two showers.", default_knowledge())
    assert [(fact.name, fact.count, fact.suite) for fact in facts.rooms] == [("dorm_room", 5, ()), ("shower", 2, ())]


def test_every_room_after_several_speaks_of_them() -> None:
    facts = read_brief(
        "A hotel of two floors having five rooms each one, in every room a bed and its bathroom.", default_knowledge()
    )
    assert [(fact.name, held(fact)) for fact in facts.rooms] == [("room", {"bathroom": 1})]


@pytest.mark.parametrize(
    "text",
    [
        "Four bedrooms, every bedroom own bathroom, and a gym.",
        "Four bedrooms, each bedroom its own bathroom, and a gym.",
        "A gym, and four bedrooms, each bedroom with own bathroom.",
    ],
)
def test_own_after_every_room_gives_it_one_and_nothing_more(text: str) -> None:
    facts = read_brief(f"A house of two floors. {text}", default_knowledge())
    assert {fact.name: held(fact) for fact in facts.rooms} == {"bedroom": {"bathroom": 1}, "gym": {}}
