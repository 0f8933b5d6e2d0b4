"""Meshes of the catalogue's assets, made from parametric recipes."""

from mansion_scene.assets.builder import Box
from mansion_scene.assets.meshes import MeshPart, collision_boxes, mesh
from mansion_scene.assets.registry import recipe_names
from mansion_scene.catalogue.palette import PbrMaterial

__all__ = ["Box", "MeshPart", "PbrMaterial", "collision_boxes", "mesh", "recipe_names"]
