"""Sample rooms for the placement tests."""

from collections.abc import Sequence

from mansion_msgs_py.placement import (
    MatrixStructure,
    PairedStructure,
    PlacementObject,
    PlacementOpening,
    PlacementRoom,
    Relation,
    SingleStructure,
    Structure,
)

Point = tuple[float, float]


def item(
    name: str,
    size: tuple[float, float, float],
    quantity: int = 1,
    where: str = "unconstrained",
    *,
    matrix: tuple[int, int] | None = None,
    paired: str | None = None,
    smaller: Sequence[tuple[float, float, float]] = (),
    **relative: str,
) -> PlacementObject:
    """Return an object; keyword arguments are relations, ``near="bed"``."""
    structure: Structure = SingleStructure()
    if matrix:
        structure, quantity = MatrixStructure(rows=matrix[0], cols=matrix[1]), matrix[0] * matrix[1]
    if paired:
        structure = PairedStructure(with_=paired)
    return PlacementObject(
        name=name,
        category=name.replace("_", " "),
        size=size,
        quantity=quantity,
        global_=where,
        smaller=list(smaller),
        relative=[Relation(kind=k, target=t) for k, t in relative.items()],
        structure=structure,
    )


def room(
    polygon: list[Point],
    doors: Sequence[tuple[Point, Point]],
    objects: Sequence[PlacementObject],
    *,
    kind: str = "room",
    windows: Sequence[tuple[Point, Point]] = (),
    holes: Sequence[list[Point]] = (),
) -> PlacementRoom:
    """Return a room."""
    return PlacementRoom(
        room_id=f"test/{kind.replace(' ', '_')}",
        room_type=kind,
        polygon=polygon,
        holes=list(holes),
        doors=[PlacementOpening(segment=d, id=f"door_{i}", sill=0.0) for i, d in enumerate(doors)],
        windows=[PlacementOpening(segment=w, id=f"window_{i}") for i, w in enumerate(windows)],
        objects=list(objects),
    )


def rectangle(width: float, depth: float) -> list[Point]:
    """Return a rectangle from the origin, counter-clockwise."""
    return [(0.0, 0.0), (width, 0.0), (width, depth), (0.0, depth)]


def classroom() -> PlacementRoom:
    """A teacher's desk, twenty desks with chairs in a matrix, storage."""
    return room(
        rectangle(8, 7),
        [((8, 0.3), (8, 1.2))],
        [
            item("teacher_desk", (1.4, 0.7, 0.75), 1, "edge"),
            item("teacher_chair", (0.55, 0.55, 0.95), paired="teacher_desk"),
            item("student_desk", (0.65, 0.5, 0.75), where="middle", matrix=(4, 5)),
            item("student_chair", (0.4, 0.4, 0.8), 20, "middle", paired="student_desk"),
            item("bookshelf", (0.9, 0.35, 1.8), 3, "edge"),
            item("plant", (0.35, 0.35, 0.9), 2, "edge"),
        ],
        kind="classroom",
        windows=[((1, 7), (3.5, 7)), ((4.5, 7), (7, 7))],
    )


def ward() -> PlacementRoom:
    """Two rows of beds as an edge matrix, each with a cabinet."""
    return room(
        rectangle(10, 7.5),
        [((0, 3), (0, 4.4))],
        [
            item("bed", (1.0, 2.1, 0.6), where="edge", matrix=(2, 3)),
            item("bedside_cabinet", (0.45, 0.45, 0.85), 6, "edge", paired="bed"),
            item("visitor_chair", (0.5, 0.5, 0.85), 6, near="bed"),
        ],
        kind="hospital ward",
    )


def restaurant() -> PlacementRoom:
    """An L-shaped room of tables with four chairs each, two doors."""
    return room(
        [(0, 0), (11, 0), (11, 5), (6, 5), (6, 9), (0, 9)],
        [((1, 0), (2.4, 0)), ((2, 9), (2.9, 9))],
        [
            item("bar_counter", (2.4, 0.6, 1.1), 1, "edge"),
            item("bar_stool", (0.35, 0.35, 0.75), 4, in_front_of="bar_counter"),
            item("table", (0.9, 0.9, 0.75), 6, "middle"),
            item("chair", (0.45, 0.45, 0.9), 24, "middle", around="table"),
            item("service_station", (0.8, 0.5, 1.0), 1, "edge", far="bar_counter"),
        ],
        kind="restaurant",
    )
