"""Read what a brief says of style and materials."""

from mansion_planner.brief.facts import MaterialFact
from mansion_planner.brief.neighbours import room_after, room_name
from mansion_planner.brief.reading import Reading

__all__ = ["read_materials", "read_style"]

_MATERIALS = (
    "oak", "walnut", "pine", "maple", "birch", "bamboo", "cherry", "ash", "parquet", "hardwood", "wooden", "wood",
    "timber", "laminate", "marble", "granite", "limestone", "travertine", "slate", "stone", "terrazzo", "concrete",
    "tile", "tiled", "ceramic", "porcelain", "carpet", "carpeted", "vinyl", "linoleum", "rubber", "cork", "brick",
    "plaster", "wallpaper", "stucco", "glass", "terracotta", "mosaic", "epoxy", "panelled", "paneled", "panelling",
)  # fmt: skip

_COLOURS = ("white", "black", "gray", "grey", "beige", "blue", "green", "red", "yellow", "cream", "dark", "light",
            "polished", "exposed", "warm", "brown", "pink", "painted", "glossy", "matte", "pale", "orange", "navy",
            "turquoise", "purple", "ivory", "charcoal", "herringbone")  # fmt: skip

_SURFACES = {"floor": "floor", "flooring": "floor", "wall": "wall"}


def read_style(reading: Reading) -> None:
    """Read the style; a style word inside a room's name ("modern kitchen") counts as well."""
    for mention in reading.mentions:
        if mention.style and not reading.taken & set(range(mention.first, mention.last)):
            following = reading.mention_at.get(mention.last)
            if (
                mention.room
                or mention.building
                or (following is not None and following.room and following.room in ("roof_terrace",))
            ):
                continue
            reading.facts.styles.append((mention.style, reading.span(mention.first, mention.last)))


def read_materials(reading: Reading) -> None:
    """Read materials: "oak floors", "marble flooring in the lobby", "white walls", "a tiled kitchen"."""
    for i in range(len(reading.tokens)):
        surface = _SURFACES.get(reading.word(i))
        if surface is None or (surface == "floor" and not _material_ending(reading, i)):
            continue
        first = _material_ending(reading, i)
        if not first:
            continue
        words = reading.text[reading.tokens[first - 1].start : reading.tokens[i - 1].end].lower()
        if surface == "floor" and not any(m in words for m in _MATERIALS):
            continue
        room = ""
        if reading.word(i + 1) in ("in", "for", "throughout"):
            target = room_after(reading, i + 2)
            room = room_name(target) if target is not None else ""
        reading.facts.materials.append(
            MaterialFact(surface, words, room, reading.span(first - 1, i + 1))  # type: ignore[arg-type]
        )
        reading.take(first - 1, i + 1)


def _material_ending(reading: Reading, end: int) -> int:
    """Return one more than the first token of the material words that end before `end`, or 0."""
    first = end
    while (
        first > 0 and (reading.word(first - 1) in _MATERIALS or reading.word(first - 1) in _COLOURS) and end - first < 4
    ):
        first -= 1
    return first + 1 if first < end else 0
