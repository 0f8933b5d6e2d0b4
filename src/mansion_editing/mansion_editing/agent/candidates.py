"""Objects, receptacles, rooms and assets that suit a fact, found with the perception tools."""

import math
from collections.abc import Generator, Sequence
from functools import lru_cache
from typing import Final

from mansion_assets.catalogue import Catalogue
from mansion_editing.agent.protocol import Action, ObjectDescription, Outcome, Scope
from mansion_editing.references import colour_of, stems, vocabulary_of
from mansion_editing.state import SceneState
from mansion_editing.tools.placement import COOLING
from mansion_knowledge import words_by
from mansion_msgs_py.editing import AssetHits, AssetInfo, ObjectInfo, ObjectList, ReceptacleReport
from mansion_msgs_py.errors import ErrorCode
from mansion_msgs_py.scene import SceneRoom
from mansion_msgs_py.wording import with_article

__all__ = [
    "AssetSearch",
    "ObjectSearch",
    "NEXT_TO",
    "Placement",
    "find_assets",
    "in_room_program",
    "is_next_to",
    "find_objects",
    "matches",
    "rooms_of",
    "list_contents",
    "exactly_named",
    "place_any",
    "receptacles",
    "find_landmarks",
    "relation_of",
    "rooms_for",
    "find_surfaces",
    "usual_receptacles",
]

ObjectSearch = Generator[Action, Outcome, list[ObjectInfo] | str]
"""Returns the objects found, or the reason why the search failed."""


def matches(thing: ObjectDescription, item: ObjectInfo, state: SceneState) -> bool:
    """Whether an object fits a description."""
    if thing.noun and thing.noun != item.id:
        scene_object = state.find(item.id)
        ends = "_" in thing.noun and item.id.endswith(f"/{thing.noun}")
        if not ends and (scene_object is None or vocabulary_of(state.catalogue).rank(scene_object[1], thing.noun) < 2):
            return False
    if thing.colour:
        material = state.find(item.id)
        if material is None or colour_of(material[1].material) != thing.colour:
            return False
    return not thing.cold or item.states.get("temperature") == "cold" or _is_cooled(item, state)


def _is_cooled(item: ObjectInfo, state: SceneState) -> bool:
    parent = state.find(item.parent or "")
    return parent is not None and item.mount == "inside" and parent[1].category in COOLING


def receptacles(where: Scope, state: SceneState) -> ObjectSearch:
    """Find the receptacles of a scope."""
    if not where.receptacle:
        return []
    found: list[ObjectInfo] = []
    for room in where.rooms or ("",):
        answer = yield Action(
            f"Which {where.receptacle} is there{f' in {room}' if room else ''}?",
            "ListObjects",
            {"room": room, "keyword": where.receptacle, "limit": 200},
        )
        if answer.error is not None:
            return str(answer.error)
        listed: ObjectList = answer.value
        found += listed.objects
    mine = [i for i in found if where.floor in (None, i.floor)]
    mine = [i for i in mine if matches(ObjectDescription(where.receptacle, 0, where.colour), i, state)]
    if stems(where.receptacle)[-1:] == (where.receptacle.lower().rpartition(" ")[2],):
        mine = exactly_named(where.receptacle, mine) or mine
    return [i for i in mine if not where.base or _is_on(i, where.base, state)]


def exactly_named(noun: str, items: list[ObjectInfo]) -> list[ObjectInfo]:
    """Return the objects whose whole name is the noun: of a fridge and a display fridge, the fridge."""
    words = stems(noun)
    return [i for i in items if stems(i.category.replace("_", " ")) == words]


def _is_on(item: ObjectInfo, base: str, state: SceneState) -> bool:
    found = state.find(item.parent or "")
    return found is not None and (found[1].id == base or vocabulary_of(state.catalogue).rank(found[1], base) >= 2)


def list_contents(receptacle: ObjectInfo, relation: str) -> ObjectSearch:
    """List the objects on or in a receptacle."""
    tool = "SearchContents" if relation == "in" else "CheckSurface"
    answer = yield Action(f"What is {relation} {receptacle.id}?", tool, {"id": receptacle.id})
    if answer.error is not None:
        return str(answer.error)
    report: ReceptacleReport = answer.value
    return report.receptacles[0].objects


def find_objects(thing: ObjectDescription, where: Scope, state: SceneState) -> ObjectSearch:
    """Find the objects in a scope that fit a description."""
    found: list[ObjectInfo] = []
    if where.receptacle:
        carriers = yield from receptacles(where, state)
        if isinstance(carriers, str):
            return carriers
        for carrier in carriers[:40]:
            for relation in ("in", "on"):
                there = yield from list_contents(carrier, relation)
                if isinstance(there, str):
                    return there
                found += [i for i in there if i not in found]
    else:
        for room in where.rooms or ("",):
            answer = yield Action(
                f"Which {thing.noun or 'things'} are there{f' in {room}' if room else ''}?",
                "ListObjects",
                {"room": room, "keyword": thing.noun, "limit": 500},
            )
            if answer.error is not None:
                return str(answer.error)
            listed: ObjectList = answer.value
            found += listed.objects
    return [i for i in found if where.floor in (None, i.floor) and matches(thing, i, state)]


NEXT_TO: Final = 0.6
"""Greatest distance between objects that are next to each other, metres."""


