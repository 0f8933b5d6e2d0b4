"""WhereAmI, ListLandmarks, ListVisible and PlanRoute: queries, which change nothing."""

from math import dist
from typing import Annotated, Any

from msgspec.structs import replace

from mansion_msgs_py.shapes import Point
from mansion_msgs_py.skills import (
    LandmarkInfo,
    Landmarks,
    Route,
    RouteLeg,
    SessionArgs,
    VisibleObject,
    VisibleObjects,
    WhereAmI,
)
from mansion_msgs_py.wording import choices
from mansion_msgs_py.world import SkillResult, SkillStatus
from mansion_skills.navigation.paths import path_length
from mansion_skills.navigation.routes import Leg, Ride, RouteGraph
from mansion_skills.skills.between_floors import STAIR_SPEED
from mansion_skills.skills.declaration import Argument, skill
from mansion_skills.skills.driving import SPEED, path_to
from mansion_skills.skills.references import object_named
from mansion_skills.skills.results import invalid, number, refused
from mansion_skills.skills.visibility import REACH, VIEW_RANGE, is_visible, reach_to
from mansion_skills.world.floor_view import landmark_named
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = ["RouteArgs", "VisibleArgs", "landmark_infos", "list_landmarks", "list_visible", "plan_route", "where_am_i"]


