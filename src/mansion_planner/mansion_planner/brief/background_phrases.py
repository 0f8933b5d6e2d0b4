"""Tell noun phrases that only speak of who writes, of what is left behind, and of what stands around the building."""

from dataclasses import replace

from mansion_planner.brief.asides import TRIALS
from mansion_planner.brief.building import MADE_INTO
from mansion_planner.brief.other_places import away_end
from mansion_planner.brief.phrase import PLAIN, Phrase
from mansion_planner.brief.reading import FLOOR_WORDS, Reading

__all__ = ["is_elsewhere", "without_bystanders"]

_STANDS = frozenset("stand sit lie located situated".split())
_SITES = frozenset("it building site house plot".split())
_LEADS = frozenset("around beside behind near opposite in on at next along off above below between".split())
_BESIDE = frozenset("between beside opposite near behind facing to from on at".split())


def without_bystanders(reading: Reading, phrases: list[Phrase]) -> list[Phrase]:
    """Return phrases of which those that name no part of the building are of an unknown head.

    "I am a vet", "we move out of our old villa", "swap our flat for a house", "the rented room is too small", "it will
    stand between the church and the inn", "the top storey houses the archive".
    """
    sites = _site_tokens(reading)
    owner = phrases[1] if len(phrases) > 1 and _owns_building(reading, *phrases[:2]) else None
    return [
        replace(phrase, head="unknown", building="", room_type="")
        if phrase is owner
        or _is_bystander(reading, phrase, sites)
        or _is_new_home(reading, phrases, number)
        or _is_customer(reading, phrases, number)
        or _is_neighbour(reading, phrases, number)
        or is_elsewhere(reading, phrases, number)
        else phrase
        for number, phrase in enumerate(phrases)
    ]


def _owns_building(reading: Reading, building: Phrase, owner: Phrase) -> bool:
    """Whether the second phrase only says whose building opens the brief: "Library of the faculty"."""
    opens = building.begin <= 2 and bool(building.building) and not owner.plural and not owner.counted
    return opens and reading.words(building.last, owner.begin) in (("of", "the"), ("of", "our"), ("of", "a"))


def _is_customer(reading: Reading, phrases: list[Phrase], number: int) -> bool:
    """Whether a phrase names those that the building works for: "a laundry for hotels", "... for schools and shops".

    It stands in the plural behind what the brief opens with, or behind another of them.
    """
    phrase = phrases[number]
    if not (phrase.building and phrase.plural) or phrase.counted or phrase.determiner:
        return False
    lead = reading.word(phrase.first - 1)
    if lead in ("and", "or", ",") and number and phrases[number - 1].last == phrase.first - 1:
        return _is_customer(reading, phrases, number - 1)
    serving = reading.word(phrase.first - 2)
    opens = 2 <= phrase.first <= _OPENING and reading.kind(phrase.first - 2) == "word"
    return lead == "for" and opens and serving not in _PLANNED and not reading.plural(phrase.first - 2)


def _is_neighbour(reading: Reading, phrases: list[Phrase], number: int) -> bool:
    """Whether a phrase names what stands near the building that the brief opens with: "a hotel near the airport"."""
    phrase = phrases[number]
    if number != 1 or not (phrase.building and phrases[0].building) or phrase.plural or phrase.counted:
        return False
    between = reading.words(phrases[0].last, phrase.first)
    near = between in (("near",), ("close", "to"), ("opposite",), ("not", "far", "from"), ("right", "by"))
    return near and phrases[0].first <= _OPENING and phrase.determiner in ("the", "our", "an", "a", "")


_OPENING = 8
"""Tokens before what a brief's building works for at most: "please design a new regional laundry plant for"."""

_PLANNED = frozenset(
    """
    plan design building block concept layout model house tower space complex sketch place premises room idea storey
    floor something one it structure centre center home me us
    """.split()
)
"""What a brief wants "for offices" where it wants offices."""


