"""Carry an object to a receptacle of any floor: carry_object.py BUILDING OBJECT RECEPTACLE."""

import sys

from mansion_skills import Robot

building, thing, receptacle = sys.argv[1:]
robot = Robot(building, reset=True)
arguments = {"GoToLandmark": "landmark", "GoNearObject": "object", "UseElevator": "target_floor",
             "TakeStairs": "direction"}  # fmt: skip
for target, skill in ((thing, "PickUp"), (receptacle, "Place")):
    for step in robot.plan_route(target).skills:
        name, _, value = step.partition(" ")
        print(robot.skill(name, **({arguments[name]: value} if value else {})).message)
    print(robot.skill(skill, **{"object" if skill == "PickUp" else "target": target}).message)
