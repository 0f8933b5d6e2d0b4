"""The robot in the building: world state, navigation, skills and camera.

The world is a scene plus an overlay of what the robots did; a skill runs in steps, and the world is consistent at each.
`Robot` drives one from a script, `nodes` holds the thin ROS 2 node.
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from mansion_skills.robot import Robot

__all__ = ["Robot"]


def __getattr__(name: str) -> Any:
    """Import `Robot` when it is asked for: it brings compiled kernels with it."""
    if name == "Robot":
        from mansion_skills.robot import Robot

        return Robot
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
