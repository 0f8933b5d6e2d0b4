"""Parameters, their services and events, command lines and files."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from rcl_interfaces.msg import (
    FloatingPointRange,
    IntegerRange,
    ParameterDescriptor,
    ParameterEvent,
    SetParametersResult,
)
from rclpy.exceptions import (
    InvalidParameterTypeException,
    InvalidParameterValueException,
    ParameterAlreadyDeclaredException,
    ParameterImmutableException,
    ParameterNotDeclaredException,
    ParameterUninitializedException,
)
from rclpy.parameter import Parameter
from rclpy.parameter_client import AsyncParameterClient
from rclpy.parameter_event_handler import ParameterEventHandler


def test_parameters_are_declared_got_set_and_undeclared(node: Any) -> None:
    assert node.declare_parameter("rate", 2.0).value == 2.0
    assert node.get_parameter("rate").type_ is Parameter.Type.DOUBLE
    assert node.set_parameters([Parameter("rate", value=3.5)])[0].successful
    assert node.get_parameter("rate").value == 3.5
    with pytest.raises(ParameterAlreadyDeclaredException):
        node.declare_parameter("rate", 1.0)
    node.undeclare_parameter("rate")
    assert not node.has_parameter("rate")
    with pytest.raises(ParameterNotDeclaredException):
        node.get_parameter("rate")
    assert node.get_parameter_or("rate", Parameter("rate", value=9)).value == 9


@pytest.mark.parametrize(
    "value",
    [True, 7, 0.5, "text", [True, False], [1, 2], [0.5, 1.5], ["a", "b"], [b"\x01", b"\x02"]],
)
def test_every_type_survives_the_message(node: Any, value: Any) -> None:
    node.declare_parameter("any", value)
    message = node.get_parameter("any").to_parameter_msg()
    assert Parameter.from_parameter_msg(message).value == value


def test_types_are_static_unless_declared_dynamic(node: Any) -> None:
    node.declare_parameter("static", 1)
    result = node.set_parameters([Parameter("static", value="text")])[0]
    assert not result.successful
    assert "Wrong parameter type" in result.reason
    node.declare_parameter("dynamic", 1, ParameterDescriptor(dynamic_typing=True))
    assert node.set_parameters([Parameter("dynamic", value="text")])[0].successful
    with pytest.raises(ValueError, match="statically typed"):
        node.declare_parameter("nothing")
    node.declare_parameter("typed", Parameter.Type.STRING)
    with pytest.raises(ParameterUninitializedException):
        node.get_parameter("typed")
    assert node.set_parameters([Parameter("typed", value="now")])[0].successful


def test_ranges_and_read_only_are_kept(node: Any) -> None:
    limits = FloatingPointRange(from_value=0.0, to_value=1.0, step=0.25)
    node.declare_parameter("share", 0.5, ParameterDescriptor(floating_point_range=[limits]))
    assert node.set_parameters([Parameter("share", value=0.75)])[0].successful
    assert "out of range" in node.set_parameters([Parameter("share", value=1.5)])[0].reason
    assert "valid step" in node.set_parameters([Parameter("share", value=0.6)])[0].reason
    count = ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=10, step=5)])
    node.declare_parameter("count", 5, count)
    assert not node.set_parameters([Parameter("count", value=7)])[0].successful
    with pytest.raises(InvalidParameterValueException):
        node.declare_parameter("outside", 20, count)
    node.declare_parameter("fixed", 1, ParameterDescriptor(read_only=True))
    assert "read-only" in node.set_parameters([Parameter("fixed", value=2)])[0].reason
    with pytest.raises(ParameterImmutableException):
        node.undeclare_parameter("fixed")


def test_callbacks_change_refuse_and_follow(node: Any) -> None:
    followed: list[Any] = []
    node.declare_parameter("speed", 1.0)

    def clamp(parameters: list[Parameter]) -> list[Parameter]:
        return [Parameter(p.name, value=min(p.value, 5.0)) for p in parameters]

    def positive(parameters: list[Parameter]) -> SetParametersResult:
        fine = all(p.value > 0 for p in parameters)
        return SetParametersResult(successful=fine, reason="" if fine else "must be positive")

    node.add_pre_set_parameters_callback(clamp)
    node.add_on_set_parameters_callback(positive)
    node.add_post_set_parameters_callback(lambda ps: followed.extend(p.value for p in ps))
    assert node.set_parameters([Parameter("speed", value=9.0)])[0].successful
    assert node.get_parameter("speed").value == 5.0
    assert node.set_parameters([Parameter("speed", value=-1.0)])[0].reason == "must be positive"
    assert followed == [5.0]
    node.remove_on_set_parameters_callback(positive)
    assert node.set_parameters([Parameter("speed", value=-1.0)])[0].successful


def test_setting_atomically_sets_all_or_none(node: Any) -> None:
    node.declare_parameters("", [("a", 1), ("b", 2)])
    wanted = [Parameter("a", value=10), Parameter("b", value="wrong")]
    assert not node.set_parameters_atomically(wanted).successful
    assert [p.value for p in node.get_parameters(["a", "b"])] == [1, 2]


def test_prefixes_list_and_descriptors(node: Any) -> None:
    node.declare_parameters("", [("pid.p", 1.0), ("pid.inner.i", 2.0), ("other", 3)])
    assert set(node.get_parameters_by_prefix("pid")) == {"p", "inner.i"}
    assert node.list_parameters(["pid"], 1).names == ["pid.p"]
    assert set(node.list_parameters(["pid"], 0).names) == {"pid.p", "pid.inner.i"}
    assert node.list_parameters(["pid"], 0).prefixes == ["pid", "pid.inner"]
    descriptor = ParameterDescriptor(description="what it is")
    node.set_descriptor("other", descriptor)
    assert node.describe_parameter("other").description == "what it is"


def test_undeclared_parameters_can_be_allowed(ros: Any) -> None:
    node = ros.create_node("free", allow_undeclared_parameters=True)
    assert node.get_parameter("x").type_ is Parameter.Type.NOT_SET
    assert node.set_parameters([Parameter("x", value=1)])[0].successful
    assert node.get_parameter("x").value == 1
    node.destroy_node()


def test_overrides_come_from_files_arguments_and_code(ros: Any, tmp_path: Path) -> None:
    file = tmp_path / "params.yaml"
    file.write_text(
        "/**:\n  ros__parameters:\n    every: 1\n    nested: {deep: [1, 2]}\n"
        "/ns/tuned:\n  ros__parameters:\n    own: text\n"
        "/*/tuned:\n  ros__parameters:\n    one_token: 2.5\n"
        "other:\n  ros__parameters:\n    every: 99\n"
    )
    args = ["--ros-args", "--params-file", str(file), "-p", "given:=[true, false]"]
    args += ["-p", "tuned:targeted:=5", "-p", "elsewhere:targeted:=6", "-r", "__ns:=/ns"]
    node = ros.create_node(
        "tuned",
        cli_args=args,
        parameter_overrides=[Parameter("in_code", value=8)],
        automatically_declare_parameters_from_overrides=True,
    )
    names = ["every", "nested.deep", "own", "one_token", "given", "targeted", "in_code"]
    values = [node.get_parameter(name).value for name in names]
    assert values == [1, [1, 2], "text", 2.5, [True, False], 5, 8]
    node.destroy_node()


def test_an_override_of_the_wrong_type_is_refused(ros: Any) -> None:
    node = ros.create_node("strict", cli_args=["--ros-args", "-p", "size:=wide"])
    with pytest.raises(InvalidParameterTypeException):
        node.declare_parameter("size", 3)
    assert node.declare_parameter("other", "default").value == "default"
    node.destroy_node()


def test_other_nodes_see_and_set_parameters_through_services(ros: Any, node: Any) -> None:
    node.declare_parameter("shared", 1)
    other = ros.create_node("other")
    client = AsyncParameterClient(other, "tested")
    assert client.wait_for_services(5.0)
    executor = ros.executors.SingleThreadedExecutor()
    executor.add_node(node)
    executor.add_node(other)

    def result(future: Any) -> Any:
        executor.spin_until_future_complete(future, 5.0)
        return future.result()

    assert result(client.get_parameters(["shared"])).values[0].integer_value == 1
    assert result(client.set_parameters([Parameter("shared", value=4)])).results[0].successful
    assert node.get_parameter("shared").value == 4
    refused = result(client.set_parameters([Parameter("unknown", value=4)])).results[0]
    assert not refused.successful
    assert "shared" in result(client.list_parameters()).result.names
    assert result(client.describe_parameters(["shared"])).descriptors[0].name == "shared"
    assert list(result(client.get_parameter_types(["shared"])).types) == [2]
    assert result(
        client.set_parameters_atomically([Parameter("shared", value=5)])
    ).result.successful
    executor.shutdown()
    other.destroy_node()


def test_changes_are_published_as_events(ros: Any, node: Any) -> None:
    events: list[ParameterEvent] = []
    seen: list[Any] = []
    handler = ParameterEventHandler(node)
    handler.add_parameter_callback("watched", "tested", lambda p: seen.append(p.value))
    node.create_subscription(ParameterEvent, "/parameter_events", events.append, 10)
    node.declare_parameter("watched", 1)
    node.set_parameters([Parameter("watched", value=2)])
    for _ in range(50):
        ros.spin_once(node, timeout_sec=0.05)
        if seen == [1, 2] and len(events) == 2:
            break
    assert seen == [1, 2]
    assert [e.node for e in events if e.changed_parameters] == ["/tested"]
