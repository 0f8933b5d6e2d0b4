"""The world of one session: a loaded building, the robot in it, the lifts, and what has moved."""

from math import dist

from mansion_msgs_py.scene import FloorScene, SceneCore
from mansion_msgs_py.world import LiftDoor, ObjectState, Pose2D, RobotState, WorldState
from mansion_skills.building import LoadedBuilding
from mansion_skills.world.landmarks import Landmark, floor_landmarks, room_at
from mansion_skills.world.lift import Lift

__all__ = ["World"]


class World:
    """All that a skill reads and changes.

    Parameters
    ----------
    building : LoadedBuilding
    session : str
    earlier : WorldState, optional
        The overlay that a former run of the session left.
    """

    def __init__(
        self, building: LoadedBuilding, session: str, earlier: WorldState | None = None
    ) -> None:
        self.building = building
        self.session = session
        self.time = 0.0
        self.step = 0
        self.calls: dict[str, int] = {}
        self.objects: dict[str, ObjectState] = {}
        self.lifts = {
            core.id: Lift(
                name=core.id,
                elevations={floor: building.entry(floor).elevation for floor in core.floors},
                labels={floor: building.label(floor) for floor in core.floors},
                floor=core.floors[0],
            )
            for core in self._all_cores()
            if core.type == "elevator"
        }
        ground = 1 if 1 in building.floors else building.floors[0]
        self._enter(ground)
        spawn = self.scene.spawn
        pose = Pose2D(x=spawn.x, y=spawn.y, yaw=spawn.yaw) if spawn else self.landmarks[0].pose
        self.robot = self._robot(pose, held=None)
        if earlier is not None:
            self._restore(earlier)

    def _all_cores(self) -> list[SceneCore]:
        found: dict[str, SceneCore] = {}
        for floor in self.building.floors:
            for core in self.building.scene(floor).cores:
                found.setdefault(core.id, core)
        return [found[name] for name in sorted(found)]

    def _enter(self, floor: int) -> None:
        """Load a floor and rebuild its landmarks (skill card UseElevator, steps 2 and 3)."""
        self.floor = floor
        self.scene: FloorScene = self.building.scene(floor)
        self.landmarks: list[Landmark] = floor_landmarks(self.scene)

    def _robot(self, pose: Pose2D, held: str | None) -> RobotState:
        return RobotState(
            session=self.session,
            floor=self.floor,
            label=self.building.label(self.floor),
            pose=pose,
            room=room_at(self.scene, pose.x, pose.y),
            held=held,
            building_id=self.building.building_id,
        )

    def move_robot(self, pose: Pose2D) -> None:
        """Put the robot at a pose of the current floor."""
        self.robot = self._robot(pose, self.robot.held)

    def distance_to(self, x: float, y: float) -> float:
        """Metres from the robot to a point of the current floor."""
        return dist((self.robot.pose.x, self.robot.pose.y), (x, y))

    def core_near(self, kind: str, reach: float) -> SceneCore | None:
        """Return the nearest core of `kind` whose entrance is within `reach` metres of the robot."""
        cores = [core for core in self.scene.cores if core.type == kind]
        nearest = min(cores, key=lambda core: self.distance_to(*core.entrance[:2]), default=None)
        if nearest is None or self.distance_to(*nearest.entrance[:2]) > reach:
            return None
        return nearest

    def update_floor(self, floor_delta: int, core_id: str) -> None:
        """Take the robot to another floor: the four steps of the UseElevator card.

        What it holds leaves this floor and enters the other with it, the other floor is loaded, its landmarks are
        rebuilt, and the robot stands at the core's standard pose there, facing outward.
        """
        held = self.robot.held
        self._enter(self.floor + floor_delta)
        core = next(core for core in self.scene.cores if core.id == core_id)
        x, y, yaw = core.entrance
        self.robot = self._robot(Pose2D(x=x, y=y, yaw=yaw), held)

    def state(self) -> WorldState:
        """Return the overlay: everything that differs from the scenes on disk."""
        return WorldState(
            building_id=self.building.building_id,
            session=self.session,
            robot=self.robot,
            lifts=[
                lift.state(self.building.building_id, self.time) for lift in self.lifts.values()
            ],
            objects=list(self.objects.values()),
            calls=dict(self.calls),
            revisions={str(f): self.building.scene(f).revision for f in self.building.floors},
            time=self.time,
            step=self.step,
        )

    def _restore(self, earlier: WorldState) -> None:
        self._enter(earlier.robot.floor)
        self.robot = self._robot(earlier.robot.pose, earlier.robot.held)
        self.calls = dict(earlier.calls)
        self.objects = {thing.id: thing for thing in earlier.objects}
        self.time, self.step = earlier.time, earlier.step
        for saved in earlier.lifts:
            lift = self.lifts.get(saved.lift_name)
            if lift is not None:
                lift.floor = next(
                    f for f, text in lift.labels.items() if text == saved.current_floor
                )
                lift.door = LiftDoor(saved.door_state)
                lift.session = saved.session_id
