"""Text vectors that are the mean of fixed vectors of subwords: those that the package ``wordllama`` carries.

Only the package's two data files are read: its code asks for a newer NumPy than ROS 2 Jazzy has. D. L. Miller,
"WordLlama: recycled token embeddings from large language models", 2024.
"""

import importlib.util
import json
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any, Final

import numpy as np
import numpy.typing as npt

from mansion_assets.retrieval.encoders import unit_rows
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["PACKAGED", "StaticEncoder", "packaged_encoder"]

Vectors = npt.NDArray[np.float32]

PACKAGED: Final = "wordllama"
"""Name of the model of the extra ``vectors``."""

_WEIGHTS: Final = "weights/l2_supercat_256.safetensors"
_SUBWORDS: Final = "tokenizers/l2_supercat_tokenizer_config.json"
_START: Final = "\u2581"
"""What stands before the first letter of a word."""


@dataclass(frozen=True)
class _Model:
    """Rows of subwords, their numbers, and the order in which neighbours are merged (byte-pair encoding)."""

    rows: Vectors
    numbers: dict[str, int]
    ranks: dict[tuple[str, str], int]
    words: dict[str, list[int]]

    def of_word(self, word: str) -> list[int]:
        """Return the subwords of a word; letters that none has are left out."""
        if word not in self.words:
            parts = list(_START + word)
            while len(parts) > 1:
                pairs = list(pairwise(parts))
                best = min(pairs, key=lambda pair: self.ranks.get(pair, len(self.ranks)))
                if best not in self.ranks:
                    break
                at = pairs.index(best)
                parts[at : at + 2] = ["".join(best)]
            self.words[word] = [self.numbers[part] for part in parts if part in self.numbers]
        return self.words[word]


class StaticEncoder:
    """`TextEncoder` by means of subword vectors; its files are read with the first text.

    Parameters
    ----------
    folder : Path
        Folder of the package.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._model: _Model | None = None

    @property
    def name(self) -> str:
        """See `TextEncoder.name`."""
        return f"{PACKAGED} {Path(_WEIGHTS).stem}"

    def encode(self, texts: Sequence[str]) -> Vectors:
        """See `TextEncoder.encode`."""
        if self._model is None:
            self._model = _read(self._folder)
        return unit_rows([_mean(self._model, text) for text in texts], len(texts), self.name)


def _mean(model: _Model, text: str) -> Vectors:
    numbers = [number for word in text.split() for number in model.of_word(word)]
    return np.asarray(model.rows[numbers or [model.numbers[_START]]].mean(axis=0), dtype=np.float32)


def packaged_encoder() -> StaticEncoder:
    """Return the encoder of the extra ``vectors``.

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` when the package is not installed.
    """
    found = importlib.util.find_spec(PACKAGED)
    if found is None or not found.submodule_search_locations:
        raise MansionError(
            ErrorCode.UNAVAILABLE,
            f"the model {PACKAGED} needs the extra `vectors`: python -m mansion_bringup.extras vectors",
            details={"extra": "vectors", "package": PACKAGED},
        )
    return StaticEncoder(Path(found.submodule_search_locations[0]))


def _read(folder: Path) -> _Model:
    try:
        rules = json.loads((folder / _SUBWORDS).read_text(encoding="utf-8"))["model"]
        rows = _tensor((folder / _WEIGHTS).read_bytes())
        merges = [merge.split(" ") if isinstance(merge, str) else merge for merge in rules["merges"]]
        ranks = {(one, other): rank for rank, (one, other) in enumerate(merges)}
        return _Model(rows, dict(rules["vocab"]), ranks, {})
    except (OSError, ValueError, KeyError, TypeError) as error:
        raise MansionError(
            ErrorCode.UNAVAILABLE, f"{folder} holds no word vectors of {PACKAGED}: {str(error)[:200]}"
        ) from None


def _tensor(raw: bytes) -> Vectors:
    """Return the only tensor of a safetensors file: a header's length, the header as JSON, the numbers."""
    start = 8 + int.from_bytes(raw[:8], "little")
    header: dict[str, Any] = json.loads(raw[8:start])
    (entry,) = (value for name, value in header.items() if name != "__metadata__")
    kind = {"F16": np.float16, "F32": np.float32}[entry["dtype"]]
    first, last = entry["data_offsets"]
    return np.frombuffer(raw[start + first : start + last], kind).reshape(entry["shape"]).astype(np.float32)
