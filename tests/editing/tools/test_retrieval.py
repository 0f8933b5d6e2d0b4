"""SearchAssets ranks by embeddings where a model is named, and by words where the model fails."""

import hashlib
import json
import re
import sys
import threading
from collections.abc import Callable, Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from mansion_assets.catalogue import Catalogue
from mansion_assets.retrieval.configured import configured_retriever
from mansion_assets.retrieval.embedding_retriever import EmbeddingRetriever
from mansion_assets.retrieval.encoders import FolderEncoder
from mansion_assets.retrieval.retriever import TextRetriever
from mansion_editing.state import SceneState
from mansion_editing.tools.perception import search_assets
from mansion_msgs_py.editing.questions import SearchAssetsArgs
from mansion_msgs_py.errors import MansionError

SIZE = 64
Answer = Callable[[list[str]], tuple[int, Any]]
MEANINGS = {"brew": "coffee", "espresso": "coffee"}


def embed(text: str, size: int = SIZE) -> list[float]:
    """Return a bag of words, where words of one meaning share a place."""
    vector = [0.0] * size
    for word in re.findall(r"[a-z]+", text.lower()) or ["none"]:
        digest = hashlib.sha256(MEANINGS.get(word, word).encode()).digest()
        vector[int.from_bytes(digest[:4], "big") % size] += 1.0
    return vector


def good(texts: list[str]) -> tuple[int, Any]:
    rows = [{"object": "embedding", "index": i, "embedding": embed(t)} for i, t in enumerate(texts)]
    return 200, {"object": "list", "model": "bag", "data": rows[::-1], "usage": {}}


class Endpoint:
    """An embeddings endpoint on loopback; it ends with the test."""

    def __init__(self) -> None:
        self.answer: Answer = good
        self.asked: list[dict[str, Any]] = []
        owner = self

        class Handler(BaseHTTPRequestHandler):
            def do_POST(self) -> None:
                body = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
                owner.asked.append({"path": self.path, **body})
                status, reply = owner.answer(body["input"])
                data = json.dumps(reply).encode()
                self.send_response(status)
                self.send_header("Content-Type", "application/json")
                self.send_header("Content-Length", str(len(data)))
                self.end_headers()
                self.wfile.write(data)

            def log_message(self, *_: object) -> None:
                """Stay silent."""

        self.server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.server.daemon_threads = True
        self.url = f"http://127.0.0.1:{self.server.server_port}/v1"


@pytest.fixture
def endpoint() -> Iterator[Endpoint]:
    """Serve embeddings while a test runs."""
    pytest.importorskip("openai")
    serving = Endpoint()
    threading.Thread(target=serving.server.serve_forever, args=(0.02,), daemon=True).start()
    yield serving
    serving.server.shutdown()
    serving.server.server_close()


@pytest.fixture
def environment(endpoint: Endpoint, tmp_path: Path) -> dict[str, str]:
    """Return the variables that name the endpoint."""
    return {
        "MANSION_EMBEDDINGS_BASE_URL": endpoint.url,
        "MANSION_EMBEDDINGS_MODEL": "bag",
        "MANSION_EMBEDDINGS_TIMEOUT": "10",
        "MANSION_EMBEDDINGS_CACHE": str(tmp_path / "vectors"),
    }


@pytest.fixture
def small(catalogue: Catalogue) -> Catalogue:
    """Return a catalogue of few things, so that few vectors are asked for."""
    names = ("mug", "coffee_machine", "sofa", "fridge", "dining_table", "floor_lamp", "apple")
    return Catalogue([a for name in names for a in catalogue.by_category(name)[:3]], [], [])


def first(catalogue: Catalogue, environment: dict[str, str], query: str) -> tuple[str, str]:
    """Return the category of the best hit, and the note."""
    found = configured_retriever(environment).retrieve(catalogue, query, 3, ())
    return found.hits[0].asset.category if found.hits else "", found.note


def test_without_a_model_words_are_searched() -> None:
    assert isinstance(configured_retriever({}), TextRetriever)


