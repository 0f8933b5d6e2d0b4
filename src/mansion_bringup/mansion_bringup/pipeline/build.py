"""Algorithm 1: a request becomes a building folder, floor by floor, resumable and repeatable."""

import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import TypeVar

import msgspec

from mansion_assets.catalogue.preferred_folders import preferring
from mansion_assets.library.building_assets import asset_files
from mansion_assets.library.folders import library_folders
from mansion_bringup.building.files import floor_files
from mansion_bringup.building.own_assets import assets_in
from mansion_bringup.building.report import building_index, building_report
from mansion_bringup.building.workspace import Workspace
from mansion_bringup.check import Fault
from mansion_bringup.check.building import in_order
from mansion_bringup.extras import require_extra
from mansion_bringup.pipeline.executors import BuildExecutors, local_executors, service_executors
from mansion_bringup.pipeline.floors import at_stage, distinct_floors, furnish, solve, source_floor
from mansion_bringup.pipeline.stages import LocalStages, Stages
from mansion_bringup.verify import floor_faults, record_faults
from mansion_export.formats import Output, Outputs, formats_of_build, outputs_of_build
from mansion_msgs_py.building import Building, BuildingReport
from mansion_msgs_py.building_folder import INDEX, floor_directory
from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.request import BuildRequest, identified
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.stages import PlanReply
from mansion_msgs_py.wording import counted
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
    """The state of a running build."""

    request: BuildRequest
    folders: tuple[Path, ...]
    stages: Stages
    report: Report
    cancelled: Callable[[], bool]
    outputs: Outputs
    done: int = 0
    total: int = 1
    seconds: dict[str, float] = field(default_factory=dict)

    def step(self, stage: str, message: str, floor: int | None = None, *, done: int = 0) -> None:
        if self.cancelled():
            raise MansionError(ErrorCode.CANCELED, "the build was cancelled")
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

    def rounded_seconds(self) -> dict[str, float]:
        return {name: round(value, 4) for name, value in self.seconds.items()}


