"""A floor's walls, doors, windows, stairs, lifts and materials, from its layout (Algorithm 1, lines 9 and 10)."""

from mansion_scene.structure.floor_structure import FloorStructure, build_structure

__all__ = ["FloorStructure", "build_structure"]
