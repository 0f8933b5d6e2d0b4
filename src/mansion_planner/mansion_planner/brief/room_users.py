"""Read who rooms of a kind are for, each with one of their own: "changing rooms for men and for women"."""

from collections import Counter
from collections.abc import Mapping
from dataclasses import replace

from mansion_language import plural, singular
from mansion_planner.brief.lexicon import lexicon_of
from mansion_planner.brief.phrase import FUNCTION_WORDS, Phrase
from mansion_planner.brief.reading import Reading

__all__ = ["PEOPLE_APART", "one_of", "with_users", "with_users_before"]

PEOPLE_APART = frozenset(
    "man woman boy girl staff guest visitor student teacher male female lady gentleman gent patient".split()
)
"""Those who have rooms of their own beside others of the kind."""
_SEXES = {
    "man": "man", "woman": "woman", "boy": "boy", "girl": "girl", "male": "man", "female": "woman", "lady": "lady",
    "gentleman": "gentleman", "masculine": "man", "feminine": "woman", "gent": "gentleman",
}  # fmt: skip
_DISABLED = frozenset("disabled handicapped invalid wheelchair".split())
_USERS_BEFORE = PEOPLE_APART | _DISABLED | {"accessible", "unisex", "referee", "umpire", "member", "public"}
"""Those whom a noun for rooms may follow: "men's, women's and accessible" toilets."""
_TOILETS = frozenset({"toilet", "restroom", "bathroom"})
_JOINTS = frozenset({"and", ",", "&", "/", "+", "plus"})
_LEADS = frozenset({",", ":", "(", "-", "–"})
_BESIDE_SEXES = frozenset({"family", "child", "kid", "adult", "baby", "swimmer", "player", "referee", "group", "team"})
"""Those who have a room of their own beside men and women."""
_PARTED = frozenset({"separated", "separate", "separately", "split", "divided", "each", "apart"})
"""Words between rooms and those who have one each."""
_PERSONS = frozenset("people person user visitor guest one".split())


def _possessive(who: str) -> str:
    """Return whose a room is that many use: "women's", "boys'", "staff"."""
    if who in ("staff", "accessible", "family"):
        return who
    users = plural(who)
    return f"{users}'" if users.endswith("s") else f"{users}'s"


def one_of(phrase: Phrase, first: int, last: int) -> Phrase:
    """Return one of the rooms that a phrase names together: the one that tokens `first` to `last` (exclusive) name."""
    return replace(phrase, count=1, counted=True, plural=False, first=first, begin=first, noun_end=last, last=last)


def with_users_before(reading: Reading, phrases: list[Phrase]) -> list[Phrase]:
    """Read "men's, women's and accessible toilets", "boys' and girls' showers" and "ladies / gents" as a room for each.

    "The ladies" and "the gents" are toilets without a noun.
    """
    found: list[Phrase] = []
    bare = {phrase.begin for phrase in phrases if phrase.head == "room" and _is_gents(reading, phrase)}
    read: set[int] = set()
    for phrase in reversed(phrases):
        if phrase.begin in read:
            continue
        if phrase.begin in bare and reading.word(phrase.first - 1) in ("for", "of"):
            found.append(replace(phrase, head="people", room_type=""))  # "a prayer hall for gents"
            continue
        users = _users_ending_at(reading, phrase, bare) if phrase.head == "room" else []
        if not users or (len(users) == 1 and phrase.begin not in bare):
            found.append(phrase)
            continue
        reading.take(users[0], phrase.last)
        read.update(users)
        found += [_for_one(reading, phrase, user, last=user == users[-1]) for user in reversed(users)]
    return found[::-1]


def _users_ending_at(reading: Reading, phrase: Phrase, bare: set[int]) -> list[int]:
    """Return the tokens of those whom a list of users before a noun names, the noun's own first word among them.

    Parameters
    ----------
    bare : set of int
        Tokens that are phrases by themselves ("gents"), and that a list may hold all the same.
    """
    users = [phrase.begin]
    if reading.word(phrase.begin) not in _USERS_BEFORE or phrase.counted:
        return []
    while True:
        joint = users[0] - 1
        joint -= reading.word(joint) in ("the", "a")
        joint -= reading.word(joint - 1) == "," and reading.word(joint) == "and"
        user = joint - 1
        if (
            reading.word(joint) not in _JOINTS
            or reading.word(user) not in _USERS_BEFORE
            or user in reading.taken - bare
            or reading.kind(user - 1) == "number"  # "a prayer hall for 300 men, a women's prayer room"
        ):
            break
        users.insert(0, user)
    return users if any(reading.word(user) in _SEXES for user in users) else []


