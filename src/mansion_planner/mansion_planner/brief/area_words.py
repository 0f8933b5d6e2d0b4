"""Areas in the text, and the words around them."""

from dataclasses import dataclass

from mansion_planner.brief.bounds import Limit
from mansion_planner.brief.reading import Reading

__all__ = [
    "ABOUT",
    "FILLERS",
    "Measure",
    "PLOT",
    "TOTALS",
    "after_area",
    "is_filler",
    "is_of_each",
    "lead_of",
    "words_after",
]

FILLERS = frozenset(
    """
    of with ( about around at least measuring is has approximately be should covering roughly an area size sized
    each : having = a must will exactly occupying minimum than more floor something like the region in circa ca
    approx some apiece over for maybe nearly almost are being up to each one - – every max maximum no less not under
    total below every measure have has some shall larger bigger smaller greater exceed exceeding within limited
    capped min pass surpass all alike identical equal same namely everything else
    """.split()
)
TOTALS = frozenset(
    """
    total overall altogether gross gfa together whole all gia net sum
    """.split()
)
ABOUT = frozenset("about around approx roughly ca circa some".split())
PLOT = frozenset({"plot", "site", "lot"})


@dataclass(frozen=True)
class Measure:
    """Areas in the text: tokens `first` to `last` (exclusive), square metres; several for a list."""

    first: int
    last: int
    values: tuple[float, ...]
    sides: bool = False
    limit: Limit = ""


def after_area(reading: Reading, index: int) -> int:
    """Return the token after an area that stands at a token: "of 60 m2 each,"; the token itself where none does."""
    number = index + (reading.word(index) in ("of", "with", "à", ",", "("))
    if reading.kind(number) != "number" or reading.kind(number + 1) != "unit":
        return index
    end = number + 2 + (reading.word(number + 2) in ("each", "apiece"))
    return end + (reading.word(end) == ")" and number > index)


def is_of_each(reading: Reading, measure: Measure) -> bool:
    """Whether an area is said of each of several: "each 30 m2", "30 m2 each"."""
    return "each" in reading.words(lead_of(reading, measure), measure.first) or words_after(reading, measure, 1) in (
        ["each"],
        ["apiece"],
    )


def words_after(reading: Reading, measure: Measure, count: int = 5) -> list[str]:
    words = []
    for index in range(measure.last, measure.last + count):
        joined = reading.words(index, index + 2) == ("together", "with")  # what follows is measured apart
        if reading.breaks(index) or reading.word(index) in (",", ":", "with") or joined:
            break
        words.append(reading.word(index))
    return words


def is_filler(reading: Reading, index: int) -> bool:
    """Whether a token only leads on to an area, as the full stop of "approx." does."""
    return reading.word(index) in FILLERS or (reading.word(index) == "." and not reading.breaks(index))


def lead_of(reading: Reading, measure: Measure) -> int:
    """Return the token before an area and the words that only make it approximate."""
    lead = measure.first - 1
    while reading.word(lead) in ABOUT:
        lead -= 1
    return lead
