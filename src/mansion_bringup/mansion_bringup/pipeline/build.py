"""Algorithm 1: a request becomes a building folder, floor by floor, resumable and repeatable."""

import time
from collections.abc import Callable
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from typing import TypeVar

import msgspec

from mansion_bringup.building.files import floor_files
from mansion_bringup.building.report import building_index, building_report
from mansion_bringup.building.workspace import Workspace
from mansion_bringup.pipeline import floors as steps
from mansion_bringup.pipeline.crew import Crew, local_crew, remote_crew
from mansion_bringup.pipeline.stages import LocalStages, Stages
from mansion_export.formats import built_building_outputs
from mansion_msgs_py.building import Building, BuildingReport
from mansion_msgs_py.building_folder import floor_directory
from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.request import BuildRequest, identified
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.stages import PlanReply
from mansion_msgs_py.world import Progress

__all__ = ["BuildResult", "build_building"]

T = TypeVar("T")

Report = Callable[[Progress], None]


@dataclass(frozen=True)
class BuildResult:
    """A finished building and where it is."""

    path: Path
    building: Building
    report: BuildingReport


@dataclass
class _Job:
    request: BuildRequest
    stages: Stages
    report: Report
    cancelled: Callable[[], bool]
    done: int = 0
    total: int = 1
    seconds: dict[str, float] = field(default_factory=dict)

    def step(self, stage: str, message: str, floor: int | None = None, *, done: int = 0) -> None:
        if self.cancelled():
            raise MansionError(ErrorCode.CANCELED, "the build was ended at the caller's wish")
        self.done += done
        self.report(
            Progress(
                stage=stage,
                message=message,
                done=self.done,
                total=self.total,
                floor=floor,
                building_id=self.request.building_id or "",
            )
        )

    def timed(self, stage: str, seconds: float) -> None:
        self.seconds[stage] = self.seconds.get(stage, 0.0) + seconds


def build_building(
    request: BuildRequest,
    output: Path,
    *,
    stages: Stages | None = None,
    exporter: Executor | None = None,
    jobs: int = 1,
    report: Report = lambda progress: None,
    cancelled: Callable[[], bool] = lambda: False,
    force: bool = False,
) -> BuildResult:
    """Build and write a building.

    Parameters
    ----------
    request : BuildRequest
    output : Path
        Folder to write; appears whole or not at all.
    stages : Stages, optional
        Where the stages run; in this process (or `jobs` processes) when absent.
    exporter : Executor, optional
        Processes for the exports, where `stages` are behind services.
    jobs : int
        Floors in work at once. The result does not depend on it.
    report : callable
        Gets a `Progress` for each step, on the calling thread.
    cancelled : callable
        Asked between steps.
    force : bool
        Replace a building that holds state of running worlds.

    Raises
    ------
    MansionError
        With the stage that failed in ``details["stage"]``. What is done stays for a later run.
    """
    request = identified(request)
    job = _Job(request, stages or LocalStages(), report, cancelled)
    started = time.perf_counter()
    crew = local_crew(jobs) if stages is None else remote_crew(stages, jobs, exporter)
    with Workspace(output, request, force=force) as workspace, crew:
        plan = _plan(job, workspace)
        layouts = _solve(job, workspace, crew, plan)
        scenes = _furnish(job, workspace, crew, plan, layouts)
        index = building_index(request, plan, scenes)
        _write_building(job, workspace, crew, index, scenes)
        job.timed("total", time.perf_counter() - started)
        summary = building_report(plan, layouts, scenes, job.seconds)
        workspace.write({"report.json": encode_bytes(summary, indent=1)})
        path = workspace.commit()
    job.step("done", f"wrote {path}", done=1)
    return BuildResult(path, index, summary)


def _plan(job: _Job, workspace: Workspace) -> PlanReply:
    job.step("plan_program", "planning the building")
    started = time.perf_counter()
    plan = workspace.load(PlanReply, "plan.json")
    if plan is None:
        plan = steps.at_stage("plan_program", lambda: job.stages.plan(job.request))
        workspace.save("plan.json", plan)
    job.timed("plan_program", time.perf_counter() - started)
    floors = plan.program.floors
    job.total = 2 + len(steps.distinct_floors(plan)) + len(floors)
    rooms = sum(node.type in ("main", "Entities") for graph in plan.topologies for node in graph.nodes)
    storeys = f"{len(floors)} floor{'s' if len(floors) != 1 else ''}"
    job.step("plan_program", f"{storeys}, {rooms} rooms", done=1)
    return plan