def _is_tried(reading: Reading, phrase: Phrase) -> bool:
    """Whether a phrase is part of what the building is to be used for: "for trials of lab automation robots"."""
    at = phrase.begin - 1
    while reading.word(at) in ("the", "our", "a", "an", "some", "new"):
        at -= 1
    trial = phrase.noun_end - phrase.begin == 1 and reading.word(phrase.begin) in TRIALS
    opens = reading.word(at) == "for" and reading.starts(at) and reading.word(phrase.begin - 1) in ("our", "my", "a")
    if trial and opens and not phrase.counted and reading.word(phrase.last) in (",", "we", "i", "on"):
        return True  # "For our study we need an apartment"
    if trial and not phrase.counted and reading.word(at) == "for" and reading.word(phrase.last) in ("of", "about"):
        return True  # "for the study of children"
    if phrase.name.rpartition("_")[2] == "class" and phrase.plural and not phrase.counted and reading.word(at) == "for":
        return True  # "a kitchen for cooking classes"
    if reading.word(at) not in ("of", "with", "on", "about") or reading.word(at - 1) not in TRIALS:
        return False
    return "for" in reading.words(max(at - 4, 0), at - 1)


def _is_predicate(reading: Reading, phrase: Phrase) -> bool:
    """Whether rooms named before are only said to be rooms apart, or one: "kitchen and living is one space"."""
    words = reading.words(phrase.begin, phrase.noun_end)
    if words[-1] == "space" and phrase.count == 1 and _ONE.issuperset(words[:-1]):
        whole = reading.word(phrase.first - 1) in ("is", "are", "be", "in", "form", "as", "into")
        if whole and not reading.starts(phrase.first - 1):
            reading.taken.difference_update(range(phrase.first, phrase.last))
            return True
    said = reading.word(phrase.first - 1) in ("are", "is", "be", "being") and words[-1] == "room"
    return said and len(words) > 1 and all(word in _SEPARATE for word in words[:-1])


_ONE = frozenset({"one", "single", "open", "big", "large", "common", "continuous", "open-plan", "plan"})
_SEPARATE = frozenset("separate separated different distinct independent divided own individual".split())


def _is_given_up(reading: Reading, phrase: Phrase) -> bool:
    """Whether a phrase is what one has now and parts with: "swap our flat for a house", "replace its old villa"."""
    at = phrase.begin - 1
    while reading.word(at) in PLAIN:
        at -= 1
    if reading.word(at) not in _OWNED or reading.kind(at - 1) != "word":
        return False
    verb = reading.word(at - 1)
    traded = verb in _TRADES and reading.word(phrase.last) in ("for", "against", "with")
    return traded or verb in _PARTS_WITH


def _is_compared(reading: Reading, phrase: Phrase) -> bool:
    """Whether a building is only what this one is to be like or not: "it must not feel like a hospital"."""
    lead = reading.words(max(phrase.begin - 2, 0), phrase.begin)
    likened = lead in (
        ("like", "a"),
        ("like", "an"),
        ("resemble", "a"),
        ("resemble", "an"),
        ("than", "a"),
        ("than", "an"),
    )
    return bool(phrase.building) and likened and not phrase.counted


def _is_researched(reading: Reading, phrase: Phrase) -> bool:
    """Whether a phrase is who wants to do studies, or the studies: "our lab wants to do isolation studies"."""
    verb = reading.words(phrase.last, phrase.last + 3)
    who = phrase.determiner in ("our", "my", "their") and verb[:1] and verb[0] in _PLANNING
    if who and verb[1:] and verb[1] == "to" and verb[2] in _RESEARCHING:
        return True
    last = reading.word(phrase.noun_end - 1)
    done = reading.word(phrase.first - 1) in _RESEARCHING and last in TRIALS | {"study", "experiment"}
    return done and reading.plural(phrase.noun_end - 1) and not phrase.counted


_PLANNING = frozenset("want wants plan plans wish wishes intend intends would will".split())
_RESEARCHING = frozenset("do conduct perform run study test try research simulate investigate train carry".split())


def _is_host(reading: Reading, phrase: Phrase) -> bool:
    """Whether a phrase is the old building that the new one is made in, or one of its neighbours.

    "Ground floor of an old bank", "in a former church", "it stands between two other houses".
    """
    if not phrase.building:
        return False
    words = set(reading.words(max(phrase.begin - 3, 0), phrase.noun_end))
    lead = phrase.begin - 1
    while lead > phrase.begin - 6 and reading.word(lead) in _BEFORE_HOSTS:
        lead -= 1
    part = reading.word(lead) == "of" and reading.word(lead - 1) in _PARTS_OF_HOST
    old = not _OLD.isdisjoint(words) and not {"a", "an"}.isdisjoint(reading.words(lead + 1, phrase.begin))
    if old and (part or reading.word(lead) in ("inside", "within")):
        return True
    beside = reading.word(lead) in ("between", "beside", "against") and phrase.plural
    return beside and not _NEIGHBOURS.isdisjoint(reading.words(lead, phrase.noun_end))


