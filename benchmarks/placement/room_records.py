"""Records of rooms and of objects to place, as the placement benchmark writes them."""

from typing import Any

__all__ = ["Json", "box", "obj", "room"]

Json = dict[str, Any]


def obj(
    name: str,
    size: tuple[float, float, float],
    quantity: int = 1,
    where: str = "unconstrained",
    *,
    matrix: tuple[int, int] | None = None,
    paired: str | None = None,
    **relative: str,
) -> Json:
    """Return an object record; keyword arguments are relations, ``near="bed"``."""
    structure: Json = {"kind": "single"}
    if matrix:
        structure = {"kind": "matrix", "rows": matrix[0], "cols": matrix[1]}
        quantity = matrix[0] * matrix[1]
    if paired:
        structure = {"kind": "paired", "with": paired}
    return {
        "name": name,
        "category": name.replace("_", " "),
        "size": list(size),
        "quantity": quantity,
        "global": where,
        "structure": structure,
        "relative": [{"kind": k, "target": t} for k, t in relative.items()],
    }


def room(
    room_id: str,
    room_type: str,
    polygon: list[tuple[float, float]],
    doors: list[tuple[tuple[float, float], tuple[float, float]]],
    objects: list[Json],
    windows: list[tuple[tuple[float, float], tuple[float, float]]] = [],  # noqa: B006
    holes: list[list[tuple[float, float]]] = [],  # noqa: B006
) -> Json:
    """Return a room record."""
    return {
        "room_id": room_id,
        "room_type": room_type,
        "polygon": polygon,
        "doors": [{"id": f"door_{i}", "segment": s} for i, s in enumerate(doors)],
        "windows": [{"id": f"window_{i}", "segment": s} for i, s in enumerate(windows)],
        "holes": holes,
        "objects": objects,
    }


def box(w: float, h: float) -> list[tuple[float, float]]:
    """Return a rectangle from the origin."""
    return [(0, 0), (w, 0), (w, h), (0, h)]
