"""Colours of a plan: a tint for each family of rooms, and the inks."""

from mansion_knowledge import kin_of, words_by

__all__ = ["FAMILIES", "INK", "room_tint"]

INK = {
    "paper": "#ffffff",
    "wall": "#3b4048",
    "outer_wall": "#2a2e35",
    "structural": "#1d2026",
    "furniture": "#fdfdfb",
    "furniture_line": "#7b818c",
    "furniture_detail": "#a3a8b1",
    "door": "#6d4f33",
    "glass": "#4f8fc0",
    "glass_fill": "#d9ecf8",
    "core": "#edeef1",
    "core_line": "#6a707b",
    "text": "#2f3440",
    "muted": "#6a707b",
    "green": "#7fa77a",
    "green_fill": "#dcebd6",
    "rug": "#ebe2d3",
}

FAMILIES = {
    "washing": "#d5ebee",
    "eating": "#fbeccb",
    "learning": "#e4efda",
    "storing": "#e6e4ea",
    "caring": "#f6e3de",
    "resting": "#f5e6d6",
    "working": "#dfe9f6",
    "trading": "#efe3f1",
    "passing": "#f5f2ea",
}
"""Tints of the families of rooms that the words of their names tell; the first that fits is taken."""

OTHER = ("#e9eedd", "#f2e7e2", "#e2ecec", "#ece6f0", "#f3eddc")


def room_tint(room_type: str, kind: str) -> str:
    """Return the fill of a room, the same for the same type on every floor.

    Parameters
    ----------
    room_type : str
        As in the program, ``meeting_room``.
    kind : str
        Node kind; ``main`` is always drawn as circulation.
    """
    if kind == "main":
        return FAMILIES["passing"]
    name, parts = kin_of(room_type).lower(), words_by("colour")
    for family, tint in FAMILIES.items():
        if any(part in name for part in parts[family]):
            return tint
    return OTHER[sum(name.encode()) % len(OTHER)]
