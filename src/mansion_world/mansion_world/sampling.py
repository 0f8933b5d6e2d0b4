"""Requests of a world: the request at an index follows from the index, the seed of the world and the mixture alone."""

import math
from collections.abc import Mapping
from typing import Final, TypeVar

import msgspec
import numpy as np

from mansion_geometry.randomness import item_generator, item_seed
from mansion_msgs_py.request import BuildRequest
from mansion_world.mixture import Mixture, SubKind
from mansion_world.sentence_templates import fill_wording, fitting_wordings, saying_clutter, values_in_words

__all__ = ["WorldRequest", "sample"]

T = TypeVar("T")

_STEP: Final = (math.sqrt(5.0) - 1.0) / 2.0
"""Step of the golden-ratio sequence: its first n points fill the unit interval evenly for every n."""

_SEEDS: Final = 2**53


class WorldRequest(msgspec.Struct, frozen=True, kw_only=True):
    """A request of a world.

    Attributes
    ----------
    index, attempt : int
        Place in the world, and how many earlier requests for this place came to nothing.
    kind, sub_kind : str
    wording : str
        Group and number of the wording.
    outline, style, clutter : str
        What was drawn; empty for none.
    request : BuildRequest
        The sentence with the number of floors, the area of a floor and a seed of its own.
    name : str
        Name of the building's folder, where it has one; the index otherwise.
    """

    index: int
    attempt: int
    kind: str
    sub_kind: str
    wording: str
    outline: str
    style: str
    clutter: str = ""
    request: BuildRequest
    name: str = ""


def sample(index: int, seed: int, mix: Mixture, *, attempt: int = 0) -> WorldRequest:
    """Return the request at `index`.

    The kind follows a low-discrepancy sequence, so that the shares of any first n requests are those of the mixture to
    within a few buildings; all else is drawn independently.

    Parameters
    ----------
    index : int
        From 0. How many others there are does not matter.
    seed : int
        Seed of the world.
    mix : Mixture
    attempt : int
        A further request for the same index, of the same kind.

    Examples
    --------
    >>> from mansion_world.mixture import load_mixture
    >>> sample(5, 7, load_mixture()) == sample(5, 7, load_mixture())
    True
    """
    kind, name = _kind_at(index, seed, mix.shares())
    part = mix.kinds[kind].kinds[name]
    generator = item_generator(seed, "request", index, attempt)
    floors = _floors(part, generator)
    floor_area = _floor_area(part, generator)
    outline, style = (_weighted(words or {"": 1.0}, generator) for words in (part.outlines, part.styles))
    taste = item_generator(seed, "clutter", index, attempt)
    clutter = _weighted(part.clutter, taste) if part.clutter else ""
    group = part.sentences or name
    wordings = fitting_wordings(group, outline=outline, style=style)
    number, wording = wordings[int(generator.integers(len(wordings)))]
    words = values_in_words(floors, floor_area, outline=outline, style=style, generator=generator)
    request = BuildRequest(
        description=saying_clutter(fill_wording(wording, words), clutter, taste),
        floors=floors,
        floor_area=floor_area,
        seed=item_seed(seed, "building", index, attempt) % _SEEDS,
        building_id=f"world-{seed}-{index:06d}",
        clutter=clutter or msgspec.UNSET,
    )
    return WorldRequest(
        index=index,
        attempt=attempt,
        kind=kind,
        sub_kind=name,
        wording=f"{group}/{number}",
        outline=outline if "{outline}" in wording or ":outline}" in wording else "",
        style=style if "{style}" in wording or ":style}" in wording else "",
        clutter=clutter,
        request=request,
    )


def _kind_at(index: int, seed: int, shares: Mapping[tuple[str, str], float]) -> tuple[str, str]:
    start = item_seed(seed, "kinds") / 2**64
    place = (start + index * _STEP) % 1.0
    passed = 0.0
    for name, share in shares.items():
        passed += share
        if place < passed:
            return name
    return list(shares)[-1]


def _floors(part: SubKind, generator: np.random.Generator) -> int:
    least, most = part.floors
    return least + _weighted({further: part.tail**further for further in range(most - least + 1)}, generator)


def _floor_area(part: SubKind, generator: np.random.Generator) -> float:
    least, most = part.floor_area
    return float(round(least + (most - least) * generator.random() ** part.skew))


def _weighted(weights: Mapping[T, float], generator: np.random.Generator) -> T:
    values = list(weights)
    shares = np.array([weights[value] for value in values])
    return values[int(generator.choice(len(values), p=shares / shares.sum()))]
