"""Floor plans show every element once and are the same each time."""

import io
import xml.etree.ElementTree as ElementTree

import msgspec
import numpy as np
from PIL import Image

from mansion_export.plan import draw_plan, plan_png, plan_svg
from mansion_export.plan.palette import room_tint
from mansion_export.plan.shapes import Label

SVG = "{http://www.w3.org/2000/svg}"


def test_svg_names_every_element_of_the_floor(ground):
    root = ElementTree.fromstring(plan_svg(ground))
    ids = {group.get("data-id") for group in root.iter(f"{SVG}g")}
    expected = [*ground.rooms, *ground.walls, *ground.doors, *ground.windows, *ground.cores]
    assert {item.id for item in expected} <= ids
    drawn = {item.id for item in ground.objects if item.mount == "floor"}
    assert drawn <= ids


def test_one_room_is_not_called_rooms(ground):
    alone = msgspec.structs.replace(ground, rooms=ground.rooms[:1], objects=ground.objects[:1])
    texts = " ".join(text.text or "" for text in ElementTree.fromstring(plan_svg(alone)).iter(f"{SVG}text"))
    assert "in 1 room, 1 object, level" in texts


def test_svg_writes_names_and_areas_of_rooms(ground):
    texts = {text.text for text in ElementTree.fromstring(plan_svg(ground)).iter(f"{SVG}text")}
    assert {"Bedroom 1", "20.0 m²", "Kitchen 1", "16.0 m²", "14.40 m", "Lift", "N"} <= texts


def test_same_scene_gives_the_same_bytes(ground, floor_of):
    assert plan_svg(ground) == plan_svg(floor_of(1))
    assert plan_png(ground) == plan_png(floor_of(1))


def test_png_has_walls_rooms_and_paper_where_they_belong(ground):
    drawing = draw_plan(ground)
    picture = Image.open(io.BytesIO(plan_png(ground))).convert("RGB")
    scale = picture.width / drawing.width

    def color(x: float, y: float) -> tuple[int, ...]:
        return picture.getpixel((int((x - drawing.x0) * scale), int((drawing.y1 - y) * scale)))

    tint = room_tint("living_room", "area")
    assert color(6.5, 2.5) == tuple(int(tint[i : i + 2], 16) for i in (1, 3, 5))
    assert max(color(5.0, 8.5)) < 80, "the wall between bedroom and kitchen is dark"
    assert color(2.45, 6.0) == (255, 255, 255), "the bedroom's doorway is open"
    assert color(drawing.x0 + 0.05, drawing.y0 + 0.05) == (255, 255, 255)


def test_labels_lie_in_their_rooms(ground):
    canvases = [canvas for canvas in draw_plan(ground).canvases if canvas.layer == "labels"]
    rooms = [room for room in ground.rooms if room.kind not in ("stair", "elevator")]
    assert len(canvases) == len(rooms)
    for room, canvas in zip(rooms, canvases):
        xs, ys = np.array(room.polygon).T
        for label in canvas.shapes:
            assert isinstance(label, Label)
            assert xs.min() < label.at[0] < xs.max()
            assert ys.min() < label.at[1] < ys.max()


def test_a_swing_lies_in_the_room_that_the_door_opens_into(ground):
    by_id = {canvas.id: canvas for canvas in draw_plan(ground).canvases}
    door = ground.doors[0]
    points = [p for shape in by_id[door.id].shapes for p in getattr(shape, "points", ())]
    assert max(y for _, y in points) > 6.8, "the leaf reaches into the bedroom"
    assert min(y for _, y in points) > 5.85, "and not into the hub"
    ground.doors[0] = msgspec.structs.replace(door, swing="F1/hub")
    by_id = {canvas.id: canvas for canvas in draw_plan(ground).canvases}
    points = [p for shape in by_id[door.id].shapes for p in getattr(shape, "points", ())]
    assert min(y for _, y in points) < 5.2


def test_names_with_markup_stay_text(ground):
    ground.rooms[0] = msgspec.structs.replace(ground.rooms[0], name="Bed & <Breakfast>")
    texts = {text.text for text in ElementTree.fromstring(plan_svg(ground)).iter(f"{SVG}text")}
    assert any(text and "<Breakfast>" in text for text in texts)
