"""Read what a brief wishes of the building's shape: outline, setbacks, size, and equal storeys."""

from dataclasses import replace
from typing import TypeAlias

from mansion_planner.brief.corrections import taken_back_by
from mansion_planner.brief.facts import BriefFacts, CopyFact, FloorRef, Shape
from mansion_planner.brief.furniture_words import furniture_of
from mansion_planner.brief.reading import FLOOR_WORDS, Place, Reading
from mansion_planner.brief.sizes import is_size, size_of

__all__ = ["give_rooms_to_copies", "read_copies", "read_massing", "read_shape", "read_sizes"]

_SHAPES: dict[str, Shape] = {"l": "L", "u": "U", "t": "T", "h": "H"}
_BENT = frozenset("bent folded wrapped laid arranged built shaped planned bends folds wraps".split())
_NEGATIONS = frozenset({"no", "without", "not", "never"})
_EQUAL = frozenset(
    """
    identical identically same repeat repeated alike equal clone copy duplicate mirror
    """.split()
)


def read_shape(reading: Reading) -> None:
    """Read the outline's shape: "L-shaped", "in the form of a U", "around a courtyard", "rectangular"."""
    after, shapes = 0, reading.facts.shapes
    for index in range(len(reading.tokens)):
        found = _shape_at(reading, index)
        if found is not None:
            shape, first, last, end = found
            sign = taken_back_by(reading.tokens, after, first) if shapes else None
            if sign is not None:
                shapes.pop()  # "H-shaped - no, L-shaped"
                reading.take(sign, first)
            shapes.append((shape, reading.span(first, last)))
            reading.take(min(first, index), end)
            after = end


_Found: TypeAlias = tuple[Shape, int, int, int]
"""An outline, where its words begin and end, and where the tokens end that belong to them."""


def _shape_at(reading: Reading, i: int) -> _Found | None:
    """Return the outline whose name stands at a token."""
    word = reading.word(i)
    if word in _SHAPES:
        return _letter_at(reading, i)
    if _is_court(reading, i):
        return "courtyard", i, i + 1, i + 1
    if word in ("rectangular", "rectangle", "oblong"):
        named = reading.word(i + 1) in ("outline", "footprint", "plan", "shape", "building")
        if not named and _names_part(reading, i + 1):
            return None
        return "rectangle", i, i + 1, i + 1 + named
    return _square_at(reading, i) if word == "square" else None


def _letter_at(reading: Reading, i: int) -> _Found | None:
    """Return the outline that a letter names: "L-shaped", "in the form of a U", "bent like an L"."""
    shape = _SHAPES[reading.word(i)]
    shaped = reading.word(i + 1) == "shaped"
    if shaped and _names_part(reading, i + 2):
        return None  # "an L-shaped living room"
    lead = " ".join(reading.word(i - k) for k in (3, 2, 1))
    formed = reading.word(i + 1) in ("shaped", "shape", "form", "plan", "formed", "outline", "footprint", "layout")
    formed = formed or lead in ("shape of a", "form of a", "shape of an", "form of an")
    formed = formed or (lead.split(" ")[1:] in (["shape", "of"], ["form", "of"]) and _is_letter(reading, i))
    bent = reading.word(i - 1) in ("a", "an") and not _BENT.isdisjoint(reading.words(max(i - 4, 0), i - 1))
    if formed or bent:
        return shape, i, i + 1 + shaped, i + 2
    first = _after_form(reading, i, _FORMS) if _is_letter(reading, i) else i
    return (shape, first, i + 1, i + 1) if first < i else None


def _square_at(reading: Reading, i: int) -> _Found | None:
    """Return a square outline: "a square tower", "a perfect square", "an office of 900 m2 a storey, square"."""
    following = reading.word(i + 1)
    named = ("outline", "footprint", "plan", "shape", "shaped", "building", "tower", "house", "form")
    if following in named and not (following == "shaped" and _names_part(reading, i + 2)):
        return "square", i, i + 2, i + 2
    if reading.words(i - 2, i) in (("a", "perfect"), ("an", "exact"), ("is", "a")):
        reading.take(i - 1, i)
        return "square", i, i + 1, i + 1
    closed = reading.word(i - 1) == "," and (reading.breaks(i + 1) or following in (",", ""))
    if closed or (reading.word(i - 1) in ("a", "our") and _names_building(reading, i + 1)):
        return "square", i, i + 1, i + 1
    first = _after_form(reading, i, _FORMS | {"plan", "footprint"})
    return ("square", first, i + 1, i + 1) if first < i else None


