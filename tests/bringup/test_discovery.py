"""Commands and clients stay on this machine unless the environment says otherwise."""

import pytest

from mansion_bringup.discovery import CHOICES, stay_on_this_machine


def test_the_range_is_this_machine_where_nothing_is_chosen() -> None:
    environment: dict[str, str] = {}
    stay_on_this_machine(environment)
    assert environment == {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}


@pytest.mark.parametrize("name", CHOICES)
def test_a_choice_of_the_user_is_left_alone(name: str) -> None:
    environment = {name: "SUBNET"}
    stay_on_this_machine(environment)
    assert environment == {name: "SUBNET"}
