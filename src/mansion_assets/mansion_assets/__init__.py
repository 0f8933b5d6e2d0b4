"""The catalogue of assets, their meshes made from parametric recipes, and finding them by words."""
