"""What a camera returns: pictures, depth and labels, the pinhole they are taken through, and the ids of labels."""

from collections.abc import Iterable
from dataclasses import dataclass
from math import atan, degrees, radians, tan

import numpy as np
import numpy.typing as npt

from mansion_msgs_py.scene import FloorScene

__all__ = ["Depth", "Frame", "Intrinsics", "Labels", "NOTHING", "Names", "Picture"]

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


class Names:
    """Ids in a fixed order; new ones are added at the end, so that an index never changes its meaning.

    Parameters
    ----------
    scenes : iterable of FloorScene
    """

    def __init__(self, scenes: Iterable[FloorScene]) -> None:
        self._index: dict[str, int] = {}
        self._table: tuple[str, ...] = ()
        for scene in scenes:
            for room in scene.rooms:
                self.index(room.id)
                self.index(f"{room.id}/ceiling")
            for name in _ids(scene):
                self.index(name)

    def __contains__(self, name: object) -> bool:
        return name in self._index

    def index(self, name: str) -> int:
        """Return the index of an id, a new one when it has none."""
        return self._index.setdefault(name, len(self._index))

    @property
    def table(self) -> tuple[str, ...]:
        """The ids, each at its index."""
        if len(self._table) != len(self._index):
            self._table = tuple(self._index)
        return self._table


def _ids(scene: FloorScene) -> list[str]:
    return [
        *(wall.id for wall in scene.walls),
        *(door.id for door in scene.doors),
        *(window.id for window in scene.windows),
        *(core.id for core in scene.cores),
        *(item.id for item in scene.objects),
    ]
