"""How the furniture of homes stands together: beds, sofas, kitchens, tables and desks, over sentences and seeds.

python benchmarks/scene/arrangement.py [--seeds 0 1] [--homes 10] [--each]
"""

import argparse
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence

import msgspec
import numpy as np
from shapely.geometry import LineString, Point, Polygon

from mansion_bringup.pipeline import build as steps
from mansion_bringup.pipeline.stages import LocalStages
from mansion_geometry.object_footprints import footprint_at
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest, identified
from mansion_msgs_py.scene import FloorScene, SceneObject

HOMES = (
    "A studio flat of 30 m2 for a student",
    "A one-bedroom flat of 48 m2",
    "A two-bedroom flat of 68 m2 with an open kitchen",
    "A three-bedroom flat of 95 m2 with two bathrooms and a balcony",
    "A flat of 80 m2 for a couple with one child",
    "A penthouse of 150 m2 with a roof garden and three bedrooms",
    "A loft of 90 m2 with a home office",
    "A maisonette with two bedrooms and a terrace",
    "A bungalow of 110 m2 with three bedrooms",
    "A bungalow for an elderly couple with a guest room",
    "A cottage with two bedrooms and a fireplace",
    "A small house of 70 m2 for two",
    "A two-storey house with four bedrooms and a garage",
    "A two-storey house for a family with three children",
    "A terraced house with three bedrooms and a study",
    "A semi-detached house with a kitchen-diner and three bedrooms",
    "A townhouse of three storeys with a roof terrace",
    "A villa with a master suite, a library and a terrace",
    "A villa of 280 m2 with five bedrooms and a games room",
    "A farmhouse with a big kitchen, a pantry and four bedrooms",
    "A house with an open living and dining room, a kitchen and two bedrooms",
    "A duplex flat for a family of four",
    "A chalet with three bedrooms, a sauna and a living room with a fireplace",
    "A holiday home by the sea with two bedrooms and a terrace",
    "A tiny house of 28 m2",
    "A courtyard house with three bedrooms and a music room",
    "A modern family home with a nursery and a playroom",
    "A house for a grandmother and her two grandchildren",
    "A one-storey house with two bedrooms, a home office and a dining room",
    "A house of 200 m2 for a family of six",
)
"""Thirty homes from a studio to a villa."""

BEDS = ("bed", "single_bed")
SCREENS = ("media_console", "television")
SOFAS = ("sofa", "loveseat")
TABLES = ("dining_table", "round_table", "cafe_table", "patio_table", "kitchen_island", "desk", "kids_table")
CHAIRS = ("chair", "dining_chair", "patio_chair")
WORKTOPS = ("counter_top", "kitchen_counter", "kitchen_sink_unit", "stove", "fridge", "dishwasher")
DOUBLE = 1.3
"""Width of the narrowest bed for two, metres."""


_FLAT = 0.05
"""Height of a rug at most, metres."""


class Piece:
    """An object of the floor in its own frame: its footprint, and where others lie ahead of and beside it."""

    def __init__(self, thing: SceneObject) -> None:
        turn = np.radians(thing.rotation)
        self.category, self.width, self.depth = thing.category, thing.size[0], thing.size[1]
        self.id = thing.id
        self.centre = np.array(thing.position[:2])
        self.right = np.array([np.cos(turn), np.sin(turn)])
        self.front = np.array([-self.right[1], self.right[0]])
        self.shape: Polygon = footprint_at(thing.position[:2], thing.size[:2], thing.rotation)

    def seen(self, other: "Piece") -> tuple[float, float]:
        """Return how far another is to the right of this one's centre and ahead of it, metres."""
        way = other.centre - self.centre
        return float(way @ self.right), float(way @ self.front)

    def looks_at(self, other: "Piece", degrees: float = 30.0) -> bool:
        """Tell whether another lies ahead, at most so many degrees aside."""
        aside, ahead = self.seen(other)
        nearest = max(abs(aside) - other.width / 2, 0.0) if abs(self.front @ other.front) > 0.7 else abs(aside)
        return ahead > 0 and nearest <= ahead * np.tan(np.radians(degrees))


