"""Make a user's model into an asset: name it, turn it to the front, scale it, add support surfaces and pieces."""

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final, Literal, TypeAlias

import msgspec
import numpy as np

from mansion_assets.catalogue.asset import Asset, JointRecord
from mansion_assets.catalogue.catalogue import Catalogue
from mansion_assets.catalogue.palette import COLOURS
from mansion_assets.catalogue.records import AssetRecord
from mansion_assets.convex import Box
from mansion_assets.glb_meshes import PieceRecord
from mansion_assets.joints import Joint
from mansion_assets.library.annotations import Annotation
from mansion_assets.library.category_guess import Named, category_of, plain_name, slug
from mansion_assets.library.convex_decomposition import METHODS, decomposed, method, piece_record
from mansion_assets.library.inner_volumes import Receptacles, receptacles_of_model
from mansion_assets.library.mass_estimate import guessed_mass
from mansion_assets.library.mesh_files import Up, read_model
from mansion_assets.library.scaling import sizing
from mansion_assets.library.source_model import Look, SourceModel, SourceSurface
from mansion_assets.library.urdf import read_urdf
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import Mount
from mansion_msgs_py.shapes import Size3

__all__ = ["FRONTS", "TRIANGLES", "AddOptions", "Prepared", "material_name", "prepared"]

Front: TypeAlias = Literal["+x", "-x", "+y", "-y", "+z", "-z"]

FRONTS: Final[tuple[Front, ...]] = ("+x", "-x", "+y", "-y", "+z", "-z")

TRIANGLES: Final = 100_000
"""Most triangles of an asset: each building that has one carries them in every export."""

_SMALL: Final = 0.35
"""Longest edge up to which what is new is picked up and stands on furniture, metres."""

_THINNEST: Final = 0.003
"""Least side of an asset, metres."""


@dataclass(frozen=True)
class AddOptions:
    """What a user states of all models that are added at once; empty where they are to speak for themselves.

    Attributes
    ----------
    up : {"y", "z"}, optional
        Axis of the files that points up; y by default.
    front : str, optional
        Direction of the files' axes that the front faces.
    triangles : int
        Most triangles of a model.
    """

    category: str = ""
    licence: str = ""
    author: str = ""
    source: str = ""
    rooms: tuple[str, ...] = ()
    up: Up | None = None
    front: Front | None = None
    triangles: int = TRIANGLES


@dataclass
class _Facts:
    """Facts as they become known, and how."""

    stated: list[str] = field(default_factory=list)
    guessed: list[str] = field(default_factory=list)

    def add(self, text: str, *, stated: bool) -> None:
        (self.stated if stated else self.guessed).append(text)


@dataclass(frozen=True)
class Prepared:
    """An asset that is ready to be written: its record without names of files, its model, its pieces."""

    record: AssetRecord
    model: SourceModel
    pieces: tuple[PieceRecord, ...]
    known: bool


def prepared(
    path: Path, root: Path, options: AddOptions, catalogue: Catalogue, annotation: Annotation | None
) -> Prepared:
    """Return the asset that a file makes.

    Parameters
    ----------
    path : Path
    root : Path
        Folder that all files lie in that it names.
    catalogue : Catalogue
        Whose categories, sizes and surfaces fill in what the file leaves open.
    annotation : Annotation, optional

    Raises
    ------
    MansionError
        ``NOT_FOUND`` and ``INVALID_PAYLOAD`` with what is wrong with the file.
    """
    facts = _Facts()
    model = read_urdf(path, root) if path.suffix.lower() == ".urdf" else read_model(path, options.up or "y")
    _refuse_broken(path, model, options.triangles)
    named = _named(path, model, options, catalogue, annotation, facts)
    alike = catalogue.by_category(named.category)
    model = _turned(path, model, options, annotation, facts)
    low, high = model.bounds
    scaled = sizing(high - low, annotation, alike)
    facts.add(f"size: {scaled.how}", stated=scaled.stated)
    model = model.placed((low + high) / 2, scaled.scale)
    w, d, h = (max(round(float(side), 4), _THINNEST) for side in (high - low) * scaled.scale)
    record = _record(path, named, (w, d, h), model, options, annotation, alike, facts)
    free = [Box((s.x, s.y, s.z + s.clearance / 2), (s.w, s.d, s.clearance)) for s in record.surfaces]
    free += [Box((v.x, v.y, v.z), (v.w, v.d, v.h)) for v in record.volumes]
    pieces = _pieces(model, record.size, free, facts)
    if record.mass is None:
        like, opens = alike[0] if alike else None, any(part.joint for part in model.parts)
        guess = guessed_mass(pieces, record.size, like, _largest(model).look, opens=opens)
        facts.add(f"mass: {guess.mass:.3g} kg, {guess.how}", stated=False)
        record = msgspec.structs.replace(record, mass=guess.mass)
    for note in model.notes:
        facts.add(note, stated=False)
    record = msgspec.structs.replace(record, stated=facts.stated, guessed=facts.guessed)
    return Prepared(record, model, pieces, named.known)


