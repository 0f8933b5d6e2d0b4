"""The editor of one building: tools by name, edits that wait or land at once, undo and redo."""

from collections.abc import Callable, Mapping, Set
from typing import Any, Final, TypeAlias

import msgspec

from mansion_assets.catalogue import Catalogue
from mansion_assets.retrieval.retriever import Retriever
from mansion_editing.passages import passages_of
from mansion_editing.physics.engine import PhysicsEngine
from mansion_editing.state import SceneState, net_changes
from mansion_editing.storage import BuildingStore
from mansion_editing.tools import manipulation, painting, paths, perception, placement, swapping
from mansion_msgs_py.codec import decode, encode
from mansion_msgs_py.editing import (
    CheckPathArgs,
    CheckSurfaceArgs,
    DiffReport,
    EditResult,
    ListObjectsArgs,
    MoveObjectArgs,
    ObjectChange,
    PaintObjectArgs,
    PlaceInContainerArgs,
    PlaceOnSurfaceArgs,
    PlacingWishes,
    RemoveObjectArgs,
    SearchAssetsArgs,
    SearchContentsArgs,
    SetStateArgs,
    SwapObjectsArgs,
    ToolArgs,
    Transaction,
)
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import FloorScene, SceneObject

__all__ = ["ACTION_TOOLS", "HISTORY_TOOLS", "PERCEPTION_TOOLS", "TOOLS", "SceneEditor"]

Scenes: TypeAlias = Mapping[int, FloorScene]

PERCEPTION_TOOLS: Final[dict[str, type[Any]]] = {
    "CheckPath": CheckPathArgs,
    "SearchAssets": SearchAssetsArgs,
    "ListObjects": ListObjectsArgs,
    "CheckSurface": CheckSurfaceArgs,
    "SearchContents": SearchContentsArgs,
}
ACTION_TOOLS: Final[dict[str, type[Any]]] = {
    "PlaceInContainer": PlaceInContainerArgs,
    "PlaceOnSurface": PlaceOnSurfaceArgs,
    "RemoveObject": RemoveObjectArgs,
    "MoveObject": MoveObjectArgs,
    "SetState": SetStateArgs,
    "PaintObject": PaintObjectArgs,
    "SwapObjects": SwapObjectsArgs,
}
HISTORY_TOOLS: Final[dict[str, type[Any]]] = {"Undo": ToolArgs, "Redo": ToolArgs, "Diff": ToolArgs, "Save": ToolArgs}
TOOLS: Final[dict[str, type[Any]]] = {**PERCEPTION_TOOLS, **ACTION_TOOLS, **HISTORY_TOOLS}
"""Each tool's name and the type of its arguments."""

_ASK: Final[dict[str, Callable[[SceneState, Any], Any]]] = {
    "CheckPath": paths.check_path,
    "SearchAssets": perception.search_assets,
    "ListObjects": perception.list_objects,
    "CheckSurface": perception.check_surface,
    "SearchContents": perception.search_contents,
}


