"""Placements with AI2-THOR as the engine; MuJoCo stands behind its client's interface, and behind the client itself."""

import os
import stat
import sys
from functools import partial
from math import cos, radians
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

pytest.importorskip("mujoco")
from mansion_editing.physics.engine import PosedBox, SettleProblem, engine_named
from mansion_editing.physics.thor_engine import BUILD, ThorEngine, house_of, parameters, thor_bodies, thor_shift
from mansion_editing.state import SceneState
from mansion_editing.tools.perception import contents, on_top
from mansion_editing.tools.placement import place_in_container, place_on_surface
from mansion_export.thor import validate_house
from mansion_geometry.thor.controller import start_controller
from mansion_msgs_py.editing.objects import PlaceInContainerArgs, PlaceOnSurfaceArgs
from mansion_msgs_py.errors import MansionError
from thor_simulator import ThorSimulator

TABLE = PosedBox((31.0, 17.0, 0.7), (1.0, 0.6, 0.06), 20.0)
TOP = 0.73


class Client:
    """``ai2thor.controller.Controller`` in so far as it hands actions on and raises what the client raises."""

    def __init__(self, simulator: ThorSimulator) -> None:
        self.simulator = simulator
        self.last_event: Any = None
        self.stopped = 0

    def step(self, action: Any = None, **arguments: Any) -> Any:
        metadata = self.simulator.do({"action": action, **arguments})
        self.last_event = SimpleNamespace(metadata=metadata)
        if metadata["errorCode"] == "InvalidAction":
            raise ValueError(metadata["errorMessage"])
        return self.last_event

    def reset(self, scene: Any = None, **parameters: Any) -> Any:
        raise AssertionError("a placement makes its scene once")

    def stop(self) -> None:
        self.stopped += 1


class Starter:
    """Starts a client each time, and remembers them."""

    def __init__(self, **faults: str) -> None:
        self.faults = faults
        self.lacking: tuple[str, ...] = ()
        self.clients: list[Client] = []
        self.parameters: dict[str, Any] = {}

    def __call__(self, **parameters: Any) -> Client:
        self.parameters = parameters
        client = Client(ThorSimulator(self.lacking))
        client.simulator.faults = self.faults
        self.clients.append(client)
        return client


def box(x: float, y: float, z: float, rotation: float = 30.0) -> PosedBox:
    return PosedBox((31.0 + x, 17.0 + y, TOP + z), (0.12, 0.08, 0.1), rotation)


def test_a_box_comes_to_rest_where_and_as_it_was_let_go() -> None:
    result = ThorEngine(Starter()).settle(SettleProblem(box(0.1, -0.05, 0.053), [TABLE]))
    assert result.at_rest and result.tilt < 0.2 and result.penetration < 0.001
    assert result.position == pytest.approx((31.1, 16.95, TOP + 0.05), abs=1e-3)
    assert result.rotation == pytest.approx(30.0, abs=0.3)


@pytest.mark.parametrize("turn", [0.0, 75.0, 200.0])
def test_it_answers_as_mujoco_does(turn: float) -> None:
    cup = PosedBox((31.13, 17.02, TOP + 0.06), (0.06, 0.06, 0.12), 10.0)
    problem = SettleProblem(box(0.0, 0.0, 0.06, turn), [TABLE], [], {"cup": cup})
    ours, theirs = engine_named("mujoco").settle(problem), ThorEngine(Starter()).settle(problem)
    assert theirs.position == pytest.approx(ours.position, abs=2e-3)
    assert cos(radians(theirs.rotation - ours.rotation)) > 0.9999
    assert theirs.at_rest is ours.at_rest
    assert theirs.pushed["cup"] == pytest.approx(ours.pushed["cup"], abs=2e-3)


def test_a_box_over_the_edge_turns_about_the_edge() -> None:
    result = ThorEngine(Starter()).settle(
        SettleProblem(PosedBox((31.0, 17.0, 1.0), (0.1, 0.1, 0.1)), [PosedBox((30.7, 17.0, 0.9), (0.58, 0.5, 0.05))])
    )
    assert result.tilt > 3.0 or result.position[2] < 0.9 or not result.at_rest


