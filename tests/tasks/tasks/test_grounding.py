"""Needs in words find what fits in a building, and what is missing is named."""

from pathlib import Path

import msgspec
import pytest

from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.task import Goal, GoalKind, Need, Task, TaskKind
from mansion_skills.world.building import LoadedBuilding
from mansion_tasks.tasks.grounding import ground
from mansion_tasks.tasks.needs import describe, matching_objects, matching_rooms
from mansion_tasks.tasks.paper_tasks import PAPER_TASKS, paper_task
from mansion_tasks.tasks.sandbox import Sandbox
from mansion_tasks.tasks.solving import replay


def paint(building: Path, floor: int, thing: str, material: str) -> None:
    """Give an object of a floor another material."""
    file = building / "floors" / f"floor_{floor}" / "scene.json"
    scene = decode(FloorScene, file.read_bytes())
    objects = [
        msgspec.structs.replace(entry, material=material) if entry.id.endswith(thing) else entry
        for entry in scene.objects
    ]
    file.write_bytes(encode_bytes(msgspec.structs.replace(scene, objects=objects)))


@pytest.fixture
def loaded(building: Path) -> LoadedBuilding:
    paint(building, 2, "mug_1", "ceramic_blue")
    return LoadedBuilding(building)


@pytest.mark.parametrize(
    ("need", "found"),
    [
        (Need(noun="mug"), ["F1/office/mug_1", "F2/office/mug_1", "F3/office/mug_1"]),
        (Need(noun="Mug", floor=2), ["F2/office/mug_1"]),
        (Need(noun="mug", color="blue"), ["F2/office/mug_1"]),
        (Need(noun="mug", color="red"), []),
        (Need(noun="mug", room="kitchen"), []),
        (Need(noun="mug", relation="on", receptacle="desk", floor=3), ["F3/office/mug_1"]),
        (Need(noun="mug", relation="in", receptacle="desk", floor=3), []),
        (Need(noun="apple", relation="in", receptacle="refrigerator", floor=1), ["F1/kitchen/apple_1"]),
        (Need(noun="apple", relation="in", floor=1), ["F1/kitchen/apple_1"]),
        (Need(noun="light", floor=1), ["F1/kitchen/ceiling_light_1"]),
        (Need(noun="toolbox"), []),
    ],
)
def test_words_mean_objects(loaded: LoadedBuilding, need: Need, found: list[str]) -> None:
    assert matching_objects(need, loaded) == found


def test_words_mean_rooms(loaded: LoadedBuilding) -> None:
    assert matching_rooms(Need(room="kitchenette"), loaded) == [f"F{k}/kitchen" for k in (1, 2, 3)]
    assert matching_rooms(Need(floor=2), loaded) == ["F2/hall", "F2/office", "F2/kitchen"]
    assert matching_rooms(Need(room="bathroom"), loaded) == []


def test_a_need_is_said_with_the_article_that_fits_the_building(loaded: LoadedBuilding) -> None:
    blue = Need(noun="mug", color="blue", relation="on", receptacle="desk", room="office", floor=2)
    assert describe(blue) == "a blue mug on a desk in an office on the second floor"
    assert describe(blue, loaded) == "the blue mug on a desk in the office on the second floor"
    assert describe(Need(noun="mug"), loaded) == "a mug"
    assert describe(Need(room="hall", floor=1), loaded) == "the hall on the first floor (button G)"


def a_task(*needs: Need, kind: TaskKind = TaskKind.DELIVER, goals: tuple[GoalKind, ...] = ()) -> Task:
    made = [Goal(kind=goal) for goal in goals]
    return Task(id="t", kind=kind, instruction="Do it.", needs=list(needs), goals=made)


TARGET = Need(noun="mug", floor=2, role="target")


