"""Numbers in English words and in figures."""

import re

__all__ = ["CARDINALS", "NUMBER_WORDS", "ORDINALS", "SCALES", "SOFT_NUMBERS", "figure"]

CARDINALS = {
    "one": 1, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "seven": 7, "eight": 8,
    "nine": 9, "ten": 10, "eleven": 11, "twelve": 12, "thirteen": 13, "fourteen": 14,
    "fifteen": 15, "sixteen": 16, "seventeen": 17, "eighteen": 18, "nineteen": 19,
    "twenty": 20, "thirty": 30, "forty": 40, "fifty": 50, "sixty": 60, "seventy": 70,
    "eighty": 80, "ninety": 90, "dozen": 12, "single": 1, "double": 2, "twin": 2, "triple": 3,
    "pair": 2, "couple": 2,
}  # fmt: skip
NUMBER_WORDS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")
"""How texts write the numbers from 0 on; larger ones are written in figures."""

SCALES = {"hundred": 100, "thousand": 1000}
SOFT_NUMBERS = frozenset({"single", "double", "twin", "triple", "pair", "couple", "dozen"})
"""Number words that may also be adjectives or nouns."""

ORDINALS = {
    "first": 1, "second": 2, "third": 3, "fourth": 4, "fifth": 5, "sixth": 6, "seventh": 7,
    "eighth": 8, "ninth": 9, "tenth": 10, "eleventh": 11, "twelfth": 12, "thirteenth": 13,
    "fourteenth": 14, "fifteenth": 15, "sixteenth": 16, "seventeenth": 17, "eighteenth": 18,
    "nineteenth": 19, "twentieth": 20, "thirtieth": 30, "fortieth": 40, "fiftieth": 50,
}  # fmt: skip


def figure(text: str) -> float:
    """Return the value of figures; groups of three digits after a mark or a blank are thousands.

    Examples
    --------
    >>> figure("1,200"), figure("20 000"), figure("2.5"), figure("2,5")
    (1200.0, 20000.0, 2.5, 2.5)
    """
    parts = re.split(r"[ ,.'’]", text[:15])  # twelve digits and their separators: more is no size of a building
    if len(parts) > 1 and all(len(part) == 3 for part in parts[1:]) and parts[0] != "0":
        return float("".join(parts))
    if len(parts) == 2:
        return float(f"{parts[0] or 0}.{parts[1] or 0}")
    return float("".join(parts)[:12])
