"""Every script of ``examples/`` runs as a process, and does what its docstring says."""

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path

import pytest

from mansion_export.nav2 import FREE, occupancy
from mansion_msgs_py.building import Building
from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.codec import decode
from mansion_msgs_py.world import SkillStatus, WorldState
from mansion_tasks.episodes.log import read_log
from mansion_tasks.episodes.port import LocalPort
from mansion_tasks.episodes.replaying import replay
from mansion_world.world_folder import WorldFolder

EXAMPLES = Path(__file__).parents[2] / "examples"
SCRIPTS = sorted(EXAMPLES.glob("*.py"))

NEEDS = {"gym_env": "gymnasium", "ros_client": "rclpy"}
"""Modules that a script imports and not every environment has."""

GRAPH = {"ros_client"}
"""Scripts that start node processes."""

Check = Callable[[list[str], Path], None]
"""Gets the lines that a script prints, and its output folder."""


def run(script: Path, folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
    """Run a script in `folder`, in a ROS domain of its own."""
    environment = dict(os.environ)
    if script.stem in GRAPH:
        from mansion_bringup.graph.domains import free_domain

        environment["ROS_DOMAIN_ID"] = str(free_domain())
    return subprocess.run(
        [sys.executable, str(script), *arguments],
        cwd=folder,
        env=environment,
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        check=False,
        timeout=240,
    )


def takes_output(script: Path) -> bool:
    """Whether a script has the option ``--output``."""
    return '"--output"' in script.read_text(encoding="utf-8")


def check_build(lines: list[str], output: Path) -> None:
    """The index, the files of each floor, and the figures that are printed."""
    folder = output / "clinic"
    building = decode(Building, (folder / "building.json").read_bytes())
    assert lines[0].startswith(f"{building.building_id} in ")
    floors = [line for line in lines if line.startswith("floor ")]
    assert floors == [
        f"floor {floor.floor}: {floor.area:.0f} m2, {floor.rooms} rooms, {floor.objects} objects"
        for floor in building.floors
    ]
    assert len(floors) == 2
    files = [line.split(": ")[1] for line in lines if line.startswith("  ")]
    assert {Path(name).name for name in files} >= {"scene.json", "plan.svg", "model.xml", "map.pgm"}
    assert [name for name in files if not (folder / name).stat().st_size] == []
    for entry, scene in zip(building.floors, BuildingFolder(folder).scenes(), strict=True):
        assert (len(scene.rooms), len(scene.objects)) == (entry.rooms, entry.objects)


def check_plan(lines: list[str], output: Path) -> None:
    """Rooms that the brief asks for, on floors that hold them, and the words that led to them."""
    plan, why = lines[: lines.index("why:")], lines[lines.index("why:") + 1 :]
    areas: list[float] = []
    rooms: list[dict[str, float]] = []
    for line in plan:
        if found := re.fullmatch(r"floor \d: (\d+) m2", line):
            areas.append(float(found[1]))
            rooms.append({})
        else:
            name, size, unit = line.split()
            assert unit == "m2"
            rooms[-1][name] = float(size)
    assert len(areas) == 2
    assert sum(name.startswith("bedroom") for floor in rooms for name in floor) == 3
    assert "sauna" in rooms[1]
    for area, floor in zip(areas, rooms, strict=True):
        assert 0.5 * area < sum(floor.values()) < area
    assert any(line.startswith('  "sauna" -> ') for line in why)


def check_model_reads(lines: list[str], output: Path) -> None:
    """The German brief is the model's alone; of the English one the rules read what it leaves out."""
    briefs = [k for k, line in enumerate(lines) if not line.startswith("  ")]
    german, english = lines[: briefs[1]], lines[briefs[1] :]
    assert {line.split(":")[0].strip() for line in german[1:-1]} == {"model"}
    assert german[-1].count("bedroom") == 3
    assert "  model: room from 'a sauna'" in english
    assert "  rules: room from 'three bedrooms'" in english
    assert english[-1].startswith("  2 floors: ")


def check_export_nav2(lines: list[str], output: Path) -> None:
    """An image of the size that its header, its length and the script say, and a YAML file that names it."""
    image = output / "nav2" / "floor_2.pgm"
    kind, size, depth, pixels = image.read_bytes().split(b"\n", 3)
    width, height = map(int, size.split())
    assert (kind, depth, len(pixels)) == (b"P5", b"255", width * height)
    assert lines[0].endswith(f"floor_2.pgm: {width} x {height} cells")
    described = dict(line.split(": ") for line in image.with_suffix(".yaml").read_text().splitlines())
    assert (described["image"], described["resolution"]) == (image.name, "0.1")
    free = pixels.count(b"\xfe")
    assert free == (occupancy(BuildingFolder(output / "clinic").scene(2), 0.1).data == FREE).sum()
    assert lines[1] == f"free for the robot: {free * 0.01:.0f} m2"


def check_drive(lines: list[str], output: Path) -> None:
    """The robot rides up, sees that floor's places, walks down, and is kept there."""
    spoken = [line for line in lines if not line.startswith("  ")]
    assert spoken[:5] == [
        "at elevator_1",
        "elevator_1 is on floor 1 with its doors open",
        "arrived on floor 2",
        "at stair_1",
        "arrived on floor 1",
    ]
    places = {line.strip() for line in lines if line.startswith("  ")}
    rooms = {room.id for room in BuildingFolder(output / "clinic").scene(2).rooms}
    assert places == rooms | {"elevator_1", "stair_1"}
    (state,) = (output / "clinic" / "state").glob("*/world.json")
    robot = decode(WorldState, state.read_bytes()).robot
    assert spoken[5] == f"on floor {robot.floor} at ({robot.pose.x:.2f}, {robot.pose.y:.2f})"


def check_edit(lines: list[str], output: Path) -> None:
    """The mug stands in the copy and nowhere else, and the floor's other files have it too."""
    before, after = (BuildingFolder(output / name).scene(1) for name in ("clinic", "edited"))
    old = {item.id for item in before.objects}
    (mug,) = [item for item in after.objects if item.id not in old]
    assert mug.category == "mug"
    assert "red" in mug.material
    assert "reception_desk" in (mug.parent or "")
    assert lines[-1].endswith(mug.id)
    assert any(line.startswith("PlaceOnSurface: ") for line in lines)
    model = Path("floors", "floor_1", "model.xml")
    assert mug.id in (output / "edited" / model).read_text()
    assert mug.id not in (output / "clinic" / model).read_text()
    assert not (output / "edited" / model.with_name("house.json")).exists()


def check_front_door(lines: list[str], output: Path) -> None:
    """The figures are the clinic's, the mug stands in the copy alone, and the robot ends in a room upstairs."""
    clinic, copy = (BuildingFolder(output / name) for name in ("clinic", "front_door"))
    for entry, scene in zip(clinic.building.floors, clinic.scenes(), strict=True):
        area = sum(room.area for room in scene.rooms)
        assert f"floor {entry.floor}: {area:.0f} m2, {entry.rooms} rooms, {entry.objects} objects" in lines
    chairs = [int(line.partition(": ")[2]) for line in lines if line.startswith("  to sit on")]
    assert len(chairs) == 2 and chairs[0] > 2
    old = {item.id for item in clinic.scene(1).objects}
    (mug,) = [item for item in copy.scene(1).objects if item.id not in old]
    assert any(line.endswith(mug.id) for line in lines) and "faults: 0" in lines
    assert (output / "front_door" / "edited.svg").read_text().startswith("<svg")
    upper = next(room for room in copy.scene(2).rooms if room.kind not in ("stair", "elevator"))
    assert lines[-1] == f"on floor 2 in {upper.id}"


def check_gym_env(lines: list[str], output: Path) -> None:
    """The task in words, a line for each step with the action and its status, and the reward."""
    assert lines[0].endswith(".")
    steps = [re.fullmatch(r" ?(\d+) ([a-z_0-9]+): ([A-Z_]+)", line) for line in lines[1:-1]]
    found = [step for step in steps if step]
    assert [int(step[1]) for step in found] == list(range(1, 21))
    statuses = [step[3] for step in found]
    assert set(statuses) <= set(SkillStatus)
    assert "SUCCESS" in statuses
    assert re.fullmatch(r"reward \d\.\d\d on floor [12]", lines[-1])


def check_agent(lines: list[str], output: Path) -> None:
    """Logs of both agents that can be repeated; the oracle does its task."""
    for name in ("oracle", "explorer"):
        log = read_log(output / "episodes" / f"{name}.jsonl")
        assert log.start.agent == name
        assert lines[0] == log.start.task.instruction
        (summary,) = [line for line in lines if line.startswith(f"{name}: ")]
        assert f"success {log.end.success}, {len(log.steps)} skills" in summary
        assert replay(log, output / "clinic", LocalPort()) == []
    assert "oracle: success True" in "\n".join(lines)


def check_ros_client(lines: list[str], output: Path) -> None:
    """A private graph plans, loads the building and drives its robot to the elevator."""
    assert lines[0] == "no graph is running here: starting a private one"
    assert lines[1].startswith("planned: ")
    assert {"kitchen", "bathroom"} <= set(lines[1].split())
    building = BuildingFolder(output / "clinic")
    assert lines[2] == f"loaded {building.building.building_id}, floors {building.floors}"
    elevator = next(core for core in building.scene(1).cores if core.type == "elevator")
    x, y, _ = elevator.entrance
    reached = re.fullmatch(r"on floor 1 at \((\S+), (\S+)\)", lines[3])
    assert reached
    assert float(reached[1]) == pytest.approx(x, abs=1.0)
    assert float(reached[2]) == pytest.approx(y, abs=1.0)


def check_world(lines: list[str], output: Path) -> None:
    """Twenty buildings without a fault, each in a split and of a difficulty, and the rooms of the one opened."""
    assert lines[0].startswith("20 buildings, ")
    assert lines[1] == "faults: 0"
    counts = {name: int(number) for name, number in (line.split(": ") for line in lines[2:9])}
    assert sum(counts[name] for name in ("train", "val", "test")) == 20
    assert sum(counts[name] for name in ("easy", "medium", "hard", "expert")) == 20
    rows = list(WorldFolder(output / "world").manifest())
    assert len(rows) == 20 and all(row.tasks == 1 for row in rows)
    first = next(row for row in rows if row.split == "train")
    rooms = [room.id for scene in BuildingFolder(output / "world" / first.path).scenes() for room in scene.rooms]
    assert lines[9].startswith(first.description)
    assert all(room in lines[9] for room in rooms)


def check_other(lines: list[str], output: Path) -> None:
    """A script without a check of its own prints something."""
    assert lines


CHECKS: dict[str, Check] = {
    "agent": check_agent,
    "build": check_build,
    "drive": check_drive,
    "edit": check_edit,
    "export_nav2": check_export_nav2,
    "front_door": check_front_door,
    "gym_env": check_gym_env,
    "model_reads": check_model_reads,
    "plan": check_plan,
    "ros_client": check_ros_client,
    "world": check_world,
}


def cases() -> list[object]:
    """Return the scripts, with the marks of what they need."""
    found: list[object] = []
    for script in SCRIPTS:
        marks = [pytest.mark.graph] if script.stem in GRAPH else []
        if module := NEEDS.get(script.stem):
            missing = find_spec(module) is None
            marks.append(pytest.mark.skipif(missing, reason=f"{module} is not installed"))
        found.append(pytest.param(script, marks=marks, id=script.stem))
    return found


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, list[str]]:
    """A working directory in which ``build.py`` has run with its defaults, and what it printed."""
    folder = tmp_path_factory.mktemp("examples")
    done = run(EXAMPLES / "build.py", folder)
    assert done.returncode == 0, done.stderr
    return folder / "out" / "examples", done.stdout.splitlines()


