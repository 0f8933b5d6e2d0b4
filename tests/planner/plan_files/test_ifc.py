"""IFC files as plans: a hand-written cottage in millimetres, as programs of architects write them."""

from pathlib import Path
from typing import Any

import pytest

from mansion_msgs_py.building_plan import BuildingPlan
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building
from mansion_planner.plan_files import read_plan

ifcopenshell = pytest.importorskip("ifcopenshell", reason="needs the extra ifc")

Box = tuple[float, float, float, float]


class Cottage:
    """An IFC4 file in millimetres with boxes for spaces, walls and openings."""

    def __init__(self) -> None:
        self.file = ifcopenshell.file(schema="IFC4")
        create = self.file.create_entity
        millimetre = create("IfcSIUnit", None, "LENGTHUNIT", "MILLI", "METRE")
        axes = create("IfcAxis2Placement3D", create("IfcCartesianPoint", (0.0, 0.0, 0.0)))
        self.context = create("IfcGeometricRepresentationContext", None, "Model", 3, 1e-5, axes)
        self.root(
            "IfcProject",
            RepresentationContexts=[self.context],
            UnitsInContext=create("IfcUnitAssignment", [millimetre]),
        )
        self.building = self.root("IfcBuilding", Name="Cottage")

    def root(self, kind: str, **attributes: Any) -> Any:
        """Add an entity with an id of its own."""
        return self.file.create_entity(kind, GlobalId=ifcopenshell.guid.new(), **attributes)

    def storey(self, name: str, elevation: float) -> Any:
        """Add a storey."""
        made = self.root("IfcBuildingStorey", Name=name, Elevation=elevation)
        self.root("IfcRelAggregates", RelatingObject=self.building, RelatedObjects=[made])
        return made

    def body(self, box: Box, bottom: float, height: float, turned: bool = False) -> dict[str, Any]:
        """Return placement and shape of a box; a turned one has its local x axis along y."""
        create, (x0, y0, x1, y1) = self.file.create_entity, box
        wide, deep = (y1 - y0, x1 - x0) if turned else (x1 - x0, y1 - y0)
        at = create("IfcCartesianPoint", ((x0 + x1) / 2, (y0 + y1) / 2, bottom))
        up = create("IfcDirection", (0.0, 0.0, 1.0))
        along = create("IfcDirection", (0.0, 1.0, 0.0) if turned else (1.0, 0.0, 0.0))
        centre = create("IfcAxis2Placement2D", create("IfcCartesianPoint", (0.0, 0.0)))
        profile = create("IfcRectangleProfileDef", "AREA", None, centre, float(wide), float(deep))
        origin = create("IfcAxis2Placement3D", create("IfcCartesianPoint", (0.0, 0.0, 0.0)))
        solid = create("IfcExtrudedAreaSolid", profile, origin, up, float(height))
        shape = create("IfcShapeRepresentation", self.context, "Body", "SweptSolid", [solid])
        return {
            "ObjectPlacement": create("IfcLocalPlacement", None, create("IfcAxis2Placement3D", at, up, along)),
            "Representation": create("IfcProductDefinitionShape", None, None, [shape]),
        }

    def space(self, storey: Any, number: str, name: str, box: Box, bottom: float = 0.0) -> Any:
        """Add a space of 2.5 m."""
        made = self.root("IfcSpace", Name=number, LongName=name, **self.body(box, bottom, 2500.0))
        self.root("IfcRelAggregates", RelatingObject=storey, RelatedObjects=[made])
        return made

    def wall(self, storey: Any, box: Box, bottom: float = 0.0) -> Any:
        """Add a wall."""
        made = self.root("IfcWall", **self.body(box, bottom, 2700.0))
        self.contain(storey, made)
        return made

    def contain(self, storey: Any, element: Any) -> None:
        """Put an element on a storey."""
        self.root("IfcRelContainedInSpatialStructure", RelatingStructure=storey, RelatedElements=[element])

    def hole(self, wall: Any, box: Box, bottom: float, height: float, turned: bool = False) -> Any:
        """Cut an opening."""
        made = self.root("IfcOpeningElement", **self.body(box, bottom, height, turned))
        self.root("IfcRelVoidsElement", RelatingBuildingElement=wall, RelatedOpeningElement=made)
        return made

    def fill(self, storey: Any, kind: str, hole: Any, width: float, **attributes: Any) -> Any:
        """Put a door or a window into an opening, at its placement."""
        placed = hole.ObjectPlacement
        made = self.root(kind, OverallWidth=float(width), ObjectPlacement=placed, **attributes)
        self.root("IfcRelFillsElement", RelatingOpeningElement=hole, RelatedBuildingElement=made)
        self.contain(storey, made)
        return made

    def write(self, path: Path) -> Path:
        """Write the file."""
        self.file.write(str(path))
        return path


