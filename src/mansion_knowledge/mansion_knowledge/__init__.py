"""What is known of buildings, rooms and materials: validated data files, open to the user's own."""

from mansion_knowledge.base import KnowledgeBase, default_knowledge, load_knowledge
from mansion_knowledge.room_names import interchangeable_names, is_class, kin_of, name_groups, uses_of, words_by
from mansion_knowledge.types import BuildingType, RoomEntry, RoomType, RoomWord, Style

__all__ = [
    "BuildingType",
    "KnowledgeBase",
    "RoomEntry",
    "RoomType",
    "RoomWord",
    "Style",
    "default_knowledge",
    "interchangeable_names",
    "is_class",
    "kin_of",
    "load_knowledge",
    "name_groups",
    "uses_of",
    "words_by",
]
