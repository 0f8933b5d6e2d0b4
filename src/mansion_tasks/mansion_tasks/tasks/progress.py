"""The progress of a task: scores of retrieval and of navigation (supplement, F.2)."""

from collections.abc import Iterator, Mapping

from mansion_msgs_py.task import Goal, GoalKind, ProgressScore, Task
from mansion_skills.skills.visibility import REACH, is_visible, reach_to
from mansion_skills.world.world import World
from mansion_tasks.tasks.goals import done

__all__ = ["ProgressTracker"]

FOUND = 0.5
"""Score of retrieval for standing before the right object; the rest is for having it."""


class ProgressTracker:
    """Follows one robot through a task; `observe` is called before the first skill and after each.

    Retrieval is 0.5 once a right object is in view and within the hand's reach, and 1 once it has been in the hand
    (where nothing is to be carried: once the robot stands before it). Navigation is the part of the way's milestones
    that were reached, in order: the floor and the room where a right object lies, then the floor and the room where it
    is to go. Milestones that the start fulfils do not count. Both never fall, and success makes both 1.

    Parameters
    ----------
    task : Task
        With goals.
    world : World
        In its initial state: where the objects lie now is where they are to be fetched from.
    session : str
        Session of the robot.

    Attributes
    ----------
    seen : set of str
        Ids of the task's objects that were in view.
    targets : list of str
        Ids of the objects that its goals name.
    score : ProgressScore
        At the last observation.
    """

    def __init__(self, task: Task, world: World, session: str) -> None:
        self.task = task
        self.seen: set[str] = set()
        self.score = ProgressScore()
        self._world = world
        self._session = session
        self.targets = sorted({name for goal in task.goals for name in goal.objects})
        self._carried = any(goal.kind in _CARRYING for goal in task.goals)
        self._milestones = list(_milestones(task, world, self.targets))
        self._passed = 0
        self._advance()
        self._given = self._passed

    def observe(self, view: Mapping[str, float] | None = None) -> ProgressScore:
        """Look at the world and return the score now.

        Parameters
        ----------
        view : mapping of str to float, optional
            The objects in view with their distances, where the caller has looked already.
        """
        world, robot = self._world, self._world.robots[self._session]
        retrieval = self.score.retrieval
        for name in self.targets:
            if name not in world.objects:
                continue
            state = world.objects.state(name)
            if state.held_by == self._session:
                self.seen.add(name)
                retrieval = 1.0
                continue
            if view is not None:
                away = view.get(name)
            elif is_visible(world, robot, state):
                away = reach_to(robot, state, world.objects.kinds[name])
            else:
                away = None
            if away is not None:
                self.seen.add(name)
                if away <= REACH:
                    retrieval = max(retrieval, FOUND if self._carried else 1.0)
        self._advance()
        success = done(self.task, world, self._session, self.seen)
        self.score = ProgressScore(
            retrieval=1.0 if success else retrieval,
            navigation=1.0 if success or self.score.navigation == 1.0 else self._navigation(),
            success=success,
        )
        return self.score

    def _navigation(self) -> float:
        count = len(self._milestones) - self._given
        return (self._passed - self._given) / count if count else 0.0

    def _advance(self) -> None:
        robot = self._world.robots[self._session]
        room = self._world.view(robot.floor).map.room_at(*robot.place)
        while self._passed < len(self._milestones):
            floors, rooms = self._milestones[self._passed]
            if robot.floor not in floors or (rooms and room not in rooms):
                return
            self._passed += 1


_CARRYING = (GoalKind.HOLDING, GoalKind.OBJECT_IN, GoalKind.OBJECT_IN_ROOM, GoalKind.OBJECT_NEAR, GoalKind.OBJECT_ON)


def _milestones(task: Task, world: World, targets: list[str]) -> Iterator[tuple[set[int], set[str]]]:
    """Yield floors and rooms (none: anywhere on the floor) in the order in which they are to be reached."""
    homes = [world.objects.state(name) for name in targets if name in world.objects]
    rooms = {state.room for state in homes if state.room is not None}
    floors = {state.floor for state in homes if state.floor is not None}
    if rooms:
        yield floors, set()
        yield floors, rooms
    for goal in task.goals:
        wanted = _destination(goal, world)
        if not wanted or wanted == rooms:
            continue
        before, rooms = floors, wanted
        floors = {
            floor for floor in world.building.floors for room in world.building.scene(floor).rooms if room.id in rooms
        }
        if floors != before:
            yield floors, set()
        yield floors, rooms


def _destination(goal: Goal, world: World) -> set[str]:
    rooms = set(goal.rooms)
    for name in goal.receptacles:
        if name in world.objects and (room := world.objects.state(name).room) is not None:
            rooms.add(room)
    return rooms
