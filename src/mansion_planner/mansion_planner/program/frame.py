"""Turn and mirror the massing frame, so that buildings differ in how they stand."""

from dataclasses import dataclass

from mansion_planner.program.model import Box, Side

__all__ = ["Frame"]


@dataclass(frozen=True)
class Frame:
    """Mirror in x, mirror in y, then exchange the axes; the result lies at non-negative coordinates.

    Attributes
    ----------
    box : tuple
        Bounds of the building in the massing frame.
    origin : (float, float)
        Where their lower corner goes in plan coordinates.
    """

    box: Box
    mirror_x: bool = False
    mirror_y: bool = False
    swap: bool = False
    origin: tuple[float, float] = (0.0, 0.0)

    def point(self, point: tuple[float, float]) -> tuple[float, float]:
        """Return a point of the massing frame in plan coordinates."""
        x = self.box[2] - point[0] if self.mirror_x else point[0] - self.box[0]
        y = self.box[3] - point[1] if self.mirror_y else point[1] - self.box[1]
        x, y = round(x, 6) + 0.0, round(y, 6) + 0.0
        x, y = (y, x) if self.swap else (x, y)
        return (round(x + self.origin[0], 6), round(y + self.origin[1], 6))

    def area_box(self, box: Box) -> Box:
        """Return a box of the massing frame in plan coordinates."""
        ax, ay = self.point((box[0], box[1]))
        bx, by = self.point((box[2], box[3]))
        return (min(ax, bx), min(ay, by), max(ax, bx), max(ay, by))

    def side(self, side: Side | None) -> Side | None:
        """Return a side of the massing frame in plan coordinates."""
        if side is None:
            return None
        flipped: dict[Side, Side] = {"east": "west", "west": "east", "north": "south", "south": "north"}
        turned: dict[Side, Side] = {"north": "east", "east": "north", "south": "west", "west": "south"}
        across = side in ("east", "west")
        if (self.mirror_x and across) or (self.mirror_y and not across):
            side = flipped[side]
        return turned[side] if self.swap else side
