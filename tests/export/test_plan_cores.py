"""A stair's symbol says which ways lead off a floor, each on a flight of its own."""

import numpy as np
import pytest
from shapely.geometry import Point, Polygon, box

from mansion_export.plan.cores import stair_shapes
from mansion_export.plan.shapes import Label, Line
from mansion_msgs_py.program import CorePlan
from mansion_msgs_py.scene import SceneCore
from mansion_scene.structure.stairs import stair_details, stair_frame

OUTLINE = box(0.0, 0.0, 20.0, 12.0)
CORES = {
    "south": ((2.0, 5.0), (0.0, 6.0)),
    "north": ((2.0, 5.0), (6.0, 12.0)),
    "west": ((0.0, 6.0), (2.0, 5.0)),
    "east": ((14.0, 20.0), (2.0, 5.0)),
}


def stair(side: str, *, up: bool, below: bool) -> SceneCore:
    x, y = CORES[side]
    plan = CorePlan(id="stair_1", type="stair", x=x, y=y, door_side=side)
    ring = [(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])]
    frame = stair_frame(plan, Polygon(ring), OUTLINE)
    details = stair_details("stair_1", frame, 3.4, goes_up=up, comes_from_below=below)
    return SceneCore(
        id="stair_1",
        type="stair",
        polygon=ring,
        door="F1/door_1",
        entrance=(0.0, 0.0, 0.0),
        floors=[1, 2, 3],
        details=details,
    )


def words(core: SceneCore) -> dict[str, tuple[float, float]]:
    return {shape.text: shape.at for shape in stair_shapes(core) if isinstance(shape, Label)}


@pytest.mark.parametrize("side", CORES)
@pytest.mark.parametrize(
    ("up", "below", "expected"), [(True, False, {"UP"}), (True, True, {"UP", "DN"}), (False, True, {"DN"})]
)
def test_every_floor_names_the_ways_that_lead_off_it(side, up, below, expected):
    assert set(words(stair(side, up=up, below=below))) == expected


@pytest.mark.parametrize("side", CORES)
@pytest.mark.parametrize(("up", "below"), [(True, False), (True, True), (False, True)])
def test_words_stand_on_the_floor_landing_and_lines_stay_inside(side, up, below):
    core = stair(side, up=up, below=below)
    landing, shaft = Polygon(core.details.floor_landing), Polygon(core.polygon).buffer(1e-6)
    assert all(landing.contains(Point(at).buffer(0.14)) for at in words(core).values())
    for shape in stair_shapes(core):
        if isinstance(shape, Line):
            assert all(shaft.covers(Point(p)) for p in shape.points)


@pytest.mark.parametrize("side", CORES)
def test_the_way_down_starts_at_the_same_flight_on_middle_and_top_floors(side):
    middle, top = (words(stair(side, up=up, below=True)) for up in (True, False))
    assert np.allclose(middle["DN"], top["DN"], atol=0.02)
    assert np.hypot(*np.subtract(middle["DN"], middle["UP"])) > 1.0
