"""Give rooms and furniture the storeys that the brief names for them, by where the two stand in its sentences.

A reference that opens a clause ("On the second floor ...", "Level 2: ...", a heading of its own line) leads what
follows it; one right after a list ("a gym and a sauna on the top floor") belongs to the list; one right before a
noun ("a ground-floor cafeteria") to that noun alone.
"""

import itertools
from dataclasses import dataclass, replace

from mansion_planner.brief.facts import FloorRef
from mansion_planner.brief.phrase import FUNCTION_WORDS, PEOPLE, Phrase
from mansion_planner.brief.reading import Place, Reading
from mansion_planner.brief.storey_counts import HOLDING

__all__ = ["Attachment", "attach_storeys"]

_SHARED_OUT = frozenset({"spread", "distributed", "divided", "split", "evenly", "total", "altogether"})
_GLUE = frozenset(
    """
    is are be goes go stay stays sit sits lie lies located situated placed both all only right directly up that
    which become stand kept share should must will shall belong take takes occupy occupies fills fill come found needed
    wanted can could may might down shown housed displayed move moves moved ,
    on in at to entirely mostly alone as well too also each one apiece most much of occupy therefore be well
    """.split()
)
_BESIDE = frozenset("its side next door adjacent adjoining beside by each other one another to it".split())
"""Words of a relation between a room and its storey: "with a scullery at its side on the lower floor"."""
_OPENERS = frozenset(
    """
    , and while but : ( where then - – | with plus whereas also finally
    """.split()
)
_MANY = 10
"""Rooms of a kind that no storey is likely to have each."""
_JOINTS = frozenset(
    """
    and a an the & + one , large small its own as well plus both another two three
    """.split()
)

_AND = frozenset({"and", "&", "+"})

_UP_AND_DOWN = {"upstairs": "up", "upstair": "up", "downstairs": "down", "downstair": "down"}
"""Adverbs that end a list of the rooms of a storey."""


_PLACED = frozenset({"shown", "housed", "displayed", "located", "situated", "placed", "kept", "is", "are"})
"""What is said of a room before its storey: "temporary exhibitions are shown upstairs, where ..."."""
_ASIDES = frozenset({"being", "which", "because", "since", "as"})
"""Words that open a reason or a remark between a room and what is said of it: "the archive, being heavy, belongs"."""
_LONGEST_ASIDE = 8
_LONGEST_QUALITY = 4
"""Words between a room and its storey that say how the room is, at most."""


def _aside(gap: tuple[str, ...]) -> int:
    """Return how many words a remark between commas has that opens a gap, or 0."""
    if gap[:1] != (",",) or gap[1:2] == () or gap[1] not in _ASIDES or "," not in gap[2:]:
        return 0
    end = gap.index(",", 2) + 1
    return end if end <= _LONGEST_ASIDE and gap[end:] else 0


def _several(place: Place) -> bool:
    return len(place.refs) > 1 or place.refs[0].kind == "range"


_DRIVEN_INTO = frozenset({"garage", "parking", "loading_dock", "apparatus_bay", "car_workshop"})


@dataclass(frozen=True)
class Attachment:
    """The storeys of a phrase; `each`: its number holds for each of them."""

    refs: tuple[FloorRef, ...] = ()
    each: bool = False


def attach_storeys(
    reading: Reading, places: list[Place], phrases: list[Phrase], building: int | None
) -> dict[int, Attachment]:
    """Return the storeys of phrases, by their number in `phrases`.

    Parameters
    ----------
    building : int, optional
        Number of the phrase that names the building itself.
    """
    return _Walk(reading, places, phrases, building).run()


_ATTICS = frozenset({"attic", "loft"})
_LONGEST_UNKNOWN = 3
"""Words of a room that nobody knows, at most."""


