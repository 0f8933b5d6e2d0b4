"""What is used of AI2-THOR's ``Controller``, and where it comes from."""

import importlib
from collections.abc import Mapping
from typing import Any, Final, Protocol

from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["SETTINGS", "Controller", "Event", "act", "load_house", "open_controller"]

SETTINGS: Final[Mapping[str, Any]] = {
    "agentMode": "default",
    "gridSize": 0.25,
    "snapToGrid": False,
    "visibilityDistance": 2.0,
    "fieldOfView": 90,
}
"""Parameters of each ``reset``: poses are not on a grid, and the hand reaches 1.5 m to the edge of a thing."""


class Event(Protocol):
    """What an action leads to: ``ai2thor.server.Event``."""

    metadata: Mapping[str, Any]


class Controller(Protocol):
    """``ai2thor.controller.Controller``, version 5."""

    last_event: Any

    def reset(self, scene: Any = None, **parameters: Any) -> Any:
        """Load a scene; a dict is a house."""

    def step(self, action: Any = None, **arguments: Any) -> Any:
        """Do one action; ``ValueError`` when the action or its arguments do not exist."""

    def stop(self) -> None:
        """End the simulator's process."""


def open_controller(**parameters: Any) -> Controller:
    """Start AI2-THOR.

    Parameters
    ----------
    **parameters
        Of ``ai2thor.controller.Controller``: ``width``, ``height``, ``platform=CloudRendering``, ...

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` when the extra ``thor`` is not installed.
    """
    try:
        module = importlib.import_module("ai2thor.controller")
    except ImportError as error:
        raise MansionError(
            ErrorCode.UNAVAILABLE,
            f"AI2-THOR is not installed ({error}); pip install 'mansion_skills[thor]'",
        ) from None
    controller: Controller = module.Controller(**{"scene": "Procedural", **SETTINGS, **parameters})
    return controller


def act(controller: Controller, action: str, **arguments: Any) -> str:
    """Do one action.

    Returns
    -------
    str
        Empty, or AI2-THOR's error message.
    """
    try:
        event = controller.step(action=action, **arguments)
    except ValueError as error:
        return f"{action}: {_sentence(str(error))}"
    return _failure(event, action)


def load_house(controller: Controller, house: Mapping[str, Any]) -> str:
    """Reset the controller to a house; return AI2-THOR's error message, empty when the house is there."""
    try:
        event = controller.reset(scene=house, **SETTINGS)
    except (RuntimeError, ValueError) as error:
        return f"CreateHouse: {_sentence(str(error))}"
    return _failure(event, "CreateHouse")


def _failure(event: Event, action: str) -> str:
    """Return an event's error message, empty when its action succeeded."""
    if event.metadata["lastActionSuccess"]:
        return ""
    return f"{action}: {_sentence(str(event.metadata.get('errorMessage') or 'no reason given'))}"


def _sentence(message: str) -> str:
    """Return the first line of an error message: Unity appends its stack."""
    return message.strip().partition("\n")[0]