def test_a_meaning_is_found_that_no_word_names(
    small: Catalogue, environment: dict[str, str], endpoint: Endpoint
) -> None:
    query = "espresso machine to brew"
    assert first(small, environment, query) == ("coffee_machine", "")
    assert endpoint.asked[0]["path"] == "/v1/embeddings"
    assert endpoint.asked[0]["input"] == [query] and endpoint.asked[0]["model"] == "bag"


def test_the_catalogue_is_embedded_once_and_kept_on_disk(
    small: Catalogue, environment: dict[str, str], endpoint: Endpoint
) -> None:
    retriever = configured_retriever(environment)
    cold = retriever.retrieve(small, "a mug", 5, ())
    assert retriever.retrieve(small, "a mug", 5, ()) == cold
    assert configured_retriever(environment).retrieve(small, "a mug", 5, ()) == cold
    assert [len(request["input"]) > 1 for request in endpoint.asked] == [False, True, False, False]
    first(small, {**environment, "MANSION_EMBEDDINGS_MODEL": "other"}, "a mug")
    assert len(endpoint.asked[-1]["input"]) > 1


def test_a_damaged_file_of_vectors_is_made_anew(
    small: Catalogue, environment: dict[str, str], endpoint: Endpoint, tmp_path: Path
) -> None:
    first(small, environment, "sofa")
    (file,) = (tmp_path / "vectors").iterdir()
    good_bytes = file.read_bytes()
    file.write_bytes(good_bytes[:100])
    assert first(small, environment, "sofa") == ("sofa", "")
    assert file.read_bytes() == good_bytes


def test_properties_filter_as_in_the_search_by_words(small: Catalogue, environment: dict[str, str]) -> None:
    retriever = configured_retriever(environment)
    hits = retriever.retrieve(small, "sofa", 50, ["CanPickup"]).hits
    assert hits and all(hit.asset.pickupable for hit in hits)
    with pytest.raises(MansionError, match="unknown property"):
        retriever.retrieve(small, "sofa", 5, ["edible"])


def short_for_assets(texts: list[str]) -> tuple[int, Any]:
    status, reply = good(texts)
    if len(texts) > 1:
        reply["data"] = [{**row, "embedding": [1.0] * 5} for row in reply["data"]]
    return status, reply


def ragged(texts: list[str]) -> tuple[int, Any]:
    status, reply = good(texts)
    reply["data"][0]["embedding"] = [1.0, 2.0]
    return status, reply


def zeros(texts: list[str]) -> tuple[int, Any]:
    rows = [{"index": i, "embedding": [0.0] * SIZE} for i in range(len(texts))]
    return 200, {"data": rows}


@pytest.mark.parametrize(
    ("answer", "reason"),
    [
        (lambda texts: (500, {"error": {"message": "out of memory"}}), "500"),
        (lambda texts: (404, {"error": {"message": "no such model"}}), "404"),
        (lambda texts: (200, {"data": []}), "embedding"),
        (lambda texts: (200, {"hello": 1}), "embedding"),
        (lambda texts: (200, {"data": [{"index": 0, "embedding": "soup"}]}), "embeddings"),
        (short_for_assets, "5 for an asset"),
        (ragged, "different lengths"),
        (zeros, "zero"),
    ],
)
def test_a_wrong_answer_falls_back_to_words_and_says_why(
    state: SceneState, small: Catalogue, environment: dict[str, str], endpoint: Endpoint, answer: Answer, reason: str
) -> None:
    endpoint.answer = answer
    state = SceneState([], small, configured_retriever(environment))
    args = SearchAssetsArgs(query="a sofa", top_k=3)
    reply = search_assets(state, args)
    assert reply.assets == search_assets(SceneState([], small), args).assets
    assert "found by words alone" in reply.message and reason in reply.message


def test_an_endpoint_that_keeps_failing_is_left_alone(
    small: Catalogue, environment: dict[str, str], endpoint: Endpoint
) -> None:
    endpoint.answer = lambda texts: (500, {})
    retriever = configured_retriever(environment)
    notes = [retriever.retrieve(small, "sofa", 1, ()).note for _ in range(5)]
    assert len(endpoint.asked) == 3 and "no longer asked" in notes[-1]


