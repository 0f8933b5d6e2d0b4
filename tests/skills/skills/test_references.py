"""A skill that is given a wrong name, floor or field answers with those that there are."""

import pytest

from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.world import SkillStatus
from mansion_skills import Robot


def refusal(robot: Robot, skill: str, **arguments: object) -> str:
    result = robot.skill(skill, **arguments)
    assert result.status is SkillStatus.INVALID_ACTION
    return str(result.message)


@pytest.mark.parametrize(
    ("skill", "arguments", "said"),
    [
        ("GoToLandmark", {"landmark": "kitchn"}, "did you mean F1/kitchen? landmarks: "),
        ("GoToLandmark", {"landmark": 7}, "floor 1 has no landmark '7'; landmarks: "),
        ("UseElevator", {"target_floor": 9}, "there is no floor '9'; floors: 1, 2, 3"),
        ("PickUp", {"object": "bal_1"}, "did you mean F1/office/ball_1? "),
        ("OpenDoor", {"door": "F1/dor_1"}, "did you mean F1/door_1? doors: "),
        ("PlanRoute", {"target": "F2/ofice"}, "did you mean F2/office? the nearest of "),
    ],
)
def test_a_wrong_name_is_answered_with_the_right_ones(
    robot: Robot, skill: str, arguments: dict[str, object], said: str
) -> None:
    assert said in refusal(robot, skill, **arguments)


def test_a_wrong_field_is_answered_with_the_fields(robot: Robot) -> None:
    with pytest.raises(MansionError) as caught:
        robot.skill("UseElevator", floor=2)
    assert caught.value.info.path == "$.floor"
    assert "UseElevator: unknown field 'floor'; did you mean target_floor?" in str(caught.value)


def test_a_wrong_skill_is_answered_with_the_skills(robot: Robot) -> None:
    with pytest.raises(MansionError, match="did you mean PickUp"):
        robot.skill("pickup_")
