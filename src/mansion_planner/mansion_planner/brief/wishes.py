"""Read what a brief wishes besides rooms and numbers: exclusions, neighbours, style, shape, copies, lifts."""

from mansion_planner.brief.facts import AdjacencyFact, CopyFact, FloorRef, MaterialFact, Shape
from mansion_planner.brief.lexicon import Mention
from mansion_planner.brief.places import Place
from mansion_planner.brief.reading import FLOOR_WORDS, Reading
from mansion_planner.brief.similarity import AS_ROOM

__all__ = [
    "read_adjacency",
    "read_copies",
    "read_exclusions",
    "read_materials",
    "read_massing",
    "read_shape",
    "read_style",
    "read_vertical",
]

_SHAPES: dict[str, Shape] = {"l": "L", "u": "U", "t": "T", "h": "H"}
_LIFT = ("elevator", "lift")
_NEGATIONS = (
    "no",
    "without",
    "exclude",
    "excluding",
    "omit",
    "not",
    "neither",
    "nor",
    "avoid",
    "skip",
    "never",
)
_CLAUSE_ENDS = (".", ";", ":", "\n", "but", "with", "!", "?", "however", "only")
_BESIDE = (("next", "to"), ("adjacent", "to"), ("beside",), ("adjoining",), ("near",), ("close", "to"),
           ("alongside",), ("connected", "to"), ("attached", "to"), ("opening", "to"), ("opening", "onto"),
           ("open", "to"), ("bordering",), ("connecting", "to"), ("directly", "off"), ("besides",),
           ("adjacent",), ("neighboring",), ("neighbouring",), ("by", "the"), ("touching",))  # fmt: skip
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


def read_shape(reading: Reading) -> None:
    """Read the outline's shape: "L-shaped", "in the form of a U", "around a courtyard", "rectangular"."""
    for i in range(len(reading.tokens)):
        word = reading.word(i)
        if word in _SHAPES and (
            reading.word(i + 1) in ("shaped", "shape", "form", "plan", "formed")
            or " ".join(reading.word(i - k) for k in (3, 2, 1))
            in ("shape of a", "form of a", "shape of an", "form of an")
        ):
            reading.facts.shapes.append(
                (_SHAPES[word], reading.span(i, i + 1 + (reading.word(i + 1) == "shaped")))
            )
            reading.take(i, i + 2)
        elif word == "courtyard" and reading.word(i - 1) not in _NEGATIONS:
            reading.facts.shapes.append(("courtyard", reading.span(i, i + 1)))
        elif word in ("rectangular", "rectangle", "oblong"):
            reading.facts.shapes.append(("rectangle", reading.span(i, i + 1)))
        elif word == "square" and reading.word(i + 1) in (
            "outline",
            "footprint",
            "plan",
            "shape",
            "shaped",
            "building",
        ):
            reading.facts.shapes.append(("square", reading.span(i, i + 2)))


def read_vertical(reading: Reading) -> None:
    """Read wishes for lifts and stairs, and their exclusion."""
    for i in range(len(reading.tokens)):
        word = reading.word(i)
        if word in _LIFT or word == "stair" or word == "staircase":
            name = "elevator" if word in _LIFT else "stair"
            before = [reading.word(i - k) for k in (1, 2, 3, 4)]
            stop = next((k for k, w in enumerate(before) if w in _CLAUSE_ENDS), len(before))
            negated = any(w in _NEGATIONS for w in before[:stop])
            if i in reading.mention_at or reading.word(i + 1) in ("lobby", "hall"):
                continue
            begin = max(i - 1, 0)
            key = f"no_{name}" if negated else name
            reading.facts.vertical.append((key, reading.span(begin, i + 1)))
            reading.take(i, i + 1)
        elif word in ("walk", "stairs") and reading.word(i + 1) == "up":
            reading.facts.vertical.append(("no_elevator", reading.span(i, i + 2)))


def read_exclusions(reading: Reading) -> None:
    """Read what must not be there: "no basement", "without a kitchen or a gym"."""
    for i in range(len(reading.tokens)):
        if reading.word(i) not in _NEGATIONS or (
            reading.word(i) == "no"
            and reading.word(i + 1) in ("more", "less", "fewer", "bigger", "larger")
        ):
            continue
        index, steps, listed = i + 1, 0, False
        while index < len(reading.tokens) and steps < 12:
            word = reading.word(index)
            if (
                word in _CLAUSE_ENDS
                or (word == "," and reading.word(index + 1) not in ("no", "nor", "or"))
                or (word == "and" and listed and reading.word(index + 1) in ("a", "an", "the"))
                or reading.kind(index) == "number"
            ):
                break
            mention = reading.mention_at.get(index)
            if mention is not None and not reading.taken & set(range(mention.first, mention.last)):
                name = mention.room or AS_ROOM.get(mention.building, "")
                if name:
                    reading.facts.excluded.append((name, reading.span(i, mention.last)))
                    reading.take(mention.first, mention.last)
                    listed = True
                index = mention.last
                continue
            if word in ("basement", "cellar", "underground"):
                reading.facts.excluded.append(("basement", reading.span(i, index + 1)))
                reading.take(index, index + 1)
                listed = True
            index += 1
            steps += 1


def read_adjacency(reading: Reading) -> None:
    """Read pairs that are to be side by side: "kitchen next to the dining room"."""
    for i in range(len(reading.tokens)):
        phrase = next(
            (p for p in _BESIDE if all(reading.word(i + k) == w for k, w in enumerate(p))), None
        )
        if phrase is None:
            continue
        left = _room_before(reading, i)
        right = _room_after(reading, i + len(phrase))
        if left is None and right is not None and phrase == ("adjacent",):
            continue
        if left is not None and right is not None:
            first, second = _name(left), _name(right)
            if first and second:
                reading.facts.adjacent.append(
                    AdjacencyFact(first, second, reading.span(left.first, right.last))
                )


