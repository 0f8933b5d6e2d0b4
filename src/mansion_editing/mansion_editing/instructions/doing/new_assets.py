"""Which assets new things are made of, and on which counters small ones come."""

import math
from collections.abc import Collection, Generator

from mansion_assets.catalogue import Asset
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.descriptions import things_of
from mansion_editing.instructions.meaning.measured import compares
from mansion_editing.instructions.meaning.nouns import is_among_counters
from mansion_editing.instructions.statements import Amount, Place, Things
from mansion_editing.provisioning.facts import ObjectDescription
from mansion_editing.provisioning.new_objects import find_assets
from mansion_editing.runs.policies import Action, Outcome, Unmet
from mansion_editing.state import SceneState
from mansion_editing.tools.relations import FLOOR_GAP, footprint_gap
from mansion_editing.tools.tops import carries_on_top
from mansion_msgs_py.editing.questions import AssetInfo
from mansion_msgs_py.scene import SceneObject
from mansion_msgs_py.shapes import Point3

__all__ = ["assets_of", "compared", "counters_by", "like_those_there"]


def assets_of(things: Things, state: SceneState) -> Generator[Action, Outcome, list[AssetInfo]]:
    """Return the assets that new things may be, those of the material that words ask for first.

    Raises
    ------
    Unmet
        Where the catalogue has none.
    """
    if not things.noun:
        raise Unmet("say what to bring")
    assets = yield from find_assets(ObjectDescription(things.noun, 1, things.colour), state)
    assets.sort(key=lambda a: _is_dummy(a, state))
    if things.material:
        kinds = {asset.category for asset in assets[:1]}
        assets.sort(key=lambda a: (a.category not in kinds, things.material.lower() not in a.material))
    return assets


def like_those_there(
    things: Things, assets: list[AssetInfo], rooms: Collection[str], state: SceneState
) -> list[AssetInfo]:
    """Return the assets for ``more mats``, ``exactly five`` yoga mats first, where all of the rooms are."""
    if things.amount.kind not in ("more", "exactly") or things.colour or things.material or things.hints:
        return assets
    every = Things(noun=things.noun, amount=Amount(kind="all", number=0), definite=True, plural=True)
    kinds = {item.category for item in things_of(state, every, Context()) if item.room in rooms}
    if len(kinds) != 1 or assets[0].category in kinds:
        return assets
    own = [info for info in assets if info.category in kinds]
    own = own or [_info_of(asset) for kind in kinds for asset in state.catalogue.by_category(kind)]
    return [*own, *(info for info in assets if info.category not in kinds)]


def _is_dummy(info: AssetInfo, state: SceneState) -> bool:
    """Whether an asset does not open or switch as most others of its kind do: a prop of AI2-THOR."""
    kind = state.catalogue.by_category(info.category)
    own = state.catalogue.assets.get(info.asset_id)
    if own is None:
        return False
    most = len(kind) / 2
    switches = sum(asset.toggleable for asset in kind) > most
    opens = sum(asset.openable for asset in kind) > most
    return (switches and not own.toggleable) or (opens and not own.openable)


def compared(things: Things, assets: list[AssetInfo], before: Point3, state: SceneState) -> list[AssetInfo]:
    """Return the assets of the kind that are larger, taller, ... than what was there, the least different first.

    Raises
    ------
    Unmet
        Where there is none.
    """
    kind = assets[0].category
    sizes = {asset.key: asset.size for asset in state.catalogue.by_category(kind)}
    known = {info.asset_id: info for info in assets}
    fitting = [key for key, size in sizes.items() if compares(things.hints, size, before)]
    if not fitting:
        raise Unmet(f"the catalogue has no {' and '.join(things.hints)} {things.noun}")
    fitting.sort(key=lambda key: (round(math.dist(sizes[key], before), 4), key))
    return [known.get(key) or _info_of(state.catalogue.asset(key)) for key in fitting]


def _info_of(asset: Asset) -> AssetInfo:
    return AssetInfo(
        asset_id=asset.key,
        category=asset.category,
        name=asset.name,
        size=asset.size,
        score=0.0,
        material=asset.material,
    )


def counters_by(mark: SceneObject, place: Place, state: SceneState) -> list[str]:
    """Return the ids of the furniture by a stove, a sink, ... that carries what is put beside that, counters first."""
    if place.relation not in ("beside", "near", "left", "right") or not is_among_counters(mark):
        return []
    tops = [
        (not item.category.endswith(("counter", "counter_top", "island")), round(footprint_gap(item, mark), 4), item.id)
        for _, item in state.objects()
        if item.room == mark.room and item.id != mark.id and item.mount == "floor"
        if (asset := state.asset(item)) is not None and carries_on_top(asset)
    ]
    return [name for _, gap, name in sorted(tops) if gap <= FLOOR_GAP]
