"""The same skills in AI2-THOR, whose controller is a double here."""

import builtins
import sys
from pathlib import Path
from typing import Any

import msgspec
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from invariants import check_world
from mansion_export.thor import house
from mansion_geometry.thor.house_format import floor_heading, floor_point, thor_heading, thor_point
from mansion_msgs_py.building import Building
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.world import SkillStatus
from mansion_skills import Robot
from mansion_skills.thor import ThorGym, open_controller
from mansion_skills.world.floor_exports import _made
from sample_building import write_building
from thor_double import OUT_OF_SIGHT, ThorDouble

LACKING = ("shelf_1", "lamp_1")
"""What AI2-THOR has no asset for, in these tests."""

MUG = "F1/office/mug_1"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """The sample building with the house of each floor."""
    made = write_building(tmp_path / "building")
    index = msgspec.json.decode((made / "building.json").read_bytes(), type=Building)
    for entry in index.floors:
        file = made / entry.files["scene"]
        scene = msgspec.json.decode(file.read_bytes(), type=FloorScene)
        objects = [
            item if item.id.endswith(LACKING) else msgspec.structs.replace(item, asset_id=f"{item.category.title()}_1")
            for item in scene.objects
        ]
        scene = msgspec.structs.replace(scene, objects=objects)
        file.write_bytes(encode_bytes(scene))
        entry.files["house"] = str(Path(entry.files["scene"]).with_name("house.json"))
        (made / entry.files["house"]).write_bytes(msgspec.json.encode(house(scene)))
    (made / "building.json").write_bytes(encode_bytes(index))
    return made


@pytest.fixture
def thor() -> ThorDouble:
    return ThorDouble()


@pytest.fixture
def gym(folder: Path, thor: ThorDouble) -> ThorGym:
    return ThorGym(folder, thor, durable=False)


def world_of(robot: Robot) -> Any:
    return robot.engine.session(robot.session).world


def nodes(scene: dict[str, Any]) -> list[str]:
    found, rest = [], list(scene["objects"])
    while rest:
        node = rest.pop()
        found.append(node["id"])
        rest += node["children"]
    return found


def test_axes_convert_there_and_back() -> None:
    assert floor_point(thor_point(1.0, 2.0, 3.0)) == (1.0, 2.0, 3.0)
    assert thor_point(1.0, 2.0, 3.0) == {"x": 1.0, "y": 3.0, "z": 2.0}
    assert [thor_heading(yaw) for yaw in (0.0, 90.0, 180.0)] == [90.0, 0.0, 270.0]
    assert all(floor_heading(thor_heading(yaw)) == yaw for yaw in (0.0, 30.0, 90.0, 275.5))


def test_the_agent_stands_where_the_robot_does(gym: ThorGym, thor: ThorDouble) -> None:
    assert thor.actions[0]["action"] == "Teleport"
    pose = gym.where_am_i().pose
    assert (thor.agent["x"], thor.agent["z"]) == (pose.x, pose.y)
    assert thor.agent["heading"] == thor_heading(pose.yaw)
    assert thor.parameters["snapToGrid"] is False


def test_a_controller_gives_the_same_answers_as_none(folder: Path, thor: ThorDouble) -> None:
    calls: list[tuple[str, dict[str, Any]]] = [
        ("GoToLandmark", {"landmark": "office"}),
        ("Rotate", {"degrees": 90}),
        ("MoveAhead", {"distance": 0.25}),
        ("MoveAhead", {"distance": -0.25}),
        ("LookDown", {"degrees": 30}),
        ("GoNearObject", {"object": MUG}),
        ("PickUp", {"object": MUG}),
        ("PickUp", {"object": MUG}),
        ("GoNearObject", {"object": "F1/kitchen/fridge_1"}),
        ("Place", {"target": "F1/kitchen/fridge_1", "relation": "in"}),
        ("OpenObject", {"object": "F1/kitchen/fridge_1"}),
        ("Place", {"target": "F1/kitchen/fridge_1", "relation": "in"}),
        ("CloseObject", {"object": "F1/kitchen/fridge_1"}),
        ("UseElevator", {"target_floor": 99}),
        ("GoToLandmark", {"landmark": "stairs"}),
        ("TakeStairs", {"direction": "Up"}),
        ("GoToLandmark", {"landmark": "elevator"}),
        ("CallElevator", {}),
        ("UseElevator", {"target_floor": 3}),
    ]
    gym, plain = ThorGym(folder, thor, "with_thor"), Robot(folder, "without", world="apart")
    for name, arguments in calls:
        ours, theirs = gym.skill(name, **arguments), plain.skill(name, **arguments)
        assert (ours.status, ours.message) == (theirs.status, theirs.message)
        assert ours.state.floor == theirs.state.floor and ours.state.held == theirs.state.held
        assert ours.state.pose.x == pytest.approx(theirs.state.pose.x, abs=0.02)
        check_world(world_of(gym))
    mug = world_of(gym).objects.state(MUG)
    assert (mug.floor, mug.parent, mug.mount) == (1, "F1/kitchen/fridge_1", "inside")


