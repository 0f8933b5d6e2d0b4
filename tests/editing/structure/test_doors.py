"""A new door stands in a wall that two rooms share, clear of furniture, and other doors stay where they are."""

from collections.abc import Callable

import pytest
from shapely import LineString

from mansion_bringup.check import check_floors
from mansion_editing.structure import Storey, Workshop, add_door
from mansion_geometry.object_footprints import footprint
from mansion_msgs_py.errors import ErrorCode, MansionError

WorkshopOf = Callable[[Storey], Workshop]
PAIRS = [("F1/open_office_1", "F1/meeting_room_1"), ("F1/toilet_1", "F1/storage"), ("F1/storage", "F1/office_2")]


@pytest.mark.parametrize(("one", "other"), PAIRS)
def test_the_door_is_there_with_nothing_in_front_of_it(
    office: Storey, workshop_of: WorkshopOf, one: str, other: str
) -> None:
    done = add_door(office, one, other, workshop_of(office))
    scene = done.storey.scene
    (door,) = [entry for entry in scene.doors if set(entry.rooms) == {one, other}]
    assert door.width >= 0.9
    way = LineString(door.segment).buffer(0.6, cap_style="flat")
    standing = [item for item in scene.objects if item.mount == "floor" and item.size[2] > 0.03]
    assert not [item.id for item in standing if footprint(item).intersection(way).area > 1e-3]
    assert not list(check_floors(scene.building_id, [scene], [done.storey.topology]))
    assert f"A door between {door.rooms[0]} and {door.rooms[1]} is new: {door.id}." in done.moved


def test_everything_else_of_the_storey_stays(office: Storey, workshop_of: WorkshopOf) -> None:
    one, other = PAIRS[0]
    scene = add_door(office, one, other, workshop_of(office)).storey.scene
    assert [door for door in scene.doors if set(door.rooms) != {one, other}] == office.scene.doors
    assert (scene.walls, scene.windows, scene.cores) == (office.scene.walls, office.scene.windows, office.scene.cores)
    away = [[o for o in s.objects if o.room not in (one, other)] for s in (scene, office.scene)]
    assert away[0] == away[1]


def test_room_graph_and_layout_have_the_new_edge(office: Storey, workshop_of: WorkshopOf) -> None:
    after = add_door(office, *PAIRS[0], workshop_of(office)).storey
    edges = {(edge.source, edge.target, edge.kind) for edge in after.topology.edges}
    assert ("open_office_1", "meeting_room_1", "access") in edges
    realised = next(e for e in after.layout.edges if (e.source, e.target) == ("open_office_1", "meeting_room_1"))
    assert realised.satisfied
    assert realised.length == pytest.approx(6.0)


@pytest.mark.parametrize(
    ("one", "other", "code", "reason"),
    [
        ("F1/lobby", "F1/office_2", ErrorCode.CONFLICT, "have the door"),
        ("F1/lobby", "F1/kitchenette", ErrorCode.CONFLICT, "stand open to each other"),
        ("F1/toilet_1", "F1/office_2", ErrorCode.INFEASIBLE, "share no wall"),
        ("F1/toilet_1", "F1/toilet_1", ErrorCode.INVALID_PAYLOAD, "joins two rooms"),
        ("F1/toilet_1", "F1/cellar", ErrorCode.NOT_FOUND, "no room"),
    ],
)
def test_what_cannot_be_is_refused_with_the_reason(
    office: Storey, workshop_of: WorkshopOf, one: str, other: str, code: ErrorCode, reason: str
) -> None:
    with pytest.raises(MansionError, match=reason) as refusal:
        add_door(office, one, other, workshop_of(office))
    assert refusal.value.info.code == code
