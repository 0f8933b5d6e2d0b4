"""Footprint files: our JSON and GeoJSON, with errors that name the file and the place."""

import json

import pytest

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.request import footprint_from_json

SQUARE = [[0, 0], [12, 0], [12, 9], [0, 9]]
COURT = [[4, 3], [8, 3], [8, 6], [4, 6]]


def geojson(*rings: list[list[float]]) -> dict[str, object]:
    return {"type": "Polygon", "coordinates": [[*ring, ring[0]] for ring in rings]}


def test_our_json_is_read_as_it_is() -> None:
    footprint = footprint_from_json(json.dumps({"boundary": SQUARE}).encode(), "f.json")
    assert footprint.boundary == [(0, 0), (12, 0), (12, 9), (0, 9)]


@pytest.mark.parametrize("wrap", ["polygon", "feature", "collection"])
def test_geojson_loses_its_repeated_point_and_keeps_its_courtyard(wrap: str) -> None:
    value: dict[str, object] = geojson(SQUARE, COURT)
    if wrap != "polygon":
        value = {"type": "Feature", "properties": {}, "geometry": value}
    if wrap == "collection":
        value = {"type": "FeatureCollection", "features": [value]}
    footprint = footprint_from_json(json.dumps(value).encode(), "f.json")
    assert len(footprint.boundary) == 4
    assert footprint.holes == [[(4, 3), (8, 3), (8, 6), (4, 6)]]


@pytest.mark.parametrize(
    "value",
    [
        {"type": "Point", "coordinates": [0, 0]},
        {"type": "Polygon", "coordinates": []},
        {"type": "Polygon", "coordinates": [[["a", 0], [1, 1], [2, 0]]]},
        {"boundary": [[0, 0], [1, 1]]},
        {"boundery": SQUARE},
        [],
    ],
)
def test_anything_else_is_refused_with_the_name_of_the_file(value: object) -> None:
    with pytest.raises(MansionError) as caught:
        footprint_from_json(json.dumps(value).encode(), "f.json")
    assert caught.value.code == ErrorCode.INVALID_PAYLOAD
