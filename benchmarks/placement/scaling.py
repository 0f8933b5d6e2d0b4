"""CPU seconds of placement against the number of objects: one hall that grows, and a floor of many rooms.

python benchmarks/placement/scaling.py
"""

import time

from mansion_msgs_py.placement import MatrixStructure, PlacementObject, PlacementOpening, PlacementRoom, Relation
from mansion_scene.placement import place_room, warm


def hall(tables: int) -> PlacementRoom:
    """Return a hall that grows with its tables: four chairs each, a matrix of desks, cabinets along the walls."""
    side = 3.2 * (2.0 * tables) ** 0.5
    return PlacementRoom(
        room_id=f"hall_{tables}",
        room_type="hall",
        polygon=[(0.0, 0.0), (side, 0.0), (side, side), (0.0, side)],
        doors=[PlacementOpening(segment=((1.0, 0.0), (2.5, 0.0)), sill=0.0)],
        objects=[
            PlacementObject(name="table", size=(0.9, 0.9, 0.75), quantity=tables, global_="middle"),
            PlacementObject(
                name="chair",
                size=(0.45, 0.45, 0.9),
                quantity=4 * tables,
                relative=[Relation(kind="around", target="table")],
            ),
            PlacementObject(
                name="crate",
                size=(0.8, 0.8, 1.0),
                quantity=max(4, tables // 4) // 2 * 2,
                global_="middle",
                structure=MatrixStructure(rows=2, cols=max(4, tables // 4) // 2),
            ),
            PlacementObject(name="cabinet", size=(0.9, 0.45, 1.8), quantity=max(2, tables // 4), global_="edge"),
            PlacementObject(name="plant", size=(0.4, 0.4, 1.2), quantity=max(2, tables // 8)),
        ],
    )


def main() -> None:
    """Print both curves."""
    warm()
    print(f"{'one hall':<16}{'objects':>8}{'placed':>8}{'seconds':>9}{'ms/object':>11}")
    for tables in (8, 16, 32, 64, 128, 256, 360):
        room = hall(tables)
        begin = time.process_time()
        result = place_room(room, seed=0)
        spent = time.process_time() - begin
        asked = sum(obj.quantity for obj in room.objects)
        print(f"{room.room_id:<16}{asked:>8}{len(result.placements):>8}{spent:>9.2f}{1000 * spent / asked:>11.2f}")
    print(f"\n{'floor of rooms':<16}{'objects':>8}{'placed':>8}{'seconds':>9}{'ms/object':>11}")
    room = hall(8)
    asked = sum(obj.quantity for obj in room.objects)
    for rooms in (5, 10, 20, 42):
        begin = time.process_time()
        placed = sum(len(place_room(room, seed=seed).placements) for seed in range(rooms))
        spent = time.process_time() - begin
        total = asked * rooms
        print(f"{rooms:<16}{total:>8}{placed:>8}{spent:>9.2f}{1000 * spent / total:>11.2f}")


if __name__ == "__main__":
    main()
