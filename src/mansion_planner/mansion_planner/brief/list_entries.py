"""Find entries of lists of rooms that nobody knows: "vivarium and cage wash", "packing" between two known rooms."""

from dataclasses import dataclass
from functools import cached_property

from mansion_knowledge.common_words import common_words
from mansion_planner.brief.idle_words import is_idle_word
from mansion_planner.brief.phrase import PEOPLE, PLAIN, Phrase, finished_phrase, name_of
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.room_users import PEOPLE_APART
from mansion_planner.brief.similarity import elliptic_room_type, similar_room_type

__all__ = ["LIST_STARTS", "NO_ROOMS", "listed_unknowns"]

LIST_STARTS = frozenset({":", ",", "and", "a", "an", "the", "one", "*", "-", "|", "plus", "&", "\n", "="})
_LIST_ENDS = frozenset(
    {
        ",",
        ".",
        ";",
        "and",
        "|",
        "\n",
        "",
        "(",
        "next",
        "beside",
        "plus",
        "&",
        "with",
        "on",
        "in",
        "adjacent",
        "adjoining",
    }
)


def listed_unknowns(reading: Reading, chunks: list[tuple[int, int]], phrases: list[Phrase]) -> list[Phrase]:
    """Return the entries of lists of rooms that nobody knows ("vivarium and cage wash"), as rooms of the nearest kind.

    Only where rooms stand in the same sentence, or a storey's heading opens it: other unknown words are no rooms.
    """
    rooms = [phrase for phrase in phrases if phrase.head == "room"]
    named = _Named(
        sentences={reading.sentence[phrase.first] for phrase in rooms},
        begins={phrase.begin for phrase in rooms},
        ends={phrase.last for phrase in phrases if phrase.head in ("room", "building")},
        things={phrase.last for phrase in phrases if phrase.head == "object"},
        furniture={phrase.begin for phrase in phrases if phrase.head == "object"},
    )
    found: list[Phrase] = []
    for begin, end in chunks:
        if not reading.free(begin, end) or end - begin > 3 or not _Entry(reading, begin, end, named).is_room():
            continue
        name = name_of(reading, begin, end)
        elliptic = "" if reading.plural(end - 1) else elliptic_room_type(reading.words(begin, end), reading.knowledge)
        kind = elliptic or similar_room_type(name, reading.knowledge)
        phrase = finished_phrase(reading, "room", begin, end, room=kind, known=bool(elliptic))
        reading.take(phrase.first, phrase.last)
        named.ends.add(phrase.last)
        found.append(phrase)
    return found


@dataclass(frozen=True)
class _Named:
    """Where a brief names rooms and furniture.

    Attributes
    ----------
    sentences : set of int
        Sentences with rooms.
    begins, ends : set of int
        First tokens of rooms, and the tokens after them.
    things : set of int
        The tokens after furniture.
    furniture : set of int
        The first tokens of furniture.
    """

    sentences: set[int]
    begins: set[int]
    ends: set[int]
    things: set[int]
    furniture: set[int]


