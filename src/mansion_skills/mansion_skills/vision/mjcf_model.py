"""The MJCF model that the camera renders, from a floor's exported model and what came from other floors."""

from collections.abc import Container, Iterable, Iterator, Mapping
from dataclasses import dataclass
from io import BytesIO
from math import atan2, degrees, hypot
from pathlib import Path, PurePosixPath
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

import numpy as np
import numpy.typing as npt

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import FloorScene, SceneCore, SceneObject, StairDetails
from mansion_skills.vision.articulation import Triangles, hinges_of, part_of, read_stl

__all__ = [
    "BELOW",
    "CameraModel",
    "ModelFile",
    "OFF",
    "ON",
    "PART",
    "PATTERNS",
    "Pattern",
    "ROBOTS",
    "SHAFT",
    "camera_model",
    "pattern_of",
    "pattern_png",
    "robot_body",
    "shaft_boxes",
]

PIXELS = 256

_Grey = npt.NDArray[np.float64]

SHAFT, BELOW = "/shaft", "/below"
"""Added to a stair's id: the bodies of its shaft, and of the flights below."""

SKIN = 0.03
"""Thickness of what stands for the walls beyond, metres."""

ON, OFF = "#on", "#off"
"""Added to a material's name: what shines, and what is switched off."""

PART = "#part"
"""Added, with a number, to the id of an object: the body of its door or lid."""

ROBOTS = 8
"""Robots that can be seen on a floor."""

SHINING = ("light", "screen")
"""First words of the materials of what can be switched on."""

GROUND = 300.0
"""Metres of ground around the building."""

GROUND_STEP = 0.06
"""Metres from the ground up to the finished ground floor."""

_PLACE = (("pos", "0 0 0"), ("quat", "1 0 0 0"))

_SHOWN = {"contype": "0", "conaffinity": "0", "mass": "0", "group": "0"}

_GLOW = {"emission": "1"}

_HEADLIGHT = {"ambient": "0.56 0.56 0.56", "diffuse": "0 0 0", "specular": "0 0 0"}
"""Ambient light only: a light that turns with the camera would show seams in panoramas."""

_LIGHTS = (
    {"dir": "0.35 0.55 -0.76", "diffuse": "0.42 0.41 0.39", "specular": "0.1 0.1 0.1"},
    {"dir": "-0.75 -0.45 -0.48", "diffuse": "0.36 0.36 0.37", "specular": "0.05 0.05 0.05"},
    {"dir": "0.1 0.15 0.98", "diffuse": "0.36 0.36 0.35", "specular": "0 0 0"},
)

_ROBOT = (
    ("cylinder", "0.19 0.12", "0 0 0.14", "0.22 0.24 0.27 1"),
    ("cylinder", "0.05 0.4", "0 0 0.66", "0.85 0.86 0.88 1"),
    ("box", "0.09 0.14 0.08", "0.02 0 1.14", "0.18 0.45 0.72 1"),
)


@dataclass(frozen=True)
class Pattern:
    """A pattern that repeats every `period` metres.

    Attributes
    ----------
    words : tuple of str
        A material whose name has one of them is laid so.
    """

    name: str
    period: float
    words: tuple[str, ...]


PATTERNS = (
    Pattern("tiles", 1.2, ("ceramic", "tile", "marble", "porcelain", "slate", "granite", "stone")),
    Pattern("planks", 1.6, ("oak", "wood", "plank", "parquet", "herringbone", "bamboo", "cork")),
    Pattern("weave", 0.8, ("carpet", "rug", "felt")),
    Pattern("speckle", 1.2, ("terrazzo", "concrete", "vinyl", "rubber", "epoxy", "screed")),
)


def pattern_of(material: str) -> Pattern | None:
    """Return how a floor of a material is laid; ``None`` for plain ones."""
    return next((p for p in PATTERNS if any(word in material for word in p.words)), None)


