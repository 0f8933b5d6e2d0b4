"""Make facts hold with the fewest edits: place, move, remove and switch what is needed."""

from collections import Counter
from collections.abc import Generator, Mapping
from dataclasses import replace
from functools import lru_cache
from typing import Any, Final

from mansion_assets.catalogue import Catalogue
from mansion_assets.catalogue.vocabulary import stems, vocabulary_of
from mansion_editing.agent.facts import (
    Action,
    Fact,
    ObjectDescription,
    ObjectFact,
    Outcome,
    PathFact,
    Policy,
    Scope,
    Unmet,
    Verdict,
    ask,
    find_objects,
    list_contents,
    matches,
    receptacles,
    rooms_of,
)
from mansion_editing.state import SceneState
from mansion_editing.tools.placement import free_places, ledges_of
from mansion_knowledge import words_by
from mansion_language.colours import colour_of
from mansion_msgs_py.editing import AssetHits, AssetInfo, ObjectInfo, ObjectList, PathReport
from mansion_msgs_py.errors import ErrorCode
from mansion_msgs_py.scene import SceneRoom
from mansion_msgs_py.shapes import Point3
from mansion_msgs_py.wording import with_article

__all__ = [
    "MOST_CARRIERS",
    "find_assets",
    "find_surfaces",
    "furnish",
    "is_furniture",
    "make_room",
    "move_after_clearing",
    "place_any",
    "relation_of",
    "rooms_for",
    "satisfy",
]

Provisioning = Generator[Action, Outcome, None]
"""Raises `Unmet` where a fact cannot be made to hold."""


def satisfy(facts: list[Fact], state: SceneState) -> Policy:
    """Check facts in order and provision what is missing."""
    failed = []
    for fact in facts:
        try:
            yield from _satisfy(fact, state)
        except Unmet as reason:
            failed.append(f"{fact}: {reason}")
    words = [str(fact) for fact in facts]
    summary = f"{len(facts) - len(failed)} of {len(facts)} facts hold" + (f"; {'; '.join(failed)}" if failed else "")
    return Verdict(summary, words, failed)


def _satisfy(fact: Fact, state: SceneState) -> Provisioning:
    if isinstance(fact, PathFact):
        yield from _require_path(fact)
    else:
        yield from _provide(fact, state)


def _require_path(fact: PathFact) -> Provisioning:
    report: PathReport = yield from ask(f"Is there {fact}?", "CheckPath", {"start": fact.start, "end": fact.end})
    if not report.reachable:
        raise Unmet(report.message)


MOST_CARRIERS: Final = 6
MOST_ROOMS: Final = 12


def _provide(fact: ObjectFact, state: SceneState) -> Provisioning:
    if fact.where.receptacle:
        yield from _provide_on_receptacle(fact, state)
    else:
        yield from _provide_in_room(fact, state)


def _provide_on_receptacle(fact: ObjectFact, state: SceneState) -> Provisioning:
    carriers = yield from receptacles(fact.where, state)
    if not carriers:
        carriers = [(yield from _provide_carrier(fact, state))]
    counted: list[tuple[int, int, ObjectInfo]] = []
    for order, carrier in enumerate(carriers[:40]):
        there = yield from list_contents(carrier, relation_of(fact.where.relation, carrier, state))
        mine = [item for item in there if matches(fact.object, item, state)]
        if len(mine) >= fact.object.count:
            return
        counted.append((-len(mine), order, carrier))
    counted.sort(key=lambda entry: entry[:2])
    yield from _place_missing(fact, [(-n, c) for n, _, c in counted[:MOST_CARRIERS]], state)


def _place_missing(fact: ObjectFact, carriers: list[tuple[int, ObjectInfo]], state: SceneState) -> Provisioning:
    """Place what is missing on the first receptacle that takes it all."""
    assets = yield from find_assets(fact.object, state)
    reasons: list[str] = []
    for number, carrier in carriers:
        relation = relation_of(fact.where.relation, carrier, state)
        missing = fact.object.count - number
        added: list[str] = []
        for _ in range(missing):
            made, reason = yield from place_any(assets, carrier.id, relation, colour=fact.object.colour)
            if not made and len(carriers) == 1:
                made = yield from make_room(fact.object, assets, carrier, state)
            if not made:
                reasons.append(reason)
                break
            added.append(made)
        if len(added) == missing:
            return
        for object_id in reversed(added):
            yield Action("They do not all fit there.", "RemoveObject", {"object_id": object_id})
    if fact.object.count == 1 and len(carriers) > 1:
        for _, carrier in carriers:
            if (yield from make_room(fact.object, assets, carrier, state)):
                return
    raise Unmet("; ".join(dict.fromkeys(reasons)) or "no receptacle takes it")


