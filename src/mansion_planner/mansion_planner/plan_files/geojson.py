"""Plans in GeoJSON: a FeatureCollection of rooms as polygons, and of doors and windows as lines or points.

``properties`` say what a feature is: ``kind`` (``room``, ``door``, ``opening``, ``window``, ``outline``) and the fields
that such things have in Mansion's own JSON; coordinates are metres in plan.
"""

from typing import Any, Final

from mansion_msgs_py.building_plan import BuildingPlan, PlanDoor, PlanRoom, PlanWindow
from mansion_msgs_py.codec import convert
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["plan_from_geojson"]

_LISTS: Final = {"room": "rooms", "door": "doors", "opening": "openings", "window": "windows"}
_FIELDS: Final = {
    "room": frozenset(PlanRoom.__struct_fields__),
    "door": frozenset(PlanDoor.__struct_fields__),
    "opening": frozenset(PlanDoor.__struct_fields__),
    "window": frozenset(PlanWindow.__struct_fields__),
}
_OF_BUILDING: Final = ("name", "building_type", "style", "units", "complete")
_OF_FLOOR: Final = ("label", "height")


def plan_from_geojson(value: dict[str, Any]) -> BuildingPlan:
    """Return the plan of a FeatureCollection.

    The collection itself may have ``name``, ``building_type``, ``style``, ``units``, ``complete`` and ``floors``, a
    list of objects with ``floor``, ``label`` and ``height``.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` naming the feature at fault.
    """
    floors: dict[Any, dict[str, Any]] = {}
    features = value.get("features")
    if not isinstance(features, list):
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "a FeatureCollection has features", path="$.features")
    for index, feature in enumerate(features):
        properties, geometry = _parts(feature, index)
        floor = floors.setdefault(properties.get("floor", 1), {"floor": properties.get("floor", 1)})
        _add(floor, properties, geometry, f"$.features[{index}]")
    stated = value.get("floors") or []
    for entry in stated if isinstance(stated, list) else ():
        if isinstance(entry, dict) and entry.get("floor") in floors:
            floors[entry["floor"]] |= {name: entry[name] for name in _OF_FLOOR if name in entry}
    said = {name: value[name] for name in _OF_BUILDING if name in value}
    return convert(BuildingPlan, {**said, "floors": list(floors.values())})


def _parts(feature: Any, index: int) -> tuple[dict[str, Any], dict[str, Any]]:
    geometry = feature.get("geometry") if isinstance(feature, dict) else None
    if not isinstance(geometry, dict) or not isinstance(geometry.get("type"), str):
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "a feature needs a geometry", path=f"$.features[{index}]")
    return feature.get("properties") or {}, geometry


def _add(floor: dict[str, Any], properties: dict[str, Any], geometry: dict[str, Any], path: str) -> None:
    shape, coordinates = geometry["type"], geometry.get("coordinates")
    kind = properties.get("kind") or ("room" if shape == "Polygon" else "door")
    if kind == "outline" and shape == "Polygon":
        rings = _rings(coordinates, path)
        floor["outline"], floor["holes"] = rings[0], rings[1:]
        return
    if kind not in _LISTS:
        known = ", ".join([*_LISTS, "outline"])
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"kind {kind!r} is not one of {known}", path=f"{path}.properties")
    entry = {name: said for name, said in properties.items() if name in _FIELDS[kind]}
    if kind == "room":
        if shape != "Polygon":
            raise MansionError(ErrorCode.INVALID_PAYLOAD, f"a room is a Polygon, not a {shape}", path=path)
        rings = _rings(coordinates, path)
        entry |= {"polygon": rings[0], "holes": rings[1:]}
    elif shape == "Point":
        entry["at"] = _plain(coordinates)
    elif shape == "LineString" and isinstance(coordinates, list) and len(coordinates) > 1:
        entry["segment"] = [_plain(coordinates[0]), _plain(coordinates[-1])]
    else:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"a {kind} is a LineString or a Point, not a {shape}", path=path)
    floor.setdefault(_LISTS[kind], []).append(entry)


def _rings(coordinates: Any, path: str) -> list[list[Any]]:
    """Return the rings of a polygon, none with its first point at its end."""
    rings = [ring for ring in coordinates if isinstance(ring, list) and ring] if isinstance(coordinates, list) else []
    if not rings:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "a Polygon needs a ring", path=path)
    return [[_plain(point) for point in (ring[:-1] if ring[0] == ring[-1] else ring)] for ring in rings]


def _plain(point: Any) -> Any:
    """Return a point without its height."""
    return point[:2] if isinstance(point, list) else point
