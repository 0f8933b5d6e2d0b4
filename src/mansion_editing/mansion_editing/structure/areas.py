"""Changes of a room's area, which its neighbours give or take."""

import itertools
from collections.abc import Iterator, Mapping
from dataclasses import replace

from shapely import Polygon

from mansion_editing.structure.attempts import Change, Outcome, attempt
from mansion_editing.structure.rebuilding import passages_of_scene
from mansion_editing.structure.room_shapes import ShapeLimits, is_circulation, limits_of
from mansion_editing.structure.storey_documents import Reshaped, Storey, Workshop, node_of, region_shapes, with_shapes
from mansion_editing.structure.wall_moves import MovedWall, Plan, most_area, plans
from mansion_geometry.shared_walls import edge_array, shared_walls
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneRoom
from mansion_msgs_py.wording import listed

__all__ = ["change_area"]

_LEAST_CHANGE = 0.1
"""Square metres below which nothing is moved."""

_MOST_PLANS = 6
_FEW_PLANS = 3
"""Plans that are tried for an area that is only offered."""

_ENOUGH = 3
"""Plans that work from which the one that loses least is taken."""

_SMALLER = (0.8, 0.6, 0.4, 0.2)
"""Shares of a change that are tried where all of it cannot be, to say what can."""


def change_area(storey: Storey, room_id: str, area: float, workshop: Workshop, *, absolute: bool = False) -> Reshaped:
    """Make a room larger or smaller by moving walls between it and neighbours that can give or take.

    Stairs, lifts, corridors and the outline stay as they are, and so do all rooms that are no neighbours of it.

    Parameters
    ----------
    storey : Storey
    room_id : str
        Id of the room in the scene.
    area : float
        Square metres that it gains (or loses, where negative); with `absolute`, that it is to have.
    workshop : Workshop
    absolute : bool

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for an unknown room, ``INVALID_PAYLOAD`` for an area that says nothing, ``INFEASIBLE`` with the
        reason and the area that can be had.
    """
    room = storey.room(room_id)
    shapes = region_shapes(storey, storey.layout)
    now = float(shapes[node_of(room)].area)
    change = area - now if absolute else area
    if abs(change) < _LEAST_CHANGE:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"{room_id} has {now:.1f} m2; name an area that differs by at least {_LEAST_CHANGE} m2",
            path="$.area",
        )
    if now + change <= 0:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{room_id} has only {now:.1f} m2", path="$.area")
    if change < 0 and is_circulation(room):
        raise MansionError(ErrorCode.INFEASIBLE, f"{room_id} is a passage and keeps its width", path="$.room_id")
    return _Neighbourhood(storey, room, shapes, workshop).changed(change)


class _Neighbourhood:
    """A room and the neighbours that it may take floor from or give floor to."""

    def __init__(self, storey: Storey, room: SceneRoom, shapes: Mapping[str, Polygon], workshop: Workshop) -> None:
        self.storey, self.room, self.workshop = storey, room, workshop
        self.node = node_of(room)
        known = {node_of(other): other for other in storey.scene.rooms}
        edges = edge_array(shapes[self.node])
        self.others = [
            name
            for name, other in known.items()
            if name != self.node and not is_circulation(other) and shared_walls(edges, edge_array(shapes[name]), 1e-3)
        ]
        self.shapes = {name: shapes[name] for name in (self.node, *self.others)}
        walls = storey.floor.structural_walls
        self.limits: dict[str, ShapeLimits] = {
            name: limits_of(shape, known[name].room_type, walls, gives=name != self.node)
            for name, shape in self.shapes.items()
        }

    def changed(self, change: float) -> Reshaped:
        """Return the storey with the room's area changed."""
        outcome, reason = self._best(change)
        if outcome is not None:
            return outcome.reshaped
        raise MansionError(ErrorCode.INFEASIBLE, self._refusal(change, reason), path="$.area")

    def _best(self, change: float) -> tuple[Outcome | None, str]:
        """Carry out the first plan that loses nothing, else the one that loses least."""
        found: list[Outcome] = []
        reason = ""
        for plan in itertools.islice(self._plans(change), _MOST_PLANS):
            try:
                outcome = attempt(self._change(plan), self.workshop)
            except MansionError as error:
                reason = reason or error.info.message
                continue
            found.append(outcome)
            if not outcome.losses or len(found) == _ENOUGH:
                break
        return min(found, key=lambda outcome: outcome.losses, default=None), reason

    def _works(self, change: float) -> bool:
        """Whether one of the first plans for a change can be carried out."""
        for plan in itertools.islice(self._plans(change), _FEW_PLANS):
            try:
                attempt(self._change(plan), self.workshop)
            except MansionError:
                continue
            return True
        return False

    def _plans(self, change: float) -> Iterator[Plan]:
        return plans(self.node, change, self.others, self.shapes, self.limits)

    def _change(self, plan: Plan) -> Change:
        changed = {name: shape for name, shape in plan.shapes.items() if shape is not self.shapes[name]}
        ids = {node_of(room): room.id for room in self.storey.scene.rooms}
        return Change(
            before=self.storey,
            after=with_shapes(self.storey, changed),
            passages=passages_of_scene(self.storey.scene),
            may_change={ids[name] for name in changed},
            moves=[_named(move, ids) for move in plan.moves],
        )

    def _refusal(self, change: float, reason: str) -> str:
        now = float(self.shapes[self.node].area)
        wanted = f"{self.room.id} has {now:.1f} m2 and cannot have {now + change:.1f} m2"
        if not self.others:
            return f"{wanted}: around it are only corridors, stairs, lifts and the outside, which stay as they are"
        least = self.limits[self.node].area
        if now + change < least - 1e-6:
            return f"{wanted}: such a room has at least {least:.1f} m2"
        bound = most_area(self.node, self.others, self.shapes, self.limits, grow=change > 0)
        if not reason:
            own = "its" if len(self.others) == 1 else "their"
            verb = "give" if change > 0 else "take"
            reason = f"{listed(self.others)} cannot {verb} more and keep {own} shape"
        return f"{wanted}: {reason}; {self._possible(change, bound)}"

    def _possible(self, change: float, bound: float) -> str:
        """Say the largest (or least) area that was found to work."""
        now = float(self.shapes[self.node].area)
        most = min(change, bound - now) if change > 0 else max(change, bound - now)
        word = "largest" if change > 0 else "smallest"
        for share in (0.98, *_SMALLER) if abs(most) >= _LEAST_CHANGE else ():
            if abs(most * share) >= _LEAST_CHANGE and self._works(most * share):
                return f"the {word} possible is {now + most * share:.1f} m2"
        return "its walls cannot be moved"


def _named(move: MovedWall, ids: Mapping[str, str]) -> MovedWall:
    return replace(move, gainer=ids[move.gainer], giver=ids[move.giver])
