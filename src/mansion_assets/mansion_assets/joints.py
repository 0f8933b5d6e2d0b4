"""Joints of the parts of an asset that move: doors, drawers, lids."""

from typing import Final, Literal, NamedTuple

import numpy as np

from mansion_assets.solids import Vec3
from mansion_geometry.compiled import Floats

__all__ = ["DOOR_OPENS", "DRAWER_OPENS", "Joint"]

DOOR_OPENS: Final = 84.0
"""Degrees by which a door of furniture opens: its handle stays clear of the neighbour's."""

DRAWER_OPENS: Final = 0.6
"""Share of its depth by which a drawer opens."""


class Joint(NamedTuple):
    """How a part moves against the asset's body; 0 is closed.

    Attributes
    ----------
    part : str
        Name of the moving part, unique in the asset.
    kind : {"hinge", "slide"}
    axis : (x, y, z)
        Unit vector along which the part slides, or about which it turns counter-clockwise.
    origin : (x, y, z)
        A point of the axis, metres, in the asset's frame.
    travel : float
        Where it stands open, which is its limit: degrees of a hinge, metres of a slide.
    """

    part: str
    kind: Literal["hinge", "slide"]
    axis: Vec3
    origin: Vec3
    travel: float

    def fitted(self, center: Floats, scale: Floats) -> "Joint":
        """Return the joint of a part moved by `-center` and then stretched along the axes."""
        moved = (np.array(self.origin) - center) * scale
        along = float(np.abs(np.array(self.axis) * scale).sum()) if self.kind == "slide" else 1.0
        return self._replace(origin=(float(moved[0]), float(moved[1]), float(moved[2])), travel=self.travel * along)
