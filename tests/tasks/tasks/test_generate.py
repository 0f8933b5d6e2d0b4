"""Generated tasks are solvable, differ, say what they mean, and are the same for the same seed."""

from pathlib import Path

import msgspec
import pytest

from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.task import GoalKind, Task, TaskKind
from mansion_tasks.tasks.generate import generate, recipes_for
from mansion_tasks.tasks.goals import done
from mansion_tasks.tasks.needs import describe
from mansion_tasks.tasks.sandbox import SESSION, Sandbox
from mansion_tasks.tasks.solving import replay
from sample_building import write_building


@pytest.fixture(scope="module")
def sandbox(tmp_path_factory: pytest.TempPathFactory) -> Sandbox:
    folder = tmp_path_factory.mktemp("sample") / "building"
    return Sandbox(write_building(folder, [1, 2, 3, 4]))


@pytest.fixture(scope="module")
def tasks(sandbox: Sandbox) -> list[Task]:
    return generate(sandbox, 15, seed=3)


def test_every_kind_and_span_takes_its_turn(tasks: list[Task]) -> None:
    assert len(tasks) == 15
    assert {task.kind for task in tasks} == set(TaskKind)
    spans = {task.id.split("_s3")[0]: task.floors_spanned for task in tasks}
    assert (spans["deliver_1f"], spans["deliver_2f"], spans["deliver_4f"]) == (1, 2, 4)
    assert len({task.id for task in tasks}) == len({task.instruction for task in tasks}) == 15


def test_every_task_is_open_at_its_start_and_done_by_its_plan(sandbox: Sandbox, tasks: list[Task]) -> None:
    for task in tasks:
        sandbox.reset(task.start)
        assert not done(task, sandbox.world, SESSION)
        assert replay(task, task.oracle, sandbox).success
        assert len(task.oracle) < task.max_steps


def test_the_instruction_names_what_the_goals_hold(sandbox: Sandbox, tasks: list[Task]) -> None:
    for task in tasks:
        for need in task.needs:
            assert describe(need, sandbox.building).lower() in task.instruction.lower()
        assert task.instruction[0].isupper() and task.instruction.endswith(".")


def test_everything_that_fits_the_words_serves(sandbox: Sandbox, tasks: list[Task]) -> None:
    for task in tasks:
        target = next(need for need in task.needs if need.role == "target")
        named = [
            thing.id
            for floor in sandbox.building.floors
            for thing in sandbox.building.scene(floor).objects
            if thing.category == target.noun.replace(" ", "_")
            and target.floor in (None, floor)
            and target.relation == "room"
            and not target.room
        ]
        objects = next(goal for goal in task.goals if goal.objects).objects
        assert set(named) <= set(objects) or target.color


def test_the_same_seed_makes_the_same_tasks_and_another_one_others(sandbox: Sandbox) -> None:
    first = generate(sandbox, 6, seed=1)
    again = generate(Sandbox(sandbox.building.path), 6, seed=1)
    assert encode_bytes(first) == encode_bytes(again)
    assert encode_bytes(first) != encode_bytes(generate(sandbox, 6, seed=2))


@pytest.mark.parametrize("kind", list(TaskKind))
def test_only_the_kind_that_is_asked_for(sandbox: Sandbox, kind: TaskKind) -> None:
    made = generate(sandbox, 4, seed=5, kind=kind)
    assert [task.kind for task in made] == [kind] * 4


def test_a_closing_task_names_one_container(sandbox: Sandbox) -> None:
    closing = [
        goal
        for task in generate(sandbox, 8, seed=2, kind=TaskKind.OPEN_AND_PUT)
        for goal in task.goals
        if goal.kind is GoalKind.CLOSED
    ]
    assert closing and all(len(goal.receptacles) == 1 for goal in closing)


def test_things_are_collected_one_by_one_each_with_a_goal_of_its_own(sandbox: Sandbox) -> None:
    for task in generate(sandbox, 4, seed=6, kind=TaskKind.COLLECT):
        targets = [need.noun for need in task.needs if need.role == "target"]
        assert len(task.goals) == len(targets) == len(set(targets)) >= 2
        taken = [call.arguments["object"] for call in task.oracle if call.skill == "PickUp"]
        assert all(set(goal.objects) & set(taken) for goal in task.goals)
        assert len({tuple(goal.rooms) for goal in task.goals}) == 1


def test_any_recipe_may_have_the_first_turn(sandbox: Sandbox) -> None:
    count = len(recipes_for(4))
    first = [generate(sandbox, 1, seed=4, first=turn)[0].id.rpartition("_s4")[0] for turn in range(count)]
    assert first == [recipe.name for recipe in recipes_for(4)]
    assert generate(sandbox, 2, seed=4, first=count) == generate(sandbox, 2, seed=4)


def test_low_buildings_have_fewer_recipes() -> None:
    assert [recipe.name for recipe in recipes_for(1)] == ["deliver_1f", "search", "open_and_put", "collect"]
    spans = [recipe.span for recipe in recipes_for(4, TaskKind.DELIVER)]
    assert spans == [1, 2, 4] and recipes_for(8, TaskKind.DELIVER)[-1].span == 8


def test_a_building_without_things_has_no_tasks(tmp_path: Path) -> None:
    from mansion_msgs_py.codec import decode
    from mansion_msgs_py.scene import FloorScene

    folder = write_building(tmp_path / "bare", [1])
    file = folder / "floors" / "floor_1" / "scene.json"
    scene = decode(FloorScene, file.read_bytes())
    fixed = [item for item in scene.objects if not item.pickupable]
    file.write_bytes(encode_bytes(msgspec.structs.replace(scene, objects=fixed)))
    with pytest.raises(MansionError, match="nothing for a task"):
        generate(Sandbox(folder), 3)
