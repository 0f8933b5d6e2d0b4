"""Where new things belong: rooms whose program has such furniture, with free floor, and no passages."""

from collections.abc import Sequence
from functools import lru_cache
from typing import Final

from mansion_assets.catalogue import Catalogue
from mansion_editing.agent.facts import Scope
from mansion_editing.state import SceneState
from mansion_msgs_py.scene import SceneRoom

__all__ = ["at_home", "rooms_for", "usual_carriers"]

PASSAGES: Final = frozenset(["corridor", "hallway", "entryway"])
"""Room types to walk through: furniture that they have none of comes there only when they are named."""

CROWDED: Final = 0.1
"""Share of a room's area by which furniture may go beyond what its program covers."""


@lru_cache(maxsize=512)
def _furniture(catalogue: Catalogue, room_type: str) -> frozenset[str]:
    """Return the categories that stand in rooms of a type."""
    out: set[str] = set()
    for item in catalogue.room_program(room_type).floor:
        out.update([item.category] if isinstance(item.category, str) else item.category)
    return frozenset(out)


def at_home(state: SceneState, room: SceneRoom, categories: Sequence[str]) -> bool:
    """Whether the program of a room's type has furniture of one of the categories."""
    return not _furniture(state.catalogue, room.room_type).isdisjoint(categories)


@lru_cache(maxsize=512)
def usual_carriers(catalogue: Catalogue, categories: tuple[str, ...]) -> frozenset[str]:
    """Return the categories of furniture on or in which the catalogue arranges small things of some categories."""
    out: set[str] = set()
    for arrangement in catalogue.arrangements.values():
        said = [entry.category for entry in (*arrangement.slots, *arrangement.seats)]
        said += [entry.category for entry in arrangement.scatter]
        names = [[name] if isinstance(name, str) else name for name in said]
        if any(category in group for group in names for category in categories):
            out.update(arrangement.on)
    return frozenset(out)


def rooms_for(where: Scope, state: SceneState, category: str, size: tuple[float, float, float]) -> list[str]:
    """Return the rooms of a scope that may take a piece of furniture, the best first.

    Those where it belongs go before others, those that are not full yet before full ones, and those with much free
    floor before narrow ones. Where rooms are named they are all there are; else passages are left out.
    """
    ranked: list[tuple[bool, bool, float, str]] = []
    for floor in state.floors:
        if where.floor not in (None, floor):
            continue
        index = state.index(floor)
        for room in state.scenes[floor].rooms:
            if room.kind in ("stair", "elevator") or (where.rooms and room.id not in where.rooms):
                continue
            belongs = at_home(state, room, [category])
            card = state.catalogue.room_program(room.room_type)
            if not (belongs or where.rooms) and card.room_type in PASSAGES:
                continue
            covered = sum(
                item.size[0] * item.size[1] for item in index.objects if item.room == room.id and item.mount == "floor"
            )
            share = (covered + size[0] * size[1]) / max(room.area, 0.1)
            free = max((part.area for part in index.passages.parts.get(room.id, ())), default=0.0)
            ranked.append((not belongs, share > card.cover + CROWDED, -round(free, 3), room.id))
    return [name for *_, name in sorted(ranked)]
