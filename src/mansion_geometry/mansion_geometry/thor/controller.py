"""AI2-THOR's ``Controller``: the part that is used, how it is started, and how its answers are read."""

import importlib
from collections.abc import Mapping
from typing import Any, Final, Protocol

from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["Controller", "Event", "act", "failure", "first_line", "start_controller"]


PATIENCE: Final = 10.0
"""Seconds that a killed simulator may take to go."""


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


def start_controller(**parameters: Any) -> Controller:
    """Start AI2-THOR.

    Parameters
    ----------
    **parameters
        Passed to ``ai2thor.controller.Controller``: ``width``, ``height``, ``platform="CloudRendering"``, ...

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` when the extra ``thor`` is not installed or the simulator does not start; no process of it is
        left then.
    """
    try:
        module = importlib.import_module("ai2thor.controller")
    except ImportError as error:
        raise MansionError(
            ErrorCode.UNAVAILABLE,
            f"AI2-THOR is not installed ({error}); it is the extra `thor`: pip install 'ai2thor>=5.0'",
            details={"extra": "thor"},
        ) from None
    if isinstance(parameters.get("platform"), str):
        # By its name the client takes a platform too, but then cannot say why it does not serve.
        platforms = importlib.import_module("ai2thor.platform")
        parameters["platform"] = getattr(platforms, parameters["platform"])
    # A constructor that fails half way has the simulator running; only the half-made object knows its process.
    controller: Any = module.Controller.__new__(module.Controller)
    try:
        controller.__init__(**parameters)
    except BaseException as error:
        _end(getattr(controller, "server", None))
        if not isinstance(error, Exception):
            raise
        raise MansionError(
            ErrorCode.UNAVAILABLE,
            f"AI2-THOR does not start: {first_line(str(error)) or type(error).__name__}; its client fetches the "
            "simulator on first use, and the simulator needs Vulkan (platform CloudRendering) or an X display",
            details={"extra": "thor"},
        ) from error
    started: Controller = controller
    return started


def _end(server: Any) -> None:
    """End the simulator's process of a server, and wait until it is gone."""
    if server is None:
        return
    server.stop()
    process = getattr(server, "unity_proc", None)
    if process is not None:
        process.wait(timeout=PATIENCE)


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
        return f"{action}: {first_line(str(error))}"
    return failure(event, action)


def failure(event: Event, action: str) -> str:
    """Return an event's error message, empty when its action succeeded."""
    if event.metadata["lastActionSuccess"]:
        return ""
    return f"{action}: {first_line(str(event.metadata.get('errorMessage') or 'no reason given'))}"


def first_line(message: str) -> str:
    """Return the first line of an error message: Unity appends its stack."""
    return message.strip().partition("\n")[0]
