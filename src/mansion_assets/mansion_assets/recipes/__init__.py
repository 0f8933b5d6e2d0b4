"""Parametric mesh recipes, one module for each kind of thing."""

__all__: list[str] = []
