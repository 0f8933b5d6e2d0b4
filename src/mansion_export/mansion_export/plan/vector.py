"""The SVG writer: one group for each layer and element, coordinates in centimetres, no dates."""

from collections.abc import Sequence
from itertools import groupby
from xml.sax.saxutils import escape, quoteattr

from mansion_export.plan.drawing import Drawing, draw_plan
from mansion_export.plan.shapes import Area, Canvas, Label, Shape
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.shapes import Point

__all__ = ["drawing_svg", "plan_svg"]

SCREEN = 1400.0
"""Pixels of the longer side where a viewer does not scale the picture."""

FONT = "Inter, 'Segoe UI', 'DejaVu Sans', Helvetica, Arial, sans-serif"


def plan_svg(scene: FloorScene) -> str:
    """Write a floor's plan as SVG 1.1.

    Parameters
    ----------
    scene : FloorScene

    Returns
    -------
    str
        The document; the same bytes for the same scene. Each room, wall, door, window, core and object is a group with
        its id in ``data-id`` and a ``<title>`` that browsers show when it is pointed at.
    """
    return drawing_svg(draw_plan(scene))


def drawing_svg(drawing: Drawing) -> str:
    """Write a drawing as SVG; see `plan_svg`."""
    scale = SCREEN / max(drawing.width, drawing.height)
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{drawing.width * scale:.0f}" '
        f'height="{drawing.height * scale:.0f}" '
        f'viewBox="0 0 {_cm(drawing.width)} {_cm(drawing.height)}" '
        f'font-family={quoteattr(FONT)} stroke-linejoin="round" stroke-linecap="butt">\n'
        f"<title>{escape(drawing.title)}</title>\n"
        f'<rect width="100%" height="100%" fill="#ffffff"/>\n'
    ]
    for layer, canvases in groupby(drawing.canvases, key=lambda canvas: canvas.layer):
        parts.append(f'<g class="{layer}">\n')
        parts += [_element(canvas, drawing) for canvas in canvases]
        parts.append("</g>\n")
    parts.append("</svg>\n")
    return "".join(parts)


def _element(canvas: Canvas, drawing: Drawing) -> str:
    body = "".join(_shape(shape, drawing) for shape in canvas.shapes)
    if not canvas.id:
        return f"{body}\n"
    title = f"<title>{escape(canvas.title)}</title>" if canvas.title else ""
    return f"<g data-id={quoteattr(canvas.id)}>{title}{body}</g>\n"


def _shape(shape: Shape, drawing: Drawing) -> str:
    if isinstance(shape, Label):
        return _text(shape, drawing)
    if isinstance(shape, Area):
        path = "".join(f"M{_path(points, drawing)}Z" for points in (shape.points, *shape.holes))
        rule = ' fill-rule="evenodd"' if shape.holes else ""
        return f'<path d="{path}"{rule}{_fill(shape.fill)}{_stroke(shape.stroke, shape.width)}/>'
    dash = f' stroke-dasharray="{_cm(shape.dash)}"' if shape.dash else ""
    path = f"M{_path(shape.points, drawing)}"
    return f'<path d="{path}" fill="none"{_stroke(shape.stroke, shape.width)}{dash}/>'


def _text(label: Label, drawing: Drawing) -> str:
    x, y = _cm(label.at[0] - drawing.x0), _cm(drawing.y1 - label.at[1])
    turn = f' transform="rotate({-label.angle:g} {x} {y})"' if label.angle else ""
    anchor = f' text-anchor="{label.anchor}"' if label.anchor != "start" else ""
    weight = ' font-weight="600"' if label.bold else ""
    halo = (
        f' stroke="#ffffff" stroke-opacity="0.8" stroke-width="{_cm(0.22 * label.size)}" paint-order="stroke"'
        if label.halo
        else ""
    )
    return (
        f'<text x="{x}" y="{y}" dy="0.35em" font-size="{_cm(label.size)}" fill="{label.color}"'
        f"{anchor}{weight}{halo}{turn}>{escape(label.text)}</text>"
    )


def _path(points: Sequence[Point], drawing: Drawing) -> str:
    x0, y1 = drawing.x0, drawing.y1
    return "L".join(f"{100 * (x - x0):.1f} {100 * (y1 - y):.1f}" for x, y in points)


def _fill(color: str | None) -> str:
    if color is None:
        return ' fill="none"'
    if len(color) == 9:
        return f' fill="{color[:7]}" fill-opacity="{int(color[7:], 16) / 255:.2f}"'
    return f' fill="{color}"'


def _stroke(color: str | None, width: float) -> str:
    return f' stroke="{color}" stroke-width="{_cm(width)}"' if color and width > 0 else ""


def _cm(metres: float) -> str:
    return f"{100 * metres:.1f}".removesuffix(".0")
