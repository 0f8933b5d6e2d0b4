"""Tasks made from a building: sampled with a seed, put into words, kept only when the oracle does them."""

import hashlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final, TypeVar

import msgspec
import numpy as np

from mansion_language import is_plural
from mansion_language.colours import colour_of
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import FloorScene, SceneObject, SceneRoom
from mansion_msgs_py.task import Goal, GoalKind, Need, Task, TaskKind, TaskStart
from mansion_msgs_py.world import Pose2D
from mansion_skills.skills.receptacles import can_contain
from mansion_skills.world.building import LoadedBuilding
from mansion_skills.world.world import World
from mansion_tasks.language.vocabulary import plain
from mansion_tasks.tasks.goals import done
from mansion_tasks.tasks.grounding import missing_needs, proven, with_ids
from mansion_tasks.tasks.needs import describe
from mansion_tasks.tasks.plausibility import is_requested, suits_container, suits_room, suits_surface
from mansion_tasks.tasks.sandbox import SESSION, Sandbox

__all__ = [
    "BRING",
    "COLLECT",
    "FIND",
    "OPEN_AND_PUT",
    "PUT_ON",
    "SURFACES",
    "THEN_CLOSE",
    "Recipe",
    "destination_need",
    "name_of_room",
    "target_need",
    "pick",
    "pick_start",
    "generate",
    "instruction",
    "recipes_for",
    "portable_objects",
]

BRING: Final = (
    "Find {item} and bring {it} to {place}.",
    "Go to where {item} is, take {it} to {place} and put {it} down there.",
    "Go and get {item}, then leave {it} in {place}.",
    "Fetch {item}. Please deliver {it} to {place}.",
    "Somebody needs {item}. Bring {it} to {place}.",
)
PUT_ON: Final = (
    "Find {item} and put {it} on {place}.",
    "Get {item}, then place {it} on {place}.",
    "Please fetch {item} and leave {it} on {place}.",
    "Take {item}. Carry {it} away and set {it} down on {place}.",
)
FIND: Final = (
    "Find {item} and go up to {it}.",
    "Look for {item} and stop beside {it}.",
    "Search for {item} and stop in front of {it}.",
    "Locate {item}; you are done when you see {it} and stand next to {it}.",
)
OPEN_AND_PUT: Final = (
    "Find {item}, open {place} and put {it} inside.",
    "Get {item}; open {place}, then put {it} in there.",
    "Take {item} and put {it} into {place}, which you have to open first.",
)
THEN_CLOSE: Final = (
    "Find {item}, open {place}, put {it} inside and close it again.",
    "Take {item} and put {it} into {place}; make sure that it is closed afterwards.",
    "Get {item}, put {it} inside {place}, then close that.",
)
COLLECT: Final = (
    "Collect {items} and bring them to {place}.",
    "Get {items}, and take them all to {place}.",
    "Gather {items}; leave them in {place}.",
    "Somebody needs {items}. Bring everything to {place}.",
)


def instruction(
    forms: tuple[str, ...], item: Need, place: Need | None, building: LoadedBuilding, rng: np.random.Generator
) -> str:
    """Return a random template of `forms` filled in with descriptions of the object and its destination."""
    form = forms[int(rng.integers(len(forms)))]
    there = "" if place is None else describe(place, building)
    pronoun = "them" if is_plural(plain(item.noun)) else "it"
    text = form.format(item=describe(item, building), place=there, it=pronoun)
    return text[:1].upper() + text[1:]


T = TypeVar("T")

SURFACES: Final = ("table", "desk", "bed", "sofa", "counter", "bench", "dresser", "sideboard", "nightstand", "island")
"""Furniture that people put objects on: endings of categories."""

_NEVER_ASKED_FOR: Final = ("book_upright", "toilet_brush", "toilet_paper", "fire_extinguisher", "plunger")
"""Categories that no instruction names."""


def pick(options: Sequence[T], rng: np.random.Generator) -> T | None:
    """Return one of `options`, each equally likely; ``None`` when there are none."""
    return options[int(rng.integers(len(options)))] if options else None


def portable_objects(scene: FloorScene) -> list[SceneObject]:
    """Return the objects of a floor that a robot can carry and an instruction can name."""
    portable = [item for item in scene.objects if item.pickupable and not item.openable]
    return [item for item in portable if item.category not in _NEVER_ASKED_FOR]


def _room_of(item: SceneObject, scene: FloorScene) -> SceneRoom:
    return next(room for room in scene.rooms if room.id == item.room)


