"""The floor while it fills: placed boxes, free space, and the hard constraints that every addition must keep."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from mansion_geometry.compiled import Bools, Floats
from mansion_geometry.fitting import feasible_poses
from mansion_scene.placement.groups import Spec
from mansion_scene.placement.options import PlacementOptions
from mansion_scene.placement.room_model import RoomModel

__all__ = ["Effort", "Floor", "Placed"]


_POCKET = 0.15
"""Free floor that one addition may cut off, square metres."""


@dataclass
class Effort:
    """A counter of the work spent on a room, about one unit for two microseconds of a desktop core.

    It counts work, never time, so that results do not depend on the machine.

    Attributes
    ----------
    limit : float
        Work after which improvement ends.
    spent : float
    """

    limit: float
    spent: float = 0.0

    def search(self, poses: int, boxes: int) -> None:
        """Count one search over `poses` against `boxes`."""
        # This line and the one of `flood` are fitted to measured times.
        self.spent += 600.0 + 0.3 * poses + 0.008 * poses * boxes

    def extend(self, factor: float) -> None:
        """Raise the limit."""
        self.limit *= factor

    def flood(self, cells: int) -> None:
        """Count one examination of reachability on a grid of `cells`."""
        self.spent += 120.0 + 0.006 * cells

    @property
    def over(self) -> bool:
        """Whether the limit is reached."""
        return self.spent >= self.limit


@dataclass(frozen=True)
class Placed:
    """A copy on the floor.

    Attributes
    ----------
    spec : int
        Index of its object.
    box : (6,) tuple
        See `mansion_geometry.boxes`.
    size : (float, float, float)
        Size of this copy (of a smaller asset where one was used).
    host : int
        Key of the copy it belongs to, -1 for none.
    key : int
        Number of the copy on this floor, never used again.
    """

    spec: int
    box: tuple[float, ...]
    size: tuple[float, float, float]
    host: int
    key: int


class Floor:
    """Placed copies with their free space; `put` adds some if every hard constraint still holds.

    Parameters
    ----------
    room : RoomModel
    specs : list of Spec
    options : PlacementOptions
    effort : Effort
        Counter of the work done.
    roomy : bool
        Whether clearances include the margins of comfort.
    """

    def __init__(
        self, room: RoomModel, specs: list[Spec], options: PlacementOptions, effort: Effort, *, roomy: bool = True
    ) -> None:
        self.effort = effort
        self.room, self.specs, self.options = room, specs, options
        self.placed: list[Placed] = []
        self.boxes: Floats = np.zeros((0, 6))
        self._counts: dict[int, int] = {}
        self._front: Bools = np.zeros(0, dtype=np.bool_)
        self._partner: npt.NDArray[np.int32] = np.zeros(0, dtype=np.int32)
        self._next = 0
        # Whether all copies were approachable when last checked.
        self._settled = False
        self._set_comfort(roomy=roomy)

    def _set_comfort(self, *, roomy: bool) -> None:
        self.roomy = roomy
        self.zones = self.room.zones(roomy=roomy)
        self.gap = self.options.gap if roomy else 0.002
        self.grid = self.room.grid(self.options, roomy=roomy)
        self._pocket = (_POCKET if roomy else 3 * _POCKET) / self.options.cell**2
        if len(self.boxes):
            self.grid.add(self.boxes)
        self._index()

    def relax(self) -> None:
        """Continue without the margins of comfort."""
        if self.roomy:
            self._set_comfort(roomy=False)

    def copy(self) -> "Floor":
        """Return an independent copy."""
        other = object.__new__(Floor)
        other.__dict__.update(self.__dict__)
        other.placed = list(self.placed)
        other._counts = dict(self._counts)
        other.grid = self.grid.copy()
        return other

    def restore(self, before: "Floor") -> None:
        """Go back to the state of a copy that was made earlier."""
        self.__dict__.update(before.__dict__)

    def count(self, spec: int) -> int:
        """Return how many copies of an object are placed."""
        return self._counts.get(spec, 0)

    @property
    def passage(self) -> float:
        """Width of a gap that the robot passes wherever it lies on the grid, metres."""
        return 2.0 * self.grid.radius + self.grid.cell

    def copies(self, spec: int) -> list[Placed]:
        """Return the copies of an object in the order they were placed."""
        return [copy for copy in self.placed if copy.spec == spec]

    def boxes_of(self, spec: int) -> Floats:
        """Return the boxes of an object's copies, shape (n, 6)."""
        return np.array([copy.box for copy in self.placed if copy.spec == spec]).reshape(-1, 6)

    def fits(self, poses: Floats, parts: Floats) -> Bools:
        """Tell at which poses rigid `parts`, shape (k, 8), are in bounds, free and clear of openings."""
        self.effort.search(len(poses), len(self.boxes) + len(parts))
        if len(parts) > 3:
            # The outermost parts of a pattern are the likeliest not to fit.
            out = np.hypot(*(parts[:, :2] - parts[:, :2].mean(axis=0)).T)
            parts = parts[np.argsort(-out, kind="stable")]
        return feasible_poses(poses, parts, self.room.edges, self.boxes, self.zones, self.gap)

    def put(
        self, boxes: Floats, specs: Sequence[int], hosts: Sequence[int], sizes: Sequence[tuple[float, float, float]]
    ) -> list[Placed] | None:
        """Add copies if all stay reachable and the doors connected; else leave the floor as it was.

        Parameters
        ----------
        boxes : (k, 6) array
        specs : k object indices
        hosts : k keys
            Key of the host copy, -1 for none; -2 - i for the i-th of these copies.
        sizes : k sizes

        Returns
        -------
        The new copies, or None.
        """
        self.effort.flood(self.grid.counts.size)
        lost_before = self.grid.free_cells - self.grid.reached_cells
        front = np.array([self.roomy and self.specs[spec].front_needed for spec in specs])
        partner = self._partners(specs, hosts)
        everything = np.concatenate([self.boxes, boxes[:, :6]])
        sound = self.grid.add(boxes[:, :6])
        if sound:
            lost = self.grid.free_cells - self.grid.reached_cells
            sound = lost - lost_before <= self._pocket
        fronts = np.concatenate([self._front, front])
        if not sound or self.grid.first_unreachable(everything, fronts, partner, changed=self._settled) >= 0:
            self.grid.undo()
            return None
        keys = [self._next + i for i in range(len(specs))]
        added = [
            Placed(spec, tuple(float(v) for v in box[:6]), size, keys[-2 - host] if host <= -2 else host, key)
            for spec, box, host, size, key in zip(specs, boxes, hosts, sizes, keys)
        ]
        self.placed = [*self.placed, *added]
        self.boxes, self._front, self._partner = everything, fronts, partner
        self._next += len(specs)
        self._settled = True
        for spec in specs:
            self._counts[spec] = self._counts.get(spec, 0) + 1
        return added

    def _partners(self, specs: Sequence[int], hosts: Sequence[int]) -> npt.NDArray[np.int32]:
        """Return for every copy, old and new, the copy before its front that may be approached in its stead, or -1."""
        first = len(self.placed)
        partner: npt.NDArray[np.int32] = np.full(first + len(specs), -1, dtype=np.int32)
        partner[:first] = self._partner
        for i, (spec, host) in enumerate(zip(specs, hosts)):
            if host == -1 or self.specs[spec].link not in ("paired", "in_front_of", "around"):
                continue
            at = first - 2 - host if host <= -2 else self._place(host)
            if at >= 0:
                partner[at] = first + i
        return partner

    def _place(self, key: int) -> int:
        """Return the position of a copy among the placed, -1 where it was removed."""
        return next((i for i, copy in enumerate(self.placed) if copy.key == key), -1)

    def _index(self) -> None:
        """Rebuild the arrays that go with `placed`."""
        copies, self.placed = self.placed, []
        self._settled = False
        self.boxes = np.array([copy.box for copy in copies]).reshape(-1, 6)
        self._counts = {}
        self._partner = np.zeros(0, dtype=np.int32)
        for copy in copies:
            self._partner = self._partners([copy.spec], [copy.host])
            self.placed.append(copy)
            self._counts[copy.spec] = self._counts.get(copy.spec, 0) + 1
        self._front = np.array([self.roomy and self.specs[copy.spec].front_needed for copy in copies], dtype=np.bool_)

    def remove(self, keys: set[int]) -> list[Placed]:
        """Remove copies by key and return them; no constraint can break, as only free space grows."""
        gone = [copy for copy in self.placed if copy.key in keys]
        if gone:
            self.placed = [copy for copy in self.placed if copy.key not in keys]
            self._index()
            self.grid.remove(np.array([copy.box for copy in gone]))
        return gone
