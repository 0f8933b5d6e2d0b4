"""Work the furniture that a brief asks for into a room's program."""

import math
from collections.abc import Collection, Iterable, Sequence
from typing import TypeVar

import msgspec

from mansion_assets.catalogue.asset import Asset
from mansion_assets.catalogue.catalogue import Catalogue, RoomProgramCard
from mansion_assets.catalogue.piece_counts import pair_of_seats, pieces
from mansion_assets.catalogue.quantities import sits_around
from mansion_assets.catalogue.records import Arrangement, Count, HangItem, Item, RugItem, Scatter, Slot
from mansion_knowledge.object_kinds import added_for, answers, idle_without, noun_of, of_one_kind, substitutes
from mansion_msgs_py.placement import Relation
from mansion_msgs_py.program import RequestedObject

__all__ = ["AskedProgram", "asked_counts", "is_a", "is_rug", "laid_categories", "with_requested", "without_small"]

_ALWAYS = 1e9
_LOW, _HIGH = 0.3, 1.35
"""Between which heights a surface is one to put things on, metres."""


class AskedProgram(msgspec.Struct, frozen=True, kw_only=True):
    """The program of a room that the brief asks furniture for.

    Attributes
    ----------
    least : dict of str to int
        Floor item to the copies that it must have, whatever the room's share of floor.
    first : frozenset of str
        Floor items that come before the others: those asked for, and what they stand at.
    most : dict of str to int
        Floor item to the copies that it may have, where no more are wanted.
    """

    card: RoomProgramCard
    least: dict[str, int] = {}
    first: frozenset[str] = frozenset()
    most: dict[str, int] = {}


def laid_categories(arrangement: Arrangement) -> list[str]:
    """Return the categories of the things that an arrangement lays or scatters, those before chairs not among them."""
    slots = [name for slot in arrangement.slots for name in _names(slot.category)]
    return slots + [name for scatter in arrangement.scatter for name in _names(scatter.category)]


def asked_counts(requested: Iterable[RequestedObject]) -> dict[str, int]:
    """Return the number of pieces asked for by category, the greatest where one is asked for twice; 0 for unwanted."""
    out: dict[str, int] = {}
    for request in requested:
        out[request.category] = max(out.get(request.category, 0), request.count)
    return out


def is_rug(asset: Asset) -> bool:
    """Tell whether an asset lies flat on the floor and is laid with the rugs."""
    return asset.recipe == "rug"


def carries(asset: Asset, thing: Asset) -> bool:
    """Tell whether a floor object has a surface at a fitting height and large enough to put a thing on."""
    half = asset.size[2] / 2
    w, d, h = thing.size
    return asset.mount == "floor" and any(
        surface.kind in ("top", "shelf")
        and _LOW <= surface.z + half <= _HIGH
        and surface.clearance > h + 0.01
        and max(w, d) + 0.02 <= max(surface.w, surface.d)
        and min(w, d) + 0.02 <= min(surface.w, surface.d)
        for surface in asset.surfaces
    )


def with_requested(
    catalogue: Catalogue, card: RoomProgramCard, counts: dict[str, int], area: float, exact: Collection[str] = ()
) -> AskedProgram:
    """Return a room's program in which requested objects come first and are certain, and unwanted ones are removed.

    Parameters
    ----------
    counts : dict of str to int
        Pieces by category (see `asked_counts`).
    exact : collection of str
        Categories of which no more are wanted: the usual number gives way, and so does other furniture of the
        same noun.

    Notes
    -----
    A category is met where the room type already has it: by that item of the program, or by one that answers for it
    (see `kinds`). Otherwise the room gets an item like the one that other room types have. Furniture on walls,
    ceilings and rugs is made certain in the program; small things lie on what the room has, or on a table added here.
    """
    unwanted = [category for category, count in counts.items() if not count]
    idle = [name for category in unwanted for name in idle_without(category) if not counts.get(name)]
    draft = _Program(catalogue, without_categories(card, [*unwanted, *idle]), area, exact)
    wanted = [(category, count) for category, count in counts.items() if count and catalogue.by_category(category)]
    for category, count in sorted(wanted, key=lambda pair: (answers("chair", pair[0]), pair[0] != "chair")):
        draft.ask(category, count)
    return draft.finished()


def _names(category: str | list[str]) -> list[str]:
    return [category] if isinstance(category, str) else category


