"""Read storeys that have a name of their own: the ground floor, the basement, the top floor, "upstairs", "middle"."""

from mansion_planner.brief.cellars import keeps_goods
from mansion_planner.brief.facts import FloorRef
from mansion_planner.brief.reading import FLOOR_WORDS, Reading
from mansion_planner.brief.storey_counts import CLOSERS, UPSTAIRS
from mansion_planner.brief.storey_kinds import HOLDING_ROOMS

__all__ = ["COPULAS", "TOPS", "NamedStoreys"]

_STREET = frozenset(
    """
    ground gnd street entrance entry garden courtyard water lobby arrival bottom lowest lower public shop pavement
    quay quayside waterside pier
    """.split()
)
TOPS = frozenset({"top", "uppermost", "topmost", "highest", "last", "final"})
COPULAS = frozenset(
    """
    is are be has have hold contain house carry belong will stay
    """.split()
)

_STAYS = frozenset({"stay", "is", "are", "go", "also"})
"""What "up" and "down" follow where they are a storey: "the bedrooms are also up"."""
_AFTER_TOP = frozenset("with and there nothing only two one become we the sit come".split())
"""Words that what is on the top storey follows: "on top there is a bar"."""


_PLACED_BELOW = frozenset("under below beneath of right directly just".split())
"""What tells more of a place at the very top: "at the very top under the lamp"."""

_AFTER_GROUND = frozenset("and there has is are also we should must".split())
"""Words that what is on the ground floor follows: "on the ground are a kitchen and a pantry"."""


_ARTICLES = frozenset({"a", "an", "and", "one"})
_ON_ROOFS = frozenset({"terrace", "garden", "deck", "room"})
"""Nouns that with "roof" or "attic" before them name a room of its own."""


