"""Objects that AI2-THOR has assets for, nested in what carries them, and those that it lacks."""

from typing import Any, TypeAlias

from mansion_export.frames import thor_point, thor_rotation
from mansion_export.thor.layers import layer_name
from mansion_msgs_py.scene import FloorScene, SceneObject

__all__ = ["build_objects"]

Json: TypeAlias = dict[str, Any]


def build_objects(scene: FloorScene, layers: dict[str, int]) -> tuple[list[Json], list[Json]]:
    """Make the object trees of a house and the list of what it leaves out.

    Returns
    -------
    (objects, omitted)
        `omitted` holds id, category and reason of each object without an AI2-THOR asset, and of each that would
        hang in the air without one of those.
    """
    made: dict[str, Json] = {}
    omitted: dict[str, Json] = {}
    roots: list[Json] = []
    waiting = {item.id: item for item in scene.objects}
    for item in scene.objects:
        _add(item, waiting, made, omitted, roots, layers)
    return roots, list(omitted.values())


def _add(
    item: SceneObject,
    items: dict[str, SceneObject],
    made: dict[str, Json],
    omitted: dict[str, Json],
    roots: list[Json],
    layers: dict[str, int],
) -> None:
    """Add an object after what carries it."""
    if item.id in made or item.id in omitted:
        return
    parent = items.get(item.parent or "")
    if parent is not None and parent is not item:
        _add(parent, items, made, omitted, roots, layers)
    reason = ""
    if item.asset_id is None:
        reason = "AI2-THOR has no such asset"
    elif parent is not None and parent.id in omitted:
        reason = f"{parent.id}, which carries it, is left out"
    if reason:
        omitted[item.id] = {"id": item.id, "category": item.category, "reason": reason}
        return
    made[item.id] = _object(item, layers)
    siblings = made[parent.id]["children"] if parent is not None else roots
    siblings.append(made[item.id])


def _object(item: SceneObject, layers: dict[str, int]) -> Json:
    """One object; its position is the centre of its bounding box."""
    width, depth, height = item.size
    made: Json = {
        "id": item.id,
        "assetId": item.asset_id,
        "position": thor_point(*item.position),
        "rotation": thor_rotation(item.rotation),
        "kinematic": not item.pickupable,
        "roomId": item.room,
        "size": thor_point(width, depth, height),
        "children": [],
    }
    if item.room in layers:
        made["layer"] = layer_name(layers[item.room])
    if "open" in item.states:
        made["openness"] = float(item.states["open"])
    if "on" in item.states:
        made["isOn"] = bool(item.states["on"])
    return made
