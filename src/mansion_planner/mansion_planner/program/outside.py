"""What the outside of a building is to be, by what the brief states."""

from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_knowledge import default_knowledge
from mansion_msgs_py.outside import GroundUse, GroundWish, Outside, RoofForm
from mansion_planner.brief.facts import OutsideFact

__all__ = ["outside_of"]

FLAT_COVERINGS: Final = frozenset({"lawn", "roof_gravel"})
"""What covers flat roofs; everything else needs a slope."""

_FORMS: Final[dict[str, RoofForm]] = {"flat": "flat", "gable": "gable", "hip": "hip"}


def outside_of(facts: Sequence[OutsideFact], building_type: str, style: str) -> Outside | msgspec.UnsetType:
    """Return what facts state of the outside, the first of each part; not set where they state nothing.

    A covering without a form decides the form as well: tiles lie on a gable, grass on a flat roof.

    Parameters
    ----------
    building_type, style : str
        Of the knowledge base: a kind of building that has a pitched roof anyway keeps its own form.
    """
    if not facts:
        return msgspec.UNSET
    roofs = [fact for fact in facts if fact.part == "roof"]
    form: RoofForm = next((_FORMS[fact.name] for fact in roofs if fact.name), "")
    covering = next((fact.covering for fact in roofs if fact.covering), "")
    if covering and not form:
        usual = default_knowledge().groups.roofs_of(building_type, style)
        form = "flat" if covering in FLAT_COVERINGS else _FORMS[next((f for f in usual if f != "flat"), "gable")]
    counts: dict[GroundUse, int] = {}
    for fact in facts:
        if fact.use is not None:
            counts[fact.use] = max(counts.get(fact.use, 0), fact.count)
    return Outside(
        facade=next((fact.name for fact in facts if fact.part == "facade"), ""),
        roof=form,
        covering=covering,
        grounds=tuple(GroundWish(use=use, count=count) for use, count in counts.items()),
    )