def sides_with_table(bed: Piece, tables: Sequence[Piece]) -> set[bool]:
    """Return at which sides of a bed's head a bedside table stands."""
    found = set()
    for table in tables:
        aside, ahead = bed.seen(table)
        beside = abs(aside) - (bed.width + table.width) / 2 <= 0.3
        if bed.shape.distance(table.shape) <= 0.3 and beside and ahead <= -bed.depth / 2 + 0.55:
            found.add(aside > 0)
    return found


def free_sides(bed: Piece, others: Sequence[Piece], room: Polygon) -> int:
    """Return at how many sides half a metre of floor is free, below the head."""
    free = 0
    for side in (-1.0, 1.0):
        middle = bed.centre + side * bed.right * (bed.width / 2 + 0.25) + bed.front * 0.25
        strip = footprint_at(
            (float(middle[0]), float(middle[1])),
            (0.46, max(bed.depth - 0.7, 0.3)),
            float(np.degrees(np.arctan2(bed.right[1], bed.right[0]))),
        )
        clear = room.buffer(0.03).covers(strip)
        free += clear and not any(strip.intersects(o.shape) for o in others if o is not bed)
    return free


def in_one_run(fitments: Sequence[Piece]) -> bool:
    """Tell whether sink, hob and fridge are joined by worktops and appliances without a gap of over 0.1 m."""
    run = {next(i for i, f in enumerate(fitments) if f.category == "kitchen_sink_unit")}
    grown = True
    while grown:
        more = {
            i
            for i, f in enumerate(fitments)
            if i not in run and any(f.shape.distance(fitments[j].shape) <= 0.1 for j in run)
        }
        grown = bool(more)
        run |= more
    return {"stove", "fridge"} <= {fitments[i].category for i in run}


class Tally:
    """Shares of what is as one expects, by measure."""

    def __init__(self) -> None:
        self.asked: Counter[str] = Counter()
        self.held: Counter[str] = Counter()
        self.faults: list[str] = []

    def note(self, measure: str, held: bool, where: str = "") -> None:
        """Count one case."""
        self.asked[measure] += 1
        self.held[measure] += held
        if not held:
            self.faults.append(f"{measure}: {where}")

    def table(self) -> str:
        """Return a line for each measure."""
        lines = [
            f"{self.held[name]:>6} of {self.asked[name]:>5}  {self.held[name] / self.asked[name]:>7.1%}  {name}"
            for name in sorted(self.asked)
        ]
        return "\n".join(lines)


def measure_floor(scene: FloorScene, tally: Tally) -> None:
    """Add the rooms of one floor to a tally."""
    by_room = defaultdict[str, list[Piece]](list)
    for thing in scene.objects:
        if (thing.mount == "floor" and thing.size[2] > _FLAT) or thing.category == "television":
            by_room[thing.room].append(Piece(thing))
    for room in scene.rooms:
        pieces = by_room[room.id]
        outline = Polygon(room.net_polygon, room.net_holes)
        _measure_beds(pieces, outline, tally)
        _measure_living(pieces, room.room_type, tally)
        _measure_kitchen(pieces, scene, room.id, tally)
        _measure_seats(pieces, tally)
        if room.room_type in ("terrace", "balcony", "home_terrace", "roof_garden"):
            tables = sum(p.category == "patio_table" for p in pieces)
            tally.note("terraces with one table at most", tables <= 1, room.id)


def _measure_beds(pieces: Sequence[Piece], room: Polygon, tally: Tally) -> None:
    floor = [p for p in pieces if p.category != "television"]
    tables = [p for p in pieces if p.category in ("nightstand", "side_table")]
    beds = [p for p in pieces if p.category in BEDS and p.width > 0.7]
    for bed in beds:
        sides = sides_with_table(bed, tables)
        tally.note("beds with a bedside table at the head", bool(sides), bed.id)
        if bed.width >= DOUBLE:
            tally.note("double beds with bedside tables at both sides of the head", len(sides) == 2, bed.id)
            tally.note("double beds that can be entered from both sides", free_sides(bed, floor, room) == 2, bed.id)
    if beds:
        for table in tables:
            if table.category == "nightstand":
                held = any(sides_with_table(bed, [table]) for bed in beds)
                tally.note("bedside tables at the head of a bed", held, table.id)


