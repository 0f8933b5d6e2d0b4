"""SearchAssets, ListObjects, CheckSurface and SearchContents: questions that the static state answers."""

from collections.abc import Callable

from mansion_assets.catalogue import Asset
from mansion_editing import geometry
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

__all__ = ["check_surface", "list_objects", "object_info", "search_assets", "search_contents"]

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
    return _report(state, args.id or args.keyword, geometry.on_top, "on")


def search_contents(state: SceneState, args: SearchContentsArgs) -> ReceptacleReport:
    """List what lies in the containers that a keyword or an id names.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when nothing fits.
    """
    return _report(state, args.id or args.keyword, geometry.contents, "in")


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
