"""The asset catalogue: categories, sizes, properties, and the object programs of room types."""

from mansion_assets.catalogue.asset import Asset, Surface, Volume
from mansion_assets.catalogue.catalogue import Catalogue, RoomProgramCard
from mansion_assets.catalogue.furnish import HangRequest, RoomFurnishing, RugRequest, furnish_request
from mansion_assets.catalogue.loading import load_catalogue
from mansion_assets.catalogue.preferred_folders import preferred_folders, preferring

__all__ = [
    "Asset",
    "Catalogue",
    "HangRequest",
    "RoomFurnishing",
    "RoomProgramCard",
    "RugRequest",
    "Surface",
    "Volume",
    "furnish_request",
    "load_catalogue",
    "preferred_folders",
    "preferring",
]