_BEFORE_HOSTS = frozenset("a an the old former disused existing historic two other another neighbouring next".split())
_OLD = frozenset("old former disused existing abandoned redundant historic".split())
_PARTS_OF_HOST = frozenset("floor storey level wing part half bay corner side shell walls ruin".split())
_NEIGHBOURS = frozenset("other another neighbouring neighboring existing adjoining old".split())


def _is_destination(reading: Reading, phrase: Phrase) -> bool:
    """Whether a phrase is where people are sent, away from the building: "we send the people to the hospital"."""
    lead = reading.words(max(phrase.begin - 6, 0), phrase.begin)
    to = lead[-2:] in (("to", "the"), ("to", "a"), ("to", "another"))
    who = any(lead[at] in ("we", "i", "they") and lead[at + 1] in _SENDING for at in range(len(lead) - 1))
    return to and who and bool(phrase.building)


_SENDING = frozenset({"send", "refer", "bring", "drive"})


def _is_new_home(reading: Reading, phrases: list[Phrase], number: int) -> bool:
    """Whether a home is where an organisation is to be: "our practice needs a new home", "a home for our school"."""
    phrase = phrases[number]
    bare = all(word in PLAIN for word in reading.words(phrase.begin, phrase.noun_end - 1))
    if reading.word(phrase.noun_end - 1) != "home" or not bare or phrase.plural or phrase.counted:
        return False
    after = phrases[number + 1] if number + 1 < len(phrases) else None
    if reading.word(phrase.last) == "for":
        owner = reading.word(phrase.last + 1) in _OWNED and after is not None and after.first <= phrase.last + 2
        return owner and _is_organisation(reading, after)
    sought = not _SEEKING.isdisjoint(reading.words(max(phrase.begin - 4, 0), phrase.begin))
    before = phrases[number - 1] if number else None
    clause = before is not None and reading.sentence[before.first] == reading.sentence[phrase.first]
    near = clause and before is not None and phrase.first - before.last <= 4
    return sought and near and _is_organisation(reading, before)


def _is_organisation(reading: Reading, phrase: Phrase | None) -> bool:
    """Whether a phrase names a kind of building in which nobody is at home: a practice, a library."""
    buildings = reading.knowledge.buildings
    return phrase is not None and bool(phrase.building) and buildings[phrase.building].family != "home"


_SEEKING = frozenset("need needs want wants get gets find finds seek seeks looking searching deserve".split())
"""Verbs of who is to have a home: "the club is looking for a new home"."""


_OWNED = frozenset({"our", "my", "its", "their"})
_TRADES = frozenset("swap exchange trade swapping exchanging trading".split())
_PARTS_WITH = frozenset("replace replacing replaces quit quitting sell selling sold outgrown outgrow vacate".split())
"""Verbs of those who part with what they own."""


