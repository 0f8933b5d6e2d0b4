"""``building_director``: Algorithm 1 by service calls to the other nodes."""

import os
import threading
from collections.abc import Callable, Sequence
from concurrent.futures import BrokenExecutor, ProcessPoolExecutor
from contextlib import suppress
from pathlib import Path

from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor
from rclpy.callback_groups import ReentrantCallbackGroup

from mansion_bringup.client import MansionClient
from mansion_bringup.graph.resident_client import ResidentClient
from mansion_bringup.pipeline.build import BuildResult, build_building
from mansion_bringup.pipeline.executors import export_pool
from mansion_bringup.pipeline.stages import RemoteStages
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.interfaces import service, topic
from mansion_msgs_py.nodes.allowed_folders import declare_allowed_folders
from mansion_msgs_py.nodes.node import MansionNode
from mansion_msgs_py.nodes.run import run_node
from mansion_msgs_py.nodes.shell import JsonPublisher, add_json_service, add_json_subscription, run_handler
from mansion_msgs_py.request import BuildRequest, identified
from mansion_msgs_py.running_calls import RunningCalls
from mansion_msgs_py.stages import BuildInWork, BuildJob, BuildReply, CancelBuild, CanceledBuilds, CancelPlan
from mansion_msgs_py.workers import release_memory

__all__ = ["BuildingDirector", "main"]

MAX_BUILDS = 4

EXPORTERS = min(os.cpu_count() or 1, MAX_BUILDS)
"""Processes for the exports of all builds."""

_RENEWED_AFTER = 24
"""Builds after which the export processes are started anew: what they remember of meshes grows for hundreds of them."""


