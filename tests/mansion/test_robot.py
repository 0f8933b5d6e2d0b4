"""The robot of the front door: its skills are those that are declared."""

import inspect
from pathlib import Path

import pytest

import mansion
from mansion_bringup.interfaces import SERVICES
from mansion_msgs_py.interfaces import SERVICES as OTHER_SERVICES
from mansion_msgs_py.world import SkillStatus
from mansion_skills.skills.registry import SKILLS


@pytest.fixture(scope="module")
def clinic(tmp_path_factory: pytest.TempPathFactory) -> mansion.Building:
    """Two storeys with a lift."""
    folder = tmp_path_factory.mktemp("clinic") / "clinic"
    return mansion.build("A two-storey clinic with an elevator", folder, floor_area=160.0, seed=1)


def test_every_skill_of_the_interface_table_is_a_method(flat: mansion.Building) -> None:
    robot = flat.robot("methods")
    others = {entry.name for entry in OTHER_SERVICES}
    served = {entry.name.removeprefix("skills/") for entry in SERVICES if entry.name not in others}
    assert set(robot.skills) == served == set(SKILLS)
    for name, skill in SKILLS.items():
        method = getattr(robot, name)
        assert name in dir(robot) and method.__name__ == name and skill.description in method.__doc__
        assert set(inspect.signature(method).parameters) == set(skill.parameters)


def test_arguments_go_by_place_or_by_name(flat: mansion.Building) -> None:
    robot = flat.robot("arguments")
    assert robot.go_to_landmark("kitchen").status is SkillStatus.SUCCESS
    assert robot.rotate(degrees=90).status is SkillStatus.SUCCESS
    with pytest.raises(mansion.MansionError, match=r"GoToLandmark.*did you mean landmark") as caught:
        robot.go_to_landmark(landmrk="kitchen")
    assert caught.value.code == "INVALID_PAYLOAD"
    with pytest.raises(mansion.MansionError, match="2 positional arguments; it takes degrees"):
        robot.rotate(1, 2)
    with pytest.raises(AttributeError, match="no skill 'dance'"):
        robot.dance()
    with pytest.raises(mansion.MansionError, match="did you mean PickUp"):
        robot.do("PickUpp")


def test_a_robot_goes_to_other_floors(clinic: mansion.Building) -> None:
    robot = clinic.robot("upstairs")
    upper = clinic.floors[2].rooms[0]
    assert robot.go_to(upper.id).status is SkillStatus.SUCCESS
    assert (robot.where_am_i().floor, robot.where_am_i().room) == (2, upper.id)
    again = robot.go_to(upper.id)
    assert again.status is SkillStatus.SUCCESS
    assert robot.go_to("the moon").status is SkillStatus.INVALID_ACTION


def test_a_robot_goes_on_where_it_was_left(clinic: mansion.Building) -> None:
    clinic.robot("left", reset=False).go_to("F2/" + clinic.floors[2].rooms[0].id.partition("/")[2])
    assert clinic.robot("left").where_am_i().floor == 2


def test_robots_of_one_building_meet_in_one_world(copy: mansion.Building) -> None:
    one, other = copy.robot("one"), copy.robot("other")
    assert one.go_to("F1/kitchen/fridge_1").status is SkillStatus.SUCCESS
    assert one.open_object("F1/kitchen/fridge_1").status is SkillStatus.SUCCESS
    assert one.go_to("bathroom").status is SkillStatus.SUCCESS
    assert other.go_to("F1/kitchen/fridge_1").status is SkillStatus.SUCCESS
    seen = {item.id: item.states for item in other.list_visible().objects}
    assert seen["F1/kitchen/fridge_1"]["open"] is True
    with pytest.raises(mansion.MansionError, match="sessions one") as caught:
        copy.robot("other", reset=True)
    assert caught.value.code == "CONFLICT"


def test_stairs_and_lifts_join_the_storeys_of_the_graph(clinic: mansion.Building) -> None:
    graph = clinic.graph()
    assert graph.nodes["elevator_1"]["kind"] == "elevator"
    assert {graph.nodes[name]["floor"] for name in graph["elevator_1"]} == {1, 2}


def test_a_robot_sees(clinic: mansion.Building, tmp_path: Path) -> None:
    pytest.importorskip("mujoco")
    robot = clinic.robot("eyes", reset=False)
    before = robot.look(width=64, height=48)
    robot.rotate(180)
    assert before.shape == (48, 64, 3) and (robot.look(width=64, height=48) != before).any()
