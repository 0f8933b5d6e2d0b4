"""The environment's name in Gymnasium; imported by Gymnasium itself, so it brings nothing else with it."""

from typing import Final

__all__ = ["ENV_ID", "register_environments"]

ENV_ID: Final = "mansion/Building-v0"


def register_environments() -> None:
    """Register `ENV_ID` with Gymnasium, unless that has been done."""
    from gymnasium.envs.registration import register, registry

    if ENV_ID not in registry:
        register(id=ENV_ID, entry_point="mansion_tasks.env.building_env:BuildingEnv")