def _measure_living(pieces: Sequence[Piece], room_type: str, tally: Tally) -> None:
    sofas = [p for p in pieces if p.category in SOFAS]
    screens = [p for p in pieces if p.category in SCREENS]
    if room_type not in ("living_room", "studio_apartment", "family_room"):
        return
    for sofa in sofas[:1]:
        held = any(sofa.looks_at(s) and 1.0 < sofa.seen(s)[1] <= 6.0 and s.front @ sofa.front < -0.7 for s in screens)
        tally.note("sofas that face a screen", held, sofa.id)
    for chair in (p for p in pieces if p.category == "armchair"):
        tables = [p for p in pieces if p.category in ("coffee_table", *SOFAS)]
        if tables:
            near = min(tables, key=lambda t: chair.shape.distance(t.shape))
            tally.note("armchairs that face their table or sofa", chair.looks_at(near, 50.0), chair.id)


def _measure_kitchen(pieces: Sequence[Piece], scene: FloorScene, room: str, tally: Tally) -> None:
    fitments = [p for p in pieces if p.category in WORKTOPS]
    if not {"kitchen_sink_unit", "stove", "fridge"} <= {p.category for p in fitments}:
        return
    tally.note("kitchens in one run", in_one_run(fitments), room)
    windows = [w for w in scene.windows if w.room == room]
    for hob in (p for p in fitments if p.category == "stove"):
        back = Point(hob.centre - hob.front * (hob.depth / 2 + 0.1))
        near = [w for w in windows if LineString(w.segment).distance(back) <= 0.3]
        tally.note("hobs without a window behind", not near, hob.id)


def _measure_seats(pieces: Sequence[Piece], tally: Tally) -> None:
    tables = [p for p in pieces if p.category in TABLES]
    desks = [p for p in pieces if p.category == "desk"]
    for chair in (p for p in pieces if p.category in CHAIRS):
        if tables:
            near = min(tables, key=lambda t: chair.shape.distance(t.shape))
            held = chair.shape.distance(near.shape) <= 0.6 and chair.looks_at(near)
            tally.note("chairs at a table or desk that they face", held, chair.id)
    chairs = [p for p in pieces if p.category in (*CHAIRS, "office_chair", "stool")]
    for desk in desks:
        sits = [c for c in chairs if desk.looks_at(c) and c.shape.distance(desk.shape) <= 0.5 and c.looks_at(desk)]
        tally.note("desks with a chair at the front", bool(sits), desk.id)


def homes(sentences: Sequence[str], seeds: Sequence[int]) -> Iterator[tuple[str, int, list[FloorScene]]]:
    """Yield the finished floors of each home."""
    for sentence in sentences:
        for seed in seeds:
            stages = LocalStages()
            try:
                plan = stages.plan(identified(BuildRequest(description=sentence, seed=seed)))
                layouts = {number: steps.solve(stages, plan, number) for number in steps.distinct_floors(plan)}
                floors = []
                for number, floor in enumerate(plan.program.floors):
                    layout = msgspec.structs.replace(layouts[steps.source_floor(plan, number)], floor=floor.index)
                    floors.append(steps.furnish(stages, plan, layout, number))
            except MansionError as error:
                print(f"{sentence[:50]:50}{seed:>5}  {str(error)[:90]}")
                continue
            yield sentence, seed, floors


def measure_home(floors: Sequence[FloorScene], tally: Tally) -> None:
    """Add a home to a tally."""
    for scene in floors:
        measure_floor(scene, tally)
    rooms = [room for scene in floors for room in scene.rooms if "bedroom" in room.room_type]
    beds = [o for scene in floors for o in scene.objects if o.category in BEDS]
    if rooms and beds:
        tally.note("homes with a bed for two", any(bed.size[0] >= DOUBLE for bed in beds), rooms[0].id)


def main() -> None:
    """Print each measure's share over all homes."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, nargs="+", default=[0, 1])
    parser.add_argument("--homes", type=int, default=len(HOMES), help="how many of the thirty, from the first")
    parser.add_argument("--each", action="store_true", help="print each piece that stands otherwise")
    options = parser.parse_args()
    total = Tally()
    for sentence, seed, floors in homes(HOMES[: options.homes], options.seeds):
        tally = Tally()
        measure_home(floors, tally)
        total.asked += tally.asked
        total.held += tally.held
        for fault in tally.faults if options.each else ():
            print(f"{sentence[:40]:40}{seed:>3}  {fault}", flush=True)
    print(total.table())


if __name__ == "__main__":
    main()