def _only(category: str | list[str], requested: str) -> list[str]:
    """Return the categories of an item that a request means: itself where it is among them, else its stand-ins."""
    names = _names(category)
    return [requested] if requested in names else [name for name in names if answers(requested, name)]


def _same_noun(category: str, requested: str) -> bool:
    """Tell whether a category is of the same kind as another and called by its noun: a lounge chair for a chair.

    A wall shelf unit is a shelf as a bookshelf is one, and a café table a table as a round table is one.
    """
    noun = requested.rpartition("_")[2]
    named = any(word == noun or (len(word) > _SHORT and noun.endswith(word)) for word in category.split("_"))
    return (named or noun_of(category) == noun) and of_one_kind(requested, category)


_SHORT = 4
"""Letters of the longest word that may end another by chance."""


_Listed = TypeVar("_Listed", Item, HangItem, RugItem, Slot, Scatter)


def without_categories(card: RoomProgramCard, unwanted: Collection[str]) -> RoomProgramCard:
    """Return a program without what is, or answers for, an unwanted category."""
    if not unwanted:
        return card
    return msgspec.structs.replace(
        card,
        floor=_without(card.floor, unwanted),
        wall=_without(card.wall, unwanted),
        ceiling=_without(card.ceiling, unwanted),
        rugs=_without(card.rugs, unwanted),
    )


def without_small(arrangements: Iterable[Arrangement], unwanted: Collection[str]) -> list[Arrangement]:
    """Return arrangements of small objects without what is, or answers for, an unwanted category."""
    if not unwanted:
        return list(arrangements)
    return [
        msgspec.structs.replace(
            arrangement,
            slots=list(_without(arrangement.slots, unwanted)),
            seats=list(_without(arrangement.seats, unwanted)),
            scatter=list(_without(arrangement.scatter, unwanted)),
        )
        for arrangement in arrangements
    ]


def is_a(category: str, unwanted: str) -> bool:
    """Tell whether a category is what nobody wants: it answers for it, or has its name ("high_chair", "chair")."""
    return answers(unwanted, category) or category.endswith(f"_{unwanted}")


def _without(items: Iterable[_Listed], unwanted: Collection[str]) -> tuple[_Listed, ...]:
    out = []
    for item in items:
        names = [name for name in _names(item.category) if not any(is_a(name, kind) for kind in unwanted)]
        if names:
            out.append(msgspec.structs.replace(item, category=names))
    return tuple(out)


