"""Meshes of a floor named after what they show, so that equal ones of all floors are written once."""

import re
from dataclasses import fields, replace
from hashlib import blake2b

import numpy as np

from mansion_export.model import Mesh, Model, Surface

__all__ = ["named_by_content"]

_FLOOR = re.compile(r"^(F-?\d+/)+")
_NUMBER = re.compile(r"_\d+\b")


def named_by_content(model: Model) -> Model:
    """Return the model with each mesh of one element named after its kind and its content.

    Meshes that are named after an element (``F2/stair_1/landing``) become ``stair/landing:7c1f09aa``, where the equal
    landing of another floor has the same name. Those of assets, doors and windows keep their names, which say what
    they show.
    """
    names = {name: _name(mesh) if _FLOOR.match(name) else name for name, mesh in model.meshes.items()}
    meshes: dict[str, Mesh] = {}
    for name, mesh in model.meshes.items():
        meshes.setdefault(names[name], replace(mesh, name=names[name]))
    return replace(model, nodes=tuple(replace(node, mesh=names[node.mesh]) for node in model.nodes), meshes=meshes)


def _name(mesh: Mesh) -> str:
    kind = _NUMBER.sub("", _FLOOR.sub("", mesh.name))
    return f"{kind}:{_digest(mesh.surfaces)}"


def _digest(surfaces: tuple[Surface, ...]) -> str:
    digest = blake2b(digest_size=8)
    for surface in surfaces:
        for each in fields(surface):
            value = getattr(surface, each.name)
            digest.update(value.tobytes() if isinstance(value, np.ndarray) else repr(value).encode())
    return digest.hexdigest()
