"""Decoration: rugs, wall and ceiling objects, and small objects on and in receptacles."""

from mansion_scene.decor.decorate import decorate_room
from mansion_scene.decor.frames import scene_object

__all__ = ["decorate_room", "scene_object"]
