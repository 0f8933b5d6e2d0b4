"""Models from URDF files: links become parts, joints that move become hinges and slides.

The format: http://wiki.ros.org/urdf/XML. The body is the root link with all that is fixed to it. A part hangs on the
body by one joint, so that what moves on a moving part (the handle of a door) is fixed to it.
"""

import math
import re
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Final, Literal

import numpy as np

from mansion_assets.joints import DOOR_OPENS, Joint
from mansion_assets.library.mesh_files import file_within, read_surfaces, refused
from mansion_assets.library.source_model import Look, SourceModel, SourcePart, SourceSurface
from mansion_assets.library.surface_colours import surfaces_of
from mansion_geometry.compiled import Floats
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["read_urdf"]

_MOVING: Final = {"revolute": "hinge", "continuous": "hinge", "prismatic": "slide"}
_FIXED: Final = ("fixed", "floating", "planar")

_LEAST: Final = 1e-3
"""Metres, or degrees, below which a joint does not move."""

_MOST_TURN: Final = 175.0
"""Degrees by which a hinge opens at most: beyond that its part is on the other side of the body."""

_TO_FRONT: Final = 90.0
"""Degrees by which a model is turned whose front faces +x, as ROS has it."""


@dataclass(frozen=True)
class _Joint:
    name: str
    kind: str
    parent: str
    child: str
    origin: Floats
    axis: Floats
    lower: float
    upper: float


@dataclass
class _Robot:
    """The links of a file with their poses when all is closed, and the joint that each hangs on."""

    path: Path
    root: Path
    links: dict[str, ElementTree.Element]
    joints: dict[str, _Joint]
    colours: dict[str, Look]
    notes: list[str] = field(default_factory=list)


def read_urdf(path: Path, root: Path | None = None) -> SourceModel:
    """Return the model that a URDF holds, with its drawers and doors closed.

    Parameters
    ----------
    path : Path
    root : Path, optional
        Folder that all its meshes lie in; that of the file by default.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` and ``INVALID_PAYLOAD`` as `read_model`; and for a file that is not a URDF, for links that
        form a loop, for invalid numbers.
    """
    try:
        tree = ElementTree.fromstring(path.read_bytes())
    except OSError as error:
        raise MansionError(ErrorCode.NOT_FOUND, f"{path}: {error.strerror or error}") from None
    except ElementTree.ParseError as error:
        raise refused(path, f"is not XML: {error}") from None
    if tree.tag != "robot":
        raise refused(path, f"is not a URDF: its first element is {tree.tag[:40]!r}, not 'robot'")
    links = {_named(path, link): link for link in tree.findall("link")}
    joints = {joint.child: joint for joint in (_joint(path, entry) for entry in tree.findall("joint"))}
    colours = {m.get("name", ""): look for m in tree.findall("material") if (look := _colour(path, m)) is not None}
    robot = _Robot(path, root or path.parent, links, joints, colours)
    for joint in joints.values():
        for link in (joint.parent, joint.child):
            if link not in links:
                raise refused(path, f"has a joint {joint.name!r} with a link {link!r} that does not exist")
    parts = _parts(robot)
    if not any(part.surfaces for part in parts):
        raise refused(path, "is empty: no link has a visible triangle")
    model = SourceModel(tree.get("name") or path.stem, tuple(parts), mass=_mass(path, tree), notes=tuple(robot.notes))
    return _facing_front(model)


def _facing_front(model: SourceModel) -> SourceModel:
    """Turn a model so that its doors and drawers, or else ROS's +x, face the front."""
    pulls = np.zeros(2)
    center = np.mean(model.bounds, axis=0)
    for part in model.parts:
        if part.joint is None:
            continue
        if part.joint.kind == "slide":
            pulls += np.array(part.joint.axis)[:2]
        else:
            points = part.points
            away = (points.min(axis=0) + points.max(axis=0)) / 2 - center
            pulls += away[:2] / max(float(np.abs(away[:2]).max()), 1e-9)
    if float(np.abs(pulls).max()) < 0.3:
        return replace(model.turned(_TO_FRONT), front="ROS's convention: +x")
    angle = math.degrees(math.atan2(float(pulls[1]), float(pulls[0])))
    quarter = 90.0 * round((90.0 - angle) / 90.0)
    return replace(model.turned(quarter), front="the side of its doors and drawers")


def _parts(robot: _Robot) -> list[SourcePart]:
    """Return the body and the moving parts."""
    found: dict[str, SourcePart] = {"": SourcePart("", ())}
    names: dict[str, str] = {}
    for name, link in robot.links.items():
        pose, joint, part = _placed(robot, name)
        if joint is not None and part not in names:
            names[part] = _part_name(joint, list(names.values()))
        key = names.get(part, "")
        whole = found.get(key) or SourcePart(key, (), joint._replace(part=key) if joint else None)
        surfaces, boxes = _drawn(robot, link, pose), _colliding(robot, link, pose)
        found[key] = replace(whole, surfaces=(*whole.surfaces, *surfaces), boxes=(*whole.boxes, *boxes))
    return [part for key, part in found.items() if part.surfaces or not key]