def _refuse_broken(path: Path, model: SourceModel, most: int) -> None:
    fault = ""
    if model.triangles == 0:
        fault = "is empty: it has no triangle"
    elif not np.isfinite(model.points).all():
        bad = int((~np.isfinite(model.points)).any(axis=1).sum())
        fault = f"has {bad} vertices that are not finite"
    elif model.triangles > most:
        fault = f"has {model.triangles:,} triangles, more than the {most:,} allowed; reduce it, or raise --triangles"
    else:
        low, high = model.bounds
        if float(np.sort(high - low)[1]) < 1e-9:
            fault = "has no extent: its triangles lie on a line or a point"
    if fault:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{path.name} {fault}", details={"file": str(path)})


def _named(
    path: Path,
    model: SourceModel,
    options: AddOptions,
    catalogue: Catalogue,
    annotation: Annotation | None,
    facts: _Facts,
) -> Named:
    """Return the category: the user's, the annotation's, or by that name of file, model and folder that says most."""
    if options.category:
        named = category_of(options.category, catalogue)
        how, stated = "as asked", True
    elif annotation is not None and annotation.category:
        named = category_of(annotation.category, catalogue)
        how, stated = f"{annotation.category!r} by {annotation.source}", True
    else:
        names = [name for name in (path.stem, model.name, path.parent.name) if plain_name(name)]
        w, d, h = (float(side) for side in np.ptp(model.bounds, axis=0))
        found = [category_of(name, catalogue, (w, d, h)) for name in names]
        found = found or [Named("thing", "thing", known=False)]
        named = max(found, key=lambda each: each.words if each.known else 0)
        how, stated = f"by the name {named.name!r}", False
    own = "" if named.known else ", a new one"
    facts.add(f"category: {named.category}{own}, {how}", stated=stated)
    return named


def _turned(
    path: Path, model: SourceModel, options: AddOptions, annotation: Annotation | None, facts: _Facts
) -> SourceModel:
    """Return the model with its front to +y."""
    if options.front is not None:
        facts.add(f"front: {options.front}, as asked", stated=True)
        if path.suffix.lower() == ".urdf":
            # What the file has along its axes was turned by the reader already.
            raise MansionError(
                ErrorCode.INVALID_PAYLOAD, f"{path.name}: --front is for meshes; a URDF's is where its doors are"
            )
        return model.turned(_turn_to_front(options.front, options.up or "y"))
    if annotation is not None and annotation.turn is not None:
        facts.add(f"front: turned by {annotation.turn:.0f} degrees by {annotation.source}", stated=True)
        return model.turned(annotation.turn)
    facts.add(f"front: {model.front or 'assumed to be where glTF has it'}", stated=False)
    return model


def _turn_to_front(front: Front, up: Up) -> float:
    """Return the degrees by which the reader's model is turned so that a direction of the file's axes faces +y."""
    axes = {"y": {"x": (-1, 0), "z": (0, 1)}, "z": {"x": (1, 0), "y": (0, 1)}}[up]
    if front[1] not in axes:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"the front cannot be {front}: {up} is up", path="$.front")
    sign = 1 if front[0] == "+" else -1
    x, y = axes[front[1]]
    return 90.0 - math.degrees(math.atan2(sign * y, sign * x))


def _record(
    path: Path,
    named: Named,
    size: Size3,
    model: SourceModel,
    options: AddOptions,
    annotation: Annotation | None,
    alike: Sequence[Asset],
    facts: _Facts,
) -> AssetRecord:
    said = annotation or Annotation()
    like = alike[0] if alike else None
    mount = _mount(said, like, size, facts)
    small = max(size) <= _SMALL and mount == "surface"
    pickupable = _first(said.pickupable, like.pickupable if like else None, small)
    mass = said.mass or model.mass
    if mass:
        facts.add(f"mass: {mass:.3g} kg", stated=True)
    held = _receptacles(model, said, alike, mount, pickupable=pickupable, facts=facts)
    licence = options.licence or said.licence
    facts.add(f"licence: {licence or 'not stated'}", stated=bool(licence))
    words = named.name or named.category.replace("_", " ")
    return AssetRecord(
        key=_key(path, named),
        category=named.category,
        name=words,
        synonyms=list(like.synonyms) if like else [],
        size=size,
        materials={"main": material_name(_largest(model))},
        mount=mount,
        pickupable=pickupable,
        openable=_first(said.openable, None, False) or any(part.joint for part in model.parts),
        toggleable=_first(said.toggleable, like.toggleable if like else None, False),
        surfaces=held.surfaces,
        volumes=held.volumes,
        rooms=list(options.rooms),
        tags=list(like.tags) if like else [],
        joints=[_joint_record(part.joint) for part in model.parts if part.joint is not None],
        mass=mass,
        description=said.description,
        source=options.source or said.origin or path.name,
        author=options.author or said.author,
        licence=licence,
    )


