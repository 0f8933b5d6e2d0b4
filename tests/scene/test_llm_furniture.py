"""Furniture by a model on loopback: checked against the catalogue, replaced where it stays wrong."""

import importlib.util
import json
import sys
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import msgspec
import pytest

from mansion_assets.catalogue import furnish_request, load_catalogue
from mansion_llm import LlmClient, LlmSettings
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.placement import MatrixStructure, PlacementOpening, PlacementRoom
from mansion_msgs_py.stages import FurnishRequest
from mansion_scene import assembly
from mansion_scene.llm_furniture import ModelChooser, ObjectsAnswer, floor_categories, object_faults, object_items
from mansion_scene.placement import place_room

DESKS: list[dict[str, Any]] = [
    {
        "name": "desk", "category": "office_desk", "quantity": 4, "global": "middle",
        "structure": {"kind": "matrix", "rows": 2, "cols": 2, "with": None}, "relative": [],
    },
    {
        "name": "seat", "category": "office_chair", "quantity": 4, "global": "unconstrained",
        "structure": {"kind": "paired", "rows": None, "cols": None, "with": "desk"}, "relative": [],
    },
    {
        "name": "plant", "category": "house_plant", "quantity": 1, "global": "edge",
        "structure": {"kind": "single"}, "relative": [{"kind": "far", "target": "desk"}],
    },
]  # fmt: skip


@pytest.fixture(scope="session")
def chat() -> ModuleType:
    """Return the module of the chat server."""
    file = Path(__file__).parents[1] / "llm" / "chat_server.py"
    spec = importlib.util.spec_from_file_location("chat_server", file)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


def faults_of(objects: list[dict[str, Any]]) -> list[str]:
    answer = msgspec.convert({"objects": objects}, ObjectsAnswer)
    return [f.text for f in object_faults(answer, load_catalogue(), "open_office", 40.0, (8.0, 5.0))]


def changed(at: int, **values: Any) -> list[dict[str, Any]]:
    return [entry | values if k == at else entry for k, entry in enumerate(DESKS)]


def test_good_objects_have_no_faults_and_become_items() -> None:
    assert faults_of(DESKS) == []
    items = object_items(msgspec.convert({"objects": DESKS}, ObjectsAnswer), set())
    assert [(item.name, item.paired, item.matrix is not None) for item in items] == [
        ("desk", "", True), ("seat", "desk", False), ("plant", "", False),
    ]  # fmt: skip


@pytest.mark.parametrize("size", [(2, 6), (6, 2), (1, 8), (2, 2)])
def test_a_matrix_keeps_its_rows_and_columns(size: tuple[int, int]) -> None:
    rows, cols = size
    structure = {"kind": "matrix", "rows": rows, "cols": cols, "with": None}
    answer = msgspec.convert(
        {"objects": [*changed(0, quantity=rows * cols, structure=structure)[:1], DESKS[1] | {"quantity": rows * cols}]},
        ObjectsAnswer,
    )
    wishes = furnish_request(
        load_catalogue(), "open_office", 120.0, seed=1, extent=(15.0, 8.0), items=object_items(answer, set())
    )
    desk, seat = wishes.floor
    assert (desk.structure, desk.quantity) == (MatrixStructure(rows=rows, cols=cols), rows * cols)
    assert seat.quantity == rows * cols


def test_the_placer_makes_a_matrix_smaller_that_does_not_fit() -> None:
    structure = {"kind": "matrix", "rows": 2, "cols": 6, "with": None}
    answer = msgspec.convert({"objects": changed(0, quantity=12, structure=structure)[:1]}, ObjectsAnswer)
    wishes = furnish_request(
        load_catalogue(), "open_office", 12.0, seed=1, extent=(4.0, 3.0), items=object_items(answer, set())
    )
    ring = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)]
    door = PlacementOpening(id="door", segment=((1.0, 0.0), (2.0, 0.0)), sill=0.0)
    room = PlacementRoom(room_id="r", polygon=ring, doors=[door], objects=list(wishes.floor))
    placed = place_room(room, seed=1)
    assert 1 <= len(placed.placements) < 12


