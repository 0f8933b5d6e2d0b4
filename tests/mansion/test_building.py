"""A building as one object: its parts, pictures, changes, files and tasks."""

import gc
import html
import pickle
from dataclasses import FrozenInstanceError
from importlib.util import find_spec
from pathlib import Path

import networkx as nx
import numpy as np
import pytest

import mansion
from mansion_bringup import extras
from mansion_msgs_py.building_folder import BuildingFolder

needs_sim = pytest.mark.skipif(find_spec("mujoco") is None, reason="needs the extra sim")


def test_a_building_without_a_folder_lives_as_long_as_something_needs_it(flat: mansion.Building) -> None:
    request = flat.request
    b = mansion.build(request)
    folder = b.folder
    assert folder.is_dir() and b.id == flat.id
    robot = b.robot()
    del b
    gc.collect()
    assert folder.is_dir()
    del robot
    gc.collect()
    assert not folder.exists() and not folder.parent.exists()


def test_a_temporary_building_can_be_kept(flat: mansion.Building, tmp_path: Path) -> None:
    with mansion.build(flat.request) as b:
        kept = b.save(tmp_path / "kept")
    assert not b.folder.exists()
    assert kept.objects == flat.objects
    with pytest.raises(mansion.MansionError, match="name a new folder") as caught:
        flat.save(kept.folder)
    assert caught.value.code == "CONFLICT"


def test_the_parts_are_those_of_the_scenes(flat: mansion.Building) -> None:
    scenes = BuildingFolder(flat.folder).scenes()
    assert [floor.scene for floor in flat.floors] == scenes
    assert flat.objects.ids == tuple(item.id for scene in scenes for item in scene.objects)
    rooms = [room for scene in scenes for room in scene.rooms if room.kind not in ("stair", "elevator")]
    assert flat.rooms.ids == tuple(room.id for room in rooms)
    assert flat.rooms.objects.ids == tuple(
        item.id for room in rooms for scene in scenes for item in scene.objects if item.room == room.id
    )


def test_parts_do_not_change_and_travel_to_other_processes(flat: mansion.Building) -> None:
    room = flat.rooms["kitchen"]
    with pytest.raises(FrozenInstanceError):
        room.area = 1.0  # type: ignore[misc]
    room.objects[0].states["open"] = True
    assert flat.rooms["kitchen"].objects[0].states == room.objects[0].states
    assert pickle.loads(pickle.dumps(room)) == room
    assert hash(flat.objects) == hash(flat.floors.objects)


@pytest.mark.parametrize("name", ["F1/kitchen", "kitchen", "Kitchen", " f1/KITCHEN "])
def test_a_room_is_taken_by_id_or_name(flat: mansion.Building, name: str) -> None:
    assert flat.rooms[name].id == "F1/kitchen"


def test_a_wrong_name_says_what_there_is(flat: mansion.Building) -> None:
    with pytest.raises(mansion.MansionError, match="did you mean F1/kitchen") as caught:
        flat.rooms["kitchn"]
    assert caught.value.code == "NOT_FOUND"
    with pytest.raises(mansion.MansionError, match="there is no floor 3; floors: 1"):
        flat.floors[3]
    assert flat.rooms.get("kitchn") is None and flat.floors.get(3) is None


def test_a_name_of_several_asks_which(flat: mansion.Building) -> None:
    lights = flat.objects.filter(category="ceiling_light")
    assert len(lights) > 1
    with pytest.raises(mansion.MansionError, match="give an id") as caught:
        flat.objects["ceiling light"]
    assert caught.value.info.details["candidates"] == list(lights.ids)


def test_filters_compose_and_refuse_fields_that_there_are_not(flat: mansion.Building) -> None:
    carried = flat.objects.filter(pickupable=True).filter(lambda item: item.parent is not None)
    assert carried and all(item.pickupable and item.parent in flat.objects for item in carried)
    assert carried[:2].ids == carried.ids[:2]
    with pytest.raises(mansion.MansionError, match="did you mean category") as caught:
        flat.objects.filter(categry="chair")
    assert caught.value.code == "INVALID_PAYLOAD"


@pytest.mark.parametrize(
    ("words", "kinds"),
    [
        ("something to sit on", {"chair", "armchair", "pouf", "sofa"}),
        ("somewhere to sleep", {"bed", "sofa"}),
        ("fridge", {"fridge"}),
        ("the fridges", {"fridge"}),
        ("something to read", {"book", "book_stack", "magazine", "newspaper"}),
        ("a lift", set()),
        ("grand piano", set()),
        ("", set()),
    ],
)
def test_objects_are_found_by_name_and_by_what_they_are_for(
    flat: mansion.Building, words: str, kinds: set[str]
) -> None:
    found = flat.objects.find(words)
    assert {item.category for item in found} == kinds & {item.category for item in flat.objects}
    assert bool(found) == bool(kinds)


