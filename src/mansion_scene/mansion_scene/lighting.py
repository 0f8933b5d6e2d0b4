"""Lights of a floor: lamps by room, the sun, the sky and the time of day (Algorithm 1, lines 15 and 16).

Sky box names and their times of day are AI2-THOR's, as listed in the `procthor` package (Apache-2.0).
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import shapely
from shapely.geometry import Polygon

from mansion_geometry.randomness import item_generator
from mansion_knowledge import is_class
from mansion_msgs_py.scene import Light, SceneObject, SceneRoom, Sky
from mansion_msgs_py.shapes import Point

__all__ = ["LightPlan", "choose_sky", "light_plan", "room_lights", "sun"]


@dataclass(frozen=True)
class _Daytime:
    """Hours of a time of day, its sun's elevation range in degrees, and colours."""

    weight: float
    hours: tuple[float, float]
    elevation: tuple[float, float]
    sky: str
    light: str
    intensity: float
    boxes: tuple[str, ...]


_DAYTIMES = (
    _Daytime(
        0.75,
        (9.0, 16.0),
        (30.0, 65.0),
        "#bfd9ff",
        "#fff6e6",
        1.0,
        (
            "Sky1",
            "Sky2",
            "SkyAlbany",
            "SkyAlbanyHill",
            "SkyDalyCity",
            "SkyEmeryville",
            "SkyGarden",
            "SkyGasworks",
            "SkyMosconeCenter",
            "SkyMountain",
            "SkyOakland",
            "SkySeaStacks",
            "SkySFCityHall",
            "SkySFDowntown",
            "SkySFGarden",
        ),
    ),
    _Daytime(
        0.17,
        (17.5, 19.5),
        (5.0, 15.0),
        "#ffd9a8",
        "#ffc98a",
        0.7,
        ("SkyNeighborhood", "SkySouthLakeUnion", "SkySunset", "SkyTreeFarm", "SkyTropical"),
    ),
    _Daytime(0.08, (20.0, 21.0), (-4.0, -1.0), "#5a6d99", "#8fa3d9", 0.15, ("Sky2Dusk",)),
)


def choose_sky(seed: int) -> Sky:
    """Draw the sky of a building from its seed."""
    generator = item_generator(seed, "sky")
    index = int(generator.choice(len(_DAYTIMES), p=[day.weight for day in _DAYTIMES]))
    day = _DAYTIMES[index]
    hour = float(generator.uniform(*day.hours))
    low, high = day.elevation
    # The sun is highest at noon and follows the hour within the day's range.
    share = (hour - day.hours[0]) / (day.hours[1] - day.hours[0])
    elevation = low + (high - low) * math.sin(math.pi * share) if index == 0 else high - (high - low) * share
    return Sky(
        name=day.boxes[int(generator.integers(len(day.boxes)))],
        hour=round(hour, 2),
        sun_azimuth=round((hour * 15.0) % 360.0, 2),
        sun_elevation=round(elevation, 2),
        color=day.sky,
    )


def sun(sky: Sky, floor: int, center: Point) -> Light:
    """Return the sun as a directional light that shines from its position towards a floor's centre."""
    day = next(day for day in _DAYTIMES if day.sky == sky.color)
    azimuth, elevation = math.radians(sky.sun_azimuth), math.radians(max(sky.sun_elevation, 1.0))
    distance = 100.0
    return Light(
        id=f"F{floor}/sun",
        kind="directional",
        position=(
            round(center[0] + distance * math.cos(elevation) * math.sin(azimuth), 3),
            round(center[1] + distance * math.cos(elevation) * math.cos(azimuth), 3),
            round(distance * math.sin(elevation), 3),
        ),
        color=day.light,
        intensity=day.intensity,
        range=10.0 * distance,
    )


_BELOW_CEILING = 0.15


@dataclass(frozen=True)
class LightPlan:
    """How a room type is lit: correlated colour temperature as a colour, intensity of a lamp, spacing in metres."""

    color: str
    intensity: float
    spacing: float


_WARM, _NEUTRAL, _COOL = "#ffe2bd", "#fff4e5", "#f2f6ff"
_PLANS: tuple[tuple[str, LightPlan], ...] = (
    ("clinical", LightPlan(_COOL, 1.1, 3.0)),
    ("teaching", LightPlan(_NEUTRAL, 1.1, 3.0)),
    ("office", LightPlan(_NEUTRAL, 1.0, 3.0)),
    ("wet", LightPlan(_NEUTRAL, 0.8, 2.5)),
    ("store", LightPlan(_NEUTRAL, 0.6, 4.0)),
    ("assembly", LightPlan(_NEUTRAL, 1.0, 4.0)),
    ("sleeping", LightPlan(_WARM, 0.6, 4.5)),
    ("living", LightPlan(_WARM, 0.8, 4.0)),
    ("circulation", LightPlan(_NEUTRAL, 0.7, 4.0)),
)
_DEFAULT = LightPlan(_NEUTRAL, 0.8, 3.5)


def light_plan(room_type: str) -> LightPlan:
    """Return how a room of a type is lit."""
    return next((plan for name, plan in _PLANS if is_class(room_type, name)), _DEFAULT)


def room_lights(room: SceneRoom, objects: Sequence[SceneObject]) -> list[Light]:
    """Return the lights of a room: a grid below its ceiling, and one in each of its lamps.

    Outdoor rooms have no ceiling, so that only their lamps give light.
    """
    lights = [] if is_class(room.room_type, "outdoor") else _ceiling_lights(room)
    lamps = [item for item in objects if item.room == room.id and _is_lamp(item)]
    for number, lamp in enumerate(lamps, start=1):
        x, y, z = lamp.position
        lights.append(
            Light(
                id=f"{room.id}/lamp_light_{number}",
                kind="point",
                position=(x, y, round(z + 0.35 * lamp.size[2], 4)),
                color=_WARM,
                intensity=0.35 if bool(lamp.states.get("on", True)) else 0.0,
                range=4.0,
                room=room.id,
            )
        )
    return lights


def _is_lamp(item: SceneObject) -> bool:
    words = item.category.lower().replace("_", " ").split()
    return item.mount != "ceiling" and ("lamp" in words or item.category.lower().endswith("lamp"))


def _ceiling_lights(room: SceneRoom) -> list[Light]:
    plan = light_plan(room.room_type)
    net = Polygon(room.net_polygon, room.net_holes)
    height = round(room.ceiling_height - _BELOW_CEILING, 4)
    reach = round(max(3.0, 2.2 * math.hypot(plan.spacing / 2, height)), 4)
    return [
        Light(
            id=f"{room.id}/light_{number}",
            kind="point",
            position=(x, y, height),
            color=plan.color,
            intensity=plan.intensity,
            range=reach,
            room=room.id,
        )
        for number, (x, y) in enumerate(_grid(net, plan.spacing), start=1)
    ]


def _grid(net: Polygon, spacing: float) -> list[tuple[float, float]]:
    """Return the centres of even cells of the room's bounds that lie inside it, at least one point."""
    x0, y0, x1, y1 = net.bounds
    columns = max(round((x1 - x0) / spacing), 1)
    rows = max(round((y1 - y0) / spacing), 1)
    inner = net.buffer(-0.2)
    points = [
        (round(x0 + (x1 - x0) * (column + 0.5) / columns, 4), round(y0 + (y1 - y0) * (row + 0.5) / rows, 4))
        for row in range(rows)
        for column in range(columns)
    ]
    inside = [point for point in points if shapely.contains_xy(inner, *point)]
    if inside:
        return inside
    middle = net.representative_point()
    return [(round(middle.x, 4), round(middle.y, 4))]
