"""Tasks made from a building: drawn with a seed, kept only when the oracle does them."""

import hashlib
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

import msgspec
import numpy as np

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.task import Goal, GoalKind, Need, Task, TaskKind, TaskStart
from mansion_skills.skills.receptacles import can_contain
from mansion_tasks.tasks import wording
from mansion_tasks.tasks.goals import done
from mansion_tasks.tasks.grounding import missing_needs, proven, with_ids
from mansion_tasks.tasks.sampling import SURFACES, call_place, call_room, call_thing, draw, draw_start, things
from mansion_tasks.tasks.sandbox import SESSION, Sandbox
from mansion_tasks.tasks.sense import goes_into, goes_on, goes_to, is_brought

__all__ = ["Recipe", "generate", "recipes_for"]

ATTEMPTS: Final = 60
"""Draws for one task before its recipe counts as not possible in the building."""

_NOT_CONTAINERS: Final = ("toilet", "toilet_pan", "kitchen_counter", "counter_top")


@dataclass(frozen=True)
class Recipe:
    """What kind of task to make, and over how many floors; `span` ``None`` is any."""

    kind: TaskKind
    span: int | None

    @property
    def name(self) -> str:
        """The beginning of the ids of its tasks."""
        return self.kind.value if self.span is None else f"{self.kind.value}_{self.span}f"


def recipes_for(floors: int, kind: TaskKind | None = None) -> list[Recipe]:
    """Return the recipes for a building of so many floors, in the order in which they take turns."""
    every = [
        Recipe(TaskKind.DELIVER, 1),
        Recipe(TaskKind.DELIVER, 2),
        Recipe(TaskKind.DELIVER, 4),
        Recipe(TaskKind.SEARCH, None),
        Recipe(TaskKind.OPEN_AND_PUT, None),
    ]
    return [recipe for recipe in every if (recipe.span or 1) <= floors and kind in (None, recipe.kind)]


def generate(
    sandbox: Sandbox,
    count: int,
    seed: int = 0,
    kind: TaskKind | None = None,
    *,
    unsolved: Callable[[Task], None] | None = None,
) -> list[Task]:
    """Make tasks for a building; the same building, count and seed give the same tasks.

    Parameters
    ----------
    sandbox : Sandbox
        Of the building; it is reset.
    count : int
        Fewer come where the building has no more that differ.
    seed : int
    kind : TaskKind, optional
        Only tasks of this kind.
    unsolved : callable, optional
        Told of each draft that the oracle could not do.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` when the building has nothing for any task.
    """
    recipes = recipes_for(len(sandbox.building.floors), kind)
    made: list[Task] = []
    said: set[str] = set()
    index = 0
    while len(made) < count and recipes:
        recipe = recipes[index % len(recipes)]
        task = _make(sandbox, recipe, seed, index, said, unsolved or _forget)
        if task is None:
            recipes.remove(recipe)
            continue
        said.add(task.instruction)
        made.append(task)
        index += 1
    if not made and count:
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"{sandbox.building.building_id} has nothing for a task" + (f" of kind {kind}" if kind else ""),
        )
    return made


def _forget(task: Task) -> None:
    """Nobody asks for the drafts that failed."""


def _make(
    sandbox: Sandbox, recipe: Recipe, seed: int, index: int, said: set[str], unsolved: Callable[[Task], None]
) -> Task | None:
    text = f"{sandbox.building.building_id} {recipe.name} {seed} {index}"
    digest = hashlib.sha256(text.encode()).digest()
    rng = np.random.default_rng(int.from_bytes(digest[:8], "little"))
    for _ in range(ATTEMPTS):
        drawn = _DRAW[recipe.kind](sandbox, recipe, rng)
        if drawn is None or drawn.instruction in said:
            continue
        named = msgspec.structs.replace(drawn, id=f"{recipe.name}_s{seed}_{index}", seed=seed)
        task = _checked(named, sandbox, recipe, unsolved)
        if task is not None:
            return task
    return None


def _checked(task: Task, sandbox: Sandbox, recipe: Recipe, unsolved: Callable[[Task], None]) -> Task | None:
    """Return a task with ids and proof; ``None`` when it is done at once, not by the skills, or over other floors."""
    if missing_needs(task, sandbox.world):
        return None
    task = with_ids(task, sandbox.world)
    sandbox.reset(task.start)
    if any(_holds_already(goal, task, sandbox) for goal in task.goals):
        return None
    try:
        task = proven(task, sandbox)
    except MansionError:
        unsolved(task)
        return None
    return task if recipe.span in (None, task.floors_spanned) else None


def _holds_already(goal: Goal, task: Task, sandbox: Sandbox) -> bool:
    """Whether the goal that makes the task is met at its start; a container may well be closed."""
    if goal.kind is GoalKind.CLOSED:
        return len(goal.receptacles) != 1
    alone = msgspec.structs.replace(task, goals=[goal])
    return done(alone, sandbox.world, SESSION)


