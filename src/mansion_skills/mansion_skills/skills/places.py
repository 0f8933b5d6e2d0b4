"""GoToLandmark and WhereAmI."""

from mansion_msgs_py.skills import GoToLandmarkArgs, SessionArgs, WhereAmI
from mansion_msgs_py.world import SkillChange, SkillResult, SkillStatus
from mansion_skills.skills.outcome import done, refused
from mansion_skills.world.landmarks import landmark_named
from mansion_skills.world.world import World

__all__ = ["go_to_landmark", "where_am_i"]

SPEED = 0.5
"""Metres a second."""


def go_to_landmark(world: World, arguments: GoToLandmarkArgs) -> SkillResult:
    """Go to a room or a core of the current floor."""
    name = "GoToLandmark"
    pose = world.robot.pose
    landmark = landmark_named(arguments.landmark, world.landmarks, world.floor, (pose.x, pose.y))
    if landmark is None:
        known = ", ".join(entry.name for entry in world.landmarks)
        text = f"floor {world.floor} has no landmark {arguments.landmark!r}"
        return refused(world, name, SkillStatus.INVALID_ACTION, text, f"one of {known}")
    world.time += world.distance_to(landmark.pose.x, landmark.pose.y) / SPEED
    world.move_robot(landmark.pose)
    return done(
        world,
        name,
        f"at {landmark.name}",
        SkillChange(what="pose", before=pose, after=landmark.pose),
        landmark=landmark.name,
    )


def where_am_i(world: World, arguments: SessionArgs) -> WhereAmI:
    """Say where the robot is and what it holds."""
    robot = world.robot
    return WhereAmI(
        floor=robot.floor,
        label=robot.label,
        room=robot.room,
        pose=robot.pose,
        held=robot.held,
        session=world.session,
    )
