"""Reference resolution: the categories, objects, rooms and floors that words name in a building."""

import re
from collections.abc import Sequence
from functools import lru_cache
from typing import Final

from mansion_assets.catalogue import Catalogue
from mansion_editing.state import SceneState
from mansion_knowledge import interchangeable_names
from mansion_language import singular
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneCore, SceneObject, SceneRoom
from mansion_msgs_py.wording import ORDINALS

__all__ = [
    "COLOUR_WORDS",
    "Vocabulary",
    "colour_of",
    "find_floor",
    "find_rooms",
    "matching_objects",
    "object_named",
    "place_named",
    "stems",
    "vocabulary_of",
]

COLOUR_WORDS: Final = {
    **{
        name: name
        for name in [
            "white",
            "black",
            "grey",
            "red",
            "blue",
            "green",
            "yellow",
            "orange",
            "purple",
            "brown",
            "beige",
            "pink",
        ]
    },
    "gray": "grey",
    "silver": "grey",
    "violet": "purple",
    "lilac": "purple",
    "navy": "blue",
    "azure": "blue",
    "scarlet": "red",
    "crimson": "red",
    "maroon": "red",
    "golden": "yellow",
    "tan": "beige",
    "cream": "beige",
}
"""Words for colours, and the name that materials have for each."""

_FILLER: Final = frozenset(["a", "an", "the", "some", "any", "of", "one", "piece"])
_GENERIC: Final = {
    "table": ("table",),
    "chair": ("chair",),
    "lamp": ("lamp", "light"),
    "plant": ("plant",),
    "shelf": ("shelf", "shelving_unit", "bookshelf"),
    "cabinet": ("cabinet",),
    "bin": ("bin", "garbage_can"),
    "drink": ("cola_can", "juice_carton", "water_bottle", "beer_bottle", "wine_bottle"),
    "fruit": ("apple", "banana", "orange", "lemon"),
    "screen": ("monitor", "television", "wall_tv"),
}
"""Words that name many categories: those whose name ends with one of these."""


def stems(text: str) -> tuple[str, ...]:
    """Return the words of a text in small letters and in the singular, without articles.

    Examples
    --------
    >>> stems("The coffee-tables")
    ('coffee', 'table')
    """
    words = re.findall(r"[a-z0-9]+", text.lower())
    return tuple(singular(word) for word in words if word not in _FILLER)


class Vocabulary:
    """The names and synonyms of the catalogue's categories.

    Parameters
    ----------
    catalogue : Catalogue
    """

    def __init__(self, catalogue: Catalogue) -> None:
        self._names: dict[tuple[str, ...], dict[str, None]] = {}
        self._synonyms: dict[tuple[str, ...], dict[str, None]] = {}
        self._memory: dict[tuple[str, ...], frozenset[str]] = {}
        self.categories = catalogue.categories
        for category in catalogue.categories:
            asset = catalogue.by_category(category)[0]
            for name in (category.replace("_", " "), asset.name):
                self._names.setdefault(stems(name), {})[category] = None
            for synonym in asset.synonyms:
                self._synonyms.setdefault(stems(synonym), {})[category] = None

    def exact(self, words: tuple[str, ...]) -> list[str]:
        """Return the categories called exactly so; by synonym where none has the name itself."""
        return list(self._names.get(words) or self._synonyms.get(words, {}))

    def generic(self, words: tuple[str, ...]) -> list[str]:
        """Return the categories of which a general word (``table``) is the last part."""
        if len(words) != 1 or words[0] not in _GENERIC:
            return []
        ends = _GENERIC[words[0]]
        return [c for c in self.categories if c.endswith(ends)]

    def containing(self, words: tuple[str, ...]) -> list[str]:
        """Return the categories whose name has all of these words."""
        wanted = set(words)
        return [c for c in self.categories if wanted and wanted <= set(stems(c.replace("_", " ")))]

    def nouns(self, text: str) -> list[str]:
        """Return the categories that a noun names: by name, synonym or general word, or by the end of the name."""
        words = without_colours(stems(text))
        tails = [c for c in self.containing(words) if stems(c.replace("_", " "))[-1] in words]
        return list(dict.fromkeys((*self.exact(words), *self.generic(words), *tails)))

    def rank(self, item: SceneObject, text: str) -> int:
        """Return how well a keyword fits an object.

        3 by name, 2 by synonym or the end of the name (``desk`` of an office desk), 1 by another part of it (a desk
        phone), 0 not at all.
        """
        words = without_colours(stems(text))
        if not words:
            return 0
        names = (stems(item.category.replace("_", " ")), stems(item.name))
        if words in names:
            return 3
        if item.category in self._meant(words):
            return 2
        fits = [name for name in names if set(words) <= set(name)]
        return max((2 if name[-1] in words else 1 for name in fits), default=0)

    def _meant(self, words: tuple[str, ...]) -> frozenset[str]:
        if words not in self._memory:
            if len(self._memory) > 4096:
                self._memory.clear()
            self._memory[words] = frozenset((*self.exact(words), *self.generic(words)))
        return self._memory[words]


