"""The rooms of a storey: their areas and their names."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.facts import RoomFact, Span
from mansion_planner.program.model import PlannedRoom
from mansion_planner.program.planned_rooms import planned_room
from mansion_planner.program.storey_rooms import fit_areas, name_rooms


def rooms(*names: str) -> list[PlannedRoom]:
    return [planned_room(default_knowledge().room(name), default_knowledge()) for name in names]


def stated(name: str, area: float) -> PlannedRoom:
    fact = RoomFact(name, name, Span(name, 0, len(name)), 1, area=area)
    return planned_room(default_knowledge().room(name), default_knowledge(), fact=fact)


@pytest.mark.parametrize("factor", [0.3, 0.9, 1.1, 3.0])
def test_rooms_fill_what_there_is_whatever_they_usually_have(factor: float) -> None:
    usual = rooms("kitchen", "bedroom", "bathroom", "living_room")
    capacity = factor * sum(room.gross for room in usual)
    assert sum(room.gross for room in fit_areas(usual, capacity)) == pytest.approx(capacity, abs=0.02)


def test_a_stated_area_stays() -> None:
    fitted = fit_areas([stated("kitchen", 31.0), *rooms("bedroom", "bathroom")], 60.0)
    assert fitted[0].area == 31.0


def test_fitting_leaves_the_rooms_that_it_is_given() -> None:
    usual = rooms("kitchen", "bedroom")
    before = [room.area for room in usual]
    fitted = fit_areas(usual, 200.0)
    assert [room.area for room in usual] == before and [room.area for room in fitted] != before


def test_rooms_of_one_name_are_numbered_and_one_alone_is_not() -> None:
    named = name_rooms(rooms("bedroom", "kitchen", "bedroom"), "hallway")
    assert [room.id for room in named] == ["bedroom_1", "kitchen", "bedroom_2"]


def test_a_room_called_as_the_hub_gets_a_number() -> None:
    assert [room.id for room in name_rooms(rooms("lobby"), "lobby")] == ["lobby_1"]


def test_the_rooms_of_a_suite_are_named_with_the_others() -> None:
    suites = rooms("hotel_room", "hotel_room")
    names = [part.id for room in name_rooms(suites, "corridor") for part in room.each()]
    assert len(suites[0].each()) > 1 and len(set(names)) == len(names)
