"""Make an agent's observation from the robot's answers, and keep back what the agent must not know."""

from dataclasses import dataclass

from mansion_msgs_py.skills import Landmarks, VisibleObject, VisibleObjects
from mansion_msgs_py.task import SkillCall, Task
from mansion_msgs_py.world import SkillResult
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World
from mansion_tasks.agents.interface import Access, Eyes, MapEntry, Observation, SeenObject
from mansion_tasks.episodes.masking import HELD, Mask
from mansion_tasks.episodes.port import SkillPort
from mansion_tasks.tasks.words import colour_of

__all__ = ["Moment", "Watcher", "object_map"]


@dataclass(frozen=True)
class Moment:
    """All there is to know before a step, of which the agent gets its part."""

    world: World
    robot: RobotBody
    visible: VisibleObjects
    landmarks: Landmarks
    mask: Mask


class Watcher:
    """Asks the robot and tells the agent.

    Parameters
    ----------
    port : SkillPort
    task : Task
    access : Access
        Of the agent.
    """

    def __init__(self, port: SkillPort, task: Task, access: Access) -> None:
        self._port, self._task, self._access = port, task, access

    def moment(self) -> Moment:
        """Return the present."""
        visible, landmarks = self._port.visible(), self._port.landmarks()
        world, robot = self._port.world()
        held = world.objects.held_by(robot.session)
        mask = Mask(visible.objects, landmarks.landmarks, held)
        return Moment(world, robot, visible, landmarks, mask)

    def observation(
        self, moment: Moment, step: int, last_call: SkillCall | None, last: SkillResult | None, eyes: Eyes | None
    ) -> Observation:
        """Return what the agent perceives; its last call is told in its own words."""
        world, robot, mask, access = moment.world, moment.robot, moment.mask, self._access
        state = world.robot_state(robot)
        seen = [seen_object(world, thing) for thing in moment.visible.objects]
        held = state.held or ""
        landmarks = moment.landmarks.landmarks
        if not access.names:
            seen = [mask.seen(thing, category=access.categories) for thing in seen]
            landmarks = [mask.landmark(entry) for entry in landmarks]
            last = None if last is None else mask.result(last)
        return Observation(
            instruction=self._task.instruction,
            step=step,
            max_steps=self._task.max_steps,
            floor=state.floor,
            floors=tuple(world.building.floors),
            pose=state.pose,
            pitch=state.pitch,
            room=(state.room or "") if access.names else mask.place(state.room),
            held=held if access.names or not held else HELD,
            landmarks=tuple(landmarks),
            visible=tuple(seen),
            last_call=last_call,
            last=last,
            eyes=eyes,
            object_map=(lambda: object_map(world)) if access.object_map else list,
        )

    def call(self, moment: Moment, call: SkillCall) -> SkillCall | str:
        """Return the agent's call with the ids of this moment, or what is wrong with it."""
        return call if self._access.names else moment.mask.call(call)


def seen_object(world: World, thing: VisibleObject) -> SeenObject:
    """Return an object in view with the colour that a camera sees."""
    is_open = thing.states.get("open")
    return SeenObject(
        ref=thing.id,
        category=thing.category,
        distance=thing.distance,
        bearing=thing.bearing,
        color=colour_of(world.objects.kinds[thing.id]),
        room=thing.room or "",
        parent=thing.parent or "",
        within_reach=thing.within_reach,
        pickupable=thing.pickupable,
        receptacle=thing.receptacle,
        openable=thing.openable,
        is_open=is_open if isinstance(is_open, bool) else None,
    )


def object_map(world: World) -> list[MapEntry]:
    """Return where every object of the building is now, in the order of the scenes."""
    found = []
    for name in world.objects:
        state, kind = world.objects.state(name), world.objects.kinds[name]
        found.append(MapEntry(name, kind.category, colour_of(kind), state.floor, state.room or "", state.parent or ""))
    return found
