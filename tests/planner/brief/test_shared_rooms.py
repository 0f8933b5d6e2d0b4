"""A room that is for several uses is one room."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.plan import plan_building


@pytest.mark.parametrize(
    ("text", "name", "kind"),
    [
        ("A 40 m2 flat: one room for living and sleeping, a bathroom", "living_and_sleeping_room", "studio_room"),
        (
            "A cabin with a single room for cooking, eating and sleeping",
            "cooking_and_eating_and_sleeping_room",
            "bedroom",
        ),
        ("An apartment with a combined living and dining room", "living_and_dining_room", "living_room"),
        ("A flat with a kitchen and dining room in one", "kitchen_and_dining_room", "open_kitchen"),
        ("A flat with a living room that also serves as a bedroom", "living_and_bedroom_room", "studio_room"),
        ("A studio flat with a living and sleeping room", "living_and_sleeping_room", "studio_room"),
    ],
)
def test_several_uses_make_one_room(text: str, name: str, kind: str) -> None:
    facts = read_brief(text, default_knowledge())
    rooms = [(room.name, room.room_type) for room in facts.rooms if room.room_type not in ("bathroom",)]
    assert rooms == [(name, kind)]
    assert facts.unread == []


def test_rooms_that_are_only_listed_stay_apart() -> None:
    facts = read_brief("A flat with a kitchen and a dining room, living room and bedroom", default_knowledge())
    assert [room.room_type for room in facts.rooms] == ["kitchen", "dining_room", "living_room", "bedroom"]


def test_a_flat_of_one_room_has_no_bedroom_beside() -> None:
    program = plan_building(
        BuildRequest(description="A 40 m2 flat: one room for living and sleeping, a kitchen")
    ).program
    kinds = [room.room_type for floor in program.floors for room in floor.rooms]
    assert "studio_room" in kinds
    assert not {"bedroom", "living_room"} & set(kinds)


@pytest.mark.parametrize(
    "text",
    [
        "A primary school with four classrooms and a hall of 150 m2 used both for gym and for assemblies.",
        "A community centre with a hall that is also used as a cinema and theatre, and four classrooms.",
    ],
)
def test_what_a_room_is_used_for_is_no_room(text: str) -> None:
    facts = read_brief(text, default_knowledge())
    assert {room.room_type for room in facts.rooms} <= {"classroom", "assembly_hall", "hallway"}
    assert not facts.unread
