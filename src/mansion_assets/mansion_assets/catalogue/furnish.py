"""The furnishing of a room by its type and area: which objects, how many, with what constraints."""

import itertools
import math
from collections.abc import Collection, Sequence

import msgspec
import numpy as np

from mansion_assets.catalogue.asset import Asset
from mansion_assets.catalogue.catalogue import Catalogue, RoomProgramCard
from mansion_assets.catalogue.piece_counts import pair_of_seats
from mansion_assets.catalogue.quantities import (
    copies,
    grid,
    room_extent,
    seating_tables,
    seats_around,
    sits_around,
    wanted_seats,
)
from mansion_assets.catalogue.records import Arrangement, HangItem, Item, MatrixShape
from mansion_assets.catalogue.requested_furniture import AskedProgram, asked_counts, with_requested, without_small
from mansion_geometry.randomness import item_generator
from mansion_knowledge.object_kinds import answers
from mansion_knowledge.object_qualities import has_quality
from mansion_msgs_py.placement import (
    GlobalConstraint,
    MatrixStructure,
    PairedStructure,
    PlacementObject,
    Relation,
    SingleStructure,
    Structure,
)
from mansion_msgs_py.program import RequestedObject
from mansion_msgs_py.shapes import Size3

__all__ = ["HangRequest", "RoomFurnishing", "RugRequest", "furnish_request"]


class HangRequest(msgspec.Struct, frozen=True, kw_only=True):
    """A wall or ceiling asset, `count` times (see `HangItem` for the fields)."""

    asset: Asset
    count: int
    place: str = "free"
    height: float | None = None
    above: str = ""
    spacing: float = 3.0


class RugRequest(msgspec.Struct, frozen=True, kw_only=True):
    """A rug below the floor object named (or of the category) `under`; the first asset that fits.

    Attributes
    ----------
    free : bool
        Whether a rug below nothing takes only floor on which nothing stands.
    """

    assets: tuple[Asset, ...]
    under: str = ""
    margin: float = 0.4
    count: int = 1
    free: bool = True


class RoomFurnishing(msgspec.Struct, frozen=True, kw_only=True):
    """The objects that a room should get.

    Attributes
    ----------
    floor : list of PlacementObject
        Objects for the placer.
    floor_assets : dict
        The asset of each entry of `floor`, by its name.
    alternatives : dict
        Assets behind ``smaller``, in the same order.
    small : list of Arrangement
        Arrangements of small objects; the first that fits a receptacle is used.
    asked : frozenset of str
        Entries of `floor` that the brief asks for, with what they stand at.
    """

    room_id: str
    room_type: str
    program: str
    floor: list[PlacementObject]
    floor_assets: dict[str, Asset]
    alternatives: dict[str, list[Asset]]
    wall: list[HangRequest]
    ceiling: list[HangRequest]
    rugs: list[RugRequest]
    small: list[Arrangement]
    asked: frozenset[str] = frozenset()

    def asset_for(self, name: str, size: Size3) -> Asset:
        """Return the asset of a placed object: the first choice, or the smaller one of that size."""
        first = self.floor_assets[name]
        choices = [first, *self.alternatives.get(name, [])]
        return min(choices, key=lambda a: sum(abs(p - q) for p, q in zip(a.size, size, strict=True)))


_LOYALTY = 0.7
"""Probability that a room takes the building's own variant of a category."""

_MANY = 6
"""Number of requested copies from which they stand in rows and columns."""

_FIELD = 10
"""Number of copies from which what stands at walls stands in rows and columns, unless it is shallow or a bed."""

_SHALLOW = 0.7
"""Depth of what lines walls in any number, metres."""

_AISLES = (0.6, 0.9)
"""Distance between the columns and rows of objects that are requested in such numbers, metres."""

_NEARLY = 0.8
"""Share of what is asked for that stands in comfortable rows, the rest beside them, before all stand close together."""

_LOOSE = MatrixShape(max_rows=99, max_cols=99, gap=(0.05, 0.6))

_WALLED = 0.55
"""Share of the walls' length that copies asked for may line."""

_CROWDED = 0.8
"""Share of the floor that objects asked for cover at the very most."""

_ROW_END, _ROWS_COVER = 1.8, 0.4
"""Free floor at either end of rows that are asked for, metres, and the share of the floor that they cover at most."""

