"""Entries of lists: their numbers, the counts after a dash or a colon, and words that are no rooms."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


def test_numbers_of_the_lines_of_a_list_are_no_statements() -> None:
    facts = read("A bank.\n1. Lobby\n2. Vault\n3. Consultation rooms: 3, near the lobby\n")
    assert not {"1", "2", "3"} & {span.words for span in facts.unread}
    assert [(room.name, room.count) for room in facts.rooms] == [("lobby", 1), ("vault", 1), ("consultation_room", 3)]


@pytest.mark.parametrize("entry", ["rooms: 3, next to the lobby", "rooms - 3", "rooms – 3"])
def test_a_count_may_stand_after_a_dash_or_a_colon(entry: str) -> None:
    facts = read(f"A police station with a lobby, interview {entry}.")
    assert [room.count for room in facts.rooms if room.name == "interview_room"] == [3]


@pytest.mark.parametrize(
    ("text", "rooms"),
    [
        ("A restaurant for 50 diners with a kitchen.", ["kitchen"]),
        ("A call centre, 24/7 site, with a lobby.", ["lobby"]),
        ("We thought around 140 square metres for our bungalow with a study.", ["study"]),
        ("A health centre, 1 st., with a lobby.", ["lobby"]),
    ],
)
def test_people_and_asides_are_no_rooms(text: str, rooms: list[str]) -> None:
    assert [room.name for room in read(text).rooms] == rooms


def test_a_later_number_may_take_back_one_of_an_earlier_clause() -> None:
    facts = read("An office of three storeys, no wait, the board approved another one, so make that four.")
    assert [quantity.value for quantity in facts.floors] == [4.0]


def test_lines_may_begin_with_codes_of_storeys() -> None:
    facts = read(
        "An office, 6 storeys.\n00 Reception; post room.\n01-04 typical: 8 no. offices; print room.\n"
        "05 Boardroom; lounge.\n"
    )
    storeys = {room.name: [(ref.first, ref.last) for ref in room.floors] for room in facts.rooms}
    assert storeys["post_room"] == [(1, 1)]
    assert storeys["print_room"] == [(number, number) for number in (2, 3, 4, 5)]
    assert storeys["boardroom"] == storeys["lounge"] == [(6, 6)]
    assert {room.name: room.count for room in facts.rooms}["boardroom"] == 1


def test_numbers_of_identical_storeys_may_open_a_sentence() -> None:
    facts = read("An 8 storey hotel. Lobby on ground. 2-8 identical, 8 guest rooms each.")
    rooms = next(room for room in facts.rooms if room.name == "guest_room")
    assert [(ref.first, ref.last) for ref in rooms.floors] == [(number, number) for number in range(2, 9)]


def test_where_a_thing_may_never_be_is_no_room_that_is_not_wanted() -> None:
    facts = read("A villa with three bedrooms and a TV in the living room, never in a bedroom.")
    assert facts.excluded == []
    assert [(room.name, room.count) for room in facts.rooms][:1] == [("bedroom", 3)]


@pytest.mark.parametrize("text", ["Police station, 2 st., ca. 900 m2.", "A court, 2 st. + cellar.", "A lab with 2 st."])
def test_storeys_may_be_abbreviated(text: str) -> None:
    assert [quantity.value for quantity in read(text).floors] == [2.0]


def test_areas_after_a_colon_are_no_count() -> None:
    rooms = read("A school with rehearsal rooms: 60, 80 and 120 m².").rooms
    assert [(room.count, room.area) for room in rooms] == [(1, 60.0), (1, 80.0), (1, 120.0)]
