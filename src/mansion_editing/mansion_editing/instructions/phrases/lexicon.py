"""The nouns that an instruction may use: a building's rooms by all their names, and the objects of the catalogue."""

from collections.abc import Iterator
from functools import cached_property, lru_cache

from mansion_assets.catalogue import Catalogue
from mansion_assets.catalogue.vocabulary import stems, vocabulary_of
from mansion_editing.instructions.phrases.verb_words import VERB_WORDS
from mansion_editing.instructions.phrases.word_sets import DOOR_KINDS, OUTER_DOORS
from mansion_editing.instructions.phrases.words import FUNCTION_WORDS, VAGUE
from mansion_editing.state import SceneState
from mansion_knowledge import default_knowledge, interchangeable_names
from mansion_knowledge.common_words import common_words
from mansion_language.spelling import Speller

__all__ = ["ANYTHING", "HYPERNYMS", "LIGHTS", "READ_LIKE", "WAYS", "Lexicon"]

ANYTHING = frozenset(["thing", "object", "stuff", "item", "content", "everything", "anything", "clutter", "mess"])
"""Nouns for whatever is there."""

HYPERNYMS = frozenset(
    "furniture light lighting seat seating drink fruit electronics decoration appliance food cutlery tableware "
    "dish toy device equipment computer vegetable plant storage kitchenware alcohol beverage gadget water wine".split()
)
"""Nouns for objects of several categories."""

WAYS = frozenset(["way", "path", "route", "access", "passage", "walkway"])
"""Nouns for what a robot gets through by."""

LIGHTS = ("lamp", "light", "chandelier", "ceiling_panel", "spot_track")
"""Ends of the categories that give light."""

_DOORS = frozenset({("door",), *((word, "door") for word in (*OUTER_DOORS, *DOOR_KINDS))})
"""Nouns for what opens and closes in the structure."""

READ_LIKE = {"kid": "child", "centre": "middle", "center": "middle"}
"""Words that instructions are read with in place of others."""

_PERSONS_OF_ROOMS = frozenset("child guest staff patient nurse teacher family man woman doctor".split())
"""Persons that rooms are named after, whose name alone does not mean the room."""

_NO_OBJECTS = frozenset(["room", "floor", "area", "hall", "office", "space", "place", "side", "top"])
"""Nouns that end names of objects but do not name any by themselves."""

_KINDS_OF_SPACES = frozenset("room bedroom bathroom office hall area studio station kitchen suite lounge shop".split())
"""Last words of names of rooms that are left out in front of what stands in them."""

_ENCLOSING = (
    "fridge",
    "freezer",
    "wardrobe",
    "dishwasher",
    "oven",
    "microwave",
    "washing_machine",
    "minibar",
    "locker",
)
"""Ends of the categories that things are kept in and seldom on."""

_STOREY_WORDS = frozenset("upper lower ground floor first second third fourth fifth sixth top".split())

_DWELLINGS = frozenset(["flat", "apartment"])
"""Words for the same kind of building."""

_CORES = frozenset(["stair", "staircase", "elevator", "entrance", "exit", "stairwell"])


