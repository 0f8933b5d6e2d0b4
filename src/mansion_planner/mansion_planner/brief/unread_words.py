"""Record the words of a brief that no statement was made of."""

from mansion_planner.brief.asides import aside_tokens
from mansion_planner.brief.exclusions import MOTIONS
from mansion_planner.brief.figurative_nouns import is_figurative
from mansion_planner.brief.idle_words import is_date_or_age, is_idle, is_idle_word
from mansion_planner.brief.persons import is_person
from mansion_planner.brief.phrase import FUNCTION_WORDS, PLAIN, PREDICATES
from mansion_planner.brief.qualifiers import is_property
from mansion_planner.brief.reading import FLOOR_WORDS, Reading
from mansion_planner.brief.rooms_of_staff import OFFICE_HOLDERS
from mansion_planner.brief.sizes import is_size

__all__ = ["leave_unread"]


def leave_unread(reading: Reading) -> None:
    """Record the runs of content words that nothing was read from; what only small words part is one run."""
    first, passed = -1, reading.taken | aside_tokens(reading)
    runs: list[tuple[int, int]] = []
    for index in range(len(reading.tokens) + 1):
        open_word = index < len(reading.tokens) and index not in passed and _is_content(reading, index)
        if open_word and first < 0:
            first = index
        elif not open_word and first >= 0:
            if not _asks_for_nothing(reading, first, index):
                if runs and _goes_on(reading, *runs[-1], first, passed):
                    first = runs.pop()[0]
                runs.append((first, index))
            first = -1
    reading.facts.unread += [reading.span(begin, min(end, begin + _LONGEST)) for begin, end in runs]


def _goes_on(reading: Reading, first: int, last: int, following: int, passed: set[int]) -> bool:
    """Whether only small words part a run from the next: "share a wall", "doors at least 1 metre wide"."""
    between = range(last, following)
    small = all(
        at not in passed and (reading.word(at) in FUNCTION_WORDS - {"and", "or", "but"} or reading.kind(at) == "unit")
        for at in between
    )
    near = len(between) <= _PARTING and following - first < _LONGEST
    return near and small and reading.sentence[first] == reading.sentence[following]


_LONGEST, _PARTING = 12, 3
"""Tokens of a run that is told of, and between two that are told of together, at most."""


def _asks_for_nothing(reading: Reading, first: int, last: int) -> bool:
    """Whether each token of an unread run is a word or a number that asks for nothing by itself."""
    return all(
        is_idle(reading, at) or is_date_or_age(reading, at) or _is_ones_own(reading, at) or _is_told_of(reading, at)
        for at in range(first, last)
    )


def _is_told_of(reading: Reading, index: int) -> bool:
    """Whether a token is where people go ("to Ireland"), the way of a verb ("moving back"), or what is not needed."""
    token, before = reading.tokens[index], reading.word(index - 1)
    town = token.capital and token.kind == "word" and before in ("to", "in", "from", "near") and index > 1
    town = town and reading.kind(index + 1) != "number" and index not in reading.mention_at
    way = token.text in _WAYS_OF_VERBS and is_idle_word(before)
    needless = before == "no" and reading.word(index + 1) in ("needed", "necessary", "required")
    return town or way or needless or token.text in _REFLEXIVE


_WAYS_OF_VERBS = frozenset({"back", "away", "out", "ahead", "around", "home"})
_REFLEXIVE = frozenset(
    {"myself", "yourself", "himself", "herself", "ourselves", "themselves", "yourselves", "themself", "ourself"}
)


def _is_ones_own(reading: Reading, index: int) -> bool:
    """Whether a number counts people, pets or times: "our second baby", "the third time", "two cats"."""
    after = reading.word(index + 1)
    first = index - (reading.word(index) in _PETS)
    if reading.kind(first) == "number" and reading.word(first + 1) in _PETS and reading.word(first - 1) in _HAVING:
        return True
    return reading.kind(index) == "ordinal" and (is_person(after) or is_idle_word(after))


