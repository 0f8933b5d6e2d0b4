"""What a model does for an open wish counts only where it can be looked up and is all that was done."""

from typing import Any

import pytest

WISH = "make the hall feel cosier"
OPEN = {"statements": [{"kind": "other", "quote": WISH}]}
PLANT = {"thought": "a plant", "tool": "PlaceOnSurface"}
DONE = {"thought": "done", "finished": True}
ADDED = {"kind": "add", "quote": "cosier", "things": {"noun": "house plant"}, "place": {"rooms": {"words": "hall"}}}


@pytest.fixture
def plant(model: Any) -> dict[str, Any]:
    """Return the turn that places a plant in the hall."""
    asset = model.editor.catalogue.by_category("house_plant")[0].key
    return {**PLANT, "arguments": {"asset_id": asset, "receptacle_id": "F1/hall"}}


def plants(model: Any) -> list[str]:
    """Return the plants of the building."""
    return [item.id for _, item in model.editor.state.objects() if item.category == "house_plant"]


def test_what_a_model_says_it_has_done_is_looked_up_and_told(model: Any, plant: dict[str, Any]) -> None:
    report = model.does(WISH, OPEN, plant, {**DONE, "statements": [ADDED]})
    assert report.done and report.saved and plants(model) == ["F1/hall/house_plant_1"]
    assert "leaves open what to do" in report.message and "F1/hall/house_plant_1" in report.message


def test_its_word_alone_does_not_count(model: Any, plant: dict[str, Any]) -> None:
    report = model.does(WISH, OPEN, plant, DONE)
    assert not report.done and model.editor.store.log() == [] and not plants(model)
    report = model.does(WISH, OPEN, {**DONE, "statements": [ADDED]})
    assert not report.done and "nothing was changed" in report.failed[0]


def test_what_it_does_not_tell_of_drops_everything(model: Any, plant: dict[str, Any]) -> None:
    hidden = {"thought": "out", "tool": "RemoveObject", "arguments": {"object_id": "F1/hall/sofa_1"}}
    report = model.does(WISH, OPEN, plant, hidden, {**DONE, "statements": [ADDED]})
    assert not report.done and "F1/hall/sofa_1" in report.failed[0]
    assert model.editor.store.log() == [] and model.editor.state.find("F1/hall/sofa_1") is not None


def test_nothing_is_removed_that_no_word_asks_to_remove(model: Any) -> None:
    gone = {"thought": "out", "tool": "RemoveObject", "arguments": {"object_id": "F1/hall/sofa_1"}}
    told = {"kind": "remove", "quote": "cosier", "things": {"noun": "sofa", "definite": True}}
    report = model.does(WISH, OPEN, gone, {**DONE, "statements": [told]})
    assert not report.done and model.editor.state.find("F1/hall/sofa_1") is not None


def test_an_action_that_failed_last_is_no_end(model: Any, plant: dict[str, Any]) -> None:
    broken = {
        "thought": "more",
        "tool": "PlaceOnSurface",
        "arguments": {"asset_id": "none", "receptacle_id": "F1/hall"},
    }
    report = model.does(WISH, OPEN, plant, broken, {**DONE, "statements": [ADDED]})
    assert not report.done and "the last action failed" in report.failed[0] and not plants(model)


def test_what_is_no_tool_is_told_and_changes_nothing(model: Any) -> None:
    shortcut = {"thought": "shortcut", "tool": "ReshapeFloor", "arguments": {"what": "stair", "room_id": "F1/hall"}}
    report = model.does(WISH, OPEN, shortcut, {**DONE, "unmet": ["walls cannot be edited"]})
    assert not report.done and report.failed == [f"{WISH}: walls cannot be edited"]
    assert any("`tool` must be one of" in prompt for prompt in model.prompts)


def test_statements_beside_an_open_wish_land_with_it_or_not_at_all(model: Any, plant: dict[str, Any]) -> None:
    text = f"Open the fridge and {WISH}"
    fridge = {"kind": "set_state", "quote": "Open the fridge", "things": {"noun": "fridge"}, "state": "open"}
    reading = {"statements": [fridge, *OPEN["statements"]]}
    assert not model.does(text, reading, plant, DONE).done
    assert not model.editor.state.get("F1/kitchen/fridge_1")[1].states.get("open")
    report = model.does(text, reading, plant, {**DONE, "statements": [ADDED]})
    assert report.done and model.editor.state.get("F1/kitchen/fridge_1")[1].states["open"]
    assert len(model.editor.store.log()) == 1
