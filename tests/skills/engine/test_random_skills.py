"""Whatever two robots do in whatever order, and whenever the process ends: nothing is lost or doubled."""

import shutil
import tempfile
from pathlib import Path

from hypothesis import HealthCheck, settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, invariant, precondition, rule

from invariants import check_world
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.world import SkillResult, SkillStatus
from mansion_skills import Robot
from mansion_skills.engine import Engine
from mansion_skills.skills.declaration import snake_case
from mansion_skills.skills.registry import SKILLS
from sample_building import write_building

FLOORS = [1, 2]
SESSIONS = ("default", "second")
THINGS = [
    f"F{floor}/{name}"
    for floor in FLOORS
    for name in (
        "office/desk_1",
        "office/mug_1",
        "office/box_1",
        "office/ball_1",
        "office/shelf_1",
        "kitchen/fridge_1",
        "kitchen/apple_1",
        "kitchen/table_1",
        "nowhere/nothing_1",
    )
]
PLACES = ["hall", "office", "kitchen", "elevator", "stairs", "attic"]
sessions = st.sampled_from(SESSIONS)
things = st.sampled_from(THINGS)


class Building(RuleBasedStateMachine):
    """Two robots that share a building whose server may die between any two skills."""

    def __init__(self) -> None:
        super().__init__()
        self.folder = Path(tempfile.mkdtemp())
        write_building(self.folder, FLOORS)
        self.start()

    def start(self) -> None:
        self.engine = Engine(durable=False)
        self.robots = {name: Robot(self.folder, name, engine=self.engine) for name in SESSIONS}

    def teardown(self) -> None:
        shutil.rmtree(self.folder)

    @property
    def world(self):  # type: ignore[no-untyped-def]
        return self.engine.session("").world

    def snapshot(self) -> bytes:
        world = self.world
        objects = [world.objects.state(name) for name in world.objects]
        robots = [world.robot_state(world.robots[name]) for name in SESSIONS]
        return encode_bytes([objects, robots, sorted(world.doors.items())])

    def do(self, session: str, name: str, **arguments: object) -> None:
        before = self.snapshot()
        result = self.robots[session].skill(name, **arguments)
        if isinstance(result, SkillResult) and result.status is not SkillStatus.SUCCESS:
            assert result.message and result.satisfied_by
            assert result.status in SKILLS[snake_case(name)].failures
            assert self.snapshot() == before

    @rule(session=sessions, place=st.sampled_from(PLACES))
    def go(self, session: str, place: str) -> None:
        self.do(session, "GoToLandmark", landmark=place)

    @rule(session=sessions, floor=st.sampled_from([*FLOORS, 99]))
    def ride(self, session: str, floor: int) -> None:
        self.do(session, "GoToLandmark", landmark="elevator")
        self.do(session, "CallElevator")
        self.do(session, "UseElevator", target_floor=floor)

    @rule(session=sessions, direction=st.sampled_from(["Up", "Down"]))
    def climb(self, session: str, direction: str) -> None:
        self.do(session, "GoToLandmark", landmark="stairs")
        self.do(session, "TakeStairs", direction=direction)

    @rule(session=sessions, thing=things, near=st.booleans())
    def take(self, session: str, thing: str, near: bool) -> None:
        if near:
            self.do(session, "GoNearObject", object=thing)
        self.do(session, "PickUp", object=thing)

    @rule(
        session=sessions, where=st.sampled_from([*THINGS, "floor"]), relation=st.sampled_from(["on", "in", "in_front"])
    )
    def put(self, session: str, where: str, relation: str) -> None:
        if where != "floor":
            self.do(session, "GoNearObject", object=where)
        self.do(session, "Place", target=where, relation=relation)

    @rule(session=sessions, thing=things, name=st.sampled_from(["OpenObject", "CloseObject"]))
    def swing(self, session: str, thing: str, name: str) -> None:
        self.do(session, "GoNearObject", object=thing)
        self.do(session, name, object=thing)

    @rule(session=sessions, number=st.integers(1, 5), is_open=st.booleans())
    def door(self, session: str, number: int, is_open: bool) -> None:
        floor = self.robots[session].where_am_i().floor
        door = f"F{floor}/door_{number}"
        self.do(session, "GoNearObject", object=door)
        self.do(session, "OpenDoor" if is_open else "CloseDoor", door=door)

    @rule(session=sessions, distance=st.floats(-1, 1), turn=st.floats(-180, 180))
    def wander(self, session: str, distance: float, turn: float) -> None:
        self.do(session, "Rotate", degrees=turn)
        self.do(session, "MoveAhead", distance=distance)

    @precondition(lambda self: self.world.step > 0)
    @rule()
    def restart(self) -> None:
        before = self.snapshot()
        self.start()
        assert self.snapshot() == before

    @invariant()
    def holds(self) -> None:
        check_world(self.world)


TestBuilding = Building.TestCase
TestBuilding.settings = settings(
    max_examples=15, stateful_step_count=20, deadline=None, suppress_health_check=[HealthCheck.too_slow]
)
