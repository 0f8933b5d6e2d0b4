"""Colours of a plan: a tint for each family of rooms, and the inks."""

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

FAMILIES: tuple[tuple[str, tuple[str, ...]], ...] = (
    (
        "#d5ebee",
        ("bath", "toilet", "wc", "shower", "restroom", "laundry", "wash", "locker", "pool", "spa"),
    ),
    (
        "#fbeccb",
        ("kitchen", "dining", "cafe", "restaurant", "canteen", "pantry", "bar", "food", "break"),
    ),
    (
        "#e4efda",
        ("class", "library", "reading", "school", "kinder", "play", "lecture", "seminar", "study"),
    ),
    (
        "#e6e4ea",
        (
            "stor", "closet", "utility", "server", "archive", "mechanic", "electric", "janitor",
            "technical", "garage", "warehouse", "plant_room",
        ),
    ),
    (
        "#f6e3de",
        (
            "patient", "ward", "exam", "surgery", "operating", "treatment", "clinic", "pharmacy",
            "nurse", "therapy", "icu", "radiology", "consult", "medical", "doctor",
        ),
    ),
    ("#f5e6d6", ("bed", "living", "lounge", "guest", "hotel", "suite", "sleep", "family")),
    (
        "#dfe9f6",
        ("office", "meeting", "conference", "work", "lab", "desk", "copy", "studio", "control"),
    ),
    ("#efe3f1", ("shop", "store", "retail", "market", "checkout", "gallery", "exhibit", "gym")),
    (
        "#f5f2ea",
        (
            "hall", "lobby", "corridor", "hub", "main", "reception", "foyer", "entrance", "landing",
            "atrium", "waiting", "vestibule",
        ),
    ),
)  # fmt: skip
"""Tint and the parts of room types that it stands for; the first that fits is taken."""

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
    name = room_type.lower()
    if kind == "main":
        return FAMILIES[-1][0]
    for tint, words in FAMILIES:
        if any(word in name for word in words):
            return tint
    return OTHER[sum(name.encode()) % len(OTHER)]
