"""Binary glTF 2.0 of a floor and of a building."""

import json
from collections.abc import Sequence
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from mansion_assets.catalogue import Catalogue
from mansion_assets.materials import material_set
from mansion_export.gltf_buffer import Buffer, Textures
from mansion_export.licences import licence_lines, licence_records
from mansion_export.meshes.building_model import building_models, floor_model
from mansion_export.meshes.materials import linear
from mansion_export.meshes.model import Material, Mesh, Model, Node, Surface
from mansion_export.meshes.normals import corner_normals, textured_corners
from mansion_export.presentation import building_title, floor_title, quarter_turns
from mansion_msgs_py.building_folder import floor_directory
from mansion_msgs_py.scene import FloorScene

__all__ = ["building_files", "building_glb", "floor_files", "floor_glb", "write_glb"]

Json: TypeAlias = dict[str, Any]


def building_glb(
    scenes: Sequence[FloorScene],
    *,
    ceilings: bool = True,
    site: bool = True,
    catalogue: Catalogue | None = None,
    models: Sequence[Model] | None = None,
) -> bytes:
    """Write all floors with stairs, shafts, doors, windows and objects as one binary glTF scene.

    Parameters
    ----------
    scenes : sequence of FloorScene
        In any order.
    ceilings : bool
        With ceilings and roof, as a robot sees it; without them, for a look from above.
    site : bool
        With the plot around the building.
    catalogue : Catalogue, optional
        Where the assets are, when they are not all in the shipped one.
    models : sequence of Model, optional
        What `building_models` makes of the same floors, the lowest first; made here when absent.

    Returns
    -------
    bytes
        The ``.glb`` file, y up. Nodes carry our ids: ``building_id`` > ``floor_2`` > ``floor_2/objects`` >
        ``F2/meeting_room_1/office_chair_3``.
    """
    name = scenes[0].building_id if scenes else "building"
    if models is None:
        models = building_models(scenes, ceilings=ceilings, site=site, catalogue=catalogue)
    return write_glb(models, name, building_title(scenes), quarter_turns(scenes), licence_records(scenes, catalogue))


def floor_glb(scene: FloorScene, *, ceilings: bool = True, catalogue: Catalogue | None = None) -> bytes:
    """Write one floor as binary glTF, its finished floor at its elevation; see `building_glb`."""
    return write_glb(
        [floor_model(scene, ceilings=ceilings, catalogue=catalogue)],
        scene.building_id,
        floor_title(scene),
        licences=licence_records([scene], catalogue),
    )


def building_files(scenes: Sequence[FloorScene], *, site: bool = True) -> dict[str, bytes]:
    """Return ``building.glb`` by its path in the building's folder."""
    return {"building.glb": building_glb(scenes, site=site)}


def floor_files(scene: FloorScene) -> dict[str, bytes]:
    """Return ``floor.glb`` of a floor by its path in the building's folder."""
    return {f"{floor_directory(scene.floor)}/floor.glb": floor_glb(scene)}


def write_glb(
    models: Sequence[Model], name: str, title: str = "", turns: int = 0, licences: Sequence[dict[str, str]] = ()
) -> bytes:
    """Write models as one binary glTF scene.

    Parameters
    ----------
    models : sequence of Model
        One a floor; each becomes a node ``floor_N`` at its elevation, with a child for each group.
    name : str
        Name of the root node.
    title : str
        What a person calls the building, kept in the root node's extras.
    turns : int
        Quarters by which to turn the building so that its entrance faces a viewer in the south; kept there, too.
    licences : sequence of dict
        Those of the user's assets, `licence_records`; in the extras of ``asset``, whose copyright states all.

    Returns
    -------
    bytes
        The ``.glb`` file. Every node is named after the id of its element.
    """
    writer = _Writer()
    floors = [writer.floor(model) for model in models]
    extras = {key: value for key, value in (("title", title), ("turns", turns)) if value}
    root = writer.node({"name": name, "children": floors, **({"extras": extras} if extras else {})})
    return writer.finish(root, licences)


def _titled(title: str) -> Json:
    return {"extras": {"title": title}} if title else {}


