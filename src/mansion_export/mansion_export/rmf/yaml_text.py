"""YAML of nested dictionaries and lists: blocks above, one line for each record; the same bytes for the same values."""

import json
from typing import TypeAlias

__all__ = ["Value", "yaml_text"]

Value: TypeAlias = "dict[str, Value] | list[Value] | str | bool | int | float"


def yaml_text(value: dict[str, Value], depth: int = 3) -> str:
    """Write a document.

    Parameters
    ----------
    value : dict
        Numbers are written with at most four decimals.
    depth : int
        Levels of dictionaries that are written as blocks; what is below them stands on one line, as JSON, which YAML
        1.2 holds in it.
    """
    return "\n".join(_lines(value, depth, "")) + "\n"


def _lines(value: dict[str, Value], depth: int, indent: str) -> list[str]:
    lines = []
    for key, item in value.items():
        name = f"{indent}{_flow(key)}:"
        if isinstance(item, dict) and item and depth > 1:
            lines += [name, *_lines(item, depth - 1, indent + "  ")]
        elif isinstance(item, list) and any(isinstance(part, list | dict) for part in item):
            lines += [name, *(f"{indent}  - {_flow(part)}" for part in item)]
        else:
            lines.append(f"{name} {_flow(item)}")
    return lines


def _flow(value: Value) -> str:
    return json.dumps(_rounded(value), ensure_ascii=False)


def _rounded(value: Value) -> Value:
    if isinstance(value, float):
        return round(value, 4) + 0.0
    if isinstance(value, list):
        return [_rounded(item) for item in value]
    if isinstance(value, dict):
        return {key: _rounded(item) for key, item in value.items()}
    return value
