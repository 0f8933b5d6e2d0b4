"""Rendering layers of rooms, by four-colouring, so that light does not bleed through one-sided walls."""

from collections.abc import Collection, Iterable, Mapping, Sequence

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
    groups = _groups(rooms, merged)
    links: dict[str, dict[str, None]] = {group: {} for group in groups.values()}
    for a, b in neighbours:
        if groups[a] != groups[b]:
            links[groups[a]][groups[b]] = None
            links[groups[b]][groups[a]] = None
    colouring = _Colouring(links)
    if not colouring.complete():
        raise MansionError("INFEASIBLE", "the rooms of this floor cannot be given four layers")
    return {room: colouring.colours[groups[room]] for room in rooms}


def _groups(rooms: Sequence[str], merged: Iterable[tuple[str, str]]) -> dict[str, str]:
    """Return the group of each room, named after one of its rooms: merged rooms are of one group."""
    root = {room: room for room in rooms}

    def find(room: str) -> str:
        while root[room] != room:
            room = root[room]
        return room

    for a, b in merged:
        root[find(b)] = find(a)
    return {room: find(room) for room in rooms}


class _Colouring:
    """A colouring of a graph with one colour for each of `LAYERS`, found by backtracking.

    Parameters
    ----------
    links : mapping
        The neighbours of each node.
    """

    def __init__(self, links: Mapping[str, Collection[str]]) -> None:
        self._links = links
        self._assignments = 0
        self.colours: dict[str, int] = {}

    def _used(self, node: str) -> set[int]:
        return {self.colours[other] for other in self._links[node] if other in self.colours}

    def complete(self) -> bool:
        """Colour the nodes that have no colour yet; leave `colours` as it was where that fails."""
        uncoloured = [node for node in self._links if node not in self.colours]
        if not uncoloured:
            return True
        node = max(uncoloured, key=lambda n: (len(self._used(n)), len(self._links[n])))
        for colour in range(len(LAYERS)):
            if colour in self._used(node):
                continue
            self._assignments += 1
            if self._assignments > MOST_ASSIGNMENTS:
                return False
            self.colours[node] = colour
            if self.complete():
                return True
            del self.colours[node]
        return False
