"""Viewpoints of pictures: the robot of a session, put at a room, a stair or a lift of any floor."""

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.wording import choices
from mansion_msgs_py.world import Pose2D
from mansion_skills.engine.session import Session
from mansion_skills.vision.room_view import widest_view
from mansion_skills.world.floor_view import Landmark, landmark_named
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = ["stand_at"]


def stand_at(session: Session, room: str = "", floor: int | None = None, turn: float = 0.0) -> None:
    """Put the robot where the picture is to be taken from; what is saved of its session stays as it is.

    Parameters
    ----------
    room : str
        A room, from where most of it is in view, or a stair or a lift, on the robot's floor first; where the robot
        is, or the floor's first when empty.
    floor : int, optional
        The only floor to look on.
    turn : float
        Degrees to the left of where it would look.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` with the places or floors that there are.
    """
    world, body = session.world, session.robot
    floors = [body.floor, *(f for f in world.building.floors if f != body.floor)]
    if floor is not None:
        if floor not in floors:
            known = ", ".join(map(str, world.building.floors))
            raise MansionError(ErrorCode.NOT_FOUND, f"there is no floor {floor}; floors: {known}")
        floors = [floor]
    if room or floor not in (None, body.floor):
        found = _place(world, body, room, floors)
        body.floor = found.floor
        body.pose = widest_view(world, found) if found.kind == "room" else found.pose
    pose = body.pose
    body.pose = Pose2D(x=pose.x, y=pose.y, yaw=(pose.yaw + turn) % 360.0)


def _place(world: World, body: RobotBody, room: str, floors: list[int]) -> Landmark:
    """Return the landmark of that name on the first floor that has one; without a name, the first floor's first."""
    if not room:
        return world.view(floors[0]).landmarks[0]
    for floor in floors:
        found = landmark_named(room, world.view(floor).landmarks, floor, body.place)
        if found is not None:
            return found
    known = [mark.name for floor in floors for mark in world.view(floor).landmarks]
    near = choices(room, known, "rooms, stairs and lifts")
    where = f"on floor {floors[0]}" if len(floors) == 1 else "in the building"
    raise MansionError(ErrorCode.NOT_FOUND, f"there is no {room!r} {where}; {near}")
