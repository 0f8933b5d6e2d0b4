"""Sky box, time of day and the sun, the same on every floor of a building.

Sky box names and their times of day are AI2-THOR's, as listed in the `procthor` package (Apache-2.0).
"""

import math
from dataclasses import dataclass

from mansion_geometry.randomness import item_generator
from mansion_msgs_py.scene import Light, Sky
from mansion_msgs_py.shapes import Point

__all__ = ["choose_sky", "sun"]


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
