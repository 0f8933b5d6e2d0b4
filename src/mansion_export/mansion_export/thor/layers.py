"""Rendering layers of rooms, by four-colouring, so that light does not bleed through one-sided walls."""

from collections.abc import Iterable, Sequence

from mansion_export.thor.vocabulary import LAYERS
from mansion_msgs_py.errors import MansionError

__all__ = ["four_colours", "room_layers"]

MOST_ASSIGNMENTS = 200_000
"""Assignments that the search may try; planar graphs of a floor's size need about one a room."""


def room_layers(
    rooms: Sequence[str], neighbours: Iterable[tuple[str, str]], merged: Iterable[tuple[str, str]]
) -> dict[str, str]:
    """Return the layer of each room; see `four_colours`."""
    return {room: LAYERS[colour] for room, colour in four_colours(rooms, neighbours, merged).items()}


def four_colours(
    rooms: Sequence[str], neighbours: Iterable[tuple[str, str]], merged: Iterable[tuple[str, str]] = ()
) -> dict[str, int]:
    """Colour rooms so that neighbours differ and merged ones agree.

    Parameters
    ----------
    rooms : sequence of str
    neighbours : iterable of (str, str)
        Pairs that share a wall.
    merged : iterable of (str, str)
        Pairs with no wall between them.

    Returns
    -------
    dict of str to int
        Colour 0 to 3 of each room.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` where four colours do not do, which no planar floor is.

    Notes
    -----
    The room with most colours among its neighbours comes first, as in DSATUR, with backtracking [1]_.

    References
    ----------
    .. [1] Brélaz, D. (1979). New methods to color the vertices of a graph. Communications of the ACM, 22(4), 251-256.
    """
    root = {room: room for room in rooms}

    def find(room: str) -> str:
        while root[room] != room:
            room = root[room]
        return room

    for a, b in merged:
        root[find(b)] = find(a)
    groups = list(dict.fromkeys(find(room) for room in rooms))
    links: dict[str, dict[str, None]] = {group: {} for group in groups}
    for a, b in neighbours:
        if find(a) != find(b):
            links[find(a)][find(b)] = None
            links[find(b)][find(a)] = None
    colours: dict[str, int] = {}
    assignments = 0

    def used(group: str) -> set[int]:
        return {colours[other] for other in links[group] if other in colours}

    def complete() -> bool:
        """Colour the groups that have no colour yet; leave `colours` as it was where that fails."""
        nonlocal assignments
        uncoloured = [group for group in groups if group not in colours]
        if not uncoloured:
            return True
        group = max(uncoloured, key=lambda g: (len(used(g)), len(links[g])))
        for colour in range(len(LAYERS)):
            if colour in used(group):
                continue
            assignments += 1
            if assignments > MOST_ASSIGNMENTS:
                return False
            colours[group] = colour
            if complete():
                return True
            del colours[group]
        return False

    if not complete():
        raise MansionError("INFEASIBLE", "the rooms of this floor cannot be given four layers")
    return {room: colours[find(room)] for room in rooms}
