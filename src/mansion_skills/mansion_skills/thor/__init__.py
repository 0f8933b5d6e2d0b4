"""AI2-THOR under the same skills: `ThorGym` drives a controller with them and reads back what became of it.

AI2-THOR is the optional extra ``thor``; nothing here imports it before `open_controller` is called.
"""

from mansion_skills.thor.engine import open_controller
from mansion_skills.thor.gym import ThorGym

__all__ = ["ThorGym", "open_controller"]
