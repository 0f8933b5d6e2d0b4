"""Placed objects rest on or in their receptacle, or are refused."""

import os
import subprocess
import sys

import pytest

from mansion_editing.physics.engine import PhysicsEngine, PosedBox, SettleProblem, engine_named
from mansion_editing.state import SceneState
from mansion_editing.tools.perception import contents, on_top
from mansion_editing.tools.placement import place_in_container, place_on_surface
from mansion_msgs_py.editing.objects import PlaceInContainerArgs, PlaceOnSurfaceArgs
from mansion_msgs_py.errors import MansionError

FLOOR = PosedBox((0.0, 0.0, -0.05), (1.0, 1.0, 0.1))


@pytest.fixture(params=["static", "mujoco"])
def engine(request: pytest.FixtureRequest) -> PhysicsEngine:
    """Return each engine; MuJoCo where it is installed."""
    if request.param == "mujoco":
        pytest.importorskip("mujoco")
    return engine_named(request.param)


def _box(x: float, y: float, z: float, size: tuple[float, float, float] = (0.1, 0.1, 0.1)) -> PosedBox:
    return PosedBox((x, y, z), size, 30.0)


def test_a_box_comes_to_rest_on_what_is_below(engine: PhysicsEngine) -> None:
    result = engine.settle(SettleProblem(_box(0.1, 0.2, 0.06), [FLOOR]))
    assert result.at_rest and result.tilt < 0.5 and result.penetration < 0.001
    assert result.position == pytest.approx((0.1, 0.2, 0.05), abs=2e-3)
    assert result.rotation == pytest.approx(30.0, abs=0.5)


def test_a_box_beyond_the_edge_topples_or_falls(engine: PhysicsEngine) -> None:
    result = engine.settle(SettleProblem(_box(0.53, 0.0, 0.06), [FLOOR]))
    assert not result.at_rest or result.tilt > 3.0 or result.position[2] < 0.0


def test_a_wall_in_the_way_is_noticed(engine: PhysicsEngine) -> None:
    wall = PosedBox((0.1, 0.0, 0.5), (0.02, 1.0, 1.0))
    result = engine.settle(SettleProblem(_box(0.12, 0.0, 0.06), [FLOOR], [wall]))
    moved = abs(result.position[0] - 0.12) > 0.01
    assert moved or result.penetration > 0.002 or result.tilt > 3.0 or not result.at_rest


def test_mujoco_sees_that_a_neighbour_is_pushed() -> None:
    pytest.importorskip("mujoco")
    is_next_to = {"cup": PosedBox((0.09, 0.0, 0.05), (0.1, 0.1, 0.1))}
    body = PosedBox((0.0, 0.0, 0.06), (0.1, 0.1, 0.1))
    result = engine_named("mujoco").settle(SettleProblem(body, [FLOOR], [], is_next_to))
    assert result.pushed["cup"] > 0.001


@pytest.mark.parametrize("asset", ["cola_can_1", "Book_26", "Laptop_30", "toolbox_1"])
def test_things_rest_on_a_table(state: SceneState, engine: PhysicsEngine, asset: str) -> None:
    args = PlaceOnSurfaceArgs(asset_id=asset, receptacle_id="F1/kitchen/dining_table_1")
    placed = place_on_surface(state, args, engine)
    _, table = state.get("F1/kitchen/dining_table_1")
    assert placed.position[2] - placed.size[2] / 2 == pytest.approx(table.size[2], abs=2e-3)
    assert placed in on_top(state.index(1), table, state.asset(table))


def test_a_fridge_fills_up_and_then_refuses(state: SceneState, engine: PhysicsEngine) -> None:
    args = PlaceInContainerArgs(asset_id="cola_can_1", container_id="F1/kitchen/fridge_1")
    _, fridge = state.get("F1/kitchen/fridge_1")
    for count in range(1, 6):
        place_in_container(state, args, engine)
        inside = contents(state.index(1), fridge, state.asset(fridge))
        assert len(inside) == count
    with pytest.raises(MansionError) as error:
        for _ in range(2000):
            place_in_container(state, args, engine)
    assert error.value.code == "INFEASIBLE"


def test_a_cushion_carries_visibly(state: SceneState, engine: PhysicsEngine) -> None:
    args = PlaceOnSurfaceArgs(asset_id="Book_26", receptacle_id="F1/hall/sofa_1")
    placed = place_on_surface(state, args, engine)
    _, sofa = state.get("F1/hall/sofa_1")
    asset = state.asset(sofa)
    assert asset is not None
    foot = placed.position[2] - placed.size[2] / 2
    seat = sofa.position[2] + asset.surfaces[0].z
    assert seat - 2e-3 <= foot <= seat + 0.05
    assert placed in on_top(state.index(1), sofa, asset)


def test_furniture_stands_clear_on_the_floor_of_a_room(state: SceneState, engine: PhysicsEngine) -> None:
    args = PlaceOnSurfaceArgs(asset_id="Fridge_1", receptacle_id="F1/kitchen")
    placed = place_on_surface(state, args, engine)
    assert placed.mount == "floor" and placed.room == "F1/kitchen"
    assert placed.position[2] == pytest.approx(placed.size[2] / 2, abs=1e-4)


def test_what_hangs_is_not_put_on_a_table(state: SceneState, engine: PhysicsEngine) -> None:
    painting = state.catalogue.by_category("painting")[0].key
    args = PlaceOnSurfaceArgs(asset_id=painting, receptacle_id="F1/kitchen/dining_table_1")
    with pytest.raises(MansionError, match="hangs on a wall"):
        place_on_surface(state, args, engine)


@pytest.mark.parametrize("backend", ["nonsense", "osmesa"])
def test_physics_needs_no_opengl(backend: str) -> None:
    pytest.importorskip("mujoco")
    script = (
        "import os\n"
        "from mansion_editing.physics.mujoco_engine import _mujoco\n"
        "assert _mujoco().MjModel.from_xml_string('<mujoco/>').nbody == 1\n"
        "print(os.environ['MUJOCO_GL'])"
    )
    done = subprocess.run(
        [sys.executable, "-c", script],
        env={**os.environ, "MUJOCO_GL": backend},
        capture_output=True,
        text=True,
        timeout=120,
    )
    assert done.stdout.strip() == backend, done.stderr
