"""A building as seen from the street."""

from dataclasses import replace

import numpy as np

from mansion_export.meshes.materials import named
from mansion_export.meshes.solids import Box, boxes_surface
from mansion_export.pictures.renderer import Triangles
from mansion_export.pictures.street_view import mirroring


def test_panes_hide_what_is_behind_them_from_outside() -> None:
    surface = boxes_surface([Box((0.0, 0.0, 1.0), (1.2, 0.02, 1.4))], named("glass"))
    pane = Triangles.plain(surface.vertices[surface.faces], np.array(named("glass").color))
    clear = replace(pane, looks=replace(pane.looks, alpha=np.full(1, 0.3)))
    shown = mirroring(clear).looks
    assert (shown.alpha == 1.0).all()
    assert (shown.textures >= 0).all()
    assert np.ptp(shown.coordinates[..., 1]) == 1.0