def test_update_floor_does_the_four_steps_of_the_card(gym: ThorGym, thor: ThorDouble) -> None:
    gym.go_near_object(MUG)
    assert gym.pick_up(MUG).status is SkillStatus.SUCCESS
    gym.update_floor(+2)
    first, second = thor.scenes
    assert MUG in nodes(first) and MUG in nodes(second)
    assert second["metadata"]["mansion"]["floor"] == 3
    assert thor.hand == MUG and gym.where_am_i().held == MUG
    assert {mark.floor for mark in gym.landmarks} == {3}
    assert gym.room_graph["F3/hall"] == ["F3/office", "F3/kitchen", "elevator_1", "stair_1"]
    assert (thor.agent["x"], thor.agent["z"], thor.agent["heading"]) == (0.66, 1.0, 90.0)
    gym.update_floor(-2)
    assert thor.hand == MUG
    gym.skill("Place", target="floor")
    gym.update_floor(+1)
    assert MUG not in nodes(thor.scenes[-1])
    gym.update_floor(-1)
    assert nodes(thor.scenes[-1]).count(MUG) == 1


def test_update_floor_names_the_floors_there_are(gym: ThorGym, thor: ThorDouble) -> None:
    with pytest.raises(MansionError, match=r"floors are \[1, 2, 3\]"):
        gym.update_floor(7)
    assert len(thor.scenes) == 1 and gym.where_am_i().floor == 1


def test_what_was_done_on_a_floor_is_there_when_one_comes_back(gym: ThorGym, thor: ThorDouble) -> None:
    gym.go_near_object("F1/kitchen/fridge_1")
    gym.open_object("F1/kitchen/fridge_1")
    gym.go_near_object("F1/door_1")
    assert gym.close_door("F1/door_1").status is SkillStatus.SUCCESS
    gym.update_floor(+1)
    gym.update_floor(-1)
    assert thor.objects["F1/kitchen/fridge_1"]["openness"] == 1.0
    assert thor.objects["F1/door_1"]["openness"] == 0.0


def test_a_box_takes_its_contents_to_the_other_floor(gym: ThorGym, thor: ThorDouble) -> None:
    gym.go_near_object("F1/office/box_1")
    assert gym.pick_up("F1/office/box_1").status is SkillStatus.SUCCESS
    gym.update_floor(+1)
    assert {"F1/office/box_1", "F1/office/ball_1"} <= set(nodes(thor.scenes[-1]))
    assert world_of(gym).objects.state("F1/office/ball_1").held_by is not None


@pytest.mark.parametrize(
    ("action", "message"), [("PickupObject", OUT_OF_SIGHT), ("Teleport", "Collided with: Chair_1")]
)
def test_what_ai2thor_refuses_fails_with_its_words_and_leaves_the_world(
    gym: ThorGym, thor: ThorDouble, action: str, message: str
) -> None:
    gym.go_near_object(MUG)
    before = encode_bytes([world_of(gym).objects.state(n) for n in world_of(gym).objects])
    thor.faults[action] = [message]
    result = gym.pick_up(MUG) if action == "PickupObject" else gym.go_to_landmark("elevator")
    assert result.status is SkillStatus.EXECUTION_FAILURE
    assert result.message == f"AI2-THOR refused: {action}: {message}"
    assert result.satisfied_by
    after = encode_bytes([world_of(gym).objects.state(n) for n in world_of(gym).objects])
    assert after == before and gym.where_am_i().held is None


