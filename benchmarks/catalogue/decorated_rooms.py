"""Furnish and decorate rooms and draw their plans: ``python benchmarks/catalogue/decorated_rooms.py OUT [SEED]``.

Prints, for each room, how many objects it got and the faults found: overlaps, objects out of the room, and small
objects that hang over their receptacle.
"""

import sys
from pathlib import Path

from shapely import Polygon

from mansion_assets.catalogue import furnish_request, load_catalogue
from mansion_geometry.object_footprints import footprint
from mansion_geometry.randomness import item_seed
from mansion_msgs_py.placement import PlacementOpening, PlacementRoom
from mansion_msgs_py.scene import Door, SceneObject, Window
from mansion_scene.decor import decorate_room, scene_object
from mansion_scene.placement import place_room

ROOMS = [
    ("meeting_room", 6.0, 4.5), ("open_office", 14.0, 10.0), ("private_office", 4.0, 3.5), ("classroom", 9.0, 8.0),
    ("living_room", 6.0, 5.0), ("bedroom", 4.5, 4.0), ("kitchen", 4.5, 3.5), ("bathroom", 3.0, 2.5),
    ("ward", 12.0, 7.0), ("restaurant", 12.0, 8.0), ("sales_area", 18.0, 14.0), ("hotel_room", 6.0, 4.2),
    ("reading_room", 10.0, 8.0), ("laboratory", 9.0, 7.0), ("lobby", 10.0, 7.0), ("corridor", 14.0, 2.4),
    ("cafeteria", 14.0, 10.0), ("gym", 12.0, 9.0), ("gallery", 12.0, 9.0), ("restroom", 6.0, 4.0),
]  # fmt: skip


def furnished(room_type: str, w: float, d: float, seed: int) -> tuple[list[SceneObject], list[SceneObject], int]:
    """Return the placed and the decorating objects of a rectangular room with a door and a window, and the loss."""
    catalogue, room_id = load_catalogue(), f"F1/{room_type}_1"
    ring = [(0.0, 0.0), (w, 0.0), (w, d), (0.0, d)]
    wishes = furnish_request(catalogue, room_type, w * d, seed=seed, style="modern", room_id=room_id, extent=(w, d))
    door = ((w * 0.3, 0.0), (w * 0.3 + 0.9, 0.0))
    window = ((w * 0.35, d), (w * 0.65, d))
    result = place_room(
        PlacementRoom(
            room_id=room_id,
            polygon=ring,
            objects=wishes.floor,
            doors=[PlacementOpening(segment=door, sill=0.0)],
            windows=[PlacementOpening(segment=window, sill=0.9)],
        ),
        seed=item_seed(seed, room_id),
    )
    placed = []
    counts: dict[str, int] = {}
    for p in result.placements:
        asset = wishes.asset_for(p.name, p.size)
        counts[asset.category] = counts.get(asset.category, 0) + 1
        identifier = f"{room_id}/{asset.category}_{counts[asset.category]}"
        placed.append(scene_object(asset, identifier, room_id, (*p.center, p.size[2] / 2), p.rotation))
    extra = decorate_room(
        catalogue,
        wishes,
        room_id=room_id,
        net_polygon=ring,
        ceiling_height=2.8,
        doors=[Door(id="d", kind="single", segment=door, rooms=(room_id, None), width=0.9, height=2.1, hinge="start")],
        windows=[Window(id="w", wall="", room=room_id, segment=window, sill=0.9, height=1.4)],
        placed=placed,
        seed=item_seed(seed, room_id),
    )
    return placed, extra, sum(lost.count for lost in result.discarded)


def faults(placed: list[SceneObject], extra: list[SceneObject], w: float, d: float) -> list[str]:
    """Return what is wrong with a room, from its boxes alone."""
    room = Polygon([(0, 0), (w, 0), (w, d), (0, d)]).buffer(0.005)
    out = []
    carried = [o for o in extra if o.parent]
    standing = placed + [o for o in extra if not o.parent and o.size[2] > 0.025]
    shapes = {o.id: footprint(o) for o in placed + extra}
    by_id = {o.id: o for o in placed + extra}
    out += [f"{o.id} out of the room" for o in placed + extra if not room.contains(shapes[o.id]) and not o.parent]
    for group in (standing, carried):
        for i, a in enumerate(group):
            for b in group[i + 1 :]:
                if a.parent != b.parent or abs(a.position[2] - b.position[2]) > (a.size[2] + b.size[2]) / 2 - 0.003:
                    continue
                if shapes[a.id].intersection(shapes[b.id]).area > 1e-6:
                    out.append(f"{a.id} overlaps {b.id}")
    for o in carried:
        parent = by_id[o.parent or ""]
        if not shapes[parent.id].buffer(0.002).contains(shapes[o.id]):
            out.append(f"{o.id} hangs over {parent.id}")
    return out


def draw(path: Path, placed: list[SceneObject], extra: list[SceneObject], w: float, d: float) -> None:
    """Draw a plan: rugs beige, furniture brown, small things red, wall things blue, ceiling things dotted."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(10, 10 * d / w + 0.5))
    axes = figure.subplots()
    colours = {"floor": "#c8a878", "wall": "#3060c0", "surface": "#c03030", "inside": "#e09090", "ceiling": "#888888"}
    rank = {"floor": 0, "inside": 1, "surface": 2, "wall": 3, "ceiling": 4}
    for o in sorted(placed + extra, key=lambda o: (rank[o.mount], o.size[2] > 0.025)):
        x, y = footprint(o).exterior.xy
        if o.mount == "ceiling":
            axes.plot(x, y, ":", color="#999999", lw=0.8)
            continue
        rug = o.mount == "floor" and o.size[2] < 0.025
        axes.fill(x, y, fc="#efe2c8" if rug else colours[o.mount], ec="#333333", lw=0.5)
        if o.mount == "floor":
            axes.text(o.position[0], o.position[1], o.category, fontsize=5, ha="center", va="center")
    axes.plot([0, w, w, 0, 0], [0, 0, d, d, 0], "k", lw=2)
    axes.plot([w * 0.3, w * 0.3 + 0.9], [0, 0], color="white", lw=3)
    axes.plot([w * 0.35, w * 0.65], [d, d], color="#60c0f0", lw=3)
    axes.set_aspect("equal")
    figure.savefig(path, dpi=90)


def main(argv: list[str]) -> int:
    """Furnish every room, print its counts and faults, draw its plan."""
    out, seed = Path(argv[0]), int(argv[1]) if len(argv) > 1 else 1
    out.mkdir(parents=True, exist_ok=True)
    wrong = 0
    for room_type, w, d in ROOMS:
        placed, extra, lost = furnished(room_type, w, d, seed)
        found = faults(placed, extra, w, d)
        wrong += len(found)
        mounts = {m: sum(o.mount == m for o in extra) for m in ("floor", "wall", "ceiling", "surface", "inside")}
        print(f"{room_type:16} placed {len(placed):3} lost {lost:2} {mounts} faults {len(found)} {found[:3]}")
        draw(out / f"{room_type}.png", placed, extra, w, d)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
