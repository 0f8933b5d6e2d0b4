"""Tell how many of some storeys lie below ground: "three floors, one of them underground"."""

from mansion_planner.brief.reading import Reading

__all__ = ["storeys_below"]

_MARKS = frozenset({",", "(", "-", "–"})
_PARTS = frozenset({"them", "which", "these", "those"})
_VERBS = frozenset({"is", "are", "being", "lie", "sit", "go"})
_BELOW = (("underground",), ("below", "ground"), ("below", "grade"), ("in", "the", "basement"), ("a", "basement"))


def storeys_below(reading: Reading, index: int) -> tuple[int, int]:
    """Return how many of the storeys counted right before a token lie below ground, and where that ends; or 0, 0."""
    at = index + (reading.word(index) in _MARKS)
    told = reading.kind(at) == "number" and reading.word(at + 1) == "of" and reading.word(at + 2) in _PARTS
    last = at + 3 + (reading.word(at + 3) in _VERBS)
    place = next((words for words in _BELOW if reading.words(last, last + len(words)) == words), ())
    return (int(reading.value(at)), last + len(place)) if told and place else (0, 0)