@dataclass(frozen=True)
class _Entry:
    """Words that nobody knows, tokens `begin` to `end` (exclusive), which may be an entry of a list of rooms."""

    reading: Reading
    begin: int
    end: int
    named: _Named

    def is_room(self) -> bool:
        """Whether they name a room."""
        told = self._measured or self._divided or self._headed
        if not told and self.reading.sentence[self.begin] not in self.named.sentences:
            return False
        if not self._measured and (not self._is_listed() or self._goes_on_furniture()):
            return False
        if self._are_spoken_of():
            return False
        return not self._is_content() and not self._is_no_name() and not self._is_where_it_stands()

    def _are_spoken_of(self) -> bool:
        """Whether they are things that everybody knows and the brief only speaks of: "the dust and the sparks"."""
        single = self.end - self.begin == 1 and not self._measured
        return single and self._plural and self._before == "the" and self.reading.word(self.begin) in common_words()

    def _is_where_it_stands(self) -> bool:
        """Whether they name the town of the building rather than a room: "a house in Berlin of 120 m2"."""
        first = self.reading.tokens[self.begin]
        return first.capital and self._before in ("in", "of", "near", "at", "from") and not self._headed

    @property
    def _before(self) -> str:
        return self.reading.word(self.begin - 1)

    @property
    def _after(self) -> str:
        return self.reading.word(self.end)

    @property
    def _plural(self) -> bool:
        return self.reading.plural(self.end - 1)

    @property
    def _counted(self) -> bool:
        return self.reading.kind(self.begin - 1) == "number" and self.begin - 1 not in self.reading.taken

    @property
    def _measured(self) -> bool:
        return _has_measure(self.reading, self.end)

    @cached_property
    def _headed(self) -> bool:
        """Whether the heading of a storey opens the sentence."""
        reading = self.reading
        start = reading.sentence.index(reading.sentence[self.begin])
        if any(i in reading.taken and reading.word(i) == ":" for i in range(start, self.begin)):
            return True
        return start in reading.taken and reading.word(start) not in LIST_STARTS

    @property
    def _divided(self) -> bool:
        """Whether a semicolon goes on with a list: "a library; scriptorium; a kitchen"."""
        goes_on = self._before == ";" and self.reading.sentence[self.begin] - 1 in self.named.sentences
        closed = self._after in (";", "with", "(", ".", "")
        return goes_on and closed and self.end - self.begin <= 2 and not self._plural

    def _is_listed(self) -> bool:
        """Whether a mark, a joint or a number leads an entry, and a mark or a joint closes it."""
        if self._divided:
            return True
        lead = self.reading.word(self.begin - 2)
        marked = self._before in (":", ",", "and", "|", "-", "*", "&", "\n")
        article = self._before in ("a", "an", "the", "one") and lead in (",", "and", ":", "a", "|", "with", "has")
        if self._is_foreign() or self._is_counted_behind:
            return True
        opens = marked or article or self._counted or self.begin - 1 in self.reading.taken
        return opens and (self._after in _LIST_ENDS or self._is_for_many or self._is_kept_apart)

    @property
    def _is_kept_apart(self) -> bool:
        """Whether "not next to" follows: "a cattery, quarantine not next to the cattery"."""
        beside = {"next", "beside", "near", "adjacent", "touching", "close"}
        return self._after == "not" and self.reading.word(self.end + 1) in beside

    def _is_foreign(self) -> bool:
        """Whether a word of another language stands where a room does: "beside the Stube", "one numaru for tea"."""
        reading, lead = self.reading, self.reading.word(self.begin - 2)
        if self.end - self.begin != 1 or self.reading.word(self.begin) in common_words():
            return False
        beside = self._before == "the" and (
            lead in _BESIDE or reading.words(self.begin - 3, self.begin - 1) == ("next", "to")
        )
        beside = beside or (self._before == "the" and lead == "and" and self.begin - 2 in self.named.ends)
        told = (
            self._before == "the"
            and reading.starts(self.begin - 1)
            and self._after in ("lie", "is", "(", "lies", "has")
        )
        counted = self._counted and self._after in ("for", "with", "of", "on", "in") and not self._plural
        return beside or told or counted

    @property
    def _is_counted_behind(self) -> bool:
        """Whether "x3" follows: "make-up x3, wardrobe"."""
        marked = self._before in (",", ":", ";") or self.reading.starts(self.begin)
        return marked and self._after == "x" and self.reading.kind(self.end + 1) == "number"

    @property
    def _is_for_many(self) -> bool:
        """Whether a number of people follows: "guest Stube for 60 with a stove"."""
        many = self._after == "for" and self.reading.kind(self.end + 1) == "number"
        return many and self.reading.kind(self.end + 2) != "unit" and self._before in (",", ":", "and", "a", "one")

    def _goes_on_furniture(self) -> bool:
        """Whether a bare noun goes on with what a room holds: "a hall with a bed, chest and desk"."""
        bare = self._before in (",", "and", "&", "|") and not self._counted
        if not bare or self.begin - 1 in self.named.ends:
            return False
        if self.begin - 2 in self.named.ends and self.reading.word(self.begin - 2) == ",":
            return False
        if self._before == "," and self._follows_room():
            return False
        between = self._before == "," and self.begin - 1 in self.named.things and self._headed and self._after == ","
        between = between and not self._plural
        return not (between and (self.end + 1 in self.named.begins or self.reading.word(self.end + 2) == ","))

    def _follows_room(self) -> bool:
        """Whether the entry before is a room of which only its size was told: "a paint shop (90 m2), joinery"."""
        reading = self.reading
        end = max((last for last in self.named.ends if last < self.begin), default=-1)
        thing = max((last for last in self.named.things if last < self.begin), default=-1)
        sized = all(
            reading.kind(at) in ("number", "unit", "mark") or reading.word(at) in _OF_THE_ROOM_BEFORE
            for at in range(end, self.begin)
        )
        between = reading.words(max(end, 0), self.begin)
        beside = not _BESIDE_WORDS.isdisjoint(between) and len(between) < _NEAR
        sized = sized or (beside and {"with", "has", "for", "and"}.isdisjoint(between))
        near = end >= 0 and reading.sentence[end - 1] == reading.sentence[self.begin] and self.begin - end <= _NEAR
        return near and thing < end and sized and not self._plural

    def _is_content(self) -> bool:
        """Whether they name people or furniture in a room."""
        reading, begin, lead = self.reading, self.begin, self.reading.word(self.begin - 2)
        if self._before in ("a", "an") and lead == "and" and begin - 2 in self.named.things:
            return True  # "each with a bed and a chest"
        if self._before in ("a", "an") and lead == "with" and self._precedes_furniture():
            return True  # "a kitchen with an island and four bar stools"
        if self._before == "the" and lead == "," and reading.word(begin - 3) in ("we", "us", "i"):
            return True  # "we, the owners, live downstairs"
        if not self._plural or reading.kind(begin - 1) != "number":
            return False
        if lead == "for" or lead in _HOLDS:
            return True  # "a bay for three engines", "a hall holding eight steel tanks"
        people = reading.word(self.end - 1).endswith(("er", "or", "ist", "ant", "ian", "eer"))
        return people and self._counted  # "30 consultants"

    def _precedes_furniture(self) -> bool:
        """Whether furniture goes on right after them: "... and four bar stools"."""
        joined = self._after in ("and", "&", ",")
        return joined and any(self.end < first <= self.end + 4 for first in self.named.furniture)

    def _is_no_name(self) -> bool:
        """Whether they say how a room is: "a penthouse of 210 m2, art deco"."""
        word = self.reading.word(self.end - 1)
        place = self._before in ("of", "in", "near") and self.reading.tokens[self.begin].capital
        if place and any(m.building and m.last == self.begin - 1 for m in self.reading.mentions):
            return True  # "an apartment of Paris with 62 m2"
        if word in PLAIN or word.endswith(("ly", "ed")) or word in NO_ROOMS:
            return True
        single = self.end - self.begin == 1 or self.reading.word(self.begin) == "some"
        if single and self._counted and word in PEOPLE_APART | PEOPLE:
            return True  # "showers for 20 men and 10 women"
        if single and (self._counted or self._plural) and is_idle_word(word):
            return True  # "three generations", "some stay six months"
        if word in _WHOLES and PLAIN.issuperset(self.reading.words(self.begin, self.end - 1)):
            return True  # "a café in a building of 170 m2"
        if word in _STRENGTHS and self.end - self.begin == 1:
            return True  # "on the second floor right next to the archive"
        return any(m.style and (m.first, m.last) == (self.begin, self.end) for m in self.reading.mentions)