def _is_gents(reading: Reading, phrase: Phrase) -> bool:
    """Whether a phrase is the word for those who use a toilet, and no noun follows."""
    return phrase.noun_end - phrase.begin == 1 and reading.word(phrase.begin) in _SEXES


def _for_one(reading: Reading, phrase: Phrase, user: int, *, last: bool) -> Phrase:
    """Return the room of one of the users that stand before a noun, or for a noun."""
    bare = _is_gents(reading, phrase)
    noun = "toilet" if bare else singular(reading.span(phrase.begin + 1, phrase.noun_end).words.lower())
    words = (noun,) if bare else reading.words(phrase.begin + 1, phrase.noun_end)
    named = lexicon_of(reading.knowledge).phrases.get(words)
    kind = named.room if named is not None and named.room else phrase.room_type
    room = one_of(phrase, user, user + 1)
    if last:
        room = replace(room, noun_end=phrase.noun_end, last=phrase.last)
    who = reading.word(user)
    if who in _DISABLED | {"accessible"} and kind in _TOILETS:
        return replace(room, room_type="accessible_toilet", name="accessible_toilet", label=f"accessible {noun}")
    who = _SEXES.get(who, who)
    name = "_".join((who, *words))
    return replace(room, name=name[:60], label=f"{_possessive(who)} {noun}", room_type=kind, known=True)


def with_users(reading: Reading, phrases: list[Phrase]) -> list[Phrase]:
    """Read "an ablution room for men and another for women" and "toilets (men, women, disabled)" as a room for each.

    Phrases that were read of the users' names themselves are left out.
    """
    names = Counter(phrase.name for phrase in phrases)
    found: list[Phrase] = []
    end = -1
    for phrase in sorted(phrases, key=lambda phrase: phrase.first):
        if phrase.first < end:
            continue
        parts = _by_users(reading, phrase, names)
        ends = {part.last for part in parts}
        found = [other for other in found if other.head != "people" or other.last not in ends]  # whose rooms they are
        if parts != [phrase]:
            end = max(part.last for part in parts)
        found += parts
    return found


def _by_users(reading: Reading, phrase: Phrase, names: Mapping[str, int]) -> list[Phrase]:
    """Return a room for each of its users, where a phrase tells some.

    Parameters
    ----------
    names : mapping of str to int
        How many phrases have each name: "toilet of boys and toilet of girls" are told apart by their users.
    """
    if phrase.head != "room":
        return [phrase]
    last = phrase.last
    one_of_several = names[phrase.name] > 1 and not phrase.plural
    if reading.word(last) in _SEXES and one_of_several and not phrase.plural:
        return [_of_users(reading, phrase, last)]  # "vestiary feminine"
    owners = _owners_before(reading, phrase)
    if owners:
        return [_of_owner(reading, phrase, owner) for owner in owners]
    led = reading.word(last) in ("for", "of")
    users, end = _users(reading, phrase)
    if led and len(users) == 1 and reading.word(users[0]) in _SEXES and (one_of_several or _is_one_of(phrase, names)):
        return [_of_users(reading, phrase, users[0])]
    if led and len(users) == 1 and _is_accessible(reading, phrase, users[0]) and not (phrase.plural and phrase.counted):
        reading.take(last, end)
        return [replace(_of_user(reading, phrase, users[0]), first=phrase.first, begin=phrase.begin, last=end)]
    if len(users) < 2 or (phrase.counted and phrase.count not in (1, len(users))):
        return [phrase]
    reading.take(last, end)
    rooms = [_of_user(reading, phrase, user) for user in users]
    rooms[0] = replace(rooms[0], first=phrase.first, begin=phrase.begin, noun_end=phrase.noun_end)
    rooms[-1] = replace(rooms[-1], last=end)
    return rooms


def _is_one_of(phrase: Phrase, names: Mapping[str, int]) -> bool:
    """Whether a plural is of what stands in one room of several: "toilets for girls and toilets for boys"."""
    return (
        phrase.room_type in _TOILETS | {"changing_room", "shower_area"}
        and not phrase.counted
        and names[phrase.name] > 1
    )