_PETS = frozenset({"cat", "dog", "kitten", "puppy", "pet"})
"""Who lives with those who write, and asks for nothing: "we have two cats"."""
_HAVING = frozenset({":", "have", "own", "has"})


_HOUSEHOLD = frozenset({"couple", "family", "man", "woman", "people", "professional"})
"""Whose age asks for nothing that a building could have."""

_RELATING = frozenset(
    """
    above below beneath underneath over under behind beside next near opposite surrounded share sharing overlooking
    facing face overlook between identical except unless half ditto idem likewise adjacent adjoining touching
    """.split()
)
"""Words that tell where a room is, or what it shares; where no relation was read they are told of."""

_BENEATH = frozenset({"below", "beneath", "underneath"})
"""Where every basement is."""

_WAYS = frozenset({"through", "from", "via", "by"})
_LAID = frozenset("wrapped grouped built laid set folded closed clustered".split())
_YARDS = frozenset({"courtyard", "patio", "yard", "atrium", "cloister"})
"""What an outline is read from where a building stands around it."""

_REQUESTS = frozenset(
    """
    design generate imagine think thank suppose assume kindly hereby attach attached regards turn convert converting
    furnish bought dream dreaming wanting requiring requirement help mean means call enter coming map
    wished wishing renovate refurbish redesign naturally course completely strictly oh whatever latter thereabouts
    scene scenario environment world god sake
    utmost provided outgrown premises actually hmm hm um uh erm scrap wait sorry oops add adding cheer regard behalf
    """.split()
)
"""Words that ask for a building and say nothing of it."""

_LABELS = frozenset(
    """
    accommodation schedule programme program character idiom core capacity interior requirement note summary project
    client sector retail residential commercial hospitality leisure healthcare education circulation vertical scope
    object furniture furnishing pet
    """.split()
)
"""What the lists and headings of a written brief are called."""

_PRAISE = frozenset(
    """
    fancy posh lovely gorgeous charming stunning spectacular magnificent superb impressive wonderful amazing pretty cute
    cheap affordable inexpensive lively perfect perfectly happy fantastic marvellous delightful inviting memorable fun
    chic flair vibe vibes
    """.split()
)
"""Words of taste, which no building could be checked for."""

_ASKING = {
    "planning": frozenset({"a", "an", "the", "our", "my", "to", "this"}),
    "plan": frozenset({"a", "an", "the", "our", "my", "me", "us", "this"}),
    "draw": frozenset({"a", "an", "the", "up", "me", "us", "out"}),
    "show": frozenset({"me", "us"}),
    "looking": frozenset({"for"}),
    "move": frozenset({"into", "to"}),
    "letting": frozenset({"a", "an", "the", "our", "my", "out"}),
    "restoring": frozenset({"a", "an", "the", "our", "my"}),
    "building": frozenset({"a", "an", "our", "my"}),
    "search": frozenset({"a", "an", "for"}),
    "test": frozenset({"scene", "scenario", "environment", "world", "setup"}),
    "retirement": frozenset({"place", "home", "house"}),
    "space": frozenset({"for"}),
}
"""Verbs that ask for a building where one of these words follows: "we are looking for a flat", "plan a clinic"."""

_AFTER_LEAD = {
    "mind": frozenset({"in"}),
    "possible": frozenset({"if", "where", "when", "as"}),
    "thought": frozenset({"second"}),
    "forget": frozenset({"not"}),
}
"""Words that ask for nothing after one of these: "I have a studio flat in mind", "if possible", "do not forget"."""

_FORMS = frozenset({"form", "plan", "shape", "format", "layout", "outline"})
"""Nouns of an outline that is read from the words beside them: "an L-shaped plan", "in form of U"."""


