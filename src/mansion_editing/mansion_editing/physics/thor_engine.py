"""AI2-THOR behind the engine interface: a simulator is started for one placement and ended with it."""

import math
import os
from collections.abc import Callable, Mapping
from dataclasses import KW_ONLY, dataclass
from pathlib import Path
from typing import Any, Final, NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from mansion_editing.physics.engine import SLOW, SLOW_TURN, PosedBox, SettleProblem, SettleResult
from mansion_export.thor.runtime_assets import box_asset, box_node, empty_house
from mansion_geometry.building_models import object_mass
from mansion_geometry.thor.controller import Controller, act, first_line, start_controller
from mansion_geometry.thor.house_format import floor_point, rotation_matrix
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.shapes import Point3

__all__ = [
    "BODY",
    "BUILD",
    "Body",
    "OrientedBox",
    "ThorEngine",
    "depth",
    "house_of",
    "parameters",
    "thor_bodies",
    "thor_shift",
    "upright",
]

Matrix = npt.NDArray[np.float64]


class OrientedBox(NamedTuple):
    """A box: centre, full extent, and its axes as the columns of a rotation matrix of shape (3, 3)."""

    center: Point3
    size: Point3
    axes: Matrix


def upright(center: Point3, size: Point3, rotation: float) -> OrientedBox:
    """Return a box that is turned about z alone, degrees counter-clockwise."""
    turn = np.radians(rotation)
    c, s = float(np.cos(turn)), float(np.sin(turn))
    return OrientedBox(center, size, np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]))


def depth(one: OrientedBox, other: OrientedBox) -> float:
    """Return how far one box would have to move to leave the other, metres; 0 where they are apart."""
    axes = [*one.axes.T, *other.axes.T]
    axes += [np.cross(a, b) for a in one.axes.T for b in other.axes.T]
    between = np.array(other.center) - np.array(one.center)
    least = np.inf
    for axis in axes:
        length = float(np.linalg.norm(axis))
        if length < 1e-6:
            continue
        unit = axis / length
        reach = _reach(one, unit) + _reach(other, unit)
        least = min(least, reach - abs(float(between @ unit)))
        if least <= 0.0:
            return 0.0
    return float(least)


def _reach(box: OrientedBox, unit: Matrix) -> float:
    """Half the length of a box's shadow on a line."""
    return float(np.abs(unit @ box.axes) @ np.array(box.size)) / 2


Json: TypeAlias = dict[str, Any]

BODY: Final = "body"
"""Name of the object that is let go."""

FALL: Final = 1.0
"""What falls off falls this far, metres."""

LAPPED: Final = 1e-3
"""Metres by which two boxes may be in each other at the start and still be let go."""


@dataclass(frozen=True)
class Body:
    """A box with a name, and whether it stays where it is."""

    name: str
    box: PosedBox
    _: KW_ONLY
    fixed: bool


def thor_shift(problem: SettleProblem) -> Point3:
    """Return what takes the problem over the middle of the room, clear of its floor."""
    boxes = [problem.body, *problem.support, *problem.shell, *problem.neighbours.values()]
    lowest = min(box.center[2] - box.size[2] / 2 for box in boxes)
    x, y, _ = problem.body.center
    return -x, -y, FALL - lowest


def thor_bodies(problem: SettleProblem) -> list[Body]:
    """Return the bodies of a problem, the one that is let go first.

    Notes
    -----
    A neighbour may stand within a box that stands for a hollow part of the receptacle. AI2-THOR has no collision
    classes that would let it; such a neighbour is fixed.
    """
    fixed = [upright(*box) for box in problem.shell]
    bodies = [Body(BODY, problem.body, fixed=False)]
    for kind, boxes in (("support", problem.support), ("shell", problem.shell)):
        bodies += [Body(f"{kind}_{number}", box, fixed=True) for number, box in enumerate(boxes)]
    for number, box in enumerate(problem.neighbours.values()):
        lapped = any(depth(upright(*box), other) > LAPPED for other in fixed)
        bodies.append(Body(f"neighbour_{number}", box, fixed=lapped))
    return bodies


def house_of(bodies: list[Body], shift: Point3) -> Json:
    """Return a house of one room with the bodies in it, each shifted."""
    empty = empty_house()
    nodes = []
    for body in bodies:
        x, y, z = (value + offset for value, offset in zip(body.box.center, shift, strict=True))
        box = body.box
        nodes.append(box_node(empty["rooms"][0], body.name, (x, y, z), box.size, box.rotation, fixed=body.fixed))
    return {**empty, "objects": nodes}


BUILD: Final = "40679c517859e09c1f2a5e39b65ee7f33fcfdd48"
"""The build that objathor, whose assets are runtime assets, asks for (its README)."""

_VARIABLE: Final = "MANSION_THOR_BUILD"

TIMESTEP: Final = 0.01
ADVANCE: Final = 0.05
"""Step of the physics, and of one action; seconds."""

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
        asset = box_asset(body.name, body.box.size, mass=object_mass(body.box.size), fixed=body.fixed)
        _do(controller, "CreateRuntimeAsset", asset=asset)
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
    return _result(problem, before, at_rest=quiet >= QUIET_ADVANCES)


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


def _result(problem: SettleProblem, poses: Poses, *, at_rest: bool) -> SettleResult:
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