def _has_measure(reading: Reading, end: int) -> bool:
    """Whether an area follows that can only be of what stands before it: "men's majlis 40 m2", "arena (250 m2)"."""
    index = end + (reading.word(end) in ("(", "of", "-", "=", "with", "–"))
    index += reading.word(index) in ("about", "approx", "around", "ca", "roughly")
    return reading.kind(index) == "number" and index in reading.taken and reading.kind(index + 1) == "unit"


_OF_THE_ROOM_BEFORE = frozenset({"of", "each"})
_BESIDE_WORDS = frozenset({"next", "beside", "adjacent", "adjoining", "touching", "near", "off", "behind"})
"""Words that place the room before, in a list of rooms."""
_NEAR = 12
"""Tokens between a room with its size and the next entry of a list, at most."""
_BESIDE = frozenset({"beside", "between", "adjoining", "adjoin", "touching", "near", "by", "facing"})
_HOLDS = frozenset("holding containing with houses housing has have holds".split())
NO_ROOMS = frozenset(
    """
    surface built gfa extension capacity volume rest remainder minimum maximum footprint group team year department
    style look feel window door wall ceiling roof floor view light noise smell garden outside street visitor guest
    cat dog kitten puppy
    gate fence plot river lake sea hill park field forest material colour color area interior facade terrace steps
    step ramp way time year day night week money budget lot plenty kind sort type size shape plan layout entrance
    access room place part one none whole wood oak brick stone glass steel concrete marble gold silver white black
    green blue red furniture gross net total rectangle footprint square thing stuff number largest biggest smallest
    rent own occupy aisle playground courtyard
    other larger smaller bigger star escape dust water power heating cooling air sun daylight privacy quiet peace m
    metre meter roof region order vicinity neighbourhood neighborhood altogether totality
    skylight rooflight dormer chimney h haha lol generation side symbol abt bit month latter former
    st ea adj approx spectacular stunning ground first thought think guess reckon say site facility facilities
    opportunity potential above below underneath beneath overhead alongside nearby opposite adjacent outdoors indoors
    """.split()
)

_WHOLES = frozenset({"building", "premise", "property", "structure"})
"""Nouns of all that is built."""

_STRENGTHS = frozenset({"right", "immediately", "close", "close-by", "hard"})
"""Adverbs that only strengthen where something is."""
