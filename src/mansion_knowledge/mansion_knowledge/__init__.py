"""What the planner knows about buildings, rooms and materials: validated data files, open to the user's own."""

from mansion_knowledge.base import KnowledgeBase, default_knowledge, load_knowledge
from mansion_knowledge.types import BuildingType, RoomEntry, RoomType, Style

__all__ = ["BuildingType", "KnowledgeBase", "RoomEntry", "RoomType", "Style", "default_knowledge", "load_knowledge"]

__version__ = "0.1.0"
