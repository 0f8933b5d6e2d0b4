"""The rules for names of topics, services, nodes and namespaces (rcl and rmw).

Each ``*_fault`` function gives None for a valid name, else the reason and the index of the fault.
"""

from __future__ import annotations

import re

__all__ = [
    "Fault",
    "expand_name",
    "full_name_fault",
    "namespace_fault",
    "node_name_fault",
    "topic_name_fault",
]

Fault = tuple[str, int] | None

_MAX_NODE_NAME = 255
_MAX_NAMESPACE = 245
_MAX_TOPIC = 247
_SUBSTITUTION = re.compile(r"\{([^{}]*)\}")


def full_name_fault(name: str, what: str = "topic name") -> Fault:
    """Check a fully qualified name."""
    if not name:
        return f"{what} must not be empty", 0
    if name[0] != "/":
        return f"{what} must be absolute, it must lead with a '/'", 0
    if name.endswith("/"):
        return f"{what} must not end with a '/'", len(name) - 1
    bad = re.search(r"[^A-Za-z0-9_/]", name)
    if bad:
        return (
            f"{what} must not contain characters other than alphanumerics, '_', or '/'",
            bad.start(),
        )
    repeated = name.find("//")
    if repeated >= 0:
        return f"{what} must not contain repeated '/'", repeated + 1
    digit = re.search(r"/[0-9]", name)
    if digit:
        return f"{what} must not have a token that starts with a number", digit.start() + 1
    if len(name) > _MAX_TOPIC:
        return f"{what} length should not exceed '{_MAX_TOPIC}'", _MAX_TOPIC - 1
    return None


def namespace_fault(namespace: str) -> Fault:
    """Check a namespace; ``/`` is one."""
    if namespace == "/":
        return None
    fault = full_name_fault(namespace, "namespace")
    if fault is None and len(namespace) > _MAX_NAMESPACE:
        return f"namespace should not exceed '{_MAX_NAMESPACE}'", _MAX_NAMESPACE - 1
    return fault


def node_name_fault(name: str) -> Fault:
    """Check the name of a node, without its namespace."""
    if not name:
        return "node name must not be empty", 0
    bad = re.search(r"[^A-Za-z0-9_]", name)
    if bad:
        return "node name must not contain characters other than alphanumerics or '_'", bad.start()
    if name[0].isdigit():
        return "node name must not start with a number", 0
    if len(name) > _MAX_NODE_NAME:
        return f"node name length should not exceed '{_MAX_NODE_NAME}'", _MAX_NODE_NAME - 1
    return None


def topic_name_fault(name: str) -> Fault:
    """Check a topic or service name before expansion; ``~`` and ``{node}`` are allowed."""
    if not name:
        return "topic name must not be empty string", 0
    if name.endswith("/"):
        return "topic name must not end with a forward slash", len(name) - 1
    tilde = name.find("~", 1)
    if tilde > 0:
        return "topic name must not have a tilde (~) unless it is the first character", tilde
    if name[0] == "~" and len(name) > 1 and name[1] != "/":
        return "topic name has the first character as '~' but is not followed by a '/'", 1
    depth = 0
    for i, char in enumerate(name):
        if char == "{":
            if depth:
                return "topic name must not have nested substitutions", i
            depth = 1
        elif char == "}":
            if not depth:
                return "topic name must not have unbalanced curly braces {}", i
            depth = 0
        elif not re.match(r"[A-Za-z0-9_/~]", char):
            return (
                "topic name must not contain characters other than alphanumerics, '_', '~', '{', or '}'",
                i,
            )
    if depth:
        return "topic name must not have unbalanced curly braces {}", name.rfind("{")
    for match in _SUBSTITUTION.finditer(name):
        if not re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*", match[1]):
            return "substitution name is not valid", match.start() + 1
    repeated = name.find("//")
    if repeated >= 0:
        return "topic name must not contain repeated '/'", repeated + 1
    digit = re.search(r"(^|/)[0-9]", name)
    if digit:
        return "topic name token must not start with a number", digit.end() - 1
    return None


def expand_name(name: str, node_name: str, namespace: str) -> str:
    """Make a name absolute: ``~``, ``{node}``, ``{ns}`` and relative names.

    Raises
    ------
    ValueError
        For a substitution that does not exist.
    """
    base = namespace if namespace.endswith("/") else f"{namespace}/"
    known = {"node": node_name, "ns": namespace, "namespace": namespace}
    for key in _SUBSTITUTION.findall(name):
        if key not in known:
            raise ValueError(f"unknown substitution: {{{key}}}")
    if name.startswith("~"):
        name = f"{base}{node_name}{name[1:]}"
    name = _SUBSTITUTION.sub(lambda match: known[match[1]], name)
    if not name.startswith("/"):
        name = base + name
    return name.replace("//", "/") if namespace == "/" else name