class _Program:
    """A room's program while requests are worked in."""

    def __init__(self, catalogue: Catalogue, card: RoomProgramCard, area: float, exact: Collection[str]) -> None:
        self._catalogue, self._card, self._area, self._exact = catalogue, card, area, exact
        self._floor = {item.name: item for item in card.floor}
        self._wall, self._ceiling, self._rugs = list(card.wall), list(card.ceiling), list(card.rugs)
        self._least: dict[str, int] = {}
        self._most: dict[str, int] = {}
        self._first: dict[str, None] = {}

    def ask(self, category: str, count: int) -> None:
        """Make the room have `count` pieces of a category."""
        for names in ([category], substitutes(category)):
            item = self._usual_item(names)
            if item is not None:
                self._raise(item, category, count)
                return
            if self._hang(names, category, count):
                return
            small = self._laid(names)
            if small:
                self._support(small)
                return
        self._add(added_for(category), category, count)

    def finished(self) -> AskedProgram:
        early = set(self._first)
        for _ in self._floor:
            early |= {name for item in early for name in _before(self._floor[item])} & self._floor.keys()
        first = [item for name, item in self._floor.items() if name in early]
        rest = [item for name, item in self._floor.items() if name not in early]
        rest = [item for item in (self._without_surplus(item) for item in rest) if item is not None]
        card = msgspec.structs.replace(
            self._card,
            floor=(*_hosts_first(first), *rest),
            wall=tuple(self._wall),
            ceiling=tuple(self._ceiling),
            rugs=tuple(self._rugs),
        )
        return AskedProgram(card=card, least=self._least, first=frozenset(self._first), most=self._most)

    def _without_surplus(self, item: Item) -> Item | None:
        """Return an item that was not requested without what would add to the objects requested in an exact number."""
        names = [name for name in _names(item.category) if not any(_same_noun(name, kind) for kind in self._exact)]
        return msgspec.structs.replace(item, category=names) if names else None

    def _usual_item(self, names: Sequence[str]) -> Item | None:
        """Return the floor item of the program that has most copies of one of these categories."""
        found = [item for item in self._floor.values() if not set(names).isdisjoint(_names(item.category))]
        return max(found, key=self._usual, default=None)

    def _usual(self, item: Item) -> float:
        """Return about how many copies the room has of an item."""
        if not item.min_area <= self._area <= item.max_area:
            return 0.0
        if item.paired:
            host = self._floor.get(item.paired)
            return 0.0 if host is None or host is item else self._usual(host)
        count = item.count
        if isinstance(count, int):
            return float(count)
        if count.each:
            host = self._floor.get(count.each)
            number = 0.0 if host is None or host is item else count.times * self._usual(host)
        else:
            number = (count.min + count.max) / 2 if count.per is None else self._area / count.per
        return min(count.max, max(count.min, number))

    def _raise(self, item: Item, category: str, count: int) -> None:
        """Make the program's item certain, in the categories that are asked for, with enough copies."""
        names = _only(item.category, category)
        assets = self._catalogue.choose_from(names, item.extent)
        extent = item.extent if assets else None
        most = max(
            (pieces(category, pair_of_seats(a)) for a in assets or self._catalogue.choose_from(names)), default=1
        )
        copies = math.ceil(count / max(most, 1))
        self._least[item.name] = max(copies, self._least.get(item.name, 0))
        self._floor[item.name] = _certain(msgspec.structs.replace(item, category=names, extent=extent))
        self._first[item.name] = None
        exact = category in self._exact
        self._seat(item.name, exact=exact)
        if exact:
            self._most[item.name] = self._least[item.name]
        if exact and not item.paired and self._host(item) is None:
            self._floor[item.name] = msgspec.structs.replace(self._floor[item.name], count=self._least[item.name])

    def _seat(self, name: str, *, exact: bool) -> None:
        """Make what an item stands at certain, with as many copies as it needs where the room's area sets them."""
        item = self._floor[name]
        at = self._host(item)
        if at is None or at.name == name:
            return
        copies = self._least[name]
        ratio = 1.0 if item.paired else max(1.0, self._usual(item) / max(self._usual(at), 1.0))
        if at.name not in self._least and isinstance(at.count, Count) and not at.count.each:
            self._least[at.name] = math.ceil(copies / ratio)
            if exact:
                self._most[at.name] = self._least[at.name]
        self._floor[at.name] = _certain(at)
        self._first[at.name] = None
        if at.name in self._least:
            ratio = max(ratio, copies / self._least[at.name])
            if not item.paired:
                count = Count(each=at.name, times=ratio, max=9999)
                self._floor[name] = msgspec.structs.replace(item, count=count)
            self._seat(at.name, exact=exact)
        elif not item.paired:
            usual = item.count
            count = Count(min=copies, max=copies) if isinstance(usual, int) else _raised(usual, copies)
            self._floor[name] = msgspec.structs.replace(item, count=count)

    def _host(self, item: Item) -> Item | None:
        """Return what the copies of an item are paired with or stand around."""
        if item.paired:
            return self._floor.get(item.paired)
        return next((other for other in self._floor.values() if sits_around(item, other.name)), None)

    def _hang(self, names: Sequence[str], category: str, count: int) -> bool:
        """Make the wall object, ceiling object or rug that answers certain; tell whether the program has one."""
        for hung in (self._wall, self._ceiling):
            for at, item in enumerate(hung):
                if not set(names).isdisjoint(_names(item.category)):
                    hung[at] = msgspec.structs.replace(
                        item,
                        category=_only(item.category, category),
                        p=1.0,
                        min_area=0.0,
                        count=_at_least(item.count, count),
                    )
                    return True
        for at, rug in enumerate(self._rugs):
            if not set(names).isdisjoint(_names(rug.category)):
                only = _only(rug.category, category)
                self._rugs[at] = msgspec.structs.replace(rug, category=only, p=1.0, count=max(rug.count, count))
                return True
        return False

    def _laid(self, names: Sequence[str]) -> str:
        """Return the category of `names` that usually lies on furniture that every such room has; empty for none."""
        floor = [i for i in self._floor.values() if i.p >= 1.0 and i.min_area <= self._area]
        certain = {name for item in floor for name in _names(item.category)}
        near = [a for a in self._catalogue.arrangements.values() if not certain.isdisjoint(a.on)]
        return next((name for name in names if any(name in laid_categories(a) for a in near)), "")

    def _add(self, added: str, category: str, count: int) -> None:
        """Give the room what its type does not have."""
        asset = self._catalogue.by_category(added)[0] if self._catalogue.by_category(added) else None
        if asset is None:
            return
        if is_rug(asset):
            self._rugs.insert(0, RugItem(category=added, count=count))
        elif asset.mount == "wall":
            self._wall.insert(0, HangItem(category=added, count=count))
        elif asset.mount == "ceiling":
            self._ceiling.insert(0, HangItem(category=added, count=count, place="spread"))
        elif asset.mount == "floor":
            item = self._new_item(added)
            self._floor[item.name] = item
            self._raise(item, category, count)
        else:
            self._support(added)

    def _new_item(self, category: str) -> Item:
        """Return an item for a category as other room types have it, at a table of this room where it is a seat."""
        model = _model_item(self._catalogue, category)
        name = category if category not in self._floor else f"asked_{category}"
        relative = [relation for relation in model.relative if relation.target in self._floor]
        paired = model.paired if model.paired in self._floor else ""
        if answers("chair", category) and not paired and not relative:
            paired, relative = self._place_at_table()
        return msgspec.structs.replace(_certain(model), name=name, count=1, paired=paired, relative=relative)

    def _place_at_table(self) -> tuple[str, list[Relation]]:
        """Return how a seat stands at a desk or table of the room that has no seats of its own."""
        free = [
            item
            for item in self._floor.values()
            if not any(o.paired == item.name or sits_around(o, item.name) for o in self._floor.values())
        ]
        free.sort(key=lambda item: item.name not in self._first)
        for item in free:
            if any(answers("desk", name) for name in _names(item.category)):
                return item.name, []
            if any(answers("dining_table", name) for name in _names(item.category)):
                return "", [Relation(kind="around", target=item.name)]
        return "", []

    def _support(self, category: str) -> None:
        """See that the room has furniture to put a small thing on."""
        thing = min(self._catalogue.by_category(category), key=lambda asset: asset.footprint)
        for item in self._floor.values():
            if item.p >= 1.0 and item.min_area <= self._area and self._all_carry(_names(item.category), thing):
                return
        on = [n for a in self._catalogue.arrangements.values() if category in laid_categories(a) for n in a.on]
        name = next(
            (n for n in (*on, "side_table", "console_table", "dining_table") if self._all_carry([n], thing)), ""
        )
        if not name:
            return
        present = self._usual_item([name])
        if present is None:
            present = self._new_item(name)
        self._floor[present.name] = present
        self._raise(present, name, 1)

    def _all_carry(self, categories: Sequence[str], thing: Asset) -> bool:
        assets = self._catalogue.choose_from(list(categories))
        return bool(assets) and all(carries(asset, thing) for asset in assets)


