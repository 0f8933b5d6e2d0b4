"""The message definitions of recordings are those of ROS 2."""

import importlib
import re

import pytest

from mansion_msgs_py.errors import MansionError
from mansion_tasks.recordings.mcap_file import FIELDS, RULE, message_definition

ALIASES = {"double": "float64", "float": "float32", "boolean": "bool", "octet": "byte"}


def spelt(kind: str) -> str:
    """Return a type as ``.msg`` files spell it."""
    if found := re.fullmatch(r"sequence<(.+)>", kind):
        return f"{ALIASES.get(found[1], found[1])}[]"
    return ALIASES.get(kind, kind)


@pytest.mark.parametrize("name", [name for name in FIELDS if not name.startswith("tf2_msgs")])
def test_a_type_has_the_fields_that_ros_gives_it(name: str) -> None:
    pytest.importorskip("rclpy")
    package, kind = name.split("/")
    message = getattr(importlib.import_module(f"{package}.msg"), kind)
    theirs = tuple(f"{spelt(kind)} {field}" for field, kind in message.get_fields_and_field_types().items())
    assert FIELDS[name] == theirs


def test_a_definition_brings_all_types_that_it_uses_once() -> None:
    parts = message_definition("nav_msgs/Path").split(f"\n{RULE}\nMSG: ")
    assert parts[0] == "std_msgs/Header header\ngeometry_msgs/PoseStamped[] poses"
    assert sorted(part.splitlines()[0] for part in parts[1:]) == [
        "builtin_interfaces/Time",
        "geometry_msgs/Point",
        "geometry_msgs/Pose",
        "geometry_msgs/PoseStamped",
        "geometry_msgs/Quaternion",
        "std_msgs/Header",
    ]


def test_an_unknown_type_is_named() -> None:
    with pytest.raises(MansionError, match="sensor_msgs/Nothing"):
        message_definition("sensor_msgs/Nothing")
