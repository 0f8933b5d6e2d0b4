"""New objects of a description: the assets that fit it, tried on a receptacle one after the other."""

from collections.abc import Generator, Mapping
from typing import Any, Final

from mansion_assets.catalogue.vocabulary import stems, vocabulary_of
from mansion_editing.provisioning.facts import ObjectDescription
from mansion_editing.runs.policies import Action, Outcome, Unmet, ask
from mansion_editing.state import SceneState
from mansion_language.colours import colour_of
from mansion_msgs_py.editing.questions import AssetHits, AssetInfo
from mansion_msgs_py.errors import ErrorCode
from mansion_msgs_py.wording import with_article

__all__ = ["find_assets", "place_any"]

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
