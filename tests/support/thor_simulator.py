"""What stands behind AI2-THOR's client in the tests: MuJoCo, asked and answering as Unity is.

It knows the actions of a placement and refuses others in Unity's words; it takes what the asset's vertices say, pauses,
resumes when the scene is at rest, and answers in single precision, Unity's axes and Euler angles. As a program it is
an executable for the client's ``local_executable_path`` and speaks through the client's two pipes.
"""

import json
import os
import struct
import sys
from collections import Counter
from contextlib import ExitStack
from typing import Any

import mujoco
import numpy as np

SWAP = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])
STEP = 0.002
INVALID = "InvalidAction"
METADATA, IMAGE, END = 1, 4, 255

ARGUMENTS = {
    "Initialize": None,
    "GetScenesInBuild": set(),
    "ChangeQuality": {"quality"},
    "Reset": None,
    "PausePhysicsAutoSim": set(),
    "CreateRuntimeAsset": {"asset"},
    "CreateHouse": {"house"},
    "AdvancePhysicsStep": {"timeStep", "simSeconds", "allowAutoSimulation"},
}


class Refused(Exception):
    """An action that fails: the message, and Unity's code."""

    def __init__(self, message: str, code: str = "") -> None:
        super().__init__(message)
        self.code = code


def single(value: float) -> float:
    return float(np.float32(value))


def vector(values: Any) -> dict[str, float]:
    return dict(zip("xyz", (single(v) for v in values), strict=True))


def numbers(point: dict[str, float]) -> np.ndarray:
    return np.array([point[axis] for axis in "xyz"], dtype=np.float64)


def box_size(part: dict[str, Any]) -> np.ndarray:
    """The extent of a collider that is a box around the origin; each edge must belong to two faces, one each way."""
    points = np.array([numbers(p) for p in part["vertices"]])
    low, high = points.min(axis=0), points.max(axis=0)
    assert np.allclose(low, -high, atol=1e-6), "the box is not around its origin"
    assert len({tuple(row) for row in np.sign(points)}) == 8, "not the eight corners of a box"
    faces = np.array(part["triangles"]).reshape(-1, 3)
    edges = Counter((int(f[i]), int(f[(i + 1) % 3])) for f in faces for i in range(3))
    assert set(edges.values()) == {1} and all((b, a) in edges for a, b in edges), "not closed"
    # Unity's front is the clockwise side, to which the usual product points in left-handed axes.
    for face in faces:
        a, b, c = points[face]
        assert np.dot(np.cross(b - a, c - a), a + b + c) > 0.0, "a face looks inward"
    return high - low


def unity_matrix(euler: dict[str, float]) -> np.ndarray:
    """The turn of Euler angles about y alone, which is all that a house has."""
    assert euler["x"] == euler["z"] == 0.0
    turn = np.radians(euler["y"])
    c, s = np.cos(turn), np.sin(turn)
    return np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])


def unity_euler(turned: np.ndarray) -> dict[str, float]:
    x = np.arcsin(np.clip(-turned[1, 2], -1.0, 1.0))
    y = np.arctan2(turned[0, 2], turned[2, 2])
    z = np.arctan2(turned[1, 0], turned[1, 1])
    return vector(np.degrees([x, y, z]) % 360.0)


