"""The folder of a building: one of the user's, or a temporary one that lives as long as something needs it."""

import shutil
import tempfile
import weakref
from pathlib import Path

__all__ = ["Home"]


class Home:
    """A building's folder; a temporary one is removed with the last object that holds this one.

    Attributes
    ----------
    folder : Path
    temporary : bool

    Examples
    --------
    >>> home = Home.new()
    >>> folder = home.folder.parent
    >>> home.remove()
    >>> folder.exists()
    False
    """

    def __init__(self, folder: Path, *, temporary: Path | None = None) -> None:
        self.folder = folder
        self.temporary = temporary is not None
        self._end = weakref.finalize(self, shutil.rmtree, temporary, ignore_errors=True) if temporary else None

    @classmethod
    def new(cls) -> "Home":
        """Return a temporary home, whose folder a build may make."""
        parent = Path(tempfile.mkdtemp(prefix="mansion-"))
        return cls(parent / "building", temporary=parent)

    def remove(self) -> None:
        """Remove a temporary folder now; a folder of the user's stays."""
        if self._end is not None:
            self._end()
