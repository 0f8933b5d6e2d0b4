"""Small rooms lie around passages, so that the rooms between which they stand are rectangles."""

import pytest

from mansion_geometry.randomness import item_generator
from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.program.blocks import Block, lay_block
from mansion_planner.program.building import PlannedBuilding, plan_program
from mansion_planner.program.model import Placement, box_area, short_edges
from mansion_planner.program.plan_quality import fill
from mansion_planner.program.planned_rooms import planned_room
from mansion_planner.program.side_passages import PASSAGE, Wish, cluster_layout, cluster_width

BRIEFS = (
    "a two-storey school with six classrooms, two laboratories and four storage rooms",
    "a single-storey laboratory of 450 m2 with three labs, two storage rooms and toilets",
    "a museum of 600 m2 with four exhibition rooms, a cloakroom and storage",
    "a two-storey town hall with a council chamber, six offices, an archive and two storage rooms",
)


def planned(text: str) -> PlannedBuilding:
    knowledge = default_knowledge()
    request = BuildRequest(description=text)
    return plan_program(request, read_brief(text, knowledge), knowledge, "b", item_generator(0, "program"))


def rooms_to_work_in(building: PlannedBuilding) -> list[Placement]:
    return [p for s in building.sketches.values() for p in s.rooms if p.boxes and p.room.kind.daylight]


@pytest.mark.parametrize("brief", BRIEFS)
def test_rooms_to_work_in_are_rectangles_beside_small_rooms(brief: str) -> None:
    rooms = rooms_to_work_in(planned(brief))
    cut = [placement.room.id for placement in rooms if fill(placement.boxes) < 0.97 and not placement.room.suite]
    assert len(cut) <= 1, cut


@pytest.mark.parametrize("brief", BRIEFS)
def test_every_room_at_a_passage_has_a_wall_for_its_door(brief: str) -> None:
    for sketch in planned(brief).sketches.values():
        assert not short_edges(sketch)


def test_the_rooms_of_a_cluster_and_their_passage_fill_their_block() -> None:
    wishes = (Wish(12.0, 1.6, 1.6), Wish(9.0, 1.6, 1.6), Wish(5.0, 1.6, 2.0))
    width = cluster_width(wishes, 6.0)
    laid = cluster_layout(wishes, width, 6.0)
    assert sum(map(box_area, (*laid.rooms, laid.passage))) == pytest.approx(width * 6.0)
    assert laid.passage[2] - laid.passage[0] == pytest.approx(PASSAGE)
    assert laid.passage[1] == 0.0  # it opens to the corridor


def test_rooms_of_a_cluster_are_about_as_large_as_asked_for_and_no_strips() -> None:
    wishes = tuple(Wish(area, 1.6, 1.6) for area in (11.0, 9.0))
    laid = cluster_layout(wishes, cluster_width(wishes, 6.0), 6.0)
    for wish, box in zip(wishes, laid.rooms):
        short, long = sorted((box[2] - box[0], box[3] - box[1]))
        assert box_area(box) == pytest.approx(wish.area, rel=0.25)
        assert long < 2.7 * short


@pytest.mark.parametrize("depth", [2.5, 3.0, 4.5])
def test_a_wheelchair_turns_in_a_toilet_beside_another_room_however_shallow_their_band(depth: float) -> None:
    knowledge = default_knowledge()
    toilet, bakery = (planned_room(knowledge.room(name), knowledge) for name in ("accessible_toilet", "bakery"))
    laid = {room.id: boxes for room, boxes in lay_block(Block(bakery, (toilet,)), 40.0 / depth, depth)}
    (box,) = laid["accessible_toilet"]
    short, long = sorted((box[2] - box[0], box[3] - box[1]))
    assert short >= 1.6 and long >= 2.3
    assert sum(map(box_area, [box, *laid["bakery"]])) == pytest.approx(40.0)
