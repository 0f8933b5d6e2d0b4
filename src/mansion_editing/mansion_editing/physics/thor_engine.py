"""AI2-THOR behind the engine interface: a simulator is started for one placement and ended with it."""

import math
import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, Final

import numpy as np

from mansion_editing.physics.overlap import OrientedBox, depth
from mansion_editing.physics.problem import SLOW, SLOW_TURN, SettleProblem, SettleResult
from mansion_editing.physics.thor_bodies import BODY, Body, house_of, runtime_asset, thor_bodies, thor_shift
from mansion_geometry.thor.controller import Controller, act, first_line, start_controller
from mansion_geometry.thor.house_format import floor_point, rotation_matrix
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.shapes import Point3

__all__ = ["BUILD", "ThorEngine", "parameters"]

BUILD: Final = "40679c517859e09c1f2a5e39b65ee7f33fcfdd48"
"""The build that objathor, whose assets are runtime assets, asks for (its README)."""

_VARIABLE: Final = "MANSION_THOR_BUILD"

TIMESTEP: Final = 0.01
ADVANCE: Final = 0.05
"""Of the physics, and of one action; seconds."""

MOST_ADVANCES: Final = 60
FEWEST_ADVANCES: Final = 5
QUIET_ADVANCES: Final = 3
"""Advances in a row below the speed limits that count as rest."""

MISPLACED: Final = 0.005
"""Metres between where a box was asked for and where AI2-THOR made it that are a fault."""

DIGITS: Final = 7

Poses = dict[str, OrientedBox]


def parameters(environment: Mapping[str, str] | None = None) -> dict[str, Any]:
    """Return the parameters of AI2-THOR's ``Controller``.

    Parameters
    ----------
    environment : mapping, optional
        The process's own when absent. ``MANSION_THOR_BUILD`` is a build's executable on this machine or the commit of
        a published build; `BUILD` when absent.
    """
    environment = os.environ if environment is None else environment
    build = environment.get(_VARIABLE, "").strip() or BUILD
    common = {"scene": "Procedural", "agentMode": "default"}
    file = Path(build).expanduser()
    if os.sep in build or file.is_file():
        return {**common, "local_executable_path": str(file)}
    return {**common, "platform": "CloudRendering", "commit_id": build}


class ThorEngine:
    """Gravity and contacts by AI2-THOR (the extra ``thor``).

    Parameters
    ----------
    start : callable, optional
        Starts a controller; `mansion_geometry.thor.controller.start_controller` when absent.
    """

    name = "thor"

    def __init__(self, start: Callable[..., Controller] = start_controller) -> None:
        self._start = start

    def settle(self, problem: SettleProblem) -> SettleResult:
        """See `PhysicsEngine.settle`."""
        controller = self._start(**parameters())
        try:
            return _settle(controller, problem)
        finally:
            controller.stop()


def _settle(controller: Controller, problem: SettleProblem) -> SettleResult:
    bodies, shift = thor_bodies(problem), thor_shift(problem)
    # An empty scene is at rest, and a scene at rest simulates itself again: hence the second pause.
    _do(controller, "PausePhysicsAutoSim")
    for body in bodies:
        _do(controller, "CreateRuntimeAsset", asset=runtime_asset(body))
    _do(controller, "CreateHouse", house=house_of(bodies, shift))
    _do(controller, "PausePhysicsAutoSim")
    before = _poses(controller, bodies, shift)
    _check_places(bodies, before)
    free = [body.name for body in bodies if not body.fixed]
    quiet = 0
    for count in range(1, MOST_ADVANCES + 1):
        _do(controller, "AdvancePhysicsStep", timeStep=TIMESTEP, simSeconds=ADVANCE, allowAutoSimulation=True)
        now = _poses(controller, bodies, shift)
        quiet = quiet + 1 if all(_is_slow(before[name], now[name]) for name in free) else 0
        before = now
        if count >= FEWEST_ADVANCES and quiet >= QUIET_ADVANCES:
            break
    return _result(problem, before, quiet >= QUIET_ADVANCES)


def _do(controller: Controller, action: str, **arguments: Any) -> None:
    try:
        error = act(controller, action, **arguments)
    except (RuntimeError, OSError) as fault:
        error = f"{action}: {first_line(str(fault))}"
    if error:
        raise _unavailable(error)


def _unavailable(reason: str) -> MansionError:
    return MansionError(
        ErrorCode.UNAVAILABLE,
        f"AI2-THOR could not do the placement: {reason}; it needs a build with CreateRuntimeAsset "
        f"({_VARIABLE} names another), or choose the engine `mujoco`",
        details={"extra": "thor"},
    )


def _poses(controller: Controller, bodies: list[Body], shift: Point3) -> Poses:
    """Return where the bodies are, in the problem's frame."""
    entries = {entry["objectId"]: entry for entry in controller.last_event.metadata["objects"]}
    poses: Poses = {}
    for body in bodies:
        entry = entries.get(body.name)
        if entry is None:
            raise _unavailable(f"its scene lacks {body.name}")
        # The middle of the box around a turned box is the turned box's own.
        there = floor_point(entry["axisAlignedBoundingBox"]["center"], DIGITS)
        x, y, z = (value - way for value, way in zip(there, shift, strict=True))
        poses[body.name] = OrientedBox((x, y, z), body.box.size, rotation_matrix(entry["rotation"]))
    return poses


def _check_places(bodies: list[Body], poses: Poses) -> None:
    for body in bodies:
        off = math.dist(poses[body.name].center, body.box.center)
        if off > MISPLACED:
            raise _unavailable(f"it made {body.name} {1000 * off:.0f} mm from its place")


def _is_slow(before: OrientedBox, now: OrientedBox) -> bool:
    speed = math.dist(before.center, now.center) / ADVANCE
    cosine = (float(np.trace(before.axes.T @ now.axes)) - 1.0) / 2.0
    return speed < SLOW and math.acos(min(1.0, max(-1.0, cosine))) / ADVANCE < SLOW_TURN


def _result(problem: SettleProblem, poses: Poses, at_rest: bool) -> SettleResult:
    body = poses[BODY]
    axes = body.axes
    pushed = {
        name: math.dist(poses[f"neighbour_{number}"].center, box.center)
        for number, (name, box) in enumerate(problem.neighbours.items())
    }
    return SettleResult(
        position=body.center,
        rotation=math.degrees(math.atan2(axes[1, 0], axes[0, 0])) % 360.0,
        tilt=math.degrees(math.acos(float(np.clip(axes[2, 2], -1.0, 1.0)))),
        at_rest=at_rest,
        penetration=max((depth(body, poses[name]) for name in poses if name != BODY), default=0.0),
        pushed=pushed,
    )
