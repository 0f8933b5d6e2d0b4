"""SearchAssets, ListObjects, CheckSurface and SearchContents: questions that the static state answers."""

import math
from collections.abc import Callable

import numpy as np
import numpy.typing as npt

from mansion_assets.catalogue import Asset
from mansion_editing.references import find_rooms, matching_objects
from mansion_editing.state import FloorIndex, SceneState
from mansion_msgs_py.editing import (
    AssetHits,
    AssetInfo,
    CheckSurfaceArgs,
    ListObjectsArgs,
    ObjectInfo,
    ObjectList,
    ReceptacleContents,
    ReceptacleReport,
    SearchAssetsArgs,
    SearchContentsArgs,
)
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneObject
from mansion_scene.decor.frames import to_local

__all__ = [
    "Column",
    "check_surface",
    "contents",
    "list_objects",
    "object_info",
    "on_top",
    "search_assets",
    "search_contents",
    "within_plan",
]

REST = 0.05
"""Greatest distance between a surface and the foot of what rests on it, metres."""

LOW = 0.02
"""Furniture lower than this stands on the floor, metres."""

EDGE = 0.01
"""Slack of footprints, metres."""

Column = npt.NDArray[np.intp]
"""Numbers of the objects whose centre lies over a receptacle."""


def within_plan(index: FloorIndex, receptacle: SceneObject) -> Column:
    """Return the objects whose centroid lies within the receptacle's rectangle, seen from above; itself left out."""
    boxes = index.boxes
    angle = math.radians(-receptacle.rotation)
    dx = boxes[:, 0] - receptacle.position[0]
    dy = boxes[:, 1] - receptacle.position[1]
    u = math.cos(angle) * dx - math.sin(angle) * dy
    v = math.sin(angle) * dx + math.cos(angle) * dy
    inside = (np.abs(u) <= receptacle.size[0] / 2 + EDGE) & (np.abs(v) <= receptacle.size[1] / 2 + EDGE)
    own = index.at.get(receptacle.id, -1)
    return np.array([n for n in np.flatnonzero(inside) if n != own], dtype=np.intp)


def on_top(index: FloorIndex, receptacle: SceneObject, asset: Asset | None) -> list[SceneObject]:
    """Return what rests on a receptacle: on its top, or on a surface of its asset (a seat, a shelf).

    Notes
    -----
    On top is a child whose centroid lies above the top of the parent's bounding box and whose foot is within 5 cm
    of it. What hangs from the ceiling rests on nothing. Where something stands in between, that one is the carrier.
    """
    found = []
    for number in within_plan(index, receptacle):
        item = index.objects[int(number)]
        if item.mount == "ceiling" or (item.mount == "wall" and item.parent is None):
            continue
        foot = item.position[2] - item.size[2] / 2
        if item.mount == "floor" and foot < LOW and receptacle.size[2] > REST:
            continue
        if _rests(item, receptacle, asset) and not _nested(index, item, receptacle):
            found.append(item)
    return found


def contents(index: FloorIndex, receptacle: SceneObject, asset: Asset | None) -> list[SceneObject]:
    """Return what lies in a container: its centroid strictly within the container's vertical range.

    Notes
    -----
    What rests on a seat, a mattress or a top below the container's highest point is not inside it; what stands on one
    of its shelves is, as the card has it, and lies on it too. Furniture that stands below a table top on the floor is
    inside only where one of the container's inner boxes holds it.
    """
    low = receptacle.position[2] - receptacle.size[2] / 2
    high = receptacle.position[2] + receptacle.size[2] / 2
    found = []
    for number in within_plan(index, receptacle):
        item = index.objects[int(number)]
        if item.mount == "ceiling" or not low < item.position[2] < high:
            continue
        loose = item.mount in ("surface", "inside") or item.pickupable
        held = _in_volume(item, receptacle, asset)
        open_seat = not held and _rests(item, receptacle, asset, shelves=False)
        if (held or (loose and not open_seat)) and not _nested(index, item, receptacle):
            found.append(item)
    return found


def _rests(item: SceneObject, receptacle: SceneObject, asset: Asset | None, *, shelves: bool = True) -> bool:
    foot = item.position[2] - item.size[2] / 2
    top = receptacle.position[2] + receptacle.size[2] / 2
    if item.position[2] > top and abs(foot - top) <= REST:
        return True
    if asset is None:
        return False
    x, y = to_local(receptacle, item.position)
    for s in asset.surfaces:
        if s.kind == "shelf" and not shelves:
            continue
        near = abs(foot - (receptacle.position[2] + s.z)) <= REST
        if near and abs(x - s.x) <= s.w / 2 + EDGE and abs(y - s.y) <= s.d / 2 + EDGE:
            return True
    return False


def _in_volume(item: SceneObject, receptacle: SceneObject, asset: Asset | None) -> bool:
    if asset is None:
        return False
    x, y = to_local(receptacle, item.position)
    z = item.position[2] - receptacle.position[2]
    return any(
        abs(x - v.x) <= v.w / 2 + EDGE and abs(y - v.y) <= v.d / 2 + EDGE and abs(z - v.z) <= v.h / 2 + EDGE
        for v in asset.volumes
    )


