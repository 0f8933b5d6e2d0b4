"""The controller of AI2-THOR with the settings of the skills."""

from collections.abc import Mapping
from typing import Any, Final

from mansion_geometry.thor.controller import Controller, failure, first_line, start_controller

__all__ = ["SETTINGS", "load_house", "open_controller"]

SETTINGS: Final[Mapping[str, Any]] = {
    "agentMode": "default",
    "gridSize": 0.25,
    "snapToGrid": False,
    "visibilityDistance": 2.0,
    "fieldOfView": 90,
}
"""Parameters of each ``reset``: poses are not on a grid, and the hand reaches 1.5 m to the edge of a thing."""


def open_controller(**parameters: Any) -> Controller:
    """Start AI2-THOR with an empty procedural scene.

    Parameters
    ----------
    **parameters
        Of ``ai2thor.controller.Controller``: ``width``, ``height``, ``platform=CloudRendering``, ...

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` when the extra ``thor`` is not installed or the simulator does not start.
    """
    return start_controller(**{"scene": "Procedural", **SETTINGS, **parameters})


def load_house(controller: Controller, house: Mapping[str, Any]) -> str:
    """Reset the controller to a house; return AI2-THOR's error message, empty when the house is there."""
    try:
        event = controller.reset(scene=house, **SETTINGS)
    except (RuntimeError, ValueError) as error:
        return f"CreateHouse: {first_line(str(error))}"
    return failure(event, "CreateHouse")