def find_landmarks(where: Scope, state: SceneState) -> ObjectSearch:
    """Find what a scope names as ``near``, within the rest of the scope."""
    around = Scope(where.relation, where.receptacle, where.rooms, where.floor, where.colour)
    return (yield from find_objects(ObjectDescription(where.near, 0), around, state))


def is_next_to(item: ObjectInfo, anchor: ObjectInfo, state: SceneState) -> bool:
    """Whether two objects of one room have at most `NEXT_TO` between them."""
    one, other = state.find(item.id), state.find(anchor.id)
    if one is None or other is None or item.room != anchor.room or item.floor != anchor.floor:
        return False
    reach = sum(max(thing.size[:2]) / 2 for _, thing in (one, other))
    return math.dist(one[1].position[:2], other[1].position[:2]) - reach <= NEXT_TO


ENOUGH: Final = 6
_EASY: Final = ("desk", "table", "counter", "shelf", "shelving_unit", "sideboard", "dresser", "nightstand", "bench")
"""Endings of categories that receive objects when an instruction names only a room."""


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


def rooms_of(where: Scope, state: SceneState) -> list[str]:
    """Return the rooms of a scope, the large ones first."""
    rooms = [
        (-room.area, room.id)
        for floor, room in state.rooms()
        if where.floor in (None, floor) and (not where.rooms or room.id in where.rooms)
    ]
    return [name for _, name in sorted(rooms)]


def find_surfaces(where: Scope, state: SceneState, noun: str = "") -> Generator[Action, Outcome, list[str] | str]:
    """Return receptacles of a scope with a surface: the usual ones of a noun first, then tables and the like."""
    found: list[tuple[int, str]] = []
    kinds = tuple(vocabulary_of(state.catalogue).nouns(noun)[:1]) if noun else ()
    usual = usual_receptacles(state.catalogue, kinds)
    having = {item.room for _, item in state.objects() if item.category in usual}
    rooms = sorted(rooms_of(where, state), key=lambda name: name not in having)
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


CROWDED: Final = 0.1
"""Share of a room's area by which furniture may go beyond what its program covers."""


@lru_cache(maxsize=512)
def _furniture(catalogue: Catalogue, room_type: str) -> frozenset[str]:
    """Return the categories of furniture in the program of a room type."""
    out: set[str] = set()
    for item in catalogue.room_program(room_type).floor:
        out.update([item.category] if isinstance(item.category, str) else item.category)
    return frozenset(out)


def in_room_program(state: SceneState, room: SceneRoom, categories: Sequence[str]) -> bool:
    """Whether the program of a room's type has furniture of one of the categories."""
    return not _furniture(state.catalogue, room.room_type).isdisjoint(categories)


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
        belongs = in_room_program(state, room, [category])
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


AssetSearch = Generator[Action, Outcome, list[AssetInfo] | str]
"""Ends with assets, the best first, or why there is none."""

Placement = Generator[Action, Outcome, tuple[str, str]]
"""Ends with the new object's id, or with an empty id and the reason."""

MOST_ASSETS: Final = 4


def find_assets(thing: ObjectDescription, state: SceneState) -> AssetSearch:
    """Return the assets that fit a description: the best first, then small ones; only those of its colour if any."""
    words = " ".join(word for word in (thing.colour, thing.noun) if word)
    answer = yield Action(f"Which asset is {with_article(words)}?", "SearchAssets", {"query": words, "top_k": 50})
    if answer.error is not None:
        return str(answer.error)
    hits: AssetHits = answer.value
    categories = vocabulary_of(state.catalogue).nouns(thing.noun)
    mine = [a for a in hits.assets if a.category in categories]
    known = {a.asset_id for a in mine}
    mine += [
        AssetInfo(
            asset_id=asset.key, category=category, name=asset.name, size=asset.size, score=0.0, material=asset.material
        )
        for category in categories
        for asset in state.catalogue.by_category(category)
        if asset.key not in known
    ]
    if not mine:
        return f"the catalogue has no {words}"
    exact = vocabulary_of(state.catalogue).exact(stems(thing.noun))
    mine = [a for a in mine if a.category in exact] or mine
    first = mine[0].category
    alike = [a for a in mine if a.category == first]
    if thing.colour:
        alike.sort(key=lambda a: colour_of(a.material) != thing.colour)
        own = [a for a in alike if colour_of(a.material) == thing.colour]
        alike = own or alike
    small = sorted(alike[1:], key=lambda a: a.size[0] * a.size[1] * a.size[2])
    others = [a for a in mine if a.category != first]
    return [alike[0], *small[:2], *others]


def place_any(
    assets: list[AssetInfo], carrier: str, relation: str, *, colour: str = "", near: str = "", most: int = MOST_ASSETS
) -> Placement:
    """Try variants of an asset on one receptacle.

    Parameters
    ----------
    near : str
        Id of an object to put it beside.
    """
    reason = ""
    for asset in assets[:most]:
        arguments = {"asset_id": asset.asset_id}
        if colour and colour_of(asset.material) != colour:
            arguments["color"] = colour
        if relation == "in":
            tool, arguments["container_id"] = "PlaceInContainer", carrier
        else:
            tool, arguments["receptacle_id"] = "PlaceOnSurface", carrier
            if near:
                arguments["near"] = near
        answer = yield Action(f"{asset.asset_id} is missing {relation} {carrier}.", tool, arguments)
        if answer.error is None:
            return answer.value.object_ids[0], ""
        reason = reason or answer.error.info.message
        if answer.error.code != ErrorCode.INFEASIBLE:
            break
    return "", reason
