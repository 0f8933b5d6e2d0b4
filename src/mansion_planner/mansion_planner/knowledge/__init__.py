"""What the planner knows about buildings, rooms and materials: validated data files, open to the user's own."""

from mansion_planner.knowledge.base import KnowledgeBase, default_knowledge, load_knowledge
from mansion_planner.knowledge.types import BuildingType, RoomEntry, RoomType, Style

__all__ = [
    "BuildingType",
    "KnowledgeBase",
    "RoomEntry",
    "RoomType",
    "Style",
    "default_knowledge",
    "load_knowledge",
]
