"""The editor of a building: tools by name, edits that wait or land at once, undo and redo; all editors of a process."""

from collections.abc import Callable, Iterator, Mapping, Sequence, Set
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Final, TypeAlias

import msgspec

from mansion_assets.catalogue import Catalogue
from mansion_assets.library.building_assets import asset_files, own_assets
from mansion_assets.retrieval.retriever import Retriever
from mansion_editing.physics.engine import PhysicsEngine
from mansion_editing.robot_passages import passages_of
from mansion_editing.state import Change, SceneState
from mansion_editing.storage import BuildingStore
from mansion_editing.tools import (
    finishes,
    furnishing,
    manipulation,
    painting,
    paths,
    perception,
    placement,
    reshaping,
    rooms,
    swapping,
)
from mansion_editing.tools.furnishing import Furnisher
from mansion_editing.unsaved_changes import document, in_words, room_records, waiting
from mansion_msgs_py.building_folder import floor_directory
from mansion_msgs_py.codec import decode, encode, encode_bytes
from mansion_msgs_py.editing.changes import DiffReport, EditResult, ObjectChange, RoomChange, Transaction
from mansion_msgs_py.editing.objects import (
    MoveObjectArgs,
    PaintObjectArgs,
    PlaceInContainerArgs,
    PlaceOnSurfaceArgs,
    PlacingWishes,
    RemoveObjectArgs,
    SetStateArgs,
    SwapObjectsArgs,
)
from mansion_msgs_py.editing.open_buildings import ToolArgs
from mansion_msgs_py.editing.questions import (
    CheckPathArgs,
    CheckSurfaceArgs,
    ListObjectsArgs,
    SearchAssetsArgs,
    SearchContentsArgs,
)
from mansion_msgs_py.editing.rooms import (
    ClearRoomArgs,
    FurnishRoomArgs,
    RenameRoomArgs,
    ReshapeFloorArgs,
    SetFinishArgs,
)
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.program import RoomProgram
from mansion_msgs_py.scene import FloorScene, SceneObject
from mansion_msgs_py.topology import TopologyNode
from mansion_msgs_py.wording import counted, with_article

__all__ = [
    "ACTION_TOOLS",
    "FLOOR_TOOLS",
    "HISTORY_TOOLS",
    "MOST_EDITORS",
    "PERCEPTION_TOOLS",
    "ROOM_TOOLS",
    "TOOLS",
    "Answered",
    "OpenEditors",
    "SceneEditor",
]

Scenes: TypeAlias = Mapping[int, FloorScene]

PERCEPTION_TOOLS: Final[dict[str, type[Any]]] = {
    "CheckPath": CheckPathArgs,
    "SearchAssets": SearchAssetsArgs,
    "ListObjects": ListObjectsArgs,
    "CheckSurface": CheckSurfaceArgs,
    "SearchContents": SearchContentsArgs,
}
ROOM_TOOLS: Final[dict[str, type[Any]]] = {
    "RenameRoom": RenameRoomArgs,
    "SetFinish": SetFinishArgs,
    "ClearRoom": ClearRoomArgs,
    "FurnishRoom": FurnishRoomArgs,
}
ACTION_TOOLS: Final[dict[str, type[Any]]] = {
    "PlaceInContainer": PlaceInContainerArgs,
    "PlaceOnSurface": PlaceOnSurfaceArgs,
    "RemoveObject": RemoveObjectArgs,
    "MoveObject": MoveObjectArgs,
    "SetState": SetStateArgs,
    "PaintObject": PaintObjectArgs,
    "SwapObjects": SwapObjectsArgs,
    **ROOM_TOOLS,
}
FLOOR_TOOLS: Final[dict[str, type[Any]]] = {"ReshapeFloor": ReshapeFloorArgs}
HISTORY_TOOLS: Final[dict[str, type[Any]]] = {"Undo": ToolArgs, "Redo": ToolArgs, "Diff": ToolArgs, "Save": ToolArgs}
TOOLS: Final[dict[str, type[Any]]] = {**PERCEPTION_TOOLS, **ACTION_TOOLS, **FLOOR_TOOLS, **HISTORY_TOOLS}
"""Each tool's name and the type of its arguments."""

