"""Footprint files: Mansion's own JSON, or GeoJSON (RFC 7946) with one polygon in metres."""

from typing import Any

from mansion_msgs_py.codec import encode
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.reading import decode_from
from mansion_msgs_py.request import Footprint

__all__ = ["footprint_from_json"]


def footprint_from_json(data: bytes, source: str) -> Footprint:
    """Read a footprint.

    Parameters
    ----------
    data : bytes
        ``{"boundary": ring, "holes": [ring]}``, or a GeoJSON Polygon, Feature or FeatureCollection of one.
    source : str
        Named in errors.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD``.
    """
    value = decode_from(dict[str, Any], data, source)
    if "type" not in value:
        return decode_from(Footprint, data, source)
    rings = _polygon(value, source)
    if not rings:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{source}: the polygon has no ring")
    open_rings = [_without_repeated_end(ring) for ring in rings]
    fields = {"boundary": open_rings[0], "holes": open_rings[1:]}
    return decode_from(Footprint, encode(fields), source)


def _polygon(value: dict[str, Any], source: str) -> list[Any]:
    kind = value.get("type")
    if kind == "Polygon":
        return list(value.get("coordinates") or [])
    if kind == "Feature" and isinstance(value.get("geometry"), dict):
        return _polygon(value["geometry"], source)
    if kind == "FeatureCollection":
        features = value.get("features")
        if isinstance(features, list) and len(features) == 1 and isinstance(features[0], dict):
            return _polygon(features[0], source)
    raise MansionError(
        ErrorCode.INVALID_PAYLOAD,
        f"{source}: GeoJSON of type {kind!r}; expected one Polygon, a Feature or a FeatureCollection of one",
        path="$.type",
    )


def _without_repeated_end(ring: Any) -> Any:
    if isinstance(ring, list) and len(ring) > 1 and ring[0] == ring[-1]:
        return ring[:-1]
    return ring
