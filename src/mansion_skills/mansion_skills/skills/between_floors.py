"""CallElevator, UseElevator and TakeStairs, as in their skill cards (section F.1)."""

from collections.abc import Generator
from typing import Annotated, Any

from mansion_msgs_py.scene import SceneCore
from mansion_msgs_py.skills import SessionArgs
from mansion_msgs_py.world import LiftCall, SkillChange, SkillResult, SkillStatus
from mansion_skills.skills.declaration import Action, Argument, Card, skill
from mansion_skills.skills.results import Run, Step, done, invalid, refused, unmet, with_changes
from mansion_skills.world.lift import Lift
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = [
    "NEAR_ENTRANCE",
    "STAIR_SPEED",
    "TakeStairsArgs",
    "UseElevatorArgs",
    "call_elevator",
    "take_stairs",
    "use_elevator",
]

NEAR_ENTRANCE = 1.0
"""How near to a core's entrance pose the robot must stand, metres."""

DIRECTIONS = {"Up": 1, "Down": -1}
"""Directions, in any case, and how they change the floor."""

STAIR_SPEED = 0.25
"""Vertical speed on stairs, metres a second."""

PATIENCE = 120.0
"""How long a robot waits for a lift that another session holds, in real time, seconds."""


class UseElevatorArgs(SessionArgs, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Skill card UseElevator: a floor number, or a label where it is unambiguous."""

    target_floor: Annotated[Any, Argument("floor", "floor to ride to, by number or unambiguous label")]


class TakeStairsArgs(SessionArgs, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Skill card TakeStairs: ``Up`` or ``Down``."""

    direction: Annotated[Any, Argument("text", "`Up` or `Down`")]


@skill(
    "CallElevator",
    "Bring the lift to the robot's floor and open its doors.",
    failures=(SkillStatus.INVALID_ACTION, SkillStatus.PRECONDITION_FAILURE, SkillStatus.EXECUTION_FAILURE),
    card=Card("call the lift; the robot must stand at its entrance (GoToLandmark elevator)"),
    actions=(Action(),),
)
def call_elevator(world: World, robot: RobotBody, arguments: SessionArgs, *, realtime: bool) -> Run:
    """Bring the lift beside the robot to its floor and open its doors."""
    name = "CallElevator"
    core = world.core_near(robot, "elevator", NEAR_ENTRANCE)
    if core is None:
        return _not_at(world, robot, name, "elevator")
    lift = world.lifts[core.id]
    before = lift.floor
    _let_go_of_others(world, robot, core.id)
    rank = lift.call(LiftCall(session=robot.session, floor=robot.floor))
    waited = 0.0
    while rank > 0 and realtime and waited < PATIENCE:
        yield Step(1.0, 0.0, f"waiting for {core.id}, number {rank} in the queue")
        waited += 1.0
        _drop_idle_holder(world, lift)
        rank = lift.place_of(robot.session)
    if rank > 0:
        text = f"{core.id} is held by session {lift.session!r}; the call is number {rank} in its queue"
        wish = "CallElevator again when that session has ended"
        queued = SkillChange(what=f"{core.id}.queue", after=rank)
        return with_changes(unmet(world, robot, name, text, wish), queued)
    robot.call = core.id
    yield from _until_open(lift, robot.floor, f"{core.id} comes", realtime=realtime)
    if not lift.is_open_at(robot.floor):
        return _taken_away(world, robot, name, core.id)
    return done(
        world,
        robot,
        name,
        f"{core.id} is on floor {robot.floor} with its doors open",
        SkillChange(what=f"{core.id}.floor", before=before, after=robot.floor),
        elevator=core.id,
        floors=sorted(lift.elevations),
        labels=[lift.labels[floor] for floor in sorted(lift.elevations)],
    )


def _let_go_of_others(world: World, robot: RobotBody, wanted: str) -> None:
    """End the robot's hold on other lifts, and the hold on this one of a robot that has walked away."""
    for name in sorted(world.lifts):
        if name != wanted:
            world.lifts[name].release(robot.session)
    _drop_idle_holder(world, world.lifts[wanted])


def _drop_idle_holder(world: World, lift: Lift) -> None:
    holder = world.robots.get(lift.session)
    if holder is None:
        if lift.session in world.absent:
            lift.release(lift.session)
        return
    core = world.core_near(holder, "elevator", NEAR_ENTRANCE)
    if core is None or core.id != lift.name:
        lift.release(holder.session)
        holder.call = None


def _until_open(lift: Lift, floor: int, message: str, *, realtime: bool) -> Generator[Step, None, None]:
    """Let time pass until the lift stands open at a floor, or rests elsewhere because its session was ended."""
    total = max(lift.seconds_to_rest(), 1e-9)
    while not lift.is_open_at(floor):
        left = lift.seconds_to_rest()
        if left <= 0.0:
            return
        step = min(left, 0.5) if realtime else left
        yield Step(max(step, 1e-3), 1.0 - left / total, message)


@skill(
    "UseElevator",
    "Ride the called lift to another floor.",
    arguments=UseElevatorArgs,
    example='{"target_floor": 3}',
    failures=(SkillStatus.INVALID_ACTION, SkillStatus.PRECONDITION_FAILURE, SkillStatus.EXECUTION_FAILURE),
    card=Card("ride the called lift to a floor", ("target_floor",)),
    actions=(Action(indexed="target_floor"),),
)
def use_elevator(world: World, robot: RobotBody, arguments: UseElevatorArgs, *, realtime: bool) -> Run:
    """Ride the called lift to another floor; what the robot holds goes with it."""
    name = "UseElevator"
    target = world.building.floor_number(arguments.target_floor)
    if target is None:
        known = ", ".join(map(str, world.building.floors))
        text = f"there is no floor {str(arguments.target_floor)[:80]!r}; floors: {known}"
        return invalid(world, robot, name, text, f"one of {world.building.floors}")
    if target == robot.floor:
        text = f"the robot is on floor {target} already"
        return invalid(world, robot, name, text, "another target_floor")
    core = world.core_near(robot, "elevator", NEAR_ENTRANCE)
    if core is None:
        return _not_at(world, robot, name, "elevator")
    lift = world.lifts[core.id]
    if target not in lift.elevations:
        text = f"{core.id} serves floors {sorted(lift.elevations)}, not {target}"
        return invalid(world, robot, name, text, "a floor that it serves")
    called = robot.call == core.id and lift.session == robot.session
    if not called or not lift.is_open_at(robot.floor):
        text = f"{core.id} has not been called to floor {robot.floor}"
        return unmet(world, robot, name, text, "CallElevator first")
    before = robot.floor
    lift.call(LiftCall(session=robot.session, floor=target))
    yield from _until_open(lift, target, f"riding to floor {target}", realtime=realtime)
    if not lift.is_open_at(target):
        return _taken_away(world, robot, name, core.id)
    world.update_floor(robot, target - before, core.id)
    robot.call = None
    lift.release(robot.session)
    return done(
        world, robot, name, f"arrived on floor {target}", SkillChange(what="floor", before=before, after=target)
    )


@skill(
    "TakeStairs",
    "Walk one floor up or down.",
    arguments=TakeStairsArgs,
    example='{"direction": "Up"}',
    failures=(SkillStatus.INVALID_ACTION, SkillStatus.PRECONDITION_FAILURE),
    card=Card(
        "walk one floor `Up` or `Down`; the robot must stand at the stairs (GoToLandmark stairs)", ("direction",)
    ),
    actions=(Action(fixed={"direction": "Up"}), Action(fixed={"direction": "Down"})),
)
def take_stairs(world: World, robot: RobotBody, arguments: TakeStairsArgs, *, realtime: bool) -> Run:
    """Walk one floor up or down."""
    name = "TakeStairs"
    wanted = arguments.direction
    step = DIRECTIONS.get(wanted.strip().capitalize()) if isinstance(wanted, str) else None
    if step is None:
        text = f"there is no direction {wanted!r}"
        return invalid(world, robot, name, text, "direction Up or Down")
    core = world.core_near(robot, "stair", NEAR_ENTRANCE)
    if core is None:
        return _not_at(world, robot, name, "stairs")
    before = robot.floor
    if before + step not in core.floors:
        text = f"{core.id} does not lead {str(wanted).lower()} from floor {before}"
        status = SkillStatus.PRECONDITION_FAILURE
        return refused(world, robot, name, status, text, _other_way(before, core))
    entry = world.building.entry
    rise = abs(entry(before + step).elevation - entry(before).elevation)
    yield Step(rise / STAIR_SPEED, 0.0, f"on {core.id}")
    world.update_floor(robot, step, core.id)
    return done(
        world,
        robot,
        name,
        f"arrived on floor {robot.floor}",
        SkillChange(what="floor", before=before, after=robot.floor),
    )


def _taken_away(world: World, robot: RobotBody, name: str, lift: str) -> SkillResult:
    robot.call = None
    text = f"the session that held {lift} was ended by a lift request"
    return refused(world, robot, name, SkillStatus.EXECUTION_FAILURE, text, "CallElevator again")


def _other_way(floor: int, core: SceneCore) -> str:
    open_ways = [way for way, step in DIRECTIONS.items() if floor + step in core.floors]
    return f"direction {' or '.join(open_ways)}" if open_ways else "another stair"


def _not_at(world: World, robot: RobotBody, name: str, what: str) -> SkillResult:
    kind = "elevator" if what == "elevator" else "stair"
    if not world.cores(kind):
        return _no_such_core(world, robot, name, kind)
    text = f"the robot is not within {NEAR_ENTRANCE:g} m of the entrance of {what}"
    here = any(core.type == kind for core in world.view(robot.floor).scene.cores)
    wish = f"GoToLandmark {what}" if here else f"a floor that has {what}"
    return unmet(world, robot, name, text, wish)


def _no_such_core(world: World, robot: RobotBody, name: str, kind: str) -> SkillResult:
    """Answer for a building that has no lift, or no stairs, at all: it can never be done, and what can instead."""
    other, skill = ("stair", "TakeStairs") if kind == "elevator" else ("elevator", "CallElevator")
    what = "elevator" if kind == "elevator" else "stairs"
    text = f"this building has no {what}"
    if world.cores(other):
        return invalid(world, robot, name, f"{text}; use {skill}", f"{skill}, at GoToLandmark {other}")
    return invalid(world, robot, name, f"{text} and one floor only", "staying on this floor")
