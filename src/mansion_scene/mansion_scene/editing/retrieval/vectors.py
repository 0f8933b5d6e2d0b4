"""Vectors of a catalogue: embedded once, kept in memory and on disk; and vectors of pictures from a file."""

import hashlib
import io
import json
import zipfile
from pathlib import Path

import numpy as np
import numpy.typing as npt

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import write_atomic
from mansion_scene.catalogue import Asset, Catalogue
from mansion_scene.editing.retrieval.encoders import TextEncoder, unit_rows

__all__ = ["CatalogueVectors", "asset_text", "picture_vectors"]

Vectors = npt.NDArray[np.float32]


def asset_text(asset: Asset) -> str:
    """Return the text that stands for an asset."""
    category = asset.category.replace("_", " ")
    names = dict.fromkeys([asset.name, category, *asset.synonyms, *asset.tags])
    look = asset.material.replace("_", " ")
    return ", ".join(names) + (f"; {look}" if look else "")


class CatalogueVectors:
    """Text vectors of catalogues by one encoder.

    Parameters
    ----------
    encoder : TextEncoder
    cache : Path, optional
        Folder for files named by a digest of the model's name and the catalogue's texts. One that cannot be read or
        written costs time, not answers.
    """

    def __init__(self, encoder: TextEncoder, cache: Path | None = None) -> None:
        self._encoder, self._cache = encoder, cache
        self._kept: dict[str, Vectors] = {}
        self._digests: dict[int, tuple[Catalogue, str]] = {}

    def of(self, catalogue: Catalogue, dimension: int) -> Vectors:
        """Return unit vectors, shape (assets, dimension), in the catalogue's order.

        Raises
        ------
        MansionError
            ``UNAVAILABLE`` when the encoder gives none, or gives vectors of another dimension than the query's.
        """
        digest = self._digest(catalogue)
        kept = self._kept.get(digest)
        if kept is None:
            kept = self._read(digest, len(catalogue.assets))
        if kept is None or kept.shape[1] != dimension:
            # A text is often the same for several assets; each is embedded once.
            texts = [asset_text(asset) for asset in catalogue.assets.values()]
            unique = list(dict.fromkeys(texts))
            rows = dict(zip(unique, self._encoder.encode(unique), strict=True))
            kept = np.array([rows[text] for text in texts], dtype=np.float32)
            if kept.shape[1] != dimension:
                raise MansionError(
                    ErrorCode.UNAVAILABLE,
                    f"{self._encoder.name} gave {dimension} numbers for the query and "
                    f"{kept.shape[1]} for an asset",
                )
            self._write(digest, kept)
        self._kept[digest] = kept
        return kept

    def _digest(self, catalogue: Catalogue) -> str:
        known = self._digests.get(id(catalogue))
        if known is None or known[0] is not catalogue:
            lines = [f"{key} {asset_text(asset)}" for key, asset in catalogue.assets.items()]
            text = "\n".join([self._encoder.name, *lines])
            known = (catalogue, hashlib.sha256(text.encode()).hexdigest()[:32])
            self._digests[id(catalogue)] = known
        return known[1]

    def _read(self, digest: str, count: int) -> Vectors | None:
        if self._cache is None:
            return None
        try:
            stored = np.load(self._cache / f"{digest}.npy", allow_pickle=False)
            return unit_rows(stored, count, digest)
        except (OSError, ValueError, EOFError, MansionError):
            return None

    def _write(self, digest: str, vectors: Vectors) -> None:
        if self._cache is None:
            return
        stream = io.BytesIO()
        np.save(stream, vectors, allow_pickle=False)
        try:
            write_atomic(self._cache / f"{digest}.npy", stream.getvalue())
        except OSError:
            return


def picture_vectors(file: Path) -> dict[str, Vectors]:
    """Read a vector for each asset key from a ``.npz`` (an array for each key) or ``.json`` (an object of arrays) file.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for no such file, ``INVALID_PAYLOAD`` for one of another form.
    """
    if not file.is_file():
        raise MansionError(ErrorCode.NOT_FOUND, f"there is no file of asset embeddings {file}")
    try:
        if file.suffix == ".json":
            raw = dict(json.loads(file.read_text(encoding="utf-8")))
        else:
            with np.load(file, allow_pickle=False) as archive:
                raw = {key: archive[key] for key in archive.files}
        rows = unit_rows([raw[key] for key in raw], len(raw), file.name)
    except (ValueError, TypeError, AttributeError, OSError, EOFError, zipfile.BadZipFile) as error:
        raise _unfit(file, str(error)[:200]) from None
    except MansionError as error:
        raise _unfit(file, error.info.message) from None
    return dict(zip(raw, rows, strict=True))


def _unfit(file: Path, why: str) -> MansionError:
    return MansionError(
        ErrorCode.INVALID_PAYLOAD,
        f"{file} must hold one vector for each asset key, all of one length (.npz or .json): {why}",
    )
