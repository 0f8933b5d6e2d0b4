"""Material names of AI2-THOR for the words of our floor, wall and ceiling materials.

The names are those of ``material-database.json`` of the PyPI package procthor (Apache-2.0).
"""

from typing import Any

__all__ = ["CEILING", "SKYBOXES", "WALL", "floor_material", "room_type", "wall_material"]

WALL: dict[str, Any] = {"name": "PureWhite", "color": {"r": 0.93, "g": 0.92, "b": 0.89}}
CEILING: dict[str, Any] = {"name": "PureWhite", "color": {"r": 0.96, "g": 0.96, "b": 0.95}}

FLOORS: tuple[tuple[str, str], ...] = (
    ("checker", "KitchenTilesCheckerboard"),
    ("hex", "HexTiles"),
    ("marble", "TexturesCom_Marble Floor Tiles 1_diffuse_S"),
    ("granite", "GREYGRANITE"),
    ("terrazzo", "TexturesCom_Marble Floor Tiles 1_diffuse_S"),
    ("stone", "CreamMarbleTiles"),
    ("mosaic", "SmallTiles"),
    ("tile", "KitchenFloor"),
    ("ceramic", "CeramicTiles1"),
    ("concrete", "ConcreteFloorSmooth"),
    ("epoxy", "ConcreteFloorSmooth"),
    ("screed", "ConcreteFloorSmooth"),
    ("resin", "ConcreteFloorSmooth"),
    ("carpet", "RoboTHOR_Carpet_Mat"),
    ("rubber", "CarpetDark"),
    ("vinyl", "GreyFloor"),
    ("linoleum", "GreyFloor"),
    ("laminate", "TexturesCom_WoodFine0050_1_seamless_S_pale"),
    ("walnut", "DarkWoodFloors"),
    ("dark", "DarkWoodFloors"),
    ("bamboo", "WoodGrain_Tan"),
    ("cherry", "WoodFineDarkFloorsRedNRM"),
    ("parquet", "WoodFloorsCross"),
    ("oak", "TexturesCom_WoodFine0050_1_seamless_S"),
    ("wood", "TexturesCom_WoodFine0038_1_seamless_S"),
)

WALLS: tuple[tuple[str, str], ...] = (
    ("subway", "SubwayTiles2"),
    ("mosaic", "SmallKitchenTiles"),
    ("tile", "SubwayTilesAO"),
    ("ceramic", "CeramicTiles2"),
    ("brick", "RedBrick"),
    ("concrete", "ConcreteBoards1"),
    ("marble", "TexturesCom_MarbleWhite0067_1_seamless_S"),
    ("stone", "TexturesCom_BrickRound0044_1_seamless_S"),
    ("panel", "RoboTHOR_Wall_Panel_Fabric_Mat"),
    ("wood", "WhiteWood"),
)

PAINTS: tuple[tuple[str, tuple[float, float, float]], ...] = (
    ("sage", (0.72, 0.78, 0.69)),
    ("mint", (0.78, 0.89, 0.83)),
    ("green", (0.72, 0.82, 0.71)),
    ("sky", (0.77, 0.86, 0.93)),
    ("blue", (0.73, 0.81, 0.90)),
    ("terracotta", (0.85, 0.62, 0.50)),
    ("peach", (0.96, 0.84, 0.75)),
    ("pink", (0.95, 0.82, 0.83)),
    ("yellow", (0.97, 0.92, 0.70)),
    ("beige", (0.91, 0.86, 0.77)),
    ("cream", (0.96, 0.93, 0.84)),
    ("warm", (0.94, 0.91, 0.86)),
    ("charcoal", (0.35, 0.36, 0.38)),
    ("grey", (0.80, 0.81, 0.82)),
    ("gray", (0.80, 0.81, 0.82)),
    ("white", (0.95, 0.95, 0.93)),
)

SKYBOXES: tuple[tuple[str, str, str], ...] = (
    ("noon", "Midday", "Sky1"),
    ("morning", "Midday", "SkyMountain"),
    ("sunset", "GoldenHour", "SkySunset"),
    ("golden", "GoldenHour", "SkyTreeFarm"),
    ("dusk", "BlueHour", "Sky2Dusk"),
    ("blue_hour", "BlueHour", "Sky2Dusk"),
    ("", "Midday", "SkySFGarden"),
)
"""Word in our sky's name, time of day and AI2-THOR's sky box; the last stands for all others."""

TYPES: tuple[tuple[str, tuple[str, ...]], ...] = (
    ("Bathroom", ("bath", "toilet", "wc", "shower", "restroom", "washroom")),
    ("Kitchen", ("kitchen", "kitchenette", "pantry")),
    ("Bedroom", ("bedroom", "guest_room", "hotel_room", "patient_room", "suite", "dorm")),
)


def floor_material(words: str) -> dict[str, Any]:
    """Return the material of a floor that is described so."""
    text = words.lower().replace("_", " ")
    return {"name": next((name for word, name in FLOORS if word in text), "GreyFloor")}


def wall_material(words: str) -> dict[str, Any]:
    """Return the material of a wall or ceiling that is described so."""
    text = words.lower().replace("_", " ")
    for word, name in WALLS:
        if word in text:
            return {"name": name}
    for word, (r, g, b) in PAINTS:
        if word in text:
            return {"name": "PureWhite", "color": {"r": r, "g": g, "b": b}}
    return dict(WALL)


def room_type(words: str) -> str:
    """Return which of ProcTHOR's four room types comes nearest."""
    text = words.lower()
    return next((name for name, keys in TYPES if any(key in text for key in keys)), "LivingRoom")
