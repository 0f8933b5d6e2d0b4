"""The fast path of the environment is the skills, only faster."""

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from mansion_msgs_py.world import SkillStatus
from mansion_skills.skills.queries import VisibleArgs, list_visible
from mansion_tasks.env.low_level import MOVE, TILT, TURN, act, low_level_actions
from mansion_tasks.env.visibility import VisibilityIndex
from mansion_tasks.tasks.sandbox import Sandbox
from sample_building import write_building

MOTIONS = {
    "move_ahead": ("MoveAhead", {"distance": MOVE}),
    "move_back": ("MoveAhead", {"distance": -MOVE}),
    "rotate_left": ("Rotate", {"degrees": TURN}),
    "rotate_right": ("Rotate", {"degrees": -TURN}),
    "look_up": ("LookUp", {"degrees": TILT}),
    "look_down": ("LookDown", {"degrees": TILT}),
}
FEW = settings(max_examples=20, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])


@pytest.fixture(scope="module")
def pair(tmp_path_factory: pytest.TempPathFactory) -> tuple[Sandbox, Sandbox]:
    folder = write_building(tmp_path_factory.mktemp("sample") / "building")
    return Sandbox(folder), Sandbox(folder)


@FEW
@given(st.lists(st.sampled_from(sorted(MOTIONS)), max_size=40))
def test_motions_end_where_the_skills_end(pair: tuple[Sandbox, Sandbox], names: list[str]) -> None:
    fast, slow = pair
    fast.reset()
    slow.reset()
    for name in names:
        outcome = act(fast, name, VisibilityIndex(fast.world).look(fast.robot))
        result = slow.skill(MOTIONS[name][0], **MOTIONS[name][1])
        assert outcome.status == result.status
        ours, theirs = fast.robot.pose, slow.robot.pose
        assert (ours.x, ours.y) == pytest.approx((theirs.x, theirs.y), abs=1e-6)
        assert ours.yaw == pytest.approx(theirs.yaw) and fast.robot.pitch == slow.robot.pitch
        assert fast.world.time == pytest.approx(slow.world.time)


DEEDS = [
    ("GoToLandmark", {"landmark": "office"}),
    ("GoToLandmark", {"landmark": "kitchen"}),
    ("GoNearObject", {"object": "F1/office/box_1"}),
    ("PickUp", {"object": "F1/office/box_1"}),
    ("Place", {"target": "floor"}),
    ("GoNearObject", {"object": "F1/kitchen/fridge_1"}),
    ("OpenObject", {"object": "F1/kitchen/fridge_1"}),
    ("CloseObject", {"object": "F1/kitchen/fridge_1"}),
    ("GoNearObject", {"object": "F1/door_1"}),
    ("CloseDoor", {}),
    ("OpenDoor", {}),
    ("Rotate", {"degrees": 35.0}),
    ("LookDown", {"degrees": 30.0}),
    ("LookUp", {"degrees": 30.0}),
]


@FEW
@given(st.lists(st.sampled_from(DEEDS), max_size=12))
def test_the_eyes_see_what_list_visible_lists(
    pair: tuple[Sandbox, Sandbox], deeds: list[tuple[str, dict[str, object]]]
) -> None:
    from mansion_msgs_py.skills import VisibleObjects

    sandbox, _ = pair
    sandbox.reset()
    sight = VisibilityIndex(sandbox.world)
    for skill, arguments in [("Rotate", {"degrees": 0.0}), *deeds]:
        if sandbox.skill(skill, **arguments).status is SkillStatus.SUCCESS:
            sight.world_changed()
        listed = list_visible.call(sandbox.world, sandbox.robot, VisibleArgs())
        assert isinstance(listed, VisibleObjects)
        view = sight.look(sandbox.robot)
        assert sorted(view.ids) == sorted(entry.id for entry in listed.objects)
        by_id = {entry.id: entry for entry in listed.objects}
        for name, away, bearing in zip(view.ids, view.distances, view.bearings):
            assert away == pytest.approx(by_id[name].distance, abs=1e-3)
            assert bearing == pytest.approx(by_id[name].bearing, abs=0.06) or abs(bearing) > 179.9


def test_only_the_nearest_are_looked_for_and_what_is_always_wanted(pair: tuple[Sandbox, Sandbox]) -> None:
    sandbox, _ = pair
    sandbox.reset()
    sandbox.skill("GoToLandmark", landmark="office")
    sight = VisibilityIndex(sandbox.world)
    for _ in range(8):
        whole = sight.look(sandbox.robot).ids
        if len(whole) > 2:
            break
        sandbox.skill("Rotate", degrees=45.0)
    assert sight.look(sandbox.robot, 1).ids == whole[:1]
    assert sight.look(sandbox.robot, 1, [whole[-1]]).ids == [whole[0], whole[-1]]


def test_hands_take_what_is_in_the_middle_of_the_picture(pair: tuple[Sandbox, Sandbox]) -> None:
    sandbox, _ = pair
    sandbox.reset()
    sandbox.skill("GoNearObject", object="F1/office/mug_1")
    sight = VisibilityIndex(sandbox.world)
    taken = act(sandbox, "pick_up", sight.look(sandbox.robot))
    assert taken.changed and sandbox.world.objects.held_by("episode") == "F1/office/mug_1"
    sight.world_changed()
    again = act(sandbox, "pick_up", sight.look(sandbox.robot))
    assert again.status is SkillStatus.PRECONDITION_FAILURE and not again.changed
    put = act(sandbox, "place", sight.look(sandbox.robot))
    assert put.changed and sandbox.world.objects.state("F1/office/mug_1").parent is not None


def test_every_floor_has_its_ride() -> None:
    assert low_level_actions([-1, 1, 2])[-3:] == ["ride_to_-1", "ride_to_1", "ride_to_2"]
