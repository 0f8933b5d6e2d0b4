"""What a layout keeps to: rooms, walls, topology, zones, cores, outlines."""

import msgspec
import numpy as np
import pytest
import shapely

from mansion_geometry.rings import as_polygon
from mansion_geometry.shared_walls import edge_array, shared_walls
from mansion_msgs_py.codec import encode
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FixedRoom, FloorLayout, FloorProblem, ProblemCore, ProblemNode
from mansion_msgs_py.topology import Edge, SeedBox, SeedPlan
from mansion_planner.solver import SolverOptions, solve_floor
from mansion_planner.solver.cut_rounds import SeedRequest
from problem_floors import box, flat, office


def shapes(layout: FloorLayout) -> dict[str, shapely.Polygon]:
    return {room.id: as_polygon(room.polygon, room.holes) for room in layout.rooms}


def straight_wall(a: shapely.Geometry, b: shapely.Geometry) -> float:
    walls = shared_walls(edge_array(a), edge_array(b), 1e-3)
    return max((wall.length for wall in walls), default=0.0)


def test_a_flat_is_partitioned_with_every_edge_met() -> None:
    layout = solve_floor(flat())
    rooms = shapes(layout)
    assert layout.topology_satisfied
    assert set(rooms) == {"living", "bed", "bath", "kitchen", "study"}
    assert shapely.union_all(list(rooms.values())).area == pytest.approx(64.0, abs=1e-6)
    assert sum(s.area for s in rooms.values()) == pytest.approx(64.0, abs=1e-6)
    assert straight_wall(rooms["bed"], rooms["bath"]) >= 0.9
    assert layout.checks["area_error"] < 0.15


def test_realised_edges_carry_the_wall_that_the_polygons_share() -> None:
    layout = solve_floor(flat())
    rooms = shapes(layout)
    for edge in layout.edges:
        assert edge.wall is not None
        line = shapely.LineString(edge.wall)
        assert rooms[edge.source].exterior.distance(line) < 1e-3
        assert line.length == pytest.approx(edge.length, abs=2e-3) or edge.kind == "adjacent"


def test_an_office_meets_wider_walls_and_the_core_is_entered_on_its_door_side() -> None:
    layout = solve_floor(office())
    rooms = shapes(layout)
    assert layout.topology_satisfied
    stair = next(e for e in layout.edges if "stair" in (e.source, e.target))
    assert stair.wall is not None
    assert {p[1] for p in stair.wall} == {4.0}
    assert all(e.length >= 1.2 - 1e-3 for e in layout.edges if e.kind == "access")
    core = shapely.box(7, 4, 10, 9)
    assert all(shape.intersection(core).area < 1e-9 for shape in rooms.values())


def test_the_same_seed_gives_the_same_bytes_and_another_seed_another_floor() -> None:
    assert encode(solve_floor(flat())) == encode(solve_floor(flat()))
    other = msgspec.structs.replace(flat(), seed=1)
    assert encode(solve_floor(other).rooms) != encode(solve_floor(flat()).rooms)


def test_a_clockwise_outline_gives_the_same_cover() -> None:
    problem = msgspec.structs.replace(flat(), boundary=box(0, 0, 8, 8)[::-1])
    layout = solve_floor(problem)
    assert layout.topology_satisfied
    assert layout.checks["coverage"] == pytest.approx(1.0)


def test_areas_that_do_not_add_up_are_scaled_and_reported() -> None:
    nodes = [ProblemNode(id="a", type="main", area=10.0), ProblemNode(id="b", type="Entities", area=30.0)]
    layout = solve_floor(FloorProblem(boundary=box(0, 0, 10, 8), nodes=nodes))
    assert layout.area_scale == 2.0
    assert shapes(layout)["b"].area == pytest.approx(60.0, rel=0.1)
    assert any("scaled" in message for message in layout.messages)


def test_zones_vanish_and_their_rooms_open_onto_the_hub() -> None:
    nodes = [
        ProblemNode(id="hall", type="main", area=20.0),
        ProblemNode(id="zone", type="area", area=40.0),
        ProblemNode(id="a", type="Entities", area=20.0),
        ProblemNode(id="b", type="Entities", area=20.0),
    ]
    edges = [Edge(source="hall", target="zone"), Edge(source="zone", target="a"), Edge(source="zone", target="b")]
    layout = solve_floor(FloorProblem(boundary=box(0, 0, 10, 6), nodes=nodes, edges=edges))
    rooms = shapes(layout)
    assert set(rooms) == {"hall", "a", "b"}
    assert straight_wall(rooms["hall"], rooms["a"]) >= 0.9
    assert straight_wall(rooms["hall"], rooms["b"]) >= 0.9


def test_a_slanted_outline_is_covered_exactly() -> None:
    ring = [(0.0, 0.0), (10.0, 0.0), (8.0, 7.0), (1.0, 6.0)]
    layout = solve_floor(msgspec.structs.replace(flat(), boundary=ring))
    whole = shapely.union_all(list(shapes(layout).values()))
    outline = as_polygon(ring)
    assert whole.symmetric_difference(outline).area < 1e-3
    assert layout.topology_satisfied


def test_a_turned_building_gets_walls_along_its_own_directions() -> None:
    c, s = np.cos(0.5), np.sin(0.5)
    ring = [(float(c * x - s * y), float(s * x + c * y)) for x, y in box(0, 0, 8, 8)]
    layout = solve_floor(msgspec.structs.replace(flat(), boundary=ring))
    assert layout.topology_satisfied
    assert layout.checks["corners"] < 7.0
    assert layout.checks["coverage"] == pytest.approx(1.0, abs=1e-6)