def _spread(sandbox: Sandbox, span: int | None, rng: np.random.Generator) -> tuple[int, int, int] | None:
    """Return floors for start, thing and destination that lie `span` floors apart."""
    floors = sandbox.building.floors
    size = span or int(rng.integers(1, len(floors) + 1))
    lows = [floor for floor in floors if floor + size - 1 in floors]
    low = draw(lows, rng)
    if low is None:
        return None
    high = low + size - 1
    inner = [floor for floor in floors if low <= floor <= high]
    ends = (low, high) if rng.random() < 0.5 else (high, low)
    other = inner[int(rng.integers(len(inner)))]
    return ((*ends, other), (ends[0], other, ends[1]), (other, *ends))[int(rng.integers(3))]


def _drawn(
    sandbox: Sandbox,
    floor: int,
    kind: TaskKind,
    forms: tuple[str, ...],
    needs: tuple[Need, Need | None],
    goals: tuple[GoalKind, ...],
    rng: np.random.Generator,
) -> Task | None:
    start: TaskStart | None = draw_start(sandbox.world, floor, rng)
    if start is None:
        return None
    target, place = needs
    return Task(
        id="draft",
        kind=kind,
        instruction=wording.instruction(forms, target, place, sandbox.building, rng),
        start=start,
        needs=[need for need in needs if need is not None],
        goals=[Goal(kind=goal) for goal in goals],
    )


def _deliver(sandbox: Sandbox, recipe: Recipe, rng: np.random.Generator) -> Task | None:
    spread = _spread(sandbox, recipe.span, rng)
    if spread is None:
        return None
    start, source, goal = spread
    building = sandbox.building
    thing = draw([entry for entry in things(building.scene(source)) if is_brought(entry)], rng)
    scene = building.scene(goal)
    if thing is None:
        return None
    target = call_thing(thing, building.scene(source), building, rng)
    wanted = {room.id: room for room in scene.rooms if room.kind not in ("stair", "elevator") and goes_to(thing, room)}
    if rng.random() < 0.5:
        room = draw([room for room in wanted.values() if room.id != thing.room], rng)
        if room is None:
            return None
        floor = goal if len(building.floors) > 1 else None
        place = Need(room=call_room(room, rng), floor=floor, role="destination")
        goal_kind = GoalKind.OBJECT_IN_ROOM
    else:
        surface = draw(
            [
                entry
                for entry in scene.objects
                if entry.receptacle
                and entry.mount == "floor"
                and entry.category.endswith(SURFACES)
                and goes_on(thing, entry)
                and (entry.room == thing.room or entry.room in wanted)
            ],
            rng,
        )
        if surface is None:
            return None
        place = call_place(surface, scene, building, rng)
        goal_kind = GoalKind.OBJECT_ON
    forms = wording.BRING if goal_kind is GoalKind.OBJECT_IN_ROOM else wording.PUT_ON
    return _drawn(sandbox, start, recipe.kind, forms, (target, place), (goal_kind,), rng)


def _search(sandbox: Sandbox, recipe: Recipe, rng: np.random.Generator) -> Task | None:
    spread = _spread(sandbox, recipe.span, rng)
    if spread is None:
        return None
    start, source, _ = spread
    scene = sandbox.building.scene(source)
    thing = draw(things(scene), rng)
    if thing is None:
        return None
    target = call_thing(thing, scene, sandbox.building, rng)
    goals = (GoalKind.SEEN, GoalKind.ROBOT_NEAR)
    return _drawn(sandbox, start, recipe.kind, wording.FIND, (target, None), goals, rng)


def _open_and_put(sandbox: Sandbox, recipe: Recipe, rng: np.random.Generator) -> Task | None:
    spread = _spread(sandbox, recipe.span, rng)
    if spread is None:
        return None
    start, source, goal = spread
    building, world = sandbox.building, sandbox.world
    brought = [entry for entry in things(building.scene(source)) if is_brought(entry)]
    scene = building.scene(goal)
    container = draw(
        [
            entry
            for entry in scene.objects
            if entry.openable
            and not entry.pickupable
            and entry.category not in _NOT_CONTAINERS
            and can_contain(world, entry)
            and any(goes_into(thing, entry) for thing in brought)
        ],
        rng,
    )
    if container is None:
        return None
    thing = draw([entry for entry in brought if goes_into(entry, container)], rng)
    if thing is None:
        return None
    target = call_thing(thing, building.scene(source), building, rng)
    place = call_place(container, scene, building, rng)
    closing = rng.random() < 0.4
    goals = (GoalKind.OBJECT_IN, GoalKind.CLOSED) if closing else (GoalKind.OBJECT_IN,)
    forms = wording.THEN_CLOSE if closing else wording.OPEN_AND_PUT
    return _drawn(sandbox, start, recipe.kind, forms, (target, place), goals, rng)


_DRAW: Final[dict[TaskKind, Callable[[Sandbox, Recipe, np.random.Generator], Task | None]]] = {
    TaskKind.DELIVER: _deliver,
    TaskKind.SEARCH: _search,
    TaskKind.OPEN_AND_PUT: _open_and_put,
}
