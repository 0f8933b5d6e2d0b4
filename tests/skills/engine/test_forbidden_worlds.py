"""In a building where the process may not write, questions are answered and robots stay where they are."""

from pathlib import Path

import pytest

from mansion_msgs_py.allowed_folders import AllowedFolders
from mansion_msgs_py.building import LoadBuilding
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.skills import SessionArgs
from mansion_skills.engine import Engine
from mansion_skills.engine.motion import VelocityCommand, drive_for


@pytest.fixture
def engine(building: Path) -> Engine:
    """An engine with two sessions in a building that it may not write."""
    engine = Engine(allowed=AllowedFolders((building.parent / "elsewhere",)))
    for session in ("a", "b"):
        engine.load(LoadBuilding(path=str(building), session=session))
    return engine


def files(building: Path) -> dict[Path, bytes]:
    return {file: file.read_bytes() for file in building.rglob("*") if file.is_file()}


def test_questions_are_answered(engine: Engine, building: Path) -> None:
    before = files(building)
    assert engine.run("WhereAmI", SessionArgs(session="a")).floor == 1
    assert engine.run("ListLandmarks", SessionArgs(session="a")).landmarks
    assert files(building) == before


def test_a_skill_is_refused_before_the_robot_moves(engine: Engine, building: Path) -> None:
    before, pose = files(building), engine.session("a").robot.pose
    with pytest.raises(MansionError, match="elsewhere, or start") as caught:
        engine.run("Rotate", SessionArgs(session="a"))
    assert caught.value.code == ErrorCode.FORBIDDEN
    assert engine.session("a").robot.pose == pose and files(building) == before


def test_a_velocity_command_moves_nothing(engine: Engine) -> None:
    session, drive = engine.session("a"), VelocityCommand()
    drive.command(0.0, 1.0, now=0.0)
    assert not drive_for(session, drive, 0.1, now=0.05)
    assert not drive.moved


def test_a_world_is_not_reset(building: Path) -> None:
    Engine().load(LoadBuilding(path=str(building)))
    before = files(building)
    engine = Engine(allowed=AllowedFolders(()))
    with pytest.raises(MansionError) as caught:
        engine.load(LoadBuilding(path=str(building), reset=True))
    assert caught.value.code == ErrorCode.FORBIDDEN and files(building) == before