def _is_content(reading: Reading, index: int) -> bool:
    """Whether a token that nothing was read from asks for something."""
    token = reading.tokens[index]
    if _says_no_more(reading, index):
        return False
    if token.kind == "number":
        bed = token.text == "double" and reading.word(index + 1) == "bed" and index + 1 in reading.taken
        return not (bed or _numbers_line(reading, index))
    return (
        token.kind == "ordinal"
        or _places(reading, index)
        or _restricts(reading, index)
        or (
            token.kind == "word"
            and token.text not in FUNCTION_WORDS
            and (token.text not in PLAIN or is_property(token.text) or is_size(token.text))
            and token.text not in FLOOR_WORDS
            and token.text not in _REQUESTS | _PRAISE | PREDICATES
            and not (token.text in _FORMS and _is_of_outline(reading, index))
            and len(token.text) > 1
        )
    )


def _points_back(reading: Reading, index: int) -> bool:
    """Whether a number only points at what was read, or bounds it: "one of the bars", "two at the very most"."""
    token, after = reading.tokens[index], reading.words(index + 1, index + 5)
    if token.kind != "number" or reading.kind(index + 1) == "unit":
        return False
    if after[:2] in (("at", "most"), ("at", "maximum"), ("at", "max")) or after[:4] == ("at", "the", "very", "most"):
        return True
    if after[:3] == ("at", "the", "most"):
        return True
    read = any(at in reading.taken for at in range(index + 3, index + 5))
    some = after[:1] == ("of",) and after[1:2] in (("the",), ("our",), ("these",), ("those",)) and read
    last = reading.breaks(index + 1) or after[:1] in ((",",), (":",))
    return token.text == "one" and (some or (last and reading.word(index - 1) in _BEFORE_PRONOUN))


_BEFORE_PRONOUN = frozenset({"be", "have", "want", "need", "like", "has", "without", "not", "such", "get", "quick"})
"""Words before "one" where it stands for what was named: "there must not be one"."""


def _is_refused_thing(reading: Reading, index: int) -> bool:
    """Whether a token is a thing that is not wanted, and that no building here has: "no anchors on the walls"."""
    word = reading.word(index)
    if word in _PARTS or reading.kind(index) != "word":
        return word in ("wall", "ceiling") and reading.word(index - 1) == "the" and _hangs_nothing(reading, index - 2)
    ends = reading.breaks(index + 1) or reading.word(index + 1) in (
        ",",
        "on",
        "in",
        "and",
        "or",
        "please",
        ")",
        "anywhere",
    )
    refused = reading.word(index - 1) in ("no", "without", "nor") and ends
    plain = reading.kind(index - 1) != "number" and "but" not in reading.words(index + 3, index + 5)
    needless = plain and reading.words(index + 1, index + 3) in (("not", "need"), *(("not", word) for word in _NEEDED))
    return (refused or needless) and index not in reading.mention_at


def _hangs_nothing(reading: Reading, index: int) -> bool:
    """Whether "on" at a token follows a thing that is refused."""
    return reading.word(index) == "on" and reading.word(index - 2) in ("no", "without", "nor")


_NEEDED = frozenset({"needed", "required", "necessary", "wanted"})
_PARTS = frozenset(
    """
    window door wall ceiling roof floor step threshold noise light sun view corridor light smell glass access street
    """.split()
)
"""Parts and qualities that any building has, and which therefore have to be told of where they are not wanted."""