def name_of_room(room: SceneRoom, rng: np.random.Generator) -> str:
    """Return a room's type, or with equal odds its own name where it has one."""
    named = room.name and plain(room.name) != plain(room.room_type)
    return plain(room.name if named and rng.random() < 0.5 else room.room_type)


def target_need(item: SceneObject, scene: FloorScene, building: LoadedBuilding, rng: np.random.Generator) -> Need:
    """Describe an object to fetch: by its floor and, at random, its colour, its room and what it is on."""
    parent = next((entry for entry in scene.objects if entry.id == item.parent), None)
    with_parent = parent is not None and rng.random() < 0.5
    with_room = rng.random() < 0.7
    relation = "room"
    if with_parent and item.mount in ("surface", "inside"):
        relation = "on" if item.mount == "surface" else "in"
    carrier = parent if relation != "room" else None
    return Need(
        noun=plain(item.category),
        color=colour_of(item.material) if rng.random() < 0.4 else "",
        relation="on" if relation == "on" else "in" if relation == "in" else "room",
        receptacle=plain(carrier.category) if carrier is not None else "",
        receptacle_color=colour_of(carrier.material) if carrier and rng.random() < 0.3 else "",
        room=name_of_room(_room_of(item, scene), rng) if with_room else "",
        floor=scene.floor if len(building.floors) > 1 else None,
        role="target",
    )


def destination_need(item: SceneObject, scene: FloorScene, building: LoadedBuilding, rng: np.random.Generator) -> Need:
    """Describe the furniture where an object is to go."""
    return Need(
        noun=plain(item.category),
        color=colour_of(item.material) if rng.random() < 0.3 else "",
        room=name_of_room(_room_of(item, scene), rng),
        floor=scene.floor if len(building.floors) > 1 else None,
        role="destination",
    )


def pick_start(world: World, floor: int, rng: np.random.Generator) -> TaskStart | None:
    """Return the landmark of a random room of a floor as a start, the robot facing one of four directions."""
    rooms = [mark for mark in world.view(floor).landmarks if mark.kind == "room"]
    mark = pick(rooms, rng)
    if mark is None:
        return None
    yaw = 90.0 * int(rng.integers(4))
    return TaskStart(floor=floor, pose=Pose2D(x=mark.pose.x, y=mark.pose.y, yaw=yaw))


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
    """Return the recipes for a building with this number of floors, in the order in which they take turns."""
    every = [
        Recipe(TaskKind.DELIVER, 1),
        Recipe(TaskKind.DELIVER, 2),
        Recipe(TaskKind.DELIVER, 4),
        Recipe(TaskKind.SEARCH, None),
        Recipe(TaskKind.OPEN_AND_PUT, None),
        Recipe(TaskKind.COLLECT, None),
        Recipe(TaskKind.DELIVER, 8),
    ]
    return [recipe for recipe in every if (recipe.span or 1) <= floors and kind in (None, recipe.kind)]


def generate(
    sandbox: Sandbox,
    count: int,
    seed: int = 0,
    kind: TaskKind | None = None,
    *,
    first: int = 0,
    unsolved: Callable[[Task], None] | None = None,
) -> list[Task]:
    """Make tasks for a building; the same building, count and seed give the same tasks.

    Parameters
    ----------
    sandbox : Sandbox
        The building's sandbox; it is reset.
    count : int
        Fewer come where the building has no more that differ.
    seed : int
    kind : TaskKind, optional
        Only tasks of this kind.
    first : int
        Which of the recipes has the first turn, counted round: so that few tasks for each of many buildings are of all
        recipes.
    unsolved : callable, optional
        Told of each draft that the oracle could not do.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` when the building has nothing for any task.
    """
    recipes = recipes_for(len(sandbox.building.floors), kind)
    recipes = recipes[first % len(recipes) :] + recipes[: first % len(recipes)]
    made: list[Task] = []
    instructions: set[str] = set()
    index = 0
    while len(made) < count and recipes:
        recipe = recipes[index % len(recipes)]
        task = _make(sandbox, recipe, seed, index, instructions, unsolved or _forget)
        if task is None:
            recipes.remove(recipe)
            continue
        instructions.add(task.instruction)
        made.append(task)
        index += 1
    if not made and count:
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"{sandbox.building.building_id} has nothing for a task" + (f" of kind {kind}" if kind else ""),
        )
    return made


def _forget(task: Task) -> None:
    """Ignore a draft that failed."""


