"""Place rooms under several seeds and print what is reached, room by room.

python benchmarks/placement/run.py benchmarks/placement/rooms.json --seeds 10
python benchmarks/placement/run.py rooms.json --seeds 3 --room bedroom_4x4 --effort 20e6 --moves 2000
python benchmarks/placement/run.py rooms.json --seeds 2 --picture placements.png
"""

import argparse
from pathlib import Path

from mansion_scene.placement import PlacementOptions
from mansion_scene.placement.evaluation import bench, table
from mansion_scene.placement.files import load_rooms
from mansion_scene.placement.picture import draw_placements


def main() -> None:
    """Read the arguments, run and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("rooms", type=Path, nargs="+", help="JSON lists of rooms")
    parser.add_argument("--seeds", type=int, default=10)
    parser.add_argument("--room", action="append", help="only these room ids")
    parser.add_argument("--effort", type=float, default=PlacementOptions.effort)
    parser.add_argument("--moves", type=int, default=PlacementOptions.moves)
    parser.add_argument("--picture", type=Path, help="draw the placements into this file")
    args = parser.parse_args()
    rooms = [room for path in args.rooms for room in load_rooms(path)]
    if args.room:
        rooms = [room for room in rooms if room.room_id in args.room]
    options = PlacementOptions(effort=args.effort, moves=args.moves)
    runs = bench(rooms, range(args.seeds), options)
    print(table({name: [measures for _, measures in pairs] for name, pairs in runs.items()}))
    if args.picture:
        drawn = [(room, result) for room in rooms for result, _ in runs[room.room_id]]
        draw_placements([room for room, _ in drawn], [result for _, result in drawn], args.picture, columns=3)


if __name__ == "__main__":
    main()