def _provide_carrier(fact: ObjectFact, state: SceneState) -> Generator[Action, Outcome, ObjectInfo]:
    """Furnish a room of the scope with the receptacle that is missing."""
    where = fact.where
    if "/" in where.receptacle or "_" in where.receptacle:
        raise Unmet(f"there is no {where.receptacle}")
    made = yield from furnish(ObjectDescription(where.receptacle, 1, where.colour), where, state)
    listed: ObjectList = yield from ask("It is there now.", "ListObjects", {"id": made})
    return listed.objects[0]


def furnish(thing: ObjectDescription, where: Scope, state: SceneState) -> Generator[Action, Outcome, str]:
    """Put furniture into the room of a scope that suits it best, and return its id.

    A kind of it that belongs into a room of the scope (an office desk) goes before one that belongs into none.
    """
    assets = yield from find_assets(thing, state)
    standing = [a for a in assets if state.catalogue.asset(a.asset_id).mount == "floor"]
    reason = f"there is no {thing.noun} {Scope('room', '', where.rooms, where.floor)}"
    if not standing:
        raise Unmet(reason)
    first = standing[0]
    common = Counter(item.category for _, item in state.objects())
    kinds = sorted(vocabulary_of(state.catalogue).nouns(thing.noun), key=lambda name: -common[name])
    for category in dict.fromkeys([first.category, *kinds]):
        own = [a for a in state.catalogue.by_category(category) if a.mount == "floor"]
        if not own or not any(_in_room_program(state, room, category) for room in _rooms(where, state)):
            continue
        if category != first.category:
            standing = yield from find_assets(replace(thing, noun=category.replace("_", " ")), state)
        break
    first = standing[0]
    for room in rooms_for(where, state, first.category, first.size)[:MOST_ROOMS]:
        made, reason = yield from place_any(standing, room, "on", colour=thing.colour)
        if made:
            return made
    raise Unmet(reason)


def _rooms(where: Scope, state: SceneState) -> list[SceneRoom]:
    named = set(rooms_of(where, state))
    return [room for f in state.floors for room in state.scenes[f].rooms if room.id in named]


def _provide_in_room(fact: ObjectFact, state: SceneState) -> Provisioning:
    found = yield from find_objects(fact.object, fact.where, state)
    missing = fact.object.count - len(found)
    if missing <= 0:
        return
    assets = yield from find_assets(fact.object, state)
    if is_furniture(assets, state):
        for _ in range(missing):
            yield from furnish(fact.object, fact.where, state)
        return
    targets = yield from find_surfaces(fact.where, state, fact.object.noun)
    reason = f"no surface {fact.where} can carry it"
    for target in targets[: 2 * MOST_CARRIERS]:
        while missing:
            made, fault = yield from place_any(assets, target, "on", colour=fact.object.colour)
            if not made:
                reason = fault
                break
            missing -= 1
        if not missing:
            return
    raise Unmet(reason)


def is_furniture(assets: list[AssetInfo], state: SceneState) -> bool:
    first = state.catalogue.asset(assets[0].asset_id)
    return first.mount == "floor" and not (first.pickupable and max(first.size) < 0.6)


def _moved(item: ObjectInfo, target: str, thought: str) -> Generator[Action, Outcome, str]:
    """Move an object, and return why it cannot be moved there, empty when it was."""
    answer = yield Action(thought, "MoveObject", {"object_id": item.id, "receptacle_id": target})
    return "" if answer.error is None else answer.error.info.message


def move_after_clearing(
    item: ObjectInfo, target: str, reason: str, state: SceneState
) -> Generator[Action, Outcome, str]:
    """Move an object to a full surface after clearing a place on it; return why that fails, empty when it does not."""
    carriers = yield from _carrier(target)
    found = state.find(item.id)
    if not carriers or found is None:
        return reason
    freed = yield from _free_up(item.name, [found[1].size], carriers[0], state)
    if freed is None:
        return reason
    return (yield from _moved(item, target, f"{target} has room for {item.id} now."))


def _carrier(object_id: str) -> Generator[Action, Outcome, list[ObjectInfo]]:
    answer = yield Action(f"What is {object_id}?", "ListObjects", {"id": object_id})
    return [] if answer.error is not None else answer.value.objects


MOST_TARGETS: Final = 6


def make_room(
    thing: ObjectDescription, assets: list[AssetInfo], carrier: ObjectInfo, state: SceneState
) -> Generator[Action, Outcome, str]:
    """Clear a place on a full surface for a new object and return its id, empty when that fails."""
    serving = yield from _free_up(thing.noun, [asset.size for asset in assets], carrier, state)
    if serving is None:
        return ""
    fitting = [asset for asset in assets if asset.size == serving]
    made, _ = yield from place_any(fitting, carrier.id, relation_of("on", carrier, state), colour=thing.colour)
    return made


