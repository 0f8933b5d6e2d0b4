"""The folders below which the services of a process may write."""

import os
import tempfile
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["EVERYWHERE", "AllowedFolders", "allowed_at_start"]


@dataclass(frozen=True)
class AllowedFolders:
    """Folders below which may be written.

    Attributes
    ----------
    roots : tuple of Path, optional
        Without links; ``None`` for every folder, as a user's own command may write.

    Examples
    --------
    >>> AllowedFolders((Path("/srv/buildings"),)).allows(Path("/srv/buildings/office"))
    True
    >>> AllowedFolders((Path("/srv/buildings"),)).allows(Path("/srv/buildings/../secrets"))
    False
    """

    roots: tuple[Path, ...] | None = None

    def allows(self, path: Path) -> bool:
        """Whether a path, its links followed, lies in one of the folders."""
        if self.roots is None:
            return True
        try:
            place = path.resolve()
        except (OSError, RuntimeError):
            return False
        return any(place.is_relative_to(root) for root in self.roots)

    def check(self, path: Path, argument: str = "$") -> None:
        """Refuse a path that lies in none of the folders.

        Parameters
        ----------
        path : Path
        argument : str
            JSON path of what named it.

        Raises
        ------
        MansionError
            ``FORBIDDEN`` with the folders that would be accepted.
        """
        if self.allows(path):
            return
        folders = [str(root) for root in self.roots or ()]
        raise MansionError(
            ErrorCode.FORBIDDEN,
            f"{path} may not be written by this service; name a folder below {' or '.join(folders)}, or start the graph"
            " with `mansion up --allow DIR` (the parameter `allow` of a node, `allow:=DIR` for the launch file)",
            path=argument,
            details={"path": str(path), "allowed": folders},
        )


EVERYWHERE: Final = AllowedFolders()
"""For a process that the user starts: it may write wherever the user may."""

SYSTEM_TEMPORARY: Final = Path("/tmp")
"""Where a short trial writes, whatever ``TMPDIR`` says."""


def allowed_at_start(named: Iterable[str | Path]) -> AllowedFolders:
    """Return the folders in which a service may write: the working folder, the temporary ones, and those named.

    Parameters
    ----------
    named : iterable of str or Path
        What the user named; empty ones are left out.

    Notes
    -----
    The root of the file system counts only where it is named: a service that happens to be started there, as in a
    container, may not write everywhere.
    """
    places = [Path.cwd(), Path(tempfile.gettempdir()), SYSTEM_TEMPORARY]
    implied = [place.resolve() for place in places if place.resolve() != Path(os.path.sep)]
    given = [Path(name).expanduser().resolve() for name in named if str(name) not in ("", ".")]
    return AllowedFolders(tuple(dict.fromkeys([*implied, *given])))