def _part_name(joint: Joint, taken: list[str]) -> str:
    kind = "drawer" if joint.kind == "slide" else "door"
    if joint.kind == "hinge" and abs(joint.axis[2]) < 0.5:
        kind = "lid"
    return f"{kind}_{1 + sum(name.startswith(kind) for name in taken)}"


def _placed(robot: _Robot, link: str) -> tuple[Floats, Joint | None, str]:
    """Return where a link is when all is closed, the joint of the part that it belongs to, and that part's link."""
    chain: list[_Joint] = []
    name = link
    while name in robot.joints:
        chain.append(robot.joints[name])
        name = robot.joints[name].parent
        if len(chain) > len(robot.joints):
            raise refused(robot.path, f"has links that form a loop: {link!r}")
    pose = np.eye(4)
    moving: Joint | None = None
    part = ""
    for joint in reversed(chain):
        pose = pose @ joint.origin
        closed, travel = _range(joint)
        if travel and moving is None:
            moving, part = _moving(joint, pose, travel), joint.child
        elif travel and joint.child == link:
            robot.notes.append(f"joint {joint.name!r} is fixed: it moves on a part that moves")
        pose = pose @ _moved(joint, closed)
    return pose, moving, part


def _range(joint: _Joint) -> tuple[float, float]:
    """Return where a joint is closed, and how far it opens from there, negative against its axis; 0 where it is fixed.

    The limit that is nearer to 0 is the closed one.
    """
    if joint.kind == "continuous":
        return 0.0, math.radians(DOOR_OPENS)
    if joint.kind not in _MOVING:
        return 0.0, 0.0
    closed = min(max(0.0, joint.lower), joint.upper)
    travel = max(joint.upper - closed, joint.lower - closed, key=abs)
    least = _LEAST if joint.kind == "prismatic" else math.radians(_LEAST)
    return closed, travel if abs(travel) > least else 0.0


def _moving(joint: _Joint, pose: Floats, travel: float) -> Joint:
    axis = pose[:3, :3] @ joint.axis * math.copysign(1.0, travel)
    origin = pose[:3, 3]
    kind: Literal["hinge", "slide"] = "slide" if joint.kind == "prismatic" else "hinge"
    far = abs(travel) if kind == "slide" else min(math.degrees(abs(travel)), _MOST_TURN)
    return Joint("", kind, _triple(axis), _triple(origin), far)


def _triple(values: Floats) -> tuple[float, float, float]:
    return float(values[0]), float(values[1]), float(values[2])


def _moved(joint: _Joint, position: float) -> Floats:
    if joint.kind != "prismatic":
        return _turn(joint.axis, position)
    pose = np.eye(4)
    pose[:3, 3] = joint.axis * position
    return pose


def _turn(axis: Floats, angle: float) -> Floats:
    """Return a turn about a unit vector by radians, (4, 4)."""
    x, y, z = axis
    skew = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    pose = np.eye(4)
    pose[:3, :3] = np.eye(3) + math.sin(angle) * skew + (1.0 - math.cos(angle)) * skew @ skew
    return pose


def _joint(path: Path, entry: ElementTree.Element) -> _Joint:
    name, kind = _named(path, entry), entry.get("type", "")
    if kind not in _MOVING and kind not in _FIXED:
        raise refused(path, f"has a joint {name!r} of type {kind[:40]!r}; types are {', '.join((*_MOVING, *_FIXED))}")
    parent, child, limit = entry.find("parent"), entry.find("child"), entry.find("limit")
    if parent is None or child is None:
        raise refused(path, f"has a joint {name!r} without parent or child")
    turning = entry.find("axis")
    axis = _numbers(path, "1 0 0" if turning is None else turning.get("xyz", "1 0 0"), 3)
    length = float(np.linalg.norm(axis))
    if length < 1e-9:
        raise refused(path, f"has a joint {name!r} whose axis has no direction")
    lower, upper = (
        float(_numbers(path, "0" if limit is None else limit.get(end, "0"), 1)[0]) for end in ("lower", "upper")
    )
    return _Joint(
        name, kind, parent.get("link", ""), child.get("link", ""), _pose(path, entry.find("origin")), axis / length,
        min(lower, upper), max(lower, upper),
    )  # fmt: skip


