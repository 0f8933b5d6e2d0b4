"""The program planner's node: service ``plan_program``, topic ``program``."""

from pathlib import Path

from rcl_interfaces.msg import ParameterDescriptor

from mansion_knowledge import load_knowledge
from mansion_msgs_py.interfaces import service, topic
from mansion_msgs_py.nodes.node import MansionNode
from mansion_msgs_py.nodes.run import run_node
from mansion_msgs_py.nodes.shell import JsonPublisher, add_json_service
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.stages import PlanReply
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
        add_json_service(self, service("plan_program"), self.plan)

    def plan(self, request: BuildRequest) -> PlanReply:
        """Plan a building and publish its program."""
        reply = plan_building(request, knowledge=self.knowledge, cancelled=lambda: not self.context.ok())
        self.programs.publish(reply.program)
        return reply


def main() -> None:
    """Run the node until it is told to end."""
    run_node(ProgramPlannerNode)


if __name__ == "__main__":
    main()
