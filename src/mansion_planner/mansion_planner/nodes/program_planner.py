"""The program planner's node: service ``plan_program``, topic ``program``."""

from pathlib import Path

from rcl_interfaces.msg import ParameterDescriptor
from rclpy.callback_groups import ReentrantCallbackGroup

from mansion_knowledge import load_knowledge
from mansion_msgs_py.interfaces import service, topic
from mansion_msgs_py.nodes.node import MansionNode
from mansion_msgs_py.nodes.run import run_node
from mansion_msgs_py.nodes.shell import JsonPublisher, add_json_service
from mansion_msgs_py.request import BuildRequest, building_id_of
from mansion_msgs_py.running_calls import RunningCalls
from mansion_msgs_py.stages import CanceledPlans, CancelPlan, PlanReply
from mansion_planner.plan import plan_building

__all__ = ["ProgramPlannerNode", "main"]


class ProgramPlannerNode(MansionNode):
    """Plans a building for each request, and publishes its program."""

    def __init__(self) -> None:
        super().__init__("program_planner")
        self.declare_parameter(
            "knowledge",
            "",
            ParameterDescriptor(
                description="Folder whose room_types.csv, building_types.toml and styles.toml extend Mansion's own",
                read_only=True,
            ),
        )
        folder = str(self.get_parameter("knowledge").value or "")
        self.knowledge = load_knowledge([Path(folder)] if folder else [])
        self.programs = JsonPublisher(self, topic("program"))
        self._plans = RunningCalls[str]("plans")
        add_json_service(self, service("plan_program"), self.plan)
        add_json_service(self, service("cancel_plan"), self.cancel, callback_group=ReentrantCallbackGroup())

    def plan(self, request: BuildRequest) -> PlanReply:
        """Plan a building and publish its program."""
        with self._plans.begun(building_id_of(request)) as asked_to_end:
            reply = plan_building(
                request, knowledge=self.knowledge, cancelled=lambda: asked_to_end.is_set() or not self.context.ok()
            )
        self.programs.publish(reply.program)
        return reply

    def cancel(self, arguments: CancelPlan) -> CanceledPlans:
        """Ask the running plan to end, if it is for the building that is named."""
        plans = self._plans.cancel(lambda plan: arguments.building_id in (None, plan))
        return CanceledPlans(plans=plans)


def main() -> None:
    """Run the node until it is told to end."""
    run_node(ProgramPlannerNode)


if __name__ == "__main__":
    main()