def _joint_record(joint: Joint) -> JointRecord:
    x, y, z = (round(value, 6) + 0.0 for value in joint.axis)
    u, v, w = (round(value, 6) + 0.0 for value in joint.origin)
    return JointRecord(
        part=joint.part, kind=joint.kind, axis=(x, y, z), origin=(u, v, w), travel=round(joint.travel, 6)
    )


def _first(*values: bool | None) -> bool:
    return next((value for value in values if value is not None), False)


def _key(path: Path, named: Named) -> str:
    """Return a key that tells the file's asset from others."""
    if plain_name(path.stem):
        return slug(path.stem)
    name = path.stem if any(c.isdigit() for c in path.stem) else path.parent.name
    bare = slug(name).removeprefix("thing_")
    return bare if plain_name(name) else f"{named.category}_{bare[:8]}".rstrip("_")


def _mount(said: Annotation, like: Asset | None, size: Size3, facts: _Facts) -> Mount:
    if said.mount is not None:
        facts.add(f"stands: {said.mount}, by {said.source}", stated=True)
        return said.mount
    if like is not None:
        facts.add(f"stands: {like.mount}, as its category does", stated=False)
        return like.mount
    mount: Mount = "surface" if max(size) <= _SMALL else "floor"
    facts.add(f"stands: {mount}, by its size", stated=False)
    return mount


def _receptacles(
    model: SourceModel, said: Annotation, alike: Sequence[Asset], mount: Mount, *, pickupable: bool, facts: _Facts
) -> Receptacles:
    """Return where things stand on the body or lie in it, if they do on things of its kind."""
    carrying = [asset for asset in alike if asset.surfaces or asset.volumes]
    carries = said.receptacle if said.receptacle is not None else bool(carrying) or not alike
    if not carries or pickupable or mount == "ceiling":
        facts.add("surfaces: none, nothing stands on things of its kind", stated=said.receptacle is False)
        return Receptacles([], [])
    kinds = Counter(asset.surfaces[0].kind for asset in carrying if asset.surfaces)
    found = receptacles_of_model(model, kinds.most_common(1)[0][0] if kinds else "top")
    facts.add(f"surfaces: {len(found.surfaces)}, where its faces are level", stated=False)
    if found.volumes:
        facts.add(f"volumes: {len(found.volumes)}, in its drawers and behind its doors", stated=False)
    return found


def _pieces(model: SourceModel, size: Size3, free: Sequence[Box], facts: _Facts) -> tuple[PieceRecord, ...]:
    how = method()
    found: list[PieceRecord] = []
    given = 0
    for part in model.parts:
        if part.boxes:
            given += 1
            halves = [((low + high) / 2, high - low) for low, high in part.boxes]
            boxes = [Box(tuple(center.tolist()), tuple(np.maximum(side, 1e-3).tolist())) for center, side in halves]
            found += [piece_record(part.name, box) for box in boxes]
        elif part.surfaces:
            starts = np.cumsum([0] + [len(s.vertices) for s in part.surfaces[:-1]])
            faces = np.concatenate([s.faces + start for s, start in zip(part.surfaces, starts.tolist())])
            pieces = decomposed(part.points, faces, size, free, how)
            found += [piece_record(part.name, piece) for piece in pieces]
    stated = given == len(model.parts)
    facts.add(f"pieces: {len(found)}, {'as the file has them' if stated else METHODS[how]}", stated=stated)
    return tuple(found)


def _largest(model: SourceModel) -> SourceSurface:
    """Return the surface of the look that most of the model has."""
    areas: dict[Look, float] = {}
    first: dict[Look, SourceSurface] = {}
    for part in model.parts:
        for surface in part.surfaces:
            areas[surface.look] = areas.get(surface.look, 0.0) + surface.area
            first.setdefault(surface.look, surface)
    return first[max(areas, key=lambda look: areas[look])]


def material_name(surface: SourceSurface) -> str:
    """Return the name of a look's material: the nearest colour that has a word, and its own.

    Examples
    --------
    >>> from mansion_assets.library.source_model import Look
    >>> material_name(SourceSurface(np.zeros((0, 3)), np.zeros((0, 3), dtype=np.int64), Look((180, 58, 50))))
    'own_red_b43a32'
    """
    color = np.array(surface.look.color, dtype=np.float64)

    def distance(name: str) -> float:
        text = COLOURS[name]
        return float(np.abs(color - [int(text[i : i + 2], 16) for i in (1, 3, 5)]).sum())

    near = min((name for name in COLOURS if name in _WORDS), key=distance)
    red, green, blue = surface.look.color
    return f"own_{near}_{red:02x}{green:02x}{blue:02x}"


_WORDS: Final = frozenset("white black grey dark light red blue green yellow orange purple brown beige pink".split())
