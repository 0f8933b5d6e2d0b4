"""Rendering layers of rooms, by four-colouring, so that light does not bleed through one-sided walls."""

from collections.abc import Iterable, Sequence

from mansion_msgs_py.errors import MansionError

__all__ = ["COLOURS", "four_colours", "layer_name"]

COLOURS = 4

TRIES = 200_000
"""Assignments that the search may try; planar graphs of a floor's size need about one a room."""


def layer_name(colour: int) -> str:
    """Return AI2-THOR's name of a layer."""
    return f"Procedural{colour}"


def four_colours(
    rooms: Sequence[str], neighbours: Iterable[tuple[str, str]], merged: Iterable[tuple[str, str]] = ()
) -> dict[str, int]:
    """Colour rooms so that neighbours differ and merged ones agree.

    Most constrained first (DSATUR), with backtracking.

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
    if not _colour(groups, links, colours, [TRIES]):
        raise MansionError("INFEASIBLE", "the rooms of this floor cannot be given four layers")
    return {room: colours[find(room)] for room in rooms}


def _colour(groups: list[str], links: dict[str, dict[str, None]], colours: dict[str, int], tries: list[int]) -> bool:
    open_groups = [group for group in groups if group not in colours]
    if not open_groups:
        return True

    def used(group: str) -> set[int]:
        return {colours[other] for other in links[group] if other in colours}

    group = max(open_groups, key=lambda g: (len(used(g)), len(links[g])))
    for colour in range(COLOURS):
        if colour in used(group):
            continue
        tries[0] -= 1
        if tries[0] < 0:
            return False
        colours[group] = colour
        if _colour(groups, links, colours, tries):
            return True
        del colours[group]
    return False
