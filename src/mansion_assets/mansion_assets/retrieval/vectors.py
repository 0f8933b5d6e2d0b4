"""Embedding vectors of a catalogue, cached in memory and on disk, and picture vectors from a file."""

import hashlib
import io
import json
import zipfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import numpy.typing as npt

from mansion_assets.catalogue import Asset, Catalogue
from mansion_assets.catalogue.descriptions import description_of
from mansion_assets.retrieval.encoders import TextEncoder, unit_rows
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import write_atomic

__all__ = ["CatalogueVectors", "asset_text", "phrases_of", "picture_vectors"]

Vectors = npt.NDArray[np.float32]
Scores = npt.NDArray[np.float64]
Rows = npt.NDArray[np.intp]


@dataclass(frozen=True)
class _Texts:
    """The texts of a catalogue, each once, and which of them are an asset's.

    Attributes
    ----------
    whole : (assets,)
        Row of an asset's text.
    names, starts : (n,), (assets,)
        Rows of all names, asset after asset, and where an asset's begin.
    """

    unique: list[str]
    whole: Rows
    names: Rows
    starts: Rows
    digest: str

    @staticmethod
    def of(catalogue: Catalogue, encoder: str) -> "_Texts":
        assets = list(catalogue.assets.values())
        wholes, names = [asset_text(a) for a in assets], [phrases_of(a) for a in assets]
        unique = list(dict.fromkeys([*wholes, *(name for each in names for name in each)]))
        row = {text: number for number, text in enumerate(unique)}
        digest = hashlib.sha256("\n".join([encoder, *unique]).encode()).hexdigest()[:32]
        return _Texts(
            unique,
            np.array([row[text] for text in wholes]),
            np.array([row[name] for each in names for name in each]),
            np.cumsum([0, *(len(each) for each in names[:-1])]),
            digest,
        )


def asset_text(asset: Asset) -> str:
    """Return the text that stands for an asset."""
    category = asset.category.replace("_", " ")
    names = dict.fromkeys([asset.name, category, *asset.synonyms, *asset.tags])
    material = asset.material.replace("_", " ")
    known = description_of(asset.category)
    return ", ".join(names) + "".join(f"; {more}" for more in (known.called, known.use, known.look, material) if more)


def phrases_of(asset: Asset) -> list[str]:
    """Return what an asset is called, what it is used for and what it looks like, each phrase once."""
    known = description_of(asset.category)
    said = [*known.called.split("; "), *known.use.split("; "), known.look]
    names = [asset.name, asset.category.replace("_", " "), *asset.synonyms]
    return list(dict.fromkeys(phrase for phrase in (*names, *said) if phrase))


class CatalogueVectors:
    """Text vectors of catalogues by one encoder.

    Parameters
    ----------
    encoder : TextEncoder
    cache : Path, optional
        Folder for files named by a digest of the model's name and the catalogue's texts. One that cannot be read or
        written costs time, not answers.

    Notes
    -----
    Every name of an asset is embedded beside its whole text: one name that says what the query says is not drowned
    by the others.
    """

    def __init__(self, encoder: TextEncoder, cache: Path | None = None) -> None:
        self._encoder, self._cache = encoder, cache
        self._kept: dict[str, Vectors] = {}
        self._texts: dict[int, tuple[Catalogue, _Texts]] = {}

    def likeness(self, catalogue: Catalogue, asked: Vectors) -> Scores:
        """Return how similar each asset is to a query, shape (assets,), in the catalogue's order.

        It is the mean of two cosines: with the asset's text, and with that of its names which is most like it.

        Parameters
        ----------
        asked : (d,) unit vector

        Raises
        ------
        MansionError
            ``UNAVAILABLE`` when the encoder gives no vectors, or of another dimension than the query's.
        """
        texts = self._texts_of(catalogue)
        cosines = (self._vectors(texts, len(asked)) @ asked).astype(np.float64)
        named: Scores = np.maximum.reduceat(cosines[texts.names], texts.starts)
        return (cosines[texts.whole] + named) / 2

    def _vectors(self, texts: "_Texts", dimension: int) -> Vectors:
        kept = self._kept.get(texts.digest)
        if kept is None:
            kept = self._read(texts.digest, len(texts.unique))
        if kept is None or kept.shape[1] != dimension:
            kept = self._encoder.encode(texts.unique)
            if kept.shape[1] != dimension:
                raise MansionError(
                    ErrorCode.UNAVAILABLE,
                    f"{self._encoder.name} gave {dimension} numbers for the query and {kept.shape[1]} for an asset",
                )
            self._write(texts.digest, kept)
        self._kept[texts.digest] = kept
        return kept

    def _texts_of(self, catalogue: Catalogue) -> "_Texts":
        known = self._texts.get(id(catalogue))
        if known is None or known[0] is not catalogue:
            known = (catalogue, _Texts.of(catalogue, self._encoder.name))
            self._texts[id(catalogue)] = known
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
