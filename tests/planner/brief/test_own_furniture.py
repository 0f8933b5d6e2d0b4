import json
from pathlib import Path

import pytest
from trimesh.creation import box

from mansion_assets.catalogue import preferring
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief.furniture_words import furniture_of, own_furniture_of
from mansion_planner.plan import plan_building


@pytest.fixture
def shop(tmp_path: Path) -> Path:
    (tmp_path / "assets").mkdir()
    (tmp_path / "assets" / "bar.glb").write_bytes(box((1.6, 1.1, 0.6)).export(file_type="glb"))
    record = {"key": "shop.bar", "category": "espresso_bar", "size": (1.6, 0.6, 1.1), "glb": "bar.glb"}
    (tmp_path / "assets" / "bar.json").write_text(json.dumps(record))
    return tmp_path


def test_names_of_preferred_assets_are_furniture_while_they_are_preferred(shop: Path) -> None:
    with preferring([shop]):
        assert furniture_of(("espresso", "bar")) == ("espresso_bar", 2)
        assert own_furniture_of(("big", "espresso", "bar")) == "espresso_bar"
        assert own_furniture_of(("bar",)) == ""
    assert own_furniture_of(("espresso", "bar")) == ""


def test_a_brief_asks_for_a_thing_that_is_a_room_without_the_library(shop: Path) -> None:
    brief = "a small flat with an espresso bar in the kitchen"
    kinds = {}
    for assets in ((), (str(shop),)):
        request = BuildRequest(description=brief, **({"assets": assets} if assets else {}))
        wishes = plan_building(request).program.wishes
        kinds[bool(assets)] = next(wish.kind for wish in wishes if wish.value.name == "espresso_bar")
    assert kinds == {False: "room", True: "object"}


def test_a_request_for_a_library_that_is_not_there_is_refused() -> None:
    with pytest.raises(MansionError, match="there is no library 'nowhere-to-be-found'"):
        plan_building(BuildRequest(description="a small flat", assets=("nowhere-to-be-found",)))