class NamedStoreys:
    """Reads the names of storeys: each method returns what is meant at a token and the token after it, if anything.

    Parameters
    ----------
    has_floors : bool
        The brief has a word for storeys.
    british : bool
        The first floor is the one above the ground floor.
    """

    def __init__(self, reading: Reading, *, has_floors: bool, british: bool) -> None:
        self.reading, self.has_floors, self.british = reading, has_floors, british

    def basement(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "the basement", "the cellar level", "below ground"."""
        reading = self.reading
        word, following = reading.word(index), reading.word(index + 1)
        mention = reading.mention_at.get(index)
        if (word in ("below", "under") and following in ("ground", "grade")) or (
            word == "under" and following == "the" and reading.word(index + 2) == "ground"
        ):
            return [FloorRef("basement")], index + (2 if following != "the" else 3)
        if word not in ("basement", "cellar", "underground", "souterrain", "subterranean", "b1") or following == "car":
            return None
        if word == "cellar" and keeps_goods(reading, index):
            return None
        last = index + 2 if following in FLOOR_WORDS else index + 1
        if mention is not None and mention.last > last:
            return None
        if reading.word(index - 1) in ("wine", "beer", "root", "coal", "finished"):
            return None
        if word in ("underground", "subterranean") and following not in FLOOR_WORDS:
            predicate = reading.word(index - 1) in COPULAS | {"lie", "go", "all"} and following in CLOSERS
            predicate = predicate or (following in (":", "=") and reading.starts(index))
            return ([FloorRef("basement")], last) if predicate else None
        return [FloorRef("basement")], last

    def ground(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "the ground floor", "street level", "downstairs", "at grade"."""
        word = self.reading.word(index)
        if word in ("ff", "sf") and self.reading.word(index + 1) in CLOSERS and self.british:
            return [FloorRef("number", 2 + (word == "sf"), 2 + (word == "sf"))], index + 1
        last = self._ground_in_full(index)
        alone = (self._is_abbreviated_ground, self._is_ground, self._is_bottom, self._is_below)
        if not last and not any(names(index) for names in alone):
            return None
        return [FloorRef("number", 1, 1)], last or index + 1

    def _ground_in_full(self, index: int) -> int:
        """Return where "the street level", "level of the street", "on the lower one", "at grade" end, or 0."""
        reading = self.reading
        word, following = reading.word(index), reading.word(index + 1)
        if word in _STREET and following in FLOOR_WORDS and not reading.plural(index + 1):
            return index + 2
        if reading.words(index, index + 4) == ("level", "of", "the", "street"):
            return index + 4
        if word in ("lower", "bottom", "lowest") and following == "one" and self._is_elliptic(index):
            return index + 2
        return index + 2 if (word, following) == ("at", "grade") else 0

    def _is_abbreviated_ground(self, index: int) -> bool:
        """Whether a token is a short form of the ground floor: "GF: a shop", "G:", "in the EG"."""
        reading = self.reading
        word, following = reading.word(index), reading.word(index + 1)
        if word == "g":
            return following == ":" and reading.starts(index)
        led = word in ("gf", "g/f", "gnd") or (word == "eg" and reading.word(index - 1) in ("the", "in", ""))
        return led and following in CLOSERS | {"has", "with"}

    def _is_ground(self, index: int) -> bool:
        """Whether "ground" stands for the ground floor: "on the ground there is a shop", "; ground for parking"."""
        reading = self.reading
        lead, following = reading.word(index - 1), reading.word(index + 1)
        if reading.word(index) != "ground":
            return False
        if following in ("for", "has", "hold") and lead in (":", ";"):
            return True
        if reading.words(index + 1, index + 3) == ("only", ":") and reading.starts(index):
            return True
        room = reading.mention_at.get(index + 1)
        if reading.starts(index) and room is not None and room.room and self._heads_with_ordinals(index):
            return True  # "Ground bar and shop. Second: six rooms."
        if lead == "," and following == ":":
            return True  # "in a Nordic style, ground: a kitchen"
        if lead in ("-", "–") and following in (".", ";", "\n"):
            return True  # "lobby, two offices - ground."
        if following == "with" and reading.words(index - 2, index) == ("on", "the"):
            return True
        led = lead in ("the", "on", "at") or reading.starts(index) or (lead == "in" and reading.starts(index - 1))
        return led and following in CLOSERS | _AFTER_GROUND

    def _heads_with_ordinals(self, index: int) -> bool:
        """Whether later sentences open with an ordinal and a colon: "Second: six rooms"."""
        reading = self.reading
        return any(
            reading.kind(at) == "ordinal" and reading.starts(at) and reading.word(at + 1) == ":"
            for at in range(index + 1, len(reading.tokens))
        )

    def _is_bottom(self, index: int) -> bool:
        """Whether "bottom" or "lowest" stands for the ground floor: "at the bottom a shop", "the very bottom"."""
        reading = self.reading
        lead, following = reading.word(index - 1), reading.word(index + 1)
        if reading.word(index) == "lowest":
            return self._names_storey(index)
        if reading.word(index) != "bottom":
            return False
        goes_on = following in CLOSERS | COPULAS | {"with", "and", "a", "an"} or self._counts(index + 1)
        if goes_on and lead in ("the", "at", "from"):
            return reading.word(index - 2) != "from"
        return following == ":" or (lead == "very" and reading.word(index - 2) in ("the", "at"))

    def _is_below(self, index: int) -> bool:
        """Whether an adverb of place stands for the ground floor: "downstairs", "Below: a shop", "the shop is down"."""
        reading = self.reading
        word, lead, following = reading.word(index), reading.word(index - 1), reading.word(index + 1)
        if word == "lower":
            return (following in (":", ",") and lead == "the") or self._is_after_on(index)
        if word == "down":
            stays = self.has_floors and following in CLOSERS and lead in _STAYS
            room = any(mention.room and mention.last == index for mention in reading.mentions)
            stays = stays or (room and following in CLOSERS and "upstairs" in {token.text for token in reading.tokens})
            return stays or (following == ":" and reading.starts(index))
        if word == "below":
            if reading.starts(index) and following in (":", "is", "are", "there", ",", "the", "we", "i", "you", "a"):
                return True
            return following in CLOSERS | {"with", "and"} and self._is_storeyed_adverb(index)
        return word in ("downstair", "downstairs")

    def _is_storeyed_adverb(self, index: int) -> bool:
        """Whether a final "above" or "below" is an adverb of place: its opposite stands in the brief too."""
        texts = {token.text for token in self.reading.tokens}
        return bool(
            {"above", "below"} <= texts
            or ("above" in texts and texts & {"downstair", "downstairs", "basement", "ground", "below"})
            or ("below" in texts and texts & {"upstair", "upstairs", "middle", "uppermost", "top"})
        )

    def _ends_clause(self, index: int) -> bool:
        return self.has_floors and (self.reading.breaks(index) or self.reading.word(index) in CLOSERS)

    def top(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "the top floor", "the rooftop", "under the roof"."""
        reading = self.reading
        word, following = reading.word(index), reading.word(index + 1)
        single = word in TOPS and not reading.plural(index + 1)
        if following in FLOOR_WORDS and (single or word in ("rooftop", "roof", "attic", "loft", "mansard", "garret")):
            return [FloorRef("top")], index + 2
        if self._is_roof(index) or self._is_top(index) or self._is_under_roof(index):
            return [FloorRef("top")], index + 1
        if self._is_on_top_of_it(index):
            return [FloorRef("top")], index + 3
        ours = word == "loft" and reading.word(index - 1) in ("our", "my")  # a flat
        attic = word in ("attic", "loft") and (following == ":" or self._is_place(index)) and not ours
        attic = attic or self._is_attic_storey(index) or (not ours and self._is_attic_in_list(index))
        highest = word in ("uppermost", "topmost", "highest") and self._names_storey(index)
        if attic or highest or self._is_at_the_top(index):
            return [FloorRef("top")], index + 1
        return None

    def _is_attic_storey(self, index: int) -> bool:
        """Whether an attic is spoken of that was counted as a storey before: "the attic holds three rooms"."""
        reading = self.reading
        if reading.word(index) not in ("attic", "loft") or reading.word(index - 1) != "the":
            return False
        counted = any(
            (token.text == reading.word(index) and at in reading.taken)
            or (token.text in FLOOR_WORDS and reading.word(index) in reading.text[token.start : token.end].lower())
            for at, token in enumerate(reading.tokens[:index])
        )
        opens = reading.starts(index - 1) or reading.word(index - 2) in (";", ",", "and")
        return counted and (
            (opens and reading.word(index + 1) in HOLDING_ROOMS) or reading.word(index - 2) in ("in", "on")
        )

    def _is_attic_in_list(self, index: int) -> bool:
        """Whether an attic follows storeys of the same form: "first floor with four bedrooms; attic with two"."""
        reading = self.reading
        if reading.word(index) not in ("attic", "loft") or not reading.starts(index):
            return False
        verb = reading.word(index + 1)
        alike = any(
            token.text in FLOOR_WORDS and reading.word(at + 1) == verb and at in reading.taken
            for at, token in enumerate(reading.tokens[:index])
        )
        return verb in ("with", "has", "have") and alike

    def _is_roof(self, index: int) -> bool:
        """Whether a roof stands for the top storey: "under the roof", "on the rooftop"."""
        reading = self.reading
        word, following = reading.word(index), reading.word(index + 1)
        # "under the roof on the third": the storey that is named counts.
        if word == "roof" and reading.words(index - 2, index) == ("under", "the") and following not in FLOOR_WORDS:
            return True
        if word not in ("rooftop", "roof") or following in ("terrace", "garden", "bar", "deck"):
            return False
        led = reading.word(index - 1) in ("the", "on") and reading.word(index - 2) in ("on", "")
        return led and index not in reading.mention_at

    def _is_under_roof(self, index: int) -> bool:
        """Whether "rooftop" or "attic" before a room says where the room is: "a rooftop bar", "an attic study"."""
        reading = self.reading
        if reading.word(index) not in ("rooftop", "roof-top", "attic") or reading.word(index - 1) not in _ARTICLES:
            return False
        own = reading.mention_at.get(index)
        room = reading.mention_at.get(index + 1)
        alone = own is None or own.last == index + 1
        return alone and room is not None and bool(room.room) and reading.word(index + 1) not in _ON_ROOFS

    def _is_top(self, index: int) -> bool:
        """Whether "top" stands for the top storey: "top: a bar", "the top is a bar", "and on top a terrace"."""
        reading = self.reading
        word, lead, following = reading.word(index), reading.word(index - 1), reading.word(index + 1)
        led = lead in ("the", "on", "very", "at") or reading.starts(index)
        if word in ("top", "topp") and led and following in CLOSERS | COPULAS | _AFTER_TOP:
            return True
        opens = lead == "on" and (reading.starts(index - 1) or reading.word(index - 2) in (",", "and"))
        return word == "top" and opens and following in ("a", "an", "our")

    def _is_on_top_of_it(self, index: int) -> bool:
        """Whether "top" opens "top of it" in "on top of it a bar", and no number of storeys follows."""
        reading = self.reading
        if reading.words(index - 1, index + 2) != ("on", "top", "of"):
            return False
        storeyed = not FLOOR_WORDS.isdisjoint(reading.words(index + 3, index + 7))  # "on top of it sit two floors"
        return not storeyed and reading.word(index + 2) in ("it", "that", "them", "this", "these")

    def _is_at_the_top(self, index: int) -> bool:
        """Whether "top" is where something is: "at the top a bar"."""
        reading = self.reading
        very = reading.word(index - 1) == "very"
        placed = reading.words(index - 2 - very, index - very) == ("at", "the") and reading.word(index) == "top"
        follows = reading.word(index + 1) in ("a", "an") or self._counts(index + 1)
        return placed and self.has_floors and (follows or (very and reading.word(index + 1) in _PLACED_BELOW))

    def _leads_list(self, index: int) -> bool:
        """Whether "above" leads the rooms of the storey above: "a garage and a shop, above two flats"."""
        reading = self.reading
        if not (reading.starts(index) or reading.word(index - 1) == ","):
            return False
        mention = reading.mention_at.get(index + 1)
        named = mention is not None and mention.plural and bool(mention.room or mention.building)
        several = reading.plural(index + 2) or reading.value(index + 1) > 1
        return named or (self._counts(index + 1) and several)

    def _is_place(self, index: int) -> bool:
        """Whether an attic is only where other rooms are: "in the attic two bedrooms", "attic nursery and study"."""
        reading = self.reading
        following = reading.mention_at.get(index + 1)
        if reading.starts(index) and following is not None and following.room:
            return True
        inside = reading.words(index - 2, index) == ("in", "the")
        opens = reading.starts(index - 2) or reading.word(index - 3) in (",", ";", "and")
        goes_on = reading.word(index + 1) in ("a", "an", "the", "are", "there", ",", "with") or self._counts(index + 1)
        others = [i for i, token in enumerate(reading.tokens) if token.text == reading.word(index) and i != index]
        return inside and ((opens and goes_on) or reading.word(index + 1) in CLOSERS) and not others

    def _after_dwelling(self, index: int) -> bool:
        """Whether a flat stands right before a token: "a shop with a flat above"."""
        return self.reading.word(index - 1) in ("flat", "apartment", "maisonette", "dwelling", "studio", "penthouse")

    def _counts(self, index: int) -> bool:
        """Whether a number of things stands at a token."""
        return self.reading.kind(index) == "number" and self.reading.kind(index + 1) == "word"

    def _names_storey(self, index: int) -> bool:
        """Whether "the lowest", "the middle one", "the uppermost" open a clause of a brief of several storeys."""
        reading = self.reading
        opens = reading.starts(index - 1) or reading.word(index - 2) in (";", ",", "and", "with", ":")
        following = reading.word(index + 1)
        return (
            reading.word(index - 1) == "the"
            and opens
            and self.has_floors
            and (following in COPULAS | {"a", "an", "the", "get", "for", ":"} or reading.kind(index + 1) == "number")
        )

    def _is_elliptic(self, index: int) -> bool:
        """Whether "on the lower one" speaks of a storey: the brief counts some, and nothing else comes before."""
        reading = self.reading
        led = reading.word(index - 1) == "the" and reading.word(index - 2) in ("on", "in", "at")
        return self.has_floors and led and (reading.starts(index - 2) or reading.word(index - 3) in (",", "and", ";"))

    def upper(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "upstairs", "the upper floors", "above", and the storeys in the middle."""
        reading = self.reading
        word, following = reading.word(index), reading.word(index + 1)
        if word in ("upper", "higher", "other") and following in FLOOR_WORDS:
            return self._upper_range(index) or ([FloorRef("upper")], index + 2)
        called = word in UPSTAIRS and reading.word(index - 1) == "the" and reading.plural(index + 1)
        if called and following in FLOOR_WORDS:
            return [FloorRef("upper")], index + 2  # "the bedroom storeys"
        if word == "lower" and following in FLOOR_WORDS and reading.plural(index + 1):
            return [FloorRef("lower")], index + 2
        if self._is_upper(index) or self._is_above(index):
            return [FloorRef("upper")], index + 1
        if self._is_upper_one(index):
            return [FloorRef("upper")], index + 2
        if reading.words(index, index + 4) == ("all", "the", "way", "up") and reading.word(index + 4) in CLOSERS:
            return [FloorRef("upper")], index + 4
        if word == "main" and following in FLOOR_WORDS and self._lies_between():
            return [FloorRef("middle")], index + 2
        if word == "middle" and (following in FLOOR_WORDS or (following == "one" and self._names_storey(index + 1))):
            return [FloorRef("middle")], index + 2
        return ([FloorRef("middle")], index + 1) if self._is_middle(index) else None

    def _lies_between(self) -> bool:
        """Whether a storey at the bottom and one at the top are named beside the main one."""
        texts = {token.text for token in self.reading.tokens}
        return bool(texts & {"bottom", "lowest"}) and bool(texts & {"top", "uppermost"})

    def _upper_range(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "upper floors 2-4"."""
        reading = self.reading
        low, high = reading.value(index + 2), reading.value(index + 4)
        ranged = reading.word(index + 3) in ("-", "–", "to") and 0 < low < high <= 100
        if not ranged or not reading.kind(index + 2) == reading.kind(index + 4) == "number":
            return None
        shift = int(low == 1)  # "upper floors 1-3" lie above the ground floor
        return [FloorRef("range", int(low) + shift, int(high) + shift)], index + 5

    def _is_upper(self, index: int) -> bool:
        """Whether a token stands for the upper floors: "upstairs", "Upper: two bedrooms", "up:"."""
        reading = self.reading
        word, lead, following = reading.word(index), reading.word(index - 1), reading.word(index + 1)
        if word == "upper" and following in (":", ",") and lead == "the":
            return True
        if word == "upper" and self._is_after_on(index):
            return True
        if word in ("upper", "og") and reading.starts(index) and following in (":", "-", "–"):
            return True
        if word == "up":
            stays = self.has_floors and following in CLOSERS and lead in _STAYS
            return stays or (following == ":" and reading.starts(index))
        return word in ("upstair", "upstairs") or (word == "og" and following in CLOSERS)

    def _is_above(self, index: int) -> bool:
        """Whether "above" stands for the upper floors: "above are two flats", "a shop with a flat above"."""
        reading, following = self.reading, self.reading.word(index + 1)
        if reading.word(index) != "above":
            return False
        if reading.starts(index) and following in (":", ",", "are", "is", "there", "we", "i", "you", "a"):
            return True
        listed = reading.word(index - 1) == ","
        if following in CLOSERS | {"with"} and (self._is_storeyed_adverb(index) or listed):
            return True
        if following == "and" and "below" in {token.text for token in reading.tokens}:
            return True  # "with the bedrooms above and the kitchen below"
        return self._leads_list(index) or (following in CLOSERS | {"for"} and self._after_dwelling(index))

    def _is_upper_one(self, index: int) -> bool:
        """Whether two words stand for the upper floors: "on the upper one", "higher up", "above it"."""
        reading = self.reading
        word, following = reading.word(index), reading.word(index + 1)
        if (word, following) == ("higher", "up") or (
            (word, following) == ("upper", "one") and self._is_elliptic(index)
        ):
            return True
        relative = word in ("over", "above") and following in ("it", "that", "them") and self._ends_clause(index + 2)
        return relative and reading.word(index - 1) not in FLOOR_WORDS

    def _is_after_on(self, index: int) -> bool:
        """Whether "on the upper," and "on lower" name a storey in brief."""
        reading = self.reading
        at = index - 1 - (reading.word(index - 1) == "the")
        return self.has_floors and reading.word(at) == "on" and reading.word(index + 1) in CLOSERS

    def _names_storeys(self) -> bool:
        """Whether the brief speaks of several storeys: with one alone, "in the middle" is a place on it."""
        tokens = self.reading.tokens
        named = sum(t.text in FLOOR_WORDS | {"ground", "upstairs", "downstairs"} or t.kind == "level" for t in tokens)
        return named > 1

    def _is_centre(self, index: int) -> bool:
        """Whether "in the middle" is the centre of a storey: nothing in its sentence is at the top or the bottom."""
        reading = self.reading
        said_after = (
            reading.word(index - 2) == "in" and not reading.starts(index - 2) and reading.word(index + 1) == ","
        )
        if not said_after:
            return False
        said = {
            token.text for at, token in enumerate(reading.tokens) if reading.sentence[at] == reading.sentence[index]
        }
        return said.isdisjoint({"top", "bottom", "above", "below", "underneath", "attic"})

    def _is_middle(self, index: int) -> bool:
        """Whether "middle" stands for the storeys in between: "Middle: three flats", "in the middle two offices"."""
        reading, following = self.reading, self.reading.word(index + 1)
        if reading.word(index) not in ("middle", "mid") or self._is_centre(index):
            return False
        if following in (":", "=") and reading.starts(index):
            return True
        inside = reading.words(index - 2, index) == ("in", "the") and reading.word(index - 3) not in _WITH_MIDDLES
        goes_on = following in CLOSERS | {"with", "there", "are", "is", "come", "we", "a", "an"}
        goes_on = goes_on and (following not in CLOSERS or self._names_storeys())
        return self.has_floors and inside and (goes_on or self._counts(index + 1))


_WITH_MIDDLES = frozenset({"courtyard", "yard", "patio", "garden", "atrium", "cloister", "stair"})
"""What has a middle of its own: "a courtyard in the middle"."""
