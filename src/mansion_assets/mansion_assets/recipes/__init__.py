"""Parametric mesh recipes, one module for each family of objects."""

__all__: list[str] = []