def _certain(item: Item) -> Item:
    return msgspec.structs.replace(item, p=1.0, min_area=0.0, max_area=_ALWAYS)


def _raised(count: Count, least: int) -> Count:
    return msgspec.structs.replace(count, min=max(count.min, least), max=max(count.max, least))


def _at_least(count: int | Count, least: int) -> int | Count:
    return max(count, least) if isinstance(count, int) else _raised(count, least)


def _hosts_first(items: Sequence[Item]) -> list[Item]:
    """Order items so that each comes after what it is paired with, stands around or is counted by."""
    left, out = list(items), list[Item]()
    while left:
        names = {item.name for item in left}
        ready = [item for item in left if names.isdisjoint(_needs(item) - {item.name})] or left[:1]
        out += ready
        left = [item for item in left if item not in ready]
    return out


def _needs(item: Item) -> set[str]:
    return {item.paired, _counted_by(item), *(relation.target for relation in item.relative)} - {""}


def _before(item: Item) -> set[str]:
    """Return the items without which this one has no number or no place."""
    tied = {relation.target for relation in item.relative if relation.kind in ("around", "in_front_of")}
    return {_counted_by(item), *tied}


def _counted_by(item: Item) -> str:
    """Return the item whose copies decide how many this one has; empty where none does."""
    return "" if isinstance(item.count, int) else item.count.each


def _model_item(catalogue: Catalogue, category: str) -> Item:
    """Return the item of the room type that has a category with the fewest ties; a plain one where none has it."""
    found = [
        item
        for room_type in catalogue.room_types
        for item in catalogue.room_program(room_type).floor
        if category in _names(item.category)
    ]
    if not found:
        return Item(name=category, category=category)
    best = min(found, key=lambda item: (bool(item.paired) + len(item.relative), item.matrix is None))
    return msgspec.structs.replace(best, category=category)
