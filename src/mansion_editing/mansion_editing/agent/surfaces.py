"""Receptacles and rooms of a scope, those that suit first."""

from collections.abc import Generator
from typing import Final

from mansion_editing.agent.belonging import usual_carriers
from mansion_editing.agent.facts import Scope
from mansion_editing.agent.protocol import Action, Outcome
from mansion_editing.state import SceneState
from mansion_msgs_py.editing import ObjectInfo

__all__ = ["furnishable", "relation_of", "surfaces_of"]

ENOUGH: Final = 6
_EASY: Final = ("desk", "table", "counter", "shelf", "shelving_unit", "sideboard", "dresser", "nightstand", "bench")
"""Ends of categories on which things are put when an instruction names only a room."""


def relation_of(relation: str, carrier: ObjectInfo, state: SceneState) -> str:
    """Return ``in`` or ``on``: as asked, unless the receptacle can only do the other."""
    asset = state.catalogue.assets.get(carrier.asset_id)
    if asset is None:
        return relation
    shelf = any(s.kind == "shelf" for s in asset.surfaces)
    if relation == "in" and not asset.volumes and not shelf:
        return "on"
    if relation == "on" and not asset.surfaces:
        return "in"
    return relation


def furnishable(where: Scope, state: SceneState) -> list[str]:
    """Return the rooms of a scope, the large ones first."""
    rooms = [
        (-room.area, room.id)
        for floor in state.floors
        if where.floor in (None, floor)
        for room in state.scenes[floor].rooms
        if room.kind not in ("stair", "elevator") and (not where.rooms or room.id in where.rooms)
    ]
    return [name for _, name in sorted(rooms)]


def surfaces_of(where: Scope, state: SceneState, noun: str = "") -> Generator[Action, Outcome, list[str] | str]:
    """Return receptacles of a scope with a surface: what usually carries a thing first, then tables and the like."""
    found: list[tuple[int, str]] = []
    kinds = tuple(state.vocabulary.nouns(noun)[:1]) if noun else ()
    usual = usual_carriers(state.catalogue, kinds)
    having = {item.room for _, item in state.objects() if item.category in usual}
    rooms = sorted(furnishable(where, state), key=lambda name: name not in having)
    for room in rooms[:40]:
        answer = yield Action(f"What stands in {room}?", "ListObjects", {"room": room, "limit": 500})
        if answer.error is not None:
            return str(answer.error)
        for item in answer.value.objects:
            asset = state.catalogue.assets.get(item.asset_id)
            if asset is not None and asset.surfaces and item.mount in ("floor", "wall"):
                easy = any(item.category.endswith(end) for end in _EASY)
                found.append((0 if item.category in usual else 1 if easy else 2, item.id))
        if sum(rank < 2 for rank, _ in found) >= ENOUGH:
            break
    return [name for _, name in sorted(found, key=lambda pair: pair[0])]