class SceneEditor:
    """Tools over one building.

    Parameters
    ----------
    store : BuildingStore
    catalogue : Catalogue
    engine : PhysicsEngine
    who : str
        Written into the log.
    autosave : bool
        Land each edit at once.
    retriever : Retriever, optional
        What SearchAssets asks; text search when absent.
    """

    def __init__(
        self,
        store: BuildingStore,
        catalogue: Catalogue,
        engine: PhysicsEngine,
        *,
        who: str = "",
        autosave: bool = True,
        retriever: Retriever | None = None,
    ) -> None:
        self.store, self.catalogue, self.engine = store, catalogue, engine
        self.who, self.autosave, self.retriever = who, autosave, retriever
        self.state = SceneState([], catalogue, retriever)
        self._what: list[str] = []
        self._marks: list[int] = []
        self._redo: list[tuple[str, list[ObjectChange]]] = []
        self.reload()

    def reload(self) -> None:
        """Take the scenes from disk, dropping what waits to be saved."""
        scenes = list(self.store.scenes().values())
        self.state = SceneState(scenes, self.catalogue, self.retriever)
        self._what, self._marks, self._redo = [], [], []

    def refreshed(self) -> SceneState:
        """Return the state, reloaded when nothing is pending and another editor has landed a transaction."""
        if not self.state.pending:
            scenes = self.store.scenes()
            if any(self.state.scenes[f].revision != s.revision for f, s in scenes.items()):
                self.reload()
        return self.state

    def call(self, tool: str, arguments: Any = None) -> Any:
        """Run a tool by name.

        Parameters
        ----------
        arguments : payload, dict or JSON text, optional

        Raises
        ------
        MansionError
            ``NOT_FOUND`` for an unknown tool, ``INVALID_PAYLOAD`` for arguments that do not fit, or the tool's own.
        """
        kind = TOOLS.get(tool)
        if kind is None:
            raise MansionError(
                ErrorCode.NOT_FOUND, f"there is no tool {str(tool)[:80]!r}; tools are {', '.join(TOOLS)}", path="$.tool"
            )
        args = arguments
        if not isinstance(arguments, kind):
            text = arguments if isinstance(arguments, str) else encode(arguments or {})
            args = decode(kind, text)
        state = self.refreshed()
        if tool in _ASK:
            return _ASK[tool](state, args)
        if tool in ACTION_TOOLS:
            return self._edit(tool, args)
        return {"Undo": self.undo, "Redo": self.redo, "Diff": self.diff, "Save": self.save}[tool]()

    def _edit(self, tool: str, args: Any) -> EditResult:
        start = len(self.state.pending)
        try:
            message = self._act(tool, args)
        except BaseException:
            self.state.roll_back(start)
            raise
        ids = list(dict.fromkeys(change.id for change in self.state.pending[start:]))
        if len(self.state.pending) > start:
            self._marks.append(start)
            self._what.append(f"{tool} {encode(_without_editor(args))}")
            self._redo = []
        if not self.autosave or not self.state.pending:
            return EditResult(message=message, object_ids=ids, saved=not self.state.pending)
        saved = self.save()
        return msgspec.structs.replace(saved, message=message)

    def _act(self, tool: str, args: Any) -> str:
        state, engine = self.state, self.engine
        if tool == "PlaceInContainer":
            item = placement.place_in_container(state, args, engine)
            return f"{item.id} is in {item.parent}"
        if tool == "PlaceOnSurface":
            item = placement.place_on_surface(state, args, engine, self._acceptable)
            return f"{item.id} is {_where(item)}"
        if tool == "RemoveObject":
            gone = manipulation.remove_object(state, args)
            return f"removed {', '.join(gone)}" if gone else "there was nothing to remove"
        if tool == "MoveObject":
            item = manipulation.move_object(state, args, engine, self._acceptable)
            return f"{item.id} is now {_where(item)}"
        if tool == "SwapObjects":
            one, other = swapping.swap_objects(state, args, engine, self._sound)
            return f"{one.id} is now {_where(one)}, {other.id} {_where(other)}"
        if tool == "PaintObject":
            item = painting.paint_object(state, args)
            return f"{item.id} is of {item.material}, {item.color}"
        item = manipulation.set_state(state, args)
        return f"{item.id}: {encode(item.states)}"

    def _acceptable(self, floor: int, item: SceneObject) -> bool:
        """Whether an object causes no new fault of the check and cuts no room for a robot."""
        before = dict(self.state.scenes)
        return self._sound(before, {**before, floor: manipulation.scene_with(self.state, floor, item)})

    def _sound(self, before: Scenes, after: Scenes) -> bool:
        """Whether the floors have no new fault of the check and no room that is newly cut for a robot."""
        if self.store.new_faults(before, after):
            return False
        return all(
            passages_of(scene).cuts.keys() <= self._cuts(before[floor])
            for floor, scene in after.items()
            if scene is not before[floor]
        )

    def _cuts(self, scene: FloorScene) -> Set[str]:
        """Return the rooms of a floor that are cut for a robot; those of the floor as it is are remembered."""
        if self.state.scenes[scene.floor] is scene:
            return self.state.index(scene.floor).passages.cuts.keys()
        return passages_of(scene).cuts.keys()

    def diff(self) -> DiffReport:
        """Say what waits to be saved."""
        changes = net_changes(self.state.pending)
        words = [f"{'+' if c.before is None else '-' if c.after is None else '~'} {c.id}" for c in changes]
        return DiffReport(message=", ".join(words) or "nothing waits to be saved", changes=changes)

    def save(self, what: str = "") -> EditResult:
        """Land what waits as one transaction; when it is refused, what waited is dropped.

        Raises
        ------
        MansionError
            ``INFEASIBLE`` or ``CONFLICT`` with the reason.
        """
        changes = net_changes(self.state.pending)
        if not changes:
            self.reload()
            return EditResult(message="nothing to save", saved=True)
        try:
            done = self.store.land(changes, self.who, what or "; ".join(self._what))
        finally:
            self.reload()
        return _landed("saved", done)

    def undo(self) -> EditResult:
        """Take back the last edit: one that waits, else this user's last one on disk."""
        if self._marks:
            start = self._marks.pop()
            taken = self.state.pending[start:]
            self._redo.append((self._what.pop(), taken))
            self.state.roll_back(start)
            ids = list(dict.fromkeys(change.id for change in taken))
            return EditResult(message=f"undid {', '.join(ids)}", object_ids=ids)
        done = self.store.undo(self.who)
        self.reload()
        return _landed(done.what, done)

    def redo(self) -> EditResult:
        """Do again what was undone last."""
        if self._redo:
            what, changes = self._redo.pop()
            self._marks.append(len(self.state.pending))
            self._what.append(what)
            for change in changes:
                self.state.apply(change)
            ids = list(dict.fromkeys(change.id for change in changes))
            return EditResult(message=f"redid {', '.join(ids)}", object_ids=ids)
        done = self.store.redo(self.who)
        self.reload()
        return _landed(done.what, done)


def _where(item: SceneObject) -> str:
    """Return in words what carries an object."""
    if item.mount in ("wall", "ceiling"):
        return f"on the {item.mount} of {item.room}"
    if item.mount == "floor":
        return f"below {item.parent}" if item.parent else f"on the floor of {item.room}"
    return f"on {item.parent}"


def _landed(message: str, done: Transaction) -> EditResult:
    return EditResult(
        message=message,
        object_ids=[change.id for change in done.changes],
        saved=True,
        transaction=done.number,
        revisions=done.revisions,
    )


def _without_editor(args: Any) -> dict[str, Any]:
    """Return the arguments that are given, wishes for the place last."""
    plain: dict[str, Any] = msgspec.to_builtins(args)
    last = PlacingWishes.__struct_fields__
    names = sorted(plain, key=lambda name: name in last)
    return {name: plain[name] for name in names if name != "editor" and plain[name] not in ("", None)}
