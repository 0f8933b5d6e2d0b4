"""Wording of messages: names that would be accepted, names in words, articles, counts and lists."""

from bisect import insort
from collections.abc import Iterable, Sequence
from difflib import SequenceMatcher

__all__ = ["choices", "counted", "in_words", "listed", "nearest", "shortened", "with_article"]

FEW = 16
"""So many names are all shown; of more, the nearest."""

SHOWN = 6
"""How many of the nearest are shown."""

_NEAR = 0.6
"""From this likeness on a name is offered as the one that was meant."""

_FAR = 0.3
"""Below this bound of their likeness names are not compared letter by letter."""

_NEIGHBOUR = 0.02
"""What being in the same folder adds to the likeness of a name."""

_ROUNDING = 1e-9
"""More than what adding and taking away loses."""

_SURE = 0.8
"""From this likeness on a name in another folder counts in full."""

_ELSEWHERE = 0.5
"""What less likeness counts for when all that is shared may be the first folder."""

_LONG = 400
"""Characters of a wrong name that are compared and shown: names may come from anywhere."""

_SOUNDED = ("uni", "use", "usu", "uti", "eu", "one")
"""Beginnings that are written with a vowel and pronounced with a consonant."""

_MUTE = ("hour", "honest", "heir")


def with_article(words: str) -> str:
    """Return words after ``a`` or ``an``, as they are spoken.

    Examples
    --------
    >>> with_article("orange toolbox"), with_article("table"), with_article("unit"), with_article("urn")
    ('an orange toolbox', 'a table', 'a unit', 'an urn')
    """
    first = words.lower()
    vowel = first[:1] in tuple("aeiou") and not (first.startswith(_SOUNDED) and not first.startswith(("unin", "unim")))
    return f"{'an' if vowel or first.startswith(_MUTE) else 'a'} {words}"


def in_words(name: str) -> str:
    """Return a name of the payloads in words.

    Examples
    --------
    >>> in_words("meeting_room")
    'meeting room'
    """
    return name.replace("_", " ")


def counted(number: int, one: str, many: str = "") -> str:
    """Return a number and its noun.

    Examples
    --------
    >>> counted(1, "wish", "wishes"), counted(2, "wish", "wishes"), counted(0, "room")
    ('1 wish', '2 wishes', '0 rooms')
    """
    return f"{number} {one if number == 1 else many or one + 's'}"


def listed(words: Sequence[str]) -> str:
    """Return words as a list in a sentence.

    Examples
    --------
    >>> listed(["a"]), listed(["a", "b", "c"])
    ('a', 'a, b and c')
    """
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}"


def shortened(text: str, most: int) -> str:
    """Return a text whose middle is left out where it has more than `most` characters.

    Examples
    --------
    >>> shortened("no floor 9", 20), shortened("x" * 1_000_000, 20)
    ('no floor 9', 'xxxxxxxxxx... (999980 characters) ...xxxxxxxxxx')
    """
    if len(text) <= most:
        return text
    head, tail = text[: most - most // 2], text[len(text) - most // 2 :]
    return f"{head}... ({len(text) - most} characters) ...{tail}"


def nearest(wanted: str, known: Iterable[str], count: int = SHOWN) -> list[str]:
    """Return the known names that are most like one that is not among them, the likest first.

    A name that contains the other, or the last part of it, counts as near: ``floor`` is near ``target_floor``.

    Examples
    --------
    >>> nearest("floor", ["session", "target_floor", "token"], 1)
    ['target_floor']
    """
    likeness = _likenesses(wanted, known, count)
    return sorted(likeness, key=lambda name: (-likeness[name], name))[:count]


def choices(wanted: object, known: Iterable[str], noun: str) -> str:
    """Say what would be accepted in place of a wrong name: all of a few, of many the nearest and their number.

    Parameters
    ----------
    wanted : object
        What was given; anything but a text is near nothing.
    known : iterable of str
        In the order to show them in.
    noun : str
        What they are, in the plural.

    Examples
    --------
    >>> choices("floor", ["target_floor", "session"], "fields")
    'did you mean target_floor? fields: target_floor, session'
    >>> choices("room_7", [f"room_{n}" for n in range(70, 90)], "rooms")
    'did you mean room_70? the nearest of 20 rooms: room_70, room_71, room_72, room_73, room_74, room_75'
    >>> choices("x", [], "floors")
    'there are no floors'
    """
    names = list(dict.fromkeys(known))
    if not names:
        return f"there are no {noun}"
    word = wanted[:_LONG] if isinstance(wanted, str) else ""
    near = nearest(word, names)
    likeness = _likenesses(word, near[:1], 1)[near[0]]
    hint = f"did you mean {near[0]}? " if likeness >= _NEAR else ""
    if len(names) <= FEW:
        return f"{hint}{noun}: {', '.join(names)}"
    if likeness < _FAR:
        return f"{len(names)} {noun}, among them {', '.join(names[:SHOWN])}"
    return f"{hint}the nearest of {len(names)} {noun}: {', '.join(near)}"


def _plain(name: str) -> str:
    return "".join(mark for mark in name[:_LONG].casefold() if mark.isalnum() or mark == "/")


def _likenesses(wanted: str, known: Iterable[str], count: int) -> dict[str, float]:
    """Return 0 to 1 for each name; folders that a path shares with what is wanted count little.

    Only the `count` greatest are exact: of a name that is certainly less like, less than its likeness may be returned.
    """
    word = _plain(wanted)
    folder, slash, last = word.rpartition("/")
    # A matcher indexes its second sequence once.
    whole = SequenceMatcher(None, "", word, autojunk=False)
    within = SequenceMatcher(None, "", last, autojunk=False)
    likeness: dict[str, float] = {}
    greatest = [0.0] * count
    for name in known:
        plain, least = _plain(name), greatest[0]
        if slash and plain.startswith(folder + slash):
            found = _likeness(within, last, plain[len(folder) + 1 :], least - _NEIGHBOUR - _ROUNDING) + _NEIGHBOUR
        else:
            found = _likeness(whole, word, plain, least)
            if slash and found < _SURE and folder.startswith(_root(plain)):
                found *= _ELSEWHERE
        likeness[name] = found
        if found > least:
            insort(greatest, found)
            del greatest[0]
    return likeness


def _root(path: str) -> str:
    """Return the first folder of an absolute path with its slashes, of any other what no folder begins with."""
    return "/".join(path.split("/")[:2]) + "/" if path.startswith("/") else "\0"


def _likeness(matcher: SequenceMatcher[str], word: str, name: str, least: float) -> float:
    """Return how alike two names are, exactly where that is `least` or more."""
    if not word or not name:
        return 0.0
    best = 0.0
    for part in dict.fromkeys((name, name.rpartition("/")[2])):
        matcher.set_seq1(part)
        if matcher.real_quick_ratio() < least:
            continue
        bound = matcher.quick_ratio()
        if bound >= least and bound > max(best, _FAR):
            best = max(best, matcher.ratio())
    short, long = sorted((word, name), key=len)
    within = 0.7 + 0.3 * len(short) / len(long) if len(short) > 2 and short in long else 0.0
    return max(best, within)
