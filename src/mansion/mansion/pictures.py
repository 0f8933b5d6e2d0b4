"""Floor plans as pictures that a notebook shows and a file takes."""

from dataclasses import dataclass, field
from pathlib import Path

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import write_atomic
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.scene import FloorScene

__all__ = ["FloorPlan"]


@dataclass(frozen=True)
class FloorPlan:
    """The plan of a floor, drawn when it is looked at.

    Parameters
    ----------
    scene : FloorScene

    Examples
    --------
    >>> plan = b.plan(1)
    >>> plan.svg[:4], plan.png[1:4]
    ('<svg', b'PNG')
    >>> plan.save("kitchen.gif")
    Traceback (most recent call last):
        ...
    mansion_msgs_py.errors.MansionError: INVALID_PAYLOAD: a plan is written as .svg or .png, not as kitchen.gif
    """

    scene: FloorScene = field(repr=False)

    @property
    def floor(self) -> int:
        """Number of the floor."""
        return self.scene.floor

    @property
    def svg(self) -> str:
        """The plan as SVG text."""
        with importing:
            from mansion_export.plan import plan_svg

        return plan_svg(self.scene)

    @property
    def png(self) -> bytes:
        """The plan as the bytes of a PNG file."""
        with importing:
            from mansion_export.plan import plan_png

        return plan_png(self.scene)

    def save(self, file: str | Path) -> Path:
        """Write the plan to a file, SVG or PNG by its suffix, and return its path."""
        path = Path(file)
        if path.suffix not in (".svg", ".png"):
            raise MansionError(ErrorCode.INVALID_PAYLOAD, f"a plan is written as .svg or .png, not as {path}")
        write_atomic(path, self.png if path.suffix == ".png" else self.svg.encode())
        return path

    def __repr__(self) -> str:
        return f"<plan of floor {self.floor}>"

    def _repr_svg_(self) -> str:
        return self.svg

    def _repr_png_(self) -> bytes:
        return self.png
