"""Builds of several clients in one process, as the graph's director runs them, each with a library of its own."""

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from threading import Lock
from typing import Any

from mansion_assets.catalogue import load_catalogue
from mansion_bringup.pipeline.build import BuildResult, build_building
from mansion_bringup.pipeline.stages import LocalStages
from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.layout import FloorLayout, FloorProblem
from mansion_msgs_py.request import BuildRequest, building_id_of
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.stages import BuildJob, FurnishRequest, PlanReply
from sample_models import write_library


def over_the_wire(payload: Any) -> Any:
    return decode(type(payload), encode_bytes(payload))


class DistantStages(LocalStages):
    """The stages, behind the bytes of services; compiled kernels take one thread at a time."""

    serving = Lock()

    def plan(self, request: BuildRequest) -> PlanReply:
        with self.serving:
            reply: PlanReply = over_the_wire(super().plan(over_the_wire(request)))
        return reply

    def solve(self, problem: FloorProblem) -> FloorLayout:
        with self.serving:
            return super().solve(over_the_wire(problem))

    def furnish(self, request: FurnishRequest) -> FloorScene:
        with self.serving:
            return super().furnish(over_the_wire(request))


def test_two_builds_at_once_have_each_its_own_assets(tmp_path: Path) -> None:
    def build(name: str) -> BuildResult:
        brief = "a small flat with an espresso bar in the living room"
        job = over_the_wire(BuildJob.of(BuildRequest(description=brief, assets=(write_library(tmp_path / name),))))
        return build_building(job.request(), tmp_path / f"flat_{name}", stages=DistantStages())

    with ThreadPoolExecutor(2) as clients:
        made = list(clients.map(build, ("red", "blue")))
    for name, result in zip(("red", "blue"), made, strict=True):
        assert isinstance(result.report.assets, list)
        assert [use.asset for use in result.report.assets] == [f"{name}.espresso_bar", f"{name}.sofa"]
        assert result.report.faults == []
        assert {file.name.partition(".")[0] for file in (result.path / "assets").iterdir()} == {name}
    assert not any(asset.record for asset in load_catalogue().assets.values())


def test_requests_without_libraries_have_the_bytes_and_the_name_that_they_had() -> None:
    plain = BuildRequest(description="A small flat", seed=3)
    assert b"assets" not in encode_bytes(plain)
    assert building_id_of(plain) == "a-small-flat-8c3972bb"
    assert BuildJob.of(plain).request() == plain
    named = BuildRequest(description="A small flat", seed=3, assets=("shop",))
    assert building_id_of(named) != building_id_of(plain)
    assert over_the_wire(BuildJob.of(named)).request().libraries == ("shop",)
