"""AI2-THOR's doors, door frames and windows, with the sizes of the holes that they close.

Figures: ``wall-holes.json`` and ``asset-database.json`` of the PyPI package procthor (Apache-2.0).
"""

from typing import TypeAlias

__all__ = ["DOORFRAMES", "DOORWAYS", "WINDOWS", "nearest"]

Sizes: TypeAlias = dict[str, tuple[float, float]]

DOORWAYS: Sizes = {
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

DOORFRAMES: Sizes = {
    "Doorframe_2": (1.0, 2.073),
    "Doorframe_6": (1.041, 2.105),
    "Doorframe_10": (1.041, 2.102),
    "Doorframe_Double_3": (1.941, 2.085),
    "Doorframe_Double_5": (1.94, 2.096),
    "Doorframe_Double_10": (1.987, 2.105),
}

WINDOWS: Sizes = {
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


def nearest(sizes: Sizes, width: float, height: float) -> tuple[str, float, float]:
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
