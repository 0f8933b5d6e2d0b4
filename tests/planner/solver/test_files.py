"""`mansion solve`: files of problems."""

import json
import sys
from pathlib import Path

import pytest

from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorProblem, ProblemNode
from mansion_msgs_py.world import Progress
from mansion_planner.solver import solve_floor
from mansion_planner.solver.files import solve_file
from mansion_planner.solver.protocol import TrueProblem, figures, score_plan, table

sys.path.insert(0, str(Path(__file__).parent))
from floors import box, flat, office


def write(path: Path, problems: list[FloorProblem]) -> Path:
    path.write_bytes(encode_bytes(problems))
    return path


def timeless(path: Path) -> list[dict[str, object]]:
    layouts = json.loads(path.read_bytes())
    for layout in layouts:
        layout.pop("seconds")
    return list(layouts)


def test_layouts_are_the_same_for_any_number_of_jobs(tmp_path: Path) -> None:
    source = write(tmp_path / "problems.json", [flat(), office(4), flat()])
    solve_file(source, tmp_path / "one.json", jobs=1)
    solve_file(source, tmp_path / "two.json", jobs=2)
    assert timeless(tmp_path / "one.json") == timeless(tmp_path / "two.json")


def test_progress_and_the_seconds_of_each_problem(tmp_path: Path) -> None:
    source = write(tmp_path / "problems.json", [flat(), flat()])
    seen: list[Progress] = []
    layouts = solve_file(source, tmp_path / "out.json", progress=seen.append)
    assert [(p.done, p.total) for p in seen] == [(1, 2), (2, 2)]
    assert all(layout.seconds > 0 for layout in layouts)


def test_a_refused_problem_does_not_stop_the_others(tmp_path: Path) -> None:
    bad = FloorProblem(
        boundary=[(0, 0), (1, 1), (2, 2)], nodes=[ProblemNode(id="x", type="main")], plan_id=7
    )
    source = write(tmp_path / "problems.json", [bad, flat()])
    first, second = solve_file(source, tmp_path / "out.json")
    assert first.rooms == []
    assert first.plan_id == 7
    assert "$.boundary" in first.messages[0]
    assert second.topology_satisfied


def test_a_missing_file_is_said_so(tmp_path: Path) -> None:
    with pytest.raises(MansionError) as caught:
        solve_file(tmp_path / "none.json", tmp_path / "out.json")
    assert caught.value.code == ErrorCode.NOT_FOUND
    assert not (tmp_path / "out.json").exists()


def test_the_protocol_gives_a_plan_that_equals_its_truth_full_marks() -> None:
    layout = solve_floor(flat())
    fields = {name: getattr(flat(), name) for name in FloorProblem.__struct_fields__}
    fields["nodes"] = [
        ProblemNode(
            id=r.id, type="Entities", area=next(n.area for n in flat().nodes if n.id == r.id)
        )
        for r in layout.rooms
    ]
    problem = TrueProblem(**fields, truth=layout.rooms)
    score = score_plan(problem, layout)
    assert score.intersection == score.union > 0
    assert score.macro == 1.0
    assert score.access == (4, 4)
    assert score.one_piece == 5
    assert figures([score, score], resamples=20)["IoU micro"].low == 1.0
    assert "IoU macro" in table([score])


def test_the_protocol_compares_rooms_of_the_same_id_only() -> None:
    nodes = [ProblemNode(id=n, type="Entities", area=8.0) for n in ("a", "b")]
    left, right = box(0, 0, 2, 4), box(2, 0, 4, 4)
    problem = FloorProblem(boundary=box(0, 0, 4, 4), nodes=nodes)
    layout = solve_floor(problem)
    rooms = {room.id: room for room in layout.rooms}
    rooms["a"].polygon, rooms["b"].polygon = left, right
    fields = {name: getattr(problem, name) for name in FloorProblem.__struct_fields__}
    swapped = [type(r)(id=i, polygon=r.polygon) for i, r in (("b", rooms["a"]), ("a", rooms["b"]))]
    assert score_plan(TrueProblem(**fields, truth=swapped), layout).intersection == 0
