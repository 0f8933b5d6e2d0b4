"""Files of a folder that are written one after the other, and all put back where one of them cannot be.

The former files are kept by further names of theirs (hard links), so that putting them back needs no space on a disk
that is full.
"""

import os
import shutil
from contextlib import suppress
from pathlib import Path

from mansion_msgs_py.building_folder import file_in
from mansion_msgs_py.files import write_atomic

__all__ = ["ReplacedFiles"]


class ReplacedFiles:
    """The files that one edit replaces.

    Parameters
    ----------
    folder : Path
        The building's folder.
    kept : Path
        Where the former files are kept, on the same file system; what an edit before this one left there is removed.
    """

    def __init__(self, folder: Path, kept: Path) -> None:
        self._folder = folder
        self._kept = kept
        self._former: dict[Path, Path | None] = {}
        shutil.rmtree(kept, ignore_errors=True)

    def write(self, name: str, data: bytes) -> None:
        """Replace a file.

        Raises
        ------
        MansionError
            ``INVALID_PAYLOAD`` for a name that leads out of the folder.
        OSError
            When it cannot be written.
        """
        file = file_in(self._folder, name)
        self._keep(file)
        write_atomic(file, data, durable=True)

    def remove(self, name: str) -> None:
        """Take a file away."""
        file = file_in(self._folder, name)
        self._keep(file)
        file.unlink(missing_ok=True)

    def _keep(self, file: Path) -> None:
        if file in self._former:
            return
        self._former[file] = None
        if file.exists():
            self._kept.mkdir(parents=True, exist_ok=True)
            former = self._kept / str(len(self._former))
            try:
                os.link(file, former)
            except OSError:  # a file system without links, or a file that has too many
                shutil.copy2(file, former)
            self._former[file] = former

    def put_back(self) -> None:
        """Give every file the content that it had."""
        for file, former in self._former.items():
            if former is None:
                file.unlink(missing_ok=True)
            elif former.exists():
                former.replace(file)
        self._former.clear()

    def forget(self) -> None:
        """Let the former files go."""
        self._former.clear()
        with suppress(OSError):
            shutil.rmtree(self._kept)
