"""Read storeys that a brief names by their numbers: "the third floor", "L3", "levels 2 to 6", "4: wards"."""

from collections.abc import Sequence

from mansion_planner.brief.facts import FloorRef
from mansion_planner.brief.reading import FLOOR_WORDS, Place, Reading
from mansion_planner.brief.storey_counts import CLOSERS
from mansion_planner.brief.storey_forms import ABOVE_GROUND
from mansion_planner.brief.storey_numbering import (
    counts_above_ground,
    counts_from_ground,
    levels_above_ground,
    numbers_above_ground,
    written_after,
)

__all__ = ["NumberedStoreys"]

_MOST_STOREYS = 1000
"""A larger number is that of no storey."""


class NumberedStoreys:
    """Reads numbers of storeys, by the way that the brief counts them.

    Each method returns what is meant at a token and the token after it, if anything.

    Parameters
    ----------
    places : sequence of Place
        The references that stand before; it grows while the brief is read.
    has_floors : bool
        The brief has a word for storeys.

    Attributes
    ----------
    british : bool
        The first floor is the one above the ground floor.
    """

    def __init__(self, reading: Reading, places: Sequence[Place], *, has_floors: bool) -> None:
        self.reading, self.places, self.has_floors = reading, places, has_floors
        self.british = counts_from_ground(reading)
        self.levels_above = levels_above_ground(reading)
        self.zero_based = any(
            reading.value(i) == 0
            and (
                (reading.kind(i) == "level" and reading.word(i) != ABOVE_GROUND)
                or (reading.kind(i) == "number" and reading.word(i - 1) in ("level", "floor", "storey"))
            )
            for i in range(len(reading.tokens))
        )
        self.numbers_above = numbers_above_ground(reading)
        if counts_above_ground(reading):
            self.british = self.zero_based = True
        self.numbered_headings = sum(
            reading.kind(i) == "number" and reading.starts(i) and self._is_heading(i)
            for i in range(len(reading.tokens))
        )
        codes = [i for i in range(len(reading.tokens)) if self._is_code(i)]
        self.coded = len(codes) > 1
        self.codes_above = int(any(reading.value(i) == 0 for i in codes))
        heads = [i for i in range(len(reading.tokens)) if reading.starts(i) and reading.word(i + 1) == ":"]
        ground = any(reading.word(i) in ("g", "ground", "gf", ABOVE_GROUND) for i in heads)
        first = any(
            reading.value(i) == 1 and reading.word(i) != "first" and reading.starts(i) and self._is_heading(i)
            for i in range(len(reading.tokens))
        )
        self.headings_above = int(ground and first)

    def level(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "L3", "L2 to L6", "1F and 2F"."""
        reading = self.reading
        if reading.kind(index) != "level":
            return None
        numbers, last = [self._level_number(index)], index + 1
        while reading.word(last) in ("to", "–", "-", ",", "and", "&", "+", "through"):
            step = 2 if reading.word(last) == "," and reading.word(last + 1) == "and" else 1
            if reading.kind(last + step) != "level" and not (
                reading.word(last) in ("–", "to") and reading.kind(last + step) == "number"
            ):
                break
            level = last + step if reading.kind(last + step) == "level" else index
            value = int(reading.value(last + step)) + self._level_number(level) - int(reading.value(level))
            if reading.word(last) in ("to", "–", "-", "through"):
                return [FloorRef("range", min(numbers[-1], value), max(numbers[-1], value))], last + step + 1
            numbers.append(value)
            last += step + 1
        return [FloorRef("number", n, n) for n in numbers], last

    def _level_number(self, index: int) -> int:
        """Return which storey a level is, the ground floor being the first."""
        above = self.reading.word(index) == ABOVE_GROUND or self.levels_above
        shift = above or self.zero_based or (self.british and written_after(self.reading, index))
        return int(self.reading.value(index)) + int(shift)

    def _number(self, index: int, kind: str) -> int | None:
        reading = self.reading
        if reading.kind(index) != kind or index in reading.taken or reading.tokens[index].soft:
            return None
        value = reading.value(index)
        shift = int((self.zero_based or self.numbers_above) and kind == "number")
        return int(value) + shift if value == int(value) and abs(value) <= _MOST_STOREYS else None

    def numbered(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "floor 3", "floors 3 to 8", "levels 2 and 3", "floors 2, 3 and 5"."""
        reading = self.reading
        if reading.word(index) not in FLOOR_WORDS or reading.word(index) == "storie":
            return None
        number = index + 1 + (reading.word(index + 1) == "from" and reading.plural(index))
        first = self._number(number, "number")
        if first is None or reading.kind(number + 1) == "unit" or reading.word(number + 1) in ("people", "person"):
            return None
        last = number + 1
        link = reading.word(last)
        again = last + 1 + (reading.word(last + 1) == reading.word(index))  # "floor 2 to floor 4"
        second = self._number(again, "number")
        ranged = link in ("to", "through", "until", "till", "–", "-", "thru") and not self._heads_count(index, last)
        if ranged and second is not None:
            return [FloorRef("range", min(first, second), max(first, second))], again + 1
        counts = reading.kind(last) == "word" and not reading.plural(index) and reading.plural(last)
        if counts and not self._is_titled(index, last):
            return None  # "level 2 bedrooms" has no plural room of one level: the number counts the rooms
        numbers, ended = [first], False
        while reading.word(last) in (",", "and", "&", "+") and not ended:
            step = 2 if reading.word(last) == "," and reading.word(last + 1) == "and" else 1
            more = self._number(last + step, "number")
            several = reading.plural(index) or self._are_two(index, last)
            if more is None or not several or more <= numbers[-1]:
                break
            if reading.kind(last + step + 1) == "unit" or reading.plural(last + step + 1):
                break
            ended = reading.word(last + step - 1) != ","  # "floors 2 and 3, ten guest rooms": what follows counts rooms
            numbers.append(more)
            last += step + 1
        return [FloorRef("number", number, number) for number in numbers], last

    def _are_two(self, index: int, joint: int) -> bool:
        """Whether "level 1 and 2" opens what both hold: the next number counts no rooms."""
        reading, after = self.reading, joint + 2
        follows = reading.value(joint + 1) == reading.value(joint - 1) + 1 and reading.word(joint) in ("and", "&", "+")
        counts = reading.plural(after) or reading.plural(after + 1)
        return reading.starts(index) and follows and (reading.word(after) in (":", ",", "=") or not counts)

    def _heads_count(self, index: int, dash: int) -> bool:
        """Whether a dash parts one storey from what it holds: "Level 1 - six offices", and not "level 1-6"."""
        reading = self.reading
        parts = reading.word(dash) in ("-", "–") and reading.tokens[dash].spaced and reading.tokens[dash + 1].spaced
        return parts and not reading.plural(index) and reading.starts(index) and reading.kind(dash + 2) == "word"

    def _is_titled(self, index: int, last: int) -> bool:
        """Whether a storey that opens a sentence has a title of a few words: "Level 0 citizens' service: ..."."""
        reading, end = self.reading, last
        while reading.kind(end) == "word" and end - last < _TITLE:
            end += 1
        return reading.starts(index) and reading.word(end) == ":"

    def ordinal(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "third floor", "second and third floors", "third to eighth floors", "second:", "on the second"."""
        reading = self.reading
        number = self._number(index, "ordinal")
        mention = reading.mention_at.get(index)
        if number is None or (mention is not None and mention.last - index > 1 and mention.room):
            return None  # "first aid"
        numbers, last, ranged = [number], index + 1, False
        while reading.word(last) in ("and", ",", "&", "to", "through", "–", "floor", "-"):
            link = reading.word(last)
            if link == "floor" and reading.word(last + 1) not in ("to", "through", "–"):
                break
            step = 2 if link == "floor" or (link == "," and reading.word(last + 1) == "and") else 1
            step += reading.word(last + step) == "the"
            more = self._number(last + step, "ordinal")
            if more is None:
                break
            ranged = ranged or link in ("to", "through", "–", "floor", "-")
            numbers.append(more)
            last += step + 1
        above = reading.word(last) == "upper" and reading.word(last + 1) in FLOOR_WORDS
        last += above  # "from the first to the seventh upper floor"
        following = reading.word(last)
        if following in FLOOR_WORDS:
            last += 1
            if reading.words(last, last + 3) == ("from", "the", "top"):
                return [FloorRef("below_top", number - 1)], last + 3
            end = last + 1 + (reading.word(last + 1) == "the")
            final = self._number(end, "ordinal") if reading.word(last) in ("to", "through", "until", "–") else None
            if final is not None and final > number and not ranged:  # "from the second storey to the sixth"
                shift = int(self.british)
                end += 1 + (reading.word(end + 1) in FLOOR_WORDS)
                return [FloorRef("range", number + shift, final + shift)], end
        elif not self._bare_ordinal(index, last):
            return None
        shift = int(self.british or above)
        numbers = [value + shift for value in numbers]
        if ranged and len(numbers) == 2:
            return [FloorRef("range", min(numbers), max(numbers))], last
        return [FloorRef("number", value, value) for value in numbers], last

    def bare_number(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "the canteen on 2", where the brief has a word for storeys."""
        reading = self.reading
        number = self._number(index, "number")
        if number is None or not self.has_floors or reading.word(index - 1) != "on" or not 1 <= number <= 200:
            return None
        return ([FloorRef("number", number, number)], index + 1) if reading.word(index + 1) in CLOSERS else None

    def _bare_ordinal(self, index: int, last: int) -> bool:
        """Whether an ordinal without "floor" means one: a heading, or the end of "on the second"."""
        reading = self.reading
        following = reading.word(last)
        if not self.has_floors and not self.places:
            return False
        if (
            reading.starts(index)
            and self.has_floors
            and following in ("for", "identical", "has", "hold", "contain", "with", "are", "have")
        ):
            return last > index + 1 or following in ("for", "has", "hold", "contain")
        if reading.starts(index):
            return following in (":", "\n", "(", "=", "-") or (following == "is" and reading.word(index - 1) == "the")
        if reading.word(index - 1) in ("on", "in", "at") and reading.starts(index - 1) and following in (":", ","):
            return True
        if reading.word(index - 1) == "on" and following in _TELLS_ROOMS:
            return reading.starts(index - 1) or reading.word(index - 2) in (",", "and", "while", "but", "–", "-")
        if reading.word(index - 1) == "from" and last > index + 1:
            return True  # "from 2nd to 4th"
        if reading.word(index - 1) != "the":
            return False
        if reading.word(index - 2) in ("on", "to", "and", "in", "at") or reading.starts(index - 1):
            led = reading.word(index - 2) in ("on", "to", "and", "in", "at")
            return (following in CLOSERS | {"and", "with", "is", "has", "are"}) or (
                led and reading.word(index - 2) == "on"
            )
        return False

    def _is_heading(self, index: int) -> bool:
        """Whether numbers that open a sentence stand before a colon: "4:", "2 and 3:", "5 to 8:"."""
        last = index + 1
        while self.reading.word(last) in (",", "and", "&", "–", "to", "through") and last - index < 12:
            last += 2
        return self._leads_list(last)

    def _leads_list(self, index: int) -> bool:
        """Whether a colon stands at a token, or after a bracket there that says storeys are alike: "(typical):"."""
        reading = self.reading
        alike = reading.word(index) == "(" and reading.word(index + 1) in _ALIKE
        return reading.word(index + 3 * (alike and reading.word(index + 2) == ")")) == ":"

    def _is_code(self, index: int) -> bool:
        """Whether a number of two digits that begins with 0 opens a line: "00 reception", "01-04 offices"."""
        token = self.reading.tokens[index]
        code = self.reading.text[token.start : token.end]
        return token.kind == "number" and len(code) == 2 and code[0] == "0" and self.reading.starts(index)

    def heading(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "1: lobby", "4, 5 and 6: wards", "2-8 identical" and "00 reception" where they number the storeys."""
        reading = self.reading
        if reading.kind(index) != "number" or not reading.starts(index):
            return None
        coded = self.coded and self._is_code(index)
        numbers, last = [int(reading.value(index))], index + 1
        while reading.word(last) in (",", "and", "&", "–", "to", "through"):
            if reading.kind(last + 1) != "number" or reading.value(last + 1) > _MOST_STOREYS:
                return None
            if reading.word(last) in ("–", "to", "through"):
                numbers += range(numbers[-1] + 1, int(reading.value(last + 1)) + 1)
            else:
                numbers.append(int(reading.value(last + 1)))
            last += 2
        marked = self.numbered_headings + self.headings_above > 1 and self._leads_list(last)
        alike = len(numbers) > 1 and self.has_floors and reading.word(last) in _ALIKE
        if not (marked or alike or coded) or max(numbers) > 200:
            return None
        above = self.codes_above if coded else self.headings_above
        numbers = [number + above for number in numbers]
        return [FloorRef("number", number, number) for number in numbers], last


_TITLE = 4
"""Words of a title between a storey and its colon, at most."""
_TELLS_ROOMS = frozenset("is are there come we only just a an the one two three four".split())
"""What goes on after a storey without its noun: "on second is a computer class"."""
_ALIKE = frozenset({"identical", "alike", "typical"})
"""What is said of storeys whose numbers alone open a sentence: "2-8 identical, ten rooms each"."""
