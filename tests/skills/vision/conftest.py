"""The sample building with models to render, and a robot with a camera in it."""

import shutil
from collections.abc import Iterator
from pathlib import Path

import msgspec
import pytest

from mansion_export.mjcf import floor_mjcf
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import FloorScene
from mansion_skills import Robot
from mansion_skills.vision import Camera
from mansion_skills.vision.offscreen import GlThread
from sample_building import write_building

FLOORS = [1, 2, 3, 4, 5]
FRIDGE = "Fridge_28"


def write_model(folder: Path, floor: int) -> None:
    """Write a floor's model, the fridge with a door of its own."""
    path = folder / "floors" / f"floor_{floor}"
    scene = msgspec.json.decode((path / "scene.json").read_bytes(), type=FloorScene)
    objects = [
        msgspec.structs.replace(item, asset=FRIDGE) if item.category == "fridge" else item for item in scene.objects
    ]
    scene = msgspec.structs.replace(scene, objects=objects)
    (path / "scene.json").write_bytes(encode_bytes(scene))
    model = floor_mjcf(scene)
    (path / "model.xml").write_text(model.xml)
    (folder / "meshes").mkdir(exist_ok=True)
    for name, mesh in model.meshes.items():
        (folder / "meshes" / name).write_bytes(mesh)


@pytest.fixture(scope="session")
def stock(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = write_building(tmp_path_factory.mktemp("pictured") / "building", FLOORS)
    for floor in FLOORS:
        write_model(folder, floor)
    return folder


@pytest.fixture(scope="session")
def renders() -> None:
    """Skip where nothing can be rendered, with what is missing."""
    try:
        GlThread(64, 64).close()
    except MansionError as error:
        assert error.code == ErrorCode.UNAVAILABLE
        pytest.skip(str(error))


@pytest.fixture
def pictured(stock: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(stock, tmp_path / "building"))


@pytest.fixture
def camera(renders: None, robot: Robot) -> Iterator[Camera]:
    with Camera(robot, 120, 120) as camera:
        yield camera
