"""The binary buffer of a glTF file: arrays of one kind share a buffer view, and each picture has one of its own.

Few views keep the JSON of a building small, which has thousands of arrays.
"""

from collections.abc import Mapping
from typing import Any, Final, TypeAlias

import numpy as np
import numpy.typing as npt

__all__ = ["Buffer"]

Json: TypeAlias = dict[str, Any]

_COMPONENTS: Final[Mapping[str, int]] = {"float32": 5126, "uint16": 5123, "uint32": 5125}

_VERTICES, _INDICES = 34962, 34963


class Buffer:
    """Collects arrays and pictures.

    Attributes
    ----------
    accessors : list of dict
        What the file's JSON says of the arrays.
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