class Lexicon:
    """What nouns mean in one building.

    Parameters
    ----------
    state : SceneState
    """

    def __init__(self, state: SceneState) -> None:
        self._state = state
        self._objects: dict[tuple[str, ...], bool] = {}
        self._here: dict[str, bool] = {}

    @cached_property
    def _room_names(self) -> frozenset[tuple[str, ...]]:
        shortened = {name[:-1] for name in self._whole_room_names if _may_be_shortened(name)}
        kinds = {room.room_type for _, room in self._state.rooms()}
        others = {name for kind in kinds for name in _names_of_kind(kind) if len(name) > 1 or not self.is_object(name)}
        return self._whole_room_names | shortened | others

    @cached_property
    def _whole_room_names(self) -> frozenset[tuple[str, ...]]:
        return frozenset(_names_of_rooms(self._state))

    @cached_property
    def _object_names(self) -> frozenset[tuple[str, ...]]:
        return frozenset(stems(item.name) for _, item in self._state.objects())

    def is_room(self, words: tuple[str, ...]) -> bool:
        """Whether words in the singular are a name, an alias or a kind of a room of the building, or of any."""
        return words in self._room_names or words in _kinds_of_rooms(self._state.catalogue)

    def is_own_room(self, words: tuple[str, ...]) -> bool:
        """Whether words name a room that this building has."""
        return words in self._room_names

    def begins_room(self, words: tuple[str, ...]) -> bool:
        """Whether words are the name of a room that this building has, without its last word: the master (bedroom)."""
        return any(name[:-1] == words and name[-1] in _KINDS_OF_SPACES for name in self._whole_room_names)

    def means_own_room(self, words: tuple[str, ...]) -> bool:
        """Whether words name a room that this building has, or are what people say for the name of one: the loo."""
        names = interchangeable_names().get(" ".join(words), ())
        return self.is_own_room(words) or any(self.is_own_room(stems(name)) for name in names)

    def is_short_for_room(self, words: tuple[str, ...]) -> bool:
        """Whether words name a room only without their last one, and may mean a thing: the computer (room)."""
        return self.is_own_room(words) and words not in self._whole_room_names

    def is_building(self, word: str) -> bool:
        """Whether a word means this building by its kind: ``the flat``, ``the house``, and no room is called so."""
        kinds = {scene.building_type.split("_")[-1] for scene in self._state.scenes.values()}
        kinds |= _DWELLINGS if kinds & _DWELLINGS else set()
        return word in kinds | {"house"} and not self.is_room((word,)) and not self.is_object((word,))

    def written_in_full(self, short: str, following: str) -> str:
        """Return the first word of the room's name that a shorter one stands for: ``exam room`` of an examination room.

        The word itself where no room here is called so, or rooms of several names are.
        """
        if (short, following) in self._room_names:
            return short
        whole = {name[0] for name in self._room_names if name[1:2] == (following,) and name[0].startswith(short)}
        return whole.pop() if len(whole) == 1 else short

    def is_room_id(self, text: str) -> bool:
        """Whether a text is the id of a room, or the end of one (``meeting_room_1``)."""
        low = text.lower()
        return any(low in (room.id.lower(), room.id.lower().split("/", 1)[-1]) for _, room in self._state.rooms())

    def is_object(self, words: tuple[str, ...]) -> bool:
        """Whether words in the singular name objects, by the catalogue or by the scene."""
        if words not in self._objects:
            text = " ".join(words)
            if len(words) == 1 and words[0] in _NO_OBJECTS:
                return False
            known = bool(vocabulary_of(self._state.catalogue).nouns(text)) or words in self._object_names | _DOORS
            self._objects[words] = known or (len(words) == 1 and words[0] in HYPERNYMS | WAYS)
        return self._objects[words]

    def is_here(self, word: str) -> bool:
        """Whether a word names objects that the building has."""
        if word not in self._here:
            kinds = {*vocabulary_of(self._state.catalogue).nouns(word)}
            self._here[word] = any(
                item.category in kinds or stems(item.name)[-1:] == (word,) for _, item in self._state.objects()
            )
        return self._here[word]

    def is_called(self, words: tuple[str, ...]) -> bool:
        """Whether words are the whole name of objects, not only its end (a kitchen, of a toy kitchen)."""
        return bool(vocabulary_of(self._state.catalogue).exact(words)) or words in self._object_names

    def is_way(self, word: str) -> bool:
        """Whether a word names what a robot gets through by."""
        return word in WAYS

    def stands(self, words: tuple[str, ...]) -> bool:
        """Whether words name furniture that stands on the floor; a general word, where most of its kinds do."""
        kinds = vocabulary_of(self._state.catalogue).nouns(" ".join(words))
        mounts = [self._state.catalogue.by_category(kind)[0].mount for kind in kinds]
        general = not vocabulary_of(self._state.catalogue).exact(words)
        most = 2 * mounts.count("floor") > len(mounts)
        return most if general else mounts[:1] == ["floor"]

    def has_small_kinds(self, words: tuple[str, ...]) -> bool:
        """Whether a general word names kinds that stand and kinds that lie on furniture: plants."""
        kinds = vocabulary_of(self._state.catalogue).nouns(" ".join(words))
        exact = vocabulary_of(self._state.catalogue).exact(words)
        return not exact and any(self._state.catalogue.by_category(kind)[0].mount == "surface" for kind in kinds)

    def is_loose(self, words: tuple[str, ...]) -> bool:
        """Whether words name what lies on or in furniture."""
        kinds = vocabulary_of(self._state.catalogue).nouns(" ".join(words))
        return bool(kinds) and self._state.catalogue.by_category(kinds[0])[0].pickupable

    def carries(self, words: tuple[str, ...]) -> bool:
        """Whether words name what things lie on or in."""
        kinds = vocabulary_of(self._state.catalogue).nouns(" ".join(words))
        asset = self._state.catalogue.by_category(kinds[0])[0] if kinds else None
        return asset is not None and bool(asset.volumes or asset.surfaces)

    def encloses(self, words: tuple[str, ...]) -> bool:
        """Whether words name what things are kept in, never on: a fridge, a wardrobe."""
        kinds = vocabulary_of(self._state.catalogue).nouns(" ".join(words))
        return bool(kinds) and kinds[0].endswith(_ENCLOSING)

    def takes_state(self, words: tuple[str, ...], state: str) -> bool:
        """Whether words name what opens (``open``), or switches (``on``)."""
        kinds = vocabulary_of(self._state.catalogue).nouns(" ".join(words))
        asset = self._state.catalogue.by_category(kinds[0])[0] if kinds else None
        return asset is not None and (asset.openable if state == "open" else asset.toggleable)

    def is_set(self, words: tuple[str, ...]) -> bool:
        """Whether words name what is one thing by its plural: crayons, headphones."""
        kinds = vocabulary_of(self._state.catalogue).exact(words)
        return bool(kinds) and stems(kinds[0].replace("_", " "))[-1:] != (kinds[0].split("_")[-1],)

    def gives_light(self, words: tuple[str, ...]) -> bool:
        """Whether words name lamps."""
        kinds = vocabulary_of(self._state.catalogue).nouns(" ".join(words))
        return words[-1:] == ("light",) or (bool(kinds) and kinds[0].endswith(LIGHTS))

    def lies_beside_others(self, words: tuple[str, ...]) -> bool:
        """Whether words name loose things that hold nothing, which others of a set lie beside: plates, laptops."""
        kinds = vocabulary_of(self._state.catalogue).nouns(" ".join(words))
        asset = self._state.catalogue.by_category(kinds[0])[0] if kinds else None
        return asset is not None and asset.pickupable and not asset.volumes

    @cached_property
    def speller(self) -> Speller:
        """Mends words to names of the building and the catalogue, and to the words of instructions."""
        return _speller(
            frozenset(word for name in self._room_names | self._object_names for word in name), self._state.catalogue
        )

    @cached_property
    def kept(self) -> frozenset[str]:
        """English words that are no mistakes."""
        return common_words()