def _nested(index: FloorIndex, item: SceneObject, receptacle: SceneObject) -> bool:
    """Whether the scene names another carrier that stands on or in this receptacle itself, and still holds the item."""
    number = index.at.get(item.parent or "", -1)
    if number < 0 or item.parent == receptacle.id:
        return False
    carrier = index.objects[number]
    x, y = to_local(carrier, item.position)
    over = abs(x) <= carrier.size[0] / 2 + EDGE and abs(y) <= carrier.size[1] / 2 + EDGE
    low, high = item.position[2] - item.size[2] / 2, item.position[2] + item.size[2] / 2
    base = carrier.position[2] - carrier.size[2] / 2
    roof = carrier.position[2] + carrier.size[2] / 2
    return over and low <= roof + REST and high >= base


MOST_RECEPTACLES = 20
_PROPERTIES = ("pickupable", "receptacle", "openable", "toggleable")


def search_assets(state: SceneState, args: SearchAssetsArgs) -> AssetHits:
    """Retrieve assets by words, with the state's retriever.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for an unknown property.
    """
    found = state.retriever.retrieve(state.catalogue, args.query, args.top_k, args.properties)
    assets = [
        AssetInfo(
            asset_id=hit.asset.key,
            category=hit.asset.category,
            name=hit.asset.name,
            size=hit.asset.size,
            score=hit.score,
            material=hit.asset.material,
            properties=_properties(hit.asset, None),
        )
        for hit in found.hits
    ]
    names = ", ".join(asset.asset_id for asset in assets) or f"nothing fits {args.query!r}"
    return AssetHits(message=names + (f" ({found.note})" if found.note else ""), assets=assets)


def list_objects(state: SceneState, args: ListObjectsArgs) -> ObjectList:
    """List the objects of the building, or those of a room, or those that a keyword or an id names.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a room that is not there.
    """
    rooms = None
    if args.room:
        found = find_rooms(state, args.room)
        if not found:
            raise MansionError(ErrorCode.NOT_FOUND, f"no room {args.room[:120]!r}", path="$.room")
        rooms = sorted({room.id for _, room in found})
    wanted = args.id or args.keyword
    if wanted:
        pairs = matching_objects(state, wanted, rooms)
    else:
        pairs = [p for p in state.objects() if rooms is None or p[1].room in rooms]
    shown = [object_info(state, floor, item) for floor, item in pairs[: args.limit]]
    return ObjectList(message=_count(len(pairs), "object"), total=len(pairs), objects=shown)


def check_surface(state: SceneState, args: CheckSurfaceArgs) -> ReceptacleReport:
    """List what rests on the receptacles that a keyword or an id names.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when nothing fits.
    """
    return _report(state, args.id or args.keyword, on_top, "on")


def search_contents(state: SceneState, args: SearchContentsArgs) -> ReceptacleReport:
    """List what lies in the containers that a keyword or an id names.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when nothing fits.
    """
    return _report(state, args.id or args.keyword, contents, "in")


def _report(
    state: SceneState,
    reference: str,
    find: Callable[[FloorIndex, SceneObject, Asset | None], list[SceneObject]],
    relation: str,
) -> ReceptacleReport:
    if not reference:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "give a keyword or an id", path="$.keyword")
    found = matching_objects(state, reference)
    if not found:
        state.get(reference, "$.keyword")
    entries = []
    for floor, receptacle in found[:MOST_RECEPTACLES]:
        children = find(state.index(floor), receptacle, state.asset(receptacle))
        entries.append(
            ReceptacleContents(
                receptacle=object_info(state, floor, receptacle),
                objects=[object_info(state, floor, child) for child in children],
            )
        )
    parts = [
        f"{relation} {entry.receptacle.id}: "
        + (", ".join(child.id.rsplit("/", 1)[-1] for child in entry.objects) or "nothing")
        for entry in entries
    ]
    if len(found) > MOST_RECEPTACLES:
        parts.append(f"and {len(found) - MOST_RECEPTACLES} more receptacles; give an id")
    return ReceptacleReport(message="; ".join(parts), receptacles=entries)


def object_info(state: SceneState, floor: int, item: SceneObject) -> ObjectInfo:
    """Return what a tool says of an object, with the properties of its asset in the catalogue."""
    return ObjectInfo(
        id=item.id,
        category=item.category,
        name=item.name,
        asset_id=item.asset,
        floor=floor,
        room=item.room,
        position=item.position,
        mount=item.mount,
        parent=item.parent,
        color=item.color,
        properties=_properties(state.asset(item), item),
        states=item.states,
    )


def _properties(asset: Asset | None, item: SceneObject | None) -> list[str]:
    return [name for name in _PROPERTIES if getattr(asset, name, False) or (item is not None and getattr(item, name))]


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"
