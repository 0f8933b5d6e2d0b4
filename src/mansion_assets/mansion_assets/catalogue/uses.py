"""What people do with things, for a search that names the use and not the thing."""

from functools import cache
from importlib.resources import files
from typing import Final

import msgspec

__all__ = ["use_of", "uses_by_category"]

_FILE: Final = "uses.json"


@cache
def uses_by_category() -> dict[str, str]:
    """Return what categories are used for; not all have an entry."""
    text = files("mansion_assets.catalogue").joinpath("data", _FILE).read_bytes()
    return msgspec.json.decode(text, type=dict[str, str])


def use_of(category: str) -> str:
    """Return what a category is used for, in a few words; empty where nothing is known."""
    return uses_by_category().get(category, "")
