"""Make words of a model safe to keep: whatever they say, they stay ids, descriptions and materials."""

import re
import unicodedata

from mansion_knowledge import KnowledgeBase, RoomType, words_by
from mansion_planner.brief.similarity import similar_room_type

__all__ = ["clean_id", "clean_text", "is_core_name", "material_fault", "room_kind", "without_number"]

_ID = re.compile(r"^[a-z][a-z0-9_]{0,47}$")
_NUMBER = re.compile(r"(_\d+)+$")
_MATERIAL = re.compile(r"^[A-Za-z][A-Za-z0-9 ,.'()/%+-]{2,79}$")
_DRY_ONLY = re.compile(r"(?i)\b(carpet|hardwood|parquet|oak|walnut|maple|pine|timber|wood|wooden|cork)\b")
_WATERPROOF = re.compile(r"(?i)\b(tiles?|tiled|vinyl|ceramic|porcelain|stone|resin|epoxy|rubber|-look|look)\b")
_CORE = re.compile(r"^(stair|stairs|staircase|stairwell|elevator|lift|core|shaft)(_|$)")


def clean_id(text: str) -> str:
    """Return an id in snake case, or an empty string for what is none.

    Examples
    --------
    >>> clean_id("Meeting Room-1"), clean_id("../../etc/passwd")
    ('meeting_room_1', '')
    """
    name = re.sub(r"[\s-]+", "_", text.strip().lower())
    return name if _ID.match(name) else ""


def clean_text(text: str, limit: int = 400) -> str:
    """Return a description on one line, without control characters, at most `limit` characters."""
    kept = "".join(c if unicodedata.category(c)[0] != "C" else " " for c in text)
    return " ".join(kept.split())[:limit]


def material_fault(text: str, kind: RoomType | None, *, floor: bool) -> str:
    """Return what is wrong with a material, or an empty string.

    Examples
    --------
    >>> material_fault("warm oak hardwood, matte", None, floor=True)
    ''
    """
    if not _MATERIAL.match(text):
        return "a material is a short description of 3 to 80 letters, such as 'warm oak hardwood, matte'"
    if kind is not None and kind.wet and _DRY_ONLY.search(text) and not _WATERPROOF.search(text):
        where = "floor" if floor else "wall"
        return f"{text!r} does not stand water, but is the {where} of a wet room ({kind.name})"
    return ""


def is_core_name(name: str) -> bool:
    """Whether an id names a stair or lift."""
    return bool(_CORE.match(name))


def without_number(name: str) -> str:
    """Return an id without the numbers at its end.

    Examples
    --------
    >>> without_number("meeting_room_12")
    'meeting_room'
    """
    return _NUMBER.sub("", name)


def room_kind(name: str, knowledge: KnowledgeBase, known: dict[str, str]) -> RoomType:
    """Return the type of a room id: numbers dropped, then by name, synonym or likeness.

    What is called a passage in any way (``east_corridor``) is a corridor.

    Parameters
    ----------
    known : dict
        Types of the names that the brief itself uses.
    """
    base = without_number(name)
    for candidate in (name, base):
        if candidate in known:
            return knowledge.room(known[candidate])
    if base not in knowledge.rooms and set(words_by("classes")["passage"]).intersection(base.split("_")):
        return knowledge.room("corridor")
    return knowledge.room(similar_room_type(base, knowledge))
