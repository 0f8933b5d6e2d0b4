"""What programs of rooms make of briefs: what is parted, what nobody asked for, and what is furnished as a study.

    python benchmarks/planning/programs.py [benchmarks/planning/programs.json] [--lines]

Buildings are planned, not drawn. Counted are, where the brief does not say on which storey they are, kitchens without a
room to eat in on their storey, rooms to eat in without a kitchen, and rooms above the ground that visitors or goods
come to first; rooms that nobody asked for and that no such building needs, by their share of the floor; rooms with a
name of their own that are furnished as a study; and corners of a room that became rooms.
"""

import argparse
import json
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from proportions import planned

from mansion_planner.program.building import PlannedBuilding
from mansion_planner.program.model import PlannedRoom

COOKING = {"kitchen", "open_kitchen", "kitchen_diner", "commercial_kitchen"}
EATING = {"restaurant", "cafeteria", "dining_room", "food_court"}
LIVING = {"living_room", "dining_room"}
FIRST = {
    "reception", "waiting_hall", "ticket_office", "service_counter", "pharmacy", "shop", "restaurant", "sales_area",
    "loading_dock", "stock_room", "mail_room", "luggage_room", "assembly_hall", "sports_hall", "indoor_pool",
    "apparatus_bay", "gear_room", "car_showroom", "car_workshop", "warehouse", "production_hall", "packing_area",
    "garage", "utility_room", "kitchen_diner", "cloakroom", "emergency_room", "holding_cell",
}  # fmt: skip
NEEDED = {
    "reception", "lobby", "corridor", "hallway", "restroom", "toilet", "accessible_toilet", "bathroom",
    "ensuite_bathroom", "childrens_washroom", "kitchen", "commercial_kitchen", "shower_area", "changing_room",
    "cloakroom", "janitor_closet", "mechanical_room", "electrical_room", "housekeeping_room", "living_room",
    "dining_room", "waiting_room", "loading_dock", "utility_room",
}  # fmt: skip
PARTS = ("corner", "nook", "alcove", "niche")
MOST = 0.15


def floors_of_rooms(building: PlannedBuilding) -> Iterator[tuple[int, PlannedRoom]]:
    """Yield the rooms of all storeys that copy no other, with their storey."""
    for storey in building.storeys:
        if storey.copy is None and storey.index >= 1:
            yield from ((storey.index, room) for top in storey.rooms for room in top.each())


def parted(building: PlannedBuilding) -> list[str]:
    """Return what belongs together and lies apart."""
    placed = {room.name for room in building.decisions.facts.rooms if room.floors or room.each}
    rooms = list(floors_of_rooms(building))
    home = building.decisions.building.family == "home"
    kinds = Counter((floor, room.kind.name) for floor, room in rooms)
    kinds.update((storey.index, storey.hub.name) for storey in building.storeys)
    eating = LIVING if home else EATING
    tables = {floor for floor, name in kinds if name in eating}
    stoves = {floor for floor, name in kinds if name in COOKING}
    found = []
    for floor, room in rooms:
        where = f"{room.id} on storey {floor}"
        if room.base in placed:
            continue
        if room.kind.name in (COOKING if home else {"commercial_kitchen"}) and tables and floor not in tables:
            found.append(f"{where} without a room to eat in")
        elif room.kind.name in (EATING - {"dining_room"}) and stoves and floor not in stoves:
            found.append(f"{where} without a kitchen")
        elif room.kind.name in FIRST and floor > 1:
            found.append(where)
    return found


def unasked(building: PlannedBuilding) -> dict[str, float]:
    """Return the square metres of what nobody asked for and the building does not need, by type."""
    areas: Counter[str] = Counter()
    for storey in building.storeys:
        if storey.copy is None and storey.index >= 1:
            for placement in building.sketches[storey.index].rooms:
                room = placement.room
                if not room.stated and not room.notes and room.kind.name not in NEEDED:
                    areas[room.kind.name] += round(placement.area)
    return dict(areas)


def main() -> None:
    """Print the counts, and what is counted with `--lines`."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("list", nargs="?", type=Path, default=Path(__file__).with_suffix(".json"))
    parser.add_argument("--lines", action="store_true")
    options = parser.parse_args()
    totals: Counter[str] = Counter()
    shares = []
    for brief in json.loads(options.list.read_text(encoding="utf-8")):
        building = planned(brief)
        if building is None:
            totals["refused"] += 1
            print("refused:", brief)
            continue
        apart, extra = parted(building), unasked(building)
        whole = sum(building.envelopes[storey.index].area for storey in building.storeys if storey.copy is None)
        share = sum(extra.values()) / whole
        own = {room.base for _, room in floors_of_rooms(building) if room.stated}
        studies = [
            room.id for _, room in floors_of_rooms(building)
            if room.stated and room.kind.name == "study_room" and "study" not in room.id and "tutor" not in room.id
        ]  # fmt: skip
        parts = sorted(name for name in own if name.rpartition("_")[2] in PARTS)
        shares.append(share)
        totals.update(
            buildings=1, apart=len(apart), parting=bool(apart), above=share > MOST, studies=len(studies),
            parts=len(parts),
        )  # fmt: skip
        if options.lines and (apart or share > MOST or studies or parts):
            print(f"{brief[:90]}\n    {share:.0%} unasked {extra}; apart {apart}; studies {studies}; parts {parts}")
    number = max(totals["buildings"], 1)
    print(
        f"{number} buildings: {totals['apart']} rooms parted from what they belong to, in {totals['parting']}; "
        f"unasked rooms {sum(shares) / number:.1%} of the floor, above {MOST:.0%} in {totals['above']}; "
        f"{totals['studies']} rooms furnished as studies; {totals['parts']} corners as rooms"
    )


if __name__ == "__main__":
    main()
