"""Carry an object to a receptacle of any floor: carry_object.py BUILDING OBJECT RECEPTACLE."""

import sys

from mansion_skills import Robot

_, building, thing, receptacle = sys.argv if len(sys.argv) == 4 else sys.exit(__doc__)
FIELDS = {"GoToLandmark": "landmark", "UseElevator": "target_floor", "TakeStairs": "direction",
          "Place": "target"}  # fmt: skip
robot = Robot(building, reset=True)
for target, last in ((thing, "PickUp"), (receptacle, "Place")):
    route = robot.plan_route(target)
    if not hasattr(route, "skills"):
        sys.exit(f"PlanRoute {target}: {route.message}")
    for step in [*route.skills, f"{last} {target}"]:
        name, _, value = step.partition(" ")
        result = robot.skill(name, **({FIELDS.get(name, "object"): value} if value else {}))
        if result.status != "SUCCESS":
            sys.exit(f"{step}: {result.status}: {result.message}")
        print(result.message)