@pytest.mark.parametrize(
    ("objects", "word"),
    [
        ([], "no objects"),
        (changed(0, category="throne"), "category"),
        (changed(0, category="ceiling_panel"), "category"),
        (changed(0, quantity=-4), "quantity"),
        (changed(0, quantity=5), "rows x cols"),
        (changed(0, **{"global": "ceiling"}), "global"),
        (changed(1, structure={"kind": "paired", "with": "sofa"}), "paired"),
        (changed(2, relative=[{"kind": "under", "target": "desk"}]), "relative"),
        (changed(2, name="desk"), "unique"),
        (changed(2, name="rm -rf /"), "snake case"),
        (changed(0, quantity=200, structure={"kind": "matrix", "rows": 20, "cols": 10}), "m2 of floor"),
        (DESKS * 10, "at most"),
    ],
)
def test_faults_are_named(objects: list[dict[str, Any]], word: str) -> None:
    assert any(word in text for text in faults_of(objects))


def test_a_dropped_object_takes_its_accessories_and_relations_along() -> None:
    items = object_items(msgspec.convert({"objects": DESKS}, ObjectsAnswer), {"desk"})
    assert [(item.name, item.relative) for item in items] == [("plant", [])]


def test_offered_categories_stand_on_the_floor() -> None:
    names = floor_categories(load_catalogue())
    assert "office_desk" in names and "ceiling_panel" not in names


def furnished(
    chat: ModuleType, request: FurnishRequest, answer: Callable[[str], Any], monkeypatch: pytest.MonkeyPatch, tape: Path
) -> Any:
    def script(asked: dict[str, Any]) -> Any:
        content = answer(str(asked["messages"][1]["content"]))
        return chat.Reply(content if isinstance(content, str) else json.dumps(content))

    request = msgspec.structs.replace(request, planner="llm", description="an office")
    with chat.ChatServer(script) as server:
        settings = LlmSettings(base_url=server.url, model="m", repairs=0, record=tape)
        monkeypatch.setattr(LlmClient, "from_environment", classmethod(lambda cls: cls(settings)))
        live = assembly.furnish_floor(request)
    monkeypatch.setattr(LlmClient, "from_environment", classmethod(lambda cls: cls(LlmSettings(replay=tape))))
    assert encode_bytes(assembly.furnish_floor(request)) == encode_bytes(live)
    return live


def test_a_floor_is_furnished_by_the_model_and_replays_to_the_same_bytes(
    chat: ModuleType, sample_floors: ModuleType, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    plants = {"objects": [DESKS[2] | {"relative": []}]}
    request = sample_floors.office()
    scene = furnished(chat, request, lambda text: plants, monkeypatch, tmp_path / "tape")
    assert set(scene.sources.values()) <= {"llm", "rules: such rooms stay empty"}
    assert "llm" in scene.sources.values() and scene.llm.answers > 0
    standing = {item.category for item in scene.objects if item.mount == "floor" and item.parent is None}
    assert standing == {"house_plant"}


def test_rooms_whose_answer_is_useless_keep_their_types_furniture(
    chat: ModuleType, sample_floors: ModuleType, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    request = sample_floors.office()
    scene = furnished(chat, request, lambda text: "no thanks", monkeypatch, tmp_path / "tape")
    assert all(source.startswith("rules: ") for source in scene.sources.values())
    rules = assembly.furnish_floor(request)
    assert [item.id for item in scene.objects] == [item.id for item in rules.objects]


def test_without_an_endpoint_the_chooser_says_what_to_set(
    sample_floors: ModuleType, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    for name in ("MANSION_LLM_BASE_URL", "MANSION_LLM_MODEL", "MANSION_LLM_REPLAY", "OPENAI_BASE_URL"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    with pytest.raises(MansionError, match="MANSION_LLM_BASE_URL"):
        ModelChooser.of_request(sample_floors.office(), load_catalogue())
