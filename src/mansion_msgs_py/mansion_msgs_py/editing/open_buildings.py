"""Arguments that name the open building of a tool call, and those that open one."""

from typing import Annotated

import msgspec

from mansion_msgs_py.shapes import PathText

__all__ = ["CancelEdit", "CanceledEdits", "EditorInfo", "OpenEditorArgs", "Text", "ToolArgs"]

Text = Annotated[str, msgspec.Meta(max_length=400)]


class ToolArgs(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Which open building a call is for; when absent, the one that was opened last without a name."""

    editor: Text = ""


class OpenEditorArgs(ToolArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """Open the building folder `path` under the name `editor`.

    Attributes
    ----------
    who : str
        Written into the log beside each change.
    autosave : bool
        Land each edit at once; else edits wait for ``scene/save``.
    """

    path: PathText
    who: Text = ""
    autosave: bool = True


class EditorInfo(msgspec.Struct, frozen=True, kw_only=True):
    """An open building."""

    building_id: str
    floors: list[int]
    labels: list[str]
    revisions: dict[str, int]
    editor: str = ""
    who: str = ""
    autosave: bool = True


class CancelEdit(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Arguments of ``scene/cancel``: the open building whose running edit is to end; any building when absent."""

    editor: Text | None = None


class CanceledEdits(msgspec.Struct, frozen=True, kw_only=True):
    """Reply of ``scene/cancel``: the editors whose edits were asked to end; empty where none was running."""

    editors: list[str]