def test_a_pushed_neighbour_and_a_wall_in_the_way_are_noticed() -> None:
    neighbour = {"cup": box(0.08, 0.0, 0.05)}
    result = ThorEngine(Starter()).settle(SettleProblem(box(0.0, 0.0, 0.06), [TABLE], [], neighbour))
    assert result.pushed["cup"] > 0.001
    wall = PosedBox((31.0, 17.0, 1.0), (0.02, 0.5, 0.6), 20.0)
    result = ThorEngine(Starter()).settle(SettleProblem(box(0.03, 0.0, 0.06), [TABLE], [wall]))
    moved = abs(result.position[0] - 31.03) > 0.01
    assert moved or result.penetration > 0.002 or result.tilt > 3.0 or not result.at_rest


def test_depth_is_that_of_the_boxes_read_back() -> None:
    """Both fixed things overlap where the body cannot leave: it is held between two walls."""
    walls = [PosedBox((31.0 + x, 17.0, TOP + 0.05), (0.04, 0.3, 0.3)) for x in (-0.07, 0.07)]
    result = ThorEngine(Starter()).settle(SettleProblem(box(0.0, 0.0, 0.06, 0.0), [TABLE], walls))
    assert result.penetration > 0.004


def test_a_neighbour_within_the_receptacles_hollow_body_stays() -> None:
    hollow = PosedBox((31.3, 17.0, TOP + 0.2), (0.3, 0.3, 0.4))
    cup = PosedBox((31.3, 17.0, TOP + 0.05), (0.06, 0.06, 0.1))
    problem = SettleProblem(box(0.0, 0.0, 0.06), [TABLE], [hollow], {"cup": cup})
    result = ThorEngine(Starter()).settle(problem)
    assert result.pushed["cup"] < 1e-4 and result.at_rest


def test_the_room_of_a_placement_is_a_sound_house() -> None:
    problem = SettleProblem(box(0.0, 0.0, 0.06), [TABLE], [], {"cup": box(0.2, 0.1, 0.05)})
    assert validate_house(house_of(thor_bodies(problem), thor_shift(problem))) == []


@pytest.mark.parametrize("asset", ["cola_can_1", "Book_26", "Laptop_30"])
def test_things_rest_on_a_table(state: SceneState, asset: str) -> None:
    starter = Starter()
    args = PlaceOnSurfaceArgs(asset_id=asset, receptacle_id="F1/kitchen/dining_table_1")
    placed = place_on_surface(state, args, ThorEngine(starter))
    _, table = state.get("F1/kitchen/dining_table_1")
    assert placed.position[2] - placed.size[2] / 2 == pytest.approx(table.size[2], abs=2e-3)
    assert placed in on_top(state.index(1), table, state.asset(table))
    assert starter.clients and all(client.stopped == 1 for client in starter.clients)


def test_things_lie_in_the_fridge_beside_each_other(state: SceneState) -> None:
    engine = ThorEngine(Starter())
    args = PlaceInContainerArgs(asset_id="cola_can_1", container_id="F1/kitchen/fridge_1")
    _, fridge = state.get("F1/kitchen/fridge_1")
    for count in range(1, 4):
        place_in_container(state, args, engine)
        assert len(contents(state.index(1), fridge, state.asset(fridge))) == count


@pytest.mark.parametrize("action", ["CreateRuntimeAsset", "CreateHouse", "AdvancePhysicsStep"])
def test_a_refusal_is_told_and_the_simulator_is_gone(action: str) -> None:
    starter = Starter(**{action: "nothing doing"})
    with pytest.raises(MansionError, match=f"{action}: nothing doing") as caught:
        ThorEngine(starter).settle(SettleProblem(box(0.0, 0.0, 0.06), [TABLE]))
    assert caught.value.code == "UNAVAILABLE"
    assert [client.stopped for client in starter.clients] == [1]


