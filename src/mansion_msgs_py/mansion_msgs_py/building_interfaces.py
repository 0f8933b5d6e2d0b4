"""Topics and services of the stages and of the director (Algorithm 1)."""

from mansion_msgs_py.interface_types import LATCHED, ServiceInterface, TopicInterface
from mansion_msgs_py.layout import FloorLayout, FloorProblem
from mansion_msgs_py.program import BuildingProgram
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.stages import BuildJob, BuildReply, FurnishRequest, PlanReply
from mansion_msgs_py.world import Progress

__all__ = ["SERVICES", "TOPICS"]

TOPICS: tuple[TopicInterface, ...] = (
    TopicInterface(
        "build_requests", "building_director", "A request to build; the answer comes as latched results.", BuildRequest
    ),
    TopicInterface("program", "program_planner", "The program of each building.", BuildingProgram, qos=LATCHED),
    TopicInterface("floor_layout", "floor_solver", "The layout of each floor.", FloorLayout, qos=LATCHED),
    TopicInterface(
        "floor_scene",
        "object_placer",
        "The furnished floor, one message a floor; from `scene_editor` again after an edit.",
        FloorScene,
        qos=LATCHED,
    ),
    TopicInterface("progress", "building_director", "How far a job is.", Progress),
    TopicInterface(
        "/diagnostics",
        "every node",
        "What each node does and how many calls it served, once a second.",
        type="diagnostic_msgs/msg/DiagnosticArray",
    ),
)

SERVICES: tuple[ServiceInterface, ...] = (
    ServiceInterface(
        "plan_program",
        "program_planner",
        "Program, room graphs and solver problems of a request.",
        BuildRequest,
        PlanReply,
        '{"description": "a two-storey library"}',
    ),
    ServiceInterface(
        "solve_floor",
        "floor_solver",
        "The layout of one floor.",
        FloorProblem,
        FloorLayout,
        '{"boundary": [[0,0],[6,0],[6,4],[0,4]], "nodes": [{"id": "hall", "type": "main"}]}',
    ),
    ServiceInterface("furnish_floor", "object_placer", "The furnished scene of one floor.", FurnishRequest, FloorScene),
    ServiceInterface(
        "build_building",
        "building_director",
        "A whole building, written to a folder.",
        BuildJob,
        BuildReply,
        '{"description": "a small flat", "output": "/tmp/flat"}',
    ),
)
