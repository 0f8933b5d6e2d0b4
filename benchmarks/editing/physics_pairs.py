"""Place random objects on and in random receptacles, and verify each result apart from the tools.

    python benchmarks/editing/physics_pairs.py BUILDING [--pairs 500] [--seed 0] [--physics mujoco]

A placement counts as good when its box lies over the receptacle, meets no other box by more than 2 mm, and stays within
2 mm in a second simulation that starts from the written pose; or when it is refused with a reason.
"""

import argparse
import math
import time
from collections import Counter
from pathlib import Path

import numpy as np

from mansion_assets.catalogue import load_catalogue
from mansion_editing.physics.engine import PosedBox, SettleProblem, engine_named
from mansion_editing.state import SceneState
from mansion_editing.tools.ledges import ledges_of
from mansion_editing.tools.placement import place_in_container, place_on_surface
from mansion_editing.tools.receptacle_bodies import half_diagonal, receptacle_shell, support_boxes
from mansion_geometry.object_footprints import footprint
from mansion_msgs_py.codec import decode
from mansion_msgs_py.editing.objects import PlaceInContainerArgs, PlaceOnSurfaceArgs
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import FloorScene, SceneObject
from mansion_scene.decor.frames import to_local

STAYS = 0.002


def main() -> None:
    """Run the pairs and print the counts."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("building", type=Path)
    parser.add_argument("--pairs", type=int, default=500)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--physics", default="mujoco")
    args = parser.parse_args()
    catalogue = load_catalogue()
    files = sorted(args.building.glob("floors/*/scene.json"))
    scenes = [decode(FloorScene, file.read_bytes()) for file in files]
    engine = engine_named(args.physics)
    rng = np.random.default_rng(args.seed)
    assets = [a for a in catalogue.assets.values() if a.mount == "surface" or a.pickupable]
    counts: Counter[str] = Counter()
    seconds: list[float] = []
    for _ in range(args.pairs):
        state = SceneState(scenes, catalogue)
        carriers = [(f, o) for f, o in state.objects() if o.receptacle and o.mount != "ceiling"]
        floor, carrier = carriers[int(rng.integers(len(carriers)))]
        asset = assets[int(rng.integers(len(assets)))]
        kinds = state.asset(carrier)
        inside = kinds is not None and bool(kinds.volumes) and (not kinds.surfaces or rng.random() < 0.5)
        started = time.process_time()
        try:
            if inside:
                container = PlaceInContainerArgs(asset_id=asset.key, container_id=carrier.id)
                placed = place_in_container(state, container, engine)
            else:
                surface = PlaceOnSurfaceArgs(asset_id=asset.key, receptacle_id=carrier.id)
                placed = place_on_surface(state, surface, engine)
        except MansionError as error:
            counts[f"refused: {_kind(error.info.message)}"] += 1
            continue
        finally:
            seconds.append(time.process_time() - started)
        fault = verify(state, floor, carrier, placed, engine)
        counts[fault or "at rest"] += 1
        if fault:
            print(f"{asset.key} {'in' if inside else 'on'} {carrier.id} ({carrier.asset}): {fault}")
    for name, count in counts.most_common():
        print(f"{count:5d}  {name}")
    print(
        f"CPU seconds: median {np.median(seconds):.3f}, 99% {np.quantile(seconds, 0.99):.3f}, most {max(seconds):.3f}"
    )


def _kind(message: str) -> str:
    for words in (
        "does not fit",
        "no free place",
        "does not come to rest",
        "has no surface",
        "holds nothing",
        "hangs on",
    ):
        if words in message:
            return words
    return message[:60]


def verify(state: SceneState, floor: int, carrier: SceneObject, placed: SceneObject, engine: object) -> str:
    """Return what is wrong with a placed object, empty when nothing is."""
    shape = footprint(placed)
    under = footprint(carrier)
    if shape.intersection(under).area < 0.98 * shape.area:
        return "hangs over its receptacle"
    low = placed.position[2] - placed.size[2] / 2
    high = placed.position[2] + placed.size[2] / 2
    for other in state.index(floor).objects:
        if other.id in (placed.id, carrier.id, carrier.parent) or other.size[2] < 0.004:
            continue
        depth = min(high, other.position[2] + other.size[2] / 2) - max(low, other.position[2] - other.size[2] / 2)
        if depth > 0.002 and math.dist(other.position[:2], placed.position[:2]) < 6.0:
            both = shape.intersection(footprint(other))
            if both.area > 1e-5:
                return f"lies in {other.category}"
    return _moves(state, carrier, placed, engine)


def _moves(state: SceneState, carrier: SceneObject, placed: SceneObject, engine: object) -> str:
    asset = state.asset(carrier)
    assert asset is not None
    foot = placed.position[2] - placed.size[2] / 2 - carrier.position[2]
    x, y = to_local(carrier, placed.position)
    ledges = [
        ledge
        for ledge in ledges_of(asset, inside=placed.mount == "inside")
        if abs(ledge.z - foot) < 0.06 and abs(x - ledge.x) <= ledge.w / 2 and abs(y - ledge.y) <= ledge.d / 2
    ]
    if not ledges:
        return "floats"
    ledge = min(ledges, key=lambda entry: abs(entry.z - foot))
    problem = SettleProblem(
        PosedBox(placed.position, placed.size, placed.rotation),
        support_boxes(carrier, asset, ledge, (x, y), half_diagonal(placed.size)),
        receptacle_shell(carrier, asset, ledge, placed.size),
    )
    result = engine.settle(problem)  # type: ignore[attr-defined]
    if not result.at_rest or result.tilt > 3.0:
        return "does not stay"
    moved = math.dist(result.position, placed.position)
    return f"moves {1000 * moved:.1f} mm" if moved > STAYS else ""


if __name__ == "__main__":
    main()
