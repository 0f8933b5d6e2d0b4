"""What the pages' examples find in the folder that they run in."""

import os
import shutil
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from mansion_bringup.pipeline.build import build_building
from mansion_bringup.pipeline.floors import solve
from mansion_bringup.pipeline.stages import LocalStages
from mansion_bringup.worlds import build_for_world, check_for_world, tasks_for_world
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.request import BuildRequest, identified
from mansion_msgs_py.stages import FurnishRequest
from mansion_world.attempts import TaskStep
from mansion_world.making import make_world
from mansion_world.mixture import load_mixture
from mansion_world.parquet import write_parquet
from mansion_world.requests import Sampled
from mansion_world.world_folder import WorldFolder

FLATS = Path(__file__).parents[2] / "examples" / "small_world.toml"


@pytest.fixture(scope="session")
def stock(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with two buildings, a world of one flat, a furnishing request, and a user's empty knowledge."""
    folder = tmp_path_factory.mktemp("pages")
    request = identified(BuildRequest(description="a two-storey clinic", floor_area=160.0))
    build_building(request, folder / "out" / "clinic")
    office = BuildRequest(description="A four-storey office with a cafeteria on the ground floor")
    build_building(office, folder / "out" / "office", jobs=2)
    (folder / "my_knowledge").mkdir()
    make_world(
        folder / "out" / "flats",
        1,
        requests=Sampled(7, load_mixture(FLATS)),
        build=build_for_world,
        check=check_for_world,
        workers=lambda: ThreadPoolExecutor(1),
        tasks=TaskStep(3, tasks_for_world),
    )
    write_parquet(WorldFolder(folder / "out" / "flats"))
    stages = LocalStages()
    plan = stages.plan(request)
    furnish = FurnishRequest(
        building_id=plan.program.building_id,
        floor=plan.program.floors[0],
        floors=[floor.index for floor in plan.program.floors],
        labels=[floor.label for floor in plan.program.floors],
        connectivity=plan.program.vertical_connectivity,
        topology=plan.topologies[0],
        layout=solve(stages, plan, 0),
    )
    (folder / "request.json").write_bytes(encode_bytes(furnish))
    return folder


@pytest.fixture
def workplace(stock: Path, tmp_path: Path) -> Iterator[Path]:
    """A copy of the stock, as the working directory."""
    shutil.copytree(stock, tmp_path / "work")
    before = Path.cwd()
    os.chdir(tmp_path / "work")
    yield tmp_path / "work"
    os.chdir(before)
