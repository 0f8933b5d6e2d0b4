"""Areas that rooms and corridors are to have where the floor solver finds their places."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.facts import RoomFact, Span
from mansion_planner.program.model import Corridor, Placement, PlannedRoom, Sketch, loosened
from mansion_planner.program.planned_rooms import planned_room


def room(name: str, area: float | None = None) -> PlannedRoom:
    fact = RoomFact(name, name, Span(name, 0, len(name)), 1, area=area)
    return planned_room(default_knowledge().room(name), default_knowledge(), fact=fact)


def sketch(corridor: float, *rooms: PlannedRoom) -> Sketch:
    """Return a sketch of 200 m2 that gives a corridor so much, and its rooms equal shares of the rest."""
    share = (200.0 - corridor) / len(rooms)
    places = [Placement(each, [(0.0, 0.0, share, 1.0)], "corridor") for each in rooms]
    return Sketch([Corridor("corridor", [(0.0, 0.0, corridor, 1.0)])], places)


def areas(made: Sketch) -> dict[str, float]:
    return {c.id: c.area for c in made.corridors} | {p.room.id: p.area for p in made.rooms}


def test_corridors_give_way_to_stated_areas() -> None:
    found = areas(loosened(sketch(90.0, room("warehouse", 140.0), room("private_office"))))
    office = default_knowledge().room("private_office")
    assert found["warehouse"] == 140.0
    assert found["private_office"] >= office.least and found["corridor"] < 60.0
    assert sum(found.values()) == pytest.approx(200.0)


def test_corridors_keep_what_they_have_where_the_rest_is_enough() -> None:
    found = areas(loosened(sketch(40.0, room("warehouse", 120.0), room("private_office"))))
    assert found["corridor"] == pytest.approx(40.0) and found["private_office"] == pytest.approx(40.0)


def test_corridors_are_left_a_share_of_a_storey_that_the_rooms_overfill() -> None:
    found = areas(loosened(sketch(60.0, room("warehouse", 195.0), room("private_office"))))
    assert found["corridor"] / found["warehouse"] == pytest.approx(0.12 * 200.0 / 195.0)
    assert sum(found.values()) == pytest.approx(200.0)


def test_narrow_corridors_are_widened() -> None:
    assert areas(loosened(sketch(2.0, room("private_office"), room("storage"))))["corridor"] == pytest.approx(10.0)
