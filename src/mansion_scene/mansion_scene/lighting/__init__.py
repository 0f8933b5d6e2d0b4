"""Light on a floor: lamps by room, the sun, the sky and the time of day (Algorithm 1, lines 15 and 16)."""

from mansion_scene.lighting.lamps import room_lights
from mansion_scene.lighting.sky import choose_sky, sun

__all__ = ["choose_sky", "room_lights", "sun"]
