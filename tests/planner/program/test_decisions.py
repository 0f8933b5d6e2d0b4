"""Areas that a request, a brief and a footprint state: they agree, or the request is refused."""

from typing import Any

import pytest

from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest, Footprint
from mansion_planner.plan import plan_building

OUTLINE = Footprint(boundary=[(0, 0), (20, 0), (20, 10), (0, 10)])


@pytest.mark.parametrize(
    ("description", "options", "path"),
    [
        ("a two-storey office", {"area": 1000.0, "floor_area": 100.0}, "$.floor_area"),
        ("a shop", {"footprint": OUTLINE, "floor_area": 215.0}, "$.footprint"),
        ("a two-storey shop", {"footprint": OUTLINE, "area": 200.0}, "$.footprint"),
    ],
)
def test_two_fields_of_the_request_that_do_not_agree_are_refused(
    description: str, options: dict[str, Any], path: str
) -> None:
    with pytest.raises(MansionError) as caught:
        plan_building(BuildRequest(description=description, **options))
    assert caught.value.code == "CONTRADICTION"
    assert caught.value.info.path == path


@pytest.mark.parametrize(
    ("description", "options", "storey", "wish"),
    [
        ("a two-storey office of 100 m2 per floor", {"area": 1000.0}, 500.0, "100 m2"),
        ("a two-storey office of 1000 m2", {"floor_area": 300.0}, 300.0, "1000 m2"),
        ("a two-storey office of 1000 m2", {"area": 500.0}, 250.0, "1000 m2"),
        ("a two-storey office, 1000 m2 in total, 300 m2 per floor", {}, 500.0, "300 m2"),
    ],
)
def test_an_area_of_the_text_that_does_not_agree_gives_way_and_is_reported(
    description: str, options: dict[str, Any], storey: float, wish: str
) -> None:
    program = plan_building(BuildRequest(description=description, **options)).program
    assert program.floors[0].gross_floor_area == pytest.approx(storey, rel=0.06)
    assert wish in [downgrade.wish for downgrade in program.downgrades]


@pytest.mark.parametrize(
    ("description", "options", "storey"),
    [
        ("a two-storey office of 1000 m2", {}, 500.0),
        ("a two-storey office of 1000 m2", {"floor_area": 490.0}, 490.0),
        ("a two-storey office", {"area": 800.0}, 400.0),
        ("a shop", {"footprint": OUTLINE, "floor_area": 206.0}, 200.0),
    ],
)
def test_a_storey_gets_the_area_that_is_stated(description: str, options: dict[str, Any], storey: float) -> None:
    program = plan_building(BuildRequest(description=description, **options)).program
    for floor in program.floors:
        assert floor.gross_floor_area == pytest.approx(storey, rel=0.02)


@pytest.mark.parametrize(
    ("description", "storeys"),
    [
        ("A shop of 240 m2 with a sales area of 120 m2, a store and an office.", 1),
        ("A museum of 1200 m2 with an exhibition hall of 400 m2.", 2),
        ("A two-storey shop of 240 m2 with a sales area of 120 m2.", 2),
        ("A shop of 240 m2 with a store and an office.", 2),
        ("An L-shaped café of 170 m2.", 1),
        ("An L-shaped house of 300 m2 on two storeys.", 2),
        ("A U-shaped shop of 240 m2 with a store and an office.", 1),
    ],
)
def test_a_stated_area_is_divided_over_no_more_storeys_than_hold_the_largest_room_or_the_outline(
    description: str, storeys: int
) -> None:
    assert len(plan_building(BuildRequest(description=description)).program.floors) == storeys


@pytest.mark.parametrize(
    ("text", "style"),
    [
        ("An elegant Mediterranean villa of two floors", "mediterranean"),
        ("A Victorian house with an elegant drawing room", "victorian"),
        ("A modern house with a warm feel", "modern"),
    ],
)
def test_a_place_or_an_age_says_more_of_the_style_than_a_mood(text: str, style: str) -> None:
    assert plan_building(BuildRequest(description=text)).program.style == style
