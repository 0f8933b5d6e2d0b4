"""What a procedure draws: colour, height and roughness of a tile; and the shades that procedures share."""

from dataclasses import dataclass

import numpy as np

from mansion_geometry.compiled import Floats

__all__ = ["Layers", "colour", "mixed", "smooth_step", "tones"]


@dataclass(frozen=True, slots=True)
class Layers:
    """A tile of a material.

    Attributes
    ----------
    shade : (rows, columns, 3) array
        sRGB. Around 1 it multiplies the colour of the material; of a material with colours of its own it is the colour.
    height : (rows, columns) array
        Relief, metres.
    roughness : (rows, columns) array
        Around 1; multiplies the roughness of the material.
    own_colours : bool
        Whether `shade` is the colour itself.
    """

    shade: Floats
    height: Floats
    roughness: Floats
    own_colours: bool = False


def colour(text: str) -> Floats:
    """Return ``#rrggbb`` as three numbers from 0 to 1."""
    return np.array([int(text[i : i + 2], 16) / 255.0 for i in (1, 3, 5)])


def tones(value: Floats, warmth: float = 0.0) -> Floats:
    """Return a shade of one value in all channels; with `warmth` places are the warmer, the darker they are."""
    dark = warmth * (float(value.max()) - value)
    shade: Floats = np.stack([value + dark, value, value - dark], axis=-1)
    return shade


def mixed(a: Floats, b: Floats, share: Floats) -> Floats:
    """Return `a` where `share`, one number a texel, is 0, and `b` where it is 1."""
    weight: Floats = share[..., None] if a.ndim == 3 else share
    blend: Floats = a * (1.0 - weight) + b * weight
    return blend


def smooth_step(value: Floats, low: float, high: float) -> Floats:
    """Return 0 below `low`, 1 above `high`, and a smooth rise between."""
    t: Floats = np.clip((value - low) / (high - low), 0.0, 1.0)
    return t * t * (3.0 - 2.0 * t)
