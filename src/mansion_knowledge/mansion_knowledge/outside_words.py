"""Words for the outside of a building: what its walls and roof are made of, and what lies on its plot."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import TypeVar

import msgspec

from mansion_msgs_py.codec import prepared
from mansion_msgs_py.outside import GroundUse, RoofForm

__all__ = ["OutsideWords", "outside_words"]

_Name = TypeVar("_Name", bound=str)


class _Facade(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    finishes: list[str]
    materials: dict[str, list[str]]
    colours: dict[str, list[str]]


class _File(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    facade: _Facade
    roof: dict[RoofForm, list[str]]
    covering: dict[str, list[str]]
    grounds: dict[GroundUse, list[str]]
    outdoor: dict[GroundUse, list[str]]


@dataclass(frozen=True)
class OutsideWords:
    """What each phrase stands for; phrases are lower case and singular, their words separated by blanks.

    Attributes
    ----------
    substances, colours : mapping of str to str
        Material of outer walls by what they are made of, and by their colour.
    roofs : mapping of str to RoofForm
    coverings : mapping of str to str
        Material of a roof.
    grounds : mapping of str to GroundUse
        Parts of a plot that are called so wherever they are named.
    outdoor : mapping of str to GroundUse
        Parts of a plot that are rooms unless the brief has them outdoors.
    """

    substances: Mapping[str, str]
    colours: Mapping[str, str]
    roofs: Mapping[str, RoofForm]
    coverings: Mapping[str, str]
    grounds: Mapping[str, GroundUse]
    outdoor: Mapping[str, GroundUse]


@cache
def outside_words() -> OutsideWords:
    """Return the words of ``outside_words.toml``.

    Examples
    --------
    >>> words = outside_words()
    >>> words.substances["larch"], words.roofs["gabled"], words.grounds["back garden"]
    ('timber_cladding', 'gable', 'garden')
    """
    text = files("mansion_knowledge").joinpath("data", "outside_words.toml").read_bytes()
    file = msgspec.toml.decode(text, type=prepared(_File))
    colours = _by_phrase(file.facade.colours)
    rendered = {f"{colour} {finish}": name for colour, name in colours.items() for finish in file.facade.finishes}
    return OutsideWords(
        substances=rendered | _by_phrase(file.facade.materials),
        colours=colours,
        roofs=_by_phrase(file.roof),
        coverings=_by_phrase(file.covering),
        grounds=_by_phrase(file.grounds),
        outdoor=_by_phrase(file.outdoor),
    )


def _by_phrase(listed: Mapping[_Name, list[str]]) -> dict[str, _Name]:
    return {phrase: name for name, phrases in listed.items() for phrase in phrases}