def test_a_robot_that_is_stopped_on_its_way_stands_where_ai2thor_has_it(gym: ThorGym, thor: ThorDouble) -> None:
    gym.go_near_object(MUG)
    begin = len(thor.actions)
    stopped = thor.do_Teleport
    thor.do_Teleport = lambda **a: (  # type: ignore[method-assign]
        stopped(**a) if len(thor.actions) <= begin + 1 else "Collided with: Plant_1"
    )
    result = gym.go_to_landmark("stairs")
    assert result.status is SkillStatus.EXECUTION_FAILURE
    assert [change.what for change in result.changed] == ["pose"]
    pose = gym.where_am_i().pose
    assert (pose.x, pose.y) == pytest.approx((thor.agent["x"], thor.agent["z"]), abs=1e-3)


def test_a_floor_that_cannot_be_shown_is_left_again(gym: ThorGym, thor: ThorDouble) -> None:
    gym.go_to_landmark("stairs")
    thor.faults["CreateHouse"] = ["No prefab for asset Desk_1"]
    result = gym.take_stairs("Up")
    assert result.status is SkillStatus.EXECUTION_FAILURE and "No prefab" in result.message
    assert gym.where_am_i().floor == 1
    assert thor.scenes[-1]["metadata"]["mansion"]["floor"] == 1
    assert gym.take_stairs("Up").status is SkillStatus.SUCCESS


def test_a_reset_that_raises_is_a_refusal_too(gym: ThorGym, thor: ThorDouble, monkeypatch: pytest.MonkeyPatch) -> None:
    gym.go_to_landmark("stairs")
    real = thor.reset

    def reset(scene: Any = None, **parameters: Any) -> Any:
        if scene["metadata"]["mansion"]["floor"] == 2:
            raise ValueError("house: no such field\n  at UnityEngine")
        return real(scene, **parameters)

    monkeypatch.setattr(thor, "reset", reset)
    result = gym.take_stairs("Up")
    assert result.message == "AI2-THOR refused: CreateHouse: house: no such field"
    assert gym.where_am_i().floor == 1


def test_what_the_physics_did_is_read_back(gym: ThorGym, thor: ThorDouble) -> None:
    apple = thor.objects["F1/kitchen/apple_1"]
    apple["center"] = {"x": 9.0, "y": 0.79, "z": 5.5}
    apple["parents"] = ["F1/kitchen/table_1", "Floor_1"]
    thor.objects["F1/kitchen/fridge_1"]["openness"] = 0.5
    result = gym.rotate(90)
    assert {change.what for change in result.changed} == {
        "yaw",
        "F1/kitchen/apple_1.place",
        "F1/kitchen/fridge_1.place",
    }
    state = world_of(gym).objects.state("F1/kitchen/apple_1")
    assert (state.parent, state.mount) == ("F1/kitchen/table_1", "surface")
    assert state.position == pytest.approx((9.0, 5.5, 0.79), abs=1e-3)
    assert world_of(gym).objects.state("F1/kitchen/fridge_1").states["open"] is True
    check_world(world_of(gym))


def test_what_falls_out_of_the_hand_is_no_longer_held(gym: ThorGym, thor: ThorDouble) -> None:
    gym.go_near_object(MUG)
    gym.pick_up(MUG)
    thor.hand = None
    thor.objects[MUG]["center"] = {"x": 3.0, "y": 0.05, "z": 5.0}
    gym.rotate(10)
    assert gym.where_am_i().held is None
    state = world_of(gym).objects.state(MUG)
    assert (state.floor, state.room, state.mount) == (1, "F1/office", "floor")
    check_world(world_of(gym))


def test_an_object_without_an_asset_cannot_be_handled(gym: ThorGym, thor: ThorDouble) -> None:
    assert gym.go_near_object("F1/office/lamp_1").status is SkillStatus.SUCCESS
    count = len(thor.actions)
    result = gym.toggle_on("F1/office/lamp_1")
    assert result.status is SkillStatus.INVALID_ACTION and "no asset" in result.message
    assert len(thor.actions) == count


def test_a_session_goes_on_where_it_was_left(folder: Path, thor: ThorDouble) -> None:
    first = ThorGym(folder, thor)
    first.go_near_object(MUG)
    first.pick_up(MUG)
    again = ThorDouble()
    second = ThorGym(folder, again)
    assert second.where_am_i() == first.where_am_i()
    assert again.hand == MUG and again.agent["x"] == thor.agent["x"]


def test_the_controller_ends_with_the_gym(folder: Path, thor: ThorDouble) -> None:
    with ThorGym(folder, thor) as gym:
        assert gym.last_event.metadata["lastActionSuccess"]
    assert thor.stopped


