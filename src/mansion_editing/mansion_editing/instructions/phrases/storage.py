"""The place of what is put away: furniture of its room that such things are kept in."""

from typing import Final

from mansion_editing.instructions.statements import Place, Things

__all__ = ["AWAY", "STORAGE"]

STORAGE: Final = Things(noun="storage furniture")
"""Cupboards, drawers, wardrobes and the like, whichever the room has."""
AWAY: Final = Place(relation="in", anchor=STORAGE)
"""Where ``put the knife away`` brings it."""
