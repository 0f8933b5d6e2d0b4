"""A double of AI2-THOR's Controller, version 5: its calls, its metadata and its words, with a simple geometry.

Shapes of ``metadata`` and the messages are those of the documented API and of errors seen in the wild. Numbers are
single precision, and an object's ``position`` is its foot while the middle is that of ``axisAlignedBoundingBox``.
"""

import copy
from math import cos, hypot, radians, sin
from types import SimpleNamespace
from typing import Any

import numpy as np
from shapely.geometry import LineString, Point, Polygon, box
from shapely.ops import unary_union

__all__ = ["ThorDouble"]

RADIUS = 0.2
OUT_OF_SIGHT = "Target object not found within the specified visibility."


def single(value: float) -> float:
    return float(np.float32(value))


def vector(x: float, y: float, z: float) -> dict[str, float]:
    return {"x": single(x), "y": single(y), "z": single(z)}


class ThorDouble:
    """Attributes: `actions` and `scenes` that came in; `faults` maps an action to the messages it will fail with."""

    def __init__(self) -> None:
        self.actions: list[dict[str, Any]] = []
        self.scenes: list[dict[str, Any]] = []
        self.parameters: dict[str, Any] = {}
        self.faults: dict[str, list[str]] = {}
        self.objects: dict[str, dict[str, Any]] = {}
        self.agent = {"x": 0.0, "z": 0.0, "heading": 0.0, "horizon": 0.0}
        self.hand: str | None = None
        self.stopped = False
        self.last_event: Any = None

    def reset(self, scene: Any = None, **parameters: Any) -> Any:
        self.scenes.append(copy.deepcopy(scene))
        self.parameters = parameters
        self.objects, self.hand = {}, None
        self.rooms = [Polygon([(p["x"], p["z"]) for p in r["floorPolygon"]]) for r in scene["rooms"]]
        for door in scene["doors"]:
            self.objects[door["id"]] = self.thing(door, None, openness=door["openness"])
        for node in scene["objects"]:
            self.spawn(node, None)
        return self.answer("CreateHouse", next(iter(self.faults.pop("CreateHouse", [])), ""))

    def spawn(self, node: dict[str, Any], parent: str | None) -> None:
        assert node["id"] not in self.objects, f"{node['id']} is spawned twice"
        self.objects[node["id"]] = self.thing(node, parent, openness=node.get("openness"))
        for child in node["children"]:
            self.spawn(child, node["id"])

    @staticmethod
    def thing(node: dict[str, Any], parent: str | None, openness: float | None) -> dict[str, Any]:
        return {
            "center": dict(node.get("position") or {"x": 0.0, "y": 1.0, "z": 0.0}),
            "size": dict(node.get("size") or {"x": 1.0, "y": 2.0, "z": 0.1}),
            "turn": node.get("rotation", {}).get("y", 0.0),
            "asset": node["assetId"],
            "pickupable": not node.get("kinematic", True),
            "openable": openness is not None,
            "openness": openness or 0.0,
            "toggleable": "isOn" in node,
            "on": bool(node.get("isOn")),
            "parents": [parent] if parent else None,
            "solid": "position" in node and parent is None,
        }

    def stop(self) -> None:
        self.stopped = True

    def step(self, action: Any = None, **arguments: Any) -> Any:
        self.actions.append({"action": action, **copy.deepcopy(arguments)})
        handler = getattr(self, f"do_{action}", None)
        if handler is None:
            self.answer(action, f"Invalid action: {action}", code="InvalidAction")
            raise ValueError(self.last_event.metadata["errorMessage"])
        if self.faults.get(action):
            return self.answer(action, self.faults[action].pop(0))
        return self.answer(action, handler(**arguments) or "")

    def answer(self, action: str, error: str, code: str = "") -> Any:
        held = self.hand
        if held is not None:
            yaw = radians(90.0 - self.agent["heading"])
            self.objects[held]["center"] = {
                "x": self.agent["x"] + 0.4 * cos(yaw),
                "y": 1.2,
                "z": self.agent["z"] + 0.4 * sin(yaw),
            }
        self.last_event = SimpleNamespace(
            metadata={
                "lastAction": action,
                "lastActionSuccess": not error,
                "errorMessage": f"{error}\n  at UnityEngine" if error else "",
                "errorCode": code,
                "actionReturn": None,
                "sceneName": "Procedural",
                "agent": {
                    "name": "agent",
                    "position": vector(self.agent["x"], 0.9009921, self.agent["z"]),
                    "rotation": vector(0.0, self.agent["heading"], 0.0),
                    "cameraHorizon": single(self.agent["horizon"]),
                    "isStanding": True,
                },
                "inventoryObjects": [{"objectId": held, "objectType": "?"}] if held else [],
                "objects": [self.described(name) for name in self.objects],
            }
        )
        return self.last_event

    def described(self, name: str) -> dict[str, Any]:
        thing = self.objects[name]
        x, y, z = (thing["center"][axis] for axis in "xyz")
        size = thing["size"]
        return {
            "name": name,
            "objectId": name,
            "assetId": thing["asset"],
            "objectType": thing["asset"].split("_")[0],
            "position": vector(x, y - size["y"] / 2, z),
            "rotation": vector(0.0, thing["turn"], 0.0),
            "axisAlignedBoundingBox": {"center": vector(x, y, z), "size": vector(**size)},
            "visible": self.visible(name),
            "openable": thing["openable"],
            "isOpen": thing["openness"] > 0.0,
            "openness": thing["openness"],
            "toggleable": thing["toggleable"],
            "isToggled": thing["on"],
            "pickupable": thing["pickupable"],
            "isPickedUp": name == self.hand,
            "receptacle": not thing["pickupable"] or thing["openable"],
            "parentReceptacles": copy.copy(thing["parents"]),
            "receptacleObjectIds": [n for n, o in self.objects.items() if name in (o["parents"] or [])],
        }

    def footprint(self, thing: dict[str, Any]) -> Polygon:
        x, z, size = thing["center"]["x"], thing["center"]["z"], thing["size"]
        turned = round(thing["turn"] / 90.0) % 2 == 1
        w, d = (size["z"], size["x"]) if turned else (size["x"], size["z"])
        return box(x - w / 2, z - d / 2, x + w / 2, z + d / 2)

    def visible(self, name: str) -> bool:
        thing = self.objects[name]
        if (
            not thing["solid"]
            and thing["parents"] is None
            and name != self.hand
            and (thing["asset"].startswith("Door"))
        ):
            return True
        parents = [self.objects[p] for p in thing["parents"] or [] if p in self.objects]
        if any(parent["openable"] and parent["openness"] == 0.0 for parent in parents):
            return False
        here = Point(self.agent["x"], self.agent["z"])
        limit = self.parameters.get("visibilityDistance", 1.5)
        yaw = radians(90.0 - self.agent["heading"])
        ahead = (thing["center"]["x"] - here.x) * cos(yaw) + (thing["center"]["z"] - here.y) * sin(yaw)
        return self.footprint(thing).distance(here) <= limit and ahead > 0.0

    def collision(self, x: float, z: float) -> str:
        here = Point(x, z)
        for name, thing in self.objects.items():
            low = thing["center"]["y"] - thing["size"]["y"] / 2
            if thing["solid"] and low < 1.5 and self.footprint(thing).distance(here) < RADIUS - 0.06:
                return name
        return "" if unary_union(self.rooms).contains(here) else "Wall_1"

    def do_Teleport(
        self,
        position: dict[str, float],
        rotation: dict[str, float],
        horizon: float,
        standing: bool,
        forceAction: bool = False,
    ) -> str:
        hit = self.collision(position["x"], position["z"])
        if hit and not forceAction:
            return f"Collided with: {hit} at position {position}"
        if not -30.0 <= horizon <= 60.0:
            return f"Each horizon must be in [-30:60]. You gave {horizon}."
        self.agent = {"x": position["x"], "z": position["z"], "heading": rotation["y"], "horizon": horizon}
        return ""

    def move(self, distance: float) -> str:
        yaw = radians(90.0 - self.agent["heading"])
        dx, dz = distance * cos(yaw), distance * sin(yaw)
        way = LineString([(self.agent["x"], self.agent["z"]), (self.agent["x"] + dx, self.agent["z"] + dz)])
        count = max(2, int(hypot(dx, dz) / 0.05) + 1)
        for i in range(1, count + 1):
            point = way.interpolate(i / count, normalized=True)
            if hit := self.collision(point.x, point.y):
                return f"{hit} is blocking Agent 0 from moving by ({dx:.4f}, 0.0000, {dz:.4f})."
        self.agent["x"] += dx
        self.agent["z"] += dz
        return ""

    def do_MoveAhead(self, moveMagnitude: float) -> str:
        return self.move(moveMagnitude)

    def do_MoveBack(self, moveMagnitude: float) -> str:
        return self.move(-moveMagnitude)

    def do_RotateRight(self, degrees: float = 90.0) -> None:
        self.agent["heading"] = (self.agent["heading"] + degrees) % 360.0

    def do_RotateLeft(self, degrees: float = 90.0) -> None:
        self.do_RotateRight(-degrees)

    def do_LookUp(self, degrees: float = 30.0) -> str:
        return self.tilt(-degrees, "up", "above")

    def do_LookDown(self, degrees: float = 30.0) -> str:
        return self.tilt(degrees, "down", "below")

    def tilt(self, degrees: float, way: str, side: str) -> str:
        after = self.agent["horizon"] + degrees
        if not -30.0 <= after <= 60.0:
            return f"can't look {way} beyond {30 if way == 'up' else 60} degrees {side} the forward horizon"
        self.agent["horizon"] = after
        return ""

    def unseen(self, name: str, force: bool) -> str:
        if name not in self.objects:
            return f"objectId: {name} is not the objectId on any object in the scene!"
        return "" if force or self.visible(name) else OUT_OF_SIGHT

    def do_PickupObject(self, objectId: str, forceAction: bool = False) -> str:
        if self.hand is not None:
            return "Agent hand has something in it already! Can't pick up anything else"
        if error := self.unseen(objectId, forceAction):
            return error
        if not self.objects[objectId]["pickupable"]:
            return f"{objectId} must have the property CanPickup to be picked up."
        self.hand = objectId
        self.objects[objectId].update(parents=None, solid=False)
        return ""

    def do_PutObject(self, objectId: str, forceAction: bool = False, placeStationary: bool = True) -> str:
        if self.hand is None:
            return "Can't place an object if Agent isn't holding anything"
        if error := self.unseen(objectId, forceAction):
            return error
        target = self.objects[objectId]
        if target["openable"] and target["openness"] == 0.0:
            return "Target openable Receptacle is CLOSED, can't place if target is not open!"
        held = self.objects[self.hand]
        middle = target["center"]
        top = middle["y"] if target["openable"] else middle["y"] + target["size"]["y"] / 2
        held.update(center={**middle, "y": top + held["size"]["y"] / 2}, parents=[objectId], solid=False)
        self.hand = None
        return ""

    def do_PlaceObjectAtPoint(self, objectId: str, position: dict[str, float]) -> str:
        thing = self.objects[objectId]
        thing.update(center={**position, "y": position["y"] + thing["size"]["y"] / 2}, parents=["Floor_1"], solid=True)
        self.hand = None if self.hand == objectId else self.hand
        return ""

    def do_OpenObject(self, objectId: str, forceAction: bool = False) -> str:
        return self.swing(objectId, forceAction, 1.0)

    def do_CloseObject(self, objectId: str, forceAction: bool = False) -> str:
        return self.swing(objectId, forceAction, 0.0)

    def swing(self, name: str, force: bool, openness: float) -> str:
        if error := self.unseen(name, force):
            return error
        if not self.objects[name]["openable"]:
            return f"{name} is not an Openable object"
        self.objects[name]["openness"] = openness
        return ""

    def do_ToggleObjectOn(self, objectId: str, forceAction: bool = False) -> str:
        return self.toggle(objectId, forceAction, True)

    def do_ToggleObjectOff(self, objectId: str, forceAction: bool = False) -> str:
        return self.toggle(objectId, forceAction, False)

    def toggle(self, name: str, force: bool, on: bool) -> str:
        if error := self.unseen(name, force):
            return error
        if not self.objects[name]["toggleable"]:
            return f"{name} is not toggleable"
        self.objects[name]["on"] = on
        return ""
