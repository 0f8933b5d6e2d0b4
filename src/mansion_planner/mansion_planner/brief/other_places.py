"""Find words for a place that is not the building's: "across the street", "in the next town", "off site"."""

from mansion_planner.brief.reading import Reading

__all__ = ["away_end"]

_OTHER_PLACES = frozenset(
    (
        *(
            (over, "the", way)
            for over, ways in (("across", ("street", "road")), ("over", ("road",)), ("down", ("road", "street")))
            for way in ways
        ),
        *((round_, "the", "corner") for round_ in ("around", "round")),
        ("next", "door"),
        ("elsewhere",),
        ("nearby",),
        ("off", "site"),
        ("offsite",),
        ("in", "town"),
        ("on", "campus"),
        *(
            (at, *which, place)
            for at in ("in", "at", "on")
            for which in (("another",), ("a", "different"), ("the", "next"), ("the", "neighbouring"), ("the", "main"))
            for place in ("building", "town", "village", "city", "site", "campus", "street", "plot", "location")
        ),
        *((at, "the", "other", place) for at in ("in", "at", "on") for place in ("town", "site", "campus", "location")),
    )
)
"""Words for where something is that the building therefore does not need."""


def away_end(reading: Reading, index: int) -> int:
    """Return where "across the street", "in the next town" or "at the other site" end that begin at a token; or 0."""
    return next((index + n for n in (4, 3, 2, 1) if reading.words(index, index + n) in _OTHER_PLACES), 0)
