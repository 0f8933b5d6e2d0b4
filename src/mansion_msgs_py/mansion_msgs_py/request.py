"""What a user asks for: the input of Algorithm 1 of the MANSION paper (arXiv 2603.11554)."""

import hashlib
import re
from typing import Annotated, Literal

import msgspec

from mansion_msgs_py.shapes import Area, Ring

__all__ = ["BuildRequest", "Footprint", "identified"]


class Footprint(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """The building envelope, ``P_env`` of section C.1.

    Attributes
    ----------
    boundary : Ring
        Outer ring in metres; either orientation is accepted.
    holes : list of Ring
        Courtyards.
    """

    boundary: Annotated[Ring, msgspec.Meta(min_length=3)]
    holes: list[Ring] = []


class BuildRequest(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """One sentence and optional numeric constraints (section C.1).

    Attributes
    ----------
    description : str
        The brief, in English.
    floors : int, optional
        Target floor count above and at the ground, ``F_target``; read from the description when absent.
    area : float, optional
        Gross area of the whole building in square metres, ``A_target``.
    floor_area : float, optional
        Gross area of one floor in square metres; excludes `area`.
    footprint : Footprint, optional
        Outline of every floor; sampled when absent.
    seed : int
        Everything random follows from it.
    planner : {"rules", "llm"}
        Which planner reads the description.
    building_id : str, optional
        Names the building in every payload; derived from the request when absent.
    """

    description: Annotated[str, msgspec.Meta(max_length=200_000)]
    floors: Annotated[int, msgspec.Meta(ge=1, le=100)] | None = None
    area: Area | None = None
    floor_area: Area | None = None
    footprint: Footprint | None = None
    seed: Annotated[int, msgspec.Meta(ge=0, le=2**53)] = 0
    planner: Literal["rules", "llm"] = "rules"
    building_id: Annotated[str, msgspec.Meta(pattern=r"^[A-Za-z0-9][A-Za-z0-9_-]{0,63}$")] | None = None
    schema_version: Literal[1] = 1


def identified(request: BuildRequest) -> BuildRequest:
    """Return the request with a ``building_id``: its own, else one made from its words and its hash.

    Examples
    --------
    >>> identified(BuildRequest(description="A small flat", seed=3)).building_id
    'a-small-flat-0ebd0d5d'
    """
    if request.building_id is not None:
        return request
    words = re.findall(r"[a-z0-9]+", request.description.lower())
    slug = "-".join(words)[:40].strip("-") or "building"
    digest = hashlib.sha256(msgspec.json.encode(request)).hexdigest()[:8]
    return msgspec.structs.replace(request, building_id=f"{slug}-{digest}")
