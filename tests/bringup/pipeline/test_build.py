"""Building tells how far it is, step by step to the last, and takes the better of two layouts."""

import math
import threading
import time
from multiprocessing import active_children
from pathlib import Path

import msgspec
import pytest
from typer.testing import CliRunner

from mansion_bringup.cli.app import app
from mansion_bringup.pipeline.build import build_building
from mansion_bringup.pipeline.floors import solve
from mansion_bringup.pipeline.stages import LocalStages
from mansion_bringup.verify import verify_building
from mansion_msgs_py.building import BuildingReport
from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.codec import decode
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorLayout, FloorProblem, LayoutRoom
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.stages import FurnishRequest
from mansion_msgs_py.world import Progress
from mansion_planner.plan import plan_building


def test_progress_grows_step_by_step_to_its_total(tmp_path: Path) -> None:
    told: list[Progress] = []
    build_building(BuildRequest(description="a small flat"), tmp_path / "flat", report=told.append)
    counts = [progress.done for progress in told]
    assert counts == sorted(counts)
    assert set(range(told[-1].total + 1)) == set(counts)
    assert told[-1].stage == "done"


FLOOR_FILES = ["layout.json", "plan.png", "plan.svg", "scene.json", "topology.json"]


def test_a_build_writes_plans_and_a_picture_and_what_it_is_asked_for(tmp_path: Path) -> None:
    request = BuildRequest(description="a small flat")
    lean = build_building(request, tmp_path / "lean")
    assert sorted(path.name for path in lean.path.iterdir()) == [
        "building.json",
        "building.png",
        "floors",
        "report.json",
    ]
    assert sorted(path.name for path in (lean.path / "floors/floor_1").iterdir()) == FLOOR_FILES
    asked = build_building(request, tmp_path / "asked", formats=["mjcf", "html", "nav2"])
    floor = asked.path / "floors/floor_1"
    assert sorted(path.name for path in floor.iterdir()) == sorted([*FLOOR_FILES, "map.pgm", "map.yaml", "model.xml"])
    assert (asked.path / "view.html").is_file() and any((asked.path / "meshes").iterdir())
    assert not (asked.path / "building.glb").exists()
    for built in (lean, asked):
        names = [*built.building.files.values(), *built.building.floors[0].files.values()]
        assert "view.html" not in names and all((built.path / name).is_file() for name in names)
        assert verify_building(built.path) == []
    assert (lean.path / "floors/floor_1/scene.json").read_bytes() == (floor / "scene.json").read_bytes()


def test_an_unknown_format_is_refused_before_anything_is_built(tmp_path: Path) -> None:
    with pytest.raises(MansionError, match=r"no format 'clay'; use all, or some of thor") as caught:
        build_building(BuildRequest(description="a small flat"), tmp_path / "flat", formats=["glb", "clay"])
    assert caught.value.code == ErrorCode.NOT_FOUND
    assert list(tmp_path.iterdir()) == []


class _Solver(LocalStages):
    """Stages whose solver lays out the rooms of a problem as squares of what share of their area its id says."""

    def solve(self, problem: FloorProblem) -> FloorLayout:
        sides = {node.id: math.sqrt((node.area or 1.0) * float(problem.plan_id)) for node in problem.nodes}
        rooms = [
            LayoutRoom(id=name, polygon=[(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)])
            for name, side in sides.items()
        ]
        return FloorLayout(rooms=rooms, topology_satisfied=True, unmet_edges=[], plan_id=problem.plan_id)


@pytest.mark.parametrize(
    ("loose", "sketched", "taken"), [("0.5", "1.0", "1.0"), ("0.95", "1.0", "0.95"), ("0.5", "0.4", "0.5")]
)
def test_the_places_of_the_sketch_are_taken_where_a_layout_misses_the_areas(
    loose: str, sketched: str, taken: str
) -> None:
    plan = plan_building(BuildRequest(description="a shop of one storey"))
    problem, fallback = (msgspec.structs.replace(plan.problems[0], plan_id=share) for share in (loose, sketched))
    plan = msgspec.structs.replace(plan, problems=[problem], fallbacks=[fallback])
    assert solve(_Solver(), plan, 0).plan_id == taken


