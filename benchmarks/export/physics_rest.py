"""Step the MuJoCo models of a building: no warning, and nothing that lies on or in furniture moves.

python benchmarks/export/physics_rest.py out/office [--steps 1000]
"""

import argparse
from pathlib import Path

import msgspec
import mujoco
import numpy as np

from mansion_export.mjcf import floor_mjcf
from mansion_msgs_py.scene import FloorScene

MOVED = 0.05
"""Metres from which an object counts as moved."""


def main() -> None:
    """Print a line for each floor, fixed and with free objects."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("building", type=Path)
    parser.add_argument("--steps", type=int, default=1000)
    options = parser.parse_args()
    for path in sorted(options.building.glob("floors/*/scene.json")):
        scene = msgspec.json.decode(path.read_bytes(), type=FloorScene)
        for free in (False, True):
            print(f"floor {scene.floor}, {'free' if free else 'fixed'}: {step(scene, free, options.steps)}")


def step(scene: FloorScene, free: bool, steps: int) -> str:
    """Step one floor's model and say what happened."""
    export = floor_mjcf(scene, "", free_pickupables=free)
    model = mujoco.MjModel.from_xml_string(export.xml, export.meshes)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    start = data.xpos.copy()
    for _ in range(steps):
        mujoco.mj_step(model, data)
    away = np.linalg.norm(data.xpos - start, axis=1)
    warnings = sum(int(warning.number) for warning in data.warning)
    moved = [model.body(int(i)).name for i in np.flatnonzero(away > MOVED)]
    return (
        f"{model.nbody} bodies, {model.njnt} free, {warnings} warnings, "
        f"largest way {away.max():.3f} m, moved: {', '.join(moved) or 'none'}"
    )


if __name__ == "__main__":
    main()
