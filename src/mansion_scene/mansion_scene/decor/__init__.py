"""Decoration: rugs, wall and ceiling objects, and small objects on and in receptacles."""

from mansion_scene.decor.frames import scene_object
from mansion_scene.decor.room import decorate_room

__all__ = ["decorate_room", "scene_object"]
