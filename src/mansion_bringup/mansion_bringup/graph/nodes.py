"""Which nodes make up the graph, and what shows that each is ready."""

from dataclasses import dataclass

__all__ = ["GRAPH_NODES", "NodeProcess"]


@dataclass(frozen=True)
class NodeProcess:
    """A node of the graph: `package` and `executable` are those of ``ros2 run``."""

    package: str
    executable: str
    service: str

    @property
    def module(self) -> str:
        """The Python module that ``python -m`` runs."""
        return f"{self.package}.nodes.{self.executable}"


GRAPH_NODES: tuple[NodeProcess, ...] = (
    NodeProcess("mansion_planner", "program_planner", "plan_program"),
    NodeProcess("mansion_planner", "floor_solver", "solve_floor"),
    NodeProcess("mansion_scene", "object_placer", "furnish_floor"),
    NodeProcess("mansion_editing", "scene_editor", "scene/open"),
    NodeProcess("mansion_skills", "skill_server", "load_building"),
    NodeProcess("mansion_bringup", "building_director", "build_building"),
)
