"""A small flat built once, and stand-ins for building that vary it as a request says."""

import shutil
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, ThreadPoolExecutor
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path

import msgspec
import pytest
from typer.testing import CliRunner

from mansion_bringup.cli.app import app
from mansion_bringup.worlds import build_for_world
from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.scene import FloorScene

FLATS = Path(__file__).parents[2] / "examples" / "small_world.toml"


@pytest.fixture(scope="session")
def flat(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A built flat."""
    folder = tmp_path_factory.mktemp("flat") / "flat"
    build_for_world(BuildRequest(description="A small flat with one bedroom.", floor_area=62.0, seed=3), folder)
    return folder


@pytest.fixture(scope="session")
def small_world(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The example of the documentation: a world of three flats, made by the command."""
    folder = tmp_path_factory.mktemp("world") / "small"
    done = CliRunner().invoke(
        app, ["world", "make", "-o", str(folder), "-n", "3", "--seed", "7", "--mix", str(FLATS), "--jobs", "1"]
    )
    assert done.exit_code == 0, done.output
    return folder


@pytest.fixture
def flats_mix() -> Path:
    """A mixture of studios and small flats."""
    return FLATS


def stretched(scene: FloorScene, share: float) -> FloorScene:
    """Return a scene whose rooms are further apart."""
    rooms = [
        msgspec.structs.replace(room, polygon=[(x * share, y * share) for x, y in room.polygon]) for room in scene.rooms
    ]
    return msgspec.structs.replace(scene, rooms=rooms)


@pytest.fixture
def build(flat: Path) -> Callable[[BuildRequest, Path], None]:
    """A build that takes no time: the flat, its rooms moved as the seed says."""

    def build(request: BuildRequest, folder: Path) -> None:
        partial = folder.with_name(f".{folder.name}.partial")
        shutil.copytree(flat, partial, dirs_exist_ok=True)
        scene = stretched(BuildingFolder(flat).scene(1), 1.0 + request.seed % 1009)
        (partial / "floors/floor_1/scene.json").write_bytes(encode_bytes(scene))
        named = msgspec.structs.replace(BuildingFolder(flat).building, building_id=request.building_id or "")
        (partial / "building.json").write_bytes(encode_bytes(named))
        partial.rename(folder)

    return build


@pytest.fixture
def threads() -> Callable[[int], Callable[[], AbstractContextManager[Executor]]]:
    """Makes workers that are threads."""

    def workers(jobs: int) -> Callable[[], AbstractContextManager[Executor]]:
        @contextmanager
        def pool() -> Iterator[Executor]:
            with ThreadPoolExecutor(jobs) as executor:
                yield executor

        return pool

    return workers
