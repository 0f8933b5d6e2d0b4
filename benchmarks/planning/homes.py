"""How homes are planned, over lists of briefs: halls, the group of kitchen and living room, bathrooms, shapes of rooms.

    python benchmarks/planning/homes.py benchmarks/planning/briefs/*.json [--every 4] [--worst 5]

Measured on the sketches of homes, storeys below ground and those that repeat others left out: the share of halls
(stairs not counted), how many homes have a kitchen that shares a wall with the dining or living room, a utility room
that shares one with the kitchen, a bathroom on every storey with bedrooms and one for each three of them, and how many
rooms fill less than three quarters of the rectangle around them.
"""

import argparse
import json
from collections import Counter
from collections.abc import Iterable
from pathlib import Path

from proportions import planned

from mansion_planner.program.building import PlannedBuilding
from mansion_planner.program.model import Placement, touching
from mansion_planner.program.plan_quality import fill

HALL, FILL = 0.15, 0.75
GROUP = ("living_room", "dining_room", "open_kitchen", "kitchen_diner", "lounge", "studio_room")
KITCHENS = ("kitchen", "open_kitchen", "kitchen_diner")
BATHS = ("bathroom", "ensuite_bathroom")


def of(placements: Iterable[Placement], kinds: Iterable[str]) -> list[Placement]:
    """Return the rooms of some types, or counted as one."""
    return [p for p in placements if p.room.kind.name in kinds or p.room.kind.counts_as in kinds]


def is_beside(ours: list[Placement], theirs: list[Placement], hub_kind: str, kinds: Iterable[str]) -> bool:
    """Whether one of our rooms shares a wall with one of theirs, or their room is the hub."""
    return hub_kind in kinds or any(a is not b and touching(a, b) for a in ours for b in theirs)


def measure(building: PlannedBuilding, totals: Counter[str]) -> float:
    """Add a home to the totals and return the share of its halls."""
    own = [storey for storey in building.storeys if storey.copy is None and storey.index >= 1]
    halls = floor = 0.0
    beds = baths = 0
    for storey in own:
        sketch = building.sketches[storey.index]
        if sketch.loose:
            sketch = sketch.placed or sketch
        placed = [p for p in sketch.rooms if p.boxes]
        passages = sum(c.area for c in sketch.corridors) if storey.hub.zone == "circulation" else 0.0
        halls, floor = halls + passages, floor + building.envelopes[storey.index].area
        kitchens, bedrooms, washing = of(placed, KITCHENS), of(placed, ("bedroom",)), of(placed, BATHS)
        utility = of(placed, ("utility_room", "laundry_room", "pantry"))
        beds, baths = beds + len(bedrooms), baths + len(washing)
        totals.update(rooms=len(placed), loose=sum(fill(p.boxes) < FILL for p in placed))
        totals.update(night=bool(bedrooms), dry=bool(bedrooms) and not washing)
        group = of(placed, GROUP)
        if kitchens and (group or storey.hub.name in GROUP):
            totals.update(kitchens=1, apart=not is_beside(kitchens, group, storey.hub.name, GROUP))
        if kitchens and utility:
            totals.update(utilities=1, far=not is_beside(kitchens, utility, storey.hub.name, KITCHENS))
    share = halls / max(floor, 1.0)
    totals.update(homes=1, long_halls=share > HALL, few_baths=beds >= 3 * max(baths, 1) + 1)
    return share


def main() -> None:
    """Print the shares, and the homes with the largest halls."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("lists", nargs="+", type=Path)
    parser.add_argument("--every", type=int, default=1, help="take every n-th brief")
    parser.add_argument("--worst", type=int, default=0, help="print so many homes with the largest halls")
    options = parser.parse_args()
    briefs = [case["brief"] for file in options.lists for case in json.loads(file.read_text()) if "brief" in case]
    totals: Counter[str] = Counter()
    shares: list[tuple[float, str]] = []
    for brief in briefs[:: options.every]:
        building = planned(brief)
        if building is not None and building.decisions.building.family == "home":
            shares.append((measure(building, totals), brief))
    shares.sort(reverse=True)
    mean = sum(share for share, _ in shares) / max(len(shares), 1)
    print(f"{totals['homes']} homes: halls {mean:.1%} of the floor, {totals['long_halls']} homes above {HALL:.0%}")
    print(f"kitchen apart from dining and living room: {totals['apart']} of {totals['kitchens']} storeys with both")
    print(f"utility room apart from the kitchen: {totals['far']} of {totals['utilities']}")
    print(f"storeys with bedrooms and no bathroom: {totals['dry']} of {totals['night']}")
    print(f"homes with more than three bedrooms for each bathroom: {totals['few_baths']}")
    print(f"rooms that fill less than {FILL:.0%} of their rectangle: {totals['loose']} of {totals['rooms']}")
    for share, brief in shares[: options.worst]:
        print(f"    {share:.0%} {brief[:150]!r}")


if __name__ == "__main__":
    main()
