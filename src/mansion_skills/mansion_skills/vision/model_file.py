"""Read a floor's ``model.xml``."""

from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

import numpy as np

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_skills.vision.fronts import Triangles, read_stl

__all__ = ["ModelFile"]

COLLISION_GROUP = "3"
"""Of boxes that are only collided with."""


@dataclass(frozen=True)
class ModelFile:
    """A floor's model on disk.

    Attributes
    ----------
    bodies : dict
        Name to element, without what is only collided with.
    materials, meshes : dict
        Name to attributes.
    sky : dict
        Attributes of the sky's texture.
    folder : Path
        Of the meshes.
    """

    bodies: dict[str, Element]
    materials: dict[str, dict[str, str]]
    meshes: dict[str, dict[str, str]]
    sky: dict[str, str]
    folder: Path

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
        bodies = {}
        for body in root.iterfind("worldbody/body"):
            for geom in body.findall("geom"):
                if geom.get("group") == COLLISION_GROUP:
                    body.remove(geom)
            bodies[body.get("name", "")] = body
        texture = root.find("asset/texture")
        compiler = root.find("compiler")
        folder = compiler.get("meshdir", ".") if compiler is not None else "."
        return cls(
            bodies=bodies,
            materials={m.get("name", ""): dict(m.attrib) for m in root.iterfind("asset/material")},
            meshes={m.get("name", ""): dict(m.attrib) for m in root.iterfind("asset/mesh")},
            sky=dict(texture.attrib) if texture is not None else {},
            folder=(path.parent / folder).resolve(),
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
            corners = read_stl(self.folder / entry["file"])
        except OSError as error:
            raise MansionError(ErrorCode.NOT_FOUND, f"{self.folder / entry['file']}: {error.strerror}") from None
        scale = np.array([float(v) for v in entry.get("scale", "1 1 1").split()])
        scaled: Triangles = corners * scale
        return scaled