def _says_no_more(reading: Reading, index: int) -> bool:
    """Whether a token only goes with what was read beside it: "a bakery building", "a gross area of 90 m2"."""
    token = reading.tokens[index]
    if _points_back(reading, index) or _is_refused_thing(reading, index):
        return True
    if token.text == "plan" and reading.word(index - 1) in ("need", "want", "make", "require"):
        return True  # "I need plan for my thesis"
    if token.text == "one" and (reading.word(index + 1) == "another" or reading.word(index - 1) in ("each", "every")):
        return True
    if token.text == "one" and reading.word(index - 1) in PLAIN and reading.word(index - 2) in ("a", "an", "the"):
        return True  # "a studio flat, a modern one"
    if token.text == "one" and index - 1 in reading.taken and reading.word(index - 2) in ("a", "an"):
        return True
    if token.text in _LABELS and ":" in reading.words(index + 1, index + 3):
        return True
    if reading.word(index + 1) in _ASKING.get(token.text, ()):
        return True
    if reading.word(index - 1) in _AFTER_LEAD.get(token.text, ()):
        return True
    if token.text in _LOFTY and reading.word(index + 1) == "ceiling" and index + 1 in reading.taken:
        return True  # "high ceilings of 4 m"
    if reading.word(index - 1) == "the" and reading.word(index + 1) in OFFICE_HOLDERS:
        return True  # "an office for the station chief"
    level = _on_one_level(reading) or not reading.facts.floors
    if token.text == "step" and reading.word(index - 1) in ("no", "without", "any") and level:
        return True  # "everything on one level, no steps"
    if token.text == "over" and reading.word(index + 1) == "all" and _has_measure(reading, index):
        return True  # "150 m2 over all"
    if token.text == "quiet" and reading.word(index - 1) in ("need", "want", "like", "love"):
        return True  # "I need quiet" is a reason
    if token.text == "flat" and is_figurative(reading, index, index + 1):
        return True  # "Flat, no stairs!"
    if token.text == "young" and reading.word(index + 1) in _HOUSEHOLD:
        return True
    if token.text == "plan" and (reading.word(index - 1) == "that" or _has_same_plan(reading, index)):
        return True
    if is_size(token.text) and reading.word(index - 1) in ("is", "are", "be") and reading.word(index + 1) == ",":
        return index + 2 in reading.taken and reading.kind(index + 2) == "number"  # "the kitchen is big, 25 m2"
    if token.text == "plan" and reading.words(index - 2, index) in (("is", "the"), ("that", "the")):
        return True
    if token.text in ("one", "roof") and "under one roof" in " ".join(reading.words(index - 2, index + 2)):
        return True
    if reading.words(index - 2, index) in (("it", "is"), ("it", "was"), ("it", "get")):
        return not is_property(token.text) or reading.word(index + 1) in ("there", "outside", "here")
    if token.text in ("plenty", "lots", "loads") and reading.word(index + 1) == "of":
        return True  # "plenty of cupboards" are several
    if token.text == "set" and reading.word(index + 1) == "up":
        return True
    if token.text == "room" and reading.word(index - 1) in ("all", "every") and reading.word(index + 1) == "on":
        return index + 2 in reading.taken  # "all rooms on one floor"
    if token.text == "place" and reading.word(index - 1) in _WHOSE_PLACE:
        return True
    if token.text in _SIZES and _has_measure(reading, index):
        return True  # "a gross floor area in the region of 3,200 m2"
    if token.text in _BENEATH and reading.word(index - 1) in ("basement", "cellar") and index - 1 in reading.taken:
        return True
    if token.text in _BUSINESSES and any(mention.building and mention.last == index for mention in reading.mentions):
        return True  # "a bakery building"
    told = reading.facts.building or reading.facts.building_span
    said = index - 1 in reading.taken or _has_measure(reading, index)
    said = said and not any(mention.room and mention.last == index for mention in reading.mentions)
    if token.text == "building" and told and said and not token.plural:
        return True  # "a clinic in a building of 170 m2", "an entire seven-storey building"
    around = reading.word(index + 1) in ("around", "round") and reading.word(index + 2) in ("a", "an", "the", "one")
    return token.text in _LAID and around and bool(_YARDS & set(reading.words(index + 2, index + 6)))


def _has_same_plan(reading: Reading, index: int) -> bool:
    """Whether "plan" at a token is that of storeys that were read to be alike: "the two floors have the same plan"."""
    return reading.word(index - 1) == "same" and bool(reading.facts.copies)


_LOFTY = frozenset({"high", "tall", "generous", "lofty"})
_BUSINESSES = frozenset({"building", "practice", "premises", "business"})
"""Nouns that add nothing to the kind of building before them: "a vet's practice"."""
_WHOSE_PLACE = frozenset({"old", "current", "present", "previous", "last", "other", "retirement", "new", "own", "our"})


