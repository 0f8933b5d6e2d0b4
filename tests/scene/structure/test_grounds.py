"""Parts of the plot lie beside the building and each other, and hold what is asked for."""

import itertools
from typing import get_args

from hypothesis import given
from hypothesis import strategies as st
from shapely.geometry import Polygon, box

from mansion_knowledge.outside_words import outside_words
from mansion_msgs_py.outside import GroundUse, GroundWish
from mansion_msgs_py.scene import Door
from mansion_scene.structure.grounds import AISLE, BAY, ground_areas
from mansion_scene.structure.materials import library

USES = [use for use in get_args(GroundUse) if use not in ("hedge", "fence")]


def door(side: str, width: float, depth: float) -> Door:
    """Return an entrance in the middle of a side of a rectangle."""
    x, y = width / 2, depth / 2
    segments = {
        "south": ((x - 0.5, 0.0), (x + 0.5, 0.0)),
        "east": ((width, y - 0.5), (width, y + 0.5)),
        "north": ((x + 0.5, depth), (x - 0.5, depth)),
        "west": ((0.0, y + 0.5), (0.0, y - 0.5)),
    }
    return Door(id="F1/door_1", kind="entrance", rooms=("F1/hall", None), segment=segments[side], width=1.0, height=2.1)


@given(
    st.sets(st.sampled_from(USES), min_size=1),
    st.integers(0, 90),
    st.sampled_from(["south", "east", "north", "west"]),
    st.floats(6.0, 60.0),
    st.floats(6.0, 40.0),
    st.sampled_from(["house", "hotel"]),
)
def test_areas_lie_clear_of_the_building_of_each_other_and_of_the_street(
    uses: set[GroundUse], count: int, side: str, width: float, depth: float, kind: str
) -> None:
    wishes = [GroundWish(use=use, count=count if use == "parking" else 0) for use in sorted(uses)]
    outline = box(0, 0, width, depth)
    areas = ground_areas(wishes, outline, [door(side, width, depth)], kind)
    assert {area.use for area in areas} == uses
    before = {
        "south": box(-500, -500, 500, 0),
        "east": box(width, -500, 500, 500),
        "north": box(-500, depth, 500, 500),
        "west": box(-500, -500, 0, 500),
    }[side]
    shapes = [(area.use, Polygon(area.polygon)) for area in areas]
    for use, shape in shapes:
        assert shape.is_valid and shape.exterior.is_ccw, use
        assert shape.distance(outline) > 1.0
        assert shape.intersection(before).area < 1e-3
    for (use, shape), (other, beside) in itertools.combinations(shapes, 2):
        if {use, other} == {"garden", "pool"}:
            assert (shape if use == "garden" else beside).covers(beside if use == "garden" else shape)
        else:
            assert shape.intersection(beside).area < 1e-6
    parking = [area for area in areas if area.use == "parking"]
    if parking:
        assert sum(area.count for area in parking) == (count or 10)
        least = BAY[0] * (BAY[1] + AISLE / 2)
        assert all(Polygon(area.polygon).area >= area.count * least - 1e-6 for area in parking)


def test_every_material_that_words_stand_for_is_in_the_library() -> None:
    words = outside_words()
    named = {*words.substances.values(), *words.colours.values(), *words.coverings.values()}
    assert named <= set(library())
