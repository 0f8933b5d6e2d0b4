"""How far what is not wanted reaches."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.reader import read_brief

HOUSE = "A house with a kitchen and two bedrooms. "


def read(brief: str) -> tuple[list[str], list[str]]:
    """Return the kinds of rooms that a brief asks for, and those that it does not want."""
    facts = read_brief(brief, default_knowledge())
    return [room.room_type for room in facts.rooms], [name for name, _ in facts.excluded]


@pytest.mark.parametrize(
    "words",
    [
        "Please leave out: gym, bar, shop.",
        "Leave out the gym, the bar and the shop.",
        "Without: gym, bar and a shop.",
        "No: gym, bar, shop.",
        "Omit: gym, bar and shop.",
        "Skip the gym, the bar and the shop, please.",
        "Exclude the gym, the bar and any shops.",
    ],
)
def test_a_list_that_is_ordered_away_is_not_wanted_whole(words: str) -> None:
    assert read(HOUSE + words) == (["kitchen", "bedroom"], ["gym", "bar", "shop"])


@pytest.mark.parametrize(
    ("brief", "wanted", "unwanted"),
    [
        ("A house without a gym, a kitchen and two bedrooms.", ["kitchen", "bedroom"], ["gym"]),
        ("A house with no sauna: a kitchen, two bedrooms and a gym.", ["kitchen", "bedroom", "gym"], ["sauna"]),
        ("An office. Forget the gym, we need a canteen.", ["cafeteria"], ["gym"]),
    ],
)
def test_what_a_sentence_goes_on_to_ask_for_is_wanted(brief: str, wanted: list[str], unwanted: list[str]) -> None:
    assert read(brief) == (wanted, unwanted)


@pytest.mark.parametrize(
    "words",
    [
        "A sauna was in the first draft; please strike it.",
        "A sauna was planned, but drop it.",
        "There was a sauna in the old plan, leave it out.",
    ],
)
def test_what_is_struck_again_is_not_wanted(words: str) -> None:
    wanted, unwanted = read(HOUSE + words)
    assert wanted == ["kitchen", "bedroom"]
    assert unwanted == ["sauna"]


@pytest.mark.parametrize("number", ["no", "zero", "0"])
def test_none_of_a_thing_is_none(number: str) -> None:
    facts = read_brief(f"A meditation hall with 30 cushions and {number} chairs.", default_knowledge())
    assert [(thing.category, thing.excluded) for thing in facts.objects] == [("pillow", False), ("chair", True)]


def test_a_lift_that_makes_no_sense_is_not_wanted() -> None:
    facts = read_brief("A research station on two storeys; a lift makes no sense there.", default_knowledge())
    assert [name for name, _ in facts.vertical] == ["no_elevator"]
