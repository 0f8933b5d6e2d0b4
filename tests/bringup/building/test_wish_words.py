"""What the receipt says that the words of a brief were read as."""

from typing import get_args

import pytest
from rich.console import Console

from mansion_bringup.building.wish_words import read_as
from mansion_bringup.cli.receipt_table import receipt_table
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.wishes import Scope, Wish, WishKind, WishValue
from mansion_planner.plan import plan_building


def readings(brief: str) -> dict[str, str]:
    return {wish.text: read_as(wish) for wish in plan_building(BuildRequest(description=brief)).program.wishes}


def test_counts_places_and_areas_are_said() -> None:
    read = readings(
        "A three-storey school with six classrooms of 50 m2 on the second floor and a canteen on the ground floor"
    )
    assert read["three-storey"] == "3 storeys"
    assert "6 classrooms of 50 m2, floor 2" in read.values()
    assert "1 canteen, ground floor" in read.values()


def test_what_is_not_wanted_and_what_belongs_together_are_said() -> None:
    read = readings(
        "A two-storey house without a garage, the kitchen next to the dining room, two sofas in the living room"
    )
    assert {"no garage", "kitchen next to dining room"} <= set(read.values())
    assert any(text.startswith("2 sofas") and text.endswith("in living room") for text in read.values())


@pytest.mark.parametrize(
    ("floors", "words"),
    [([1], "ground floor"), ([0], "basement 1"), ([-1], "basement 2"), ([2, 3], "floors 2 and 3"),
     ([2, 3, 4], "floors 2 to 4"), ([1, 3, 5], "floors 1, 3 and 5")],
)  # fmt: skip
def test_storeys_are_named(floors: list[int], words: str) -> None:
    wish = Wish(
        id="wish_1",
        text="lift",
        span=(0, 4),
        kind="room",
        value=WishValue(name="gym", count=1),
        scope=Scope(floors=floors),
    )
    assert read_as(wish) == f"1 gym, {words}"


@pytest.mark.parametrize("kind", get_args(WishKind))
def test_every_kind_of_wish_has_words(kind: WishKind) -> None:
    value = WishValue(name="oak", other="ash", count=2, area=12.0, height=3.0)
    assert bool(read_as(Wish(id="wish_1", text="words", span=(0, 5), kind=kind, value=value))) == (kind != "unread")


def test_the_table_has_a_column_for_it() -> None:
    wish = Wish(id="wish_1", text="twin beds", span=(0, 9), kind="object", value=WishValue(name="single_bed", count=2))
    console = Console(width=120)
    with console.capture() as captured:
        console.print(receipt_table([wish]))
    assert "2 single beds" in captured.get()


def test_bounds_are_read_as_bounds() -> None:
    value = WishValue(name="classroom", type="classroom", count=4, area=50.0, limit="least")
    asked = Wish(id="wish_1", text="four classrooms", span=(0, 15), kind="room", value=value)
    assert read_as(asked) == "4 classrooms of at least 50 m2"
    whole = Wish(id="wish_2", text="900 m2", span=(0, 6), kind="total_area", value=WishValue(area=900.0, limit="most"))
    assert read_as(whole) == "at most 900 m2 in all"
