"""Blocks: a room with what belongs to it, laid out in a rectangle that touches the corridor along its front.

Local frame: x along the corridor from 0 to the block's width, y from 0 at the corridor to the band's depth.
"""

from dataclasses import dataclass, field

from mansion_planner.program.model import Box, PlannedRoom

__all__ = ["Block", "front_depth", "group_blocks", "lay_block", "widened"]

DOOR = 1.5
"""Least contact of a room with what it is reached from, with a margin over the 1.20 m of a door, metres."""


LEAST_FRONT = 1.3
"""Least stretch of corridor, or of its host's wall, that a room gets, metres."""


def widened(widths: list[float], least: list[float]) -> list[float]:
    """Raise widths to their least; those that have more to spare give it, in proportion.

    The sum stays; widths that cannot all have their least stay as they are.
    """
    need = sum(max(low - width, 0.0) for width, low in zip(widths, least))
    spare = sum(max(width - low, 0.0) for width, low in zip(widths, least))
    if need <= 0.0 or spare <= need:
        return widths
    return [low if width < low else width - (width - low) * need / spare for width, low in zip(widths, least)]


@dataclass
class Block:
    """A room of full depth with small rooms cut from its front corner.

    Attributes
    ----------
    host : PlannedRoom
    smalls : list of PlannedRoom
        Rooms too small for the band's depth, also reached from the corridor.
    least : float
        Metres of front that its place asks for.
    """

    host: PlannedRoom
    smalls: list[PlannedRoom] = field(default_factory=list)
    least: float = 0.0

    @property
    def gross(self) -> float:
        """Area of the host with its suite and the small rooms."""
        return self.host.gross + sum(room.area for room in self.smalls)

    @property
    def fixed(self) -> bool:
        """Whether its width must not be scaled."""
        return self.host.fixed

    @property
    def least_width(self) -> float:
        """Metres of corridor that its rooms need at least."""
        return max(self.least, LEAST_FRONT * (1 + len(self.smalls)))

    def fronts(self) -> list[PlannedRoom]:
        """Return the rooms that touch the corridor."""
        return [*self.smalls, self.host]


def front_depth(area: float, depth: float) -> float:
    """Return how deep a small room of `area` is made in a band of `depth`."""
    return float(min(max((area * 1.25) ** 0.5, 1.8), max(depth - 1.8, 0.55 * depth)))


def group_blocks(rooms: list[PlannedRoom], depth: float, pairs: list[tuple[str, str]]) -> list[Block]:
    """Give each room that is too small for a band of `depth` to a larger neighbour as its front corner."""
    narrow = [room for room in rooms if not room.suite and room.area / depth < 1.9]
    narrow.sort(key=lambda room: -room.area)
    blocks = [Block(room) for room in rooms if not any(room is other for other in narrow)]
    for room in narrow:
        width = room.area / front_depth(room.area, depth)
        best: Block | None = None
        for block in blocks:
            spare = _spare_front(block, depth)
            if block.host.suite or spare < width + 1.9 or len(block.smalls) >= 3:
                continue
            if best is None or _fit(block, room, depth, pairs) > _fit(best, room, depth, pairs):
                best = block
        if best is None:
            blocks.append(Block(room))
        else:
            best.smalls.append(room)
    return blocks


def _spare_front(block: Block, depth: float) -> float:
    width = block.gross / depth
    return width - sum(room.area / front_depth(room.area, depth) for room in block.smalls)


def _fit(block: Block, room: PlannedRoom, depth: float, pairs: list[tuple[str, str]]) -> float:
    """Prefer hosts of kindred use with room to spare."""
    same_zone = block.host.kind.zone == room.kind.zone
    wanted = room.kind.name in block.host.kind.near or block.host.kind.name in room.kind.near
    asked = any(
        (block.host.called(one) and room.called(other)) or (block.host.called(other) and room.called(one))
        for one, other in pairs
    )
    clean = not (room.kind.wet and "kitchen" in block.host.kind.name)
    return (
        3.0 * wanted
        + 8.0 * asked
        + 2.0 * clean
        + 0.5 * same_zone
        - 2.0 * len(block.smalls)
        + min(_spare_front(block, depth), 12.0) / 6.0
        - (1.0 if block.host.fixed else 0.0)
    )