def _is_bystander(reading: Reading, phrase: Phrase, sites: set[int]) -> bool:
    if phrase.head == "object":
        return _is_done(reading, phrase)
    if phrase.head not in ("room", "building"):
        return False
    lead = reading.words(max(phrase.first - 4, 0), phrase.begin)
    writer = any(lead[at : at + 3] in (("i", "am", "a"), ("i", "am", "an")) for at in range(len(lead)))
    left = any(lead[at : at + 2] == ("out", "of") for at in range(len(lead))) and "move" in reading.words(
        max(phrase.first - 6, 0), phrase.first
    )
    outgrown = (
        phrase.determiner == "the"
        and not phrase.counted
        and reading.words(phrase.last, phrase.last + 2) in (("is", "too"), ("was", "too"), ("has", "become"))
    ) or _is_left(reading, phrase)
    verb = (
        phrase.last - phrase.begin == 1
        and reading.tokens[phrase.begin].text in ("house", "houses")
        and reading.plural(phrase.begin)
        and reading.word(phrase.last) in ("the", "a", "an", "our", "all")
    )
    fled = not {"leaving", "fleeing", "escaping"}.isdisjoint(reading.words(max(phrase.begin - 2, 0), phrase.noun_end))
    tried = _is_tried(reading, phrase) or _is_predicate(reading, phrase)
    owned = _is_given_up(reading, phrase) or _is_destination(reading, phrase) or _is_host(reading, phrase)
    owned = owned or _is_compared(reading, phrase) or _is_researched(reading, phrase)
    made = reading.word(phrase.last) in MADE_INTO and reading.word(phrase.last + 1) in ("into", "to")
    made = made or (phrase.building != "" and reading.word(phrase.last) == "into" and not phrase.counted)
    return (
        made
        or tried
        or owned
        or fled
        or writer
        or left
        or outgrown
        or verb
        or (phrase.first in sites and phrase.determiner in ("the", ""))
    )


def _is_done(reading: Reading, phrase: Phrase) -> bool:
    """Whether a phrase is what somebody does, a verb with its object: "I write novels", "we collect chairs"."""
    if phrase.determiner == "the" and not phrase.counted and reading.word(phrase.last) in _MOVING:
        return True  # "the forklifts run on Sundays"
    bare = not phrase.counted and not phrase.determiner and not (phrase.plural and phrase.noun_end - phrase.begin == 1)
    return bare and reading.word(phrase.begin - 1) in ("i", "we", "they", "she", "he", "who", "us")


_MOVING = frozenset("run drive travel arrive leave break broke".split())


_GOING = frozenset("go goes going went gone walk walks drive cycle".split())
_NOW = frozenset("bursting small cramped tiny full old cold damp noisy overcrowded falling burnt gone getting".split())
"""What people say of the place that they have."""
_DOING = frozenset("will wants want needs need tests test uses use runs run plans plan works work trains train".split())
_BUILT_LONG_AGO = frozenset({"is", "was", "has", "had", "leaks", "leak", "burnt", "burned"})


def _is_left(reading: Reading, phrase: Phrase) -> bool:
    """Whether a phrase is the place that people have now: "the flat is bursting", "the old school leaks"."""
    if phrase.counted:
        return False
    at = phrase.last
    if reading.word(at) == ",":
        at = next((end + 1 for end in range(at + 1, at + 6) if reading.word(end) == ","), at)
    verb, after = reading.word(at), reading.word(at + 1)
    lead = reading.words(phrase.first - 2, phrase.first)
    if lead[1] in ("hate", "hates", "dislike") or (lead[0] in ("nobody", "none") and lead[1] in ("like", "likes")):
        return True  # "nobody likes long corridors"
    if reading.word(phrase.begin - 1) == "to" and reading.word(phrase.begin - 2) in _GOING and phrase.building:
        return True  # "the kids go to school"
    if phrase.determiner not in ("the", "our", "my"):
        return False
    old = verb in _BUILT_LONG_AGO and reading.word(phrase.begin) in ("old", "current", "present", "existing", "former")
    old = old or (
        verb in _BUILT_LONG_AGO and reading.word(phrase.begin - 1) in ("old", "current", "present", "existing")
    )
    home = phrase.building in ("flat", "house", "studio_flat", "apartment") and phrase.determiner != "a"
    bursting = home and verb in ("is", "was", "are") and after in _NOW
    tested = phrase.determiner in ("our", "my") and verb == "will" and after in _DOING
    return old or bursting or tested


def _site_tokens(reading: Reading) -> set[int]:
    """Return the tokens that say what the building stands beside: "it will stand between the church and the inn"."""
    found: set[int] = set()
    for index in range(len(reading.tokens)):
        if reading.word(index) not in _STANDS:
            continue
        start = index
        while start > 0 and reading.sentence[start - 1] == reading.sentence[index]:
            start -= 1
        before = reading.words(start, index)
        if index - start > 5 or _SITES.isdisjoint(before[:3]) or before[0] in _LEADS:
            continue  # "around it sit six offices" is about rooms
        at = index + 1
        while at < len(reading.tokens) and not reading.breaks(at) and reading.word(at) not in ("should", "with", "has"):
            at += 1
        if not _BESIDE.isdisjoint(reading.words(index + 1, at)):
            found.update(range(index + 1, at))
    return found


