"""The catalogue: assets by key and category, and the object programs of room types."""

from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import Literal

import msgspec

from mansion_assets.catalogue.asset import Asset
from mansion_assets.catalogue.records import Arrangement, Extent, HangItem, Item, RoomRecord, RugItem
from mansion_assets.catalogue.room_matching import RoomIndex
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["Catalogue", "RoomProgramCard"]


class RoomProgramCard(msgspec.Struct, frozen=True, kw_only=True):
    """The object program of a room type, with what ``like`` names filled in.

    Attributes
    ----------
    asked, room_type : str
        The type asked for, and the type whose program is used.
    how : {"exact", "synonym", "similar", "fallback"}
        How the first matched the second.
    """

    asked: str
    room_type: str
    how: Literal["exact", "synonym", "similar", "fallback"]
    cover: float
    floor: tuple[Item, ...]
    wall: tuple[HangItem, ...]
    ceiling: tuple[HangItem, ...]
    rugs: tuple[RugItem, ...]
    arrangements: tuple[str, ...]
    tags: tuple[str, ...]


class Catalogue:
    """Assets, room programs and arrangements of small objects; read only.

    Parameters
    ----------
    assets : iterable of Asset
    rooms : iterable of RoomRecord
    arrangements : iterable of Arrangement
        A later record replaces an earlier one of the same key, type or name.
    preferred : collection of str
        Keys of the assets that come before others of their categories.
    """

    def __init__(
        self,
        assets: Iterable[Asset],
        rooms: Iterable[RoomRecord],
        arrangements: Iterable[Arrangement],
        *,
        preferred: Collection[str] = (),
    ) -> None:
        self._preferred = frozenset(preferred)
        self._assets: dict[str, Asset] = {asset.key: asset for asset in assets}
        self._rooms: dict[str, RoomRecord] = {room.room_type: room for room in rooms}
        self._arrangements = {record.name: record for record in arrangements}
        self._categories: dict[str, list[Asset]] = {}
        for asset in self._assets.values():
            self._categories.setdefault(asset.category, []).append(asset)
        self._index = RoomIndex(self._rooms.values())

    @property
    def assets(self) -> Mapping[str, Asset]:
        """All assets by key."""
        return self._assets

    @property
    def categories(self) -> list[str]:
        """Names of the categories, in the order of the data files."""
        return list(self._categories)

    @property
    def room_types(self) -> list[str]:
        """Room types with a record of their own."""
        return list(self._rooms)

    @property
    def arrangements(self) -> Mapping[str, Arrangement]:
        """Arrangements of small objects by name."""
        return self._arrangements

    @property
    def preferred(self) -> frozenset[str]:
        """Keys of the assets that come before others of their categories."""
        return self._preferred

    def favoured(self, assets: Sequence[Asset]) -> list[Asset]:
        """Return those of `assets` that are preferred, or all where none is."""
        first = [asset for asset in assets if asset.key in self._preferred] if self._preferred else []
        return first or list(assets)

    def asset(self, key: str) -> Asset:
        """Return an asset by key.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` with the nearest keys in `details`.
        """
        found = self._assets.get(key)
        if found is not None:
            return found
        import difflib

        near = difflib.get_close_matches(key, self._assets, n=5, cutoff=0.5)
        raise MansionError(
            ErrorCode.NOT_FOUND,
            f"no asset {key!r} in the catalogue; nearest: {', '.join(near) or 'none'}",
            details={"asset": key, "nearest": near},
        )

    def by_category(self, category: str) -> Sequence[Asset]:
        """Return the assets of a category, in the order of the data files; empty for an unknown one."""
        return self._categories.get(category, [])

    def choose_from(self, category: str | list[str], extent: Extent | None = None) -> list[Asset]:
        """Return the assets of one or several categories that fit an `extent`."""
        names = [category] if isinstance(category, str) else category
        out = [asset for name in names for asset in self._categories.get(name, [])]
        if extent is None:
            return out
        return [a for a in out if _within(a, extent)]

    def room_program(self, room_type: str) -> RoomProgramCard:
        """Return the program of a room type; every type gets one (see `RoomIndex.resolve`)."""
        name, how = self._index.resolve(room_type)
        record = self._rooms[name]
        chain = [record]
        while chain[-1].like and self._rooms[chain[-1].like] not in chain:
            chain.append(self._rooms[chain[-1].like])
        return RoomProgramCard(
            asked=room_type,
            room_type=name,
            how=how,
            cover=record.cover,
            floor=tuple(next((r.floor for r in chain if r.floor is not None), [])),
            wall=tuple(next((r.wall for r in chain if r.wall is not None), [])),
            ceiling=tuple(next((r.ceiling for r in chain if r.ceiling is not None), [])),
            rugs=tuple(next((r.rugs for r in chain if r.rugs is not None), [])),
            arrangements=tuple(next((r.arrangements for r in chain if r.arrangements), [])),
            tags=tuple(next((r.tags for r in chain if r.tags), [])),
        )


def _within(asset: Asset, extent: Extent) -> bool:
    bounds = zip(extent.min, asset.size, extent.max, strict=True)
    return all(low <= value <= high for low, value, high in bounds)