def _pose(path: Path, origin: ElementTree.Element | None) -> Floats:
    pose = np.eye(4)
    if origin is not None:
        pose[:3, 3] = _numbers(path, origin.get("xyz", "0 0 0"), 3)
        angles = _numbers(path, origin.get("rpy", "0 0 0"), 3)
        for axis, angle in zip(np.eye(3)[::-1], angles[::-1].tolist(), strict=True):
            pose = pose @ _turn(axis, angle)
    return pose


def _drawn(robot: _Robot, link: ElementTree.Element, pose: Floats) -> list[SourceSurface]:
    """Return the visible part of a link."""
    found = []
    for visual in link.findall("visual"):
        place = pose @ _pose(robot.path, visual.find("origin"))
        material = visual.find("material")
        look = (
            None if material is None else _colour(robot.path, material) or robot.colours.get(material.get("name", ""))
        )
        for surface in _geometry(robot, visual):
            vertices = surface.vertices @ place[:3, :3].T + place[:3, 3]
            found.append(SourceSurface(vertices, surface.faces, look or surface.look))
    return found


def _colliding(robot: _Robot, link: ElementTree.Element, pose: Floats) -> list[tuple[Floats, Floats]]:
    """Return the boxes of a link's collision that stand square to the model."""
    found = []
    for collision in link.findall("collision"):
        box = collision.find("geometry/box")
        place = pose @ _pose(robot.path, collision.find("origin"))
        square = np.allclose(np.abs(place[:3, :3]).max(axis=0), 1.0, atol=1e-6)
        if box is None or not square:
            return []
        half = np.abs(place[:3, :3] @ _numbers(robot.path, box.get("size", ""), 3)) / 2
        found.append((place[:3, 3] - half, place[:3, 3] + half))
    return found


def _geometry(robot: _Robot, visual: ElementTree.Element) -> list[SourceSurface]:
    """Return the triangles of a shape in its own frame."""
    from trimesh import creation

    path, shape = robot.path, visual.find("geometry")
    kinds = [] if shape is None else list(shape)
    if not kinds:
        return []
    first = kinds[0]
    if first.tag == "mesh":
        scale = _numbers(path, first.get("scale", "1 1 1"), 3)
        surfaces = read_surfaces(_mesh_file(robot, first.get("filename", "")), robot.root)
        if float(np.prod(scale)) < 0.0:
            surfaces = [surface._replace(faces=surface.faces[:, ::-1]) for surface in surfaces]
        return [surface._replace(vertices=surface.vertices * scale) for surface in surfaces]
    if first.tag == "box":
        return surfaces_of(creation.box(_numbers(path, first.get("size", ""), 3)), linear=False)
    radius = float(_numbers(path, first.get("radius", ""), 1)[0])
    if first.tag == "cylinder":
        length = float(_numbers(path, first.get("length", ""), 1)[0])
        return surfaces_of(creation.cylinder(radius, length, sections=24), linear=False)
    if first.tag == "sphere":
        return surfaces_of(creation.icosphere(2, radius), linear=False)
    raise refused(path, f"has a shape {first.tag[:40]!r}; shapes are mesh, box, cylinder, sphere")


def _mesh_file(robot: _Robot, name: str) -> Path:
    """Return the file of a mesh; of ``package://NAME/rest`` what follows the package's name."""
    plain = re.sub(r"^(package://[^/]+/|file://)", "", name)
    folders = [robot.path.parent, robot.root] if name.startswith("package://") else [robot.path.parent]
    for folder in folders:
        if (folder / plain).is_file():
            break
    try:
        return file_within(robot.root, folder, plain)
    except MansionError as error:
        raise error.with_message(f"{robot.path.name}: {error.info.message}") from None


def _colour(path: Path, material: ElementTree.Element) -> Look | None:
    colour = material.find("color")
    if colour is None:
        return None
    values = np.clip(_numbers(path, colour.get("rgba", ""), 4), 0.0, 1.0)
    red, green, blue = (round(255 * float(value)) for value in values[:3])
    return Look((red, green, blue), float(values[3]), name=material.get("name", ""))


def _mass(path: Path, tree: ElementTree.Element) -> float | None:
    """Return the mass of all links that have one."""
    entries = [entry.get("value", "") for entry in tree.findall("link/inertial/mass")]
    whole = sum(float(_numbers(path, value, 1)[0]) for value in entries)
    return whole if whole > 0.0 else None


def _numbers(path: Path, text: str, count: int) -> Floats:
    try:
        values = np.array([float(word) for word in text.split()])
    except ValueError:
        values = np.zeros(0)
    if len(values) != count or not np.isfinite(values).all():
        raise refused(path, f"has {text[:60]!r} where {count} finite numbers belong")
    return values


def _named(path: Path, element: ElementTree.Element) -> str:
    name = element.get("name")
    if not name:
        raise refused(path, f"has a {element.tag} without a name")
    return name
