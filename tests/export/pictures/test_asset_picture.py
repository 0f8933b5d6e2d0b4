"""Pictures of assets show the side that people see."""

import numpy as np
import pytest

from mansion_assets.catalogue import load_catalogue
from mansion_export.pictures.asset_picture import asset_picture

CATALOGUE = load_catalogue()


def _pixels(category: str) -> np.ndarray:
    return np.asarray(asset_picture(CATALOGUE.by_category(category)[0], CATALOGUE, 96), dtype=float)


@pytest.mark.parametrize(("category", "colour"), [("sprinkler", (178, 56, 47)), ("ceiling_light", (255, 241, 208))])
def test_what_hangs_from_a_ceiling_is_seen_from_below(category: str, colour: tuple[int, int, int]) -> None:
    # The red bulb of a sprinkler is below its cover plate, the lit bowl of a lamp below its rim.
    hue = np.array(colour) / np.linalg.norm(colour)
    pixels = _pixels(category)
    lengths = np.maximum(np.linalg.norm(pixels, axis=2), 1.0)
    alike = (pixels @ hue) / lengths > 0.995
    assert alike.mean() > 0.02


def test_a_lamp_is_brighter_than_what_the_sun_lights() -> None:
    assert _pixels("wall_lamp").min(axis=2).max() >= 250
