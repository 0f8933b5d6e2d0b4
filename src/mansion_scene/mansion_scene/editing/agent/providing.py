"""Provisioning of an object fact: count what is there, add what is missing where it takes the fewest edits."""

from collections.abc import Generator

from mansion_msgs_py.editing import AssetHits, AssetInfo, ObjectInfo
from mansion_msgs_py.errors import ErrorCode
from mansion_scene.editing.agent.facts import ObjectFact, Scope, Thing
from mansion_scene.editing.agent.looking import find_things, fits, look_at, receptacles
from mansion_scene.editing.agent.protocol import Action, Outcome
from mansion_scene.editing.state import SceneState
from mansion_scene.editing.vocabulary import colour_of

__all__ = ["provide", "relation_of", "surfaces_of"]

Work = Generator[Action, Outcome, str]
Assets = Generator[Action, Outcome, list[AssetInfo] | str]

MOST_CARRIERS = 6
MOST_ASSETS = 4
_EASY = (
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


def provide(fact: ObjectFact, state: SceneState) -> Work:
    """Make an object fact hold; return why it cannot."""
    if not fact.where.receptacle:
        return (yield from _provide_in_room(fact, state))
    carriers = yield from receptacles(fact.where, state)
    if isinstance(carriers, str):
        return carriers
    if not carriers:
        carrier = yield from _provide_carrier(fact, state)
        if isinstance(carrier, str):
            return carrier
        carriers = [carrier]
    counted: list[tuple[int, int, ObjectInfo]] = []
    for order, carrier in enumerate(carriers[:40]):
        relation = relation_of(fact.where.relation, carrier, state)
        there = yield from look_at(carrier, relation)
        if isinstance(there, str):
            return there
        number = sum(fits(fact.thing, item, state) for item in there)
        if number >= fact.thing.count:
            return ""
        counted.append((-number, order, carrier))
    counted.sort(key=lambda entry: entry[:2])
    return (yield from _fill(fact, [(-n, c) for n, _, c in counted[:MOST_CARRIERS]], state))


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


def _fill(fact: ObjectFact, carriers: list[tuple[int, ObjectInfo]], state: SceneState) -> Work:
    """Place what is missing on the first receptacle that takes it all."""
    assets = yield from _assets(fact.thing, state)
    if isinstance(assets, str):
        return assets
    reasons: list[str] = []
    for number, carrier in carriers:
        relation = relation_of(fact.where.relation, carrier, state)
        missing = fact.thing.count - number
        added: list[str] = []
        for _ in range(missing):
            placed = yield from _place_any(assets, carrier.id, relation)
            if not placed[0]:
                reasons.append(placed[1])
                break
            added.append(placed[0])
        if len(added) == missing:
            return ""
        for object_id in reversed(added):
            yield Action("They do not all fit there.", "RemoveObject", {"object_id": object_id})
    return "; ".join(dict.fromkeys(reasons)) or "no receptacle takes it"


def _place_any(
    assets: list[AssetInfo], carrier: str, relation: str
) -> Generator[Action, Outcome, tuple[str, str]]:
    """Try variants of an asset on one receptacle; return the new id, or the reason."""
    reason = ""
    for asset in assets[:MOST_ASSETS]:
        tool = "PlaceInContainer" if relation == "in" else "PlaceOnSurface"
        target = "container_id" if relation == "in" else "receptacle_id"
        answer = yield Action(
            f"{asset.asset_id} is missing {relation} {carrier}.",
            tool,
            {"asset_id": asset.asset_id, target: carrier},
        )
        if answer.error is None:
            return answer.value.object_ids[0], ""
        reason = reason or answer.error.info.message
        if answer.error.code != ErrorCode.INFEASIBLE:
            break
    return "", reason


def _assets(thing: Thing, state: SceneState) -> Assets:
    """Return assets of a thing, the best first, then the small ones."""
    words = " ".join(word for word in (thing.colour, thing.noun) if word)
    answer = yield Action(
        f"Which asset is a {words}?", "SearchAssets", {"query": words, "top_k": 50}
    )
    if answer.error is not None:
        return str(answer.error)
    hits: AssetHits = answer.value
    categories = state.vocabulary.nouns(thing.noun)
    mine = [a for a in hits.assets if a.category in categories]
    known = {a.asset_id for a in mine}
    mine += [
        AssetInfo(
            asset_id=asset.key,
            category=category,
            name=asset.name,
            size=asset.size,
            score=0.0,
            material=asset.material,
        )
        for category in categories
        for asset in state.catalogue.by_category(category)
        if asset.key not in known
    ]
    if thing.colour:
        mine = [a for a in mine if colour_of(a.material) == thing.colour]
    if not mine:
        return f"the catalogue has no {words}"
    first = mine[0].category
    alike = [a for a in mine if a.category == first]
    small = sorted(alike[1:], key=lambda a: a.size[0] * a.size[1] * a.size[2])
    others = [a for a in mine if a.category != first]
    return [alike[0], *small[:2], *others]


def _provide_carrier(
    fact: ObjectFact, state: SceneState
) -> Generator[Action, Outcome, ObjectInfo | str]:
    """Furnish a room of the scope with the receptacle that is missing."""
    where = fact.where
    if "/" in where.receptacle or "_" in where.receptacle:
        return f"there is no {where.receptacle}"
    assets = yield from _assets(Thing(where.receptacle), state)
    if isinstance(assets, str):
        return assets
    usual = state.catalogue.asset(assets[0].asset_id).rooms
    rooms = [
        (0 if room.room_type in usual else 1, -room.area, room.id)
        for floor in state.floors
        if where.floor in (None, floor)
        for room in state.scenes[floor].rooms
        if room.kind not in ("stair", "elevator") and (not where.rooms or room.id in where.rooms)
    ]
    standing = [a for a in assets if state.catalogue.asset(a.asset_id).mount == "floor"]
    reason = f"there is no {where.receptacle} {Scope('room', '', where.rooms, where.floor)}"
    for _, _, room in sorted(rooms)[:MOST_CARRIERS] if standing else []:
        placed = yield from _place_any(standing, room, "on")
        if placed[0]:
            listed = yield Action("It is there now.", "ListObjects", {"id": placed[0]})
            info: ObjectInfo = listed.value.objects[0]
            return info
        reason = placed[1]
    return reason


def _provide_in_room(fact: ObjectFact, state: SceneState) -> Work:
    found = yield from find_things(fact.thing, fact.where, state)
    if isinstance(found, str):
        return found
    missing = fact.thing.count - len(found)
    if missing <= 0:
        return ""
    assets = yield from _assets(fact.thing, state)
    if isinstance(assets, str):
        return assets
    if state.catalogue.asset(assets[0].asset_id).mount == "floor":
        targets = _rooms(fact.where, state)
    else:
        listed = yield from surfaces_of(fact.where, state)
        if isinstance(listed, str):
            return listed
        targets = listed
    reason = f"nothing {fact.where} carries it"
    for target in targets[:MOST_CARRIERS]:
        while missing:
            placed = yield from _place_any(assets, target, "on")
            if not placed[0]:
                reason = placed[1]
                break
            missing -= 1
        if not missing:
            return ""
    return reason


def _rooms(where: Scope, state: SceneState) -> list[str]:
    return [
        room.id
        for floor in state.floors
        if where.floor in (None, floor)
        for room in sorted(state.scenes[floor].rooms, key=lambda r: -r.area)
        if room.kind not in ("stair", "elevator") and (not where.rooms or room.id in where.rooms)
    ]


def surfaces_of(where: Scope, state: SceneState) -> Generator[Action, Outcome, list[str] | str]:
    """Return receptacles of a scope with a surface, tables and the like first."""
    found: list[tuple[int, str]] = []
    for room in _rooms(where, state)[:40]:
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
        if sum(rank == 0 for rank, _ in found) >= MOST_CARRIERS:
            break
    return [name for _, name in sorted(found, key=lambda pair: pair[0])]
