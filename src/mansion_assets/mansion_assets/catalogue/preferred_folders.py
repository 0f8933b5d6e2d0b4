"""Folders of own assets that are preferred in a context, so that one building's are not another's."""

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from pathlib import Path
from typing import Final

__all__ = ["preferred_folders", "preferring"]

_FOLDERS: Final[ContextVar[tuple[Path, ...]]] = ContextVar("preferred_folders", default=())


def preferred_folders() -> tuple[Path, ...]:
    """Return the folders that this context prefers."""
    return _FOLDERS.get()


@contextmanager
def preferring(folders: Iterable[Path]) -> Iterator[None]:
    """Prefer the assets of some folders, and of no others, to the catalogue's own within the block.

    Notes
    -----
    What is handed to another thread or process does not take the context along; name the folders there again.

    Examples
    --------
    >>> with preferring([Path("shop")]):
    ...     [folder.name for folder in preferred_folders()]
    ['shop']
    >>> preferred_folders()
    ()
    """
    token = _FOLDERS.set(tuple(Path(folder).resolve() for folder in folders))
    try:
        yield
    finally:
        _FOLDERS.reset(token)