def _after_form(reading: Reading, index: int, ends: frozenset[str]) -> int:
    """Return where words begin that lead to an outline's name: "in shape of letter L", "the shape is"; or `index`.

    What is said of a room's form leads to none.
    """
    at = index - 1
    while index - at < 8 and reading.word(at) in _FORM_LINKS - ends:
        ends = ends | _BUILT if reading.word(at) == "letter" else ends
        at -= 1
    if reading.word(at) not in ends or reading.sentence[at] != reading.sentence[index]:
        return index
    at -= 2 * (reading.words(at - 2, at) in (("shape", "of"), ("form", "of")))
    near = [mention for mention in reading.mentions if at - 4 <= mention.first < index]
    near = [mention for mention in near if reading.sentence[mention.first] == reading.sentence[at]]
    return index if any(mention.room and not mention.building for mention in near) else at


_FORMS = frozenset({"shape", "form", "outline"})
_BUILT = frozenset({"shaped", "plan", "building", "footprint"})
"""Words that a letter after them tells the outline of, where it is called one."""
_FORM_LINKS = frozenset(
    """
    of a an the letter latin capital like it is as in : = " should must be have has building its house plan
    """.split()
)


def _is_letter(reading: Reading, index: int) -> bool:
    token = reading.tokens[index]
    return reading.text[token.start : token.end].isupper()


def _names_part(reading: Reading, index: int) -> bool:
    """Whether a room or a thing is named within three words from a token: what stands before it is said of that."""
    for at in range(index, index + 3):
        mention = reading.mention_at.get(at)
        if mention is not None:
            return bool(mention.room) and not mention.building
        if furniture_of(reading.words(index, at + 1))[0]:
            return True  # "an L-shaped sofa"
        if reading.kind(at) != "word":
            return False
    return False


def _names_building(reading: Reading, index: int) -> bool:
    mention = reading.mention_at.get(index)
    return mention is not None and bool(mention.building)


_COURTS = frozenset({"garth", "quad", "quadrangle", "atrium", "court", "patio"})


_SEEN_FROM_ROOMS = frozenset({"facing", "face", "overlooking", "overlook", "towards", "toward", "view"})
"""Words before a yard that somebody only looks into from a room: there may be one, beside or behind."""


def _is_court(reading: Reading, index: int) -> bool:
    """Whether a word is of a yard that wings stand around: "about an open cloister garth", "a closed quadrangle"."""
    before = reading.words(max(index - 5, 0), index)
    if reading.word(index) == "courtyard":
        seen = not _SEEN_FROM_ROOMS.isdisjoint(reading.words(max(index - 3, 0), index))
        return not seen and reading.word(index - 1) not in _NEGATIONS and reading.word(index + 1) not in FLOOR_WORDS
    if reading.word(index) not in _COURTS or index in reading.taken or reading.facts.shapes:
        return False
    if reading.word(index) in ("quadrangle", "quad", "garth"):
        return _NEGATIONS.isdisjoint(before)
    open_yard = "open" in before[-3:] and reading.word(index) != "patio"
    return open_yard and not {"around", "about", "round"}.isdisjoint(before)


_LEADS_TO_THING = frozenset({"a", "an", "one", "the", "large", "big", "wall", "with", "and", ","})