def _solve(job: _Job, workspace: Workspace, crew: Crew, plan: PlanReply) -> list[FloorLayout]:
    found: dict[int, FloorLayout] = {}
    waiting: dict[int, Future[tuple[bytes, float]]] = {}
    for index in steps.distinct_floors(plan):
        floor = plan.program.floors[index].index
        earlier = workspace.load(FloorLayout, f"{floor_directory(floor)}/layout.json")
        if earlier is not None:
            found[index] = earlier
        else:
            waiting[index] = crew.pool.submit(_solve_task, crew.remote, plan, index)
    for index in steps.distinct_floors(plan):
        floor = plan.program.floors[index].index
        if index in waiting:
            data, seconds = _result(waiting, index)
            found[index] = decode(FloorLayout, data)
            workspace.write({f"{floor_directory(floor)}/layout.json": data})
            job.timed("solve_floor", seconds)
        job.step("solve_floor", f"floor {floor} laid out", floor, done=1)
    return [found[steps.source_floor(plan, index)] for index in range(len(plan.program.floors))]


def _solve_task(stages: Stages | None, plan: PlanReply, index: int) -> tuple[bytes, float]:
    started = time.perf_counter()
    layout = steps.solve(stages or LocalStages(), plan, index)
    return encode_bytes(layout, indent=1), time.perf_counter() - started


def _furnish(
    job: _Job, workspace: Workspace, crew: Crew, plan: PlanReply, layouts: list[FloorLayout]
) -> list[FloorScene]:
    waiting: dict[int, Future[tuple[dict[str, bytes], float, float]]] = {}
    for index, floor in enumerate(plan.program.floors):
        if not workspace.floor_done(floor.index):
            waiting[index] = crew.furnish(_furnish_task, plan, layouts[index], index)
    scenes = []
    for index, floor in enumerate(plan.program.floors):
        if index in waiting:
            files, furnishing, exporting = _result(waiting, index)
            workspace.write(files)
            workspace.mark_floor(floor.index)
            job.timed("furnish_floor", furnishing)
            job.timed("export_floor", exporting)
        data = workspace.read(f"{floor_directory(floor.index)}/scene.json")
        scenes.append(decode(FloorScene, data))
        count = len(scenes[-1].objects)
        job.step("furnish_floor", f"floor {floor.index}: {count} objects", floor.index, done=1)
    return scenes


def _furnish_task(
    stages: Stages | None, exporter: Executor | None, plan: PlanReply, layout: FloorLayout, index: int
) -> tuple[dict[str, bytes], float, float]:
    started = time.perf_counter()
    layout = msgspec.structs.replace(layout, floor=plan.program.floors[index].index)
    scene = steps.furnish(stages or LocalStages(), plan, layout, index)
    furnished = time.perf_counter()
    files = steps.at_stage(
        f"export (floor {scene.floor})", lambda: _call(exporter, floor_files, plan.topologies[index], layout, scene)
    )
    return files, furnished - started, time.perf_counter() - furnished


def _call(exporter: Executor | None, export: Callable[..., dict[str, bytes]], *arguments: object) -> dict[str, bytes]:
    if not isinstance(exporter, ProcessPoolExecutor):
        return export(*arguments)
    return exporter.submit(export, *arguments).result()


def _result(waiting: dict[int, Future[T]], index: int) -> T:
    try:
        return waiting[index].result()
    except BaseException:
        for future in waiting.values():
            future.cancel()
        raise


def _write_building(job: _Job, workspace: Workspace, crew: Crew, index: Building, scenes: list[FloorScene]) -> None:
    job.step("export", "writing the 3D building")
    started = time.perf_counter()
    waiting = [crew.exporter.submit(output.make, scenes) for output in built_building_outputs()]
    for made in waiting:
        workspace.write(steps.at_stage("export", made.result))
    workspace.write({"building.json": encode_bytes(index, indent=1)})
    job.timed("export_building", time.perf_counter() - started)
