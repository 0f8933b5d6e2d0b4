"""What was mentioned before, and words that fit several things."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from mansion_editing.instructions.meaning.brief import Asked
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneObject

__all__ = ["Ambiguous", "Context", "ambiguous"]


class Ambiguous(MansionError):
    """Words that mean one thing fit several; `details` has the candidates."""


@dataclass(frozen=True)
class Context:
    """What was mentioned last.

    Attributes
    ----------
    things : tuple of str
        Ids of the objects.
    rooms : tuple of str
        Ids of the rooms.
    noun : str
        What the objects were called.
    kept : frozenset of str
        Ids of what the instruction says to leave as it is; not meant where words mean several things.
    holders : tuple of str
        Ids of what was mentioned last to put things on, in or under, or to take them from; where it is empty, that is
        what carries `things`.
    assumed : frozenset of str
        Ids of things that are where others, which are not where they were told to be, shall go: taken for those that
        went there before.
    earlier : tuple of str
        Ids of single rooms that were mentioned before `rooms`, the last one last.
    vacated : tuple of SceneObject
        What went away or moved with the last statement that took something from its place, as it stood.
    brief : Asked
        What the building's brief asked for.
    """

    things: tuple[str, ...] = ()
    rooms: tuple[str, ...] = ()
    noun: str = ""
    kept: frozenset[str] = frozenset()
    holders: tuple[str, ...] = ()
    assumed: frozenset[str] = frozenset()
    earlier: tuple[str, ...] = ()
    vacated: tuple[SceneObject, ...] = ()
    brief: Asked = field(default_factory=Asked)

    def followed(
        self, things: Sequence[str], rooms: Sequence[str], noun: str, holders: Sequence[str] = ()
    ) -> "Context":
        """Return the context after something else was mentioned; what was not stays."""
        left = self.rooms if rooms and len(self.rooms) == 1 and tuple(rooms) != self.rooms else ()
        return replace(
            self,
            things=tuple(things) or self.things,
            rooms=tuple(rooms) or self.rooms,
            noun=noun or self.noun,
            holders=tuple(holders) or (() if things else self.holders),
            earlier=(*self.earlier, *left),
        )

    def nearest(self, rooms: Sequence[str]) -> frozenset[str]:
        """Return the room, of several that are candidates, that was mentioned last; all of `rooms` where none was."""
        here = frozenset(rooms) & frozenset(self.rooms)
        before = next((room for room in reversed(self.earlier) if room in rooms), None)
        return here or (frozenset(rooms) if before is None else frozenset([before]))


def ambiguous(words: str, candidates: Sequence[str], ids: Sequence[str]) -> Ambiguous:
    shown = " or ".join(candidates[:6]) + (f" or one of {len(candidates) - 6} more" if len(candidates) > 6 else "")
    return Ambiguous(
        ErrorCode.CONFLICT,
        f"{words!r} may be {shown}; say which",
        path="$.instruction",
        details={"words": words, "candidates": list(ids)},
    )
