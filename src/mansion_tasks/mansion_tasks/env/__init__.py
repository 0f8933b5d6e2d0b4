"""A Gymnasium environment: a robot with a task in a building.

Importing this package registers ``mansion/Building-v0`` and ``mansion/Buildings-v0``; where the package is installed,
Gymnasium does so itself.
"""

from importlib.util import find_spec

from mansion_tasks.env.registration import BUILDINGS_ENV_ID, ENV_ID, register_environments

__all__ = ["BUILDINGS_ENV_ID", "ENV_ID", "register_environments"]

if find_spec("gymnasium") is not None:
    register_environments()
