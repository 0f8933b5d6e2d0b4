"""The building itself, named by its kind: ``the lamps in the flat``."""

import msgspec
import pytest

from mansion_assets.catalogue import Catalogue
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import SetState
from mansion_editing.state import SceneState
from mansion_msgs_py.scene import FloorScene


def _called(kind: str, scenes: list[FloorScene], catalogue: Catalogue) -> SceneState:
    return SceneState([msgspec.structs.replace(scene, building_type=kind) for scene in scenes], catalogue)


@pytest.mark.parametrize(
    ("kind", "words"), [("flat", "flat"), ("flat", "apartment"), ("dental_clinic", "clinic"), ("flat", "house")]
)
def test_all_in_it_are_all_there_are(kind: str, words: str, furnished: list[FloorScene], catalogue: Catalogue) -> None:
    read = read_instruction(f"Turn off all lamps in the {words}.", _called(kind, furnished, catalogue))
    (switched,) = read.statements
    assert read.not_understood == []
    assert isinstance(switched, SetState) and switched.things.place is None and switched.things.amount.kind == "all"


@pytest.mark.parametrize(
    ("kind", "words"),
    [("flat", "in the clinic"), ("dental_clinic", "in the flat"), ("flat", "in the flats"), ("office", "in a flat")],
)
def test_another_building_is_not_this_one(
    kind: str, words: str, furnished: list[FloorScene], catalogue: Catalogue
) -> None:
    assert read_instruction(f"Turn off all lamps {words}.", _called(kind, furnished, catalogue)).not_understood


@pytest.mark.parametrize("words", ["next to the building", "in front of the house", "behind the building"])
def test_nothing_is_put_outside_of_it(words: str, furnished: list[FloorScene], catalogue: Catalogue) -> None:
    assert read_instruction(f"Put a bench {words}.", _called("flat", furnished, catalogue)).not_understood
