"""The foyer of a public building: floor of its hub beside the entrance, where the rooms leave some."""

from collections.abc import Sequence

from mansion_planner.program.model import Massing, PlannedRoom, Storey, lobby_length
from mansion_planner.program.room_growth import reach

__all__ = ["foyer_length"]

_LEAST, _MOST = 1.2, 9.0
"""Metres of the band beside the entrance that a foyer takes at least and at most."""

_MOST_AREA = 32.0
"""Square metres of a foyer beside the corridor and the lobby before a lift, where the brief states none."""

_MOST_SHARE = 0.25
"""Greatest share of the bar's length for it."""

_IN_ONE_PIECE = 10
"""Rooms up to which the corridor is one piece, and so all of it part of the foyer."""


def foyer_length(
    storey: Storey, massing: Massing, rooms: Sequence[PlannedRoom], capacity: float, stated: float
) -> float:
    """Return the metres of the lower band that the hub of an entrance storey takes for a foyer.

    It takes what the rooms of a brief leave when all have sensible sizes; as much as a foyer of a stated size lacks, of
    what they leave at the sizes that they are planned with; and a little where no lobby lies before a lift.

    Parameters
    ----------
    rooms : sequence of PlannedRoom
    capacity : float
        Square metres for them, without a foyer.
    stated : float
        Square metres of the foyer that the brief states, or 0.
    """
    passes = storey.hub.zone == "circulation" and storey.use.family != "home"
    plain = not (massing.hall or massing.wings or massing.aisles) and massing.south > 0.0
    described = any(room.stated for room in rooms)
    if storey.role not in ("ground", "single") or not (passes and plain and described):
        return 0.0
    spare = capacity - reach(rooms)
    piece = massing.length if len(rooms) <= _IN_ONE_PIECE else 0.5 * massing.length
    lacking = stated - massing.corridor * piece - massing.south * lobby_length(massing, storey)
    left = capacity - sum(room.gross for room in rooms)
    length = max(spare, min(lacking, left)) / massing.south
    most = max(_MOST_AREA, lacking) / massing.south
    length = min(length, most, _MOST, _MOST_SHARE * massing.length) if length >= _LEAST else 0.0
    alone = massing.lobby or massing.corridor > _HALL or capacity < _SMALL or any(r.kind.unit for r in rooms)
    usual = min(max(left, 0.0), _USUAL) / massing.south
    return length if alone or usual < _LEAST else max(length, min(usual, _MOST_SHARE * massing.length))


_USUAL = 15.0
"""Square metres of a foyer beside the corridor of a building without a lift."""

_HALL = 2.9
"""Width from which a corridor is a foyer by itself, metres."""

_SMALL = 90.0
"""Square metres of rooms up to which a corridor is enough to come in by."""
