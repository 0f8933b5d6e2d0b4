"""Drawings in DXF as plans: rooms, names, doors and windows by layers, in the units of the drawing."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest

from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building
from mansion_planner.plan_files import read_plan

ezdxf = pytest.importorskip("ezdxf", reason="needs the extra dxf")

MILLIMETRES = 4
ROOMS = {"Living room": (0, 0, 4000, 4000), "Kitchen": (4120, 0, 7000, 4000)}


def ring(space: Any, box: Sequence[float], layer: str) -> Any:
    """Draw a closed polyline."""
    x0, y0, x1, y1 = box
    return space.add_lwpolyline([(x0, y0), (x1, y0), (x1, y1), (x0, y1)], close=True, dxfattribs={"layer": layer})


def leaf(target: Any, hinge: tuple[float, float], width: float, start: float, layer: str) -> None:
    """Draw a leaf that stands open at `start` degrees beyond a quarter turn, with the arc that it sweeps."""
    target.add_arc(hinge, width, start, start + 90.0, dxfattribs={"layer": layer})


def flat(units: int = MILLIMETRES, prefix: str = "A-") -> Any:
    """Return a drawing of a living room and a kitchen with an entrance, a door between them and a window."""
    drawing = ezdxf.new()
    drawing.header["$INSUNITS"] = units
    space = drawing.modelspace()
    for name, box in ROOMS.items():
        ring(space, box, f"{prefix}ROOM")
        text = space.add_mtext(f"12.40 m²\n{name}", dxfattribs={"layer": f"{prefix}TEXT"})
        text.set_location((box[0] + 500, box[1] + 500))
    block = drawing.blocks.new("D900") if "D900" not in drawing.blocks else drawing.blocks.get("D900")
    block.add_line((0, 0), (0, 900))
    leaf(block, (0, 0), 900, 0.0, "0")
    space.add_blockref("D900", (1000, -150), dxfattribs={"layer": f"{prefix}DOOR"})
    leaf(space, (4060, 2000), 800, 0.0, f"{prefix}DOOR")
    space.add_line((4060, 2000), (4860, 2000), dxfattribs={"layer": f"{prefix}DOOR"})
    for y in (-300, -150, 0):
        space.add_line((5000, y), (6200, y), dxfattribs={"layer": f"{prefix}GLAZ"})
    return drawing


def saved(drawing: Any, folder: Path, name: str = "flat.dxf") -> Path:
    """Write a drawing and return its path."""
    drawing.saveas(folder / name)
    return folder / name


def test_polylines_are_rooms_texts_their_names_and_openings_are_where_they_are_drawn(tmp_path: Path) -> None:
    (floor,) = read_plan(saved(flat(), tmp_path)).floors
    assert [room.name for room in floor.rooms] == ["Living room", "Kitchen"]
    assert sorted(floor.rooms[1].polygon) == [(4.12, 0.0), (4.12, 4.0), (7.0, 0.0), (7.0, 4.0)]
    assert {tuple(sorted(door.segment or ())) for door in floor.doors} == {
        ((1.0, -0.15), (1.9, -0.15)),
        ((4.06, 2.0), (4.06, 2.8)),
    }
    assert [tuple(sorted(window.segment or ())) for window in floor.windows] == [((5.0, -0.15), (6.2, -0.15))]


def test_a_drawing_is_planned_as_it_is(tmp_path: Path) -> None:
    reply = plan_building(BuildRequest(description="", plan=read_plan(saved(flat(), tmp_path))))
    openings = reply.program.floors[0].openings
    assert openings is not None and len(openings.windows or ()) == 1
    assert {frozenset(door.rooms) for door in openings.doors} == {
        frozenset(("living_room", "kitchen")),
        frozenset(("living_room", None)),
    }


@pytest.mark.parametrize("units", [MILLIMETRES, 0])
def test_without_units_the_size_of_rooms_tells_them(tmp_path: Path, units: int) -> None:
    plan = read_plan(saved(flat(units), tmp_path))
    assert max(x for x, _ in plan.floors[0].rooms[1].polygon) == 7.0


def test_inches_of_a_drawing_are_metres_of_the_plan(tmp_path: Path) -> None:
    drawing = ezdxf.new()
    drawing.header["$INSUNITS"] = 1
    ring(drawing.modelspace(), (0, 0, 120, 120), "Rooms")
    assert max(read_plan(saved(drawing, tmp_path)).floors[0].rooms[0].polygon) == pytest.approx((3.048, 3.048))


def test_two_arcs_are_a_double_door(tmp_path: Path) -> None:
    drawing = flat()
    space = drawing.modelspace()
    leaf(space, (2200, 4000), 700, 0.0, "A-DOOR")
    leaf(space, (3600, 4000), 700, 90.0, "A-DOOR")
    doors = read_plan(saved(drawing, tmp_path)).floors[0].doors
    (double,) = [door for door in doors if door.kind == "double"]
    assert sorted(double.segment or ()) == [(2.2, 4.0), (3.6, 4.0)]


def test_windows_in_one_line_stay_apart(tmp_path: Path) -> None:
    drawing = flat()
    for y in (-300, 0):
        drawing.modelspace().add_line((6300, y), (6900, y), dxfattribs={"layer": "A-GLAZ"})
    assert len(read_plan(saved(drawing, tmp_path)).floors[0].windows) == 2


def test_floors_are_told_by_layers(tmp_path: Path) -> None:
    drawing = flat()
    space = drawing.modelspace()
    ring(space, (0, 0, 4000, 4000), "F2-ROOM")
    space.add_text("Bedroom", dxfattribs={"layer": "F2-TEXT", "insert": (500, 500)})
    path = saved(drawing, tmp_path)
    ground, upper = read_plan(path).floors
    assert (ground.floor, upper.floor, upper.rooms[0].name) == (1, 2, "Bedroom")
    (alone,) = read_plan(path.with_name("flat.dxf#2")).floors
    assert (alone.floor, alone.rooms[0].name) == (1, "Bedroom")
    with pytest.raises(MansionError, match=r"no floor '3'.*1, 2"):
        read_plan(path.with_name("flat.dxf#3"))


def test_layers_may_be_said(tmp_path: Path) -> None:
    drawing = flat(prefix="A-")
    other = drawing.modelspace()
    ring(other, (0, 0, 300, 300), "COLUMNS")
    for entity in other:
        if entity.dxf.layer == "A-ROOM":
            entity.dxf.layer = "OUTLINES"
    path = saved(drawing, tmp_path)
    with pytest.raises(MansionError, match=r"closed polylines are on OUTLINES, COLUMNS: say --layers rooms=NAME"):
        read_plan(path)
    assert len(read_plan(path, layers={"rooms": "OUTLINES"}).floors[0].rooms) == 2
    with pytest.raises(MansionError, match=r"nothing is on a layer 'OUTLINE' \(rooms\)"):
        read_plan(path, layers={"rooms": "OUTLINE"})
    with pytest.raises(MansionError, match="--layers walls="):
        read_plan(path, layers={"walls": "OUTLINES"})


def test_a_drawing_of_lines_alone_is_told_to_need_polylines(tmp_path: Path) -> None:
    drawing = ezdxf.new()
    drawing.modelspace().add_line((0, 0), (4, 0))
    with pytest.raises(MansionError, match=r"flat\.dxf: it has no closed polyline; draw one around each room"):
        read_plan(saved(drawing, tmp_path))


def test_the_outline_around_rooms_is_none(tmp_path: Path) -> None:
    drawing = flat()
    ring(drawing.modelspace(), (-300, -300, 7300, 4300), "A-AREA")
    assert len(read_plan(saved(drawing, tmp_path)).floors[0].rooms) == 2


def test_faults_name_the_handle(tmp_path: Path) -> None:
    drawing = flat()
    space = drawing.modelspace()
    overlapping = ring(space, (6000, 500, 9000, 3000), "A-ROOM")
    text = space.add_text("Study", dxfattribs={"layer": "A-TEXT"})
    text.set_placement((8000, 1000))
    far = space.add_line((20000, 0), (20900, 0), dxfattribs={"layer": "A-DOOR"})
    with pytest.raises(MansionError) as refusal:
        plan_building(BuildRequest(description="", plan=read_plan(saved(drawing, tmp_path))))
    faults = refusal.value.info.details["faults"]
    assert any(f"handle {overlapping.dxf.handle}]" in fault and "overlap" in fault for fault in faults)
    assert any(f"[handle {far.dxf.handle}]: is on no wall" in fault for fault in faults)
    assert any(f"[handle {overlapping.dxf.handle}]: cannot be reached" in fault for fault in faults)


@pytest.mark.parametrize("text", ["", "no drawing", "  0\nSECTION\n  2\nENTITIES\n"])
def test_what_is_no_drawing_is_refused_in_one_line(tmp_path: Path, text: str) -> None:
    path = tmp_path / "flat.dxf"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(MansionError, match=r"flat\.dxf") as refusal:
        read_plan(path)
    assert "\n" not in refusal.value.info.message


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(MansionError, match=r"nothing\.dxf: there is no such file"):
        read_plan(tmp_path / "nothing.dxf")
