"""Where things usually go: on or in a receptacle, the surfaces for a noun, the rooms for a piece of furniture."""

from collections.abc import Generator
from functools import lru_cache
from typing import Final

from mansion_assets.catalogue import Catalogue
from mansion_assets.catalogue.vocabulary import vocabulary_of
from mansion_editing.provisioning.facts import Scope
from mansion_editing.provisioning.object_search import rooms_of
from mansion_editing.runs.policies import Action, Outcome, ask
from mansion_editing.state import SceneState
from mansion_editing.tools.tops import carries_on_top
from mansion_knowledge import words_by
from mansion_msgs_py.editing.questions import AssetInfo, ObjectInfo, ObjectList
from mansion_msgs_py.scene import SceneRoom

__all__ = ["_in_room_program", "find_surfaces", "is_furniture", "relation_of", "rooms_for", "usual_receptacles"]


def is_furniture(assets: list[AssetInfo], state: SceneState) -> bool:
    first = state.catalogue.asset(assets[0].asset_id)
    return first.mount == "floor" and not (first.pickupable and max(first.size) < 0.6)


def relation_of(relation: str, carrier: ObjectInfo, state: SceneState) -> str:
    """Return ``in`` or ``on``: as asked, unless the receptacle can only do the other."""
    asset = state.catalogue.assets.get(carrier.asset_id)
    if asset is None:
        return relation
    shelf = any(s.kind == "shelf" for s in asset.surfaces)
    if relation == "in" and not asset.volumes and not shelf:
        return "on"
    if relation == "on" and not carries_on_top(asset):
        return "in"
    return relation


ENOUGH: Final = 6
_EASY: Final = ("desk", "table", "counter", "shelf", "shelving_unit", "sideboard", "dresser", "nightstand", "bench")
"""Endings of categories that receive objects when an instruction names only a room."""


def find_surfaces(where: Scope, state: SceneState, noun: str = "") -> Generator[Action, Outcome, list[str]]:
    """Return receptacles of a scope with a surface: the usual ones of a noun first, then tables and the like."""
    found: list[tuple[int, str]] = []
    kinds = tuple(vocabulary_of(state.catalogue).nouns(noun)[:1]) if noun else ()
    usual = usual_receptacles(state.catalogue, kinds)
    having = {item.room for _, item in state.objects() if item.category in usual}
    rooms = sorted(rooms_of(where, state), key=lambda name: name not in having)
    for room in rooms[:40]:
        listed: ObjectList = yield from ask(f"What stands in {room}?", "ListObjects", {"room": room, "limit": 500})
        for item in listed.objects:
            asset = state.catalogue.assets.get(item.asset_id)
            if asset is not None and asset.surfaces and item.mount in ("floor", "wall"):
                easy = any(item.category.endswith(end) for end in _EASY)
                found.append((0 if item.category in usual else 1 if easy else 2, item.id))
        if sum(rank < 2 for rank, _ in found) >= ENOUGH:
            break
    return [name for _, name in sorted(found, key=lambda pair: pair[0])]


CROWDED: Final = 0.1
"""Share of a room's area by which furniture may go beyond what its program covers."""


@lru_cache(maxsize=512)
def _furniture(catalogue: Catalogue, room_type: str) -> frozenset[str]:
    """Return the categories of furniture in the program of a room type."""
    out: set[str] = set()
    for item in catalogue.room_program(room_type).floor:
        out.update([item.category] if isinstance(item.category, str) else item.category)
    return frozenset(out)


def _in_room_program(state: SceneState, room: SceneRoom, category: str) -> bool:
    """Whether the program of a room's type has furniture of a category."""
    return category in _furniture(state.catalogue, room.room_type)


@lru_cache(maxsize=512)
def usual_receptacles(catalogue: Catalogue, categories: tuple[str, ...]) -> frozenset[str]:
    """Return the categories of furniture on which the catalogue arranges small objects of some categories."""
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

    Rooms whose program has it come first, then rooms that are not crowded, then those with the most free floor.
    Corridors and the like are left out unless the scope names rooms.
    """
    ranked: list[tuple[bool, bool, float, str]] = []
    for floor, room in state.rooms():
        if where.floor not in (None, floor) or (where.rooms and room.id not in where.rooms):
            continue
        index = state.index(floor)
        belongs = _in_room_program(state, room, category)
        card = state.catalogue.room_program(room.room_type)
        if not (belongs or where.rooms) and card.room_type in words_by("uses")["passing"]:
            continue
        covered = sum(
            item.size[0] * item.size[1] for item in index.objects if item.room == room.id and item.mount == "floor"
        )
        share = (covered + size[0] * size[1]) / max(room.area, 0.1)
        free = max((part.area for part in index.passages.parts.get(room.id, ())), default=0.0)
        ranked.append((not belongs, share > card.cover + CROWDED, -round(free, 3), room.id))
    return [name for *_, name in sorted(ranked)]
