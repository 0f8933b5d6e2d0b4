"""The user's own assets in a building, and how often each is used."""

from collections import Counter
from collections.abc import Sequence
from pathlib import Path

import msgspec

from mansion_assets.catalogue import Asset, load_catalogue
from mansion_assets.library.building_assets import own_assets
from mansion_msgs_py.building import OwnAssetUse
from mansion_msgs_py.scene import FloorScene

__all__ = ["asset_uses", "assets_in"]


def assets_in(scenes: Sequence[FloorScene]) -> list[Asset]:
    """Return the user's assets that objects of the scenes show."""
    return own_assets((item.asset for scene in scenes for item in scene.objects), load_catalogue())


def asset_uses(assets: Sequence[Asset], scenes: Sequence[FloorScene]) -> list[OwnAssetUse] | msgspec.UnsetType:
    """Return the part of a report about the user's assets; unset if there are none."""
    counts = Counter(item.asset for scene in scenes for item in scene.objects)
    uses = [
        OwnAssetUse(
            asset=asset.key,
            category=asset.category,
            objects=counts[asset.key],
            library=Path(asset.record).parent.parent.name,
            licence=asset.licence,
            author=asset.author,
            source=asset.source,
            sha256=asset.sha256,
        )
        for asset in assets
    ]
    return uses or msgspec.UNSET
