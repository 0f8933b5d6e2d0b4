"""An editor of a building's folder: the independent check before each edit, and the files of what changed after it."""

import getpass
import os
from collections.abc import Sequence
from datetime import UTC, datetime
from pathlib import Path
from typing import Final

from mansion_assets.library.building_assets import catalogue_for
from mansion_assets.retrieval.configured import configured_retriever
from mansion_assets.retrieval.static_vectors import PACKAGED
from mansion_bringup.edit_hooks import kept_files, new_faults, records
from mansion_bringup.extras import ensure_extra
from mansion_editing.editor import SceneEditor
from mansion_editing.physics.engine import engine_named
from mansion_editing.storage import BuildingStore
from mansion_msgs_py.errors import refused_by_system
from mansion_scene.refurnishing import furnish_room

__all__ = ["ENGINE_EXTRAS", "open_editor", "write_derived"]

ENGINE_EXTRAS: Final = {"mujoco": "sim", "thor": "thor"}
"""The extra that an engine needs."""


def open_editor(building: Path, *, physics: str = "mujoco", who: str = "", assets: Sequence[str] = ()) -> SceneEditor:
    """Return an editor of a folder, with the independent check before each edit.

    Parameters
    ----------
    assets : sequence of str
        Libraries of own assets beside those that the building was made with.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for no building, no such engine or no such library, ``UNAVAILABLE`` when the engine is not
        installed.
    """
    if physics in ENGINE_EXTRAS:
        ensure_extra(ENGINE_EXTRAS[physics])
    if os.environ.get("MANSION_EMBEDDINGS_MODEL") == PACKAGED and not os.environ.get("MANSION_EMBEDDINGS_BASE_URL"):
        ensure_extra("vectors")
    store = BuildingStore(building, validator=new_faults, records=records, clock=_now)
    return SceneEditor(
        store,
        catalogue_for(building, assets, store.building.request.libraries),
        engine_named(physics),
        who=who or getpass.getuser(),
        retriever=configured_retriever(),
        furnisher=furnish_room,
    )


def _now() -> str:
    return datetime.now(UTC).isoformat(timespec="seconds")


def write_derived(editor: SceneEditor) -> list[int]:
    """Rewrite the files of the folder that are made from the floors that changed, and return these floors."""
    try:
        return editor.store.refresh(kept_files)
    except OSError as error:
        outcome = "the building is up to date, but the plans and models made from it are not; the next edit writes them"
        raise refused_by_system(error, outcome) from error
