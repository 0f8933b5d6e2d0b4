"""Random skills over buildings, with every invariant checked: time, memory, and what was refused.

PYTHONPATH=tests/support python benchmarks/skills/random_skills.py BUILDING... [--skills 10000] [--seed 0]
"""

import argparse
import resource
import time
from collections import Counter
from random import Random

from invariants import check_world
from mansion_skills import Robot
from mansion_skills.engine import Engine

NEAR: dict[str, str] = {}
"""Session to what its robot went near to last."""


def step(robot: Robot, rng: Random) -> str:
    """Run one skill that makes sense often enough; return its status."""
    session = robot.engine.session(robot.session)
    world, floor = session.world, session.robot.floor
    here = [state.id for state in world.objects.on_floor(floor)]
    takeable = [name for name in here if world.objects.kinds[name].pickupable]
    holders = [name for name in here if world.objects.kinds[name].receptacle]
    doors = list(world.view(floor).doors)
    marks = [mark.name for mark in world.view(floor).landmarks]
    last = NEAR.get(robot.session, "")
    near = rng.choice([rng.choice(takeable or here), rng.choice(holders or here), rng.choice(doors)])
    choices = [
        ("GoNearObject", {"object": near}),
        ("GoNearObject", {"object": near}),
        ("PickUp", {"object": last}),
        ("PickUp", {"object": last}),
        ("Place", {"target": last or "floor", "relation": rng.choice(["on", "in", "in_front"])}),
        ("Place", {"target": rng.choice([last, "floor"]), "relation": "on"}),
        ("OpenObject", {"object": last}),
        ("CloseObject", {"object": last}),
        ("ToggleOn", {"object": last}),
        ("ToggleOff", {"object": last}),
        ("OpenDoor", {"door": last}),
        ("CloseDoor", {"door": last}),
        ("GoToLandmark", {"landmark": rng.choice(marks)}),
        ("GoToLandmark", {"landmark": "elevator"}),
        ("GoToLandmark", {"landmark": "stairs"}),
        ("CallElevator", {}),
        ("UseElevator", {"target_floor": rng.choice([*world.building.floors, 99])}),
        ("TakeStairs", {"direction": rng.choice(["Up", "Down", "Sideways"])}),
        ("MoveAhead", {"distance": rng.uniform(-1, 1)}),
        ("Rotate", {"degrees": rng.uniform(-180, 180)}),
        ("LookUp", {}),
        ("LookDown", {}),
        ("ListVisible", {}),
        ("PlanRoute", {"target": rng.choice(here)}),
    ]
    name, arguments = rng.choice(choices)
    result = robot.skill(name, **arguments)
    if name == "GoNearObject":
        NEAR[robot.session] = near
    return str(getattr(result, "status", "SUCCESS"))


def main() -> None:
    """Run and print."""
    parser = argparse.ArgumentParser()
    parser.add_argument("buildings", nargs="+")
    parser.add_argument("--skills", type=int, default=10_000)
    parser.add_argument("--check-every", type=int, default=10)
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    rng = Random(options.seed)
    counts: Counter[str] = Counter()
    engine = Engine(durable=False)
    robots = [
        Robot(path, f"{name}{number}", world="benchmark", reset=name == "a", engine=engine)
        for number, path in enumerate(options.buildings)
        for name in ("a", "b")
    ]
    begin, memory = time.process_time(), []
    for number in range(options.skills):
        robot = rng.choice(robots)
        counts[step(robot, rng)] += 1
        if number % options.check_every == 0:
            check_world(engine.session(robot.session).world)
        if number % max(1, options.skills // 5) == 0:
            memory.append(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024)
    seconds = time.process_time() - begin
    print(f"{options.skills} skills, {len(options.buildings)} buildings: every invariant held")
    print(f"{seconds / options.skills * 1e3:.2f} ms of processor time each; {dict(counts)}")
    print(f"peak memory at each fifth, MB: {memory}")


if __name__ == "__main__":
    main()
