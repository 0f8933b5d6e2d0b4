"""Storeys that are named in short are read as if they were named in full."""

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


def storeys(text: str) -> dict[str, list[tuple[str, int]]]:
    """Return the storeys of each kind of room."""
    return {fact.room_type: [(ref.kind, ref.first) for ref in fact.floors] for fact in read(text).rooms}


def test_an_ordinal_alone_is_a_storey() -> None:
    found = storeys("A 3 storey house. Garage on ground. Living room on first. On second, two bedrooms.")
    assert found == {"garage": [("number", 1)], "living_room": [("number", 2)], "bedroom": [("number", 3)]}


def test_a_number_behind_a_storey_counts_what_was_named_before() -> None:
    rooms = read("A school. The ground floor has 6 classrooms, the upper floor 8.").rooms
    assert [(room.room_type, room.count, room.floors[0].kind) for room in rooms] == [
        ("classroom", 6, "number"),
        ("classroom", 8, "upper"),
    ]


def test_per_floor_behind_a_list_in_brackets_is_of_all_of_it() -> None:
    rooms = read("Student house with 3 floors (5 bedrooms, 2 bathrooms, 1 kitchen per floor).").rooms
    assert [(room.count, room.each) for room in rooms] == [(5, True), (2, True), (1, True)]


def test_the_side_of_the_ground_may_be_told_twice() -> None:
    found = storeys("A theatre with four dressing rooms. The dressing rooms lie below in the basement.")
    assert found["dressing_room"] == [("basement", 0)]


def test_a_storey_that_houses_rooms_is_no_house() -> None:
    facts = read("The ground floor of the school houses 6 classrooms.")
    assert [name for name, _ in facts.building] == ["school"]


def test_every_tenant_floor_is_an_upper_one() -> None:
    found = storeys("Office tower of six storeys for five tenants. Every tenant floor has two meeting rooms.")
    assert found["meeting_room"] == [("upper", 0)]


def test_all_of_a_list_may_be_placed_behind_it() -> None:
    found = storeys("Workshop: two storeys, a paint shop, a store and a wc, all downstairs; boss's office up.")
    assert {kind: refs[0] for kind, refs in found.items() if refs}.get("toilet") == ("number", 1)
    assert found["storage"] == [("number", 1)]
    assert found["private_office"][0][0] == "upper"


def test_each_of_several_storeys_may_have_no_noun() -> None:
    rooms = read("Training house with two identical storeys of 80 m2: each has a kitchen and a bedroom.").rooms
    assert [(room.room_type, room.each) for room in rooms] == [("kitchen", True), ("bedroom", True)]


def test_what_is_unwanted_on_a_storey_is_not_wanted_there() -> None:
    facts = read("A house of two floors with three bedrooms. No ground floor bedrooms.")
    assert [(name, ref.first) for name, ref, _ in facts.excluded_on] == [("bedroom", 1)]
    assert [room.count for room in facts.rooms] == [3]
