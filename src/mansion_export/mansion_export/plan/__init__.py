"""Floor plans: a drawing of shapes in plan metres, written as SVG or PNG."""

from mansion_export.plan.drawing import Drawing, draw_plan
from mansion_export.plan.raster import drawing_png, plan_png
from mansion_export.plan.vector import drawing_svg, plan_svg
from mansion_msgs_py.building_folder import floor_directory
from mansion_msgs_py.scene import FloorScene

__all__ = ["Drawing", "draw_plan", "plan_files", "plan_png", "plan_svg"]


def plan_files(scene: FloorScene) -> dict[str, bytes]:
    """Return ``plan.svg`` and ``plan.png`` of a floor by their paths in the building's folder."""
    folder, drawing = floor_directory(scene.floor), draw_plan(scene)
    return {f"{folder}/plan.svg": drawing_svg(drawing).encode(), f"{folder}/plan.png": drawing_png(drawing)}