_ASKED_SHARE = 0.3
"""Share of the floor up to which the assets of requested objects are chosen freely."""


def furnish_request(
    catalogue: Catalogue,
    room_type: str,
    area: float,
    *,
    seed: int,
    style: str = "",
    room_id: str = "",
    extent: tuple[float, float] | None = None,
    items: Sequence[Item] | None = None,
    requested: Sequence[RequestedObject] = (),
    compact: bool = False,
    beside: Collection[str] = (),
) -> RoomFurnishing:
    """Return the objects that a room should get.

    Parameters
    ----------
    area : float
        Net area of the room, square metres.
    seed : int
        Seed of the building; with `room_id` it determines the result.
    style : str
        Style of the building; rooms of one style and seed prefer the same variants.
    extent : (float, float), optional
        Sides of the room's bounding rectangle, metres; matrices and long objects then fit it.
    items : sequence of Item, optional
        Floor objects that replace the room type's own list.
    requested : sequence of RequestedObject
        What the brief asks for; it comes before the rest, whatever the share of the floor.
    compact : bool
        Whether the smallest assets are taken for it.
    beside : collection of str
        Types of the other rooms of the floor, which hold some things instead of this one.

    Notes
    -----
    Items are taken in the order of the program until floor objects cover its share of the room (`cover`), less in rooms
    below 12 m2; what does not fit the share gets fewer copies, or a smaller asset, or is left out.
    """
    counts = asked_counts(requested)
    card = _usual_program(catalogue, room_type, items, beside)
    rng = item_generator(seed, "furnish", room_id, card.room_type)
    exact = {wanted.category for wanted in requested if wanted.exact}
    asked = with_requested(catalogue, card, counts, area, exact) if counts else AskedProgram(card=card)
    card = asked.card
    draft = _Draft(catalogue, asked, area, extent, rng, _Style(seed, style), compact=compact)
    draft.rows = {r.category: r.rows for r in requested if r.rows}
    draft.wanted_looks = {r.category: r.words.split() for r in requested if r.words}
    for item in card.floor:
        draft.add(item)
    floor, assets, alternatives = draft.finished()
    return RoomFurnishing(
        room_id=room_id,
        room_type=room_type,
        program=card.room_type,
        floor=floor,
        floor_assets=assets,
        alternatives=alternatives,
        wall=[w for item in card.wall if (w := _hang(draft, item)) is not None],
        ceiling=[w for item in card.ceiling if (w := _hang(draft, item)) is not None],
        rugs=_rugs(draft),
        small=without_small(_arrangements(catalogue, card), [c for c, count in counts.items() if not count]),
        asked=draft.first,
    )


def _usual_program(
    catalogue: Catalogue, room_type: str, items: Sequence[Item] | None, beside: Collection[str]
) -> RoomProgramCard:
    """Return what a room of a type gets unasked, without what rooms beside it hold instead."""
    card = catalogue.room_program(room_type)
    if items is not None:
        card = msgspec.structs.replace(card, floor=tuple(items))
    if beside:
        kept = tuple(item for item in card.floor if not _had_elsewhere(item, beside))
        card = msgspec.structs.replace(card, floor=kept)
    return card


def _had_elsewhere(item: Item, beside: Collection[str]) -> bool:
    """Whether another room of the floor has an item in the room's stead."""
    stead = [item.unless] if isinstance(item.unless, str) else item.unless
    return any(name in beside for name in stead)


def _is_whole(shape: MatrixShape | None, wanted: int) -> bool:
    """Whether `wanted` copies are a matrix whose rows and columns are given."""
    return shape is not None and shape.exact and wanted == shape.max_rows * shape.max_cols


class _Style:
    def __init__(self, seed: int, name: str) -> None:
        self.seed, self.name = seed, name

    def pick(self, assets: list[Asset], rng: np.random.Generator) -> Asset:
        """Return one of `assets`; the building's own choice more often than not."""
        draws = rng.random(2)
        if draws[0] < _LOYALTY:
            generator = item_generator(self.seed, "style", self.name, assets[0].category, len(assets))
            return assets[int(generator.integers(len(assets)))]
        return assets[int(draws[1] * len(assets))]


