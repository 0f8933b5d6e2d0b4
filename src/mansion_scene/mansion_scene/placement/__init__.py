"""Room-level object placement: Algorithm 4 of the supplement's part G, with an improvement pass.

`place_room` is a pure function of room, seed and options. `warm` compiles its kernels ahead of the first call.
"""

from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.placement import PlacementResult, PlacementRoom
from mansion_scene.placement.options import PlacementOptions

_DEFAULTS = PlacementOptions()

__all__ = ["PlacementOptions", "place_room", "warm"]


def place_room(room: PlacementRoom, *, seed: int, options: PlacementOptions = _DEFAULTS) -> PlacementResult:
    """Place the objects of a room.

    Everything placed is in bounds, overlaps nothing, leaves the doors' areas free and can be approached by the robot
    from a door; what cannot be placed so is in `discarded` with the reason.

    Parameters
    ----------
    room : PlacementRoom
        Its polygon is the net interior, metres.
    seed : int
        Same room, seed and options, same result.
    options : PlacementOptions
        Clearances and search budgets.

    Returns
    -------
    PlacementResult
        `seconds` is 0: a pure function reads no clock.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for a polygon that crosses itself, a repeated object name or a reference to an unknown one.
    """
    with importing:
        from mansion_scene.placement.solver import solve_room

    return solve_room(room, seed, options)


def warm() -> None:
    """Compile the machine-code kernels, or load them from the disk cache, by placing a small room."""
    with importing:
        from mansion_msgs_py.placement import PlacementObject, PlacementOpening

    room = PlacementRoom(
        room_id="warm",
        polygon=[(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)],
        doors=[PlacementOpening(segment=((1.0, 0.0), (1.9, 0.0)))],
        objects=[
            PlacementObject(name="shelf", size=(0.8, 0.3, 1.8), global_="edge"),
            PlacementObject(name="table", size=(0.8, 0.6, 0.7), global_="middle"),
        ],
    )
    place_room(room, seed=0)
