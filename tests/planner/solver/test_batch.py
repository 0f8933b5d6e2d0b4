"""`mansion solve`: files of problems."""

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import msgspec
import pytest

from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorProblem, ProblemNode
from mansion_msgs_py.world import Progress
from mansion_planner.solver import solve_floor
from mansion_planner.solver.batch import largest_first, solve_file
from mansion_planner.solver.evaluation import TrueProblem, figures, score_plan, table
from problem_floors import box, flat, office


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
    bad = FloorProblem(boundary=[(0, 0), (1, 1), (2, 2)], nodes=[ProblemNode(id="x", type="main")], plan_id=7)
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
        ProblemNode(id=r.id, type="Entities", area=next(n.area for n in flat().nodes if n.id == r.id))
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
    halves = {"a": left, "b": right}
    rooms = {room.id: msgspec.structs.replace(room, polygon=halves[room.id]) for room in layout.rooms}
    layout = msgspec.structs.replace(layout, rooms=list(rooms.values()))
    fields = {name: getattr(problem, name) for name in FloorProblem.__struct_fields__}
    swapped = [type(r)(id=i, polygon=r.polygon) for i, r in (("b", rooms["a"]), ("a", rooms["b"]))]
    assert score_plan(TrueProblem(**fields, truth=swapped), layout).intersection == 0


# Prints after each problem how the workers were started; the process has no other thread, as on the command line.
SOLVE = """
import multiprocessing, pathlib, sys
from mansion_planner.solver.batch import solve_file

def tell(progress):
    print(*{type(child).__name__ for child in multiprocessing.active_children()}, flush=True)

solve_file(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), jobs=2, progress=tell)
"""


def solving(source: Path, output: Path) -> "subprocess.Popen[str]":
    return subprocess.Popen(
        [sys.executable, "-c", SOLVE, str(source), str(output)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )


@pytest.mark.skipif(sys.platform != "linux", reason="forks on Linux only")
def test_a_process_without_threads_forks_its_workers_and_gets_the_same_layouts(tmp_path: Path) -> None:
    source = write(tmp_path / "problems.json", [flat(), office(4), flat()])
    solve_file(source, tmp_path / "one.json", jobs=1)
    with solving(source, tmp_path / "two.json") as process:
        said, complaint = process.communicate(timeout=120)
    assert (process.returncode, complaint) == (0, "")
    assert said.split()[0] == "ForkProcess"
    assert timeless(tmp_path / "one.json") == timeless(tmp_path / "two.json")


def test_an_interrupt_ends_every_process_and_writes_nothing(tmp_path: Path) -> None:
    source = write(tmp_path / "problems.json", [office(8) for _ in range(60)])
    with solving(source, tmp_path / "out.json") as process:
        assert process.stdout is not None
        assert process.stdout.readline()
        os.killpg(process.pid, signal.SIGINT)
        _, complaint = process.communicate(timeout=60)
    assert process.returncode == -signal.SIGINT
    assert complaint.count("Traceback") == 1
    with pytest.raises(ProcessLookupError):
        os.killpg(process.pid, 0)
    assert [path.name for path in tmp_path.iterdir()] == ["problems.json"]


def test_the_largest_floors_are_handed_out_first_and_equal_ones_in_order() -> None:
    problems = [flat(), office(4), flat(), office(8)]
    rooms = [len(problems[index].nodes) for index in largest_first(problems)]
    assert rooms == sorted(rooms, reverse=True)
    assert largest_first([flat(), flat(), flat()]) == [0, 1, 2]
