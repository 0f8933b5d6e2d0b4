"""Shapes that are none are named by the check and refused in one line by what draws, and nothing breaks on them."""

from collections.abc import Callable
from typing import Any

import pytest

from mansion_bringup.check import check_floors
from mansion_geometry.sound_shapes import require_sound_shapes
from mansion_msgs_py.codec import convert, to_builtins
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.topology import FloorTopology
from sample_building import scene

CROSSING = [[0.0, 0.0], [5.0, 5.0], [5.0, 0.0], [0.0, 5.0]]
RINGS: dict[str, list[list[float]]] = {
    "crossing": CROSSING,
    "empty": [],
    "point": [[1.0, 1.0]],
    "line": [[0.0, 0.0], [1.0, 1.0]],
    "flat": [[0.0, 0.0], [5.0, 0.0], [2.0, 0.0]],
    "repeated": [[1.0, 1.0]] * 5,
}
Json = dict[str, Any]

PLACES: dict[str, Callable[[Json, list[list[float]]], object]] = {
    "outline": lambda value, ring: value.update(outline=ring),
    "courtyard": lambda value, ring: value.update(holes=[ring]),
    "room": lambda value, ring: value["rooms"][1].update(polygon=ring),
    "net": lambda value, ring: value["rooms"][1].update(net_polygon=ring),
    "hole": lambda value, ring: value["rooms"][1].update(holes=[ring]),
    "core": lambda value, ring: value["cores"][0].update(polygon=ring),
}


def spoilt(edit: Callable[[Json], object]) -> FloorScene:
    value = to_builtins(scene(1, [1]))
    edit(value)
    return convert(FloorScene, value)


@pytest.mark.parametrize("form", RINGS)
@pytest.mark.parametrize("place", PLACES)
def test_a_ring_that_is_none_is_a_fault(place: str, form: str) -> None:
    found = spoilt(lambda value: PLACES[place](value, RINGS[form]))
    faults = list(check_floors(found.building_id, [found], [FloorTopology(nodes=[], edges=[])]))
    assert {fault.kind for fault in faults} & {"ROOM_SHAPE", "ROOM_NET", "OUTLINE"}
    with pytest.raises(MansionError, match="mansion check"):
        require_sound_shapes([found])


@pytest.mark.parametrize("group", ["walls", "doors", "windows"])
def test_what_has_no_length_is_a_fault(group: str) -> None:
    def shrink(value: Json) -> None:
        for entry in value[group]:
            entry["segment"] = [[1.0, 1.0], [1.0, 1.0]]

    sound, found = scene(1, [1]), spoilt(shrink)
    if getattr(sound, group):
        assert list(check_floors(found.building_id, [found], [FloorTopology(nodes=[], edges=[])]))


def test_a_sound_floor_has_sound_shapes() -> None:
    require_sound_shapes([scene(1, [1, 2]), scene(2, [1, 2])])