def build_building(
    request: BuildRequest,
    output: Path,
    *,
    stages: Stages | None = None,
    exporter: Executor | None = None,
    jobs: int = 1,
    report: Report = lambda progress: None,
    cancelled: Callable[[], bool] = lambda: False,
    formats: Sequence[str] = (),
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
        Floors that are built at once. The result does not depend on it.
    report : callable
        Gets a `Progress` for each step, on the calling thread.
    cancelled : callable
        Asked between steps.
    formats : sequence of str
        Export formats to write beside those that every build writes; see `formats_of_build`.
    force : bool
        Replace a building that holds state of running worlds.

    Raises
    ------
    MansionError
        With the stage that failed in ``details["stage"]``; what is done stays for a later run. ``NOT_FOUND`` for a
        format that does not exist, ``UNAVAILABLE`` for one whose extra is missing.
    """
    request = identified(request)
    folders = library_folders(request.libraries)
    chosen, outputs = _formats(formats)
    job = _Job(request, folders, stages or LocalStages(), report, cancelled, outputs)
    started = time.perf_counter()
    executors = local_executors(jobs, outputs) if stages is None else service_executors(stages, jobs, exporter)
    folder = Workspace(output, request, formats=chosen, force=force)
    with _told_of_killed_workers(), folder as workspace, executors, preferring(folders):
        plan = _plan(job, workspace)
        layouts = _solve(job, workspace, executors, plan)
        scenes = _furnish(job, workspace, executors, plan, layouts)
        own = assets_in(scenes)
        workspace.write(asset_files(own))
        index = building_index(request, plan, scenes, outputs)
        checking = executors.exporter.submit(floor_faults, index.building_id, scenes, plan.topologies)
        _write_building(job, workspace, executors, index, scenes)
        summary = building_report(plan, layouts, scenes, job.seconds, own)
        workspace.write({"report.json": encode_bytes(summary, indent=1)})
        faults = _check(job, workspace, checking, index, layouts, scenes)
        job.timed("total", time.perf_counter() - started)
        summary = msgspec.structs.replace(summary, faults=faults, seconds=job.rounded_seconds())
        workspace.write({"report.json": encode_bytes(summary, indent=1)})
        path = workspace.commit()
    job.step("done", f"wrote {path}", done=1)
    return BuildResult(path, index, summary)


def _formats(names: Sequence[str]) -> tuple[list[str], Outputs]:
    """Return the names of the formats that are written, and what they make."""
    chosen = formats_of_build(names)
    for each in chosen:
        if each.extra:
            require_extra(each.extra)
    return [each.name for each in chosen], outputs_of_build(names)


@contextmanager
def _told_of_killed_workers() -> Iterator[None]:
    try:
        yield
    except BrokenExecutor:
        raise MansionError(
            ErrorCode.UNAVAILABLE,
            "a process of the build was killed, as Linux does when memory runs out; run the build again to continue"
            " with the remaining floors, with --jobs 1 to use the least memory",
        ) from None


def _plan(job: _Job, workspace: Workspace) -> PlanReply:
    job.step("plan_program", "planning the building")
    started = time.perf_counter()
    plan = workspace.load(PlanReply, "plan.json")
    if plan is None:
        plan = at_stage("plan_program", lambda: job.stages.plan(job.request))
        workspace.save("plan.json", plan)
    job.timed("plan_program", time.perf_counter() - started)
    floors = plan.program.floors
    job.total = 2 + len(distinct_floors(plan)) + len(floors)
    rooms = sum(node.type in ("main", "Entities") for graph in plan.topologies for node in graph.nodes)
    job.step("plan_program", f"{counted(len(floors), 'floor')}, {counted(rooms, 'room')}", done=1)
    return plan


def _solve(job: _Job, workspace: Workspace, executors: BuildExecutors, plan: PlanReply) -> list[FloorLayout]:
    layouts: dict[int, FloorLayout] = {}
    futures: dict[int, Future[tuple[bytes, float]]] = {}
    for index in distinct_floors(plan):
        floor = plan.program.floors[index].index
        earlier = workspace.load(FloorLayout, f"{floor_directory(floor)}/layout.json")
        if earlier is not None:
            layouts[index] = earlier
        else:
            futures[index] = executors.pool.submit(_solve_task, executors.remote, plan, index)
    for index in distinct_floors(plan):
        floor = plan.program.floors[index].index
        if index in futures:
            data, seconds = _result(futures, index)
            layouts[index] = decode(FloorLayout, data)
            workspace.write({f"{floor_directory(floor)}/layout.json": data})
            job.timed("solve_floor", seconds)
        job.step("solve_floor", f"floor {floor} laid out", floor, done=1)
    return [
        msgspec.structs.replace(layouts[source_floor(plan, index)], floor=floor.index)
        for index, floor in enumerate(plan.program.floors)
    ]


def _solve_task(stages: Stages | None, plan: PlanReply, index: int) -> tuple[bytes, float]:
    started = time.perf_counter()
    layout = solve(stages or LocalStages(), plan, index)
    return encode_bytes(layout, indent=1), time.perf_counter() - started


def _furnish(
    job: _Job, workspace: Workspace, executors: BuildExecutors, plan: PlanReply, layouts: list[FloorLayout]
) -> list[FloorScene]:
    futures: dict[int, Future[tuple[dict[str, bytes], float, float]]] = {}
    for index, floor in enumerate(plan.program.floors):
        if not workspace.floor_done(floor.index):
            futures[index] = executors.furnish(
                _furnish_task, plan, layouts[index], index, job.outputs.floor, job.request.libraries, job.folders
            )
    scenes = []
    for index, floor in enumerate(plan.program.floors):
        if index in futures:
            files, furnishing, exporting = _result(futures, index)
            workspace.write(files)
            workspace.mark_floor(floor.index)
            job.timed("furnish_floor", furnishing)
            job.timed("export_floor", exporting)
        data = workspace.read(f"{floor_directory(floor.index)}/scene.json")
        scenes.append(decode(FloorScene, data))
        objects = counted(len(scenes[-1].objects), "object")
        job.step("furnish_floor", f"floor {floor.index}: {objects}", floor.index, done=1)
    return scenes


def _furnish_task(
    stages: Stages | None,
    exporter: Executor | None,
    plan: PlanReply,
    layout: FloorLayout,
    index: int,
    outputs: Sequence[Output],
    libraries: Sequence[str],
    folders: Sequence[Path],
) -> tuple[dict[str, bytes], float, float]:
    started = time.perf_counter()
    scene = furnish(stages or LocalStages(), plan, layout, index, libraries)
    furnished = time.perf_counter()
    files = at_stage(
        f"export (floor {scene.floor})",
        lambda: _call(exporter, _preferring, folders, floor_files, plan.topologies[index], layout, scene, outputs),
    )
    return files, furnished - started, time.perf_counter() - furnished


def _preferring(folders: Sequence[Path], make: Callable[..., T], *arguments: object) -> T:
    """Call a function where the build's own assets are preferred, in whatever thread or process it runs."""
    with preferring(folders):
        return make(*arguments)


def _call(exporter: Executor | None, export: Callable[..., dict[str, bytes]], *arguments: object) -> dict[str, bytes]:
    if not isinstance(exporter, ProcessPoolExecutor):
        return export(*arguments)
    return exporter.submit(export, *arguments).result()


def _result(futures: dict[int, Future[T]], index: int) -> T:
    try:
        return futures[index].result()
    except BaseException:
        for future in futures.values():
            future.cancel()
        raise


def _write_building(
    job: _Job, workspace: Workspace, executors: BuildExecutors, index: Building, scenes: list[FloorScene]
) -> None:
    job.step("export", "writing the building")
    started = time.perf_counter()
    futures = [
        executors.exporter.submit(_preferring, job.folders, output.make, scenes) for output in job.outputs.building
    ]
    for made in futures:
        workspace.write(at_stage("export", made.result))
    workspace.write({INDEX: encode_bytes(index, indent=1)})
    job.timed("export_building", time.perf_counter() - started)


def _check(
    job: _Job,
    workspace: Workspace,
    checking: Future[list[Fault]],
    index: Building,
    layouts: Sequence[FloorLayout],
    scenes: Sequence[FloorScene],
) -> list[str]:
    """Return the faults that ``mansion check`` would find."""
    job.step("check", "checking the building")
    started = time.perf_counter()
    faults = at_stage("check", lambda: [*checking.result(), *record_faults(workspace.partial, index, layouts, scenes)])
    job.timed("check", time.perf_counter() - started)
    return [str(fault) for fault in in_order(faults)]