def _free_up(
    noun: str, sizes: list[Point3], carrier: ObjectInfo, state: SceneState
) -> Generator[Action, Outcome, Point3 | None]:
    """Move one object to another surface of the room, and return the size that fits in its place.

    What this instruction has touched stays, and only one thing makes room for an instruction.
    """
    touched = {change.id for change in state.pending}
    if any(change.before is not None and change.after is not None for change in state.pending):
        return None
    for item in (yield from list_contents(carrier, relation_of("on", carrier, state))):
        found = state.find(item.id)
        if found is None or item.id in touched or not found[1].pickupable:
            continue
        if state.subtree(*found)[1:] or vocabulary_of(state.catalogue).rank(found[1], noun) >= 2:
            continue
        size = next((size for size in sizes if _fits_without(size, carrier, item, state)), None)
        if size is None:
            continue
        targets = yield from find_surfaces(Scope("room", "", (item.room,)), state)
        for target in targets[:MOST_TARGETS]:
            if target == carrier.id:
                continue
            if not (yield from _moved(item, target, f"{item.id} makes room for the {noun}.")):
                return size
    return None


def _fits_without(size: Point3, carrier: ObjectInfo, item: ObjectInfo, state: SceneState) -> bool:
    found = state.find(carrier.id)
    kind = state.catalogue.assets.get(carrier.asset_id)
    if found is None or kind is None:
        return False
    ledges = ledges_of(kind, inside=False)
    return bool(free_places(state.index(found[0]), found[1], ledges, size, {item.id}))


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


ENOUGH: Final = 6
_EASY: Final = ("desk", "table", "counter", "shelf", "shelving_unit", "sideboard", "dresser", "nightstand", "bench")
"""Endings of categories that receive objects when an instruction names only a room."""


def find_surfaces(where: Scope, state: SceneState, noun: str = "") -> Generator[Action, Outcome, list[str]]:
    """Return receptacles of a scope with a surface: the usual ones of a noun first, then tables and the like."""
    found: list[tuple[int, str]] = []
    kinds = tuple(vocabulary_of(state.catalogue).nouns(noun)[:1]) if noun else ()
    usual = _usual_receptacles(state.catalogue, kinds)
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
def _usual_receptacles(catalogue: Catalogue, categories: tuple[str, ...]) -> frozenset[str]:
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


MOST_ASSETS: Final = 4


def find_assets(thing: ObjectDescription, state: SceneState) -> Generator[Action, Outcome, list[AssetInfo]]:
    """Return the assets that fit a description: the best first, then small ones; only those of its colour if any."""
    words = " ".join(word for word in (thing.colour, thing.noun) if word)
    question = f"Which asset is {with_article(words)}?"
    hits: AssetHits = yield from ask(question, "SearchAssets", {"query": words, "top_k": 50})
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
        raise Unmet(f"the catalogue has no {words}")
    exact = vocabulary_of(state.catalogue).exact(stems(thing.noun))
    mine = [a for a in mine if a.category in exact] or mine
    first = mine[0].category
    alike = [a for a in mine if a.category == first]
    if thing.colour:
        alike = [a for a in alike if colour_of(a.material) == thing.colour] or alike
    small = sorted(alike[1:], key=lambda a: a.size[0] * a.size[1] * a.size[2])
    others = [a for a in mine if a.category != first]
    return [alike[0], *small[:2], *others]


def place_any(
    assets: list[AssetInfo],
    carrier: str,
    relation: str,
    *,
    colour: str = "",
    near: str = "",
    name: str = "",
    wishes: Mapping[str, Any] | None = None,
) -> Generator[Action, Outcome, tuple[str, str]]:
    """Try variants of an asset on one receptacle; return the new object's id, or an empty id and the reason.

    Parameters
    ----------
    near : str
        Id of an object to put it beside.
    name : str
        What to call it; what the asset is called when empty.
    wishes : mapping, optional
        Further arguments of PlaceOnSurface.
    """
    reason = ""
    for asset in assets[:MOST_ASSETS]:
        arguments: dict[str, Any] = {"asset_id": asset.asset_id}
        if colour and colour_of(asset.material) != colour:
            arguments["color"] = colour
        if name and name != asset.name:
            arguments["name"] = name
        if relation == "in":
            tool, arguments["container_id"] = "PlaceInContainer", carrier
        else:
            tool, arguments["receptacle_id"] = "PlaceOnSurface", carrier
            if near:
                arguments["near"] = near
            arguments.update(wishes or {})
        answer = yield Action(f"{asset.asset_id} is missing {relation} {carrier}.", tool, arguments)
        if answer.error is None:
            return answer.value.object_ids[0], ""
        reason = reason or answer.error.info.message
        if answer.error.code != ErrorCode.INFEASIBLE:
            break
    return "", reason
