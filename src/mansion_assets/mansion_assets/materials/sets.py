"""Which set of textures each material has, as data: a procedure, its parameters, and the true size of its tile."""

import tomllib
from functools import cache
from importlib.resources import files
from typing import Any, Final

import msgspec

from mansion_msgs_py.codec import prepared

__all__ = ["MaterialSet", "art", "material_set", "set_names", "set_of"]

_DATA: Final = files("mansion_assets.materials").joinpath("data/sets.toml")


class MaterialSet(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """How the textures of some materials are made.

    Attributes
    ----------
    procedure : str
        ``module.function`` of `mansion_assets.materials.families`.
    size : (width, height)
        Size of the tile, metres.
    pixels : (columns, rows)
    parameters : dict
        Arguments of the procedure.
    fitted : bool
        Whether one tile fills each body that shows it, as a painting its canvas; its size is then 1 by 1.
    """

    procedure: str
    size: tuple[float, float]
    pixels: tuple[int, int] = (256, 256)
    parameters: dict[str, Any] = {}
    fitted: bool = False

    @property
    def density(self) -> tuple[float, float]:
        """Texels a metre, across and down."""
        return self.pixels[0] / self.size[0], self.pixels[1] / self.size[1]


class _Registry(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """The data file: sets by name, and the set of each material, or of each family ``family_colour``; see `art`."""

    art: tuple[str, ...]
    sets: dict[str, MaterialSet]
    materials: dict[str, str]
    families: dict[str, str]


@cache
def _registry() -> _Registry:
    return msgspec.convert(tomllib.loads(_DATA.read_text(encoding="utf-8")), prepared(_Registry))


def set_names() -> list[str]:
    """Return the names of all sets, in the order of the data."""
    return list(_registry().sets)


def art() -> tuple[str, ...]:
    """Return the materials of paintings and prints, of which each painting shows one."""
    return _registry().art


def material_set(name: str) -> MaterialSet:
    """Return a set by its name.

    Raises
    ------
    KeyError
        When there is no such set.
    """
    return _registry().sets[name]


@cache
def set_of(material: str) -> str:
    """Return the name of the set that a material shows; empty for what has no pattern, as glass and lamps.

    Parameters
    ----------
    material : str
        A material of rooms and building parts (``oak_hardwood``), or of assets (``wood_walnut``).

    Examples
    --------
    >>> set_of("wood_walnut"), set_of("wood_white"), set_of("glass_clear")
    ('veneer', 'painted_wood', '')
    """
    known = _registry()
    return known.materials.get(material, known.families.get(material.partition("_")[0], ""))
