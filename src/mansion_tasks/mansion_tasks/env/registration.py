"""The names of the environments in Gymnasium; imported by Gymnasium itself, so it brings nothing else with it."""

from typing import Final

__all__ = ["BUILDINGS_ENV_ID", "ENV_ID", "register_environments"]

ENV_ID: Final = "mansion/Building-v0"
BUILDINGS_ENV_ID: Final = "mansion/Buildings-v0"


def register_environments() -> None:
    """Register both with Gymnasium, unless that has been done."""
    from gymnasium.envs.registration import register, registry

    if ENV_ID not in registry:
        register(id=ENV_ID, entry_point="mansion_tasks.env.building_env:BuildingEnv")
        register(id=BUILDINGS_ENV_ID, entry_point="mansion_tasks.env.buildings_env:BuildingsEnv")