def _on_one_level(reading: Reading) -> bool:
    return any(quantity.value == 1 for quantity in reading.facts.floors)


def _places(reading: Reading, index: int) -> bool:
    """Whether a word without a meaning of its own tells where something is: "above", "on the same floor as"."""
    word, following = reading.words(index, index + 2)
    grounded = following in ("ground", "grade") or reading.kind(index + 1) in ("number", "unit")
    if word in _RELATING and not grounded:
        return True
    if word in ("same", "different") and following in FLOOR_WORDS and index + 1 not in reading.taken:
        return True  # "on the same floor as"
    if word in ("around", "round") and following in ("it", "them", "this", "that"):
        return True  # "a hall with the shops around it"
    if word in ("around", "round") and following in ("a", "an", "the", "one"):
        return not _YARDS & set(reading.words(index + 1, index + 5))
    # "the third floor is like the second floor"
    return word == "like" and following == "the" and _names_storey(reading, index + 2)


def _restricts(reading: Reading, index: int) -> bool:
    """Whether a word without a meaning of its own says how something is, or that nothing else is."""
    word = reading.word(index)
    if reading.word(index - 1) == "(" and reading.word(index + 1) == ")" and word in PLAIN:
        return True  # "kitchen (open)"
    if (
        word in MOTIONS
        and reading.word(index - 1) in ("not", "never")
        and reading.word(index + 1) in ("into", "through")
    ):
        return True  # "the public must not get into the hall"
    if word == "only" and (reading.word(index + 1) in _WAYS or _after_way(reading, index)):
        return True  # "reached only through the kitchen", "from the kitchen only"
    if word == "only" and reading.plural(index - 1) and reading.breaks(index + 1):
        return True  # "on the first floor we want bedrooms only"
    return _keeps_to_itself(reading, index)


def _is_of_outline(reading: Reading, index: int) -> bool:
    """Whether an outline is read from the words right beside a token."""
    near = reading.tokens[max(index - 3, 0)].start, reading.tokens[min(index + 4, len(reading.tokens) - 1)].end
    return any(span.start < near[1] and near[0] < span.end for _, span in reading.facts.shapes)


def _keeps_to_itself(reading: Reading, index: int) -> bool:
    """Whether a word says that a storey is for nobody or nothing else: "the third floor is private", "exclusively"."""
    said = reading.word(index - 1) in ("is", "are", "be", "stay", "remain")
    return reading.word(index) in ("exclusively", "solely", "purely") or (
        said and reading.word(index) in ("private", "public")
    )


def _numbers_line(reading: Reading, index: int) -> bool:
    """Whether a number is that of an entry in a list of lines: "2. Lobby"."""
    marked = reading.word(index + 1) in (".", ")") and not reading.tokens[index + 1].spaced
    return marked and (index == 0 or reading.word(index - 1) == "\n") and reading.word(index + 2) not in ("", "\n")


_SIZES = frozenset(
    "footprint area gross rough region vicinity order size surface space net nearest neighbourhood sum".split()
)
"""Words that lead to an area of the building, and say no more than it does."""


def _has_measure(reading: Reading, index: int) -> bool:
    """Whether an area that was read follows a word within its clause, or stands right before it."""
    around = (*range(index - 2, index), *range(index + 1, index + 9))
    units = [at for at in around if reading.kind(at) == "unit" and at in reading.taken]
    return any(reading.sentence[at] == reading.sentence[index] for at in units)


def _names_storey(reading: Reading, index: int) -> bool:
    return not FLOOR_WORDS.isdisjoint(reading.words(index, index + 2))


def _after_way(reading: Reading, index: int) -> bool:
    """Whether the words right before say which way a room is reached: "from the kitchen only"."""
    return not _WAYS.isdisjoint(reading.words(max(index - 4, 0), index)) and not reading.breaks(index)
