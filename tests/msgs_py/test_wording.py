"""Messages name what would be accepted, and read as sentences."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mansion_msgs_py.wording import choices, counted, nearest, with_article


@pytest.mark.parametrize(
    ("words", "spoken"),
    [
        ("orange toolbox", "an orange toolbox"),
        ("armchair", "an armchair"),
        ("Office", "an Office"),
        ("umbrella", "an umbrella"),
        ("urn", "an urn"),
        ("university", "a university"),
        ("unisex toilet", "a unisex toilet"),
        ("utility room", "a utility room"),
        ("one-storey house", "a one-storey house"),
        ("hourglass", "an hourglass"),
        ("house", "a house"),
        ("", "a "),
    ],
)
def test_the_article_is_as_spoken(words: str, spoken: str) -> None:
    assert with_article(words) == spoken


def test_one_is_not_in_the_plural() -> None:
    assert counted(1, "wish", "wishes") == "1 wish"
    assert [counted(n, "room") for n in (0, 1, 2)] == ["0 rooms", "1 room", "2 rooms"]


def test_a_name_with_a_part_left_out_or_a_slip_finds_what_was_meant() -> None:
    assert nearest("floor", ["direction", "target_floor", "token"])[0] == "target_floor"
    assert nearest("cafetria", ["F1/lobby", "F1/cafeteria", "F2/office"])[0] == "F1/cafeteria"
    assert choices("targetfloor", ["target_floor"], "fields").startswith("did you mean target_floor?")


def test_a_shared_folder_makes_no_likeness() -> None:
    services = ["/mansion/skills/toggle_on", "/mansion/skills/move_to", "/other/x"]
    assert choices("/mansion/skills/teleport", services, "services").startswith("services: ")
    assert choices("/mansion/skills/togle_on", services, "services").startswith(
        "did you mean /mansion/skills/toggle_on?"
    )


def test_names_of_the_same_folder_come_before_those_that_share_its_first_part() -> None:
    services = ["/mansion/solve_floor", "/mansion/skills/follow", "/mansion/skills/go_to"]
    assert nearest("/mansion/skills/foo", services)[0] == "/mansion/skills/follow"
    assert "solve_floor?" not in choices("/mansion/skills/foo", services, "services")
    said = choices("/mansion/skills/solve_floor", services, "services")
    assert said.startswith("did you mean /mansion/solve_floor?")


def test_what_resembles_nothing_gets_no_guess() -> None:
    assert choices("xyz", ["lobby", "office"], "rooms") == "rooms: lobby, office"
    assert choices(7, ["lobby", "office"], "rooms") == "rooms: lobby, office"


def test_of_many_the_nearest_and_their_number_are_shown() -> None:
    said = choices("room_15", [f"F1/room_{n}" for n in range(100)], "rooms")
    assert said.startswith("did you mean F1/room_15? the nearest of 100 rooms: F1/room_15, ")
    assert len(said) < 200
    said = choices(None, [f"F1/room_{n}" for n in range(100)], "rooms")
    assert said.startswith("100 rooms, among them F1/room_0, ")


@settings(deadline=None, max_examples=60)
@given(st.text(max_size=500), st.lists(st.text(min_size=1, max_size=30), max_size=30))
def test_any_name_gets_an_answer_that_is_short(wanted: str, known: list[str]) -> None:
    said = choices(wanted, known, "names")
    assert "names" in said and len(said) < 800
    assert set(nearest(wanted, known)) <= set(known)


@settings(deadline=None, max_examples=100)
@given(
    st.text("abcF12_/", max_size=12),
    st.lists(st.text("abcF12_/", min_size=1, max_size=12), max_size=40, unique=True),
    st.integers(1, 8),
)
def test_the_nearest_are_those_of_all_in_order(wanted: str, known: list[str], count: int) -> None:
    assert nearest(wanted, known, count) == nearest(wanted, known, max(len(known), 1))[:count]