class VisibleArgs(SessionArgs, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """How far to look, metres."""

    distance: Annotated[Any, Argument("number", "how far to look, metres")] = None


class RouteArgs(SessionArgs, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Where a route leads: a room or core of any floor (``F3/office_1``), or an object, by its id."""

    target: Annotated[Any, Argument("text", "room or core of any floor, or an object, by its id")]


@skill("WhereAmI", "Floor, room, pose and held object.", reply=WhereAmI)
def where_am_i(world: World, robot: RobotBody, arguments: SessionArgs) -> WhereAmI:
    """Say where the robot is and what it holds."""
    state = world.robot_state(robot)
    return WhereAmI(
        floor=state.floor, label=state.label, room=state.room, pose=state.pose, held=state.held, session=robot.session
    )


def landmark_infos(world: World, floor: int) -> list[LandmarkInfo]:
    """Return a floor's landmarks as payloads."""
    return [
        LandmarkInfo(name=entry.name, kind=entry.kind, floor=entry.floor, pose=entry.pose)
        for entry in world.view(floor).landmarks
    ]


@skill("ListLandmarks", "Rooms and cores of this floor.", reply=Landmarks, example="{}")
def list_landmarks(world: World, robot: RobotBody, arguments: SessionArgs) -> Landmarks:
    """List the rooms and cores of the robot's floor."""
    return Landmarks(
        floor=robot.floor,
        label=world.building.label(robot.floor),
        landmarks=landmark_infos(world, robot.floor),
        session=robot.session,
    )


@skill(
    "ListVisible",
    "What the robot sees from where it stands.",
    arguments=VisibleArgs,
    reply=VisibleObjects,
    example='{"distance": 3.0}',
    failures=(SkillStatus.INVALID_ACTION,),
)
def list_visible(world: World, robot: RobotBody, arguments: VisibleArgs) -> VisibleObjects | SkillResult:
    """List the objects that the camera sees, the nearest first."""
    distance = VIEW_RANGE if arguments.distance is None else number(arguments.distance, 1000.0)
    if distance is None or distance < 0:
        text = f"distance {arguments.distance!r} is not a number of metres"
        return invalid(world, robot, "ListVisible", text, "0 to 1000")
    found = []
    x, y = robot.place
    for state in world.objects.on_floor(robot.floor):
        kind = world.objects.kinds[state.id]
        assert state.position is not None
        far = distance + kind.size[0] + kind.size[1]
        if abs(state.position[0] - x) > far or abs(state.position[1] - y) > far:
            continue
        if not is_visible(world, robot, state, distance):
            continue
        away = reach_to(robot, state, kind)
        found.append(
            VisibleObject(
                id=state.id,
                category=kind.category,
                distance=round(away, 3),
                bearing=round(robot.bearing((state.position[0], state.position[1])), 1),
                room=state.room,
                parent=state.parent,
                within_reach=away <= REACH,
                pickupable=kind.pickupable,
                receptacle=kind.receptacle,
                openable=kind.openable,
                toggleable=kind.toggleable,
                states=state.states,
            )
        )
    found.sort(key=lambda entry: (entry.distance, entry.id))
    return VisibleObjects(floor=robot.floor, pose=robot.pose, objects=found, session=robot.session)


@skill(
    "PlanRoute",
    "The way to a room, core or object of any floor, leg by leg.",
    arguments=RouteArgs,
    reply=Route,
    example='{"target": "F3/office_1"}',
    failures=(SkillStatus.INVALID_ACTION, SkillStatus.PLANNING_FAILURE),
)
def plan_route(world: World, robot: RobotBody, arguments: RouteArgs) -> Route | SkillResult:
    """Plan the way to a room, a core or an object of any floor; lifts and stairs count with their time."""
    name = "PlanRoute"
    goal = _goal(world, robot, arguments.target)
    if isinstance(goal, str):
        return invalid(world, robot, name, goal, "a landmark's name (F3/office_1) or an object's id")
    room = world.view(robot.floor).map.room_at(*robot.place) or ""
    graph = route_graph(world)
    legs = graph.route((robot.floor, room, robot.place), goal, world.doors)
    if legs is None:
        text = f"there is no route to {arguments.target}"
        status = SkillStatus.PLANNING_FAILURE
        return refused(world, robot, name, status, text, "another target")
    return _route(world, robot, legs, str(arguments.target))


def route_graph(world: World) -> RouteGraph:
    """Return the building's graph, made when it is first needed."""
    if world.routes is None:
        rides = [
            Ride(lift.name, "elevator", a, b, lift.seconds_for(a, b))
            for lift in world.lifts.values()
            for a in lift.elevations
            for b in lift.elevations
            if a != b
        ]
        entry = world.building.entry
        for floor in world.building.floors:
            for core in world.building.scene(floor).cores:
                for other in (floor - 1, floor + 1):
                    if core.type == "stair" and floor in core.floors and other in core.floors:
                        rise = abs(entry(other).elevation - entry(floor).elevation)
                        rides.append(Ride(core.id, "stair", floor, other, rise / STAIR_SPEED))
        scenes = [world.building.scene(floor) for floor in world.building.floors]
        world.routes = RouteGraph(scenes, rides, SPEED)
    return world.routes


def _goal(world: World, robot: RobotBody, target: object) -> tuple[int, str, Point] | str:
    if not isinstance(target, str):
        return f"{target!r} is not a name"
    here = landmark_named(target, world.view(robot.floor).landmarks, robot.floor, robot.place)
    floors = [robot.floor] if here else world.building.floors
    for floor in floors:
        for room in world.building.scene(floor).rooms:
            called = {name.casefold() for name in (room.id, room.name, *room.aliases) if name}
            if room.id == here.name if here is not None else target.strip().casefold() in called:
                mark = landmark_named(room.id, world.view(floor).landmarks, floor, (0.0, 0.0))
                if mark is not None:
                    return floor, room.id, (mark.pose.x, mark.pose.y)
    if here is not None:
        place = (here.pose.x, here.pose.y)
        return robot.floor, world.view(robot.floor).map.room_at(*place) or "", place
    state = object_named(world, robot, target)
    if isinstance(state, str) or state.floor is None or state.position is None:
        rooms = (room.id for f in world.building.floors for room in world.building.scene(f).rooms)
        near = choices(target, (*rooms, *world.objects), "rooms and objects")
        return f"there is no landmark or object {target[:80]!r} to go to; {near}"
    return state.floor, state.room or "", (state.position[0], state.position[1])


def _route(world: World, robot: RobotBody, legs: list[Leg], target: str) -> Route:
    """Join walks of one floor, measure those of the robot's own floor exactly, and name the skills."""
    joined: list[RouteLeg] = []
    place = robot.place
    for leg in legs:
        meters = dist(place, leg.end) if leg.kind == "walk" else 0.0
        place = leg.end
        last = joined[-1] if joined else None
        if last is not None and last.kind == leg.kind == "walk" and last.floor == leg.floor:
            joined[-1] = replace(
                last,
                seconds=last.seconds + leg.seconds,
                meters=last.meters + meters,
                points=[*last.points, leg.end],
                via=leg.via or target,
            )
            continue
        joined.append(
            RouteLeg(
                kind=leg.kind,
                floor=leg.floor,
                to_floor=leg.to_floor,
                via=leg.via or target,
                seconds=leg.seconds,
                meters=meters,
                points=[leg.end],
            )
        )
    first = joined[0]
    if first.kind == "walk" and (path := path_to(world, robot, first.points[-1], REACH)) is not None:
        meters = path_length(path)
        joined[0] = replace(first, points=path, meters=meters, seconds=meters / SPEED)
    return Route(
        legs=joined,
        seconds=round(sum(leg.seconds for leg in joined), 3),
        meters=round(sum(leg.meters for leg in joined), 3),
        skills=_skills(joined, target, is_object=target in world.objects),
        session=robot.session,
    )


def _skills(legs: list[RouteLeg], target: str, *, is_object: bool) -> list[str]:
    skills: list[str] = []
    for number_, leg in enumerate(legs):
        if leg.kind == "walk":
            last = number_ == len(legs) - 1
            go = "GoNearObject" if is_object and last else "GoToLandmark"
            skills.append(f"{go} {target if last else leg.via}")
        elif leg.kind == "elevator":
            skills += ["CallElevator", f"UseElevator {leg.to_floor}"]
        else:
            skills.append(f"TakeStairs {'Up' if leg.to_floor > leg.floor else 'Down'}")
    return skills