def _make(
    sandbox: Sandbox, recipe: Recipe, seed: int, index: int, instructions: set[str], unsolved: Callable[[Task], None]
) -> Task | None:
    text = f"{sandbox.building.building_id} {recipe.name} {seed} {index}"
    digest = hashlib.sha256(text.encode()).digest()
    rng = np.random.default_rng(int.from_bytes(digest[:8], "little"))
    for _ in range(ATTEMPTS):
        draft = _DRAFTS[recipe.kind](sandbox, recipe, rng)
        if draft is None or draft.instruction in instructions:
            continue
        named = msgspec.structs.replace(draft, id=f"{recipe.name}_s{seed}_{index}", seed=seed)
        task = _checked(named, sandbox, recipe, unsolved)
        if task is not None:
            return task
    return None


def _checked(task: Task, sandbox: Sandbox, recipe: Recipe, unsolved: Callable[[Task], None]) -> Task | None:
    """Return a task with ids and proof; ``None`` when it is done at once, not by the skills, or over other floors."""
    if missing_needs(task, sandbox.world):
        return None
    task = with_ids(task, sandbox.world)
    if task.kind is TaskKind.COLLECT and not _targets_differ(task):
        return None
    sandbox.reset(task.start)
    if any(_holds_already(goal, task, sandbox) for goal in task.goals):
        return None
    try:
        task = proven(task, sandbox)
    except MansionError:
        unsolved(task)
        return None
    return task if recipe.span in (None, task.floors_spanned) else None


def _targets_differ(task: Task) -> bool:
    """Whether no object serves two of the goals."""
    named = [name for goal in task.goals for name in goal.objects]
    return len(named) == len(set(named))


def _holds_already(goal: Goal, task: Task, sandbox: Sandbox) -> bool:
    """Whether the goal that makes the task is met at its start; a container may well be closed."""
    if goal.kind is GoalKind.CLOSED:
        return len(goal.receptacles) != 1
    alone = msgspec.structs.replace(task, goals=[goal])
    return done(alone, sandbox.world, SESSION)


def _pick_floors(sandbox: Sandbox, span: int | None, rng: np.random.Generator) -> tuple[int, int, int] | None:
    """Return floors for start, object and destination that lie `span` floors apart."""
    floors = sandbox.building.floors
    size = span or int(rng.integers(1, len(floors) + 1))
    lows = [floor for floor in floors if floor + size - 1 in floors]
    low = pick(lows, rng)
    if low is None:
        return None
    high = low + size - 1
    inner = [floor for floor in floors if low <= floor <= high]
    ends = (low, high) if rng.random() < 0.5 else (high, low)
    other = inner[int(rng.integers(len(inner)))]
    return ((*ends, other), (ends[0], other, ends[1]), (other, *ends))[int(rng.integers(3))]


def _draft(
    sandbox: Sandbox,
    floor: int,
    kind: TaskKind,
    forms: tuple[str, ...],
    needs: tuple[Need, Need | None],
    goals: tuple[GoalKind, ...],
    rng: np.random.Generator,
) -> Task | None:
    start: TaskStart | None = pick_start(sandbox.world, floor, rng)
    if start is None:
        return None
    target, place = needs
    return Task(
        id="draft",
        kind=kind,
        instruction=instruction(forms, target, place, sandbox.building, rng),
        start=start,
        needs=[need for need in needs if need is not None],
        goals=[Goal(kind=goal) for goal in goals],
    )


def _deliver(sandbox: Sandbox, recipe: Recipe, rng: np.random.Generator) -> Task | None:
    floors_of_task = _pick_floors(sandbox, recipe.span, rng)
    if floors_of_task is None:
        return None
    start, source, goal = floors_of_task
    building = sandbox.building
    item = pick([entry for entry in portable_objects(building.scene(source)) if is_requested(entry)], rng)
    scene = building.scene(goal)
    if item is None:
        return None
    target = target_need(item, building.scene(source), building, rng)
    wanted = {
        room.id: room for room in scene.rooms if room.kind not in ("stair", "elevator") and suits_room(item, room)
    }
    if rng.random() < 0.5:
        room = pick([room for room in wanted.values() if room.id != item.room], rng)
        if room is None:
            return None
        floor = goal if len(building.floors) > 1 else None
        place = Need(room=name_of_room(room, rng), floor=floor, role="destination")
        goal_kind = GoalKind.OBJECT_IN_ROOM
    else:
        surface = pick(
            [
                entry
                for entry in scene.objects
                if entry.receptacle
                and entry.mount == "floor"
                and entry.category.endswith(SURFACES)
                and suits_surface(item, entry)
                and (entry.room == item.room or entry.room in wanted)
            ],
            rng,
        )
        if surface is None:
            return None
        place = destination_need(surface, scene, building, rng)
        goal_kind = GoalKind.OBJECT_ON
    forms = BRING if goal_kind is GoalKind.OBJECT_IN_ROOM else PUT_ON
    return _draft(sandbox, start, recipe.kind, forms, (target, place), (goal_kind,), rng)