def lay_block(block: Block, width: float, depth: float) -> list[tuple[PlannedRoom, list[Box]]]:
    """Lay out a block in ``width x depth``; areas keep their proportions.

    Returns
    -------
    list of (PlannedRoom, list of Box)
        Boxes that make up each room, in the local frame.
    """
    scale = width * depth / block.gross
    placed: list[tuple[PlannedRoom, list[Box]]] = []
    x = 0.0
    corner_boxes: list[Box] = []
    for number, room in enumerate(block.smalls):
        high = front_depth(room.area * scale, depth)
        after = LEAST_FRONT * (len(block.smalls) - number)
        wide = min(max(room.area * scale / high, LEAST_FRONT), max(width - x - after, 0.5))
        high = min(high, max(room.area * scale / wide, 1.2))
        corner_boxes.append((x, 0.0, x + wide, high))
        placed.append((room, [(x, 0.0, x + wide, high)]))
        x += wide
    if block.smalls:
        boxes = [(x, 0.0, width, depth)]
        boxes += [(box[0], box[3], box[2], depth) for box in corner_boxes]
        placed.append((block.host, boxes))
        return placed
    return _lay_suite(block.host, width, depth, scale)


def _lay_suite(host: PlannedRoom, width: float, depth: float, scale: float) -> list[tuple[PlannedRoom, list[Box]]]:
    suite = host.suite
    if not suite:
        return [(host, [(0.0, 0.0, width, depth)])]
    if len(suite) == 1 and not suite[0].suite:
        return _lay_one(host, suite[0], width, depth, scale)
    return _lay_columns(host, width, depth, scale)


def _lay_one(
    host: PlannedRoom, child: PlannedRoom, width: float, depth: float, scale: float
) -> list[tuple[PlannedRoom, list[Box]]]:
    """A child in the front corner when the front is wide enough (a hotel room's bath), else at the back."""
    area = child.area * scale
    high = front_depth(area, depth)
    wide = area / high
    if width - wide >= DOOR and area < 0.4 * host.area * scale:
        corner: Box = (0.0, 0.0, wide, high)
        return [(host, [(wide, 0.0, width, depth), (0.0, high, wide, depth)]), (child, [corner])]
    back = area / width
    if back >= 1.5:
        front = depth - back
        return [(host, [(0.0, 0.0, width, front)]), (child, [(0.0, front, width, depth)])]
    high = max(area / max(0.5 * width, 1.5), 1.5)
    wide = area / high
    boxes: list[Box] = [(0.0, 0.0, width, depth - high), (wide, depth - high, width, depth)]
    return [(host, boxes), (child, [(0.0, depth - high, wide, depth)])]


def _lay_columns(host: PlannedRoom, width: float, depth: float, scale: float) -> list[tuple[PlannedRoom, list[Box]]]:
    """The host as a slab of full depth between two columns of its children."""
    children = sorted(host.suite, key=lambda room: -room.gross)
    columns: tuple[list[PlannedRoom], list[PlannedRoom]] = ([], [])
    if len(children) <= 3:
        columns[1].extend(children)
    else:
        for child in children:
            sums = [sum(room.gross for room in column) for column in columns]
            columns[0 if sums[0] <= sums[1] else 1].append(child)
    placed: list[tuple[PlannedRoom, list[Box]]] = []
    wide = [sum(room.gross for room in column) * scale / depth for column in columns]
    least = [LEAST_FRONT if column else 0.0 for column in columns]
    wide = widened([*wide, width - sum(wide)], [*least, LEAST_FRONT])[:2]
    placed.append((host, [(wide[0], 0.0, width - wide[1], depth)]))
    for number, column in enumerate(columns):
        x0, x1 = (0.0, wide[0]) if number == 0 else (width - wide[1], width)
        y = 0.0
        ordered = sorted(column, key=lambda room: (not room.kind.wet, room.id))
        whole = sum(child.gross for child in ordered) or 1.0
        rises = widened([depth * child.gross / whole for child in ordered], [LEAST_FRONT] * len(ordered))
        for child, high in zip(ordered, rises):
            placed.append((child, [(x0, y, x1, y + high)]))
            y += high
    return placed
