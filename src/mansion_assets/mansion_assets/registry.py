"""Mesh recipes and receptacle rules by name.

The modules of `mansion_assets.recipes` enter theirs when they are imported. All modules of that folder are imported at
the first look-up, so that a new one is known without being listed anywhere.
"""

from collections.abc import Callable
from functools import cache
from importlib import import_module
from pkgutil import iter_modules
from typing import TYPE_CHECKING, Any, TypeAlias

from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.shapes import Size3

if TYPE_CHECKING:
    from mansion_assets.builder import Builder
    from mansion_assets.catalogue.receptacles import Receptacle

__all__ = ["Recipe", "ReceptacleRule", "receptacle_rule", "receptacles", "recipe", "recipe_named", "recipe_names"]

Recipe: TypeAlias = Callable[["Builder"], None]
ReceptacleRule: TypeAlias = Callable[[Size3, dict[str, Any]], "list[Receptacle]"]
"""From an asset's size and the parameters of its recipe to what carries and holds things."""

_RECIPES: dict[str, Recipe] = {}
_RULES: dict[str, ReceptacleRule] = {}


def recipe(name: str) -> Callable[[Recipe], Recipe]:
    """Enter a function as the mesh recipe called `name`."""

    def enter(function: Recipe) -> Recipe:
        _RECIPES[name] = function
        return function

    return enter


def receptacles(*names: str) -> Callable[[ReceptacleRule], ReceptacleRule]:
    """Enter a function as the receptacle rule of the recipes called `names`."""

    def enter(function: ReceptacleRule) -> ReceptacleRule:
        _RULES.update(dict.fromkeys(names, function))
        return function

    return enter


@cache
def _load() -> None:
    with importing:
        from mansion_assets import recipes

    for module in iter_modules(recipes.__path__):
        import_module(f"{recipes.__name__}.{module.name}")


def recipe_named(name: str) -> Recipe | None:
    """Return the recipe called `name`, or None."""
    _load()
    return _RECIPES.get(name)


def receptacle_rule(name: str) -> ReceptacleRule | None:
    """Return the receptacle rule of the recipe called `name`, None where nothing lies on or in it."""
    _load()
    return _RULES.get(name)


def recipe_names() -> list[str]:
    """Return the names of all recipes."""
    _load()
    return sorted(_RECIPES)
