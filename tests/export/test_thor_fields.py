"""House JSON against the fields that AI2-THOR reads (ProceduralData.cs): names, and types that its reader takes."""

import json
from numbers import Real

import pytest

from mansion_export.thor import house


def vector(value):
    return isinstance(value, dict) and set(value) == {"x", "y", "z"} and all(map(number, value.values()))


def number(value):
    return isinstance(value, Real) and not isinstance(value, bool)


def flag(value):
    return isinstance(value, bool)


def text(value):
    return isinstance(value, str)


def points(value):
    return isinstance(value, list) and all(map(vector, value))


def texts(value):
    return isinstance(value, list) and all(map(text, value))


def color(value):
    return isinstance(value, dict) and {"r", "g", "b"} <= set(value) and all(map(number, value.values()))


def material(value):
    return isinstance(value, dict) and text(value["name"]) and color(value.get("color", {"r": 0, "g": 0, "b": 0}))


HOLE = {
    "id": text, "assetId": text, "room0": text, "room1": text, "wall0": text, "wall1": text,
    "holePolygon": points, "assetPosition": vector, "openable": flag, "openness": number, "scale": vector,
}  # fmt: skip
FIELDS = {
    "rooms": {"id": text, "roomType": text, "floorMaterial": material, "layer": text, "floorPolygon": points},
    "walls": {"id": text, "polygon": points, "roomId": text, "layer": text, "material": material, "empty": flag,
              "thickness": number},
    "doors": HOLE,
    "windows": HOLE,
    "objects": {"id": text, "assetId": text, "position": vector, "rotation": vector, "kinematic": flag,
                "layer": text, "openness": number, "isOn": flag, "isDirty": flag},
}  # fmt: skip
LIGHT = {
    "id": text, "type": text, "position": vector, "rotation": vector, "intensity": number, "range": number,
    "indirectMultiplier": number, "rgb": color, "cullingMaskOff": texts,
}  # fmt: skip
NEEDED = {
    "rooms": {"id", "roomType", "floorMaterial", "floorPolygon"},
    "walls": {"id", "polygon", "roomId", "material"},
    "doors": set(HOLE) - {"scale"},
    "windows": {"id", "assetId", "wall0", "wall1", "holePolygon", "assetPosition"},
    "objects": {"id", "assetId", "position", "rotation", "kinematic"},
}


@pytest.mark.parametrize("part", list(FIELDS))
def test_entries_have_the_fields_that_the_simulator_reads(building, part):
    for scene in building:
        made = json.loads(json.dumps(house(scene)))
        entries = list(made[part])
        assert entries
        while entries:
            entry = entries.pop()
            if part == "objects":
                entries += entry["children"]
            assert NEEDED[part] <= set(entry)
            for name, fits in FIELDS[part].items():
                assert name not in entry or fits(entry[name]), (entry["id"], name)


def test_lights_and_poses_have_them_too(building):
    for scene in building:
        made = json.loads(json.dumps(house(scene)))
        for light in made["proceduralParameters"]["lights"]:
            for name, fits in LIGHT.items():
                assert name not in light or fits(light[name]), (light["id"], name)
        for pose in made["metadata"]["agentPoses"].values():
            assert number(pose["horizon"])
            assert vector(pose["position"]) and vector(pose["rotation"])
