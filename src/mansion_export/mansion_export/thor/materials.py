"""AI2-THOR's materials, sky boxes and room types for ours."""

from typing import Any

from mansion_export.appearance import hex_color
from mansion_scene.structure.materials import library, match_material

__all__ = ["SKYBOXES", "ceiling_material", "floor_material", "room_type", "wall_material"]

SKYBOXES: tuple[tuple[str, str, str], ...] = (
    ("noon", "Midday", "Sky1"),
    ("morning", "Midday", "SkyMountain"),
    ("sunset", "GoldenHour", "SkySunset"),
    ("golden", "GoldenHour", "SkyTreeFarm"),
    ("dusk", "BlueHour", "Sky2Dusk"),
    ("blue_hour", "BlueHour", "Sky2Dusk"),
    ("", "Midday", "SkySFGarden"),
)
"""Word in our sky's name, time of day and AI2-THOR's sky box; the last stands for all others."""

TYPES: tuple[tuple[str, tuple[str, ...]], ...] = (
    ("Bathroom", ("bath", "toilet", "wc", "shower", "restroom", "washroom")),
    ("Kitchen", ("kitchen", "kitchenette", "pantry")),
    ("Bedroom", ("bedroom", "guest_room", "hotel_room", "patient_room", "suite", "dorm")),
)


def floor_material(words: str) -> dict[str, Any]:
    """Return AI2-THOR's material for a floor that is named or described so."""
    return {"name": match_material(words, "floor").thor}


def wall_material(words: str) -> dict[str, Any]:
    """Return AI2-THOR's material for a wall that is named or described so; plain paint keeps its colour."""
    found = library().get(words) or match_material(words, "wall")
    return _coloured(found.thor, found.color)


def ceiling_material(words: str) -> dict[str, Any]:
    """Return AI2-THOR's material for a ceiling that is named or described so."""
    found = match_material(words, "ceiling")
    return _coloured(found.thor, found.color)


def _coloured(name: str, color: str) -> dict[str, Any]:
    if name != "PureWhite":
        return {"name": name}
    r, g, b = (round(value, 4) for value in hex_color(color))
    return {"name": name, "color": {"r": r, "g": g, "b": b}}


def room_type(words: str) -> str:
    """Return which of ProcTHOR's four room types comes nearest."""
    text = words.lower()
    return next((name for name, keys in TYPES if any(key in text for key in keys)), "LivingRoom")
