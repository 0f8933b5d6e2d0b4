"""Materials of floors and walls: what they are of, of which rooms they are said, and whether of all."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.brief.reader import read_brief


def _facts(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    ("text", "surface", "material", "room"),
    [
        ("A house with a kitchen. The kitchen has a black marble floor.", "floor", "black marble", "kitchen"),
        ("A flat with a kitchen with tiled floor and a bath", "floor", "tiled", "kitchen"),
        ("A flat. The kitchen walls in blue.", "wall", "blue", "kitchen"),
        ("A hotel. The floor of the lobby is black marble.", "floor", "black marble", "lobby"),
        ("The kitchen has a stove, terracotta tiles on the floor and a sink", "floor", "terracotta tiles", "kitchen"),
        ("A flat whose bedrooms have carpet", "floor", "carpet", "bedroom"),
        ("An office. Colour of the walls: light grey.", "wall", "light grey", ""),
        ("An office, the floors are oak", "floor", "oak", ""),
        ("A house. Walls all white color.", "wall", "white", ""),
        ("A flat with oak floors in the flat", "floor", "oak", ""),
    ],
)
def test_a_material_is_of_the_room_that_it_is_said_of(text: str, surface: str, material: str, room: str) -> None:
    facts = _facts(text)
    (fact,) = facts.materials
    assert (fact.surface, fact.material, fact.room_type) == (surface, material, room)
    assert not facts.unread


def test_a_material_of_several_rooms_is_of_each() -> None:
    facts = _facts("A flat with wooden floors in the living room and the bedroom")
    assert [fact.room_type for fact in facts.materials] == ["living_room", "bedroom"]


def test_a_second_material_goes_on_with_the_room_of_the_first() -> None:
    facts = _facts("A kitchen with a tiled floor and red walls")
    assert [(fact.surface, fact.room_type) for fact in facts.materials] == [("floor", "kitchen"), ("wall", "kitchen")]


@pytest.mark.parametrize(
    ("text", "throughout"),
    [
        ("A house with oak floors throughout", True),
        ("A house with white walls everywhere", True),
        ("A house. All walls should be white.", True),
        ("A house with oak floors and a kitchen", False),
    ],
)
def test_throughout_means_every_room(text: str, throughout: bool) -> None:
    (fact,) = _facts(text).materials
    assert (fact.throughout, fact.room_type) == (throughout, "")


def test_a_floor_may_be_called_by_its_own_name() -> None:
    facts = read_brief("A house with a lounge with oak parquet, and a study", default_knowledge())
    assert [(fact.surface, fact.material, fact.room_type) for fact in facts.materials] == [
        ("floor", "oak parquet", "lounge")
    ]