_ASK: Final[dict[str, Callable[[SceneState, Any], Any]]] = {
    "CheckPath": paths.check_path,
    "SearchAssets": perception.search_assets,
    "ListObjects": perception.list_objects,
    "CheckSurface": perception.check_surface,
    "SearchContents": perception.search_contents,
}


@dataclass(frozen=True)
class Answered:
    """What a question was about, and the number of edits that had landed then.

    Attributes
    ----------
    things, rooms : tuple of str
        Ids.
    """

    edits: int
    things: tuple[str, ...]
    rooms: tuple[str, ...]
    noun: str


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
    furnisher : Furnisher, optional
        The placer, which FurnishRoom asks.

    Attributes
    ----------
    answered : Answered, optional
        What the last question was about.
    cancelled : callable
        Whether the work in progress was cancelled (see `cancellable`).
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
        furnisher: Furnisher | None = None,
    ) -> None:
        self.store, self.catalogue, self.engine = store, catalogue, engine
        self.who, self.autosave, self.retriever, self.furnisher = who, autosave, retriever, furnisher
        self.state = SceneState([], catalogue, retriever)
        self._what: list[str] = []
        self._marks: list[int] = []
        self._redo: list[tuple[str, list[Change]]] = []
        self.answered: Answered | None = None
        self.cancelled: Callable[[], bool] = _never
        self.reload()

    def reload(self) -> None:
        """Read the scenes from disk again, and drop unsaved changes."""
        scenes = list(self.store.scenes().values())
        self.state = SceneState(scenes, self.catalogue, self.retriever, self.store.documents.copy)
        self._what, self._marks, self._redo = [], [], []

    def refreshed(self) -> SceneState:
        """Return the state, reloaded when nothing is pending and another editor has landed a transaction."""
        if not self.state.pending:
            scenes = self.store.scenes()
            seen = {floor: scene.revision for floor, scene in self.state.scenes.items()}
            if seen != {floor: scene.revision for floor, scene in scenes.items()}:
                self.reload()
        return self.state

    @contextmanager
    def cancellable(self, cancelled: Callable[[], bool]) -> Iterator[None]:
        """Let the calls in the block be cancelled: they end at their next step, and none of their edits land.

        Raises
        ------
        MansionError
            ``CANCELED`` where something in the block failed after it was cancelled.
        """
        self.cancelled = cancelled
        try:
            yield
        except MansionError:
            self.go_on()
            raise
        finally:
            self.cancelled = _never

    def go_on(self) -> None:
        """Raise an error if the work in progress was cancelled.

        Raises
        ------
        MansionError
            ``CANCELED``.
        """
        if self.cancelled():
            raise MansionError(ErrorCode.CANCELED, "the edit was cancelled; nothing of it was done")

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
        self.go_on()
        state = self.refreshed()
        if tool in _ASK:
            return _ASK[tool](state, args)
        if tool in ACTION_TOOLS:
            return self._edit(tool, args)
        if tool in FLOOR_TOOLS:
            return self._reshape(args)
        return {"Undo": self.undo, "Redo": self.redo, "Diff": self.diff, "Save": self.save}[tool]()

    def _edit(self, tool: str, args: Any) -> EditResult:
        return self._done(lambda: self._act(tool, args), f"{tool} {encode(_without_editor(args))}")

    def _done(self, act: Callable[[], str], what: str) -> EditResult:
        """Do one edit, whole or not at all, and land it where edits do not wait."""
        start = len(self.state.pending)
        try:
            message = act()
            self.go_on()
        except BaseException:
            self.state.roll_back(start)
            raise
        done = self.state.pending[start:]
        if len(self.state.pending) > start:
            self._marks.append(start)
            self._what.append(what)
            self._redo = []
        if not self.autosave or not self.state.pending:
            return _told(message, done, saved=not self.state.pending)
        saved = self.save()
        return msgspec.structs.replace(saved, message=message)

    def _act(self, tool: str, args: Any) -> str:
        state, engine = self.state, self.engine
        if tool in ROOM_TOOLS:
            return self._act_on_room(tool, args)
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
        door = manipulation.door_swung(state, args)
        if door is not None:
            floor, swung = door
            self._replace_scene(floor, swung)
            return f"{args.object_id} is {'open' if args.open else 'closed'}"
        item = manipulation.set_state(state, args)
        return f"{item.id}: {encode(item.states)}"

    def _replace_scene(self, floor: int, scene: FloorScene) -> None:
        path = f"{floor_directory(floor)}/scene.json"
        self.state.apply(self.store.documents.replacement(path, encode_bytes(scene, indent=1)))

    def _act_on_room(self, tool: str, args: Any) -> str:
        state, records = self.state, self._records
        if tool == "RenameRoom":
            room, old = rooms.rename_room(state, args, records)
            return f"{room.id} is called {room.name!r}, {old!r} before"
        if tool == "SetFinish":
            room, finish = finishes.set_finish(state, args, records)
            return f"the {args.part} of {room.id}: {finish.name}"
        if tool == "ClearRoom":
            room, gone = rooms.clear_room(state, args, records)
            return f"took {counted(len(gone), 'object')} out of {room.id}" if gone else f"{room.id} holds nothing loose"
        if self.furnisher is None:
            raise MansionError(ErrorCode.UNAVAILABLE, "this editor was opened without a placer, which furnishes rooms")
        room, new = furnishing.furnish_room(state, args, records, self.furnisher, self._faults_with)
        kind = with_article(room.room_type.replace("_", " "))
        return f"{room.id} is furnished as {kind} with {counted(len(new), 'object')}"

    def _reshape(self, args: ReshapeFloorArgs) -> EditResult:
        """Change the structure of a storey, whose documents are replaced whole."""
        if self.furnisher is None:
            raise MansionError(ErrorCode.UNAVAILABLE, "this editor was opened without a placer, which furnishes rooms")
        made = reshaping.reshape_floor(
            self.state, args, self.document, self._new_faults, self.catalogue, self.furnisher, self.go_on
        )
        done = self.replace_documents(made.files, f"ReshapeFloor {encode(_without_editor(args))}")
        return msgspec.structs.replace(done, message=" ".join(made.moved), room_ids=made.rooms)

    def _new_faults(self, changed: Mapping[int, FloorScene]) -> list[str]:
        """Return the faults that the building would have with other scenes of some floors."""
        return self.store.new_faults(self.store.scenes(), {**self.state.scenes, **changed})

    def _records(self, floor: int, room_id: str) -> tuple[RoomProgram | None, TopologyNode | None]:
        return room_records(self.state, self.store.documents, floor, room_id)

    def document(self, path: str) -> bytes | None:
        """Return a document of the building with the unsaved changes; ``None`` if it does not exist."""
        return document(self.state, self.store.documents, path)

    def replace_documents(self, files: Mapping[str, bytes | None], what: str) -> EditResult:
        """Put other documents in the place of those that the building has, as one edit.

        Parameters
        ----------
        files : mapping
            By path relative to the building's folder; ``None`` takes a document away. They are made from `document`,
            so that they hold what waits already.
        what : str
            For the log.

        Raises
        ------
        MansionError
            As `save` does, and ``INVALID_PAYLOAD`` for a path that is not a document of the building.
        """

        def act() -> str:
            for path, data in files.items():
                self.state.apply(self.store.documents.replacement(path, data))
            return what

        return self._done(act, what)

    def _faults_with(self, floor: int, scene: FloorScene) -> list[str]:
        """Return the new faults of the check for a floor as it would be, and the cuts that keep a robot from a part."""
        before = self.store.scenes()
        faults = self.store.new_faults(before, {**before, **self.state.scenes, floor: scene})
        known = passages_of(before[floor]).cuts.keys()
        return [*faults, *(f"{room} would be cut for a robot" for room in passages_of(scene).cuts.keys() - known)]

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
        changes, changed_rooms, documents = waiting(self.state, self.store.documents)
        words = [*map(in_words, documents), *map(in_words, changed_rooms), *map(in_words, changes)]
        message = ", ".join(words) or "nothing waits to be saved"
        return DiffReport(message=message, changes=changes, rooms=changed_rooms, documents=documents)

    def save(self, what: str = "") -> EditResult:
        """Land what waits as one transaction; when it is refused, what waited is dropped.

        Raises
        ------
        MansionError
            ``INFEASIBLE`` or ``CONFLICT`` with the reason.
        """
        changes, changed_rooms, documents = waiting(self.state, self.store.documents)
        if not (changes or changed_rooms or documents):
            self.reload()
            return EditResult(message="nothing to save", saved=True)
        try:
            told = what or "; ".join(self._what)
            done = self.store.land(
                changes, self.who, told, rooms=changed_rooms, documents=documents, files=self._own_assets()
            )
        finally:
            self.reload()
        return _landed("saved", done)

    def _own_assets(self) -> dict[str, bytes]:
        """Return the files of the user's assets that the building shows and its folder does not have."""
        keys = {item.asset for scene in self.state.scenes.values() for item in scene.objects}
        return asset_files(own_assets(keys, self.catalogue), self.store.folder)

    def undo(self) -> EditResult:
        """Take back the last edit: one that waits, else this user's last one on disk."""
        if self._marks:
            start = self._marks.pop()
            taken = self.state.pending[start:]
            self._redo.append((self._what.pop(), taken))
            self.state.roll_back(start)
            return _told(f"undid {_ids(taken)}", taken)
        done = self.store.undo(self.who)
        self.reload()
        return _landed(done.what, done)

    def redo(self) -> EditResult:
        """Redo the edit that was undone last."""
        if self._redo:
            what, changes = self._redo.pop()
            self._marks.append(len(self.state.pending))
            self._what.append(what)
            for change in changes:
                self.state.apply(change)
            return _told(f"redid {_ids(changes)}", changes)
        done = self.store.redo(self.who)
        self.reload()
        return _landed(done.what, done)


