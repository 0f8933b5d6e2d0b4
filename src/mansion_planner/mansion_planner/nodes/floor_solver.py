"""``floor_solver``: Algorithm 2 as a service; each layout is also published, latched."""

from collections.abc import Sequence

from rcl_interfaces.msg import IntegerRange, ParameterDescriptor
from rclpy.callback_groups import ReentrantCallbackGroup

from mansion_msgs_py.interfaces import service, topic
from mansion_msgs_py.layout import FloorLayout, FloorProblem
from mansion_msgs_py.nodes.node import MansionNode
from mansion_msgs_py.nodes.run import run_node
from mansion_msgs_py.nodes.shell import JsonPublisher, add_json_service
from mansion_planner.solver import SolverOptions, solve_floor, warm

__all__ = ["FloorSolver", "main"]


class FloorSolver(MansionNode):
    """Serves ``solve_floor`` and publishes ``floor_layout``."""

    def __init__(self) -> None:
        super().__init__("floor_solver")
        defaults = SolverOptions()
        self._integer("retries", defaults.retries, 1, "retries of a cutting node, N_retry", 1000)
        self._integer("batch", defaults.batch, 1, "local candidates of a retry, B", 10_000)
        self._integer(
            "candidates", defaults.candidates, 1, "most candidate layouts looked at for one floor", 1_000_000_000
        )
        self._layouts = JsonPublisher(self, topic("floor_layout"))
        self.get_logger().info(
            "loading the solver's kernels; after an installation they are compiled first, for a minute"
        )
        warm()
        self.get_logger().info("ready")
        add_json_service(self, service("solve_floor"), self.solve, callback_group=ReentrantCallbackGroup())

    def _integer(self, name: str, default: int, least: int, what: str, most: int) -> None:
        self.declare_parameter(
            name,
            default,
            ParameterDescriptor(
                description=what, integer_range=[IntegerRange(from_value=least, to_value=most, step=1)]
            ),
        )

    def solve(self, problem: FloorProblem) -> FloorLayout:
        """Lay out one floor with the node's present parameters and publish the result."""
        options = SolverOptions(
            retries=int(self.get_parameter("retries").value),
            batch=int(self.get_parameter("batch").value),
            candidates=int(self.get_parameter("candidates").value),
        )
        layout = solve_floor(problem, options=options)
        self._layouts.publish(layout)
        self.get_logger().info(
            f"floor {layout.floor}: {len(layout.rooms)} rooms, {len(layout.unmet_edges)} unmet edges"
        )
        return layout


def main(args: Sequence[str] | None = None) -> None:
    """Run the node."""
    run_node(FloorSolver, args)


if __name__ == "__main__":
    main()