def read_copies(reading: Reading, places: list[Place]) -> None:
    """Read storeys that are to be identical: "floors 3 to 8 identical", "L3, L4, L5 the same", "share one plan"."""
    for index, token in enumerate(reading.tokens):
        if index in reading.differing:
            continue
        if _read_unchanging(reading, places, index) or _read_again(reading, places, index):
            continue
        sharing = _shares_plan(reading, index)
        comparing = _compares(reading, places, index)
        if not (comparing or sharing or token.text in _EQUAL or _is_typical(reading, places, index)):
            continue
        if reading.word(index + 1) in ("time", "building", "room", "walls"):
            continue
        if token.text in ("same", "equal") and reading.kind(index + 1) == "number":
            continue  # "the same 400 m2 on each"
        if token.text == "mirror" and (token.plural or reading.word(index - 1) in _LEADS_TO_THING):
            continue  # "a piano and a mirror"
        if token.text == "same" and reading.words(index + 1, index + 3) in (
            ("level", ","),
            ("floor", "as"),
            ("level", "."),
        ):
            continue
        pair = _same_as(places, index, reading)
        if pair is not None:
            first, last = sorted((pair[0].refs[0].first, pair[1].refs[0].first))
            span = reading.span(pair[0].first, pair[1].last)
            reading.facts.copies.append(CopyFact(FloorRef("range", first, last, span), span))
            reading.take(index, index + 1)
            continue
        if comparing and not _is_within(places, index):
            continue
        near = [p for p in places if reading.sentence[p.first] == reading.sentence[index] and _several(p)]
        counted = [p for p in near if p.refs[0].kind in ("number", "range") and p.last <= index]
        near = counted or near  # "from the 2nd to the 9th floor all are the same, each floor has ..."
        if not near and reading.word(index) not in ("same", "equal", "copy", "mirror"):
            near = [p for p in places if reading.sentence[p.first] == reading.sentence[index] - 1 and _several(p)][-1:]
        if near:
            place = min(near, key=lambda p: min(abs(p.last - index), abs(p.first - index)))
            words = reading.span(min(place.first, index), max(place.last, index + 1))
            group = _joined(place)
            if not any(_are_alike(copy.first, group) for copy in reading.facts.copies):
                reading.facts.copies.append(CopyFact(group, words))
        elif FLOOR_WORDS & set(reading.words(index + 1, index + 3)) and token.text in ("identical", "equal"):
            span = reading.span(index, index + 2)
            stated = reading.facts.floors[0].value if reading.facts.floors else 0.0
            whole = reading.kind(index - 1) == "number" and reading.value(index - 1) >= stated
            reading.facts.copies.append(CopyFact(FloorRef("every" if whole else "upper", span=span), span))
        plan = next((at for at in range(index + 1, index + 5) if reading.word(at) in ("plan", "layout")), index)
        reading.take(index, plan + 1 if sharing else index + 1)


def give_rooms_to_copies(facts: BriefFacts) -> None:
    """Give each of several storeys that are to be alike the rooms that are told of them together."""
    for number, room in enumerate(facts.rooms):
        if len(room.floors) == 1 and any(_are_alike(room.floors[0], copy.first) for copy in facts.copies):
            facts.rooms[number] = replace(room, each=True)


def _are_alike(one: FloorRef, other: FloorRef) -> bool:
    """Whether two references mean the same storeys, whatever words they were read from."""
    return (one.kind, one.first, one.last) == (other.kind, other.first, other.last)


def _shares_plan(reading: Reading, index: int) -> bool:
    """Whether storeys "share one plan"."""
    shared = reading.word(index) in ("share", "sharing") and reading.word(index + 1) in ("one", "a", "the")
    return shared and not {"plan", "layout"}.isdisjoint(reading.words(index + 1, index + 5))


def _is_within(places: list[Place], index: int) -> bool:
    """Whether a token stands within the words that name storeys: "L01 = L02", "St. 2-6 typical"."""
    return any(place.first < index < place.last for place in places)


def _is_typical(reading: Reading, places: list[Place], index: int) -> bool:
    """Whether storeys are called typical."""
    named = _is_within(places, index) or reading.word(index + 1) in FLOOR_WORDS
    named = named or any(p.last == index - 1 and _several(p) for p in places if reading.word(p.last) in ("is", "are"))
    return reading.word(index) == "typical" and named


