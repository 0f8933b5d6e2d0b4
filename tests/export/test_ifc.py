"""Buildings as IFC4: valid, with the rooms, openings and furniture of the scenes, the same in every run."""

import sys
from collections import Counter

import pytest
from shapely.geometry import MultiPoint, Polygon

from mansion_export.ifc import building_ifc, ifc_files
from mansion_msgs_py.errors import MansionError

LEAFLESS = ("open", "doorway")


@pytest.fixture
def written(building):
    """The sample building as a file that is read again."""
    ifcopenshell = pytest.importorskip("ifcopenshell", reason="needs the extra ifc")
    return ifcopenshell.file.from_string(building_ifc(building).decode())


def corners(element):
    """Return the corners of an element's body in the building's frame, (x, y, z), metres."""
    geometry = pytest.importorskip("ifcopenshell.geom")
    settings = geometry.settings()
    settings.set("use-world-coords", True)
    flat = geometry.create_shape(settings, element).geometry.verts
    return [tuple(flat[k : k + 3]) for k in range(0, len(flat), 3)]


def tagged(written, kind):
    """Return the elements of a class by their id."""
    return {element.Tag: element for element in written.by_type(kind)}


def quantity(element, name):
    """Return a quantity of an element."""
    sets = [relation.RelatingPropertyDefinition for relation in element.IsDefinedBy]
    found = [each for one in sets if one.is_a("IfcElementQuantity") for each in one.Quantities if each.Name == name]
    return found[0][3]


def test_the_validator_of_ifcopenshell_finds_nothing(written):
    validate = pytest.importorskip("ifcopenshell.validate")
    log = validate.json_logger()
    validate.validate(written, log, express_rules=True)
    assert log.statements == []


def test_the_same_building_is_the_same_file(building):
    pytest.importorskip("ifcopenshell")
    assert list(ifc_files(building)) == ["building.ifc"]
    assert building_ifc(building) == building_ifc(building[::-1])


def test_spaces_have_names_types_and_areas_of_the_rooms(written, building):
    spaces = {
        (space.Decomposes[0].RelatingObject.Elevation, space.Name): space for space in written.by_type("IfcSpace")
    }
    assert len(spaces) == sum(len(scene.rooms) + len(scene.cores) for scene in building)
    for scene in building:
        for room in scene.rooms:
            space = spaces[scene.elevation, room.id.partition("/")[2]]
            assert space.ObjectType == room.room_type
            net = Polygon(room.net_polygon, room.net_holes)
            assert quantity(space, "NetFloorArea") == pytest.approx(net.area, rel=0.01)
            assert quantity(space, "GrossFloorArea") == pytest.approx(room.area, rel=0.01)
            drawn = corners(space)
            assert MultiPoint(drawn).convex_hull.area == pytest.approx(net.convex_hull.area, rel=0.01)
            assert min(z for _, _, z in drawn) == pytest.approx(scene.elevation)


def test_each_door_fills_an_opening_of_its_wall_at_its_place_and_is_at_the_boundary_of_its_rooms(written, building):
    made = tagged(written, "IfcDoor")
    leaved = [door for scene in building for door in scene.doors if door.kind not in LEAFLESS]
    assert made.keys() == {door.id for door in leaved}
    for door in leaved:
        opening = made[door.id].FillsVoids[0].RelatingOpeningElement
        assert opening.VoidsElements[0].RelatingBuildingElement.Tag == door.wall
        drawn = MultiPoint(corners(opening)).convex_hull
        assert drawn.centroid.distance(MultiPoint(door.segment).centroid) < 1e-3
        assert made[door.id].OverallWidth == pytest.approx(door.width)
        beside = {relation.RelatingSpace.Name for relation in made[door.id].ProvidesBoundaries}
        assert beside == {room.rpartition("/")[2] for room in door.rooms if room}


def test_where_no_wall_stands_a_virtual_element_is_between_the_rooms(written, building):
    places = [door for scene in building for door in scene.doors if door.kind == "open"]
    made = written.by_type("IfcVirtualElement")
    assert len(made) == len(places) > 0
    assert all(len(element.ProvidesBoundaries) == 2 for element in made)


def test_windows_have_their_sills(written, building):
    made = tagged(written, "IfcWindow")
    windows = {window.id: (scene, window) for scene in building for window in scene.windows}
    assert made.keys() == windows.keys()
    for name, (scene, window) in windows.items():
        heights = [z for _, _, z in corners(made[name].FillsVoids[0].RelatingOpeningElement)]
        assert min(heights) == pytest.approx(scene.elevation + window.sill)


def test_objects_stand_in_their_rooms_with_their_category_and_size(written, building):
    made = {}
    for kind in ("IfcFurniture", "IfcSanitaryTerminal", "IfcLightFixture", "IfcElectricAppliance"):
        made |= tagged(written, kind)
    objects = {item.id: item for scene in building for item in scene.objects}
    assert made.keys() == objects.keys()
    for name, item in objects.items():
        element = made[name]
        assert element.ObjectType == item.category
        assert element.ContainedInStructure[0].RelatingStructure.Name == item.room.rpartition("/")[2]
        middle = MultiPoint([point[:2] for point in corners(element)]).envelope.centroid
        assert middle.distance(MultiPoint([item.position[:2]])) < 0.05


def test_stairs_lifts_slabs_and_walls_are_there(written, building):
    counts = Counter(element.is_a() for element in written.by_type("IfcElement"))
    assert counts["IfcWall"] == sum(len(scene.walls) for scene in building)
    assert counts["IfcSlab"] == len(building)
    lifts = {core.id for scene in building for core in scene.cores if core.type == "elevator"}
    assert counts["IfcTransportElement"] == len(lifts)
    assert counts["IfcRoof"] >= 1


def test_without_ifcopenshell_the_error_says_what_to_install(building, monkeypatch):
    monkeypatch.setitem(sys.modules, "ifcopenshell", None)
    with pytest.raises(MansionError, match=r"ifcopenshell: pip install 'mansion\[ifc\]'") as caught:
        building_ifc(building)
    assert caught.value.code == "UNAVAILABLE"