def test_a_build_without_runtime_assets_is_named_as_the_fault() -> None:
    starter = Starter()
    starter.lacking = ("CreateRuntimeAsset",)
    with pytest.raises(MansionError, match="MANSION_THOR_BUILD"):
        ThorEngine(starter).settle(SettleProblem(box(0.0, 0.0, 0.06), [TABLE]))
    assert starter.clients[0].stopped == 1


def test_the_environment_names_another_build(tmp_path: Path) -> None:
    assert parameters({}) == {
        "scene": "Procedural",
        "agentMode": "default",
        "platform": "CloudRendering",
        "commit_id": BUILD,
    }
    assert parameters({"MANSION_THOR_BUILD": "f00"})["commit_id"] == "f00"
    file = str(tmp_path / "thor-Linux64")
    assert parameters({"MANSION_THOR_BUILD": file})["local_executable_path"] == file


def test_without_the_extra_the_error_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "ai2thor", None)
    monkeypatch.setitem(sys.modules, "ai2thor.controller", None)
    with pytest.raises(MansionError, match="the extra `thor`") as caught:
        engine_named("thor").settle(SettleProblem(box(0.0, 0.0, 0.06), [TABLE]))
    assert caught.value.code == "UNAVAILABLE"


@pytest.fixture
def executable(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The simulator as a program that AI2-THOR's own client starts; each start writes its process into a file."""
    pytest.importorskip("ai2thor")
    program = tmp_path / "thor-simulator"
    script = Path(__file__).with_name("thor_simulator.py")
    program.write_text(f'#!/bin/sh\nexec "{sys.executable}" "{script}"\n', encoding="utf-8")
    program.chmod(program.stat().st_mode | stat.S_IXUSR)
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("DISPLAY", ":77")
    monkeypatch.setenv("THOR_SIMULATOR_LOG", str(tmp_path / "started"))
    monkeypatch.setenv("MANSION_THOR_BUILD", str(program))
    return tmp_path


def gone(folder: Path) -> bool:
    """Whether exactly one simulator was started and none is left."""
    (process,) = (folder / "started").read_text(encoding="utf-8").split()
    return not os.path.exists(f"/proc/{process}")


def test_through_the_real_client_a_box_comes_to_rest(executable: Path) -> None:
    engine = ThorEngine(partial(start_controller, server_timeout=20.0))
    result = engine.settle(SettleProblem(box(0.1, -0.05, 0.053), [TABLE]))
    assert result.at_rest and result.penetration < 0.001
    assert result.position == pytest.approx((31.1, 16.95, TOP + 0.05), abs=1e-3)
    assert gone(executable)


@pytest.mark.parametrize("action", ["GetScenesInBuild", "CreateHouse"])
def test_through_the_real_client_a_simulator_that_dies_is_unavailable(
    executable: Path, action: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("THOR_SIMULATOR_DIES_AT", action)
    impatient = partial(start_controller, server_timeout=5.0)
    with pytest.raises(MansionError) as caught:
        ThorEngine(impatient).settle(SettleProblem(box(0.1, 0.0, 0.053), [TABLE]))
    assert caught.value.code == "UNAVAILABLE" and gone(executable)


def test_through_the_real_client_an_unknown_action_is_told(executable: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("THOR_SIMULATOR_LACKING", "CreateRuntimeAsset")
    with pytest.raises(MansionError, match="Invalid action: CreateRuntimeAsset"):
        engine_named("thor").settle(SettleProblem(box(0.1, 0.0, 0.053), [TABLE]))
    assert gone(executable)


def test_through_the_real_client_a_build_that_cannot_be_had_is_unavailable(
    executable: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def none(*_: Any) -> list[Any]:
        return []

    controller = pytest.importorskip("ai2thor.controller")
    monkeypatch.setattr(controller.Controller, "find_platform_builds", none)
    monkeypatch.delenv("MANSION_THOR_BUILD")
    with pytest.raises(MansionError, match="platforms=CloudRendering") as caught:
        engine_named("thor").settle(SettleProblem(box(0.1, 0.0, 0.053), [TABLE]))
    assert caught.value.code == "UNAVAILABLE"
    assert not (executable / "started").exists()
