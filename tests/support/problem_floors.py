"""Floor problems for the solver's tests: fixed examples and hypothesis strategies."""

import math

import shapely
from hypothesis import strategies as st

from mansion_geometry.rings import polygon_parts
from mansion_msgs_py.layout import FixedRoom, FloorProblem, ProblemCore, ProblemNode
from mansion_msgs_py.topology import Edge

Ring = list[tuple[float, float]]


def box(x0: float, y0: float, x1: float, y1: float) -> Ring:
    """Return a rectangle's ring."""
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def parts_for_rooms(region: shapely.Geometry) -> shapely.MultiPolygon:
    """Return the parts of a region that are somewhere half a metre wide; the largest where none is."""
    parts = polygon_parts(region)
    wide = [part for part in parts if not part.buffer(-0.25, join_style="mitre").is_empty]
    return shapely.MultiPolygon(wide or [max(parts, key=lambda part: part.area)])


def flat() -> FloorProblem:
    """Return a small flat: a hub, four rooms around it and a bathroom behind a bedroom."""
    nodes = [
        ProblemNode(id="living", type="main", area=26.0),
        ProblemNode(id="bed", type="Entities", area=14.0),
        ProblemNode(id="bath", type="Entities", area=5.0),
        ProblemNode(id="kitchen", type="Entities", area=9.0),
        ProblemNode(id="study", type="Entities", area=10.0),
    ]
    edges = [
        Edge(source="living", target="bed"),
        Edge(source="bed", target="bath"),
        Edge(source="living", target="kitchen"),
        Edge(source="living", target="study"),
        Edge(source="kitchen", target="study", kind="adjacent"),
    ]
    return FloorProblem(boundary=box(0, 0, 8, 8), nodes=nodes, edges=edges, plan_id="flat")


def office(rooms: int = 8) -> FloorProblem:
    """Return an office floor: a corridor, rooms along it, a stair in the middle with a door side, and a lift."""
    stair = ProblemCore(id="stair", type="stair", polygon=box(7, 4, 10, 9), door_side="south")
    lift = ProblemCore(id="lift", type="elevator", polygon=box(10, 4, 12, 6))
    nodes = [ProblemNode(id="corridor", type="main", area=40.0)]
    edges = [Edge(source="corridor", target="stair"), Edge(source="corridor", target="lift")]
    for k in range(rooms):
        nodes.append(ProblemNode(id=f"office_{k}", type="Entities", area=15.0 + 3 * (k % 3)))
        edges.append(Edge(source="corridor", target=f"office_{k}"))
    nodes.append(ProblemNode(id="stair", type="stair"))
    nodes.append(ProblemNode(id="lift", type="elevator"))
    return FloorProblem(
        boundary=box(0, 0, 18, 12), nodes=nodes, edges=edges, cores=[stair, lift], min_access_wall=1.2, plan_id="office"
    )


@st.composite
def outlines(draw: st.DrawFn) -> Ring:
    """Draw a simple polygon: a box, an L, a slanted or a turned one, in either order."""
    wide = draw(st.floats(5.0, 20.0))
    high = draw(st.floats(5.0, 15.0))
    kind = draw(st.sampled_from(["box", "ell", "slanted", "star", "turned"]))
    ring = box(0, 0, wide, high)
    if kind == "ell":
        x, y = wide * draw(st.floats(0.4, 0.8)), high * draw(st.floats(0.4, 0.8))
        ring = [(0, 0), (wide, 0), (wide, y), (x, y), (x, high), (0, high)]
    elif kind == "slanted":
        ring = [(0, 0), (wide, 0), (wide * 0.8, high), (wide * 0.1, high * 0.9)]
    elif kind == "star":
        count = draw(st.integers(5, 14))
        ring = [
            (
                wide / 2 * (1 + (0.75 + 0.2 * (k % 2)) * math.cos(2 * math.pi * k / count)),
                high / 2 * (1 + (0.75 + 0.2 * (k % 2)) * math.sin(2 * math.pi * k / count)),
            )
            for k in range(count)
        ]
    elif kind == "turned":
        angle = draw(st.floats(0.1, 1.4))
        c, s = math.cos(angle), math.sin(angle)
        ring = [(c * x - s * y, s * x + c * y) for x, y in ring]
    return ring[::-1] if draw(st.booleans()) else ring


@st.composite
def small_boxes(draw: st.DrawFn) -> Ring:
    """Draw a small rectangle near the origin's quadrant."""
    x, y = draw(st.floats(-1.0, 12.0)), draw(st.floats(-1.0, 9.0))
    return box(x, y, x + draw(st.floats(0.5, 3.0)), y + draw(st.floats(0.5, 3.0)))


@st.composite
def problems(draw: st.DrawFn) -> FloorProblem:
    """Draw a floor problem; its geometry need not make sense."""
    count = draw(st.integers(1, 7))
    names = [f"r{k}" for k in range(count)]
    others = st.sampled_from(["Entities", "Entities", "area"])
    kinds = ["main", *draw(st.lists(others, min_size=count - 1, max_size=count - 1))]
    nodes = [
        ProblemNode(
            id=name,
            type=kind,
            area=draw(st.none() | st.floats(0.5, 40.0)),
            seed=draw(st.none() | st.tuples(st.floats(0.0, 20.0), st.floats(0.0, 15.0))),
            min_width=draw(st.none() | st.floats(0.5, 3.0)),
        )
        for name, kind in zip(names, kinds)
    ]
    cores = [
        ProblemCore(id=f"core{k}", type="stair", polygon=ring, door_side=draw(st.sampled_from([None, "north", "east"])))
        for k, ring in enumerate(draw(st.lists(small_boxes(), max_size=2)))
    ]
    fixed = [
        FixedRoom(id=f"fixed{k}", polygon=ring) for k, ring in enumerate(draw(st.lists(small_boxes(), max_size=1)))
    ]
    ends = names + [core.id for core in cores] + [room.id for room in fixed]
    edges = draw(
        st.lists(
            st.builds(
                Edge,
                source=st.sampled_from(ends),
                target=st.sampled_from(ends),
                kind=st.sampled_from(["access", "adjacent"]),
            ),
            max_size=10,
        )
    )
    at, reach = st.floats(0.0, 12.0), st.floats(0.0, 12.0)
    point = st.tuples(at, reach)
    upright = st.builds(lambda x, a, b: ((x, a), (x, b)), at, reach, reach)
    walls = st.one_of(upright, upright, upright, st.tuples(point, point))
    return FloorProblem(
        boundary=draw(outlines()),
        holes=draw(st.lists(small_boxes(), max_size=1)),
        cores=cores,
        fixed_rooms=fixed,
        structural_walls=draw(st.lists(walls, max_size=2)),
        nodes=nodes,
        edges=edges,
        seed=draw(st.integers(0, 5)),
    )
