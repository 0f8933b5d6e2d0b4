"""CallElevator, UseElevator and TakeStairs, as in their skill cards (section F.1)."""

from mansion_msgs_py.scene import SceneCore
from mansion_msgs_py.skills import SessionArgs, TakeStairsArgs, UseElevatorArgs
from mansion_msgs_py.world import SkillChange, SkillResult, SkillStatus
from mansion_skills.skills.outcome import done, refused
from mansion_skills.world.world import World

__all__ = ["NEAR_ENTRANCE", "call_elevator", "take_stairs", "use_elevator"]

NEAR_ENTRANCE = 1.0
"""How near to a core's entrance pose the robot must stand, metres."""

DIRECTIONS = {"Up": 1, "Down": -1}

STAIR_SPEED = 0.25
"""Metres of height a second on stairs."""


def call_elevator(world: World, arguments: SessionArgs) -> SkillResult:
    """Bring the lift beside the robot to its floor and open its doors."""
    name = "CallElevator"
    core = world.core_near("elevator", NEAR_ENTRANCE)
    if core is None:
        return _not_at(world, name, "elevator")
    lift = world.lifts[core.id]
    before = lift.floor
    world.time += lift.travel(world.floor, world.session)
    world.calls[core.id] = world.floor
    return done(
        world,
        name,
        f"{core.id} is on floor {world.floor} with its doors open",
        SkillChange(what=f"{core.id}.floor", before=before, after=world.floor),
        elevator=core.id,
        floors=sorted(lift.elevations),
        labels=[lift.labels[floor] for floor in sorted(lift.elevations)],
    )


def use_elevator(world: World, arguments: UseElevatorArgs) -> SkillResult:
    """Ride the called lift to another floor; what the robot holds goes with it."""
    name = "UseElevator"
    target = world.building.floor_number(arguments.target_floor)
    if target is None:
        return _no_floor(world, name, arguments.target_floor)
    if target == world.floor:
        text = f"the robot is on floor {target} already"
        return refused(world, name, SkillStatus.INVALID_ACTION, text, "another target_floor")
    core = world.core_near("elevator", NEAR_ENTRANCE)
    if core is None:
        return _not_at(world, name, "elevator")
    lift = world.lifts[core.id]
    if target not in lift.elevations:
        text = f"{core.id} serves floors {sorted(lift.elevations)}, not {target}"
        return refused(world, name, SkillStatus.INVALID_ACTION, text, "a floor that it serves")
    if world.calls.get(core.id) != world.floor or not lift.is_open_at(world.floor):
        text = f"{core.id} has not been called to floor {world.floor}"
        return refused(world, name, SkillStatus.PRECONDITION_FAILURE, text, "CallElevator first")
    before = world.floor
    world.time += lift.travel(target, world.session)
    world.update_floor(target - before, core.id)
    del world.calls[core.id]
    lift.release()
    return done(
        world,
        name,
        f"arrived on floor {target}",
        SkillChange(what="floor", before=before, after=target),
    )


def take_stairs(world: World, arguments: TakeStairsArgs) -> SkillResult:
    """Walk one floor up or down."""
    name = "TakeStairs"
    step = DIRECTIONS.get(arguments.direction)
    if step is None:
        text = f"there is no direction {arguments.direction!r}"
        return refused(world, name, SkillStatus.INVALID_ACTION, text, "direction Up or Down")
    core = world.core_near("stair", NEAR_ENTRANCE)
    if core is None:
        return _not_at(world, name, "stairs")
    if world.floor + step not in core.floors:
        text = f"{core.id} does not lead {arguments.direction.lower()} from floor {world.floor}"
        return refused(world, name, SkillStatus.PRECONDITION_FAILURE, text, _other_way(world, core))
    before = world.floor
    rise = world.building.entry(before + step).elevation - world.building.entry(before).elevation
    world.update_floor(step, core.id)
    world.time += abs(rise) / STAIR_SPEED
    after = world.floor
    return done(
        world,
        name,
        f"arrived on floor {after}",
        SkillChange(what="floor", before=before, after=after),
    )


def _other_way(world: World, core: SceneCore) -> str:
    open_ways = [way for way, step in DIRECTIONS.items() if world.floor + step in core.floors]
    return f"direction {' or '.join(open_ways)}" if open_ways else "another stair"


def _not_at(world: World, name: str, what: str) -> SkillResult:
    text = f"the robot is not within {NEAR_ENTRANCE:g} m of the entrance of {what}"
    wish = f"GoToLandmark {what}" if _has(world, what) else f"a floor that has {what}"
    return refused(world, name, SkillStatus.PRECONDITION_FAILURE, text, wish)


def _has(world: World, what: str) -> bool:
    kind = "elevator" if what == "elevator" else "stair"
    return any(core.type == kind for core in world.scene.cores)


def _no_floor(world: World, name: str, value: int | str) -> SkillResult:
    text = f"there is no floor {value!r}"
    wish = f"one of {world.building.floors}"
    return refused(world, name, SkillStatus.INVALID_ACTION, text, wish)
