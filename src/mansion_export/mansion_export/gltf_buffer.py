"""The binary buffer of a glTF file, with its arrays and pictures, and the textures that use these pictures.

Arrays of one kind share a buffer view, which keeps the JSON of a building small: it has thousands of arrays.
"""

import hashlib
from collections.abc import Mapping
from typing import Any, Final, TypeAlias

import numpy as np
import numpy.typing as npt

from mansion_assets.materials import texture_set
from mansion_export.meshes.materials import linear
from mansion_export.meshes.model import Material

__all__ = ["Buffer", "Textures"]

Json: TypeAlias = dict[str, Any]

_COMPONENTS: Final[Mapping[str, int]] = {"float32": 5126, "uint16": 5123, "uint32": 5125}

_VERTICES, _INDICES = 34962, 34963


class Buffer:
    """Collects arrays and pictures.

    Attributes
    ----------
    accessors : list of dict
        The arrays as the file's JSON describes them.
    """

    def __init__(self) -> None:
        self.accessors: list[Json] = []
        self._views: list[Json] = []
        self._data: list[bytearray] = []
        self._by_kind: dict[tuple[str, int], int] = {}

    def array(self, values: npt.NDArray[Any], *, bounds: bool = False) -> int:
        """Append an array and return the index of its accessor.

        Parameters
        ----------
        values : (n,) array of unsigned integers, or (n, 2) or (n, 3) array of float32
            Indices, or what vertices have.
        bounds : bool
            State the lowest and the highest values, which positions need.
        """
        width = values.shape[1] if values.ndim == 2 else 1
        view = self._view(values.dtype.name, width, values.itemsize)
        content: Json = {
            "bufferView": view,
            "byteOffset": len(self._data[view]),
            "componentType": _COMPONENTS[values.dtype.name],
            "count": len(values),
            "type": "SCALAR" if values.ndim == 1 else f"VEC{width}",
        }
        if bounds:
            content |= {"min": _shortest(values.min(0)), "max": _shortest(values.max(0))}
        self._data[view] += values.tobytes()
        self.accessors.append(content)
        return len(self.accessors) - 1

    def picture(self, data: bytes) -> int:
        """Append a picture's file and return the index of its buffer view."""
        self._views.append({"buffer": 0})
        self._data.append(bytearray(data))
        return len(self._views) - 1

    def finish(self) -> tuple[list[Json], bytes]:
        """Return the buffer views and the buffer; each view begins on a multiple of four bytes."""
        views: list[Json] = []
        whole = bytearray()
        for content, data in zip(self._views, self._data):
            views.append({**content, "byteOffset": len(whole), "byteLength": len(data)})
            whole += data + b"\0" * (-len(data) % 4)
        return views, bytes(whole)

    def _view(self, dtype: str, width: int, itemsize: int) -> int:
        if (dtype, width) not in self._by_kind:
            vertices: Json = {"byteStride": width * itemsize, "target": _VERTICES}
            self._views.append({"buffer": 0, **(vertices if width > 1 else {"target": _INDICES})})
            self._data.append(bytearray())
            self._by_kind[dtype, width] = len(self._views) - 1
        return self._by_kind[dtype, width]


def _shortest(values: npt.NDArray[np.float32]) -> list[float]:
    """Return the shortest decimals that are these numbers in single precision."""
    return [float(str(value)) for value in values]


class Textures:
    """Collects the pictures of materials.

    Parameters
    ----------
    buffer : Buffer
        The file's buffer, which takes the pictures.
    """

    def __init__(self, buffer: Buffer) -> None:
        self.images: list[Json] = []
        self.textures: list[Json] = []
        self._buffer = buffer
        self._index: dict[bytes, int] = {}

    def dressed(self, material: Material, plain: Json) -> Json:
        """Return a glTF material with its textures: colour, normals, occlusion, roughness and metalness."""
        made = texture_set(material.texture)
        color = {"index": self._texture(f"{material.texture}_color", made.base)}
        surface = {"index": self._texture(f"{material.texture}_surface", made.surface)}
        pbr = {
            **plain["pbrMetallicRoughness"],
            "baseColorFactor": [*linear(made.tint(material.color)), material.alpha],
            "baseColorTexture": color,
            "metallicRoughnessTexture": surface,
            "roughnessFactor": round(min(1.0, material.roughness / made.roughness), 4),
        }
        content = {**plain, "pbrMetallicRoughness": pbr, "occlusionTexture": surface}
        if material.emission > 0.0:
            content |= {"emissiveTexture": color, "emissiveFactor": [round(material.emission, 6)] * 3}
        if made.normal:
            content["normalTexture"] = {"index": self._texture(f"{material.texture}_normal", made.normal)}
        return content

    def document(self) -> Json:
        """Return the pictures as the file's JSON describes them."""
        if not self.images:
            return {}
        return {"images": self.images, "textures": self.textures, "samplers": [{"wrapS": 10497, "wrapT": 10497}]}

    def _texture(self, name: str, picture: bytes) -> int:
        key = hashlib.sha256(picture).digest()
        if key not in self._index:
            self.images.append({"name": name, "bufferView": self._buffer.picture(picture), "mimeType": "image/jpeg"})
            self.textures.append({"sampler": 0, "source": len(self.images) - 1})
            self._index[key] = len(self.textures) - 1
        return self._index[key]