def without_colours(words: tuple[str, ...]) -> tuple[str, ...]:
    """Drop colours, unless nothing else is left (an orange)."""
    rest = tuple(word for word in words if word not in COLOUR_WORDS)
    return rest or words


def colour_of(material: str) -> str:
    """Return the colour in the name of a material (``paint_red``), empty when it names none.

    Examples
    --------
    >>> colour_of("paint_red")
    'red'
    """
    return next((part for part in material.split("_") if part in COLOUR_WORDS), "")


@lru_cache(maxsize=4)
def vocabulary_of(catalogue: Catalogue) -> Vocabulary:
    """Return the vocabulary of a catalogue, made once."""
    return Vocabulary(catalogue)


_TO = r"\b(?:on |at |of |from |to |in )?(?:the )?"
_FLOOR_WORDS = r"(?:floor|storey|story|level)"


def find_floor(state: SceneState, text: str) -> tuple[int | None, str]:
    """Return the floor that a text names, if any, and the text without it.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a floor that the building lacks.

    Notes
    -----
    Ordinals count from the entrance floor: the second floor is number 2; the ground floor is 1.
    """
    low = text.lower()
    ordinal = "|".join(ORDINALS)
    patterns = (
        rf"{_TO}(?:{_FLOOR_WORDS} )?(?P<word>{ordinal}|{'|'.join(_NAMED)}|\d+(?:st|nd|rd|th)) {_FLOOR_WORDS}\b",
        rf"{_TO}{_FLOOR_WORDS} (?:number |no\.? )?(?P<word>-?\d+|{'|'.join(_NUMBERS)})\b",
        rf"\b(?:on|at) the (?P<word>{ordinal}|\d+(?:st|nd|rd|th))\b",
        rf"{_TO}(?P<word>basement|cellar|upstairs|downstairs)\b",
    )
    for pattern in patterns:
        match = re.search(pattern, low)
        if match:
            floor = _floor_number(state, match["word"])
            rest = f"{text[: match.start()]} {text[match.end() :]}"
            return floor, " ".join(rest.split())
    return None, text


_NAMED = [
    "ground",
    "entrance",
    "street",
    "lowest",
    "bottom",
    "top",
    "topmost",
    "uppermost",
    "highest",
    "upper",
    "lower",
    "last",
]
_NUMBERS = ["one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"]


def _floor_number(state: SceneState, word: str) -> int:
    digits = re.match(r"-?\d+", word)
    if digits:
        number = int(digits.group()) if len(digits.group()) < 6 else 10**6
    elif word in ORDINALS:
        number = ORDINALS.index(word) + 1
    elif word in _NUMBERS:
        number = _NUMBERS.index(word) + 1
    else:
        number = _named_floor(state, word)
    if number not in state.scenes:
        raise MansionError(
            ErrorCode.NOT_FOUND,
            f"there is no floor {word}; the building has floors {', '.join(map(str, state.floors))}",
            details={"floors": state.floors},
        )
    return number


def _named_floor(state: SceneState, word: str) -> int:
    if word in ("ground", "entrance", "street"):
        return 1
    if word in ("basement", "cellar"):
        return min(0, state.floors[0])
    if word in ("lowest", "bottom", "lower", "downstairs"):
        return state.floors[0] if word != "downstairs" else 1
    if word == "upstairs":
        return min(2, state.floors[-1])
    return state.floors[-1]


def find_rooms(
    state: SceneState, text: str, on_floor: int | None = None, *, every: bool = False
) -> list[tuple[int, SceneRoom]]:
    """Return the rooms that a text names, the best fits only: by id, by the end of it, or by words and floor.

    Parameters
    ----------
    on_floor : int, optional
        The floor, where the text does not name one.
    every : bool
        All rooms of the kind instead of the best fits.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a floor that is not there.
    """
    whole = state.room(text)
    if whole is not None:
        return [whole]
    floor, rest = find_floor(state, text)
    floor = on_floor if floor is None else floor
    rooms = [(number, room) for number, room in state.rooms() if floor in (None, number)]
    ends = [pair for pair in rooms if pair[1].id.split("/", 1)[-1] == rest.strip().lower()]
    if ends and not every:
        return ends
    size = re.match(r"^(?:the )?(?P<word>largest|biggest|smallest)\s+(?P<rest>.+)$", rest, re.I)
    if size:
        few = find_rooms(state, size["rest"], floor, every=True)
        few.sort(key=lambda pair: pair[1].area, reverse=size["word"].lower() != "smallest")
        return few[:1]
    nth = re.match(rf"^(?:the )?(?P<word>{'|'.join(ORDINALS)})\s+(?P<rest>.+)$", rest, re.I)
    if nth:
        few = find_rooms(state, nth["rest"], floor, every=True)
        at = ORDINALS.index(nth["word"].lower())
        return few[at : at + 1]
    words = tuple(w for w in stems(rest) if w != "room") or stems(rest)
    if not words:
        return rooms if floor is not None else []
    ranked = [(_room_rank(room, words, stems(rest)), pair) for pair in rooms for room in [pair[1]]]
    best = max((rank for rank, _ in ranked), default=0)
    if not best:
        return _by_synonym(rooms, rest)
    least = min(best, 2) if every else best
    return [pair for rank, pair in ranked if rank >= least]


