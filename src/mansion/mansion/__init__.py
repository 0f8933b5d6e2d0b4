"""The front door of Mansion: buildings from one sentence, and robots in them, in a line of Python each.

`build`, `load` and `plan` work in this process; `connect` gives the same names over a running node graph. Everything is
imported when it is first asked for, and `rclpy` by `connect` alone. What goes wrong is a `MansionError` with a code and
a message, as the command line prints them.

Examples
--------
>>> import mansion
>>> plan = mansion.plan("a two-storey house with three bedrooms and a sauna upstairs")
>>> [floor.label for floor in plan.floors]
['G', '2']
>>> [wish.status for wish in plan.wishes.filter(kind="floors")]
['met']
"""

from typing import TYPE_CHECKING, Any

from mansion_msgs_py import __version__

if TYPE_CHECKING:
    from mansion.building import Building
    from mansion.edits import Edit
    from mansion.graph import Graph, connect
    from mansion.making import build, load
    from mansion.parts import Floor, Object, Room
    from mansion.pictures import FloorPlan
    from mansion.plans import Plan, plan
    from mansion.robot import Robot
    from mansion.selections import Floors, Objects, Rooms, Selection, Wishes
    from mansion.worlds import World, WorldBuilding, build_all
    from mansion_bringup.pipeline.build import BuildResult, build_building
    from mansion_msgs_py.building_folder import BuildingFolder
    from mansion_msgs_py.errors import ErrorCode, MansionError
    from mansion_msgs_py.request import BuildRequest
    from mansion_planner.plan import plan_building

__all__ = [
    "BuildRequest",
    "BuildResult",
    "Building",
    "BuildingFolder",
    "Edit",
    "ErrorCode",
    "Floor",
    "FloorPlan",
    "Floors",
    "Graph",
    "MansionError",
    "Object",
    "Objects",
    "Plan",
    "Robot",
    "Room",
    "Rooms",
    "Selection",
    "Wishes",
    "World",
    "WorldBuilding",
    "__version__",
    "build",
    "build_all",
    "build_building",
    "connect",
    "load",
    "plan",
    "plan_building",
]


_HOMES = {
    "BuildRequest": "mansion_msgs_py.request",
    "BuildResult": "mansion_bringup.pipeline.build",
    "Building": "mansion.building",
    "BuildingFolder": "mansion_msgs_py.building_folder",
    "Edit": "mansion.edits",
    "ErrorCode": "mansion_msgs_py.errors",
    "Floor": "mansion.parts",
    "FloorPlan": "mansion.pictures",
    "Floors": "mansion.selections",
    "Graph": "mansion.graph",
    "MansionError": "mansion_msgs_py.errors",
    "Object": "mansion.parts",
    "Objects": "mansion.selections",
    "Plan": "mansion.plans",
    "Robot": "mansion.robot",
    "Room": "mansion.parts",
    "Rooms": "mansion.selections",
    "Selection": "mansion.selections",
    "Wishes": "mansion.selections",
    "World": "mansion.worlds",
    "WorldBuilding": "mansion.worlds",
    "build": "mansion.making",
    "build_all": "mansion.worlds",
    "build_building": "mansion_bringup.pipeline.build",
    "connect": "mansion.graph",
    "load": "mansion.making",
    "plan": "mansion.plans",
    "plan_building": "mansion_planner.plan",
}


def __getattr__(name: str) -> Any:
    # Imported when first asked for: a script that only reads a building does not load the solver.
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(_HOMES[name]), name)


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