def _compares(reading: Reading, places: list[Place], index: int) -> bool:
    """Whether a storey is told to be as another one: "just like 4F", "L3 = L2"."""
    if reading.word(index) == "=":
        return _is_within(places, index) or any(place.first == index + 1 for place in places)
    return reading.word(index) in ("like", "as") and reading.word(index - 1) in ("just", "exactly", "look", "repeat")


def _read_unchanging(reading: Reading, places: list[Place], index: int) -> bool:
    """Read "from the 2nd to the 6th the plan never changes" as equal storeys."""
    changes = reading.word(index) in ("change", "vary", "differ", "changing", "varies")
    never = changes and reading.word(index - 1) in ("never", "not", "without", "hardly")
    if not never and reading.word(index) not in ("unchanged", "unchanging"):
        return False
    near = [p for p in places if reading.sentence[p.first] == reading.sentence[index] and _several(p)]
    if not near:
        return False
    place = next((p for p in reversed(near) if p.last <= index), near[0])
    plan = index - next((k for k in (1, 2, 3, 4) if reading.word(index - k) in _PLANS), never)
    span = reading.span(min(place.first, plan), max(place.last, index + 1))
    if not any(_are_alike(copy.first, _joined(place)) for copy in reading.facts.copies):
        reading.facts.copies.append(CopyFact(_joined(place), span))
    reading.take(plan, index + 1)
    return True


_PLANS = frozenset({"plan", "layout", "arrangement", "scheme", "floorplan", "programme", "program"})
_AGAIN = frozenset({"same", "ditto", "idem", "repeat", "repeated", "likewise", "identical", "copy", "as"})
_BACK = frozenset({"as", "again", "ditto", "idem", "repeat", "likewise", "below", "before"})
_SAID_AGAIN = frozenset(
    """
    the a an exactly just is are of it that again as before below above one storey floor level story under beneath
    plan layout thing room set down there : , = - previous all everything completely entirely and in every respect
    """.split()
)


def _read_again(reading: Reading, places: list[Place], index: int) -> bool:
    """Read "3rd storey: the same again" and "Level 4: ditto" as the storey named before once more."""
    if reading.word(index) not in _AGAIN or index in reading.taken:
        return False
    here = [
        n for n, p in enumerate(places) if 0 <= index - p.last <= 4 and p.refs[0].kind in ("number", "range", "top")
    ]
    if not here or here[-1] == 0:
        return False
    place, before = places[here[-1]], places[here[-1] - 1]
    end = index
    while not reading.breaks(end) and end - index < 9:
        end += 1
    storeys = [(ref.kind, ref.first, ref.last) for ref in before.refs]
    again = [p for p in places if [(ref.kind, ref.first, ref.last) for ref in p.refs] == storeys]
    named = {at for p in again for at in range(p.first, p.last)}
    said = {reading.word(at) for at in range(place.last, end) if at not in named}
    several = len(place.refs) > 1 or place.refs[0].kind == "range"
    if several and said.isdisjoint(_BACK):
        return False  # "floors 2, 3 and 4 are the same" as one another
    if not said <= _SAID_AGAIN | _AGAIN or before.refs[-1].kind not in ("number", "range"):
        return False
    base, first = before.refs[-1].last, place.refs[0]
    floors = int(reading.facts.floors[0].value) if reading.facts.floors else 0
    final = floors if first.kind == "top" else place.refs[-1].last
    if (first.first if first.kind != "top" else final) != base + 1:
        return False
    span = reading.span(place.first, end)
    reading.facts.copies.append(CopyFact(FloorRef("range", base, final, span), span))
    reading.take(place.last, end)
    return True


def _several(place: Place) -> bool:
    return len(place.refs) > 1 or (
        place.refs[0].kind in ("range", "upper", "middle", "every", "not_top", "top")
        and (place.refs[0].kind != "top" or place.refs[0].first > 1)
    )


def _joined(place: Place) -> FloorRef:
    """Return consecutive storeys as one range."""
    if len(place.refs) == 1:
        return place.refs[0]
    return FloorRef(
        "range", min(ref.first for ref in place.refs), max(ref.last for ref in place.refs), place.refs[0].span
    )


