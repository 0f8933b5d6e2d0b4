"""Read which rooms of a brief are to be side by side, and which mentions of a room only repeat it."""

from mansion_planner.brief.facts import AdjacencyFact
from mansion_planner.brief.lexicon import Mention
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.similarity import AS_ROOM

__all__ = ["read_adjacency", "repeated_mentions", "room_after", "room_name"]

_BESIDE = (("next", "to"), ("adjacent", "to"), ("beside",), ("adjoining",), ("near",), ("close", "to"),
           ("alongside",), ("connected", "to"), ("attached", "to"), ("opening", "to"), ("opening", "onto"),
           ("open", "to"), ("bordering",), ("connecting", "to"), ("directly", "off"), ("besides",),
           ("adjacent",), ("neighboring",), ("neighbouring",), ("by", "the"), ("touching",))  # fmt: skip

_BESIDE_STARTS = frozenset(phrase[0] for phrase in _BESIDE) | {"should", "must", "is", "are", "opens"}


def read_adjacency(reading: Reading) -> None:
    """Read pairs that are to be side by side: "kitchen next to the dining room"."""
    for i in range(len(reading.tokens)):
        phrase = next((p for p in _BESIDE if all(reading.word(i + k) == w for k, w in enumerate(p))), None)
        if phrase is None:
            continue
        left = _room_before(reading, i)
        right = room_after(reading, i + len(phrase))
        if left is None and right is not None and phrase == ("adjacent",):
            continue
        if left is not None and right is not None:
            first, second = room_name(left), room_name(right)
            if first and second:
                reading.facts.adjacent.append(AdjacencyFact(first, second, reading.span(left.first, right.last)))


def room_name(mention: Mention) -> str:
    """Return the room type that a mention means, empty for none."""
    return mention.room or AS_ROOM.get(mention.building, "")


def _room_before(reading: Reading, index: int) -> Mention | None:
    for back in range(index, max(index - 7, -1), -1):
        mention = reading.mention_ending.get(back)
        if mention is not None and room_name(mention):
            return mention
        if reading.word(back - 1) in (".", ";", "\n"):
            return None
    return None


def room_after(reading: Reading, index: int) -> Mention | None:
    """Return the room mentioned within four words from `index`, in the same clause."""
    for at in range(index, index + 4):
        mention = reading.mention_at.get(at)
        if mention is not None and room_name(mention):
            return mention
        if reading.word(at) in (".", ";", ",", "\n"):
            return None
    return None


def repeated_mentions(reading: Reading) -> set[int]:
    """Return the first tokens of mentions that only repeat a room within a neighbour wish.

    In "a kitchen next to the dining room" the second room stands with "the": it is the one that is there anyway when
    the brief names it elsewhere.
    """
    seen: dict[str, int] = {}
    repeated: set[int] = set()
    for mention in reading.mentions:
        name = room_name(mention)
        if not name or mention.first in reading.taken:
            continue
        definite = reading.word(mention.first - 1) in (
            "the",
            "its",
            "their",
            "this",
            "that",
            "each",
            "every",
            "both",
            "all",
        )
        restated = (
            not mention.plural
            and reading.word(mention.last) in _BESIDE_STARTS
            and reading.kind(mention.first - 1) not in ("number",)
            and reading.word(mention.first - 1) not in ("a", "an")
        )
        sized = reading.word(mention.last) in ("should", "must", "is", "has", "to", "shall", "will", "of") and definite
        if name in seen and (definite or restated or sized):
            repeated.add(mention.first)
        else:
            seen.setdefault(name, mention.first)
    return repeated
