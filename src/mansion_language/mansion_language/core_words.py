"""Words for stairs and lifts."""

from typing import Final

__all__ = ["CORE_WORDS"]

CORE_WORDS: Final = {"elevator": "elevator", "lift": "elevator", "stairs": "stair", "stair": "stair"}
"""Words for a vertical core, and the name that plans have for its kind."""
