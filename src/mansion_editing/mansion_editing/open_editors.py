"""The buildings that are open in one process: a limited number, of which the one used longest ago gives way."""

from typing import Final

from mansion_editing.editor import SceneEditor
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["MOST_EDITORS", "OpenEditors"]

MOST_EDITORS: Final = 16
"""An open building of ten storeys takes tens of megabytes."""


class OpenEditors:
    """Editors by name, the one used last at the end."""

    def __init__(self) -> None:
        self._editors: dict[str, SceneEditor] = {}

    def get(self, name: str) -> SceneEditor:
        """Return an editor.

        Raises
        ------
        MansionError
            ``NOT_LOADED`` when none is open under that name.
        """
        editor = self._editors.pop(name, None)
        if editor is None:
            raise MansionError(
                ErrorCode.NOT_LOADED,
                f"no building is open as {name!r}; call scene/open with its folder first",
                path="$.editor",
            )
        self._editors[name] = editor
        return editor

    def put(self, name: str, editor: SceneEditor) -> None:
        """Add an editor, or put it in the place of another of its name.

        Raises
        ------
        MansionError
            ``CONFLICT`` when too many are open, and edits wait to be saved in all of them.
        """
        if name not in self._editors and len(self._editors) >= MOST_EDITORS:
            idle = next((key for key, other in self._editors.items() if not other.state.pending), None)
            if idle is None:
                raise MansionError(
                    ErrorCode.CONFLICT,
                    f"{MOST_EDITORS} buildings are open, with edits that wait in all of them; save those of one",
                    path="$.editor",
                )
            del self._editors[idle]
        self._editors.pop(name, None)
        self._editors[name] = editor