def _same_as(places: list[Place], index: int, reading: Reading) -> tuple[Place, Place] | None:
    """Return the two neighbouring storeys of "floor 3: same as floor 2", "5F just like 4F"."""
    places = [p for p in places if reading.sentence[p.first] == reading.sentence[index]]
    before = [
        p for p in places
        if index - p.last >= 0 and (p.heading or index - p.last <= 3)
        and p.refs[0].kind == "number" and len(p.refs) == 1
    ]  # fmt: skip
    after = [p for p in places if 0 < p.first - index <= 3 and p.refs[0].kind == "number"]
    if before and after and abs(before[-1].refs[0].first - after[0].refs[0].first) == 1:
        return before[-1], after[0]
    return None


_IN_A_ROW = frozenset("house home dwelling property cottage villa maisonette row family".split())
"""What is terraced where it stands in a row; other buildings are where their storeys step back."""


def read_massing(reading: Reading) -> None:
    """Read setbacks and terraces, protruding ground floors and garages."""
    for i in range(len(reading.tokens)):
        word, following = reading.word(i), reading.word(i + 1)
        if word == "setback" or (word == "set" and following == "back") or word in ("stepped", "recessed", "terraced"):
            if word == "terraced" and following in _IN_A_ROW:
                continue
            reading.facts.setback.append(reading.span(i, i + 1 + (following == "back")))
        elif word in ("protruding", "projecting", "podium", "wider") or (word == "larger" and following == "ground"):
            reading.facts.protruding.append(reading.span(i, i + 1))


_NAMED = {"duplex": 2, "triplex": 3, "bungalow": 1}

_PARTS_WITH_TOWERS = frozenset(
    """
    bell clock church water stair corner watch control lift cooling fly drill hose climbing lookout round square
    """.split()
)
"""What stands before a tower that is a part of a building."""

_WITH_PARTS = frozenset({"with", "and", "plus", "including", ",", "has", "have", "having"})
"""Words after which a building's parts are named."""


def read_sizes(reading: Reading, first: int, last: int) -> None:
    """Read how large and tall the building is called, from the words around the noun that names it.

    Parameters
    ----------
    first, last : int
        Tokens of the noun phrase that names the building; both 0 where none does.
    """
    for index in range(len(reading.tokens)):
        word = reading.word(index)
        span = reading.span(index, index + 1)
        if word in _NAMED:
            reading.facts.size.append((word, span))
        elif word in ("high", "mid", "low") and reading.word(index + 1) in ("rise", "riser"):
            reading.facts.size.append((f"{word}_rise", reading.span(index, index + 2)))
            reading.take(index, index + 2)
        elif word in ("highrise", "midrise", "lowrise"):
            reading.facts.size.append((f"{word[:-4]}_rise", span))
        elif word in ("skyscraper", "tower") and _is_the_building(reading, index, first, last):
            reading.facts.size.append(("high_rise", span))
        elif is_size(word) and first - 3 <= index < max(last, 4) and _says_of_all(reading, index, first, last):
            reading.facts.size.append((size_of(word), span))


def _is_the_building(reading: Reading, index: int, first: int, last: int) -> bool:
    """Whether a tower is the building itself, and no part of it: "a church with a bell tower", "a tower room"."""
    if reading.word(index + 1) in ("room", "block") or reading.word(index - 1) in _PARTS_WITH_TOWERS:
        return False
    named_otherwise = bool(last) and not first - 2 <= index <= last
    return not (named_otherwise and _WITH_PARTS & set(reading.words(index - 3, index)))


def _says_of_all(reading: Reading, index: int, first: int, last: int) -> bool:
    """Whether a word for a size, near the noun of the building, is about that: not in "house with small rooms"."""
    if reading.sentence[index] != reading.sentence[first] or reading.word(index - 1) in ("not", "too", "never"):
        return False
    return index < last or not last or reading.word(index + 1) in (",", ":", ";", ".", ")", "\n", "")
