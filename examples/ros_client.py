"""Call the services of the node graph: of the one that runs (`mansion up`), else of a private one.

.venv/bin/python examples/ros_client.py --output out/examples    # after examples/build.py
"""

import argparse
from pathlib import Path

from mansion_bringup.graph.processes import graph_client
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.skills import Loaded, WhereAmI


def main() -> None:
    """Plan a building, and ask a robot where it is."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--output", type=Path, default=Path("out/examples"), metavar="DIR")
    building = (parser.parse_args().output / "clinic").resolve()

    with graph_client(allow=[building], notice=print) as mansion:
        plan = mansion.plan(BuildRequest(description="A small flat for two"))
        print("planned:", *(room.id for room in plan.program.floors[0].rooms))

        # A session of its own, so that the robot of a graph which runs already stays where it is.
        session = {"session": "example"}
        loaded = mansion.call("load_building", {"path": str(building), **session}, reply=Loaded)
        print(f"loaded {loaded.building_id}, floors {loaded.floors}")
        mansion.call("skills/go_to_landmark", {"landmark": "elevator", **session})
        place = mansion.call("example/skills/where_am_i", reply=WhereAmI)
        print(f"on floor {place.floor} at ({place.pose.x:.2f}, {place.pose.y:.2f})")


if __name__ == "__main__":
    main()
