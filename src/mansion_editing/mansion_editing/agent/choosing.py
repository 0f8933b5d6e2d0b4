"""Which assets serve as a thing, and placing the first of them that finds a place."""

from collections.abc import Generator
from typing import Final

from mansion_editing.agent.facts import Thing
from mansion_editing.agent.protocol import Action, Outcome
from mansion_editing.state import SceneState
from mansion_editing.vocabulary import colour_of, stems
from mansion_msgs_py.editing import AssetHits, AssetInfo
from mansion_msgs_py.errors import ErrorCode
from mansion_msgs_py.wording import with_article

__all__ = ["Assets", "Placed", "assets_of", "place_any"]

Assets = Generator[Action, Outcome, list[AssetInfo] | str]
"""Ends with assets, the best first, or why there is none."""

Placed = Generator[Action, Outcome, tuple[str, str]]
"""Ends with the new object's id, or with an empty id and the reason."""

MOST_ASSETS: Final = 4


def assets_of(thing: Thing, state: SceneState) -> Assets:
    """Return assets of a thing: the best first, then the small ones; those of its colour before others."""
    words = " ".join(word for word in (thing.colour, thing.noun) if word)
    answer = yield Action(f"Which asset is {with_article(words)}?", "SearchAssets", {"query": words, "top_k": 50})
    if answer.error is not None:
        return str(answer.error)
    hits: AssetHits = answer.value
    categories = state.vocabulary.nouns(thing.noun)
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
        return f"the catalogue has no {words}"
    exact = state.vocabulary.exact(stems(thing.noun))
    mine = [a for a in mine if a.category in exact] or mine
    first = mine[0].category
    alike = [a for a in mine if a.category == first]
    if thing.colour:
        alike.sort(key=lambda a: colour_of(a.material) != thing.colour)
        own = [a for a in alike if colour_of(a.material) == thing.colour]
        alike = own or alike
    small = sorted(alike[1:], key=lambda a: a.size[0] * a.size[1] * a.size[2])
    others = [a for a in mine if a.category != first]
    return [alike[0], *small[:2], *others]


def place_any(
    assets: list[AssetInfo], carrier: str, relation: str, *, colour: str = "", near: str = "", most: int = MOST_ASSETS
) -> Placed:
    """Try variants of an asset on one receptacle.

    Parameters
    ----------
    near : str
        Id of an object to put it beside.
    """
    reason = ""
    for asset in assets[:most]:
        arguments = {"asset_id": asset.asset_id}
        if colour and colour_of(asset.material) != colour:
            arguments["color"] = colour
        if relation == "in":
            tool, arguments["container_id"] = "PlaceInContainer", carrier
        else:
            tool, arguments["receptacle_id"] = "PlaceOnSurface", carrier
            if near:
                arguments["near"] = near
        answer = yield Action(f"{asset.asset_id} is missing {relation} {carrier}.", tool, arguments)
        if answer.error is None:
            return answer.value.object_ids[0], ""
        reason = reason or answer.error.info.message
        if answer.error.code != ErrorCode.INFEASIBLE:
            break
    return "", reason
