"""The world of a loaded building: its objects, doors and lifts, and the robots in it."""

from collections import deque
from collections.abc import Iterable
from math import dist

import numpy as np
import numpy.typing as npt

from mansion_geometry.robot_body import ROBOT_RADIUS
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneCore
from mansion_msgs_py.shapes import Point
from mansion_msgs_py.world import LiftState, Pose2D, RobotState, WorldState
from mansion_skills.navigation.grid_kernels import NO_CELL, nearest_free
from mansion_skills.navigation.routes import RouteGraph
from mansion_skills.world.building import LoadedBuilding
from mansion_skills.world.floor_view import FloorView
from mansion_skills.world.lift import Lift
from mansion_skills.world.objects import ObjectTable
from mansion_skills.world.robot_body import RobotBody

__all__ = ["World"]

MOST_LIFT_CHANGES = 256
"""Most changes of lifts that wait to be published; a script that publishes nothing keeps no more."""

GIVING_WAY = 1.5
"""Greatest distance from an occupied standard pose to the free one that is taken instead, metres."""


class World:
    """All that skills read and change.

    Parameters
    ----------
    building : LoadedBuilding
    name : str
        Name of the world; sessions that name it share it.
    radius : float
        Robots' radius, metres.

    Attributes
    ----------
    doors : dict
        Door id to whether it stands open, for doors that are not as in their scene.
    time : float
        Seconds on the world's clock.
    step : int
        Number of finished skills that changed something.
    absent : set of str
        Sessions of this world whose robots are not loaded now.
    routes : RouteGraph, optional
        The building's routes, once somebody has asked for one.
    lift_changes : deque of LiftState
        What lifts did since somebody last emptied it; the oldest are dropped where nobody does.
    """

    def __init__(self, building: LoadedBuilding, name: str = "shared", radius: float = ROBOT_RADIUS) -> None:
        self.building = building
        self.name = name
        self.radius = radius
        self.time = 0.0
        self.step = 0
        self.doors: dict[str, bool] = {}
        self.robots: dict[str, RobotBody] = {}
        self.absent: set[str] = set()
        self.lift_changes: deque[LiftState] = deque(maxlen=MOST_LIFT_CHANGES)
        self.routes: RouteGraph | None = None
        self.objects = ObjectTable(building.scene(floor) for floor in building.floors)
        self._views: dict[int, FloorView] = {}
        self.lifts = {core.id: self._lift(core) for core in self.cores("elevator")}

    def cores(self, kind: str) -> list[SceneCore]:
        """Return the building's cores of a kind, ``stair`` or ``elevator``, each once."""
        found: dict[str, SceneCore] = {}
        for floor in self.building.floors:
            for core in self.building.scene(floor).cores:
                if core.type == kind:
                    found.setdefault(core.id, core)
        return [found[name] for name in sorted(found)]

    def _lift(self, core: SceneCore) -> Lift:
        elevations = {floor: self.building.entry(floor).elevation for floor in core.floors}
        return Lift(
            name=core.id,
            elevations=elevations,
            labels={floor: self.building.label(floor) for floor in core.floors},
            position=elevations[core.floors[0]],
        )

    def view(self, floor: int) -> FloorView:
        """Return a floor, loaded when it is first needed."""
        if floor not in self._views:
            scene = self.building.scene(floor)
            self._views[floor] = FloorView(scene, self.objects, self.doors, self.radius)
        return self._views[floor]

    def refresh(self, floor: int) -> None:
        """Bring a floor's grids up to date after a door or a standing object changed."""
        if floor in self._views:
            self._views[floor].refresh(self.doors)

    def reload(self) -> None:
        """Forget the loaded floors, after objects and doors were restored."""
        self._views.clear()

    def add_robot(self, session: str) -> RobotBody:
        """Put a session's robot at the spawn pose, or return the one that is there already."""
        if session in self.robots:
            return self.robots[session]
        self.absent.discard(session)
        floors = self.building.floors
        floor = 1 if 1 in floors else floors[0]
        view = self.view(floor)
        spawn = view.scene.spawn
        if spawn is None and not view.landmarks:
            raise MansionError(ErrorCode.NOT_FOUND, f"floor {floor} has neither a spawn pose nor a landmark")
        pose = Pose2D(x=spawn.x, y=spawn.y, yaw=spawn.yaw) if spawn else view.landmarks[0].pose
        self.robots[session] = RobotBody(session, floor, self._beside(session, floor, pose), self.radius)
        return self.robots[session]

    def robot_state(self, robot: RobotBody) -> RobotState:
        """Return a robot's state as a payload."""
        return RobotState(
            session=robot.session,
            floor=robot.floor,
            label=self.building.label(robot.floor),
            pose=robot.pose,
            room=self.view(robot.floor).map.room_at(robot.pose.x, robot.pose.y),
            held=self.objects.held_by(robot.session),
            pitch=robot.pitch,
            building_id=self.building.building_id,
        )

    def others(self, session: str, floor: int) -> list[Point]:
        """Return where the other robots of a floor stand."""
        return [robot.place for name, robot in self.robots.items() if name != session and robot.floor == floor]

    def blocked_for(self, session: str, floor: int) -> npt.NDArray[np.bool_]:
        """Return where the centre of a session's robot cannot be: walls, closed doors, objects, other robots."""
        discs: Iterable[tuple[Point, float]] = [(place, 2 * self.radius) for place in self.others(session, floor)]
        return self.view(floor).map.blocked_with(discs)

    def core_near(self, robot: RobotBody, kind: str, reach: float) -> SceneCore | None:
        """Return the nearest core of `kind` whose entrance is within `reach` metres of the robot."""
        cores = [core for core in self.view(robot.floor).scene.cores if core.type == kind]
        away = {core.id: dist(robot.place, core.entrance[:2]) for core in cores}
        nearest = min(cores, key=lambda core: away[core.id], default=None)
        return nearest if nearest is not None and away[nearest.id] <= reach else None

    def update_floor(self, robot: RobotBody, floor_delta: int, core_id: str) -> None:
        """Take a robot to another floor: the four steps of the UseElevator card.

        What it holds leaves this floor and enters the other with it (it is in the hand all the while), the other
        floor is loaded with its landmarks, and the robot stands at the core's standard pose there, facing outward, its
        camera level.
        """
        floor = robot.floor + floor_delta
        core = next(core for core in self.view(floor).scene.cores if core.id == core_id)
        x, y, yaw = core.entrance
        pose = self._beside(robot.session, floor, Pose2D(x=x, y=y, yaw=yaw))
        robot.floor, robot.pose, robot.pitch, robot.path = floor, pose, 0.0, []

    def _beside(self, session: str, floor: int, pose: Pose2D) -> Pose2D:
        """Return a pose, or the nearest free one when another robot is there."""
        if all(dist((pose.x, pose.y), place) >= 2 * self.radius for place in self.others(session, floor)):
            return pose
        frame = self.view(floor).map.frame
        row, column = frame.cell(pose.x, pose.y)
        reach = int(GIVING_WAY / frame.resolution)
        cell = int(nearest_free(self.blocked_for(session, floor), row, column, reach))
        if cell == NO_CELL:
            return pose
        x, y = frame.center(cell // frame.columns, cell % frame.columns)
        return Pose2D(x=x, y=y, yaw=pose.yaw)

    def advance(self, seconds: float) -> None:
        """Let time pass: lifts move and open their doors."""
        for lift in self.lifts.values():
            self.lift_changes.extend(lift.advance(seconds, self.time, self.building.building_id))
        self.time += seconds

    def lift_states(self) -> list[LiftState]:
        """Return every lift's state now."""
        return [lift.state(self.building.building_id, self.time) for lift in self.lifts.values()]

    def state(self, robot: RobotBody) -> WorldState:
        """Return a session's overlay: its robot, and all that differs from the scenes on disk."""
        return WorldState(
            building_id=self.building.building_id,
            session=robot.session,
            world=self.name,
            robot=self.robot_state(robot),
            lifts=self.lift_states(),
            queues={name: lift.queue for name, lift in self.lifts.items() if lift.queue},
            objects=list(self.objects.changed.values()),
            doors=dict(self.doors),
            calls={robot.call: robot.floor} if robot.call is not None else {},
            revisions={str(f): self.building.scene(f).revision for f in self.building.floors},
            time=self.time,
            step=self.step,
        )
