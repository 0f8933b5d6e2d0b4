"""Procedures by family; each draws the tile of a material on its canvas."""