def test_a_colour_in_the_words_is_a_colour_of_the_object(copy: mansion.Building) -> None:
    copy.edit("put a red mug on the coffee table", physics="static")
    mugs = copy.objects.find("mug")
    red = copy.objects.find("a red mug")
    assert red and set(red) < set(mugs)
    assert all("red" in item.material.split("_") for item in red)
    assert not copy.objects.find("purple mug")


def test_what_is_found_in_a_room_is_in_it(flat: mansion.Building) -> None:
    room = flat.rooms["bedroom"]
    assert {item.room for item in room.objects.find("lamp")} == {room.id}
    assert flat.rooms.find("the largest room").ids == (max(flat.rooms, key=lambda room: room.area).id,)
    assert flat.rooms.find("bedrooms") == flat.rooms.filter(type="bedroom")
    assert not flat.rooms.filter(type="kitchen").find("the bathroom")
    with pytest.raises(mansion.MansionError, match="there is no floor third"):
        flat.rooms.find("bedrooms on the third floor")


def test_tables_are_plain_values(flat: mansion.Building) -> None:
    (row, *_) = flat.objects.records()
    assert row["id"] == flat.objects[0].id and set(row) == set(mansion.Objects.columns)
    shown = flat.objects._repr_html_()
    assert shown.count("<tr>") == 61 and f"and {len(flat.objects) - 60} more" in shown


def test_a_receipt_says_what_each_wish_was_read_as() -> None:
    plan = mansion.plan("a two-storey house with three bedrooms")
    rows = {row["text"]: row for row in plan.wishes.records()}
    assert rows["three bedrooms"]["read_as"].startswith("3 bedrooms")
    assert list(rows["three bedrooms"]) == ["id", "text", "read_as", "kind", "status", "reason"]
    table = plan.wishes._repr_html_()
    assert table.count("<th>") == 6 and all(html.escape(row["read_as"]) in table for row in rows.values())


def test_a_notebook_shows_plans_and_the_whole(flat: mansion.Building, tmp_path: Path) -> None:
    plan = flat.plan(1)
    assert plan._repr_svg_() == (flat.folder / "floors/floor_1/plan.svg").read_text()
    assert plan.save(tmp_path / "plan.png").read_bytes() == (flat.folder / "floors/floor_1/plan.png").read_bytes()
    assert flat._repr_png_() == (flat.folder / "building.png").read_bytes()
    assert "data:image/png;base64," in flat._repr_html_() and flat.description in flat._repr_html_()
    assert flat.wishes._repr_html_().startswith("<table>")


def test_rooms_and_doors_are_a_graph(flat: mansion.Building) -> None:
    graph = flat.graph()
    assert set(graph) == set(flat.rooms.ids)
    assert nx.is_connected(graph)
    assert graph.nodes["F1/kitchen"]["type"] == "kitchen"
    assert all(width > 0.5 for _, _, width in graph.edges(data="width"))


def test_an_edit_says_what_changed_and_is_undone(copy: mansion.Building) -> None:
    before = copy.objects
    lamp = copy.rooms["living_room"].objects.find("floor lamp")[0]
    done = copy.edit("put two mugs on the coffee table and turn the floor lamp in the living room on", physics="static")
    assert done and len(done.added) == 2 and not done.removed
    assert [(old.id, old.states["on"], new.states["on"]) for old, new in done.changed] == [(lamp.id, False, True)]
    assert set(done.added) == set(copy.objects) - set(before) - {new for _, new in done.changed}
    assert copy.undo().removed.ids == done.added.ids
    assert copy.objects == before
    assert copy.redo().added.ids == done.added.ids
    assert not copy.check()


def test_a_question_is_answered_and_changes_nothing(copy: mansion.Building) -> None:
    answer = copy.edit("how many fridges are in the kitchen?", physics="static")
    assert "1 fridge" in str(answer) and not answer


def test_what_is_not_done_is_an_error_with_its_reason(copy: mansion.Building) -> None:
    before = copy.objects
    with pytest.raises(mansion.MansionError, match="piano") as caught:
        copy.edit("put the grand piano into the fridge", physics="static")
    assert caught.value.code == "INFEASIBLE" and caught.value.info.details["failed"]
    assert copy.objects == before
    with pytest.raises(mansion.MansionError):
        copy.undo()


def test_an_edit_of_a_room_names_it(copy: mansion.Building) -> None:
    done = copy.edit("rename the kitchen to Galley", physics="static")
    assert done.rooms.ids == ("F1/kitchen",)
    assert copy.rooms["Galley"].id == "F1/kitchen"