@pytest.mark.parametrize("ending", ["npz", "json"])
def test_pictures_decide_among_assets_alike_in_words(
    small: Catalogue, environment: dict[str, str], tmp_path: Path, ending: str
) -> None:
    mugs = [asset.key for asset in small.by_category("mug")]
    looks = {key: embed("stripes" if key == mugs[-1] else "plain") for key in small.assets}
    file = tmp_path / f"pictures.{ending}"
    if ending == "json":
        file.write_text(json.dumps(looks))
    else:
        np.savez(file, **{key: np.array(vector) for key, vector in looks.items()})
    shown = configured_retriever({**environment, "MANSION_ASSET_EMBEDDINGS": str(file)})
    found = shown.retrieve(small, "a mug with stripes", 3, ())
    assert found.hits[0].asset.key == mugs[-1] and not found.note


def test_pictures_of_another_model_are_left_out_and_said(
    small: Catalogue, environment: dict[str, str], tmp_path: Path
) -> None:
    file = tmp_path / "pictures.json"
    file.write_text(json.dumps({key: [1.0, 0.5] for key in small.assets}))
    category, note = first(small, {**environment, "MANSION_ASSET_EMBEDDINGS": str(file)}, "sofa")
    assert category == "sofa"
    assert note.startswith("pictures left out") and "MANSION_ASSET_EMBEDDINGS_MODEL" in note


@pytest.mark.parametrize("text", ["[1, 2]", "{", '{"a": [1], "b": [1, 2]}', '{"a": "x"}', "{}"])
def test_a_file_of_another_form_is_refused(environment: dict[str, str], tmp_path: Path, text: str) -> None:
    for ending in ("json", "npz"):
        file = tmp_path / f"pictures.{ending}"
        file.write_text(text)
        with pytest.raises(MansionError) as error:
            configured_retriever({**environment, "MANSION_ASSET_EMBEDDINGS": str(file)})
        assert error.value.code == "INVALID_PAYLOAD"


@pytest.mark.parametrize(
    "variables",
    [
        {"MANSION_EMBEDDINGS_BASE_URL": "http://127.0.0.1:9/v1"},
        {"MANSION_EMBEDDINGS_MODEL": "no-such-folder"},
        {"MANSION_ASSET_EMBEDDINGS": "pictures.npz"},
    ],
)
def test_settings_that_name_half_a_model_are_refused(variables: dict[str, str]) -> None:
    with pytest.raises(MansionError, match="MANSION_EMBEDDINGS_") as error:
        configured_retriever(variables)
    assert error.value.code == "INVALID_PAYLOAD"


def test_a_folder_needs_the_package_and_says_so(
    small: Catalogue, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "sentence_transformers", None)
    with pytest.raises(MansionError, match="pip install sentence-transformers") as error:
        FolderEncoder(tmp_path).encode(["sofa"])
    assert error.value.code == "UNAVAILABLE"
    found = configured_retriever({"MANSION_EMBEDDINGS_MODEL": str(tmp_path)}).retrieve(small, "sofa", 1, ())
    assert found.hits[0].asset.category == "sofa" and "sentence-transformers" in found.note


def test_a_model_in_a_folder_ranks(small: Catalogue, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    class Model:
        def __init__(self, folder: str, *, local_files_only: bool) -> None:
            assert Path(folder) == tmp_path and local_files_only

        def encode(self, texts: list[str], *, show_progress_bar: bool) -> Any:
            return np.array([embed(text) for text in texts], dtype=np.float32)

    package = SimpleNamespace(SentenceTransformer=Model)
    monkeypatch.setitem(sys.modules, "sentence_transformers", package)
    found = EmbeddingRetriever(FolderEncoder(tmp_path)).retrieve(small, "espresso machine", 1, ())
    assert found.hits[0].asset.category == "coffee_machine" and not found.note