@lru_cache(maxsize=4)
def _speller(own: frozenset[str], catalogue: Catalogue) -> Speller:
    """Return what mends words, made once for the words of a building: one instruction follows another."""
    return Speller(own | _catalogue_words(catalogue), FUNCTION_WORDS | VAGUE | VERB_WORDS | _STOREY_WORDS, own)


def _names_of_rooms(state: SceneState) -> Iterator[tuple[str, ...]]:
    for _, room in state.rooms():
        own = stems(room.id.split("/", 1)[-1].replace("_", " "))
        bare = own[:-1] if own and own[-1].isdecimal() else own
        kind = stems(room.room_type.replace("_", " "))
        called = stems(room.name)
        plain = called[: called.index("for")] if "for" in called[1:] else called  # "Office for two clerks"
        for said in (own, bare, called, plain, kind, *(stems(alias) for alias in room.aliases)):
            name = tuple(READ_LIKE.get(word, word) for word in said if word != "s")  # of the children's room
            proper = tuple(
                word for word in name if word not in _words_of_kinds(state.catalogue) and not word.isdecimal()
            )
            if proper and len(proper) < len(name):
                yield proper
                yield (*proper, "room")
            if not name:
                continue
            yield name
            if len(name) > 1 and name[-1].isdecimal():
                yield name[:-1]
            if "and" in name:
                yield tuple(word for word in name if word != "and")  # "the kitchen-living room"
            if len(name) > 1 and name[-1:] in _kinds_of_rooms(state.catalogue) and name[-1] in _PLAIN_KINDS:
                yield name[-1:]  # "the kitchen" of an eat-in kitchen
            if "and" in name[1:-1]:
                joint = name.index("and")
                yield from (name[:joint], name[joint + 1 :])  # the kitchen of "Kitchen and living room"


_PLAIN_KINDS = frozenset(
    "kitchen bathroom bedroom closet library kitchenette lobby corridor hallway gallery garage terrace nursery "
    "workshop classroom laundry pantry attic basement cellar canteen cafeteria restaurant".split()
)
"""Words that tell by themselves what a room is."""


def _names_of_kind(room_type: str) -> frozenset[tuple[str, ...]]:
    """Return the other names of a kind of room: the lab of a laboratory."""
    entry = default_knowledge().rooms.get(room_type)
    return frozenset() if entry is None else frozenset(stems(name) for name in entry.synonyms)


def _may_be_shortened(name: tuple[str, ...]) -> bool:
    """Whether a room may be called by its name without the last word: the dining (room)."""
    person = len(name) == 2 and name[0] in _PERSONS_OF_ROOMS
    return len(name) > 1 and not person and name[-1] in ("room", "area", "office", "suite", "studio", "hall")


@lru_cache(maxsize=4)
def _words_of_kinds(catalogue: Catalogue) -> frozenset[str]:
    """Return the words that kinds of rooms are called by, which are no proper names."""
    usual = "left right north south east west big small main upper lower front back new old open private shared"
    return frozenset(word for kind in _kinds_of_rooms(catalogue) for word in kind) | frozenset(usual.split())


@lru_cache(maxsize=4)
def _kinds_of_rooms(catalogue: Catalogue) -> frozenset[tuple[str, ...]]:
    kinds = {stems(kind.replace("_", " ")) for kind in catalogue.room_types}
    others = {stems(name) for names in interchangeable_names().values() for name in names}
    return frozenset(kinds | others | {(core,) for core in _CORES} | {("room",)})


@lru_cache(maxsize=4)
def _catalogue_words(catalogue: Catalogue) -> frozenset[str]:
    words: set[str] = set()
    for category in catalogue.categories:
        words.update(stems(category.replace("_", " ")))
        for synonym in catalogue.by_category(category)[0].synonyms:
            words.update(stems(synonym))
    words.update(part for kind in catalogue.room_types for part in stems(kind.replace("_", " ")))
    return frozenset(words)
