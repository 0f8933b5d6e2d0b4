"""The table of what labels in a segmentation mean."""

from collections.abc import Iterable

from mansion_msgs_py.scene import FloorScene

__all__ = ["Names"]


class Names:
    """Ids in a fixed order; new ones are added at the end, so that an index never changes its meaning.

    Parameters
    ----------
    scenes : iterable of FloorScene
    """

    def __init__(self, scenes: Iterable[FloorScene]) -> None:
        self._index: dict[str, int] = {}
        self._table: tuple[str, ...] = ()
        for scene in scenes:
            for room in scene.rooms:
                self.index(room.id)
                self.index(f"{room.id}/ceiling")
            for name in _ids(scene):
                self.index(name)

    def __contains__(self, name: object) -> bool:
        return name in self._index

    def index(self, name: str) -> int:
        """Return the index of an id, a new one when it has none."""
        return self._index.setdefault(name, len(self._index))

    @property
    def table(self) -> tuple[str, ...]:
        """The ids, each at its index."""
        if len(self._table) != len(self._index):
            self._table = tuple(self._index)
        return self._table


def _ids(scene: FloorScene) -> list[str]:
    return [
        *(wall.id for wall in scene.walls),
        *(door.id for door in scene.doors),
        *(window.id for window in scene.windows),
        *(core.id for core in scene.cores),
        *(thing.id for thing in scene.objects),
    ]