def test_no_room_straddles_a_structural_wall() -> None:
    wall = ((5.0, 0.0), (5.0, 3.0))
    layout = solve_floor(msgspec.structs.replace(flat(), structural_walls=[wall]))
    line = shapely.LineString(wall)
    for shape in shapes(layout).values():
        assert line.intersection(shape.buffer(-0.02)).length < 0.05


def test_a_slanted_structural_wall_inside_is_refused_with_its_place() -> None:
    problem = msgspec.structs.replace(flat(), structural_walls=[((1.0, 1.0), (5.0, 4.0))])
    with pytest.raises(MansionError) as caught:
        solve_floor(problem)
    assert caught.value.info.path == "$.structural_walls[0]"


def test_a_floor_whose_rooms_are_all_usable_says_so() -> None:
    layout = solve_floor(office())
    assert layout.checks["usable"] == layout.checks["rooms"]
    assert layout.checks["straddled"] == 0.0


def test_fixed_rooms_come_back_unchanged_and_count_for_edges() -> None:
    problem = flat()
    shop = FixedRoom(id="shop", polygon=box(6, 6, 8, 8))
    edges = [*problem.edges, Edge(source="living", target="shop")]
    layout = solve_floor(msgspec.structs.replace(problem, fixed_rooms=[shop], edges=edges))
    rooms = shapes(layout)
    assert layout.topology_satisfied
    assert rooms["shop"].equals(shapely.box(6, 6, 8, 8))
    assert straight_wall(rooms["living"], rooms["shop"]) >= 0.9


def test_a_graph_that_is_not_planar_is_relaxed_adjacent_edges_first() -> None:
    names = ["a", "b", "c", "d", "e"]
    nodes = [ProblemNode(id=n, type="main" if n == "a" else "Entities", area=12.0) for n in names]
    edges = [
        Edge(source=x, target=y, kind="access" if x == "a" else "adjacent")
        for k, x in enumerate(names)
        for y in names[k + 1 :]
    ]
    layout = solve_floor(FloorProblem(boundary=box(0, 0, 10, 6), nodes=nodes, edges=edges))
    assert not layout.topology_satisfied
    assert all(edge.kind == "adjacent" for edge in layout.unmet_edges)
    assert any("planar" in edge.reason for edge in layout.unmet_edges)


def test_a_core_that_cannot_be_entered_is_named() -> None:
    problem = flat()
    core = ProblemCore(id="s", type="stair", polygon=box(0, 5, 2, 8), door_side="north")
    edges = [*problem.edges, Edge(source="living", target="s")]
    layout = solve_floor(msgspec.structs.replace(problem, cores=[core], edges=edges))
    (unmet,) = layout.unmet_edges
    assert {unmet.source, unmet.target} == {"living", "s"}
    assert "north" in unmet.reason


@pytest.mark.parametrize(
    "change",
    [
        {"boundary": [(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)]},
        {"boundary": [(0.0, 0.0), (float("nan"), 0.0), (2.0, 2.0)]},
        {"cores": [ProblemCore(id="c", type="stair", polygon=box(-1, -1, 9, 9))]},
        {"nodes": [ProblemNode(id="lift", type="elevator")]},
        {"edges": [Edge(source="living", target="nowhere")]},
        {"nodes": [ProblemNode(id="x", type="main"), ProblemNode(id="x", type="Entities")]},
    ],
)
def test_senseless_problems_are_refused_with_the_place(change: dict[str, object]) -> None:
    with pytest.raises(MansionError) as caught:
        solve_floor(msgspec.structs.replace(flat(), **change))
    assert caught.value.code == ErrorCode.INFEASIBLE
    assert caught.value.info.path.startswith("$.")


def test_seed_boxes_decide_where_rooms_lie() -> None:
    def centre(x: float) -> float:
        rooms = (("bed", x), ("kitchen", 8 - x), ("study", 8 - x))
        seeds = SeedPlan(
            boxes=[
                SeedBox(room_id=name, x=(at - 1.0, at + 1.0), y=(y - 1.0, y + 1.0))
                for (name, at), y in zip(rooms, (6.0, 6.0, 2.0))
            ]
        )
        layout = solve_floor(msgspec.structs.replace(flat(), seeds=seeds))
        return float(shapes(layout)["bed"].centroid.x)

    assert centre(1.5) < 3.5
    assert centre(6.5) > 4.5


def test_the_callback_is_asked_before_each_round_with_a_preview() -> None:
    seen: list[SeedRequest] = []

    def callback(request: SeedRequest) -> SeedPlan | None:
        seen.append(request)
        return None

    solve_floor(flat(), seed_callback=callback)
    assert [(r.parent, r.children) for r in seen] == [("living", ("bed", "kitchen", "study")), ("bed", ("bath",))]
    assert all(r.preview.startswith(b"\x89PNG") for r in seen)
    assert {room.id for room in seen[1].layout} == {"living", "bed", "kitchen", "study"}
    assert 0.0 < seen[0].fractions["bed"] < 1.0


@pytest.mark.parametrize("budget", [1, 50, 700, 5000])
def test_the_budget_is_never_exceeded(budget: int) -> None:
    layout = solve_floor(office(), options=SolverOptions(candidates=budget))
    assert layout.checks["candidates"] <= budget
    assert layout.checks["coverage"] == pytest.approx(1.0)


def test_the_published_algorithm_alone_also_gives_a_partition() -> None:
    layout = solve_floor(flat(), options=SolverOptions(wall_search=False))
    assert layout.checks["coverage"] == pytest.approx(1.0)
    assert [record.parent for record in layout.rounds] == ["living", "bed"]