class _Entry(msgspec.Struct, frozen=True):
    item: Item
    asset: Asset
    count: int
    structure: Structure
    smaller: list[Asset]


class _Draft:
    """The floor objects of a room, added until its share of floor is covered."""

    def __init__(
        self,
        catalogue: Catalogue,
        asked: AskedProgram,
        area: float,
        extent: tuple[float, float] | None,
        rng: np.random.Generator,
        style: _Style,
        *,
        compact: bool = False,
    ) -> None:
        card = asked.card
        self.catalogue, self.card, self.area, self.rng, self.style = (catalogue, card, area, rng, style)
        self.asked, self.compact = asked, compact
        self.rests: dict[str, list[str]] = {}
        self.wanted_looks: dict[str, list[str]] = {}
        self.rows: dict[str, int] = {}
        self.extent = room_extent(area, extent)
        self.left = area * card.cover * min(1.0, 0.7 + 0.3 * area / 12.0)
        self.entries: dict[str, _Entry] = {}

    @property
    def numbers(self) -> dict[str, int]:
        return {name: entry.count for name, entry in self.entries.items()}

    @property
    def first(self) -> frozenset[str]:
        """Names of the objects that come before the usual furniture."""
        names = {name for name in self.entries if name in self.asked.first}
        return frozenset(names.union(*(self.rests.get(name, []) for name in names)))

    def category_of(self, name: str) -> str:
        """Return the category that an item of the room got; `name` itself where no item is called so."""
        return self.entries[name].asset.category if name in self.entries else name

    def add(self, item: Item) -> None:
        """Take an item of the program as far as the share of floor allows."""
        least = self.asked.least.get(item.name, 0)
        wanted = max(copies(item.count, self.area, self.numbers, self.rng), least)
        wanted = min(wanted, self.asked.most.get(item.name, wanted))
        present = self.rng.random() < item.p and item.min_area <= self.area <= item.max_area
        asset = self._asset(item, wanted)
        if asset is None or not present or wanted < 1 or item.name in self.entries or self._stray(item):
            return
        wanted = min(wanted, self._places(item, asset))
        structure: Structure = SingleStructure()
        if item.paired:
            if item.paired not in self.entries:
                return
            wanted = self.entries[item.paired].count
            structure = PairedStructure(with_=item.paired)
        elif asset.footprint > 0.0:
            wanted = max(wanted, self._in_rows(asset))
            usual = min(wanted, max(1, int((self.left - self._reserved(item)) / self._share(item, asset))))
            usual = usual if asset.footprint <= max(self.left, 0.0) else 0
            if _is_whole(item.matrix, wanted):
                usual = min(wanted, self._possible(asset))
            least = max(least, self._in_rows(asset))
            wanted = max(usual, min(wanted, least, self._possible(asset)))
            shape = self._shape(item, asset, wanted)
            if shape is not None:
                rows, cols = self._grid(item, asset, wanted, shape)
                wanted = rows * cols
                structure = MatrixStructure(rows=rows, cols=cols) if wanted > 1 else structure
        if wanted < 1:
            return
        self.left -= wanted * asset.footprint
        smaller = [] if item.paired else self._smaller(item, asset)
        self.entries[item.name] = _Entry(item, asset, wanted, structure, smaller)
        if least or item.name in self.asked.first:
            self._add_rests(item, least)

    def _rows_told(self, asset: Asset) -> int:
        """Return in how many rows the brief wants an asset to stand; 0 where it says nothing of rows."""
        return next((rows for category, rows in self.rows.items() if answers(category, asset.category)), 0)

    def _in_rows(self, asset: Asset) -> int:
        """Return how many copies stand in the rows that the brief tells, as long as the room allows."""
        rows = self._rows_told(asset)
        along = max(1, int((self.extent[0] - 2 * _ROW_END) / asset.size[0])) if rows else 0
        return min(rows * along, int(_ROWS_COVER * self.area / asset.footprint) // rows * rows) if rows else 0

    def _possible(self, asset: Asset) -> int:
        """Return how many copies the whole floor of the room has space for."""
        return max(1, int(_CROWDED * self.area / max(asset.footprint, 0.01)))

    def _shape(self, item: Item, asset: Asset, wanted: int) -> MatrixShape | None:
        """Return how the copies of an item spread in rows and columns; None where they do not."""
        if item.name not in self.asked.least or _is_whole(item.matrix, wanted):
            return item.matrix
        if wanted < _MANY and not self._room_for_rows(item, asset, wanted):
            return None
        tied = item.paired or any(relation.kind == "around" for relation in item.relative)
        along = 2 * sum(self.extent) * _WALLED
        bed = any(surface.kind == "mattress" for surface in asset.surfaces)
        few = wanted < _FIELD or bed or asset.size[1] <= _SHALLOW
        walled = item.global_ == "edge" and few and wanted * (asset.size[0] + 0.1) <= along
        if tied or (item.matrix is None and (wanted < _MANY or walled)):
            return None
        return MatrixShape(max_rows=99, max_cols=99, gap=item.matrix.gap if item.matrix else _AISLES)

    def _room_for_rows(self, item: Item, asset: Asset, wanted: int) -> bool:
        """Tell whether one copy at least has space between the aisles of rows and columns."""
        return item.matrix is None or math.prod(self._grid(item, asset, wanted, item.matrix)) > 0

    def _add_rests(self, item: Item, least: int) -> None:
        """Add the copies asked for that are not of the item's matrix, or have no place at its tables."""
        entry = self.entries[item.name]
        hosts = [(name, e) for name, e in self.entries.items() if name == item.paired or sits_around(item, name)]
        placed = entry.count
        for host, at in hosts:
            for rest in self.rests.get(host, []):
                share = math.ceil(entry.count * self.entries[rest].count / max(at.count, 1))
                placed += self._rest(entry, share, host=rest)
        missing = min(least, self._possible(entry.asset)) - placed
        while missing > 0:
            missing -= self._rest(entry, missing)

    def _rest(self, entry: _Entry, count: int, host: str = "") -> int:
        """Add up to `count` further copies of an entry, at `host` or on their own; return how many."""
        item, asset = entry.item, entry.asset
        structure: Structure = SingleStructure()
        relative = [Relation(kind="around", target=host)] if host and not item.paired else []
        if host and item.paired:
            structure = PairedStructure(with_=host)
        elif not host and count >= _MANY:
            rows, cols = grid(count, (asset.size[0], asset.size[1]), _LOOSE, self.extent)
            if rows * cols > 1:
                count, structure = rows * cols, MatrixStructure(rows=rows, cols=cols)
        taken = self.rests.setdefault(item.name, [])
        name = f"more_{item.name}" if not taken else f"more_{item.name}_{len(taken) + 1}"
        taken.append(name)
        place: GlobalConstraint = "edge" if item.global_ == "edge" and count < _MANY else "unconstrained"
        rest = Item(name=name, category=asset.category, global_=place, relative=relative)
        self.left -= count * asset.footprint
        self.entries[name] = _Entry(rest, asset, count, structure, [] if host else self._smaller(rest, asset))
        return count

    def _stray(self, item: Item) -> bool:
        """Tell whether copies would stand at something that what the brief asks for leaves no floor for."""
        tied = [relation.target for relation in item.relative if relation.kind in ("around", "in_front_of")]
        return bool(self.asked.least and tied) and not any(target in self.entries for target in tied)

    def _places(self, item: Item, seat: Asset) -> int:
        """Return how many copies fit around the tables that they belong to."""
        tables = [e for name, e in self.entries.items() if sits_around(item, name)]
        if not tables:
            return 999
        return sum(entry.count * seats_around(entry.asset, seat) for entry in tables)

    def _for_seats(self, item: Item, assets: list[Asset], wanted: int) -> list[Asset]:
        """Return the tables that take as many seats as the program asks for around each."""
        for other in self.card.floor:
            if not sits_around(other, item.name) or not (other.min_area <= self.area <= other.max_area):
                continue
            seats = self.catalogue.choose_from(other.category, other.extent)
            if seats:
                largest = max(seats, key=lambda a: (a.size[0], a.key))
                number = wanted_seats(other, self.area, wanted)
                return seating_tables(assets, largest, number, self.extent)
        return assets

    def _share(self, item: Item, asset: Asset) -> float:
        """Return the floor that one copy takes, with the accessories that are paired with it or follow it."""
        total = asset.footprint
        for other in self.card.floor:
            follows = not isinstance(other.count, int) and other.count.each == item.name
            if (other.paired == item.name or follows) and other.min_area <= self.area:
                sizes = [a.footprint for a in self.catalogue.choose_from(other.category, other.extent)]
                times = 1.0 if isinstance(other.count, int) or not follows else other.count.times
                total += times * other.p * (min(sizes) if sizes else 0.0)
        return total

    def _reserved(self, item: Item) -> float:
        """Return the floor reserved for the smallest assets of the later items that every such room has."""
        later = self.card.floor[self.card.floor.index(item) + 1 :]
        total = 0.0
        for other in later:
            certain = other.p >= 1.0 and other.min_area <= self.area <= other.max_area
            if certain and not other.paired and isinstance(other.count, int):
                sizes = [a.footprint for a in self.catalogue.choose_from(other.category, other.extent)]
                total += other.count * (min(sizes) if sizes else 0.0)
        return total

    def _grid(self, item: Item, asset: Asset, wanted: int, shape: MatrixShape) -> tuple[int, int]:
        if _is_whole(shape, wanted):
            return shape.max_rows, shape.max_cols
        rows = self._rows_told(asset)
        if rows and wanted >= rows:
            return rows, wanted // rows
        depth = asset.size[1]
        for other in self.card.floor:
            if other.paired == item.name:
                sizes = [a.size[1] for a in self.catalogue.choose_from(other.category, other.extent)]
                depth += 0.8 * min(sizes) if sizes else 0.0
        rows, cols = grid(wanted, (asset.size[0], depth), shape, self.extent)
        if item.name in self.asked.least and rows * cols < _NEARLY * wanted:
            return max(
                (rows, cols), grid(wanted, (asset.size[0], depth), _LOOSE, self.extent), key=lambda g: g[0] * g[1]
            )
        return rows, cols

    def _asset(self, item: Item, wanted: int) -> Asset | None:
        """Draw an asset whose copies fit what is left of the share, the smallest ones where none does.

        Those that are preferred come first, as long as one fits the room and the share.
        """
        choices = self._looking_so(item, self.catalogue.choose_from(item.category, item.extent))
        own = [a for a in choices if a.key in self.catalogue.preferred]
        first = self._drawn(item, wanted, own) if own else None
        if first is not None and (item.name in self.asked.least or first.footprint <= max(self.left, 0.0)):
            return first
        return self._drawn(item, wanted, choices)

    def _looking_so(self, item: Item, assets: list[Asset]) -> list[Asset]:
        """Return the assets that are as the brief says ("double bed", "leather sofa"), word by word where any is."""
        names = [item.category] if isinstance(item.category, str) else item.category
        asked = (words for category, words in self.wanted_looks.items() if any(answers(category, n) for n in names))
        for word in itertools.chain.from_iterable(asked):
            assets = [a for a in assets if has_quality(a.category, a.size, a.material, word)] or assets
        return assets

    def _drawn(self, item: Item, wanted: int, assets: list[Asset]) -> Asset | None:
        """Draw one of `assets`; None where none goes into the room."""
        long, short = self.extent
        inside = [a for a in assets if a.size[0] <= long - 0.3 and a.size[1] <= short - 0.3]
        if not inside and item.name in self.asked.least:  # lengthwise in a narrow room
            inside = [a for a in assets if max(a.size[:2]) <= long - 0.3 and min(a.size[:2]) <= short - 0.3]
        if not inside and item.name in self.asked.least:  # the largest of another size
            others = [a for a in self.catalogue.choose_from(item.category) if max(a.size[:2]) <= short - 0.3]
            others = self.catalogue.favoured(others)
            inside = sorted(others, key=lambda a: (-a.footprint, a.key))[:1]
        assets = inside
        if not assets:
            return None
        assets = self._for_seats(item, assets, wanted)
        if item.name in self.asked.least:
            return pair_of_seats(self._asked_asset(assets, wanted))
        free = max(self.left - self._reserved(item), 0.0)
        limit = 99.0 if item.paired else 0.7 * free / max(1, min(wanted, 3))
        fitting = [a for a in assets if a.footprint <= limit]
        if _is_whole(item.matrix, wanted):
            fitting = [a for a in fitting if wanted * a.footprint <= free] or fitting
        if not fitting:
            fitting = sorted(assets, key=lambda a: a.footprint)[: max(1, len(assets) // 8)]
        return self.style.pick(fitting, self.rng)

    def _asked_asset(self, assets: list[Asset], wanted: int) -> Asset:
        """Draw an asset whose requested copies leave enough floor free, or else one of the smallest."""
        roomy = [a for a in assets if wanted * a.footprint <= _ASKED_SHARE * self.area]
        if self.compact or not roomy:
            least = min(a.footprint for a in assets)
            roomy = [a for a in assets if a.footprint <= 1.05 * least]
        return self.style.pick(roomy, self.rng)

    def _smaller(self, item: Item, asset: Asset) -> list[Asset]:
        """Return up to two assets of the same category that are smaller in plan, the largest of them first."""
        w, d, _ = asset.size
        choices = self.catalogue.choose_from(asset.category, item.extent)
        fits = [a for a in choices if a.size[0] <= w and a.size[1] <= d and a.footprint < 0.93 * asset.footprint]
        fits.sort(key=lambda a: (-a.footprint, a.key))
        out = fits[:1]
        if out:
            out += [a for a in fits if a.footprint < 0.85 * out[0].footprint][:1]
        return out

    def _enough_seats(self, name: str, entry: _Entry) -> list[Asset]:
        """Return the smaller assets that still take the seats of the room around them."""
        seats = [e for e in self.entries.values() if sits_around(e.item, name)]
        return [
            table
            for table in entry.smaller
            if all(entry.count * seats_around(table, e.asset) >= e.count for e in seats)
        ]

    def finished(self) -> tuple[list[PlacementObject], dict[str, Asset], dict[str, list[Asset]]]:
        """Return the placer's objects, without relations to items that were left out."""
        floor = []
        smaller = {name: self._enough_seats(name, entry) for name, entry in self.entries.items()}
        first = self.first
        for name, entry in self.entries.items():
            relative = [r for r in entry.item.relative if r.target in self.entries and r.target != name]
            floor.append(
                PlacementObject(
                    name=name,
                    size=entry.asset.size,
                    category=entry.asset.category,
                    quantity=entry.count,
                    global_=entry.item.global_,
                    structure=entry.structure,
                    relative=relative,
                    smaller=[a.size for a in smaller[name]],
                    first=name in first,
                )
            )
        assets = {name: entry.asset for name, entry in self.entries.items()}
        return floor, assets, {name: choices for name, choices in smaller.items() if choices}


def _hang(draft: _Draft, item: HangItem) -> HangRequest | None:
    wanted = copies(item.count, draft.area, draft.numbers, draft.rng)
    present = draft.rng.random() < item.p and draft.area >= item.min_area
    assets = draft.catalogue.favoured(draft.catalogue.choose_from(item.category))
    asset = draft.style.pick(assets, draft.rng) if assets else None
    if asset is None or not present or wanted < 1:
        return None
    return HangRequest(
        asset=asset,
        count=wanted,
        place=item.place,
        height=item.height,
        above=draft.category_of(item.above),
        spacing=item.spacing,
    )


def _rugs(draft: _Draft) -> list[RugRequest]:
    out = []
    for item in draft.card.rugs:
        present = draft.rng.random() < item.p
        assets = draft.catalogue.choose_from(item.category)
        order = draft.rng.permutation(len(assets))
        if present and assets and (not item.under or _has(draft, item.under)):
            drawn = [assets[int(i)] for i in order]
            chosen = tuple(sorted(drawn, key=lambda asset: asset.key not in draft.catalogue.preferred))
            out.append(
                RugRequest(assets=chosen, under=draft.category_of(item.under), margin=item.margin, count=item.count)
            )
    return out


def _has(draft: _Draft, under: str) -> bool:
    return any(under in (name, entry.asset.category) for name, entry in draft.entries.items())


def _arrangements(catalogue: Catalogue, card: RoomProgramCard) -> list[Arrangement]:
    """Return the room's own arrangements, then those for its type, then those for any room."""
    table = catalogue.arrangements
    own = [table[name] for name in card.arrangements if name in table]
    names = {card.room_type, *card.tags}
    typed = [a for a in table.values() if names & set(a.rooms)]
    general = [a for a in table.values() if not a.rooms]
    return own + [a for a in typed if a not in own] + [a for a in general if a not in own]
