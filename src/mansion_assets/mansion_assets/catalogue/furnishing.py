"""What one room is to be furnished with: the placer's wishes and the decorator's."""

import msgspec

from mansion_assets.catalogue.asset import Asset
from mansion_assets.catalogue.records import Arrangement
from mansion_msgs_py.placement import PlacementObject
from mansion_msgs_py.shapes import Size3

__all__ = ["HangWish", "RoomFurnishing", "RugWish"]


class HangWish(msgspec.Struct, frozen=True, kw_only=True):
    """A wall or ceiling asset, `count` times (see `HangItem` for the fields)."""

    asset: Asset
    count: int
    place: str = "free"
    height: float | None = None
    above: str = ""
    spacing: float = 3.0


class RugWish(msgspec.Struct, frozen=True, kw_only=True):
    """A rug below the floor object named (or of the category) `under`; the first asset that fits."""

    assets: tuple[Asset, ...]
    under: str = ""
    margin: float = 0.4
    count: int = 1


class RoomFurnishing(msgspec.Struct, frozen=True, kw_only=True):
    """The wish lists of a room.

    Attributes
    ----------
    floor : list of PlacementObject
        For the placer.
    floor_assets : dict
        The asset of each entry of `floor`, by its name.
    alternatives : dict
        Assets behind ``smaller``, in the same order.
    small : list of Arrangement
        What may lie on and in receptacles; the first that fits a receptacle counts.
    """

    room_id: str
    room_type: str
    program: str
    floor: list[PlacementObject]
    floor_assets: dict[str, Asset]
    alternatives: dict[str, list[Asset]]
    wall: list[HangWish]
    ceiling: list[HangWish]
    rugs: list[RugWish]
    small: list[Arrangement]

    def asset_for(self, name: str, size: Size3) -> Asset:
        """Return the asset of a placed object: the first choice, or the smaller one of that size."""
        first = self.floor_assets[name]
        choices = [first, *self.alternatives.get(name, [])]
        return min(choices, key=lambda a: sum(abs(p - q) for p, q in zip(a.size, size, strict=True)))