def _by_synonym(rooms: Sequence[tuple[int, SceneRoom]], text: str) -> list[tuple[int, SceneRoom]]:
    """Return the rooms that another word for the same kind of room names."""
    number = re.search(r"\s(?:number |no\.? )?(\d+)$", text.strip())
    words = stems(text[: number.start()] if number else text)
    group = next((names for name, names in interchangeable_names().items() if stems(name) == words), ())
    kinds = [stems(name) for name in group]
    return [
        pair
        for pair in rooms
        if (stems(pair[1].room_type.replace("_", " ")) in kinds or stems(pair[1].name) in kinds)
        and (number is None or pair[1].id.endswith(f"_{number[1]}"))
    ]


def _room_rank(room: SceneRoom, words: tuple[str, ...], whole: tuple[str, ...]) -> int:
    own = stems(room.id.split("/", 1)[-1].replace("_", " "))
    kind = stems(room.room_type.replace("_", " "))
    named = stems(room.name)
    if whole == own or (named and whole == named) or whole in [stems(alias) for alias in room.aliases]:
        return 4
    if whole == kind:
        return 3
    if words == tuple(w for w in kind if w != "room"):
        return 2
    return 1 if set(words) <= {*own, *kind, *named} else 0


def matching_objects(
    state: SceneState, keyword: str, rooms: Sequence[str] | None = None, floor: int | None = None
) -> list[tuple[int, SceneObject]]:
    """Return the objects that a keyword or id names, the best fits first.

    Parameters
    ----------
    rooms : sequence of str, optional
        Only in these rooms.
    """
    whole = state.find(keyword)
    if whole is not None:
        return [whole]
    words = vocabulary_of(state.catalogue)
    ranked: list[tuple[int, int, tuple[int, SceneObject]]] = []
    memory: dict[tuple[str, str], int] = {}
    for number, (its_floor, item) in enumerate(state.objects()):
        if (rooms is not None and item.room not in rooms) or floor not in (None, its_floor):
            continue
        if "/" in keyword or "_" in keyword:
            rank = 4 if item.id.endswith(f"/{keyword}") else 0
        else:
            rank = 0
        if not rank:
            key = (item.category, item.name)
            if key not in memory:
                memory[key] = words.rank(item, keyword.replace("_", " "))
            rank = memory[key]
        if rank:
            ranked.append((-rank, number, (its_floor, item)))
    ranked.sort(key=lambda entry: entry[:2])
    if ranked and ranked[0][0] < -1:
        ranked = [entry for entry in ranked if entry[0] < -1]
    return [pair for _, _, pair in ranked]


def object_named(state: SceneState, reference: str, path: str) -> tuple[int, SceneObject]:
    """Return the one object that an id, the end of an id, or a keyword names.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for none, ``CONFLICT`` for several of a keyword, with ids to choose from.
    """
    whole = state.find(reference)
    if whole is not None:
        return whole
    found = matching_objects(state, reference) if reference else []
    if not found:
        return state.get(reference, path)
    if len(found) > 1:
        some = [item.id for _, item in found[:6]]
        raise MansionError(
            ErrorCode.CONFLICT,
            f"{reference[:120]!r} names {len(found)} objects; give an id: {', '.join(some)}"
            + (", ..." if len(found) > 6 else ""),
            path=path,
            details={"candidates": some},
        )
    return found[0]


def place_named(state: SceneState, reference: str, path: str) -> tuple[int, str]:
    """Return floor and id of the room or core that a reference names; an object stands for its room.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for none, ``CONFLICT`` for rooms that cannot be told apart.
    """
    core = _core(state, reference)
    if core is not None:
        return core
    rooms = find_rooms(state, reference)
    if len(rooms) == 1:
        return rooms[0][0], rooms[0][1].id
    if not rooms:
        found = state.find(reference) or next(iter(matching_objects(state, reference)), None)
        if found is not None:
            return found[0], found[1].room
        known = [room.id for scene in state.scenes.values() for room in scene.rooms]
        raise MansionError(
            ErrorCode.NOT_FOUND,
            f"no room {reference[:120]!r}; rooms are {', '.join(known[:40])}",
            path=path,
            details={"rooms": known},
        )
    some = [room.id for _, room in rooms[:8]]
    raise MansionError(
        ErrorCode.CONFLICT,
        f"{reference[:120]!r} names {len(rooms)} rooms; give an id: {', '.join(some)}",
        path=path,
        details={"candidates": some},
    )


def _core(state: SceneState, reference: str) -> tuple[int, str] | None:
    floor, rest = find_floor(state, reference)
    names = {"elevator": "elevator", "lift": "elevator", "stairs": "stair", "stair": "stair"}
    wanted = rest.strip().lower().removeprefix("the ")
    cores: list[tuple[int, SceneCore]] = [
        (number, core) for number in state.floors if floor in (None, number) for core in state.scenes[number].cores
    ]
    for number, core in cores:
        if core.id == wanted or core.type == names.get(wanted):
            return number, core.id
    return None
