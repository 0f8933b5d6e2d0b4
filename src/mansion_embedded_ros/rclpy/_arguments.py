"""The part of a command line between ``--ros-args`` and ``--``: rules, parameters, log levels."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from rclpy._names import expand_name
from rclpy._rclpy_pybind11 import RCLInvalidROSArgsError, UnknownROSArgsError

__all__ = ["RemapRule", "RosArguments", "parse_arguments", "split_ros_arguments"]

_SWITCHES = {
    "--enable-rosout-logs": ("rosout", True),
    "--disable-rosout-logs": ("rosout", False),
    "--enable-stdout-logs": ("stdout", True),
    "--disable-stdout-logs": ("stdout", False),
    "--enable-external-lib-logs": ("external", True),
    "--disable-external-lib-logs": ("external", False),
}
_WITH_VALUE = {
    "-r": "remap",
    "--remap": "remap",
    "-p": "param",
    "--param": "param",
    "--params-file": "params_file",
    "--log-level": "log_level",
    "--log-config-file": "ignored",
    "--log-file-name": "ignored",
    "-e": "ignored",
    "--enclave": "ignored",
}
_RULE = re.compile(
    r"^(?:(?P<node>[A-Za-z_/*][\w/*]*):(?!//))?(?P<scheme>rostopic://|rosservice://)?"
    r"(?P<from>[^:]+):=(?P<to>.*)$"
)


@dataclass(frozen=True, slots=True)
class RemapRule:
    """``node:from:=to``; ``kind`` is topic, service, name (both), node or namespace."""

    kind: str
    node: str | None
    source: str
    target: str


@dataclass
class RosArguments:
    """What a command line asks of its nodes."""

    rules: list[RemapRule] = field(default_factory=list)
    parameters: list[tuple[str | None, str, str]] = field(default_factory=list)
    files: list[str] = field(default_factory=list)
    log_levels: list[tuple[str, str]] = field(default_factory=list)
    switches: dict[str, bool] = field(default_factory=dict)
    others: list[str] = field(default_factory=list)

    def node_name(self, name: str) -> str:
        """The remapped name of a node."""
        return self._special("node", name) or name

    def namespace(self, name: str) -> str | None:
        """The remapped namespace of a node, None without a rule."""
        return self._special("namespace", name)

    def _special(self, kind: str, name: str) -> str | None:
        for rule in self.rules:
            if rule.kind == kind and rule.node in (None, name):
                return rule.target
        return None

    def remap(self, name: str, node_name: str, namespace: str, service: bool) -> str | None:
        """The name that a full topic or service name is remapped to, None without a rule."""
        kinds = ("name", "service" if service else "topic")
        for rule in self.rules:
            if rule.kind not in kinds or rule.node not in (None, node_name):
                continue
            if expand_name(rule.source, node_name, namespace) == name:
                return expand_name(rule.target, node_name, namespace)
        return None


def split_ros_arguments(args: Sequence[str]) -> tuple[list[str], list[str]]:
    """The arguments of ROS and all others, each in order; ``--`` ends a section of ROS."""
    ros: list[str] = []
    others: list[str] = []
    inside = False
    for arg in args:
        if arg == "--ros-args":
            inside = True
        elif inside and arg == "--":
            inside = False
        else:
            (ros if inside else others).append(arg)
    return ros, others


def _parse_rule(text: str) -> RemapRule:
    match = _RULE.match(text)
    if match is None:
        raise RCLInvalidROSArgsError(
            f"Couldn't parse remap rule: '-r {text}'. It should look like 'from:=to' or "
            "'node:from:=to'"
        )
    source, node = match["from"], match["node"]
    kind = {"rostopic://": "topic", "rosservice://": "service"}.get(match["scheme"] or "", "name")
    if source in ("__node", "__name"):
        kind = "node"
    elif source == "__ns":
        kind = "namespace"
    return RemapRule(kind, node, source, match["to"])


def _parse_parameter(text: str) -> tuple[str | None, str, str]:
    name, separator, value = text.partition(":=")
    node, colon, rest = name.rpartition(":")
    if not separator or not (rest if colon else name):
        raise RCLInvalidROSArgsError(
            f"Couldn't parse parameter override rule: '-p {text}'. It should look like 'name:=value'"
        )
    return (node if colon else None), rest if colon else name, value


def parse_arguments(args: Sequence[str] | None) -> RosArguments:
    """Read a command line.

    Raises
    ------
    RCLInvalidROSArgsError
        If an argument of ROS cannot be read.
    UnknownROSArgsError
        If there is none of that name.
    """
    ros, others = split_ros_arguments(args or [])
    found = RosArguments(others=others)
    unknown: list[str] = []
    queue: list[Any] = list(reversed(ros))
    while queue:
        arg = queue.pop()
        if arg in _SWITCHES:
            key, value = _SWITCHES[arg]
            found.switches[key] = value
            continue
        kind = _WITH_VALUE.get(arg)
        if kind is None:
            unknown.append(arg)
            continue
        if not queue:
            raise RCLInvalidROSArgsError(f"Couldn't parse trailing {arg} flag. No value found.")
        value = queue.pop()
        if kind == "remap":
            found.rules.append(_parse_rule(value))
        elif kind == "param":
            found.parameters.append(_parse_parameter(value))
        elif kind == "params_file":
            found.files.append(value)
        elif kind == "log_level":
            name, separator, level = value.rpartition(":=")
            found.log_levels.append((name if separator else "", level))
    if unknown:
        raise UnknownROSArgsError(f"Found unknown ROS arguments: {unknown}")
    return found