_AWAY = frozenset({"minute", "km", "kilometre", "mile", "walk", "drive", "hour"})
"""How far something is from the building."""
_FROM = frozenset({"from", "to", "of"})
_ARTICLES = frozenset({"a", "an", "the", "our", "my", "its"})
_MARKS = frozenset({":", ".", ",", ";", "(", "-", "\n", ""})
_WHOLES = frozenset({"house", "home", "flat", "building", "place", "villa"})
_NAMING = 8
"""Tokens from the start in which the building is named with whom it is for."""
_STATES = frozenset({"emergency", "accident", "fire"})
"""What a room is kept for, and no room itself: "stays open for emergencies"."""

_OUTSIDE = frozenset({("outside",), ("outdoors",), ("in", "front"), ("at", "front"), ("out", "front")})
_OUTDOOR = frozenset({"outdoor", "outside", "surface"})
"""What stands behind and before parking that is no room."""


def _lies_elsewhere(reading: Reading, phrase: Phrase) -> bool:
    """Whether a clause only tells that a room is in another place: "the main hospital is in the next town"."""
    end = away_end(reading, phrase.last + 1)
    closes = reading.breaks(end) or reading.word(end) in (",", ")")
    beside = reading.words(phrase.last + 1, end) in (("next", "door"), ("nearby",))
    opens = reading.starts(_before(reading, phrase) + 1) or reading.word(_before(reading, phrase)) in (
        ",",
        "as",
        "since",
    )
    return reading.word(phrase.last) in ("is", "are") and bool(end) and closes and opens and not beside


def is_elsewhere(reading: Reading, phrases: list[Phrase], number: int) -> bool:
    """Whether a phrase names no part of the building, but what is around it, whom it is for or what it was."""
    phrase = phrases[number]
    if phrase.name in _STATES and reading.word(phrase.first - 1) in ("for", "in", "of") and not phrase.counted:
        return True
    if number > 0 and _is_parking_outside(reading, phrase):
        return True
    if number == 1 and not phrase.counted and _is_client(reading, phrases):
        return True
    if not (phrase.building or phrase.room_type) or phrase.counted:
        return False
    if _is_near_the_whole(reading, phrases, number) or _is_studied(reading, phrase):
        return True
    if _lies_elsewhere(reading, phrase):
        reading.take(phrase.last, away_end(reading, phrase.last + 1))
        return True
    if phrase.plural:
        return False
    return (
        (bool(phrase.building) and _is_away(reading, phrase))
        or (number > 0 and _is_said_of_whole(reading, phrase))
        or _is_seen(reading, phrases, phrase)
        or (number == 1 and _is_shell(reading, phrases))
        or (number > 0 and bool(phrase.building) and _has_the_floor(reading, phrase))
    )


def _is_studied(reading: Reading, phrase: Phrase) -> bool:
    """Whether a phrase names where what is studied happens: "for our study of way-finding in hospitals we need"."""
    if not (phrase.building and phrase.plural) or phrase.determiner or reading.word(phrase.first - 1) != "in":
        return False
    first = phrase.first
    while not reading.starts(first):
        first -= 1
    opening = reading.words(first, phrase.first)
    return opening[:1] == ("for",) and not TRIALS.isdisjoint(opening)


def _is_near_the_whole(reading: Reading, phrases: list[Phrase], number: int) -> bool:
    """Whether a phrase names what the whole building stands near: "the club is close to the station"."""
    phrase = phrases[number]
    if phrase.determiner not in ("the", "a", "an", "our", "") or phrase.plural or number == 0:
        return False
    at = _before(reading, phrase)
    near = next((len(words) for words in _NEAR if reading.words(at - len(words) + 1, at + 1) == words), 0)
    verb = at - near
    verb -= near and reading.word(verb) in ("very", "quite", "right", "just", "so")
    if not near or reading.word(verb) not in _STANDS | {"is", "be", "stay"}:
        return False
    subject = verb - 1 - (reading.word(verb - 1) in ("is", "should", "will", "shall"))
    room = any(
        p.head == "room" and p.first <= subject < p.last and p.name.rpartition("_")[2] == reading.word(subject)
        for p in phrases[:number]
    )
    again = reading.word(subject - 1) in ("the", "our", "this") and reading.word(subject) in reading.words(0, _OPENING)
    return reading.word(subject) in _SITES or (again and not room)


