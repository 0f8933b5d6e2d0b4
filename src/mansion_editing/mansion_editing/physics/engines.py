"""The engines by name; each is imported when it is asked for."""

from typing import Final

from mansion_editing.physics.problem import PhysicsEngine
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["ENGINES", "engine_named"]

ENGINES: Final = ("mujoco", "static", "thor")


def engine_named(name: str) -> PhysicsEngine:
    """Return an engine.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for an unknown name.
    """
    if name == "mujoco":
        from mansion_editing.physics.mujoco_engine import MujocoEngine

        return MujocoEngine()
    if name == "static":
        from mansion_editing.physics.static import StaticEngine

        return StaticEngine()
    if name == "thor":
        from mansion_editing.physics.thor_engine import ThorEngine

        return ThorEngine()
    raise MansionError(ErrorCode.NOT_FOUND, f"no physics engine {name!r}; engines are {', '.join(ENGINES)}")
