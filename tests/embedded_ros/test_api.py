"""Names and signatures are those of Jazzy's rclpy 7.1."""

from __future__ import annotations

import ast
import importlib
import inspect
import json
import re
from pathlib import Path
from typing import Any

import pytest
from rclpy._missing import MISSING

API = json.loads((Path(__file__).parent / "data" / "rclpy_api.json").read_text(encoding="utf-8"))
PRESETS = API.pop("qos_presets")
KINDS = {0: "positional", 1: "positional", 2: "*", 3: "keyword", 4: "**"}


def _recorded(text: str) -> tuple[list[tuple[str, str]], set[str]]:
    """Parameters with their kinds, and which of them have defaults."""
    text = re.sub(r"<[^<>]*(<[^<>]*>)?[^<>]*>", "None", text)
    text = re.sub(r"Duration\(nanoseconds=-?\d+\)", "None", text.replace("~", ""))
    function = ast.parse(f"def f{text}: pass").body[0]
    assert isinstance(function, ast.FunctionDef)
    args = function.args
    parameters = [(a.arg, "positional") for a in args.args]
    parameters += [(args.vararg.arg, "*")] if args.vararg else []
    parameters += [(a.arg, "keyword") for a in args.kwonlyargs]
    parameters += [(args.kwarg.arg, "**")] if args.kwarg else []
    defaults = {a.arg for a in args.args[len(args.args) - len(args.defaults) :]}
    defaults |= {a.arg for a, d in zip(args.kwonlyargs, args.kw_defaults) if d is not None}
    return parameters, defaults


def _actual(function: Any) -> tuple[list[tuple[str, str]], set[str]]:
    parameters = inspect.signature(function).parameters.values()
    return (
        [(p.name, KINDS[int(p.kind)]) for p in parameters],
        {p.name for p in parameters if p.default is not p.empty},
    )


def _entries() -> list[tuple[str, str, str | None, str]]:
    """Module, name, member (None for the name itself), and what was recorded."""
    found: list[tuple[str, str, str | None, str]] = []
    for module, names in API.items():
        for name, entry in names.items():
            if name == "TYPE_CHECKING":
                continue
            if isinstance(entry, dict):
                found += [(module, name, key, text) for key, text in entry["members"].items()]
            else:
                found.append((module, name, None, entry))
    return found


@pytest.mark.parametrize("module", API)
def test_every_module_is_there(module: str) -> None:
    importlib.import_module(module)


@pytest.mark.parametrize(("module", "name", "member", "text"), _entries())
def test_what_exists_has_the_recorded_signature(
    module: str, name: str, member: str | None, text: str
) -> None:
    owner = getattr(importlib.import_module(module), name)
    if member is None:
        if text.startswith("("):
            assert _actual(owner) == _recorded(text)
        else:
            assert repr(owner) == text
        return
    found = inspect.getattr_static(owner, member)
    if text == "property":
        assert isinstance(found, property)
    elif text.startswith("("):
        function = found.__func__ if isinstance(found, staticmethod | classmethod) else found
        if not inspect.isclass(function):
            assert _actual(function) == _recorded(text)
    else:
        assert repr(getattr(owner, member)) == text


@pytest.mark.parametrize("name", PRESETS)
def test_qos_presets_have_the_recorded_values(name: str) -> None:
    from rclpy.qos import QoSPresetProfiles

    assert str(QoSPresetProfiles[name].value) == PRESETS[name]


@pytest.mark.parametrize("module", ["rclpy.action", "rclpy.lifecycle"])
def test_what_is_missing_says_so(module: str) -> None:
    with pytest.raises(ImportError, match="embedded ROS has no"):
        importlib.import_module(module).ActionServer  # noqa: B018


@pytest.mark.parametrize(("module", "name"), [(m, n) for m in MISSING for n in MISSING[m]])
def test_missing_names_say_so(module: str, name: str) -> None:
    with pytest.raises(AttributeError, match="embedded ROS does not have it"):
        getattr(importlib.import_module(module), name)


def test_a_message_type_that_is_not_there_says_what_is() -> None:
    with pytest.raises(ImportError, match="cannot import name 'Nothing'"):
        from std_msgs.msg import Nothing  # type: ignore[attr-defined]  # noqa: F401
    module = importlib.import_module("std_msgs.msg")
    with pytest.raises(AttributeError, match="it has Bool"):
        module.Nothing  # noqa: B018