def cottage(*, entrance: bool = True, kitchen_from: float = 4120.0) -> Cottage:
    """A living room and a kitchen side by side, 0.12 m apart, a window and an opening, a door in a deep hole."""
    made = Cottage()
    ground = made.storey("Ground floor", 0.0)
    made.storey("Roof", 2800.0)
    made.space(ground, "1.01", "Living room", (0.0, 0.0, 4000.0, 4000.0))
    made.space(ground, "1.02", "Kitchen", (kitchen_from, 0.0, 7000.0, 4000.0))
    between, front = made.wall(ground, (4000.0, 0.0, 4120.0, 4000.0)), made.wall(ground, (0.0, -300.0, 7000.0, 0.0))
    made.hole(between, (4000.0, 1000.0, 4120.0, 2000.0), 0.0, 2100.0)
    made.hole(between, (4000.0, 3000.0, 4120.0, 3300.0), 1000.0, 300.0)
    if entrance:
        hole = made.hole(front, (1000.0, -1000.0, 1900.0, 700.0), 0.0, 2100.0)
        made.fill(ground, "IfcDoor", hole, 900.0, OperationType="DOUBLE_DOOR_SINGLE_SWING")
    pane = made.hole(front, (5000.0, -300.0, 6200.0, 0.0), 900.0, 1300.0)
    made.fill(ground, "IfcWindow", pane, 1200.0)
    return made


def planned(plan: BuildingPlan) -> Any:
    """Return what the planner makes of a plan."""
    return plan_building(BuildRequest(description="", plan=plan))


def test_spaces_are_rooms_and_openings_are_doors_windows_and_doorways(tmp_path: Path) -> None:
    plan = read_plan(cottage().write(tmp_path / "cottage.ifc"))
    (floor,) = plan.floors
    assert (plan.name, floor.floor) == ("Cottage", 1)
    assert [(room.name, room.id) for room in floor.rooms] == [("Living room", ""), ("Kitchen", "")]
    assert sorted(floor.rooms[0].polygon) == [(0.0, 0.0), (0.0, 4.0), (4.0, 0.0), (4.0, 4.0)]
    (door,), (opening,), (window,) = floor.doors, floor.openings, floor.windows
    assert sorted(door.segment or ()) == [(1.0, -0.15), (1.9, -0.15)]
    assert (door.kind, opening.kind) == ("double", "doorway")
    assert sorted(opening.segment or ()) == [(4.06, 1.0), (4.06, 2.0)]
    assert (window.sill, window.height) == (0.9, 1.3)


def test_a_cottage_is_planned_as_it_is_drawn(tmp_path: Path) -> None:
    floor = planned(read_plan(cottage().write(tmp_path / "cottage.ifc"))).program.floors[0]
    assert [(room.id, room.room_type) for room in floor.rooms] == [
        ("living_room", "living_room"),
        ("kitchen", "kitchen"),
    ]
    assert {frozenset(door.rooms) for door in floor.openings.doors} == {
        frozenset(("living_room", "kitchen")),
        frozenset(("living_room", None)),
    }


def test_faults_name_the_entity(tmp_path: Path) -> None:
    made = cottage(entrance=False, kitchen_from=3500.0)
    spaces = {space.LongName: space.GlobalId for space in made.file.by_type("IfcSpace")}
    with pytest.raises(MansionError) as refusal:
        planned(read_plan(made.write(tmp_path / "cottage.ifc")))
    faults = refusal.value.info.details["faults"]
    overlap = next(fault for fault in faults if "overlap" in fault)
    assert f"[GlobalId {spaces['Living room']}, GlobalId {spaces['Kitchen']}]" in overlap
    assert any("no entrance" in fault for fault in faults)


def test_a_door_at_fault_is_named(tmp_path: Path) -> None:
    made = cottage()
    ground = made.file.by_type("IfcBuildingStorey")[0]
    far = made.wall(ground, (20000.0, 0.0, 20200.0, 4000.0))
    door = made.fill(ground, "IfcDoor", made.hole(far, (20000.0, 1000.0, 20200.0, 1900.0), 0.0, 2100.0), 900.0)
    with pytest.raises(MansionError, match=rf"\[GlobalId {door.GlobalId.replace('$', '[$]')}\]: is on no wall"):
        planned(read_plan(made.write(tmp_path / "cottage.ifc")))


