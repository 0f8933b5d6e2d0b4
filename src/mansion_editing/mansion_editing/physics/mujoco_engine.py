"""MuJoCo behind the engine interface: a world of boxes for one placement, made and dropped within the call."""

import math
import os
from typing import Any

import numpy as np

from mansion_editing.physics.engine import SLOW, SLOW_TURN, PosedBox, SettleProblem, SettleResult
from mansion_geometry.building_models import object_mass
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["MujocoEngine"]

TIMESTEP = 0.002
MOST_STEPS = 900
QUIET_STEPS = 40
"""Steps in a row below the speed limits that count as rest."""

FEWEST_STEPS = 120

BODY, NEIGHBOUR, SUPPORT, SHELL = 1, 2, 4, 8
"""Collision classes, one bit each for MuJoCo's contype and conaffinity: the shell collides with the new object alone,
because neighbours may already stand within boxes that fill hollow parts of the receptacle."""

_OPTIONS = f"""<compiler angle="degree"/>
<option timestep="{TIMESTEP}" integrator="implicitfast" cone="elliptic" impratio="5"/>
<default><geom type="box" condim="4" friction="0.8 0.01 0.001" solref="0.006 1" solimp="0.95 0.99 0.0005"/></default>"""


class MujocoEngine:
    """Gravity and contacts by MuJoCo (the extra ``sim``)."""

    name = "mujoco"

    def settle(self, problem: SettleProblem) -> SettleResult:
        """See `PhysicsEngine.settle`."""
        mujoco = _mujoco()
        model = mujoco.MjModel.from_xml_string(_world(problem))
        data = mujoco.MjData(model)
        quiet = 0
        for step in range(MOST_STEPS):
            mujoco.mj_step(model, data)
            quiet = quiet + 1 if _is_slow(data.qvel) else 0
            if step >= FEWEST_STEPS and quiet >= QUIET_STEPS:
                break
        mujoco.mj_forward(model, data)
        return _result(problem, mujoco, model, data, at_rest=quiet >= QUIET_STEPS)


def _mujoco() -> Any:
    # Importing MuJoCo also loads the OpenGL that this variable names, which physics does without.
    backend = os.environ.get("MUJOCO_GL")
    os.environ["MUJOCO_GL"] = "disable"
    try:
        import mujoco
    except ImportError as error:
        raise MansionError(
            ErrorCode.UNAVAILABLE,
            "placing an object needs MuJoCo (the extra `sim`); install it, or choose the engine `static`",
            details={"extra": "sim", "reason": str(error)},
        ) from None
    finally:
        if backend is None:
            del os.environ["MUJOCO_GL"]
        else:
            os.environ["MUJOCO_GL"] = backend
    return mujoco


def _is_slow(speeds: Any) -> bool:
    rows = np.abs(speeds.reshape(-1, 6))
    return bool(rows[:, :3].max() < SLOW and rows[:, 3:].max() < SLOW_TURN)


def _world(problem: SettleProblem) -> str:
    fixed = [
        _geom(box, f'pos="{_numbers(box.center)}" {_turn(box)}', kind, touches)
        for boxes, kind, touches in ((problem.support, SUPPORT, BODY | NEIGHBOUR), (problem.shell, SHELL, BODY))
        for box in boxes
    ]
    free = [_free("body", problem.body, BODY, BODY | NEIGHBOUR | SUPPORT | SHELL)]
    free += [
        _free(f"n{number}", box, NEIGHBOUR, BODY | NEIGHBOUR | SUPPORT)
        for number, box in enumerate(problem.neighbours.values())
    ]
    return f"<mujoco>{_OPTIONS}<worldbody>{''.join(fixed)}{''.join(free)}</worldbody></mujoco>"


def _free(name: str, box: PosedBox, kind: int, touches: int) -> str:
    geom = _geom(box, f'mass="{object_mass(box.size):.5g}"', kind, touches)
    return f'<body name="{name}" pos="{_numbers(box.center)}" {_turn(box)}><freejoint/>{geom}</body>'


def _geom(box: PosedBox, rest: str, kind: int, touches: int) -> str:
    half = _numbers([max(value / 2, 5e-4) for value in box.size])
    return f'<geom size="{half}" {rest} contype="{kind}" conaffinity="{touches}"/>'


def _turn(box: PosedBox) -> str:
    return f'euler="0 0 {box.rotation:.6g}"'


def _numbers(values: Any) -> str:
    return " ".join(f"{float(value):.7g}" for value in values)


def _result(problem: SettleProblem, mujoco: Any, model: Any, data: Any, *, at_rest: bool) -> SettleResult:
    body = model.body("body").id
    matrix = np.array(data.xmat[body]).reshape(3, 3)
    own = model.body_geomadr[body]
    depth = 0.0
    for contact in data.contact[: data.ncon]:
        if own in (contact.geom1, contact.geom2):
            depth = max(depth, -float(contact.dist))
    pushed = {}
    for number, (name, box) in enumerate(problem.neighbours.items()):
        there = data.xpos[model.body(f"n{number}").id]
        pushed[name] = float(np.linalg.norm(there - np.array(box.center)))
    x, y, z = (float(value) for value in data.xpos[body])
    return SettleResult(
        position=(x, y, z),
        rotation=math.degrees(math.atan2(matrix[1, 0], matrix[0, 0])) % 360.0,
        tilt=math.degrees(math.acos(float(np.clip(matrix[2, 2], -1.0, 1.0)))),
        at_rest=at_rest,
        penetration=depth,
        pushed=pushed,
    )
