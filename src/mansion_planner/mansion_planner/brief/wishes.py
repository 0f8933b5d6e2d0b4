"""Read what a brief wishes of the building's shape: outline, setbacks, lifts, equal storeys, and what to leave out."""

from mansion_planner.brief.facts import CopyFact, FloorRef, Shape
from mansion_planner.brief.places import Place
from mansion_planner.brief.reading import FLOOR_WORDS, Reading
from mansion_planner.brief.similarity import AS_ROOM

__all__ = ["read_copies", "read_exclusions", "read_massing", "read_shape", "read_vertical"]

_SHAPES: dict[str, Shape] = {"l": "L", "u": "U", "t": "T", "h": "H"}
_LIFT = ("elevator", "lift")
_NEGATIONS = (
    "no", "without", "exclude", "excluding", "omit", "not", "neither", "nor", "avoid", "skip", "never",
)  # fmt: skip
_CLAUSE_ENDS = (".", ";", ":", "\n", "but", "with", "!", "?", "however", "only")


def read_shape(reading: Reading) -> None:
    """Read the outline's shape: "L-shaped", "in the form of a U", "around a courtyard", "rectangular"."""
    for i in range(len(reading.tokens)):
        word = reading.word(i)
        if word in _SHAPES and (
            reading.word(i + 1) in ("shaped", "shape", "form", "plan", "formed")
            or " ".join(reading.word(i - k) for k in (3, 2, 1))
            in ("shape of a", "form of a", "shape of an", "form of an")
        ):
            reading.facts.shapes.append((_SHAPES[word], reading.span(i, i + 1 + (reading.word(i + 1) == "shaped"))))
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
            reading.word(i) == "no" and reading.word(i + 1) in ("more", "less", "fewer", "bigger", "larger")
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


def read_copies(reading: Reading, places: list[Place]) -> None:
    """Read storeys that are to be identical: "floors 3 to 8 identical", "identical upper floors"."""
    for i in range(len(reading.tokens)):
        if reading.word(i) not in ("identical", "same", "repeated", "repeat", "alike", "equal") and not (
            reading.word(i) == "typical" and reading.word(i + 1) in FLOOR_WORDS
        ):
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
        if word == "setback" or (word == "set" and following == "back") or word in ("stepped", "recessed", "terraced"):
            if word == "terraced" and following == "house":
                continue
            reading.facts.setback.append(reading.span(i, i + 1 + (following == "back")))
        elif word in ("protruding", "projecting", "podium", "wider") or (word == "larger" and following == "ground"):
            reading.facts.protruding.append(reading.span(i, i + 1))