def test_rooms_of_one_name_are_told_apart_by_their_numbers_and_doors_by_boundaries(tmp_path: Path) -> None:
    made = cottage()
    for space in made.file.by_type("IfcSpace"):
        space.LongName = "Bedroom"
    opening = made.file.by_type("IfcOpeningElement")[0]
    for space in made.file.by_type("IfcSpace"):
        made.root(
            "IfcRelSpaceBoundary",
            RelatingSpace=space,
            RelatedBuildingElement=opening,
            PhysicalOrVirtualBoundary="VIRTUAL",
            InternalOrExternalBoundary="INTERNAL",
        )
    floor = read_plan(made.write(tmp_path / "cottage.ifc")).floors[0]
    assert [room.id for room in floor.rooms] == ["Bedroom 1.01", "Bedroom 1.02"]
    assert floor.openings[0].rooms == ["Bedroom 1.01", "Bedroom 1.02"]


def test_the_door_of_a_cubicle_in_a_room_is_left_out(tmp_path: Path) -> None:
    made = cottage()
    ground = made.file.by_type("IfcBuildingStorey")[0]
    partition = made.wall(ground, (1000.0, 2000.0, 3000.0, 2040.0))
    made.fill(ground, "IfcDoor", made.hole(partition, (1500.0, 2000.0, 2200.0, 2040.0), 0.0, 2000.0), 700.0)
    assert len(read_plan(made.write(tmp_path / "cottage.ifc")).floors[0].doors) == 1


def test_rooms_that_touch_are_open_where_no_wall_stands(tmp_path: Path) -> None:
    made = Cottage()
    ground = made.storey("Ground floor", 0.0)
    made.space(ground, "1", "Kitchen", (0.0, 0.0, 4000.0, 4000.0))
    made.space(ground, "2", "Dining room", (4000.0, 0.0, 8000.0, 4000.0))
    made.space(ground, "3", "Study", (0.0, 4000.0, 4000.0, 8000.0))
    made.space(ground, "4", "Pantry", (4000.0, 4000.0, 8000.0, 8000.0))
    made.wall(ground, (0.0, 3940.0, 4000.0, 4060.0))
    made.wall(ground, (4000.0, 3940.0, 7000.0, 4060.0))
    openings = read_plan(made.write(tmp_path / "plan.ifc")).floors[0].openings
    kinds = {frozenset(door.rooms): door.kind for door in openings}
    assert kinds == {
        frozenset(("Kitchen", "Dining room")): "open",
        frozenset(("Study", "Pantry")): "open",
        frozenset(("Dining room", "Pantry")): "doorway",
    }


def test_storeys_are_numbered_from_the_ground_and_one_may_be_named(tmp_path: Path) -> None:
    made = cottage()
    cellar, upper = made.storey("Cellar", -2800.0), made.storey("Upper floor", 2800.0)
    made.space(cellar, "0.01", "Storage", (0.0, 0.0, 4000.0, 4000.0), -2800.0)
    made.space(upper, "2.01", "Bedroom", (0.0, 0.0, 4000.0, 4000.0), 2800.0)
    path = made.write(tmp_path / "cottage.ifc")
    assert [(floor.floor, floor.height) for floor in read_plan(path).floors] == [(0, 2.8), (1, 2.8), (2, None)]
    (alone,) = read_plan(path.with_name("cottage.ifc#Upper floor")).floors
    assert (alone.floor, alone.rooms[0].name) == (1, "Bedroom")
    with pytest.raises(MansionError, match=r"no storey 'Attic'.*Upper floor"):
        read_plan(path.with_name("cottage.ifc#Attic"))


def test_a_space_without_a_storey_and_a_file_without_spaces(tmp_path: Path) -> None:
    made = Cottage()
    made.storey("Ground floor", 0.0)
    with pytest.raises(MansionError, match="no IfcSpace on an IfcBuildingStorey has a floor"):
        read_plan(made.write(tmp_path / "empty.ifc"))


@pytest.mark.parametrize("text", ["", "not a STEP file", "ISO-10303-21;\nHEADER;\n"])
def test_what_is_no_ifc_file_is_refused_in_one_line(tmp_path: Path, text: str) -> None:
    path = tmp_path / "plan.ifc"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(MansionError, match=r"plan\.ifc is not an IFC file") as refusal:
        read_plan(path)
    assert "\n" not in refusal.value.info.message


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(MansionError, match=r"nothing\.ifc: there is no such file"):
        read_plan(tmp_path / "nothing.ifc")
