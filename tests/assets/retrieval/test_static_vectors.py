"""Texts are embedded as the mean of the vectors of their subwords."""

import json
from pathlib import Path

import numpy as np
import pytest

from mansion_assets.retrieval import static_vectors
from mansion_assets.retrieval.configured import configured_retriever
from mansion_assets.retrieval.static_vectors import StaticEncoder, packaged_encoder
from mansion_msgs_py.errors import MansionError

SUBWORDS = ["\u2581", "a", "b", "\u2581a", "\u2581ab"]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """Return a package's folder with five subwords, each along an axis of its own."""
    (tmp_path / "tokenizers").mkdir()
    (tmp_path / "weights").mkdir()
    rules = {"vocab": {text: number for number, text in enumerate(SUBWORDS)}, "merges": ["\u2581 a", "\u2581a b"]}
    (tmp_path / "tokenizers/l2_supercat_tokenizer_config.json").write_text(json.dumps({"model": rules}))
    rows = np.eye(5, dtype=np.float16)
    header = json.dumps({"rows": {"dtype": "F16", "shape": [5, 5], "data_offsets": [0, rows.nbytes]}}).encode()
    file = tmp_path / "weights/l2_supercat_256.safetensors"
    file.write_bytes(len(header).to_bytes(8, "little") + header + rows.tobytes())
    return tmp_path


def axes(folder: Path, text: str) -> list[str]:
    """Return the subwords whose vectors a text's vector is made of."""
    (row,) = StaticEncoder(folder).encode([text])
    return [SUBWORDS[number] for number in np.flatnonzero(row)]


def test_neighbours_are_merged_into_the_longest_subword(folder: Path) -> None:
    assert axes(folder, "ab") == ["\u2581ab"]
    assert axes(folder, "ba") == ["\u2581", "a", "b"]


def test_vectors_have_length_one_and_letters_unknown_are_left_out(folder: Path) -> None:
    rows = StaticEncoder(folder).encode(["ab a", "ab", "z", ""])
    assert np.allclose(np.linalg.norm(rows, axis=1), 1.0)
    assert axes(folder, "abz") == ["\u2581ab"]


def test_damaged_files_are_unavailable(folder: Path) -> None:
    (folder / "weights/l2_supercat_256.safetensors").write_bytes(b"short")
    with pytest.raises(MansionError, match="holds no word vectors"):
        StaticEncoder(folder).encode(["a"])


def test_the_extra_is_named_where_the_package_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(static_vectors.importlib.util, "find_spec", lambda _: None)
    with pytest.raises(MansionError, match="extras vectors"):
        packaged_encoder()
    with pytest.raises(MansionError, match="extras vectors"):
        configured_retriever({"MANSION_EMBEDDINGS_MODEL": "wordllama"})
