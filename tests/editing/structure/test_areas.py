"""A room has the area that is asked for, and every room that gave nothing stays as it was."""

from collections.abc import Callable

import pytest
import shapely
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from shapely import Polygon

from mansion_bringup.check import check_floors
from mansion_editing.structure import Reshaped, Storey, Workshop, change_area
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import FloorScene

WorkshopOf = Callable[[Storey], Workshop]
ROOMS = ["F1/open_office_1", "F1/meeting_room_1", "F1/office_1", "F1/toilet_1", "F1/storage", "F1/office_2"]


def polygon(scene: FloorScene, room: str) -> Polygon:
    return next(Polygon(entry.polygon, entry.holes) for entry in scene.rooms if entry.id == room)


def objects(scene: FloorScene, room: str) -> list[bytes]:
    return [encode_bytes(item) for item in scene.objects if item.room == room]


def moved_rooms(before: Storey, done: Reshaped) -> set[str]:
    old = {room.id: room for room in before.scene.rooms}
    return {room.id for room in done.storey.scene.rooms if room.polygon != old[room.id].polygon}


@settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(room=st.sampled_from(ROOMS), change=st.floats(-8.0, 12.0).filter(lambda value: abs(value) > 0.5))
def test_an_area_is_met_without_gap_overlap_or_fault_or_refused(
    office: Storey, workshop_of: WorkshopOf, room: str, change: float
) -> None:
    before = polygon(office.scene, room).area
    try:
        done = change_area(office, room, change, workshop_of(office))
    except MansionError as refusal:
        assert refusal.info.code in (ErrorCode.INFEASIBLE, ErrorCode.INVALID_PAYLOAD)
        return
    scene = done.storey.scene
    assert polygon(scene, room).area == pytest.approx(before + change, rel=0.01)
    shapes = [polygon(scene, entry.id) for entry in scene.rooms]
    whole = shapely.union_all([polygon(office.scene, entry.id) for entry in office.scene.rooms])
    assert shapely.union_all(shapes).symmetric_difference(whole).area < 0.01
    assert sum(shape.area for shape in shapes) == pytest.approx(whole.area, abs=0.01)
    assert not list(check_floors(scene.building_id, [scene], [done.storey.topology]))
    changed = moved_rooms(office, done)
    for entry in office.scene.rooms:
        if entry.id not in changed:
            assert objects(scene, entry.id) == objects(office.scene, entry.id)


def test_corridors_and_cores_keep_their_polygons(office: Storey, workshop_of: WorkshopOf) -> None:
    done = change_area(office, "F1/meeting_room_1", 6.0, workshop_of(office))
    assert moved_rooms(office, done) == {"F1/meeting_room_1", "F1/open_office_1"}
    assert [core.polygon for core in done.storey.scene.cores] == [core.polygon for core in office.scene.cores]


def test_several_neighbours_give_what_one_cannot(office: Storey, workshop_of: WorkshopOf) -> None:
    done = change_area(office, "F1/storage", 12.0, workshop_of(office))
    assert {"F1/toilet_1", "F1/office_2"} <= moved_rooms(office, done)


def test_a_room_may_be_asked_to_have_an_area(office: Storey, workshop_of: WorkshopOf) -> None:
    done = change_area(office, "F1/office_2", 27.0, workshop_of(office), absolute=True)
    assert polygon(done.storey.scene, "F1/office_2").area == pytest.approx(27.0, rel=0.01)


def test_all_documents_of_the_storey_say_the_same(office: Storey, workshop_of: WorkshopOf) -> None:
    after = change_area(office, "F1/meeting_room_1", 6.0, workshop_of(office)).storey
    in_layout = {room.id: Polygon(room.polygon).area for room in after.layout.rooms}
    in_graph = {node.id: node.area for node in after.topology.nodes}
    in_program = {room.id: room.area_estimate for room in after.floor.rooms}
    assert in_layout["meeting_room_1"] == pytest.approx(42.0, abs=0.01)
    assert in_graph["meeting_room_1"] == pytest.approx(42.0, abs=0.01)
    assert in_program["meeting_room_1"] == pytest.approx(42.0, abs=0.01)
    assert sum(in_program.values()) == pytest.approx(sum(room.area_estimate for room in office.floor.rooms))


def test_the_report_names_areas_and_walls(office: Storey, workshop_of: WorkshopOf) -> None:
    moved = change_area(office, "F1/meeting_room_1", 6.0, workshop_of(office)).moved
    assert "F1/meeting_room_1 has 42.0 m2 instead of 36.0 m2." in moved
    assert "The wall between F1/meeting_room_1 and F1/open_office_1 moved 1.00 m to the west." in moved


def test_an_area_that_cannot_be_is_refused_with_the_largest_that_can(office: Storey, workshop_of: WorkshopOf) -> None:
    with pytest.raises(MansionError, match=r"cannot have 236.0 m2: .* the largest possible is (\d+\.\d) m2") as refusal:
        change_area(office, "F1/meeting_room_1", 200.0, workshop_of(office))
    largest = float(refusal.value.info.message.split()[-2])
    assert 42.0 < largest < 84.0
    done = change_area(office, "F1/meeting_room_1", largest, workshop_of(office), absolute=True)
    assert polygon(done.storey.scene, "F1/meeting_room_1").area == pytest.approx(largest, rel=0.01)


def test_a_passage_does_not_shrink(office: Storey, workshop_of: WorkshopOf) -> None:
    with pytest.raises(MansionError, match="is a passage and keeps its width"):
        change_area(office, "F1/lobby", -4.0, workshop_of(office))


def test_a_room_that_is_not_there_and_an_area_that_says_nothing_are_refused(
    office: Storey, workshop_of: WorkshopOf
) -> None:
    with pytest.raises(MansionError, match="no room"):
        change_area(office, "F1/ballroom", 4.0, workshop_of(office))
    with pytest.raises(MansionError, match="name an area that differs"):
        change_area(office, "F1/storage", 0.01, workshop_of(office))