class _Writer:
    """Collects the JSON arrays and the binary buffer."""

    def __init__(self) -> None:
        self.nodes: list[Json] = []
        self.meshes: list[Json] = []
        self.materials: list[Json] = []
        self.buffer = Buffer()
        self.textures = Textures(self.buffer)
        self._mesh_index: dict[str, int] = {}
        self._material_index: dict[Material, int] = {}

    def node(self, content: Json) -> int:
        self.nodes.append(content)
        return len(self.nodes) - 1

    def floor(self, model: Model) -> int:
        """Write a floor's groups and nodes; return the index of the floor's node."""
        groups: dict[str, list[int]] = {}
        for node in model.nodes:
            mesh = self.mesh(model.meshes[node.mesh])
            if mesh is not None:
                groups.setdefault(node.group, []).append(self.node(_placed(node, mesh)))
        children = [
            self.node({"name": f"{model.name}/{group}", "children": members}) for group, members in groups.items()
        ]
        content: Json = {"name": model.name, "children": children, **_titled(model.title)}
        if model.elevation:
            content["translation"] = [0.0, round(model.elevation, 5), 0.0]
        if not children:
            del content["children"]
        return self.node(content)

    def mesh(self, mesh: Mesh) -> int | None:
        """Write a mesh once; None where it has no triangle."""
        if not mesh.surfaces:
            return None
        if mesh.name not in self._mesh_index:
            primitives = [self.primitive(surface) for surface in mesh.surfaces]
            self.meshes.append({"name": mesh.name, "primitives": primitives})
            self._mesh_index[mesh.name] = len(self.meshes) - 1
        return self._mesh_index[mesh.name]

    def primitive(self, surface: Surface) -> Json:
        textured = bool(surface.material.texture)
        if textured:
            points, normals, places, indices = textured_corners(surface.vertices, surface.faces, surface.coordinates)
        else:
            points, normals, indices = corner_normals(surface.vertices, surface.faces)
        positions = gltf_points(points)
        attributes = {
            "POSITION": self.buffer.array(positions, bounds=True),
            "NORMAL": self.buffer.array(gltf_points(normals)),
        }
        if textured:
            width, height = material_set(surface.material.texture).size
            tiles = places / (width, -height)
            attributes["TEXCOORD_0"] = self.buffer.array(tiles.astype(np.float32))
        dtype = np.uint16 if len(positions) < 65535 else np.uint32
        return {
            "attributes": attributes,
            "indices": self.buffer.array(indices.astype(dtype).reshape(-1)),
            "material": self.material(surface.material),
        }

    def material(self, material: Material) -> int:
        if material not in self._material_index:
            pbr: Json = {
                "baseColorFactor": [*linear(material.color), material.alpha],
                "metallicFactor": material.metallic,
                "roughnessFactor": material.roughness,
            }
            content: Json = {"name": material.name, "pbrMetallicRoughness": pbr}
            if material.alpha < 1.0:
                content |= {"alphaMode": "BLEND", "doubleSided": True}
            if material.emission > 0.0:
                content["emissiveFactor"] = [round(material.emission * c, 6) for c in linear(material.color)]
            if material.texture:
                content = self.textures.dressed(material, content)
            self.materials.append(content)
            self._material_index[material] = len(self.materials) - 1
        return self._material_index[material]

    def finish(self, root: int, licences: Sequence[dict[str, str]]) -> bytes:
        """Write header, JSON chunk and binary chunk (glTF 2.0, 4.4)."""
        asset: Json = {"version": "2.0", "generator": "Mansion", "copyright": "; ".join(licence_lines(licences))}
        if licences:
            asset["extras"] = {"licences": list(licences)}
        document: Json = {"asset": asset, "scene": 0, "scenes": [{"nodes": [root]}], "nodes": self.nodes}
        views, data = self.buffer.finish()
        if self.meshes:
            document |= {
                "meshes": self.meshes,
                "materials": self.materials,
                **self.textures.document(),
                "accessors": self.buffer.accessors,
                "bufferViews": views,
                "buffers": [{"byteLength": len(data)}],
            }
        text = json.dumps(document, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        chunks = len(text).to_bytes(4, "little") + b"JSON" + text
        if data:
            chunks += len(data).to_bytes(4, "little") + b"BIN\0" + data
        return b"glTF" + (2).to_bytes(4, "little") + (12 + len(chunks)).to_bytes(4, "little") + chunks


def _placed(node: Node, mesh: int) -> Json:
    content: Json = {"name": node.id, "mesh": mesh}
    if any(node.position):
        x, y, z = node.position
        content["translation"] = [round(x, 5), round(z, 5), round(-y, 5)]
    if node.rotation % 360.0:
        content["rotation"] = gltf_quaternion(node.rotation)
    if node.scale != (1.0, 1.0, 1.0):
        w, d, h = node.scale
        content["scale"] = [round(w, 6), round(h, 6), round(d, 6)]
    extras: Json = {}
    if node.room and node.room != node.id:
        extras["room"] = node.room
    if node.label:
        x, y, z = node.label_at
        extras |= {"label": list(node.label), "label_at": [x, z, -y]}
    if extras:
        content["extras"] = extras
    return content


def gltf_points(points: npt.ArrayLike) -> npt.NDArray[np.float32]:
    """Return z-up points or directions of shape (n, 3) in glTF's y-up axes."""
    array = np.asarray(points, dtype=np.float32).reshape(-1, 3)
    return np.ascontiguousarray(np.stack([array[:, 0], array[:, 2], -array[:, 1]], axis=1))


def gltf_quaternion(rotation: float) -> list[float]:
    """Return a rotation about the vertical (degrees counter-clockwise) as glTF's (x, y, z, w)."""
    half = np.radians(rotation) / 2.0
    return [0.0, round(float(np.sin(half)), 7), 0.0, round(float(np.cos(half)), 7)]
