"""Parameter overrides of a node, from ``-p`` arguments and ``--params-file`` files with wildcards."""

from __future__ import annotations

import re
from typing import Any

from rclpy._arguments import RosArguments
from rclpy._rclpy_pybind11 import RCLInvalidROSArgsError
from rclpy.parameter import Parameter, _from_yaml, get_parameter_value, parameter_value_to_python

__all__ = ["flatten", "overrides_for"]


def flatten(tree: Any, prefix: str = "") -> dict[str, Any]:
    """Nested mappings as names with dots."""
    found: dict[str, Any] = {}
    for key, value in (tree or {}).items():
        name = f"{prefix}.{key}" if prefix else str(key)
        if isinstance(value, dict):
            found.update(flatten(value, name))
        else:
            found[name] = value
    return found


def _matches(pattern: str, full_name: str) -> bool:
    """``/**`` matches any tokens, ``*`` one token."""
    if not pattern.startswith("/"):
        pattern = f"/{pattern}"
    expression = "".join(
        "(/[^/]+)*" if token == "**" else "/[^/]+" if token == "*" else "/" + re.escape(token)
        for token in pattern.strip("/").split("/")
    )
    return re.fullmatch(expression, full_name) is not None


def _sections(tree: Any, path: str) -> list[tuple[str, dict[str, Any]]]:
    found: list[tuple[str, dict[str, Any]]] = []
    for key, value in tree.items():
        if not isinstance(value, dict):
            raise RCLInvalidROSArgsError(
                f"the parameter file has a value at '{path}{key}', outside of any 'ros__parameters'"
            )
        if key == "ros__parameters":
            found.append((path.rstrip("/") or "/**", flatten(value)))
        else:
            found.extend(_sections(value, f"{path}{str(key).strip('/')}/"))
    return found


def _read(path: str) -> list[tuple[str, dict[str, Any]]]:
    import yaml

    try:
        with open(path, encoding="utf-8") as file:
            content = yaml.safe_load(file)
    except OSError as problem:
        raise RCLInvalidROSArgsError(f"Couldn't open parameter file: '{path}': {problem}") from None
    except yaml.YAMLError as problem:
        raise RCLInvalidROSArgsError(f"Couldn't parse params file: '{path}': {problem}") from None
    if content is None:
        return []
    if not isinstance(content, dict):
        raise RCLInvalidROSArgsError(f"Couldn't parse params file: '{path}': it holds no mapping")
    return _sections(content, "/")


def overrides_for(
    arguments: list[RosArguments], node_name: str, full_name: str
) -> dict[str, Parameter]:
    """The overrides of one node; later arguments win, ``-p`` over files.

    Parameters
    ----------
    arguments
        Those of the process and then those of the node.
    """
    found: dict[str, Parameter] = {}
    for given in arguments:
        for path in given.files:
            for pattern, values in _read(path):
                if _matches(pattern, full_name):
                    for name, value in values.items():
                        kind = _from_yaml(value)
                        found[name] = Parameter(
                            name, Parameter.Type(kind.type), parameter_value_to_python(kind)
                        )
        for target, name, text in given.parameters:
            if target is None or _targets(target, node_name, full_name):
                value = get_parameter_value(text)
                found[name] = Parameter(
                    name, Parameter.Type(value.type), parameter_value_to_python(value)
                )
    return found


def _targets(pattern: str, node_name: str, full_name: str) -> bool:
    if pattern.startswith("/") or "*" in pattern:
        return _matches(pattern, full_name)
    return pattern == node_name or f"/{pattern}" == full_name
