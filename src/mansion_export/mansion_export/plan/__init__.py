"""Floor plans: a drawing of shapes in plan metres, written as SVG or PNG."""

from mansion_export.plan.drawing import Drawing, draw_plan
from mansion_export.plan.raster import plan_png
from mansion_export.plan.vector import plan_svg
from mansion_msgs_py.building_folder import floor_directory
from mansion_msgs_py.scene import FloorScene

__all__ = ["Drawing", "draw_plan", "plan_files", "plan_png", "plan_svg"]


def plan_files(scene: FloorScene) -> dict[str, bytes]:
    """Return ``plan.svg`` and ``plan.png`` of a floor by their paths in the building's folder."""
    folder = floor_directory(scene.floor)
    return {f"{folder}/plan.svg": plan_svg(scene).encode(), f"{folder}/plan.png": plan_png(scene)}
