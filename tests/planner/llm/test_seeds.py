"""Seed boxes are checked one by one; the good ones of an answer are kept."""

from typing import Any

import msgspec
import pytest

from mansion_msgs_py.layout import LayoutRoom
from mansion_planner.llm.answers import SeedsAnswer
from mansion_planner.llm.seeds import seed_faults
from mansion_planner.solver.cut_rounds import SeedRequest

REQUEST = SeedRequest(
    parent="hall",
    children=("kitchen", "den"),
    fractions={"kitchen": 0.4, "den": 0.4},
    x_range=(0.0, 10.0),
    y_range=(0.0, 6.0),
    neighbours=("stair_1",),
    layout=[LayoutRoom(id="hall", polygon=[(0.0, 0.0), (10.0, 0.0), (10.0, 6.0), (0.0, 6.0)])],
    preview=b"",
)
KITCHEN: dict[str, Any] = {"room_id": "kitchen", "x": [0.0, 4.0], "y": [0.0, 6.0], "area": 0.4}
DEN: dict[str, Any] = {"room_id": "den", "x": [6.0, 10.0], "y": [0.0, 6.0]}


def faulty(*boxes: dict[str, Any]) -> dict[str, str]:
    """Return the last fault of each piece."""
    answer = msgspec.convert({"boxes": list(boxes)}, SeedsAnswer)
    return {fault.piece: fault.text for fault in seed_faults(answer, REQUEST)}


def test_good_boxes_have_no_faults() -> None:
    assert faulty(KITCHEN, DEN) == {}


@pytest.mark.parametrize(
    ("boxes", "piece", "word"),
    [
        ([KITCHEN], "den", "missing"),
        ([KITCHEN, KITCHEN, DEN], "kitchen", "2 boxes"),
        ([KITCHEN, DEN | {"x": [0.5, 4.0]}], "den", "overlap"),
        ([KITCHEN, DEN | {"x": [10.0, 6.0]}], "den", "min"),
        ([KITCHEN, DEN | {"x": [30.0, 40.0]}], "den", "parent"),
        ([KITCHEN | {"area": -0.4}, DEN], "kitchen", "share"),
        ([KITCHEN | {"area": 12.0}, DEN], "kitchen", "share"),
        ([KITCHEN | {"x": [-1e308, 1e308]}, DEN], "kitchen", "finite"),
        ([KITCHEN, DEN, DEN | {"room_id": "cellar"}], "extra", "cellar"),
    ],
)
def test_a_fault_is_that_of_its_room(boxes: list[dict[str, Any]], piece: str, word: str) -> None:
    found = faulty(*boxes)
    assert set(found) == {piece} and word in found[piece]
