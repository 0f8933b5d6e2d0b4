"""What a camera gives, and the pinhole that it looks through."""

from dataclasses import dataclass
from math import atan, degrees, radians, tan

import numpy as np
import numpy.typing as npt

__all__ = ["NOTHING", "Depth", "Frame", "Intrinsics", "Labels", "Picture"]

Picture = npt.NDArray[np.uint8]
"""RGB, shape (height, width, 3)."""

Depth = npt.NDArray[np.float32]
Labels = npt.NDArray[np.int32]

NOTHING = -1
"""Label of pixels that show the sky."""


@dataclass(frozen=True)
class Intrinsics:
    """A pinhole camera without distortion.

    Attributes
    ----------
    width, height : int
        Pixels.
    fov : float
        Across, degrees.
    """

    width: int
    height: int
    fov: float

    @property
    def focal(self) -> float:
        """Focal length, pixels."""
        return self.width / 2 / tan(radians(self.fov) / 2)

    @property
    def vertical_fov(self) -> float:
        """From the lower to the upper edge, degrees."""
        return 2 * degrees(atan(self.height / 2 / self.focal))

    @property
    def center(self) -> tuple[float, float]:
        """Where the optical axis meets the picture, pixels; (0, 0) is the middle of the upper left pixel."""
        return (self.width - 1) / 2, (self.height - 1) / 2


@dataclass(frozen=True)
class Frame:
    """What the camera saw at one moment; row 0 is the upper edge.

    Attributes
    ----------
    rgb : (height, width, 3) array of uint8
    depth : (height, width) array of float32
        Metres along the optical axis; infinite beyond 150 m and where nothing is (REP-118).
    segmentation : (height, width) array of int32
        Index into `names` of what each pixel shows; -1 where nothing is.
    names : tuple of str
        Ids of rooms (their floors), ceilings, walls, doors, windows, cores, objects and robots. An id keeps its index
        as long as the camera lives.
    """

    rgb: Picture
    depth: Depth
    segmentation: Labels
    names: tuple[str, ...]

    def visible(self, least: int = 1) -> dict[str, int]:
        """Return the number of pixels of everything that covers at least `least`, in the order of `names`."""
        labels, counts = np.unique(self.segmentation, return_counts=True)
        return {
            self.names[label]: int(count)
            for label, count in zip(labels.tolist(), counts.tolist())
            if label != NOTHING and count >= least
        }
