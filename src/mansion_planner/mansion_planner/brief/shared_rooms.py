"""Read one room that is for several uses: "one room for living and sleeping", "kitchen and dining room in one"."""

from dataclasses import replace

from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading

__all__ = ["as_studio_flat", "rooms_of_several_uses"]

_USES = {
    "living": "living", "lounging": "living", "sitting": "living", "live": "living",
    "sleeping": "sleeping", "sleep": "sleeping", "bed": "sleeping",
    "cooking": "cooking", "cook": "cooking", "kitchen": "cooking",
    "eating": "eating", "dining": "eating", "eat": "eating", "dine": "eating", "meal": "eating",
    "working": "working", "work": "working", "study": "working", "studying": "working", "office": "working",
    "playing": "playing", "play": "playing", "reading": "reading", "everything": "living",
}  # fmt: skip
_TYPES = {
    "living_room": "living", "bedroom": "sleeping", "master_bedroom": "sleeping", "kitchen": "cooking",
    "open_kitchen": "cooking", "dining_room": "eating", "home_office": "working", "study_room": "working",
}  # fmt: skip
_PLACES = frozenset({"room", "space", "area"})
_JOINTS = frozenset({"and", ",", "&", "/", "+", "as", "well"})
_ONE = frozenset({"combined", "joint", "joined", "merged", "mixed"})
_SERVES = frozenset({"serve", "serves", "serving", "double", "doubles", "doubling", "used", "act", "acts", "function"})
_STUDIO = frozenset({"living", "sleeping"})
_BEFORE_USE = frozenset("of that which is are can be will to also , ( )".split())
_USE_WORDS = frozenset("for as and or both a an the also alternately & either".split())
_MOST_BEFORE_USE, _MOST_OF_USES = 6, 10


def rooms_of_several_uses(reading: Reading, phrases: list[Phrase]) -> list[Phrase]:
    """Return the phrases with each such room as one; what names its further uses is no phrase by itself."""
    phrases = _without_what_rooms_are_used_for(reading, phrases)
    found: list[Phrase] = []
    number = 0
    while number < len(phrases):
        phrase = phrases[number]
        shared = _for_uses(reading, phrase) if phrase.head == "room" and not phrase.plural else None
        following = phrases[number + 1] if number + 1 < len(phrases) else None
        if shared is None and following is not None and phrase.head == following.head == "room":
            shared = _in_one(reading, phrase, following)
        if shared is None:
            found.append(phrase)
            number += 1
            continue
        reading.take(shared.first, shared.last)
        uses = {_USES.get(word, "") for word in shared.name.split("_")}
        kept = {shared.room_type, "" if shared.room_type == "studio_room" else "master_bedroom"}
        reading.facts.combined += [kind for kind, use in _TYPES.items() if use in uses and kind not in kept]
        found.append(shared)
        while number < len(phrases) and phrases[number].first < shared.last:
            number += 1
    return found


def _without_what_rooms_are_used_for(reading: Reading, phrases: list[Phrase]) -> list[Phrase]:
    """Return the phrases without the uses of a room: "a hall of 150 m2 used both for gym and for assemblies"."""
    dropped: set[int] = set()
    begins = {phrase.first: number for number, phrase in enumerate(phrases)}
    for number, phrase in enumerate(phrases):
        first = _use_begins(reading, phrase) if phrase.head == "room" and number not in dropped else 0
        at, inside = first, []
        while at and at - first < _MOST_OF_USES:
            if at in begins and not phrases[begins[at]].counted:
                inside.append(begins[at])
                at = phrases[begins[at]].last
            elif reading.word(at) in _USE_WORDS or reading.word(at - 1) in ("for", "as"):
                at += 1
            else:
                break
        if any(phrases[use].head == "room" and phrases[use].room_type in _TYPES for use in inside):
            continue  # "a lounge used as a bedroom" is both
        if first:
            dropped.update(inside)
            reading.take(first - 1, at)
    return [phrase for number, phrase in enumerate(phrases) if number not in dropped]


