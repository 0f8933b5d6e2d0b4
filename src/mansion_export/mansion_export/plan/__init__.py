"""Floor plans: a drawing of shapes in plan metres, written as SVG or PNG."""

from mansion_export.plan.drawing import Drawing, draw_plan
from mansion_export.plan.raster import plan_png
from mansion_export.plan.vector import plan_svg

__all__ = ["Drawing", "draw_plan", "plan_png", "plan_svg"]