class BuildingDirector(MansionNode):
    """Serves ``build_building`` and builds what is published on ``build_requests``."""

    def __init__(self) -> None:
        super().__init__("building_director")
        self.declare_parameter(
            "output_root", "buildings", ParameterDescriptor(description="folder for buildings whose request names none")
        )
        self.declare_parameter(
            "stage_timeout",
            120.0,
            ParameterDescriptor(
                description="seconds that one stage of one floor may take",
                floating_point_range=[FloatingPointRange(from_value=0.1, to_value=86_400.0)],
            ),
        )
        self.declare_parameter(
            "floors_at_once",
            2,
            ParameterDescriptor(
                description="floors of one building worked on at the same time",
                integer_range=[IntegerRange(from_value=1, to_value=64, step=1)],
            ),
        )
        self.declare_parameter(
            "lend_client",
            False,
            ParameterDescriptor(
                description="take the calls of `mansion call` by a socket that is this user's alone", read_only=True
            ),
        )
        self._allowed = declare_allowed_folders(self, self._root())
        self._progress = JsonPublisher(self, topic("progress"))
        self._guard = threading.Lock()
        self._exporter = _exports()
        self._built_since = 0
        self._builds = RunningCalls[BuildInWork]("builds", MAX_BUILDS)
        self._stages = MansionClient(domain_id=self.context.get_domain_id(), namespace=self.get_namespace())
        group = ReentrantCallbackGroup()
        add_json_service(self, service("build_building"), self.build, callback_group=group)
        add_json_service(self, service("cancel_build"), self.cancel, callback_group=group)
        add_json_subscription(self, topic("build_requests"), self._build_from_topic, callback_group=group)
        self._resident: ResidentClient | None = None
        if self.get_parameter("lend_client").value:
            self._resident = self._lent()

    def _lent(self) -> ResidentClient | None:
        """Lend the client where a socket can be made; the node serves as well without."""
        try:
            return ResidentClient(self.get_namespace(), self._stages)
        except OSError as error:
            self.get_logger().warning(
                f"cannot lend the client, so each `mansion call` starts a participant of its own: {error}"
            )
            return None

    def build(self, job: BuildJob) -> BuildReply:
        """Build one building; at most `MAX_BUILDS` at the same time."""
        request = identified(job.request())
        output = self._output(job, request)
        work = BuildInWork(building_id=request.building_id or "", path=os.path.abspath(output))
        try:
            with self._builds.begun(work) as asked_to_end:
                result = self._built(job, request, output, lambda: asked_to_end.is_set() or not self.context.ok())
        except MansionError as error:
            if error.code in (ErrorCode.CANCELED, ErrorCode.TIMEOUT):
                self._give_up_plan(work.building_id)
            raise
        finally:
            self._release_memory()
        self.get_logger().info(f"wrote {result.path}")
        return BuildReply(building=result.building, path=str(result.path))

    def _built(self, job: BuildJob, request: BuildRequest, output: Path, cancelled: Callable[[], bool]) -> BuildResult:
        timeout = self.get_parameter("stage_timeout").value or 120.0
        return build_building(
            request,
            output,
            stages=RemoteStages(self._stages, timeout, cancelled=cancelled),
            exporter=self._working_exporter(),
            jobs=self.get_parameter("floors_at_once").value or 1,
            report=self._progress.publish,
            formats=job.formats,
            force=job.force,
            cancelled=cancelled,
        )

    def cancel(self, arguments: CancelBuild) -> CanceledBuilds:
        """Ask the builds of a building id, into a folder, or all running ones, to end."""
        path = None if arguments.output is None else os.path.abspath(_expanded(arguments.output))

        def chosen(build: BuildInWork) -> bool:
            return arguments.building_id in (None, build.building_id) and path in (None, build.path)

        return CanceledBuilds(builds=self._builds.cancel(chosen))

    def _give_up_plan(self, building_id: str) -> None:
        """Have the planner give up a plan that no build waits for any more."""
        if self.context.ok() and not self._builds.any(lambda build: build.building_id == building_id):
            with suppress(MansionError):
                self._stages.call("cancel_plan", CancelPlan(building_id=building_id), timeout=1.0, wait=0.0)

    def _working_exporter(self) -> ProcessPoolExecutor:
        """Return the export processes, restarted if one of them was killed: the pool refuses all work then."""
        with self._guard:
            try:
                self._exporter.submit(os.getpid)
            except BrokenExecutor:
                self._exporter = _exports()
            return self._exporter

    def _release_memory(self) -> None:
        """Have the export processes give back what the last build took, by new ones from time to time."""
        with self._guard, suppress(BrokenExecutor, RuntimeError):
            self._built_since += 1
            if self._built_since >= _RENEWED_AFTER and not self._builds.any(lambda build: True):
                self._exporter.shutdown(wait=False)
                self._exporter, self._built_since = _exports(), 0
            for _ in range(EXPORTERS):
                self._exporter.submit(release_memory)

    def _output(self, job: BuildJob, request: BuildRequest) -> Path:
        """Return the folder of a building, which lies where this node may write."""
        if job.output is not None:
            output = _expanded(job.output)
        else:
            output = _expanded(self._root()) / (request.building_id or "building")
        self._allowed.check(output, "$.output")
        return output

    def _root(self) -> str:
        return str(self.get_parameter("output_root").value or "buildings")

    def _build_from_topic(self, request: BuildRequest) -> None:
        run_handler(self, "build_requests", lambda: self.build(BuildJob.of(request)))

    def destroy_node(self) -> None:
        """End the client of the stages and the export processes, then the node."""
        self._exporter.shutdown(wait=False, cancel_futures=True)
        if self._resident is not None:
            self._resident.close()
        self._stages.close()
        super().destroy_node()


def _expanded(name: str) -> Path:
    try:
        return Path(name).expanduser()
    except RuntimeError:
        raise MansionError(ErrorCode.NOT_FOUND, f"{name[:200]}: there is no such user", path="$.output") from None


def _exports() -> ProcessPoolExecutor:
    return export_pool(EXPORTERS)


def main(args: Sequence[str] | None = None) -> None:
    """Run the node."""
    run_node(BuildingDirector, args, threads=2 * MAX_BUILDS + 2)


if __name__ == "__main__":
    main()
