"""How many a room is for: for each of several, in covers, and told where nothing stands there for them."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def _facts(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    ("text", "room", "count", "each"),
    [
        ("Hostel with 6 dormitories for 4 persons each and a kitchen", "dormitory", 4, True),
        ("Barracks with two dormitories for 12 soldiers each", "dormitory", 12, True),
        ("A college with two lecture rooms, each for 40 students", "lecture_room", 40, True),
        ("Conference centre: three seminar rooms (20 people each), one hall", "seminar_room", 20, True),
        ("A college with a canteen for 60 staff", "canteen", 60, False),
        ("A hotel with a restaurant seating 60 which adjoins its kitchen", "restaurant", 60, False),
        ("An office with a reception, an open plan for 40 people and a kitchen", "open_plan_office", 40, False),
    ],
)
def test_as_many_seats_or_beds_stand_in_the_room(text: str, room: str, count: int, each: bool) -> None:
    assert [(fact.room, fact.count, fact.each) for fact in _facts(text).objects] == [(room, count, each)]


@pytest.mark.parametrize(
    "text", ["A courthouse with cells for four detainees", "A hall with a cloakroom for 80 guests"]
)
def test_users_that_nothing_is_made_of_are_told(text: str) -> None:
    assert any("detainees" in span.words or "guests" in span.words for span in _facts(text).unread)


@pytest.mark.parametrize(
    ("text", "noun", "count"),
    [
        ("Restaurant with 80 covers, a kitchen and a bar", "covers", 80),
        ("A bistro, 45 covers inside, one storey", "covers", 45),
        ("Start-up office, open plan, 30 desks, two meeting rooms", "desks", 30),
        ("Law firm: reception, open-plan with 16 workstations", "workstations", 16),
    ],
)
def test_covers_and_desks_of_an_open_plan_are_furniture(text: str, noun: str, count: int) -> None:
    facts = _facts(text)
    assert [(fact.count, noun in fact.words) for fact in facts.objects] == [(count, True)]
    assert facts.unread == []


def test_an_open_plan_kitchen_is_no_office() -> None:
    rooms = _facts("A loft with an open plan kitchen, two desks in the study").rooms
    assert not any(room.room_type == "open_office" for room in rooms)


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("A hall, men's, women's and accessible toilets", ["man_toilet", "woman_toilet", "accessible_toilet"]),
        ("A hall with ladies', gents' and disabled toilets", ["lady_toilet", "gentleman_toilet", "accessible_toilet"]),
        ("Pub: bar, ladies / gents, kitchen", ["lady_toilet", "gentleman_toilet"]),
        ("An office with male/female toilets", ["man_toilet", "woman_toilet"]),
        ("Sports hall: men's, women's and referees' changing rooms",
         ["man_changing_room", "woman_changing_room", "referee_changing_room"]),
    ],
)  # fmt: skip
def test_users_before_a_noun_have_a_room_each(text: str, names: list[str]) -> None:
    rooms = {room.name: room.count for room in _facts(text).rooms}
    assert [rooms.get(name) for name in names] == [1] * len(names)


def test_gents_that_a_room_is_for_are_no_toilet() -> None:
    assert [room.name for room in _facts("A mosque with a prayer hall of 250 m2 for gents").rooms] == ["prayer_hall"]


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("A prison with a cell block of 20 cells and a mess hall", 20),
        ("A prison with two cell blocks of ten cells each", 20),
        ("A prison. One cell block with two levels: 15 cells", 15),
        ("A police station with a cell block", None),
    ],
)
def test_a_block_is_as_many_rooms_as_are_counted_in_it(text: str, count: int | None) -> None:
    facts = _facts(text)
    assert [room.count for room in facts.rooms if room.room_type == "holding_cell"] == [count]
    assert not any("block" in span.words for span in facts.unread)
