"""Read storeys that have a name of their own: the ground floor, the basement, the top floor, "upstairs", "middle"."""

from mansion_planner.brief.facts import FloorRef
from mansion_planner.brief.reading import FLOOR_WORDS, Reading
from mansion_planner.brief.storey_counts import CLOSERS

__all__ = ["COPULAS", "TOPS", "NamedStoreys"]

_STREET = frozenset(
    """
    ground gnd street entrance entry garden courtyard water lobby arrival bottom lowest lower public shop pavement
    """.split()
)
TOPS = frozenset({"top", "uppermost", "topmost", "highest", "last", "final"})
COPULAS = frozenset(
    """
    is are be has have hold contain house carry belong will stay
    """.split()
)


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
        last = index + 2 if following in FLOOR_WORDS else index + 1
        if mention is not None and mention.last > last:
            return None
        if reading.word(index - 1) in ("wine", "beer", "root", "coal", "finished"):
            return None
        if word in ("underground", "subterranean") and following not in FLOOR_WORDS:
            predicate = reading.word(index - 1) in COPULAS | {"lie", "go", "all"} and following in CLOSERS
            return ([FloorRef("basement")], last) if predicate else None
        return [FloorRef("basement")], last

    def ground(self, index: int) -> tuple[list[FloorRef], int] | None:
        """Read "the ground floor", "street level", "downstairs", "at grade"."""
        reading = self.reading
        word, following = reading.word(index), reading.word(index + 1)
        ground = [FloorRef("number", 1, 1)]
        if word in _STREET and following in FLOOR_WORDS and not reading.plural(index + 1):
            return ground, index + 2
        if reading.words(index, index + 4) == ("level", "of", "the", "street"):
            return ground, index + 4
        if word == "lower" and following in (":", ",") and reading.word(index - 1) == "the":
            return ground, index + 1
        if word in ("lower", "bottom", "lowest") and following == "one" and self._is_elliptic(index):
            return ground, index + 2
        if word in ("downstair", "downstairs"):
            return ground, index + 1
        if (
            word in ("eg", "gnd")
            and following in CLOSERS | {"has", "with"}
            and reading.word(index - 1) in ("the", "in", "")
        ):
            return ground, index + 1
        if word == "g" and following == ":" and reading.starts(index):
            return ground, index + 1
        if word in ("gf", "g/f", "gnd") and following in CLOSERS | {"has", "with"}:
            return ground, index + 1
        if word in ("ff", "sf") and following in CLOSERS and self.british:
            return [FloorRef("number", 2 + (word == "sf"), 2 + (word == "sf"))], index + 1
        if word == "at" and following == "grade":
            return ground, index + 2
        if (
            word == "ground"
            and (following in CLOSERS or following in ("and", "there", "has", "is", "also"))
            and (
                reading.word(index - 1) in ("the", "on", "at")
                or reading.starts(index)
                or (reading.word(index - 1) == "in" and reading.starts(index - 1))
            )
        ):
            return ground, index + 1
        if word == "ground" and following in ("for", "has", "hold") and reading.word(index - 1) in (":", ";"):
            return ground, index + 1
        if (
            word == "bottom"
            and (following in CLOSERS | COPULAS | {"with", "and", "a", "an"} or self._counts(index + 1))
            and reading.word(index - 1) in ("the", "at", "from")
        ):
            return None if reading.word(index - 2) == "from" else (ground, index + 1)
        if (word == "bottom" or (word == "down" and reading.starts(index))) and following == ":":
            return ground, index + 1
        if word == "bottom" and reading.word(index - 1) == "very" and reading.word(index - 2) in ("the", "at"):
            return ground, index + 1
        if word == "lowest" and self._names_storey(index):
            return ground, index + 1
        if word == "below" and (
            (reading.starts(index) and following in (":", "is", "are", "there", ",", "the", "we", "i", "you", "a"))
            or (following in CLOSERS | {"with"} and self._is_storeyed_adverb(index))
        ):
            return ground, index + 1
        if (
            word == "down"
            and self.has_floors
            and following in CLOSERS
            and reading.word(index - 1) in ("stay", "is", "are", "go")
        ):
            return ground, index + 1
        return None

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
        if word in TOPS and following in FLOOR_WORDS and not reading.plural(index + 1):
            return [FloorRef("top")], index + 2
        if word in ("rooftop", "roof") and following in FLOOR_WORDS:
            return [FloorRef("top")], index + 2
        if word == "roof" and reading.words(index - 2, index) == ("under", "the") and following not in FLOOR_WORDS:
            # "under the roof on the third": the storey that is named counts.
            return [FloorRef("top")], index + 1
        if (
            word in ("rooftop", "roof")
            and following not in ("terrace", "garden", "bar", "deck")
            and (
                index not in reading.mention_at
                and reading.word(index - 1) in ("the", "on")
                and reading.word(index - 2) in ("on", "")
            )
        ):
            return [FloorRef("top")], index + 1
        led = reading.word(index - 1) in ("the", "on", "very", "at") or reading.starts(index)
        if (
            word in ("top", "topp")
            and led
            and (
                following
                in CLOSERS
                | COPULAS
                | {"with", "and", "there", "nothing", "only", "two", "one", "become", "we", "the", "sit", "come"}
            )
        ):
            return [FloorRef("top")], index + 1
        opens = reading.word(index - 1) == "on" and (
            reading.starts(index - 1) or reading.word(index - 2) in (",", "and")
        )
        if word == "top" and opens and following in ("a", "an", "our"):
            return [FloorRef("top")], index + 1
        over = reading.words(index - 1, index + 2) == ("on", "top", "of")
        over = over and FLOOR_WORDS.isdisjoint(reading.words(index + 3, index + 7))  # "on top of it sit two floors"
        if over and reading.word(index + 2) in ("it", "that", "them", "this", "these"):
            return [FloorRef("top")], index + 3
        edge = reading.words(index - 2, index) == ("at", "the") and (
            following in ("a", "an") or self._counts(index + 1)
        )
        if word == "top" and edge and self.has_floors:
            return [FloorRef("top")], index + 1
        if word in ("attic", "loft") and (following == ":" or self._is_place(index)):
            return [FloorRef("top")], index + 1
        if word in ("uppermost", "topmost", "highest") and self._names_storey(index):
            return [FloorRef("top")], index + 1
        return None

    def _leads_list(self, index: int) -> bool:
        """Whether "above" leads the rooms of the storey above: "a garage and a shop, above two flats"."""
        reading = self.reading
        if not (reading.starts(index) or reading.word(index - 1) == ","):
            return False
        mention = reading.mention_at.get(index + 1)
        named = mention is not None and mention.plural and bool(mention.room or mention.building)
        return named or (self._counts(index + 1) and reading.plural(index + 2))

    def _is_place(self, index: int) -> bool:
        """Whether an attic is only where other rooms are: "in the attic two bedrooms", "attic nursery and study"."""
        reading = self.reading
        following = reading.mention_at.get(index + 1)
        if reading.starts(index) and following is not None and following.room:
            return True
        inside = reading.words(index - 2, index) == ("in", "the")
        opens = reading.starts(index - 2) or reading.word(index - 3) in (",", ";", "and")
        goes_on = reading.word(index + 1) in ("a", "an", "are", "there", ",", "with") or self._counts(index + 1)
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
        upper = [FloorRef("upper")]
        if word in ("upstair", "upstairs"):
            return upper, index + 1
        if word == "upper" and following == "one" and self._is_elliptic(index):
            return upper, index + 2
        if word == "upper" and following in (":", ",") and reading.word(index - 1) == "the":
            return upper, index + 1
        if word in ("upper", "higher", "other") and following in FLOOR_WORDS:
            low, high = reading.value(index + 2), reading.value(index + 4)
            ranged = reading.word(index + 3) in ("-", "–", "to") and 0 < low < high <= 100
            if ranged and reading.kind(index + 2) == reading.kind(index + 4) == "number":
                shift = int(low == 1)  # "upper floors 1-3" lie above the ground floor
                return [FloorRef("range", int(low) + shift, int(high) + shift)], index + 5
            return upper, index + 2
        if word in ("lower",) and following in FLOOR_WORDS and reading.plural(index + 1):
            return [FloorRef("lower")], index + 2
        if word == "higher" and following == "up":
            return upper, index + 2
        if word == "above" and (
            (reading.starts(index) and following in (":", ",", "are", "is", "there", "we", "i", "you", "a"))
            or (following in CLOSERS | {"with"} and (self._is_storeyed_adverb(index) or reading.word(index - 1) == ","))
        ):
            return upper, index + 1
        if word == "above" and self._leads_list(index):
            return upper, index + 1
        if word == "above" and following in CLOSERS | {"for"} and self._after_dwelling(index):
            return upper, index + 1
        if word in ("upper", "og") and reading.starts(index) and following in (":", "-", "–"):
            return upper, index + 1
        if word == "og" and following in CLOSERS:
            return upper, index + 1
        if word == "up" and reading.starts(index) and following == ":":
            return upper, index + 1
        relative = word in ("over", "above") and following in ("it", "that", "them") and self._ends_clause(index + 2)
        if relative and reading.word(index - 1) not in FLOOR_WORDS:
            return upper, index + 2
        if word == "middle" and (following in FLOOR_WORDS or (following == "one" and self._names_storey(index + 1))):
            return [FloorRef("middle")], index + 2
        if word == "middle" and following in (":", "=") and reading.starts(index):
            return [FloorRef("middle")], index + 1
        if (
            word == "middle"
            and reading.words(index - 2, index) == ("in", "the")
            and reading.word(index - 3) not in ("courtyard", "yard", "patio", "garden", "atrium", "cloister", "stair")
            and (
                following in CLOSERS | {"with", "there", "are", "is", "come", "we", "a", "an"}
                or self._counts(index + 1)
            )
            and self.has_floors
        ):
            return [FloorRef("middle")], index + 1
        return None