def test_a_building_without_houses_is_as_with_them(folder: Path, gym: ThorGym) -> None:
    for file in folder.glob("floors/*/house.json"):
        file.unlink()
    made = ThorGym(folder, ThorDouble(), session="other", durable=False)
    assert MUG in made.houses
    pose, floors = made.where_am_i().pose, made.engine.session("other").world.building.floors
    worlds = [each.engine.session(each.session).world for each in (gym, made)]
    for floor in floors:
        with_files, without = (each.houses.arranged(at, floor, pose) for each, at in zip((gym, made), worlds))
        assert with_files == without


def test_where_houses_cannot_be_made_the_command_that_writes_them_is_named(
    tmp_path: Path, thor: ThorDouble, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "mansion_export.thor.house", None)
    _made.cache_clear()
    with pytest.raises(MansionError, match="mansion export DIR --to thor"):
        ThorGym(write_building(tmp_path / "bare"), thor)


def test_without_the_extra_the_error_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "ai2thor", None)
    monkeypatch.setitem(sys.modules, "ai2thor.controller", None)
    with pytest.raises(MansionError, match="the extra `thor`") as caught:
        open_controller()
    assert caught.value.code == "UNAVAILABLE"


def test_a_controller_is_opened_with_the_settings_and_the_callers(monkeypatch: pytest.MonkeyPatch) -> None:
    seen: dict[str, Any] = {}

    class Recorder:
        def __init__(self, **parameters: Any) -> None:
            seen.update(parameters)

    module = type(builtins)("ai2thor.controller")
    module.Controller = Recorder  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "ai2thor", type(builtins)("ai2thor"))
    monkeypatch.setitem(sys.modules, "ai2thor.controller", module)
    open_controller(width=640, gridSize=0.1)
    assert seen["scene"] == "Procedural" and seen["width"] == 640 and seen["gridSize"] == 0.1


STEPS = st.one_of(
    st.tuples(st.just("GoNearObject"), st.sampled_from(["mug_1", "fridge_1", "table_1", "box_1", "desk_1", "apple_1"])),
    st.tuples(st.just("PickUp"), st.sampled_from(["mug_1", "box_1", "apple_1", "ball_1"])),
    st.tuples(st.just("Place"), st.sampled_from(["desk_1", "table_1", "fridge_1", "floor"])),
    st.tuples(st.sampled_from(["OpenObject", "CloseObject"]), st.just("fridge_1")),
    st.tuples(st.just("TakeStairs"), st.sampled_from(["Up", "Down"])),
    st.tuples(st.just("MoveAhead"), st.sampled_from([0.25, -0.25, 1.0])),
    st.tuples(st.just("Rotate"), st.sampled_from([90, -45])),
)
FAULTS = st.sampled_from(["", "", "", "Teleport", "PickupObject", "PutObject", "CreateHouse"])
ARGUMENT = {
    "GoNearObject": "object",
    "PickUp": "object",
    "Place": "target",
    "OpenObject": "object",
    "CloseObject": "object",
    "TakeStairs": "direction",
    "MoveAhead": "distance",
    "Rotate": "degrees",
}


@settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(steps=st.lists(st.tuples(STEPS, FAULTS), max_size=15))
def test_world_and_ai2thor_agree_after_every_skill(folder: Path, steps: list[tuple[tuple[str, Any], str]]) -> None:
    thor = ThorDouble()
    gym = ThorGym(folder, thor, reset=True, durable=False)
    world, houses = world_of(gym), gym.houses
    for (name, value), fault in steps:
        if name == "TakeStairs":
            gym.go_to_landmark("stairs")
        thor.faults = {fault: ["it does not go"]} if fault else {}
        relation = {"relation": "in"} if value == "fridge_1" and name == "Place" else {}
        gym.skill(name, **{ARGUMENT[name]: value}, **relation)
        thor.faults = {}
        check_world(world)
        here = gym.where_am_i()
        assert thor.hand == here.held
        assert (thor.agent["x"], thor.agent["z"]) == pytest.approx((here.pose.x, here.pose.y), abs=0.011)
        for state in world.objects.on_floor(here.floor):
            if state.id in houses:
                center = thor.objects[state.id]["center"]
                assert state.position == pytest.approx((center["x"], center["z"], center["y"]), abs=0.011)