_NEAR = (("near",), ("close", "to"), ("not", "far", "from"), ("next", "to"), ("opposite",), ("across", "from"), ("by",))


def _is_parking_outside(reading: Reading, phrase: Phrase) -> bool:
    """Whether cars are left before the building, where every plot has places for them: "parking outside"."""
    words = reading.words(phrase.begin, phrase.last)
    told_of = reading.word(phrase.last) in ("is", "are")  # "outside parking is not part of it" refuses it
    refused = reading.word(phrase.begin - 1) in ("no", "without")
    if told_of or refused or ("parking" not in words and words[-2:] != ("car", "park")):
        return False
    behind = reading.words(phrase.last, phrase.last + 2)
    return (
        behind[:1] in _OUTSIDE
        or behind in _OUTSIDE
        or not _OUTDOOR.isdisjoint((*words, reading.word(phrase.begin - 1)))
    )


def _before(reading: Reading, phrase: Phrase) -> int:
    """Return the token before a phrase and its article."""
    return phrase.begin - 1 - (reading.word(phrase.begin - 1) in _ARTICLES)


def _is_away(reading: Reading, phrase: Phrase) -> bool:
    """Whether "nine minutes from" or "a short walk to" leads to a building."""
    lead = _before(reading, phrase)
    return reading.word(lead) in _FROM and not _AWAY.isdisjoint(reading.words(max(lead - 3, 0), lead))


def _is_said_of_whole(reading: Reading, phrase: Phrase) -> bool:
    """Whether the whole is only called something once more: "this is a home that photographs well"."""
    lead = reading.words(phrase.begin - 3, phrase.begin)
    said = lead in (("this", "is", "a"), ("this", "is", "an"), ("it", "is", "a"), ("it", "is", "an"))
    return said and bool(phrase.building) and reading.word(phrase.last) in ("that", "which", "where")


def _is_seen(reading: Reading, phrases: list[Phrase], phrase: Phrase) -> bool:
    """Whether another room only looks out on a hall that is named nowhere else: "with a view over the hall"."""
    lead = reading.words(phrase.begin - 3, phrase.begin)
    seen = lead[-1:] == ("the",) and ("view" in lead or "overlooking" in lead)
    return seen and not any(p is not phrase and phrase.name in p.name for p in phrases)


def _is_client(reading: Reading, phrases: list[Phrase]) -> bool:
    """Whether the second phrase is whom the building is for: "office for a law chambers", "for an animation studio"."""
    whole, client = phrases[0], phrases[1]
    bare = bool(whole.building) and reading.word(client.begin - 1) == "for" and client.noun_end - client.begin == 1
    led = reading.word(_before(reading, client)) == "for" and (bare or reading.word(client.begin - 1) in ("a", "an"))
    opens = client.first <= _NAMING and whole.last == _before(reading, client)
    plain = reading.word(whole.noun_end - 1) in _WHOLES
    return led and opens and not plain and reading.word(client.last) in _MARKS


def _is_shell(reading: Reading, phrases: list[Phrase]) -> bool:
    """Whether the second phrase is the building that the first is made in: "coworking in a church. ..."."""
    whole, shell = phrases[0], phrases[1]
    led = reading.words(whole.last, shell.begin) in (("in", "a"), ("in", "an"), ("inside", "a"), ("inside", "an"))
    return led and bool(shell.building) and whole.begin <= 2 and reading.word(shell.last) in _MARKS


def _has_the_floor(reading: Reading, phrase: Phrase) -> bool:
    """Whether a phrase is the building in which the plan takes a storey: "second floor of a shopping arcade"."""
    lead = _before(reading, phrase)
    opens = any(reading.starts(at) for at in range(max(lead - 4, 0), lead))
    return (
        opens
        and reading.word(lead) == "of"
        and reading.word(lead - 1) in FLOOR_WORDS
        and not reading.plural(lead - 1)
        and reading.word(phrase.begin - 1) in ("a", "an")
    )
