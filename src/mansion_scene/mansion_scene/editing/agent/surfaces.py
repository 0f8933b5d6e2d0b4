"""Receptacles and rooms of a scope, those that suit first."""

from collections.abc import Generator, Sequence
from typing import Final

from mansion_msgs_py.editing import ObjectInfo
from mansion_scene.editing.agent.facts import Scope
from mansion_scene.editing.agent.protocol import Action, Outcome
from mansion_scene.editing.state import SceneState

__all__ = ["furnishable", "relation_of", "surfaces_of"]

ENOUGH: Final = 6
_EASY: Final = (
    "desk",
    "table",
    "counter",
    "shelf",
    "shelving_unit",
    "sideboard",
    "dresser",
    "nightstand",
    "bench",
)
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


def furnishable(where: Scope, state: SceneState, usual: Sequence[str] = ()) -> list[str]:
    """Return the rooms of a scope: those whose type is usual first, then the large ones."""
    rooms = [
        (0 if room.room_type in usual else 1, -room.area, room.id)
        for floor in state.floors
        if where.floor in (None, floor)
        for room in state.scenes[floor].rooms
        if room.kind not in ("stair", "elevator") and (not where.rooms or room.id in where.rooms)
    ]
    return [name for _, _, name in sorted(rooms)]


def surfaces_of(where: Scope, state: SceneState) -> Generator[Action, Outcome, list[str] | str]:
    """Return receptacles of a scope with a surface, tables and the like first."""
    found: list[tuple[int, str]] = []
    for room in furnishable(where, state)[:40]:
        answer = yield Action(
            f"What stands in {room}?", "ListObjects", {"room": room, "limit": 500}
        )
        if answer.error is not None:
            return str(answer.error)
        for item in answer.value.objects:
            asset = state.catalogue.assets.get(item.asset_id)
            if asset is not None and asset.surfaces and item.mount in ("floor", "wall"):
                easy = any(item.category.endswith(end) for end in _EASY)
                found.append((0 if easy else 1, item.id))
        if sum(rank == 0 for rank, _ in found) >= ENOUGH:
            break
    return [name for _, name in sorted(found, key=lambda pair: pair[0])]