@pytest.mark.parametrize(
    ("task", "kinds"),
    [
        (a_task(TARGET, Need(room="kitchen", role="destination")), [GoalKind.OBJECT_IN_ROOM]),
        (a_task(TARGET, Need(floor=3, role="destination")), [GoalKind.OBJECT_IN_ROOM]),
        (a_task(TARGET, Need(noun="table", floor=1, role="destination")), [GoalKind.OBJECT_NEAR]),
        (a_task(TARGET, kind=TaskKind.SEARCH), [GoalKind.SEEN, GoalKind.ROBOT_NEAR]),
        (a_task(TARGET, Need(noun="fridge", role="destination"), kind=TaskKind.OPEN_AND_PUT), [GoalKind.OBJECT_IN]),
        (
            a_task(
                TARGET,
                Need(noun="table", floor=1, role="destination"),
                goals=(GoalKind.OBJECT_NEAR, GoalKind.ROBOT_NEAR),
            ),
            [GoalKind.OBJECT_NEAR, GoalKind.ROBOT_NEAR],
        ),
    ],
)
def test_a_grounded_task_can_be_done_as_it_says(building: Path, task: Task, kinds: list[GoalKind]) -> None:
    sandbox = Sandbox(building)
    made = ground(task, sandbox)
    assert [goal.kind for goal in made.goals] == kinds
    assert made.building_id == "sample" and made.start is not None
    assert made.oracle and made.max_steps >= len(made.oracle)
    assert replay(made, made.oracle, sandbox).success


def test_what_is_missing_is_named(building: Path) -> None:
    task = a_task(Need(noun="basketball", color="red", role="target"), Need(room="hall", role="destination"))
    with pytest.raises(MansionError, match="a red basketball") as caught:
        ground(task, Sandbox(building))
    assert caught.value.code == "INFEASIBLE" and caught.value.info.path == "$.needs[0]"
    assert [need["noun"] for need in caught.value.info.details["missing"]] == ["basketball"]


def test_what_cannot_be_carried_or_opened_does_not_meet_its_part(building: Path) -> None:
    kitchen = Need(room="kitchen", role="destination")
    with pytest.raises(MansionError, match="a desk"):
        ground(a_task(Need(noun="desk", role="target"), kitchen), Sandbox(building))
    closed = a_task(TARGET, Need(noun="table", role="destination"), goals=(GoalKind.OBJECT_IN, GoalKind.CLOSED))
    with pytest.raises(MansionError, match="a table"):
        ground(closed, Sandbox(building))


def test_a_task_that_is_done_already_is_refused(building: Path) -> None:
    here = a_task(TARGET, Need(room="office", floor=2, role="destination"))
    with pytest.raises(MansionError, match="done before it begins"):
        ground(here, Sandbox(building))


def test_the_robot_starts_where_it_is_told(building: Path) -> None:
    task = a_task(TARGET, Need(room="kitchen", floor=3, role="destination"))
    sandbox = Sandbox(building)
    made = ground(task, sandbox, start_floor=3)
    assert made.start is not None and made.start.floor == 3
    assert sandbox.world.view(3).map.room_at(made.start.pose.x, made.start.pose.y) == "F3/kitchen"
    with pytest.raises(MansionError, match="floor 8"):
        ground(task, sandbox, start_floor=8)


def test_the_papers_tasks_say_all_that_their_instruction_says() -> None:
    assert len(PAPER_TASKS) == 7
    for entry in PAPER_TASKS.values():
        said = entry.task.instruction.lower()
        for need in entry.task.needs:
            for words in (need.noun, need.color, need.receptacle, need.receptacle_color, need.room):
                assert words in said
        assert [need.role for need in entry.task.needs] == ["target", "destination"]
    assert paper_task("orange_toolbox").task.needs[0].color == "orange"
    with pytest.raises(MansionError, match="apartment_box"):
        paper_task("sofa")


def test_a_paper_task_is_grounded_where_its_needs_are_met(building: Path) -> None:
    entry = paper_task("orange_toolbox")
    file = building / "floors" / "floor_2" / "scene.json"
    scene = decode(FloorScene, file.read_bytes())
    objects = [
        msgspec.structs.replace(item, category="toolbox", material="metal_orange") if item.category == "mug" else item
        for item in scene.objects
    ]
    file.write_bytes(encode_bytes(msgspec.structs.replace(scene, objects=objects)))
    needs = [
        msgspec.structs.replace(entry.task.needs[0], floor=2),
        msgspec.structs.replace(entry.task.needs[1], floor=3),
    ]
    task = msgspec.structs.replace(entry.task, needs=needs)
    made = ground(task, Sandbox(building))
    assert made.goals[0].objects == ["F2/office/mug_1"]
    assert made.goals[0].rooms == ["F3/hall", "F3/office", "F3/kitchen"]
