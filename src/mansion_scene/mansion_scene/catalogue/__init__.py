"""The asset catalogue: categories, sizes, properties, and the object programs of room types."""

from mansion_scene.catalogue.asset import Asset, Surface, Volume
from mansion_scene.catalogue.catalogue import Catalogue, RoomProgramCard
from mansion_scene.catalogue.furnish import furnish_request
from mansion_scene.catalogue.furnishing import HangWish, RoomFurnishing, RugWish
from mansion_scene.catalogue.loading import load_catalogue

__all__ = [
    "Asset",
    "Catalogue",
    "HangWish",
    "RoomFurnishing",
    "RoomProgramCard",
    "RugWish",
    "Surface",
    "Volume",
    "furnish_request",
    "load_catalogue",
]
