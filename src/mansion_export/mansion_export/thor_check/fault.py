"""What the validator finds."""

from collections.abc import Iterable
from typing import Any, NamedTuple, TypeAlias

__all__ = ["HouseFault", "Json", "flatten", "numbers", "vector"]

Json: TypeAlias = dict[str, Any]


class HouseFault(NamedTuple):
    """A fault: its kind, the JSON path or id where it is, and what was found against what is asked."""

    kind: str
    where: str
    message: str

    def __str__(self) -> str:
        return f"{self.kind} {self.where}: {self.message}"


def vector(value: object) -> tuple[float, float, float] | None:
    """Return ``{"x", "y", "z"}`` as numbers, or None where it is no such thing."""
    if not isinstance(value, dict):
        return None
    found = [value.get(axis) for axis in ("x", "y", "z")]
    if not all(isinstance(part, (int, float)) and not isinstance(part, bool) for part in found):
        return None
    return (float(value["x"]), float(value["y"]), float(value["z"]))


def flatten(objects: Iterable[Json]) -> list[Json]:
    """Return all objects of a house, those on and in others after what carries them."""
    return [part for item in objects for part in (item, *flatten(item.get("children") or []))]


def numbers(value: object, path: str = "$") -> Iterable[tuple[str, float]]:
    """Return every number of a JSON value with its path."""
    if isinstance(value, dict):
        for key, part in value.items():
            yield from numbers(part, f"{path}.{key}")
    elif isinstance(value, list):
        for i, part in enumerate(value):
            yield from numbers(part, f"{path}[{i}]")
    elif isinstance(value, float):
        yield path, value
