"""Text search over the catalogue, by the index of its words."""

import re
from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_assets.catalogue.asset import Asset
from mansion_assets.catalogue.catalogue import Catalogue
from mansion_assets.catalogue.palette import COLOURS, FAMILIES
from mansion_assets.catalogue.word_index import word_index
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["PROPERTIES", "SearchHit", "having", "look_bonus", "mixed", "search_assets", "word_scores"]

PROPERTIES: Final[dict[str, str]] = {
    "pickupable": "pickupable",
    "pickable": "pickupable",
    "canpickup": "pickupable",
    "receptacle": "receptacle",
    "openable": "openable",
    "canopen": "openable",
    "toggleable": "toggleable",
    "cantoggleonoff": "toggleable",
    "thor": "thor",
}
"""Accepted property names, in small letters without separators, and the field that each tests."""


_NEAR: Final = 0.25
"""Share of the best score from which other categories come before further variants of the first."""
_NEAR_NAMED: Final = 0.45
"""The same where the query is a name, whose variants are wanted rather."""


class SearchHit(msgspec.Struct, frozen=True):
    """An asset and how well it fits; scores compare within one search only."""

    asset: Asset
    score: float


def search_assets(catalogue: Catalogue, query: str, top_k: int = 5, properties: Sequence[str] = ()) -> list[SearchHit]:
    """Return the assets that fit a text best, the best first.

    Parameters
    ----------
    query : str
        Free text; colours and materials in it choose among the variants of a category.
    top_k : int
        Greatest number of hits.
    properties : sequence of str
        Each must hold: ``pickupable``, ``receptacle``, ``openable``, ``toggleable``, ``thor`` (has an AI2-THOR id);
        AI2-THOR's own names (``CanPickup``, ...) count too.

    Notes
    -----
    The first hits come from different categories where several fit about as well; further variants follow. Within a
    category's variants those come first that the query's colours and materials fit, then those that are preferred.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for an unknown property.
    """
    fields = [_field(name) for name in properties]
    index = word_index(catalogue)
    scores = index.scores(query)
    order = sorted(range(len(scores)), key=lambda i: (-scores[i], i))
    groups: list[list[SearchHit]] = []
    for i in order:
        if scores[i] <= 0.0 or len(groups) > top_k:
            break
        variants = [a for a in catalogue.by_category(index.categories[i]) if _holds(a, fields)]
        hits = [SearchHit(a, round(scores[i] + look_bonus(a, query), 4)) for a in variants]
        hits.sort(key=lambda hit: (-hit.score, hit.asset.key not in catalogue.preferred))
        if hits:
            groups.append(hits)
    return mixed(groups, top_k, near=_NEAR_NAMED if index.is_name(query) else _NEAR)


def mixed(groups: Sequence[Sequence[SearchHit]], top_k: int, *, near: float = _NEAR) -> list[SearchHit]:
    """Return the first hits of groups, each sorted: in turn from those that fit about as well as the first group."""
    best = groups[0][0].score if groups else 0.0
    close = [group for group in groups if group[0].score >= near * best]
    far = [hit for group in groups if group[0].score < near * best for hit in group]
    depth = max((len(g) for g in close), default=0)
    turns = [g[level] for level in range(depth) for g in close if level < len(g)]
    return [*turns, *far][:top_k]


def word_scores(catalogue: Catalogue, query: str) -> dict[str, float]:
    """Return how well each category fits a text by its words; they compare within one search only."""
    index = word_index(catalogue)
    return dict(zip(index.categories, index.scores(query), strict=True))


def having(catalogue: Catalogue, properties: Sequence[str]) -> list[Asset]:
    """Return the assets that have all the properties (see `search_assets`), in the catalogue's order.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for an unknown property.
    """
    fields = [_field(name) for name in properties]
    return [asset for asset in catalogue.assets.values() if _holds(asset, fields)]


def _field(name: str) -> str:
    field = PROPERTIES.get(re.sub(r"[^a-z]", "", name.lower()))
    if field is None:
        accepted = ", ".join(sorted(set(PROPERTIES.values())))
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD, f"unknown property {name!r}; accepted: {accepted}", path="$.properties"
        )
    return field


def _holds(asset: Asset, fields: Sequence[str]) -> bool:
    return all(asset.asset_id is not None if field == "thor" else bool(getattr(asset, field)) for field in fields)


def look_bonus(asset: Asset, query: str) -> float:
    """Return a small bonus for each colour or material that the query names and the asset has."""
    words = set(re.findall(r"[a-z]+", query.lower()))
    named = words & (COLOURS.keys() | FAMILIES.keys())
    parts = set(asset.material.split("_"))
    return 0.5 * len(named & parts)