def _search(sandbox: Sandbox, recipe: Recipe, rng: np.random.Generator) -> Task | None:
    floors_of_task = _pick_floors(sandbox, recipe.span, rng)
    if floors_of_task is None:
        return None
    start, source, _ = floors_of_task
    scene = sandbox.building.scene(source)
    item = pick(portable_objects(scene), rng)
    if item is None:
        return None
    target = target_need(item, scene, sandbox.building, rng)
    goals = (GoalKind.SEEN, GoalKind.ROBOT_NEAR)
    return _draft(sandbox, start, recipe.kind, FIND, (target, None), goals, rng)


def _open_and_put(sandbox: Sandbox, recipe: Recipe, rng: np.random.Generator) -> Task | None:
    floors_of_task = _pick_floors(sandbox, recipe.span, rng)
    if floors_of_task is None:
        return None
    start, source, goal = floors_of_task
    building, world = sandbox.building, sandbox.world
    brought = [entry for entry in portable_objects(building.scene(source)) if is_requested(entry)]
    scene = building.scene(goal)
    container = pick(
        [
            entry
            for entry in scene.objects
            if entry.openable
            and not entry.pickupable
            and entry.category not in _NOT_CONTAINERS
            and can_contain(world, entry)
            and any(suits_container(item, entry) for item in brought)
        ],
        rng,
    )
    if container is None:
        return None
    item = pick([entry for entry in brought if suits_container(entry, container)], rng)
    if item is None:
        return None
    target = target_need(item, building.scene(source), building, rng)
    place = destination_need(container, scene, building, rng)
    closing = rng.random() < 0.4
    goals = (GoalKind.OBJECT_IN, GoalKind.CLOSED) if closing else (GoalKind.OBJECT_IN,)
    forms = THEN_CLOSE if closing else OPEN_AND_PUT
    return _draft(sandbox, start, recipe.kind, forms, (target, place), goals, rng)


def _collect(sandbox: Sandbox, recipe: Recipe, rng: np.random.Generator) -> Task | None:
    """Two or three things of different kinds, from one floor or from several, to one room."""
    floors_of_task = _pick_floors(sandbox, recipe.span, rng)
    if floors_of_task is None:
        return None
    start, source, goal = floors_of_task
    building = sandbox.building
    room = pick([room for room in building.scene(goal).rooms if room.kind not in ("stair", "elevator")], rng)
    if room is None:
        return None
    sources = [source, start, source][: int(rng.integers(2, 4))]
    targets: list[Need] = []
    for floor in sources:
        scene = building.scene(floor)
        item = pick([entry for entry in portable_objects(scene) if _is_brought_to(entry, room)], rng)
        if item is not None:
            targets.append(target_need(item, scene, building, rng))
    if len({need.noun for need in targets}) != len(sources):
        return None
    place = Need(room=name_of_room(room, rng), floor=goal if len(building.floors) > 1 else None, role="destination")
    *most, last = (describe(need, building) for need in targets)
    form = COLLECT[int(rng.integers(len(COLLECT)))]
    text = form.format(items=f"{', '.join(most)} and {last}", place=describe(place, building))
    begin = pick_start(sandbox.world, start, rng)
    if begin is None:
        return None
    return Task(
        id="draft", kind=recipe.kind, instruction=text[:1].upper() + text[1:], start=begin, needs=[*targets, place]
    )


def _is_brought_to(item: SceneObject, room: SceneRoom) -> bool:
    return item.room != room.id and is_requested(item) and suits_room(item, room)


_DRAFTS: Final[dict[TaskKind, Callable[[Sandbox, Recipe, np.random.Generator], Task | None]]] = {
    TaskKind.DELIVER: _deliver,
    TaskKind.SEARCH: _search,
    TaskKind.OPEN_AND_PUT: _open_and_put,
    TaskKind.COLLECT: _collect,
}
