"""Materials as tileable sets of textures, made by procedures of our own: the same bytes on every run."""

from mansion_assets.materials.sets import MaterialSet, art, material_set, set_names, set_of
from mansion_assets.materials.textures import TextureSet, texture_set

__all__ = ["MaterialSet", "TextureSet", "art", "material_set", "set_names", "set_of", "texture_set"]
