"""Panes of glass as they look from outside by day: they mirror the sky and hide what is behind them."""

from typing import Final

import numpy as np

from mansion_assets.materials import set_of
from mansion_export.meshes.solids import SIDES
from mansion_export.pictures.renderer import Triangles
from mansion_export.pictures.texture_sampling import texture_number

__all__ = ["mirroring"]

TONES: Final = np.array([(0.94, 0.97, 1.0), (0.8, 0.85, 0.9), (0.86, 0.88, 0.88), (0.7, 0.76, 0.82), (1.0, 1.0, 0.98)])
"""What the sky in a pane is multiplied with: rooms behind are bright or dark, curtains open or drawn."""


def mirroring(triangles: Triangles) -> Triangles:
    """Return triangles whose boxes of glass are opaque and show the sky, each pane in a tone of its own."""
    glass = np.flatnonzero((triangles.looks.alpha < 0.99)[triangles.which])
    if not len(glass) or len(glass) % len(SIDES):
        return triangles
    shown = triangles.apart()
    looks = shown.looks
    corners = triangles.corners[glass].reshape(-1, len(SIDES) * 3, 3)
    low, high = corners.min(axis=1), corners.max(axis=1)
    height = np.maximum(high[:, 2] - low[:, 2], 1e-3)[:, None]
    extent = high - low
    turned = (extent[:, 1] > extent[:, 0])[:, None]
    across = np.where(turned, corners[..., 1], corners[..., 0]) / height
    up = (corners[..., 2] - low[:, None, 2]) / height
    # Neighbours differ, and the same building always looks the same.
    numbers = np.round((low + high) @ (3.1, 5.3, 7.7)).astype(np.int64) % len(TONES)
    looks.colors[glass] = np.repeat(TONES[numbers], len(SIDES), axis=0)
    looks.alpha[glass] = 1.0
    looks.textures[glass] = texture_number(set_of("mirroring_glass"))
    looks.coordinates[glass] = np.stack([across, up], axis=-1).reshape(-1, 3, 2)
    return shown