class _Walk:
    """Goes from sentence to sentence with the scope that headings and openings leave."""

    def __init__(self, reading: Reading, places: list[Place], phrases: list[Phrase], building: int | None) -> None:
        self.reading, self.places, self.phrases, self.building = reading, places, phrases, building
        self.found: dict[int, Attachment] = {}
        self.heading: Place | None = None
        self.trailing: Place | None = None

    def run(self) -> dict[int, Attachment]:
        """Walk over all sentences."""
        carried: Place | None = None
        last_end = -1
        for sentence in range((self.reading.sentence or [0])[-1] + 1):
            items = [("place", n, p.first) for n, p in enumerate(self.places) if self._in(p.first, sentence)]
            items += [
                ("phrase", n, p.first)
                for n, p in enumerate(self.phrases)
                if self._in(p.first, sentence) and n != self.building
            ]
            items.sort(key=lambda item: item[2])
            end = max((i for i, s in enumerate(self.reading.sentence) if s == sentence), default=0)
            self.trailing = None
            carried = self._sentence(items, carried, sentence)
            behind = self._place_behind()
            if carried is None and behind is not None and self._contrasts(sentence):
                carried = behind
            if self.reading.word(end) != ";":
                carried = None
            blank = self.reading.word(end) == "\n" and self.reading.word(last_end) == "\n" and end == last_end + 1
            if blank and self.heading is not None and not self._heading_follows(sentence):
                self.heading = self.heading if self._list_follows(sentence) else None
            last_end = end
        return self.found

    def _in(self, index: int, sentence: int) -> bool:
        return index < len(self.reading.sentence) and self.reading.sentence[index] == sentence

    def _place_behind(self) -> Place | None:
        """Return the storey that stands behind what the sentence before tells."""
        return self.trailing

    def _contrasts(self, sentence: int) -> bool:
        """Whether clauses without a storey follow, and then a sentence that opens with another one.

        "Three studios downstairs; changing rooms; a waiting corner. Upstairs a theatre."
        """
        reading = self.reading
        last = sentence + 1
        while last < reading.sentence[-1] and reading.word(self._end_of(last)) == ";":
            last += 1
        inside = [p for p in self.places if sentence < reading.sentence[p.first] <= last]
        after = [p for p in self.places if reading.sentence[p.first] == last + 1]
        return not inside and bool(after) and (after[0].heading or reading.starts(after[0].first))

    def _end_of(self, sentence: int) -> int:
        return max((at for at, number in enumerate(self.reading.sentence) if number == sentence), default=0)

    def _heading_follows(self, sentence: int) -> bool:
        return any(place.heading and self.reading.sentence[place.first] > sentence for place in self.places)

    def _list_follows(self, sentence: int) -> bool:
        first = next((i for i, s in enumerate(self.reading.sentence) if s == sentence + 1), -1)
        return self.reading.word(first) in ("-", "*") or self.reading.kind(first) == "number"

    def _sentence(self, items: list[tuple[str, int, int]], carried: Place | None, sentence: int) -> Place | None:
        scope = carried or self.heading
        opened = carried is not None
        left: list[int] = []
        for position, (kind, number, _) in enumerate(items):
            if kind == "phrase":
                if carried is not None and scope is carried and self._is_driven_into(number, carried):
                    scope, opened = self.heading, False  # "upstairs two bedrooms; garage at the side"
                if scope is not None:
                    self._give(number, scope, trailing=False)
                left.append(number)
                continue
            place = self._within(self.places[number], scope)
            rest = [n for k, n, _ in items[position + 1 :] if k == "phrase"]
            roof = self.reading.word(place.last - 1) == "roof" and place.last - place.first < 5
            attic = scope is not None and not _ATTICS.isdisjoint(self.reading.words(scope.last, scope.last + 4))
            if scope is not None and roof and not attic and not self.reading.starts(place.first):
                continue  # "second floor: a bedroom under the roof"
            holds = place.refs[0].kind == "basement" and self.reading.word(place.last) in HOLDING and rest
            if holds and not self._opens_sentence(place, left):
                self._fill_basement(place, left, rest)
                left += rest[:1]
            elif self._ends_line(place):
                self.heading = scope = place
                opened, left = True, []
            elif self._is_served(place, left):
                continue
            elif self._is_prenominal(place, rest):
                self._give(rest[0], place, trailing=False)
                items[position + 1 :] = [item for item in items[position + 1 :] if item[:2] != ("phrase", rest[0])]
            elif not left and self._follows_unknown(place):
                continue
            elif left and self._puts_it(place):
                self._give_all(left[-1:], place)
            elif left and self._follows(place, left):
                self._give_all(left[:1], place)
            elif self.reading.word(place.first - 1) == "both" and len(left) > 1:
                self._give_all(left[-2:], place)  # "the sauna next to the gym, and both in the basement"
                left = []
            elif self._trails(place, left):
                self._give_all(self._claimed(place, left, opened=opened), place)
                self._give_all(self._in_brackets_after(place, rest), place)
                held = self._held_with(place, rest)
                self._give_all(held, place)
                items[position + 1 :] = [i for i in items[position + 1 :] if i[0] != "phrase" or i[1] not in held]
                left = []
                self.trailing = place if not opened and place.refs[0].kind in ("number", "upper", "top") else None
                if self._goes_on(place):
                    scope = place
                elif not opened:
                    scope = self.heading
            else:
                if scope is None and self._goes_up(place):
                    self._stay_below(place, left)
                scope, opened, left = place, True, []
        return scope if opened else None

    def _goes_up(self, place: Place) -> bool:
        """Whether a list goes on upstairs: "a living room, a study, and upstairs three bedrooms"."""
        one = place.last - place.first == 1 and _UP_AND_DOWN.get(self.reading.word(place.first)) == "up"
        return one and self.reading.word(place.first - 1) == "and"

    def _stay_below(self, place: Place, numbers: list[int]) -> None:
        """Put what a list names before it goes on upstairs on the ground floor, bedrooms of a number left aside."""
        below = replace(place, refs=(FloorRef("number", 1, 1, place.refs[0].span),))
        for number in numbers:
            phrase = self.phrases[number]
            if phrase.head == "room" and phrase.room_type and not (phrase.plural and phrase.counted):
                self._give(number, below, trailing=False)

    def _opens_sentence(self, place: Place, left: list[int]) -> bool:
        """Whether a sentence is about a storey: "Basement with laundry, a storage room and a gym."."""
        return not left and any(self.reading.starts(at) for at in range(max(place.first - 2, 0), place.first + 1))

    def _fill_basement(self, place: Place, left: list[int], rest: list[int]) -> None:
        """Put into a basement what it holds: "over a basement with parking", "a spa in a basement with two saunas"."""
        if left and self._stands_in(place, left[-1]):
            self._give(left[-1], place, trailing=True)
        self._give_all(self._listed_below(rest) or self._joined(rest), place)

    def _listed_below(self, rest: list[int]) -> list[int]:
        """Return a whole list of rooms that may all lie below ground: "with a pool, a sauna and a cinema"."""
        chosen, closed = rest[:1], False
        for number in rest[1:]:
            gap = self.reading.words(self.phrases[chosen[-1]].last, self.phrases[number].begin)
            if not gap or gap[0] not in (",", "and") or len(gap) > 3 or not set(gap) <= {",", "and", "a", "an", "the"}:
                break
            chosen.append(number)
            closed = closed or "and" in gap
            if "and" in gap:
                break
        types = [self.phrases[number].room_type for number in chosen[1:]]
        below = all(kind and self.reading.knowledge.room(kind).storey in ("any", "basement") for kind in types)
        return chosen if closed and below and types else []

    def _give_all(self, numbers: list[int], place: Place) -> None:
        """Give phrases the storey that stands behind them."""
        for number in numbers:
            self._give(number, place, trailing=True)

    def _stands_in(self, place: Place, number: int) -> bool:
        """Whether a room stands right before the basement that it is in: "a spa in the basement with two saunas"."""
        return place.first == self.phrases[number].last and self.reading.word(place.first) in ("in", "on", "at")

    def _in_brackets_after(self, place: Place, rest: list[int]) -> list[int]:
        """Return what brackets behind a storey tell of it: "the surgery suite upstairs (two theatres)"."""
        reading = self.reading
        if reading.word(place.last) != "(":
            return []
        end = place.last
        while not reading.breaks(end) and reading.word(end) != ")":
            end += 1
        return [number for number in rest if self.phrases[number].last <= end]

    def _follows_unknown(self, place: Place) -> bool:
        """Whether a storey stands behind words that nobody knows: "smoke maze on the first floor, a workshop ..."."""
        reading = self.reading
        first = place.first
        while first > 0 and not reading.breaks(first - 1) and place.first - first <= _LONGEST_UNKNOWN:
            first -= 1
        words = range(first, place.first)
        unknown = all(reading.kind(at) == "word" and reading.word(at) not in FUNCTION_WORDS for at in words)
        return place.led and 0 < len(words) <= _LONGEST_UNKNOWN and unknown and reading.word(place.last) == ","

    def _held_with(self, place: Place, rest: list[int]) -> list[int]:
        """Return what "with" tells of a room behind its storey: "an office on the ground floor with two rooms"."""
        led = place.led and self.reading.word(place.last) == "with" and rest
        return self._joined(rest) if led and self.phrases[rest[0]].first <= place.last + 2 else []

    def _puts_it(self, place: Place) -> bool:
        """Whether a room named before is put somewhere: "the laundry makes noise, so put it on the ground floor"."""
        verb, pronoun = self.reading.words(place.first - 2, place.first) if place.first > 1 else ("", "")
        return pronoun in ("it", "this", "that") and verb in ("put", "place", "keep", "locate", "leave", "want", "have")

    def _follows(self, place: Place, left: list[int]) -> bool:
        """Whether a storey follows from what is said of a subject: "the bar far from the hall, so upstairs"."""
        gap = self.reading.words(self.phrases[left[-1]].last, place.first)
        return gap in ((",", "so"), (",", "therefore"), (",", "hence"), (",", "thus")) and self._closes(place)

    def _is_served(self, place: Place, left: list[int]) -> bool:
        """Whether a place only says where a lift or stair goes: "a lift to all floors"."""
        before = self.phrases[left[-1]] if left else None
        if before is None or before.head not in ("elevator", "stair"):
            return False
        if before.last == place.first and self.reading.word(place.first) in ("to", "serving"):
            return True
        return self.reading.words(before.last, place.first) in (("to",), ("serving",), ("reaching",), ("up", "to"))

    def _within(self, place: Place, scope: Place | None) -> Place:
        """Read "each floor" as each of the storeys that the clause is about: "floors 3 to 9: nine on each floor"."""
        if scope is None or place.refs[0].kind != "every" or not _several(scope):
            return place
        return replace(place, refs=scope.refs)

    def _joined(self, rest: list[int]) -> list[int]:
        """Return the first of some phrases and those joined to it by "and" alone."""
        chosen = rest[:1]
        for number in rest[1:]:
            if self.reading.words(self.phrases[chosen[-1]].last, self.phrases[number].begin) not in (
                ("and",),
                ("and", "a"),
                ("and", "an"),
            ):
                break
            chosen.append(number)
        return chosen

    def _ends_line(self, place: Place) -> bool:
        reading = self.reading
        last = place.last + (reading.word(place.last) in (":", "="))
        return reading.starts(place.first) and (reading.word(last) == "\n" or self._bracket_ends_line(last))

    def _bracket_ends_line(self, last: int) -> bool:
        reading = self.reading
        if reading.word(last) not in ("(", ","):
            return False
        index = last
        while index < len(reading.tokens) and reading.word(index) not in ("\n", ".", ";") and index - last < 12:
            index += 1
        inside = any(last <= phrase.first < index for phrase in self.phrases)
        return reading.word(index) == "\n" and not inside

    def _is_prenominal(self, place: Place, rest: list[int]) -> bool:
        """Whether the reference stands inside a noun phrase: "a ground-floor cafeteria"."""
        if place.led or place.heading or not rest:
            return False
        phrase = self.phrases[rest[0]]
        if phrase.begin != place.last or phrase.first < place.last or phrase.counted:
            return False
        reading = self.reading
        lead = reading.word(place.first)
        if lead in ("a", "an"):
            return True
        before = reading.word(place.first - 1)
        return (
            before in ("a", "an")
            or reading.kind(place.first - 1) == "number"
            or (
                lead == "the"
                and place.refs[0].kind == "number"
                and not reading.starts(place.first)
                and before in ("and", "with", "in")
            )
        )

    def _trails(self, place: Place, left: list[int]) -> bool:
        if not left or place.heading:
            return False
        phrase = self.phrases[left[-1]]
        gap = self.reading.words(phrase.last, place.first)
        if self._is_of_measure(place, gap):
            return False
        if "where" in self.reading.words(place.last, place.last + 2) and _PLACED.isdisjoint(gap):
            return False
        if (
            self.reading.word(place.last) in ("has", "have", "hold", "house", "contain", ":", "get", "carry", "host")
            and self.reading.word(place.first - 1) in _OPENERS
        ):
            return False
        if phrase.head == "people" and self.reading.word(place.last) in ("with", ":", "has", "have", "get"):
            return False  # "the family upstairs with three bedrooms"
        if gap[:1] == ("(",) and ")" in gap:
            gap = gap[gap.index(")") + 1 :]  # "two toilets (m/f) on each level"
        gap = gap[_aside(gap) :]
        gap = gap[self._capacity(phrase.last, len(gap)) :]
        gap = gap[self._quality(place, gap) :]
        after = phrase.last + len(self.reading.words(phrase.last, place.first)) - len(gap)
        sized = {k for k in range(len(gap)) if self.reading.kind(after + k) in ("number", "unit")}
        joints = {k for k in range(len(gap)) if gap[k] in ("and", ",") and {k - 1, k + 1} & sized}
        if len(gap) - len(sized | joints) > 6:
            return False
        measures = all(
            word in _GLUE
            or (word in ("has", "have", "need") and gap[k + 1 : k + 2] == ("to",))
            or k in joints
            or (word in _BESIDE and (after + k in self.reading.taken or word == "it"))
            or self.reading.kind(after + k) in ("number", "unit")
            or word in ("(", ")", "of", "about", "x", "people")
            or (word == "them" and gap[k - 2 : k] in (("all", "of"), ("both", "of")))
            for k, word in enumerate(gap)
        )
        if not measures:
            return False
        return not (gap and gap[-1] == "," and not self._closes(place))

    def _is_of_measure(self, place: Place, gap: tuple[str, ...]) -> bool:
        """Whether storeys belong to the area before them: "four bedrooms, 91 m2 on each of two storeys"."""
        if not gap or gap[0] != "," or place.first < 1:
            return False
        end = self.reading.tokens[place.first - 1].end
        return any(quantity.span.end == end for quantity in self.reading.facts.floor_area)

    def _capacity(self, index: int, most: int) -> int:
        """Return how many tokens "for 200 guests" and "seating 50" have that stand at a token, or 0."""
        reading = self.reading
        if reading.word(index) not in ("for", "seating") or reading.kind(index + 1) != "number":
            return 0
        size = 2 + (reading.word(index + 2) in PEOPLE)
        return size if size <= most else 0

    def _quality(self, place: Place, gap: tuple[str, ...]) -> int:
        """Return how many tokens a gap has where it only says how a room is: "a store without windows"."""
        led = gap[:1] in (("with",), ("without",)) and place.led and len(gap) <= _LONGEST_QUALITY
        first = place.first - len(gap)
        words = all(
            self.reading.kind(at) == "word" and at not in self.reading.taken for at in range(first, place.first)
        )
        return len(gap) if led and words else 0

    def _goes_on(self, place: Place) -> bool:
        """Whether what follows a place shares it: "on the first floor together with the foyer", "upstairs, where"."""
        following = self.reading.words(place.last, place.last + 2)
        together = following in (("together", "with"), ("along", "with")) or "where" in following
        return together or (following[0] == "with" and not place.led)

    def _closes(self, place: Place) -> bool:
        """Whether a reference after a comma ends its clause, so that it can only belong to what stands before it."""
        following = self.reading.word(place.last)
        return self.reading.breaks(place.last) or following in (")", ",", "and")

    def _claimed(self, place: Place, left: list[int], *, opened: bool) -> list[int]:
        sentence = self.reading.sentence[place.first]
        listed = self._list_before(place, left)
        if listed:
            return listed
        titled = self.building is not None and self.reading.sentence[self.phrases[self.building].first] == sentence
        if not opened and not titled:
            below = place.refs[0].kind in ("basement", "every") or self.reading.word(place.last) == ","
            return left[-1:] if self._asyndetic(left) and (below or not place.led) else left
        if self._is_contrasted(place):
            return left
        if len(left) > 1 and (self._is_bracketed(left[-1]) or self._are_its_people(left)):
            return [left[-1], *self._claimed(place, left[:-1], opened=opened)]
        chosen = [left[-1]]
        joined = False
        for number in reversed(left[:-1]):
            between = self.reading.words(self.phrases[number].last, self.phrases[chosen[-1]].first)
            joined = joined or not _AND.isdisjoint(between)
            sized = range(self.phrases[number].last, self.phrases[chosen[-1]].first)
            between = tuple(
                word
                for at, word in zip(sized, between, strict=True)
                if self.reading.kind(at) not in ("number", "unit", "ordinal") and word != "of"
            )
            furnished = self.phrases[chosen[-1]].head == "object" and between[:1] == ("with",)
            if furnished and between[1:] in ((), ("a",), ("an",), ("its",)) and joined:
                chosen.append(number)  # "a boot room with lockers and a drying room on the ground floor"
                continue
            if not all(word in _JOINTS for word in between) or not joined or (opened and "," in between):
                if between[:1] == ("with",) and len(chosen) > 1 and self._is_set_off(*chosen[:-3:-1]):
                    chosen.pop()  # "a cafeteria with a kitchen, and toilets on each floor"
                break
            if not place.led and "," in between:
                return chosen[:1]  # "a reception, a waiting room and a staff room upstairs"
            if not self._suits(number, place):
                break
            chosen.append(number)
        return chosen

    def _is_contrasted(self, place: Place) -> bool:
        """Whether a list ends upstairs and another one of its sentence downstairs, so that each has all of its list.

        "A house with a kitchen, a study and a WC downstairs, three bedrooms and a bathroom upstairs."
        """
        ends = [
            other
            for other in self.places
            if self.reading.sentence[other.first] == self.reading.sentence[place.first]
            and other.last - other.first == 1
            and self.reading.word(other.first) in _UP_AND_DOWN
        ]
        told = {_UP_AND_DOWN[self.reading.word(other.first)] for other in ends}
        if place not in ends or not len(ends) == len(told) == 2:
            return False
        bracketed = "(" in self.reading.words(ends[0].last, ends[1].first)
        return self._closes(ends[1]) and not bracketed

    def _is_set_off(self, first: int, second: int) -> bool:
        """Whether a comma stands between two phrases."""
        return "," in self.reading.words(self.phrases[first].last, self.phrases[second].first)

    def _are_its_people(self, left: list[int]) -> bool:
        """Whether the last phrase is of those whom the one before is for: "quarters for eight firefighters"."""
        room, people = self.phrases[left[-2]], self.phrases[left[-1]]
        return people.head == "people" and self.reading.words(room.last, people.first) == ("for",)

    def _is_bracketed(self, number: int) -> bool:
        """Whether a phrase stands in a bracket behind another one: "the living room (with a fireplace)"."""
        phrase, reading = self.phrases[number], self.reading
        before = self.phrases[number - 1].last if number else 0
        return "(" in reading.words(before, phrase.first) and reading.word(phrase.last) == ")"

    def _list_before(self, place: Place, left: list[int]) -> list[int]:
        """Return the rooms of a clause that its storey ends, where the next clause tells another storey.

        "Monastery: church, refectory, kitchen on the ground floor; a dormitory above."
        """
        reading = self.reading
        sentence = reading.sentence[place.first]
        following = any(reading.sentence[other.first] == sentence + 1 for other in self.places)
        paired = any(self._ends_clause(other) for other in self.places if reading.sentence[other.first] == sentence - 1)
        alone = not any(other is not place and reading.sentence[other.first] == sentence for other in self.places)
        listed = reading.word(place.last) == ";" and following and place.led
        paired = paired and reading.breaks(place.last)  # "three bedrooms up; kitchen, living, WC down"
        if not (listed or paired) or not alone or _several(place):
            return []
        colons = [at for at in range(place.first) if reading.word(at) == ":" and reading.sentence[at] == sentence]
        return [number for number in left if not colons or self.phrases[number].first > colons[-1]]

    def _ends_clause(self, place: Place) -> bool:
        """Whether a storey stands at the end of a clause, behind what it holds."""
        return not place.heading and self.reading.word(place.last) == ";" and not self.reading.starts(place.first)

    def _asyndetic(self, left: list[int]) -> bool:
        """Whether commas alone part a list, so that what follows is of its last entry: "shop, cafe upstairs"."""
        joints = [
            self.reading.words(self.phrases[a].last, self.phrases[b].first)
            for a, b in itertools.pairwise(left)
            if self.phrases[b].head != "object"  # "a hall with counters and machines, an office"
        ]
        plain = [words[: words.index("for")] if "for" in words else words for words in joints]
        if len(plain) > 2 and _AND.isdisjoint(plain[-1]):
            return True  # "a pool and a bath, changing rooms, showers, a sauna upstairs"
        return len(joints) > 1 and all(_AND.isdisjoint(words) for words in plain)

    def _suits(self, number: int, place: Place) -> bool:
        phrase = self.phrases[number]
        if not phrase.room_type:
            return True
        storey = self.reading.knowledge.room(phrase.room_type).storey
        return not (storey == "ground" and place.refs[0].kind in ("top", "roof", "basement"))

    def _is_driven_into(self, number: int, place: Place) -> bool:
        """Whether cars go into a room, so that an upper storey named before a semicolon is not its own."""
        return self.phrases[number].room_type in _DRIVEN_INTO and place.refs[0].kind in ("upper", "top", "roof")

    def _give(self, number: int, place: Place, *, trailing: bool) -> None:
        if number in self.found and not trailing:
            return
        several = len(place.refs) > 1 or place.refs[0].kind in (
            "every",
            "range",
            "middle",
            "lower",
            "odd",
            "even",
            "not_top",
        )
        distributed = not {"each", "every"}.isdisjoint(self.reading.words(place.first, place.last))
        distributed = distributed or self.reading.word(self.phrases[number].noun_end) == "each"
        several = several or (place.refs[0].kind == "top" and place.refs[0].first > 1 and distributed)
        several = several or (place.refs[0].kind == "upper" and self._plural_upper(place))
        several = several and not (place.refs[0].kind == "middle" and not self._plural_upper(place))
        several = several and not (not trailing and self._are_one(place, number))
        phrase = self.phrases[number]
        near = self.reading.words(max(phrase.first - 4, 0), place.first if trailing else phrase.first)
        rest = tuple(itertools.takewhile(lambda word: word != ".", self.reading.words(phrase.last, phrase.last + 3)))
        shared = (
            ("shared", "between") in itertools.pairwise(rest)
            or not _SHARED_OUT.isdisjoint(near)
            or not _SHARED_OUT.isdisjoint(rest)
            or phrase.determiner == "all"
            or (trailing and self._is_total(phrase, place))
        )
        self.found[number] = Attachment(place.refs, several and not shared)

    def _are_one(self, place: Place, number: int) -> bool:
        """Whether storeys are one room together: "the two floors above are one apartment"."""
        phrase, reading = self.phrases[number], self.reading
        if not {"each", "every"}.isdisjoint(reading.words(place.first, place.last)):
            return False  # "on each floor is one bathroom"
        verb = reading.words(place.last, phrase.first) in (("are",), ("is",), ("form",), ("become",))
        return verb and reading.kind(phrase.first) == "number" and reading.value(phrase.first) == 1

    def _is_total(self, phrase: Phrase, place: Place) -> bool:
        """Whether a large number of rooms is that of all the storeys named after it: "40 offices on floors 2 to 5"."""
        if place.refs[0].kind not in ("number", "range") or not phrase.counted:
            return False
        storeys = sum(ref.last - ref.first + 1 for ref in place.refs)
        count = phrase.count or 0
        return storeys > 1 and count >= _MANY * storeys and count % storeys == 0

    def _plural_upper(self, place: Place) -> bool:
        if not {"each", "every"}.isdisjoint(self.reading.words(place.first, place.last)):
            return True  # "on each sleeping level"
        return any(
            self.reading.plural(i) and self.reading.word(i) in ("floor", "storey", "level", "story", "deck")
            for i in range(place.first, place.last)
        )