def test_a_floor_without_a_sketch_is_drawn_anew_where_its_layout_misses_the_areas() -> None:
    plan = plan_building(BuildRequest(description="a shop of one storey"))
    problem = msgspec.structs.replace(plan.problems[0], plan_id="0.5")
    plan = msgspec.structs.replace(plan, problems=[problem], fallbacks=[None])

    class OtherDraws(_Solver):
        def solve(self, problem: FloorProblem) -> FloorLayout:
            share = "0.5" if problem.seed == plan.problems[0].seed else "1.0"
            return super().solve(msgspec.structs.replace(problem, plan_id=share))

    assert solve(OtherDraws(), plan, 0).plan_id == "1.0"


def test_each_bedroom_of_a_flat_has_a_bed(tmp_path: Path) -> None:
    text = "Grandparents, parents and a baby share this flat: three bedrooms, a nursery and two bathrooms."
    build_building(BuildRequest(description=text, floor_area=108.0, floors=1, seed=2083577693649823), tmp_path / "flat")
    folder = BuildingFolder(tmp_path / "flat")
    told = [wish.status for wish in folder.building.wishes if wish.text == "three bedrooms"]
    assert told == ["met"]


def test_a_killed_worker_ends_the_build_with_a_line_and_the_next_build_goes_on(tmp_path: Path) -> None:
    def kill_workers(progress: Progress) -> None:
        if progress.stage == "plan_program" and progress.done:
            waiting.set()

    def kill_one() -> None:
        waiting.wait()
        while not (children := active_children()):
            time.sleep(0.01)
        children[0].kill()

    waiting = threading.Event()
    killer = threading.Thread(target=kill_one)
    killer.start()
    request = BuildRequest(description="a house of two storeys")
    with pytest.raises(MansionError, match="was killed") as caught:
        build_building(request, tmp_path / "house", jobs=2, report=kill_workers)
    killer.join()
    assert caught.value.code == ErrorCode.UNAVAILABLE
    build_building(request, tmp_path / "house")
    assert [path.name for path in tmp_path.iterdir()] == ["house"]


class _Careless(LocalStages):
    """Stages whose furniture stands in a corner of its own, out of the building."""

    def furnish(self, request: FurnishRequest) -> FloorScene:
        scene = super().furnish(request)
        first = msgspec.structs.replace(scene.objects[0], position=(-50.0, -50.0, 0.5))
        return msgspec.structs.replace(scene, objects=[first, *scene.objects[1:]])


def test_a_build_tells_the_faults_that_the_check_finds(tmp_path: Path) -> None:
    request = BuildRequest(description="a small flat")
    sound = build_building(request, tmp_path / "sound")
    assert sound.report.faults == [] and verify_building(sound.path) == []
    faulty = build_building(request, tmp_path / "faulty", stages=_Careless())
    assert faulty.report.faults == [str(fault) for fault in verify_building(faulty.path)] != []
    assert decode(BuildingReport, (faulty.path / "report.json").read_bytes()).faults == faulty.report.faults


def test_a_build_with_faults_does_not_end_with_success(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("mansion_bringup.pipeline.build.LocalStages", _Careless)
    result = CliRunner().invoke(app, ["build", "a small flat", "-o", str(tmp_path / "flat"), "--jobs", "1"])
    assert result.exit_code == 1
    assert "does not pass `mansion check`" in result.stderr


def test_storeys_that_are_alike_pass_the_check_of_the_build(tmp_path: Path) -> None:
    request = BuildRequest(description="a hostel of three storeys, 150 m2 each; floors 2 and 3 are identical")
    built = build_building(request, tmp_path / "hostel")
    assert [floor.copy for floor in built.building.program.floors] == [None, None, 2]
    assert built.report.faults == []
