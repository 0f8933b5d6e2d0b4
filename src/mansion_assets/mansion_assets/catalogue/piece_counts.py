"""How many pieces of furniture an asset is: the seats of a row count each."""

import msgspec

from mansion_assets.catalogue.asset import Asset
from mansion_knowledge.object_kinds import answers

__all__ = ["pair_of_seats", "pieces"]


def pieces(requested: str, asset: Asset) -> int:
    """Return how many of `requested` an asset is: the seats of a row, else one; 0 where it does not answer."""
    if not answers(requested, asset.category):
        return 0
    return int(asset.parameters.get("seats", 1)) if asset.recipe == "seat_row" else 1


def pair_of_seats(row: Asset) -> Asset:
    """Return two seats of a row of three or more, both at an aisle when rows stand side by side; else the asset."""
    number = pieces(row.category, row)
    if number < 3:
        return row
    size = (2 * row.size[0] / number, row.size[1], row.size[2])
    return msgspec.structs.replace(row, size=size, parameters={**row.parameters, "seats": 2})
