"""Where people come in: receptions, and the rooms of customers."""

from mansion_scene.structure import build_structure


def box(x0, y0, x1, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def doors(sample_floors, kind, building_type, relations=None):
    rooms = {"hall": ("corridor", box(0, 0, 14, 2.4)), "front": (kind, box(0, 2.4, 14, 9))}
    request = sample_floors.request(rooms, [("hall", "front")], building_type=building_type, **(relations or {}))
    structure = build_structure(request)
    return [door for door in structure.doors if None in door.rooms]


def test_customers_come_in_to_a_sales_area_from_the_street(sample_floors):
    found = doors(sample_floors, "sales_area", "pharmacy_building")
    assert any("F1/front" in door.rooms and door.width >= 1.2 for door in found)


def test_an_office_has_no_door_to_the_street(sample_floors):
    assert not any("F1/front" in door.rooms for door in doors(sample_floors, "private_office", "office"))


def test_a_living_room_of_a_home_has_none(sample_floors):
    assert not any("F1/front" in door.rooms for door in doors(sample_floors, "cafe", "house"))
