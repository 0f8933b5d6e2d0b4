"""Textures of a binary glTF file: each picture once, and what materials say of them."""

import hashlib
from typing import Any, TypeAlias

from mansion_assets.materials import texture_set
from mansion_export.gltf_buffer import Buffer
from mansion_export.materials import linear
from mansion_export.model import Material

__all__ = ["Textures"]

Json: TypeAlias = dict[str, Any]


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
        """Return a material's glTF form with its set of textures: colour, normals, occlusion, roughness and metal."""
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
        """Return what the file's JSON says of pictures."""
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