def test_a_format_that_there_is_not_is_refused_with_the_list(flat: mansion.Building, tmp_path: Path) -> None:
    with pytest.raises(mansion.MansionError, match="use one of thor") as caught:
        flat.export("dwg", tmp_path)
    assert caught.value.code == "NOT_FOUND"
    (page,) = flat.export("html", tmp_path / "page")
    assert page.parent == tmp_path / "page" and page.stat().st_size > 10_000


def test_a_missing_extra_is_named_and_not_installed(flat: mansion.Building, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(extras.EXTRAS, "sim", ("no_such_module",))
    monkeypatch.setitem(extras.EXTRAS, "usd", ("no_such_module",))
    wants = (flat.look, flat.env, lambda: flat.export("usd"), lambda: flat.edit("put a mug on the coffee table"))
    for want, name in zip(wants, ("sim", "sim", "usd", "sim"), strict=True):
        with pytest.raises(mansion.MansionError, match=f"the extra '{name}'") as caught:
            want()
        assert caught.value.code == "UNAVAILABLE"


@needs_sim
def test_a_look_is_a_picture_of_the_room(flat: mansion.Building) -> None:
    seen = flat.look("kitchen", width=96, height=64)
    assert seen.shape == (64, 96, 3) and seen.dtype == np.uint8 and seen.std() > 5
    assert (flat.look("kitchen", width=96, height=64) == seen).all()
    assert (flat.look("bathroom", width=96, height=64) != seen).any()
    assert flat.look("kitchen", part="depth", width=96, height=64).shape == (64, 96)
    with pytest.raises(mansion.MansionError, match="did you mean depth"):
        flat.look("kitchen", part="deph")  # type: ignore[arg-type]
    with pytest.raises(mansion.MansionError, match="there is no 'ballroom'"):
        flat.look("ballroom")


@needs_sim
def test_an_edit_is_seen(copy: mansion.Building) -> None:
    before = copy.look("living_room", part="segmentation", width=160, height=120)
    copy.edit("paint the walls of the living room green", physics="static")
    assert (copy.look("living_room", part="segmentation", width=160, height=120) == before).all()
    copy.edit("remove the armchairs from the living room", physics="static")
    assert (copy.look("living_room", part="segmentation", width=160, height=120) != before).any()


def test_tasks_are_those_of_the_command_line(flat: mansion.Building) -> None:
    tasks = flat.tasks(2, seed=1, kind="deliver")
    assert len(tasks) == 2 and {task.kind for task in tasks} == {"deliver"}
    assert tasks == flat.tasks(2, seed=1, kind="deliver")
    with pytest.raises(mansion.MansionError, match="kinds: deliver, search, open_and_put, collect"):
        flat.tasks(kind="dance")


@needs_sim
def test_the_environment_begins_the_task(flat: mansion.Building) -> None:
    (task,) = flat.tasks(1)
    env = flat.env(task, actions="low")
    _, info = env.reset(seed=0)
    assert info["instruction"] == task.instruction
    assert env.observation_space.contains(env.reset(seed=0)[0])
    env.close()


def test_the_same_sentence_and_seed_give_the_same_building(flat: mansion.Building, tmp_path: Path) -> None:
    again = mansion.build(flat.description, tmp_path / "again", seed=flat.seed)
    assert again.floors[1].scene == flat.floors[1].scene


@pytest.mark.parametrize(
    ("options", "code"),
    [
        ({"floors": 0}, "INVALID_PAYLOAD"),
        ({"seed": -1}, "INVALID_PAYLOAD"),
        ({"footprint": "nowhere.json"}, "NOT_FOUND"),
        ({"footprint": [(0, 0), (1, 1)]}, "INVALID_PAYLOAD"),
    ],
)
def test_options_that_do_not_fit_are_refused(options: dict[str, object], code: str) -> None:
    with pytest.raises(mansion.MansionError) as caught:
        mansion.plan("a flat", **options)  # type: ignore[arg-type]
    assert caught.value.code == code


def test_an_outline_is_taken_as_corners() -> None:
    plan = mansion.plan("a small office", footprint=[(0, 0), (14, 0), (14, 10), (0, 10)])
    assert {tuple(point) for point in plan.floors[0].outline} <= {(x, y) for x in range(15) for y in range(11)}
    assert str(plan).splitlines()[-1] == plan.wishes.summary


def test_progress_is_told(flat: mansion.Building, tmp_path: Path) -> None:
    told: list[str] = []
    mansion.build(flat.request, tmp_path / "told", progress=lambda step: told.append(step.stage))
    assert told[0] == "plan_program" and told[-1] == "done"
