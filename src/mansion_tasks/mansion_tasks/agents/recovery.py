"""Recovery from a corner: what to do when the way ahead is blocked (the first failure case of section F.5)."""

from collections.abc import Mapping
from typing import Final

from mansion_msgs_py.task import SkillCall
from mansion_msgs_py.world import SkillResult, SkillStatus
from mansion_tasks.agents.interface import Observation

__all__ = ["CornerRecovery", "escape_moves"]

TURNS: Final[Mapping[str, float]] = {"ahead": 0.0, "left": 90.0, "back": 180.0, "right": -90.0}
MARGIN: Final = 0.05
MAX_ESCAPE: Final = 1.5
MAX_BLOCKED: Final = 2
"""Blocked moves in a row after which an agent is led out."""


def escape_moves(result: SkillResult | None) -> list[SkillCall] | None:
    """Return the skills that lead away from an obstacle, towards where most space is free.

    Parameters
    ----------
    result : SkillResult, optional
        Result of a MoveAhead, with the metres free in four directions.

    Returns
    -------
    list of SkillCall or None
        ``None`` when the result says nothing of free space, or there is none.

    Examples
    --------
    >>> free = {"ahead": 0.0, "left": 0.1, "back": 2.4, "right": 0.0}
    >>> stuck = SkillResult(skill="MoveAhead", status=SkillStatus.EXECUTION_FAILURE, message="", data={"free": free})
    >>> [(call.skill, *call.arguments.values()) for call in escape_moves(stuck)]
    [('Rotate', 180.0), ('MoveAhead', 1.5)]
    """
    if result is None or result.status is SkillStatus.SUCCESS:
        return None
    free = result.data.get("free")
    if not isinstance(free, Mapping):
        return None
    best = max(TURNS, key=lambda way: float(free.get(way, 0.0)))
    distance = min(float(free.get(best, 0.0)) - MARGIN, MAX_ESCAPE)
    if distance <= 0.0:
        return None
    turn = [SkillCall(skill="Rotate", arguments={"degrees": TURNS[best]})] if TURNS[best] else []
    return [*turn, SkillCall(skill="MoveAhead", arguments={"distance": round(distance, 2)})]


class CornerRecovery:
    """Watches an agent's moves, and takes over when it runs against the same corner again and again."""

    def __init__(self) -> None:
        self._blocked = 0
        self._way_out: list[SkillCall] = []

    def step(self, observation: Observation) -> SkillCall | None:
        """Return a skill that leads out of a corner, ``None`` while the agent is free to choose.

        After `MAX_BLOCKED` blocked moves, with or without turns between them, the robot turns to the freest direction,
        goes there, and then to the nearest landmark, from which every room can be reached again.
        """
        if self._way_out:
            return self._way_out.pop(0)
        call, last = observation.last_call, observation.last
        if call is None or last is None or call.skill in ("Rotate", "LookUp", "LookDown"):
            return None
        moved = last.skill == "MoveAhead"
        if not moved or last.status is SkillStatus.SUCCESS:
            self._blocked = 0
            return None
        self._blocked += 1
        if self._blocked < MAX_BLOCKED:
            return None
        self._blocked = 0
        self._way_out = [*(escape_moves(last) or []), *_to_nearest(observation)]
        return self._way_out.pop(0) if self._way_out else None


def _to_nearest(observation: Observation) -> list[SkillCall]:
    here = observation.pose
    nearest = min(
        observation.landmarks,
        key=lambda entry: (entry.pose.x - here.x) ** 2 + (entry.pose.y - here.y) ** 2,
        default=None,
    )
    if nearest is None:
        return []
    return [SkillCall(skill="GoToLandmark", arguments={"landmark": nearest.name})]
