"""The recipes by name; a module of `recipes` adds its own when it is imported."""

from collections.abc import Callable
from importlib import import_module

from mansion_assets.builder import Builder

__all__ = ["Recipe", "recipe", "recipe_named", "recipe_names"]

Recipe = Callable[[Builder], None]

_MODULES = (
    "appliances",
    "small_appliances",
    "bathroom",
    "bathroom_fittings",
    "beds",
    "bins",
    "containers",
    "electronics",
    "terminals",
    "industry",
    "kitchenware",
    "boxes",
    "leisure",
    "lighting",
    "machines",
    "devices",
    "optics",
    "medical",
    "museum",
    "music",
    "office",
    "personal",
    "plants",
    "seating",
    "benches",
    "shop",
    "sport",
    "weights",
    "storage",
    "racks",
    "tables",
    "counters",
    "workplaces",
    "toys",
    "vehicles",
    "wall",
    "panels",
    "hangings",
)

_RECIPES: dict[str, Recipe] = {}


def recipe(name: str) -> Callable[[Recipe], Recipe]:
    """Enter a function under `name`."""

    def enter(function: Recipe) -> Recipe:
        _RECIPES[name] = function
        return function

    return enter


def _load() -> None:
    if not _RECIPES:
        for module in _MODULES:
            import_module(f"mansion_assets.recipes.{module}")


def recipe_named(name: str) -> Recipe | None:
    """Return the recipe called `name`, or None."""
    _load()
    return _RECIPES.get(name)


def recipe_names() -> list[str]:
    """Return the names of all recipes."""
    _load()
    return sorted(_RECIPES)
