"""The front door of Mansion: what a script imports to plan, build and read buildings.

>>> import mansion
>>> request = mansion.BuildRequest(description="a small flat for two")
>>> [floor.index for floor in mansion.plan_building(request).program.floors]
[1]
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from mansion_bringup.pipeline.build import BuildResult, build_building
    from mansion_msgs_py.building_folder import BuildingFolder
    from mansion_msgs_py.errors import MansionError
    from mansion_msgs_py.request import BuildRequest
    from mansion_planner.plan import plan_building

__all__ = ["BuildRequest", "BuildResult", "BuildingFolder", "MansionError", "build_building", "plan_building"]

__version__ = "0.1.0"

_HOMES = {
    "BuildRequest": "mansion_msgs_py.request",
    "BuildResult": "mansion_bringup.pipeline.build",
    "BuildingFolder": "mansion_msgs_py.building_folder",
    "MansionError": "mansion_msgs_py.errors",
    "build_building": "mansion_bringup.pipeline.build",
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