class ThorSimulator:
    """Attributes: `actions` that came in; `faults` maps an action to the message that it fails with."""

    def __init__(self, lacking: tuple[str, ...] = ()) -> None:
        self.actions: list[dict[str, Any]] = []
        self.faults: dict[str, str] = {}
        self.lacking = lacking
        self.assets: dict[str, dict[str, Any]] = {}
        self.nodes: dict[str, dict[str, Any]] = {}
        self.paused = False
        self.model: Any = None
        self.data: Any = None

    def do(self, action: dict[str, Any]) -> dict[str, Any]:
        """Do an action; return the agent's metadata."""
        self.actions.append(action)
        name = action["action"]
        arguments = {k: v for k, v in action.items() if k not in ("action", "sequenceId")}
        returned, error, code = None, "", ""
        try:
            known = ARGUMENTS.get(name, set())
            if name not in ARGUMENTS or name in self.lacking:
                raise Refused(f"Invalid action: {name}", INVALID)
            if known is not None and set(arguments) - known:
                raise Refused(f"unknown arguments {set(arguments) - known}", "InvalidArgument")
            if name in self.faults:
                raise Refused(self.faults[name])
            returned = getattr(self, f"do_{name}", lambda **_: None)(**arguments)
        except Refused as refused:
            error, code = str(refused), refused.code
        return self.metadata(name, returned, error, code)

    def metadata(self, name: str, returned: Any, error: str, code: str) -> dict[str, Any]:
        return {
            "lastAction": name,
            "lastActionSuccess": not error,
            "errorMessage": f"{error}\n  at UnityStandardAssets" if error else "",
            "errorCode": code,
            "actionReturn": returned,
            "sceneName": "Procedural",
            "screenWidth": 300,
            "screenHeight": 300,
            "isSceneAtRest": self.resting(),
            "colors": [],
            "thirdPartyCameras": [],
            "agentId": 0,
            "agent": {"name": "agent", "position": vector((0.0, 0.9, 0.0))},
            "inventoryObjects": [],
            "objects": [self.described(node) for node in self.nodes],
        }

    def do_GetScenesInBuild(self) -> list[str]:
        return ["Procedural"]

    def do_Reset(self, **_: Any) -> None:
        self.assets, self.nodes, self.model, self.paused = {}, {}, None, False

    def do_PausePhysicsAutoSim(self) -> None:
        self.paused = True

    def do_CreateRuntimeAsset(self, asset: dict[str, Any]) -> None:
        assert [numbers(p).tolist() for p in asset["vertices"]], "a mesh to show"
        assert {"mass", "drag", "angularDrag", "useGravity", "isKinematic"} == set(asset["physicalProperties"])
        self.assets[asset["name"]] = asset

    def do_CreateHouse(self, house: dict[str, Any]) -> None:
        if not self.paused:
            raise Refused("the test wants physics paused before things are put into the air")
        self.nodes = {n["id"]: n for n in house["objects"] if n["assetId"] in self.assets}
        parts = ['<geom type="plane" size="9 9 1"/>']
        for name, node in self.nodes.items():
            asset = self.assets[node["assetId"]]
            half = " ".join(f"{v:.9g}" for v in SWAP @ box_size(asset["colliders"][0]) / 2)
            place = " ".join(f"{v:.9g}" for v in SWAP @ numbers(node["position"]))
            turned = SWAP @ unity_matrix(node["rotation"]) @ SWAP
            axes = " ".join(f"{v:.9g}" for v in [*turned[:, 0], *turned[:, 1]])
            joint = "" if node["kinematic"] else "<freejoint/>"
            weight = asset["physicalProperties"]["mass"]
            parts.append(
                f'<body name="{name}" pos="{place}" xyaxes="{axes}">{joint}'
                f'<geom type="box" size="{half}" mass="{weight}" condim="4"/></body>'
            )
        self.model = mujoco.MjModel.from_xml_string(
            f'<mujoco><option timestep="{STEP}" integrator="implicitfast" cone="elliptic"/>'
            '<default><geom friction="0.6 0.01 0.001" solref="0.006 1" solimp="0.95 0.99 0.0005"/>'
            f"</default><worldbody>{''.join(parts)}</worldbody></mujoco>"
        )
        self.data = mujoco.MjData(self.model)
        mujoco.mj_forward(self.model, self.data)
        self.paused = False  # a scene without objects was at rest, so that it simulates itself again

    def do_AdvancePhysicsStep(
        self, timeStep: float = 0.02, simSeconds: float | None = None, allowAutoSimulation: bool = False
    ) -> None:
        if not self.paused and not allowAutoSimulation:
            raise Refused("AdvancePhysicsStep can only be called if Physics AutoSimulation is currently paused")
        if not 0.0 < timeStep <= 0.05:
            raise Refused("Please use a timeStep between 0.0f and 0.05f.")
        assert self.paused, "the placement would depend on the frames in between"
        for _ in range(round((simSeconds or timeStep) / STEP)):
            mujoco.mj_step(self.model, self.data)
        mujoco.mj_forward(self.model, self.data)

    def resting(self) -> bool:
        return self.data is None or float(np.abs(self.data.qvel).max(initial=0.0)) < 1e-3

    def described(self, name: str) -> dict[str, Any]:
        body = self.data.body(name)
        turned = SWAP @ body.xmat.reshape(3, 3) @ SWAP
        extent = box_size(self.assets[self.nodes[name]["assetId"]]["colliders"][0])
        place = SWAP @ body.xpos
        return {
            "name": name,
            "objectId": name,
            "assetId": self.nodes[name]["assetId"],
            "objectType": "Undefined",
            "position": vector(place),
            "rotation": unity_euler(turned),
            "axisAlignedBoundingBox": {"center": vector(place), "size": vector(np.abs(turned) @ extent)},
            "visible": False,
        }


def message(kind: int, body: bytes) -> bytes:
    return struct.pack("!BI", kind, len(body)) + body


def main() -> None:
    """Answer the client's actions until it closes its pipe."""
    import msgpack

    lacking = tuple(filter(None, os.environ.get("THOR_SIMULATOR_LACKING", "").split(",")))
    simulator = ThorSimulator(lacking)
    frame = bytes(300 * 300 * 3)
    if log := os.environ.get("THOR_SIMULATOR_LOG"):
        with open(log, "a", encoding="utf-8") as file:
            file.write(f"{os.getpid()}\n")
    sequence, answer = 0, simulator.metadata("Initialize", None, "", "")
    with ExitStack() as pipes:
        out = pipes.enter_context(open(os.environ["AI2THOR_FIFO_SERVER_PIPE_PATH"], "wb"))
        into = None
        while True:
            whole = {"agents": [answer], "thirdPartyCameras": [], "activeAgentId": 0, "sequenceId": sequence}
            out.write(message(METADATA, msgpack.packb(whole)) + message(IMAGE, frame) + message(END, b""))
            out.flush()
            if into is None:  # the client opens its end when it has heard the first message
                name = os.environ["AI2THOR_FIFO_CLIENT_PIPE_PATH"]
                into = pipes.enter_context(open(name, "rb"))
            header = into.read(5)
            if len(header) < 5:
                return
            _, length = struct.unpack("!BI", header)
            action = json.loads(into.read(length))
            into.read(5)
            if action["action"] == os.environ.get("THOR_SIMULATOR_DIES_AT"):
                sys.exit(3)
            sequence, answer = action["sequenceId"], simulator.do(action)


if __name__ == "__main__":
    main()
