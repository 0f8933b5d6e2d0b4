"""A plan that is not wanted any more is given up between two storeys."""

import pytest

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building
from mansion_planner.topology import floor_topology


def test_a_plan_is_cancelled_between_its_storeys(monkeypatch: pytest.MonkeyPatch) -> None:
    planned = []

    def graph(*arguments: object) -> object:
        planned.append(arguments)
        return floor_topology(*arguments)  # type: ignore[arg-type]

    monkeypatch.setattr("mansion_planner.plan.floor_topology", graph)
    with pytest.raises(MansionError) as refusal:
        plan_building(BuildRequest(description="a four-storey office"), cancelled=lambda: bool(planned))
    assert refusal.value.code == ErrorCode.CANCELED
    assert len(planned) == 1