def _name(mention: Mention) -> str:
    return mention.room or AS_ROOM.get(mention.building, "")


def _room_before(reading: Reading, index: int) -> Mention | None:
    for back in range(index, max(index - 7, -1), -1):
        mention = reading.mention_ending.get(back)
        if mention is not None and _name(mention):
            return mention
        if reading.word(back - 1) in (".", ";", "\n"):
            return None
    return None


def _room_after(reading: Reading, index: int) -> Mention | None:
    for at in range(index, index + 4):
        mention = reading.mention_at.get(at)
        if mention is not None and _name(mention):
            return mention
        if reading.word(at) in (".", ";", ",", "\n"):
            return None
    return None


def repeated_mentions(reading: Reading) -> set[int]:
    """Return the first tokens of mentions that only repeat a room within a neighbour wish.

    In "a kitchen next to the dining room" the second room stands with "the": it is the one that is there anyway when
    the brief names it elsewhere.
    """
    seen: dict[str, int] = {}
    repeated: set[int] = set()
    for mention in reading.mentions:
        name = _name(mention)
        if not name or mention.first in reading.taken:
            continue
        definite = reading.word(mention.first - 1) in (
            "the",
            "its",
            "their",
            "this",
            "that",
            "each",
            "every",
            "both",
            "all",
        )
        restated = (
            not mention.plural
            and reading.word(mention.last) in _BESIDE_STARTS
            and reading.kind(mention.first - 1) not in ("number",)
            and reading.word(mention.first - 1) not in ("a", "an")
        )
        sized = (
            reading.word(mention.last)
            in ("should", "must", "is", "has", "to", "shall", "will", "of")
            and definite
        )
        if name in seen and (definite or restated or sized):
            repeated.add(mention.first)
        else:
            seen.setdefault(name, mention.first)
    return repeated


_BESIDE_STARTS = frozenset(phrase[0] for phrase in _BESIDE) | {
    "should",
    "must",
    "is",
    "are",
    "opens",
}


def read_style(reading: Reading) -> None:
    """Read the style; a style word inside a room's name ("modern kitchen") counts as well."""
    for mention in reading.mentions:
        if mention.style and not reading.taken & set(range(mention.first, mention.last)):
            following = reading.mention_at.get(mention.last)
            if (
                mention.room
                or mention.building
                or (
                    following is not None and following.room and following.room in ("roof_terrace",)
                )
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
            target = _room_after(reading, i + 2)
            room = _name(target) if target is not None else ""
        reading.facts.materials.append(
            MaterialFact(surface, words, room, reading.span(first - 1, i + 1))  # type: ignore[arg-type]
        )
        reading.take(first - 1, i + 1)


def _material_ending(reading: Reading, end: int) -> int:
    """Return one more than the first token of the material words that end before `end`, or 0."""
    first = end
    while (
        first > 0
        and (reading.word(first - 1) in _MATERIALS or reading.word(first - 1) in _COLOURS)
        and end - first < 4
    ):
        first -= 1
    return first + 1 if first < end else 0


def read_copies(reading: Reading, places: list[Place]) -> None:
    """Read storeys that are to be identical: "floors 3 to 8 identical", "identical upper floors"."""
    for i in range(len(reading.tokens)):
        if reading.word(i) not in (
            "identical",
            "same",
            "repeated",
            "repeat",
            "alike",
            "equal",
        ) and not (reading.word(i) == "typical" and reading.word(i + 1) in FLOOR_WORDS):
            continue
        pair = _same_as(places, i)
        if pair is not None:
            first, last = sorted((pair[0].refs[0].first, pair[1].refs[0].first))
            span = reading.span(pair[0].first, pair[1].last)
            reading.facts.copies.append(CopyFact(FloorRef("range", first, last, span), span))
            continue
        near = [
            p for p in places
            if (0 <= i - p.last <= 5 or 0 < p.first - i <= 3)
            and p.refs[0].kind in ("range", "upper", "middle", "every")
        ]  # fmt: skip
        if near:
            place = min(near, key=lambda p: min(abs(p.last - i), abs(p.first - i)))
            reading.facts.copies.append(
                CopyFact(place.refs[0], reading.span(min(place.first, i), max(place.last, i + 1)))
            )
        elif reading.word(i) == "identical" and reading.word(i + 1) in FLOOR_WORDS:
            span = reading.span(i, i + 2)
            reading.facts.copies.append(CopyFact(FloorRef("upper", span=span), span))


def _same_as(places: list[Place], index: int) -> tuple[Place, Place] | None:
    """Return the two neighbouring storeys of "floor 3: same as floor 2"."""
    before = [p for p in places if 0 <= index - p.last <= 3 and p.refs[0].kind == "number"]
    after = [p for p in places if 0 < p.first - index <= 3 and p.refs[0].kind == "number"]
    if before and after and abs(before[-1].refs[0].first - after[0].refs[0].first) == 1:
        return before[-1], after[0]
    return None


def read_massing(reading: Reading) -> None:
    """Read setbacks and terraces, protruding ground floors and garages."""
    for i in range(len(reading.tokens)):
        word, following = reading.word(i), reading.word(i + 1)
        if (
            word == "setback"
            or (word == "set" and following == "back")
            or word in ("stepped", "recessed", "terraced")
        ):
            if word == "terraced" and following == "house":
                continue
            reading.facts.setback.append(reading.span(i, i + 1 + (following == "back")))
        elif word in ("protruding", "projecting", "podium", "wider") or (
            word == "larger" and following == "ground"
        ):
            reading.facts.protruding.append(reading.span(i, i + 1))