def _use_begins(reading: Reading, phrase: Phrase) -> int:
    """Return the token after "used" and the like, which say of a room what it is for; 0 where they do not."""
    at = phrase.last
    while reading.word(at) in _BEFORE_USE or reading.kind(at) in ("number", "unit"):
        at += 1
    several = reading.word(at + 1) in ("both", "for", "as") or reading.words(at + 1, at + 3) == ("alternately", "for")
    return at + 1 if at - phrase.last <= _MOST_BEFORE_USE and reading.word(at) in _SERVES and several else 0


def as_studio_flat(reading: Reading, phrases: list[Phrase]) -> None:
    """Plan a flat whose one room is for living and sleeping as a studio."""
    if not any(phrase.room_type == "studio_room" and phrase.name.count("_and_") for phrase in phrases):
        return
    facts = reading.facts
    if facts.building and facts.building[0][0] == "flat":
        facts.building_name = facts.building_name or "flat"
        facts.building[0] = ("studio_flat", facts.building[0][1])
    elif not facts.building and "studio" in facts.building_name.split("_"):
        facts.building_like = "studio_flat"


def _for_uses(reading: Reading, phrase: Phrase) -> Phrase | None:
    """Read "a room for cooking, eating and sleeping"."""
    words = reading.words(phrase.begin, phrase.last)
    if "for" not in words or _PLACES.isdisjoint(words[: words.index("for")]):
        return None
    at = phrase.begin + words.index("for") + 1
    uses: list[str] = []
    words_of_uses: list[str] = []
    last = at
    while True:
        while reading.word(at) in _JOINTS | {"for"} and uses:
            at += 1
        use = _USES.get(reading.word(at))
        if use is None or (uses and reading.word(at + 1) in _PLACES):
            break
        uses.append(use)
        words_of_uses.append(reading.word(at))
        last = at = at + 1
    return _shared(phrase, last, uses, words_of_uses) if len(set(uses)) > 1 else None


def _in_one(reading: Reading, first: Phrase, second: Phrase) -> Phrase | None:
    """Read "a combined living and dining room", "kitchen and dining room in one", "a lounge used as bedroom"."""
    if first.plural or second.plural or first.areas or (second.counted and (second.count or 0) > 1):
        return None
    uses = [_USES.get(p.name) or _TYPES.get(p.room_type, "") for p in (first, second)]
    if not all(uses) or uses[0] == uses[1]:
        return None
    called_by = [" ".join(w for w in p.name.split("_") if w not in _ONE | _PLACES) for p in (first, second)]
    gap = reading.words(first.last, second.first)
    beside = gap in (("and",), ("&",), ("/",), ("-",), ("cum",))
    bare = first.name in _USES and first.name not in ("kitchen", "office", "study")
    called = not _ONE.isdisjoint(reading.words(first.first - 1, first.noun_end)) or (bare and "sleeping" in uses)
    one = reading.words(second.last, second.last + 2) == ("in", "one")
    if beside and (called or one):
        return _shared(first, second.last + 2 * one, uses, called_by)
    serves = len(gap) <= 6 and gap[:1] in (("that",), ("which",), (",",)) and not _SERVES.isdisjoint(gap)
    return _shared(first, second.last, uses, called_by) if serves and "as" in gap else None


def _shared(phrase: Phrase, last: int, uses: list[str], words: list[str]) -> Phrase:
    """Return the room of several uses that ends before a token, called by the words for them."""
    kinds = set(uses)
    if kinds >= _STUDIO:
        room, known = "studio_room", True
    elif "sleeping" in kinds:
        room, known = "bedroom", False
    elif "cooking" in kinds:
        room, known = "open_kitchen", False
    else:
        room, known = "living_room" if "living" in kinds else phrase.room_type, False
    label = f"{' and '.join(dict.fromkeys(words))} room"
    name = label.replace(" ", "_")[:60]
    return replace(phrase, noun_end=last, last=last, room_type=room, known=known, name=name, label=label)
