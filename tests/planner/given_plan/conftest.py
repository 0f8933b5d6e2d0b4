"""A flat of five rooms, and what the planner makes of a plan."""

from collections.abc import Callable
from copy import deepcopy
from typing import Any

import pytest

from mansion_msgs_py.building_plan import BuildingPlan
from mansion_msgs_py.codec import convert
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.stages import PlanReply
from mansion_planner.plan import plan_building

FLAT: dict[str, Any] = {
    "floors": [
        {
            "rooms": [
                {"name": "Hall", "polygon": [[4, 3], [8, 3], [8, 5], [4, 5]]},
                {"name": "Living room", "polygon": [[0, 3], [4, 3], [4, 8], [0, 8]]},
                {"name": "Kitchen", "polygon": [[4, 5], [8, 5], [8, 8], [4, 8]]},
                {"name": "Anna's bedroom", "polygon": [[0, 0], [4, 0], [4, 3], [0, 3]]},
                {"name": "Bath", "polygon": [[4, 0], [8, 0], [8, 3], [4, 3]]},
            ],
            "doors": [
                {"rooms": ["hall", "outside"], "at": [8, 4], "width": 1.0},
                {"rooms": ["Hall", "Living room"]},
                {"segment": [[5, 5], [5.9, 5]]},
                {"at": [5, 3], "width": 0.8},
                {"rooms": ["Living room", "Anna's bedroom"], "at": [3, 3]},
            ],
            "openings": [{"rooms": ["Living room", "Kitchen"]}],
            "windows": [{"segment": [[0, 5], [0, 7]]}, {"at": [6, 8], "width": 1.5}, {"at": [0, 1.5]}],
        }
    ]
}


@pytest.fixture
def flat() -> dict[str, Any]:
    """A plan of five rooms that the test may change."""
    return deepcopy(FLAT)


@pytest.fixture
def house() -> dict[str, Any]:
    """A plan of two storeys with stairs that the test may change."""
    stairs = {"name": "Stairs", "polygon": [[4, 0], [6, 0], [6, 4], [4, 4]]}
    ground = [
        {"name": "Hall", "polygon": [[4, 4], [6, 4], [6, 8], [4, 8]]},
        {"name": "Living room", "polygon": [[0, 0], [4, 0], [4, 8], [0, 8]]},
        {"name": "Kitchen", "polygon": [[6, 0], [10, 0], [10, 8], [6, 8]]},
        stairs,
    ]
    upper = [
        {"name": "Landing", "polygon": [[4, 4], [6, 4], [6, 8], [4, 8]]},
        {"name": "Bedroom", "polygon": [[0, 0], [4, 0], [4, 8], [0, 8]]},
        {"name": "Bathroom", "polygon": [[6, 0], [10, 0], [10, 8], [6, 8]]},
        stairs,
    ]
    return {
        "floors": [
            {
                "floor": 2,
                "rooms": upper,
                "doors": [{"rooms": ["Landing", name]} for name in ("Bedroom", "Bathroom", "Stairs")],
            },
            {
                "floor": 1,
                "rooms": ground,
                "doors": [{"rooms": ["Hall", name]} for name in ("Living room", "Kitchen", "Stairs", "outside")],
            },
        ]
    }


def planned(plan: dict[str, Any], description: str = "") -> PlanReply:
    """Return what the planner makes of a plan."""
    return plan_building(BuildRequest(description=description, plan=convert(BuildingPlan, plan)))


@pytest.fixture
def plan() -> Callable[..., PlanReply]:
    """`planned`, for tests."""
    return planned


@pytest.fixture
def faults() -> Callable[[dict[str, Any]], list[str]]:
    """What is wrong with a plan, a line for each fault."""

    def told(value: dict[str, Any]) -> list[str]:
        with pytest.raises(MansionError) as refusal:
            planned(value)
        assert refusal.value.code == "INFEASIBLE"
        found: list[str] = refusal.value.info.details["faults"]
        return found

    return told