def _owners_before(reading: Reading, phrase: Phrase) -> list[int]:
    """Return the tokens of the two that have a room each: "dogs and cats recover in wards of their own"."""
    end = phrase.last + 3
    if not phrase.plural or reading.words(phrase.last, end) != ("of", "their", "own") or phrase.count not in (None, 2):
        return []
    start = reading.sentence.index(reading.sentence[phrase.first])
    for at in range(max(start, phrase.first - 6), phrase.first - 3):
        opens = at == start or reading.word(at - 1) in ("the", ",", ";", ":")
        if opens and reading.word(at + 1) == "and":
            other = at + 2 + (reading.word(at + 2) == "the")
            if reading.plural(at) and reading.plural(other):
                reading.take(at, other + 1)
                reading.take(phrase.last, end)
                return [at, other]
    return []


def _of_owner(reading: Reading, phrase: Phrase, owner: int) -> Phrase:
    """Return the room of one of two kinds of owners, of the kind that the lexicon has under their name."""
    who = _SEXES.get(reading.word(owner), reading.word(owner))
    named = lexicon_of(reading.knowledge).phrases.get((who, *phrase.name.split("_")))
    room = one_of(phrase, owner, owner + 1)
    kind = named.room if named is not None and named.room else phrase.room_type
    return replace(
        room, name=f"{who}_{phrase.name}"[:60], label=f"{who} {singular(phrase.label.lower())}", room_type=kind
    )


def _users(reading: Reading, phrase: Phrase) -> tuple[list[int], int]:
    """Return the tokens of those whom a phrase's rooms are for, and the token after the list; none where it has none.

    What follows "for" may be people of many kinds; a list without it ("toilets (men, women)") tells the sexes apart.
    """
    apart = phrase.plural and "separate" in reading.words(phrase.first - 1, phrase.noun_end)
    parted = reading.word(phrase.last) in _PARTED  # "ablution rooms separated for men and women"
    start = phrase.last + parted
    led = reading.word(start) in ("for", "of") or (parted and reading.word(start) in ("by", "between"))

    users: list[int] = []

    def uses(at: int) -> bool:
        word = reading.word(at)
        if word in _DISABLED:
            return True
        beside = word in _BESIDE_SEXES and bool(users) and reading.word(users[0]) in _SEXES
        return (word in PEOPLE_APART or beside or (apart and reading.plural(at))) if led else word in _SEXES

    index = start + (led or reading.word(start) in _LEADS)
    end = index
    closed = False  # behind the last "and" a comma ends the list
    while len(users) < 6:
        index += reading.word(index) in ("one", "another", "others", "a")
        index += reading.word(index) in ("for", "of") and (bool(users) or not led)
        index += reading.word(index) == "the"
        if not uses(index):
            break
        users.append(index)
        index += 1 + (reading.word(index) in _DISABLED and reading.word(index + 1) in _PERSONS)
        end = index
        if reading.word(index) not in _JOINTS or (closed and reading.word(index) == ","):
            break
        closed = closed or "and" in reading.words(index, index + 2)
        index += 1 + (reading.word(index + 1) in _JOINTS)
    bracketed = reading.word(phrase.last) == "("
    if not led and not (phrase.plural and (reading.word(end) == ")" if bracketed else _closes(reading, end))):
        return [], end
    return users, end + (bracketed and bool(users))


def _closes(reading: Reading, index: int) -> bool:
    """Whether no noun goes on at a token: "male and female toilets" are other rooms."""
    return reading.breaks(index) or reading.kind(index) == "mark" or reading.word(index) in FUNCTION_WORDS


def _is_accessible(reading: Reading, phrase: Phrase, user: int) -> bool:
    return reading.word(user) in _DISABLED and phrase.room_type in _TOILETS


def _of_user(reading: Reading, phrase: Phrase, user: int) -> Phrase:
    """Return the room that one of several users has."""
    room, who = one_of(phrase, user, user + 1), reading.word(user)
    noun = singular(phrase.label.lower())
    if _is_accessible(reading, phrase, user):
        return replace(room, room_type="accessible_toilet", name="accessible_toilet", label=f"accessible {noun}")
    who = _SEXES.get(who, who)
    return replace(room, name=f"{who}_{phrase.name}"[:60], label=f"{_possessive(who)} {noun}")


def _of_users(reading: Reading, phrase: Phrase, user: int) -> Phrase:
    """Return a room under the name of those who use it: "changing room for women", "toilet of boys"."""
    who = _SEXES[reading.word(user)]
    reading.take(phrase.last, user + 1)
    label = f"{_possessive(who)} {singular(phrase.label.lower())}"
    named = replace(phrase, name=f"{who}_{phrase.name}"[:60], label=label, last=user + 1)
    return replace(named, count=1, plural=False) if phrase.plural else named
