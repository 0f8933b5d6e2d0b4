"""AI2-THOR's names and figures: layers, agents, materials, sky boxes, room types, assets of doors and windows."""

from typing import Any, Final, NamedTuple, TypeAlias

from mansion_export.meshes.materials import hex_color
from mansion_knowledge import kin_of, words_by
from mansion_scene.structure.materials import library, match_material

__all__ = [
    "AGENT_MODES",
    "DOORFRAMES",
    "DOORWAYS",
    "HORIZONS",
    "LAYERS",
    "LIGHT_TYPES",
    "SCHEMA",
    "WINDOWS",
    "AssetSizes",
    "Sky",
    "best_fitting",
    "ceiling_material",
    "floor_material",
    "room_type",
    "sky",
    "wall_material",
]

SCHEMA: Final = "1.0.0"
"""Version of the house format."""

LAYERS: Final = ("Procedural0", "Procedural1", "Procedural2", "Procedural3")
"""Rendering layers of rooms."""

AGENT_MODES: Final = ("default", "arm", "stretch", "locobot")
"""Keys of ``metadata.agentPoses``; a locobot has no ``standing``."""

HORIZONS: Final = (-30, 0, 30, 60)
"""Camera pitches that ``TeleportFull`` takes, degrees, down is positive."""

LIGHT_TYPES: Final = frozenset(["point", "directional", "spot"])


class Sky(NamedTuple):
    """A sky box with the sun that ProcTHOR gives its time of day (ProcTHOR, supplement).

    Attributes
    ----------
    skybox : str
        AI2-THOR's ``skyboxId``.
    pitch, yaw : float
        Direction of the sunlight, degrees.
    intensity : float
    color : tuple of float
        Red, green and blue from 0 to 1.
    """

    skybox: str
    pitch: float
    yaw: float
    intensity: float
    color: tuple[float, float, float]


_MIDDAY: Final = (66.0, 75.0, 1.0, (1.0, 1.0, 1.0))
_GOLDEN_HOUR: Final = (6.0, -166.0, 1.0, (1.0, 0.694, 0.78))
_BLUE_HOUR: Final = (82.0, -30.0, 0.5, (0.638, 0.843, 1.0))

_SKIES: Final = (
    ("noon", Sky("Sky1", *_MIDDAY)),
    ("morning", Sky("SkyMountain", *_MIDDAY)),
    ("sunset", Sky("SkySunset", *_GOLDEN_HOUR)),
    ("golden", Sky("SkyTreeFarm", *_GOLDEN_HOUR)),
    ("dusk", Sky("Sky2Dusk", *_BLUE_HOUR)),
    ("blue_hour", Sky("Sky2Dusk", *_BLUE_HOUR)),
    ("", Sky("SkySFGarden", *_MIDDAY)),
)
"""Word in the name of a scene's sky, and the sky for it; the last stands for all others."""

_ROOM_TYPES: Final = ("Bathroom", "Kitchen", "Bedroom")
"""ProcTHOR's room types besides the living room; the first that a name fits is taken."""

AssetSizes: TypeAlias = dict[str, tuple[float, float]]
"""Width and height of the hole that an asset closes, metres, by asset id."""

# Sizes: wall-holes.json and asset-database.json of the PyPI package procthor (Apache-2.0).
DOORWAYS: Final[AssetSizes] = {
    "Doorway_1": (1.073, 2.128),
    "Doorway_2": (0.992, 2.071),
    "Doorway_4": (1.037, 2.101),
    "Doorway_5": (1.033, 2.092),
    "Doorway_8": (1.049, 2.098),
    "Doorway_9": (0.999, 2.074),
    "Doorway_Double_2": (1.908, 2.069),
    "Doorway_Double_5": (1.937, 2.094),
    "Doorway_Double_8": (1.957, 2.094),
    "Doorway_Double_10": (1.985, 2.102),
}

DOORFRAMES: Final[AssetSizes] = {
    "Doorframe_2": (1.0, 2.073),
    "Doorframe_6": (1.041, 2.105),
    "Doorframe_10": (1.041, 2.102),
    "Doorframe_Double_3": (1.941, 2.085),
    "Doorframe_Double_5": (1.94, 2.096),
    "Doorframe_Double_10": (1.987, 2.105),
}

WINDOWS: Final[AssetSizes] = {
    "Window_Fixed_36x48": (0.908, 1.206),
    "Window_Fixed_60x36": (1.524, 0.914),
    "Window_Fixed_60x48": (1.519, 1.208),
    "Window_Fixed_60x72": (1.523, 1.823),
    "Window_Fixed_96x48": (2.439, 1.218),
    "Window_Fixed_96x72": (2.438, 1.824),
    "Window_Hung_32x60": (0.811, 1.574),
    "Window_Hung_44x60": (1.115, 1.576),
    "Window_Hung_48x44": (1.217, 1.272),
    "Window_Slider_36x36": (0.909, 0.911),
    "Window_Slider_48x24": (1.218, 0.608),
    "Window_Slider_48x36": (1.214, 0.909),
    "Window_Slider_60x36": (1.522, 0.912),
    "Window_Slider_60x48": (1.521, 1.214),
}


def best_fitting(sizes: AssetSizes, width: float, height: float) -> tuple[str, float, float]:
    """Return the asset whose proportions change least when it is stretched to an opening.

    Returns
    -------
    (asset id, scale along the wall, scale upwards)
    """

    def stretch(name: str) -> float:
        w, h = sizes[name]
        return max(width / w, w / width) * max(height / h, h / height)

    name = min(sizes, key=lambda key: (round(stretch(key), 6), key))
    w, h = sizes[name]
    return name, width / w, height / h


def sky(name: str) -> Sky:
    """Return AI2-THOR's sky for the name of a scene's sky."""
    return next(found for word, found in _SKIES if word in name)


def room_type(words: str) -> str:
    """Return which of ProcTHOR's four room types comes nearest."""
    text, parts = kin_of(words).lower(), words_by("thor")
    return next((name for name in _ROOM_TYPES if any(part in text for part in parts[name])), "LivingRoom")


def floor_material(words: str) -> dict[str, Any]:
    """Return AI2-THOR's material for a floor that is named or described so."""
    return {"name": match_material(words, "floor").thor}


def wall_material(words: str) -> dict[str, Any]:
    """Return AI2-THOR's material for a wall that is named or described so; plain paint keeps its colour."""
    found = library().get(words) or match_material(words, "wall")
    return _painted(found.thor, found.color)


def ceiling_material(words: str) -> dict[str, Any]:
    """Return AI2-THOR's material for a ceiling that is named or described so."""
    found = match_material(words, "ceiling")
    return _painted(found.thor, found.color)


def _painted(name: str, color: str) -> dict[str, Any]:
    if name != "PureWhite":
        return {"name": name}
    r, g, b = (round(value, 4) for value in hex_color(color))
    return {"name": name, "color": {"r": r, "g": g, "b": b}}
