"""The request for a building: the input of Algorithm 1 of the MANSION paper (arXiv 2603.11554)."""

import hashlib
import re
from typing import Annotated, Any, Literal, TypeAlias

import msgspec

from mansion_msgs_py.building_plan import BuildingPlan
from mansion_msgs_py.codec import encode
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import decode_from
from mansion_msgs_py.limits import MAX_BUILDING_AREA, MAX_FLOORS
from mansion_msgs_py.program import Clutter
from mansion_msgs_py.shapes import Area, BuildingId, Ring

__all__ = ["BuildRequest", "Footprint", "Libraries", "building_id_of", "footprint_from_json", "identified"]


Libraries: TypeAlias = Annotated[
    tuple[Annotated[str, msgspec.Meta(min_length=1, max_length=4096)], ...], msgspec.Meta(max_length=50)
]
"""Names of libraries of own assets, or paths with a slash in them."""


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
        The brief: English, or what language the model of planner ``llm`` reads.
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
        Who reads the description and plans: rules, or a language model whose gaps they fill.
    building_id : str, optional
        Names the building in every payload; derived from the request when absent.
    plan : BuildingPlan, optional
        The plan to furnish; the description, which may then be empty, says what it is and what is wished for beside.
    clutter : {"sparse", "dense"}, optional
        Fewer or more small objects than usual lie about in all rooms.
    assets : tuple of str, optional
        Libraries of own assets that come before the catalogue's, by name, or by a path with a slash in it.
    """

    description: Annotated[str, msgspec.Meta(max_length=200_000)]
    floors: Annotated[int, msgspec.Meta(ge=1, le=MAX_FLOORS)] | None = None
    area: Annotated[float, msgspec.Meta(gt=0.0, le=MAX_BUILDING_AREA)] | None = None
    floor_area: Area | None = None
    footprint: Footprint | None = None
    seed: Annotated[int, msgspec.Meta(ge=0, le=2**53)] = 0
    planner: Literal["rules", "llm"] = "rules"
    building_id: BuildingId | None = None
    schema_version: Literal[1] = 1
    plan: BuildingPlan | None = None
    assets: Libraries | msgspec.UnsetType = msgspec.UNSET
    clutter: Clutter | msgspec.UnsetType = msgspec.UNSET

    @property
    def libraries(self) -> tuple[str, ...]:
        """Libraries of own assets; none where the request does not say."""
        return () if isinstance(self.assets, msgspec.UnsetType) else self.assets


def building_id_of(request: BuildRequest) -> str:
    """Return the id of the building that a request asks for: its own, or one made from its words and a hash.

    Examples
    --------
    >>> building_id_of(BuildRequest(description="A small flat", seed=3))
    'a-small-flat-8c3972bb'
    """
    if request.building_id is not None:
        return request.building_id
    spoken = request.description or (request.plan.name if request.plan else "")
    words = re.findall(r"[a-z0-9]+", spoken.lower())
    slug = "-".join(words)[:40].strip("-") or "building"
    said = {name: getattr(request, name) for name in BuildRequest.__struct_fields__}
    if request.plan is None:
        del said["plan"]
    for name in ("assets", "clutter"):
        if isinstance(said[name], msgspec.UnsetType):
            del said[name]
    digest = hashlib.sha256(msgspec.json.encode(said)).hexdigest()[:8]
    return f"{slug}-{digest}"


def identified(request: BuildRequest) -> BuildRequest:
    """Return the request with its ``building_id`` filled in."""
    return msgspec.structs.replace(request, building_id=building_id_of(request))


def footprint_from_json(data: bytes, source: str) -> Footprint:
    """Read a footprint.

    Parameters
    ----------
    data : bytes
        ``{"boundary": ring, "holes": [ring]}``, or a GeoJSON Polygon, Feature or FeatureCollection of one.
    source : str
        Named in errors.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD``.
    """
    value = decode_from(dict[str, Any], data, source)
    if "type" not in value:
        return decode_from(Footprint, data, source)
    rings = _polygon(value, source)
    if not rings:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{source}: the polygon has no ring")
    open_rings = [_without_repeated_end(ring) for ring in rings]
    fields = {"boundary": open_rings[0], "holes": open_rings[1:]}
    return decode_from(Footprint, encode(fields), source)


def _polygon(value: dict[str, Any], source: str) -> list[Any]:
    kind = value.get("type")
    if kind == "Polygon":
        return list(value.get("coordinates") or [])
    if kind == "Feature" and isinstance(value.get("geometry"), dict):
        return _polygon(value["geometry"], source)
    if kind == "FeatureCollection":
        features = value.get("features")
        if isinstance(features, list) and len(features) == 1 and isinstance(features[0], dict):
            return _polygon(features[0], source)
    raise MansionError(
        ErrorCode.INVALID_PAYLOAD,
        f"{source}: GeoJSON of type {kind!r}; expected one Polygon, a Feature or a FeatureCollection of one",
        path="$.type",
    )


def _without_repeated_end(ring: Any) -> Any:
    if isinstance(ring, list) and len(ring) > 1 and ring[0] == ring[-1]:
        return ring[:-1]
    return ring