def pattern_png(pattern: Pattern) -> bytes:
    """Return a pattern as a PNG file of 256 x 256 pixels; always the same one."""
    from PIL import Image

    draw = {"tiles": _tiles, "planks": _planks, "weave": _weave, "speckle": _speckle}
    rng = np.random.default_rng([len(pattern.name), PIXELS])
    grey = np.clip(np.round(255 * draw[pattern.name](rng)), 0, 255).astype(np.uint8)
    file = BytesIO()
    Image.fromarray(np.repeat(grey[..., None], 3, axis=2)).save(file, "PNG")
    return file.getvalue()


def _tiles(rng: np.random.Generator) -> _Grey:
    """Two by two tiles with joints."""
    half = PIXELS // 2
    grey = np.repeat(np.repeat(rng.uniform(0.93, 1.0, (2, 2)), half, axis=0), half, axis=1)
    joint = np.arange(PIXELS) % half < 3
    grey[joint, :] = grey[:, joint] = 0.68
    return grey


def _planks(rng: np.random.Generator) -> _Grey:
    """Eight rows of boards, each with its own shade, grain and end."""
    rows, deep = 8, PIXELS // 8
    grey = np.empty((PIXELS, PIXELS))
    for row in range(rows):
        ends = np.sort(rng.integers(0, PIXELS, 2))
        shade = rng.uniform(0.82, 1.0, 2)
        along = np.arange(PIXELS)
        board = np.where((along >= ends[0]) & (along < ends[1]), shade[0], shade[1])
        grain = 1.0 + 0.03 * rng.standard_normal((deep, 1))
        strip = board[None, :] * grain
        strip[:2, :] = 0.62
        strip[:, ends] = 0.62
        grey[row * deep : (row + 1) * deep] = strip
    return grey