@pytest.mark.parametrize("script", cases())
def test_an_example_does_what_it_says(script: Path, built: tuple[Path, list[str]], tmp_path: Path) -> None:
    made, lines = built
    check = CHECKS.get(script.stem, check_other)
    if script.stem == "build":
        check(lines, made)
        return
    shutil.copytree(made, tmp_path / "made")
    arguments = ["--output", "made"] if takes_output(script) else []
    done = run(script, tmp_path, *arguments)
    assert done.returncode == 0, done.stderr
    check(done.stdout.splitlines(), tmp_path / "made")
    assert [path.name for path in tmp_path.iterdir()] == ["made"]


def test_a_building_with_the_state_of_a_robot_is_built_anew(built: tuple[Path, list[str]], tmp_path: Path) -> None:
    shutil.copytree(built[0], tmp_path / "made")
    state = tmp_path / "made" / "clinic" / "state" / "default"
    state.mkdir(parents=True)
    done = run(EXAMPLES / "build.py", tmp_path, "--output", "made")
    assert done.returncode == 0, done.stderr
    assert not state.exists()


def test_the_readme_lists_every_example_and_how_to_run_it() -> None:
    text = (EXAMPLES / "README.md").read_text(encoding="utf-8")
    assert set(re.findall(r"\]\((\w+\.py)\)", text)) == {script.name for script in SCRIPTS}
    for script in SCRIPTS:
        command = f".venv/bin/python examples/{script.name}"
        assert command in script.read_text(encoding="utf-8")
