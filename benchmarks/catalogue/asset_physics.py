"""Let every asset rest in MuJoCo, closed and open, and sweep each of its joints.

python benchmarks/catalogue/asset_physics.py [--every] [--steps 1000]
"""

import argparse
import re

import mujoco
import numpy as np

from mansion_assets.catalogue import Asset, load_catalogue
from mansion_assets.meshes import links
from mansion_export.mjcf import floor_mjcf
from mansion_msgs_py.scene import FloorScene, SceneObject, SceneRoom

APART = 6.0
"""Metres between the assets on the floor."""

MOVED, TILTED = 0.05, 10.0
"""Metres and degrees from which an asset counts as fallen."""

DRIFTED = 0.05
"""Share of its range by which a joint may move by itself."""

PASSES = 0.003
"""Metres by which two parts may overlap on the way."""

PRINTED = 20


def main() -> None:
    """Print what falls, what drifts, and which parts pass through others."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--every", action="store_true", help="all assets instead of one of each category")
    parser.add_argument("--steps", type=int, default=1000)
    options = parser.parse_args()
    known = load_catalogue()
    assets = list(known.assets.values()) if options.every else [known.by_category(c)[-1] for c in known.categories]
    standing = [asset for asset in assets if asset.mount in ("floor", "surface", "inside")]
    jointed = [asset for asset in assets if len(links(asset)) > 1]
    for is_open, chosen in ((False, standing), (True, [asset for asset in standing if asset in jointed])):
        fallen, drifted = rest(chosen, options.steps, is_open=is_open)
        state = "open" if is_open else "closed"
        print(f"{state}: {len(chosen)} assets, {len(fallen)} fallen, {len(drifted)} joints drifted")
        print("\n".join(f"  {line}" for line in (*fallen, *drifted)[:PRINTED]))
    count, found = sweep(jointed)
    print(f"{count} joints of {len(jointed)} assets swept, {len(found)} pass through something")
    print("\n".join(f"  {line}" for line in found[:PRINTED]))


def hall(assets: list[Asset], *, is_open: bool) -> FloorScene:
    """Return a floor with the assets in rows."""
    row = int(np.ceil(np.sqrt(max(len(assets), 1))))
    side = APART * (row + 1)
    ring = [(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)]
    room = SceneRoom(id="hall", room_type="hall", kind="main", polygon=ring, net_polygon=ring, area=side * side)
    items = [
        SceneObject(
            id=asset.key,
            room="hall",
            category=asset.category,
            asset=asset.key,
            position=(APART * (i % row + 1), APART * (i // row + 1), asset.size[2] / 2),
            rotation=0.0,
            size=asset.size,
            pickupable=True,
            states={"open": is_open},
        )
        for i, asset in enumerate(assets)
    ]
    return FloorScene(
        building_id="hall", floor=1, floors=1, label="1", elevation=0.0, height=3.0, outline=ring, rooms=[room],
        walls=[], doors=[], objects=items,
    )  # fmt: skip


def rest(assets: list[Asset], steps: int, *, is_open: bool) -> tuple[list[str], list[str]]:
    """Step free assets on the floor, and say which fell and which joints moved."""
    export = floor_mjcf(hall(assets, is_open=is_open), "", free_pickupables=True, articulated=True)
    model = mujoco.MjModel.from_xml_string(export.xml, export.meshes)
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    places, turns, angles = data.xpos.copy(), data.xquat.copy(), data.qpos.copy()
    for _ in range(steps):
        mujoco.mj_step(model, data)
    fallen = []
    for asset in assets:
        body = model.body(asset.key).id
        moved = float(np.linalg.norm(data.xpos[body] - places[body]))
        tilt = float(np.degrees(2 * np.arccos(min(1.0, abs(float(data.xquat[body] @ turns[body]))))))
        if moved > MOVED or tilt > TILTED:
            fallen.append(f"{asset.key} ({asset.recipe}): {moved:.3f} m, {tilt:.0f} degrees")
    drifted = []
    for j in range(model.njnt):
        place = model.jnt_qposadr[j]
        if model.jnt_type[j] != mujoco.mjtJoint.mjJNT_FREE:
            way = abs(float(data.qpos[place] - angles[place])) / float(model.jnt_range[j][1])
            if way > DRIFTED:
                drifted.append(f"{model.jnt(j).name}: {way:.0%} of its range")
    return fallen, drifted


def sweep(assets: list[Asset]) -> tuple[int, list[str]]:
    """Move each joint from closed to open, and say whose part meets another."""
    export = floor_mjcf(hall(assets, is_open=False), "", articulated=True)
    # The export lets a part and its own body overlap; here they may not.
    xml = re.sub(r"  <contact>.*?</contact>\n", "", export.xml, flags=re.DOTALL)
    model = mujoco.MjModel.from_xml_string(xml, export.meshes)
    data = mujoco.MjData(model)
    parts = [model.jnt(j).name for j in range(model.njnt)]
    worst: dict[str, float] = {}
    by_asset: dict[str, list[int]] = {}
    for j, name in enumerate(parts):
        by_asset.setdefault(name.rsplit("/", 1)[0], []).append(j)
    # Assets are out of each other's reach, so one joint of each moves at a time.
    for turn in range(max(len(joints) for joints in by_asset.values())):
        moving = [joints[turn] for joints in by_asset.values() if turn < len(joints)]
        for share in np.linspace(0.0, 1.0, 13):
            data.qpos[:] = 0.0
            data.qpos[moving] = share * model.jnt_range[moving, 1]
            mujoco.mj_forward(model, data)
            for contact in data.contact:
                for geom in contact.geom:
                    name = model.body(model.geom_bodyid[geom]).name
                    if contact.dist < -PASSES and name in parts:
                        worst[name] = min(worst.get(name, 0.0), float(contact.dist))
    return len(parts), [f"{name}: {-depth * 1000:.0f} mm" for name, depth in sorted(worst.items())]


if __name__ == "__main__":
    main()