def _weave(rng: np.random.Generator) -> _Grey:
    """Short threads in squares that turn from one to the next."""
    grey = 0.94 + 0.05 * rng.standard_normal((PIXELS, PIXELS))
    quarter = (np.arange(PIXELS) // (PIXELS // 2)) % 2
    return grey - 0.035 * (quarter[:, None] ^ quarter[None, :])


def _speckle(rng: np.random.Generator) -> _Grey:
    """Chips of two sizes in an even ground."""
    grey = np.full((PIXELS, PIXELS), 0.97)
    for count, size, shade in ((260, 3, 0.8), (120, 5, 0.88)):
        for y, x in rng.integers(0, PIXELS - size, (count, 2)).tolist():
            grey[y : y + size, x : x + size] = shade
    return grey


@dataclass(frozen=True)
class ModelFile:
    """A floor's exported model, on disk or in memory.

    Attributes
    ----------
    bodies : dict
        Name to element, without what is only collided with, which has no material.
    materials, meshes : dict
        Name to attributes.
    sky : dict
        Attributes of the sky's texture.
    folder : Path
        Folder of the meshes on disk.
    files : mapping of str to bytes
        Meshes in memory by name; empty for a model on disk.
    """

    bodies: dict[str, Element]
    materials: dict[str, dict[str, str]]
    meshes: dict[str, dict[str, str]]
    sky: dict[str, str]
    folder: Path
    files: Mapping[str, bytes]

    @classmethod
    def made(cls, files: Mapping[str, bytes]) -> "ModelFile":
        """Return the model of files by path in the building's folder, one of them the document."""
        (document,) = [data for path, data in files.items() if path.endswith(".xml")]
        meshes = {PurePosixPath(path).name: data for path, data in files.items() if not path.endswith(".xml")}
        return cls._of(ElementTree.fromstring(document), Path(), meshes)

    @classmethod
    def read(cls, path: Path) -> "ModelFile":
        """Read a file that ``mansion export DIR --to mjcf`` wrote.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` when there is none, ``INVALID_PAYLOAD`` when it is no XML.
        """
        try:
            root = ElementTree.parse(path).getroot()
        except OSError:
            raise MansionError(
                ErrorCode.NOT_FOUND,
                f"{path} does not exist; `mansion export DIR --to mjcf` writes what the camera needs",
                path="$.path",
            ) from None
        except ElementTree.ParseError as error:
            raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{path}: {error}") from None
        compiler = root.find("compiler")
        folder = compiler.get("meshdir", ".") if compiler is not None else "."
        return cls._of(root, (path.parent / folder).resolve(), {})

    @classmethod
    def _of(cls, root: Element, folder: Path, files: Mapping[str, bytes]) -> "ModelFile":
        bodies = {}
        for body in root.iterfind("worldbody/body"):
            for geom in body.findall("geom"):
                if not geom.get("material"):
                    body.remove(geom)
            bodies[body.get("name", "")] = body
        texture = root.find("asset/texture")
        return cls(
            bodies=bodies,
            materials={m.get("name", ""): dict(m.attrib) for m in root.iterfind("asset/material")},
            meshes={m.get("name", ""): dict(m.attrib) for m in root.iterfind("asset/mesh")},
            sky=dict(texture.attrib) if texture is not None else {},
            folder=folder,
            files=files,
        )

    def triangles(self, mesh: str) -> Triangles:
        """Return the triangles of a mesh at its scale.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` when its file is missing.
        """
        entry = self.meshes[mesh]
        try:
            corners = read_stl(self.files.get(entry["file"]) or (self.folder / entry["file"]).read_bytes())
        except OSError as error:
            raise MansionError(ErrorCode.NOT_FOUND, f"{self.folder / entry['file']}: {error.strerror}") from None
        scale = np.array([float(v) for v in entry.get("scale", "1 1 1").split()])
        scaled: Triangles = corners * scale
        return scaled


def shaft_boxes(scene: FloorScene) -> Iterator[tuple[str, list[Element]]]:
    """Yield for each stair the name of its shaft's body and its boxes, without a material.

    Where stairs lead on, the walls go on for a storey, up to a lid and down to a bottom; else the lid is the ceiling.
    """
    for core in scene.cores:
        details = core.details
        if not isinstance(details, StairDetails):
            continue
        top = max((wall.height for wall in scene.walls), default=2.8)
        lid = top + scene.height if details.ceiling_opening else top
        boxes = [_plate(core, lid)]
        if details.ceiling_opening:
            boxes += _ring(core, top, lid)
        if details.floor_opening:
            boxes += _ring(core, -scene.height, 0.0)
            boxes.append(_plate(core, -scene.height))
        yield core.id + SHAFT, boxes


def _ring(core: SceneCore, low: float, high: float) -> list[Element]:
    """Boxes along the outline, inside of it."""
    ring, boxes = core.polygon, []
    for (ax, ay), (bx, by) in zip(ring, [*ring[1:], ring[0]]):
        length = hypot(bx - ax, by - ay)
        inward = (-(by - ay) / length * SKIN / 2, (bx - ax) / length * SKIN / 2)
        x, y = (ax + bx) / 2 + inward[0], (ay + by) / 2 + inward[1]
        box = _box((x, y, (low + high) / 2), (length, SKIN, high - low))
        box.set("euler", f"0 0 {degrees(atan2(by - ay, bx - ax)):g}")
        boxes.append(box)
    return boxes


def _plate(core: SceneCore, z: float) -> Element:
    xs, ys = zip(*core.polygon)
    middle = ((min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2, z)
    return _box(middle, (max(xs) - min(xs), max(ys) - min(ys), SKIN))


def _box(center: tuple[float, float, float], size: tuple[float, float, float]) -> Element:
    return Element(
        "geom",
        type="box",
        pos=" ".join(f"{value:g}" for value in center),
        size=" ".join(f"{value / 2:g}" for value in size),
        rgba="0.62 0.61 0.59 1",
    )


def robot_body(number: int) -> str:
    """Return the name of the body that shows the other robot of that number."""
    return f"robot#{number}"


@dataclass(frozen=True)
class CameraModel:
    """An MJCF document, and the pictures and meshes in memory that it names."""

    document: str
    files: dict[str, bytes]


def camera_model(
    file: ModelFile,
    scene: FloorScene,
    kinds: Mapping[str, SceneObject],
    guests: Iterable[tuple[ModelFile, str]] = (),
    below: tuple[ModelFile, float] | None = None,
) -> CameraModel:
    """Return what is rendered of a floor.

    Parameters
    ----------
    file : ModelFile
        The floor's.
    scene : FloorScene
    kinds : mapping
        The objects of the building.
    guests : iterable of (ModelFile, str)
        Objects of other floors that are here now, each with the file that has it.
    below : (ModelFile, float), optional
        The next floor down, whose flights are seen, and how deep it lies, metres.
    """
    writer = _Writer(kinds, {room.id for room in scene.rooms})
    for name, body in file.bodies.items():
        writer.body(file, name, body)
    for other, name in guests:
        writer.body(other, name, other.bodies[name])
    for name, boxes in shaft_boxes(scene):
        writer.boxes(name, boxes)
    for core in scene.cores if below is not None else ():
        if core.type == "stair" and below is not None and core.id in below[0].bodies:
            flights = Element("body", pos=f"0 0 {-below[1]:g}")
            flights.extend(below[0].bodies[core.id])
            writer.body(below[0], core.id + BELOW, flights)
    for number in range(ROBOTS):
        writer.robot(number)
    if scene.elevation >= 0.0:
        writer.ground(-scene.elevation - GROUND_STEP)
    return CameraModel(writer.document(file.sky), dict(writer.files))


class _Writer:
    def __init__(self, kinds: Mapping[str, SceneObject], rooms: Container[str]) -> None:
        self._kinds = kinds
        self._rooms = rooms
        self.files: dict[str, bytes] = {}
        self._assets = Element("asset")
        self._world = Element("worldbody")
        self._known: set[str] = set()
        self._materials: dict[str, dict[str, str]] = {}

    def body(self, file: ModelFile, name: str, source: Element) -> None:
        """Write a body; what of it opens becomes one of its own."""
        place = {key: source.get(key, default) for key, default in _PLACE if source.get(key)}
        body = Element("body", {"name": name, **place})
        kind = self._kinds.get(name)
        hinges = hinges_of(kind) if kind is not None else ()
        parts = [Element("body", {"name": f"{name}{PART}{i}", **place}) for i in range(len(hinges))]
        if kind is not None and parts:
            self._cut(file, source, kind, [body, *parts])
        else:
            for geom in source.findall("geom"):
                self._geom(file, body, name, geom)
        self._world.extend(entry for entry in (body, *parts) if len(entry))

    def _geom(self, file: ModelFile, body: Element, name: str, geom: Element) -> None:
        """Write a box, or a mesh; floors with the pattern of their finish."""
        material = self._material(file, geom.get("material", ""))
        mesh = geom.get("mesh")
        pattern = pattern_of(geom.get("material", "")) if name in self._rooms else None
        if mesh is None:
            shape = {key: geom.get(key, "") for key in ("type", "pos", "size", "quat")}
            shape = {key: value for key, value in shape.items() if value}
            _add(body, "geom", material=material, **_SHOWN, **shape)
        elif pattern is not None:
            self._inline_mesh(f"{name}#{mesh}", file.triangles(mesh), pattern.period)
            self._mesh(body, f"{name}#{mesh}", self._patterned(material, pattern))
        else:
            self._mesh(body, self._file_mesh(file, mesh), material)

    def _mesh(self, body: Element, mesh: str, material: str) -> None:
        _add(body, "geom", type="mesh", mesh=mesh, material=material, **_SHOWN)

    def _cut(self, file: ModelFile, source: Element, kind: SceneObject, bodies: list[Element]) -> None:
        """Write an object's meshes, what opens into bodies of its own: what stays first, then each part."""
        geoms = [geom for geom in source.findall("geom") if geom.get("mesh")]
        meshes = [file.triangles(geom.get("mesh", "")) for geom in geoms]
        part = part_of(np.concatenate([np.zeros((0, 3, 3)), *meshes]), kind)
        ends = np.cumsum([len(mesh) for mesh in meshes])
        for geom, mesh, chosen in zip(geoms, meshes, np.split(part, ends)):
            material = self._material(file, geom.get("material", ""))
            for number, body in enumerate(bodies, start=-1):
                if (chosen == number).any():
                    name = f"{kind.id}#{geom.get('mesh')}#{number}"
                    self._inline_mesh(name, mesh[chosen == number])
                    self._mesh(body, name, material)

    def _material(self, file: ModelFile, name: str) -> str:
        """Write a material when it is new, with its other states when it can shine."""
        given = file.materials[name]
        key = "|".join([name, *(given.get(k, "") for k in ("rgba", "emission"))])
        if key not in self._known:
            self._known.add(key)
            self._materials[key] = given
            self._assets.append(Element("material", {**given, "name": key}))
            if name.startswith(SHINING):
                r, g, b, a = (float(v) for v in given["rgba"].split())
                dim = " ".join(f"{0.55 * v:g}" for v in (r, g, b)) + f" {a:g}"
                self._assets.append(Element("material", {**given, "name": key + ON} | _GLOW))
                self._assets.append(Element("material", {**given, "name": key + OFF, "rgba": dim, "emission": "0"}))
        return key

    def _patterned(self, material: str, pattern: Pattern) -> str:
        """Write a material with the pattern of a floor."""
        file, name = f"{pattern.name}.png", f"{material}|{pattern.name}"
        if file not in self.files:
            self.files[file] = pattern_png(pattern)
            attributes = {"name": pattern.name, "type": "2d", "file": file}
            self._assets.append(Element("texture", attributes))
        if name not in self._known:
            self._known.add(name)
            given = {**self._materials[material], "name": name, "texture": pattern.name}
            self._assets.append(Element("material", given))
        return name

    def _file_mesh(self, file: ModelFile, name: str) -> str:
        if name not in self._known:
            self._known.add(name)
            entry = dict(file.meshes[name])
            if entry["file"] in file.files:
                self.files[entry["file"]] = file.files[entry["file"]]
            else:
                entry["file"] = str(file.folder / entry["file"])
            self._assets.append(Element("mesh", entry))
        return name

    def _inline_mesh(self, name: str, triangles: Triangles, period: float = 0.0) -> None:
        """Write a mesh into the document; with a texture that repeats in plan when it has a period, metres."""
        points, index = np.unique(np.round(triangles.reshape(-1, 3), 5), axis=0, return_inverse=True)
        faces = index.reshape(-1, 3)
        flat = (faces[:, [0, 1, 2]] == faces[:, [1, 2, 0]]).any(axis=1)
        attributes = {
            "name": name,
            "inertia": "shell",
            "vertex": " ".join(f"{v:g}" for v in points.ravel()),
            "face": " ".join(str(v) for v in faces[~flat].ravel()),
        }
        if period > 0.0:
            attributes["texcoord"] = " ".join(f"{v:g}" for v in (points[:, :2] / period).ravel())
        self._assets.append(Element("mesh", attributes))

    def boxes(self, name: str, boxes: Iterable[Element]) -> None:
        """Write a body of boxes that have their own colours."""
        body = _add(self._world, "body", name=name)
        for box in boxes:
            body.append(Element("geom", {**box.attrib, **_SHOWN}))

    def ground(self, z: float) -> None:
        """Write the ground around the building."""
        body = _add(self._world, "body", name="ground")
        size, pos = f"{GROUND} {GROUND} 0.1", f"0 0 {z - 0.1:g}"
        _add(body, "geom", type="box", size=size, pos=pos, rgba="0.45 0.5 0.38 1", **_SHOWN)

    def robot(self, number: int) -> None:
        """Write the body of another robot: a base, a mast and a head."""
        body = _add(self._world, "body", name=robot_body(number))
        for kind, size, pos, rgba in _ROBOT:
            _add(body, "geom", type=kind, size=size, pos=pos, rgba=rgba, **_SHOWN)

    def document(self, sky: Mapping[str, str]) -> str:
        """Return all that was written as one document."""
        root = Element("mujoco")
        _add(root, "compiler", angle="degree", autolimits="true")
        visual = _add(root, "visual")
        _add(visual, "headlight", **_HEADLIGHT)
        _add(visual, "map", znear="0.05", zfar="1000")
        _add(visual, "quality", offsamples="0", shadowsize="0")
        _add(root, "statistic", extent="1")
        if sky:
            self._assets.append(Element("texture", dict(sky)))
        root.append(self._assets)
        for light in _LIGHTS:
            _add(self._world, "light", type="directional", castshadow="false", **light)
        root.append(self._world)
        return ElementTree.tostring(root, encoding="unicode")


def _add(parent: Element, tag: str, **attributes: str) -> Element:
    return ElementTree.SubElement(parent, tag, attributes)