def _never() -> bool:
    return False


def _where(item: SceneObject) -> str:
    """Return in words what carries an object."""
    if item.mount in ("wall", "ceiling"):
        return f"on the {item.mount} of {item.room}"
    if item.mount == "floor":
        return f"below {item.parent}" if item.parent else f"on the floor of {item.room}"
    return f"on {item.parent}"


def _ids(changes: Sequence[Change]) -> str:
    return ", ".join(dict.fromkeys(change.id for change in changes))


def _told(message: str, changes: Sequence[Change], *, saved: bool = False) -> EditResult:
    return EditResult(
        message=message,
        object_ids=list(dict.fromkeys(change.id for change in changes if isinstance(change, ObjectChange))),
        room_ids=list(dict.fromkeys(change.id for change in changes if isinstance(change, RoomChange))),
        saved=saved,
    )


def _landed(message: str, done: Transaction) -> EditResult:
    return EditResult(
        message=message,
        object_ids=[change.id for change in done.changes],
        room_ids=[change.id for change in done.rooms],
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


MOST_EDITORS: Final = 16
"""Editors that a process keeps open: a building of ten storeys takes tens of megabytes."""


class OpenEditors:
    """The editors that are open in a process, by name; beyond `MOST_EDITORS` the least recently used one is closed."""

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
                    f"{MOST_EDITORS} buildings are open, all with unsaved edits; save those of one",
                    path="$.editor",
                )
            del self._editors[idle]
        self._editors.pop(name, None)
        self._editors[name] = editor
