"""A building on disk and its edits: transactions that land whole, a log, undo and redo.

``DIR/edits/log.jsonl`` holds one `Transaction` a line: changes of objects, of rooms, and of whole documents, of which
copies lie in ``DIR/edits/documents``. A transaction is written to ``pending.json`` first, then into the documents, then
into the log; whoever takes the lock next finishes what a killed process left.
"""

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import AbstractContextManager
from pathlib import Path

import msgspec

from mansion_editing.document_copies import Documents, floor_of, is_scene
from mansion_editing.edit_log import EditLog, append_line
from mansion_editing.replaced_files import ReplacedFiles
from mansion_editing.robot_sessions import refuse_in_session, refuse_robots
from mansion_editing.room_parts import parts_of, program_with, records_of, topology_with
from mansion_editing.state import SceneChange, changed, inverse, rebase
from mansion_msgs_py.allowed_folders import EVERYWHERE, AllowedFolders
from mansion_msgs_py.building import Building
from mansion_msgs_py.building_folder import EDIT_LOG, INDEX, BuildingFolder, file_in, floor_directory
from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.editing.changes import DocumentChange, ObjectChange, RoomChange, Transaction
from mansion_msgs_py.errors import ErrorCode, MansionError, refused_by_system
from mansion_msgs_py.file_locks import hold_lock
from mansion_msgs_py.files import remove_remains, write_atomic
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.topology import FloorTopology
from mansion_msgs_py.wording import counted

__all__ = ["BuildingStore", "KeptFiles", "Records", "Validator", "locked"]

Scenes = Mapping[int, FloorScene]
Validator = Callable[[Scenes, Scenes], Sequence[str]]
"""Gets the floors before and after, and returns the faults that are new."""

Records = Callable[[Path, Scenes], Mapping[str, bytes]]
"""Gets the folder and all its floors, and returns the files about the whole building that they make untrue."""


KeptFiles = Callable[[Path, Sequence[FloorScene], Sequence[int]], Mapping[str, bytes]]
"""Gets the folder, all its floors, and the numbers of those that changed; returns what the folder has that is made from
these, made again."""


class BuildingStore:
    """The scenes of one building folder.

    Parameters
    ----------
    folder : Path
    validator : callable, optional
        Judges each transaction before it lands.
    records : callable, optional
        Updates what a building's own records state of it, each time a transaction lands.
    clock : callable
        Returns the time for the log.
    allowed : AllowedFolders
        Where this process may write; a building elsewhere can be read.

    Attributes
    ----------
    documents : Documents
        Makes the changes that replace whole documents.
    edit_log : EditLog
        What landed.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when `folder` holds no building, ``INVALID_PAYLOAD`` when a file does not fit its type.
    """

    def __init__(
        self,
        folder: Path,
        *,
        validator: Validator | None = None,
        records: Records | None = None,
        clock: Callable[[], str] = lambda: "",
        allowed: AllowedFolders = EVERYWHERE,
    ) -> None:
        self.folder = folder
        self._allowed = allowed
        self._validator = validator
        self._records = records
        self._clock = clock
        self._reader = BuildingFolder(folder)
        self.documents = Documents(folder, allowed)
        self._scenes: dict[int, tuple[tuple[int, int, int], FloorScene]] = {}
        self.lock_file = file_in(folder, "edits/lock")
        self._edits = self.lock_file.parent
        self.edit_log = EditLog(file_in(folder, EDIT_LOG))
        if allowed.allows(folder):
            self._tidy()

    def _tidy(self) -> None:
        """Finish or remove what killed processes left."""
        for place in (self.folder, self._edits, *sorted(self.folder.glob("floors/*"))):
            if place.resolve().is_relative_to(self.folder.resolve()):
                remove_remains(place)
        if (self._edits / "pending.json").exists():
            with locked(self.lock_file):
                self._recover()

    @property
    def building(self) -> Building:
        """The content of ``building.json`` when the scenes were last read."""
        return self._reader.building

    def scenes(self) -> dict[int, FloorScene]:
        """Return all floors as they are on disk."""
        self._reader = BuildingFolder(self.folder)
        return {floor: self._scene(floor) for floor in self._reader.floors}

    def _scene(self, floor: int) -> FloorScene:
        """Return a floor, decoded again only where its file is another one: each is replaced whole."""
        path = self.folder / floor_directory(floor) / "scene.json"
        if not path.is_file():
            return self._reader.scene(floor)  # which says what is missing
        file = path.stat()
        mark = (file.st_ino, file.st_mtime_ns, file.st_size)
        known = self._scenes.get(floor)
        if known is None or known[0] != mark:
            known = self._scenes[floor] = (mark, self._reader.scene(floor))
        return known[1]

    def _topology(self, floor: int) -> FloorTopology | None:
        if not (self.folder / floor_directory(floor) / "topology.json").is_file():
            return None
        return self._reader.topology(floor)

    def log(self) -> list[Transaction]:
        """Return all transactions, oldest first."""
        return self.edit_log.transactions()

    def land(
        self,
        changes: Sequence[ObjectChange],
        who: str,
        what: str,
        *,
        rooms: Sequence[RoomChange] = (),
        documents: Sequence[DocumentChange] = (),
        files: Mapping[str, bytes] | None = None,
        undoes: int | None = None,
        redoes: int | None = None,
    ) -> Transaction:
        """Write changes as one transaction; on any refusal the building stays as it was.

        Parameters
        ----------
        changes : sequence of ObjectChange
        rooms : sequence of RoomChange
        documents : sequence of DocumentChange
            From `documents.replacement`. A floor whose scene is among them has no other changes.
        files : mapping of str to bytes, optional
            What the changes need besides, by path in the folder. It is there before they are, and stays when they are
            undone.

        Raises
        ------
        MansionError
            ``CONFLICT`` when another editor changed the same objects, rooms or documents, or a running session holds
            one; ``INFEASIBLE`` with the faults that the building would have; ``INVALID_PAYLOAD`` for changes of a floor
            whose scene is replaced; ``FORBIDDEN`` for a folder that this process may not write.

        Notes
        -----
        Changes made against an older revision are carried over to the newest; an id that another editor took
        meanwhile is replaced by the next free one.
        """
        self._allowed.check(self.folder)
        with locked(self.lock_file):
            self._recover()
            before = self.scenes()
            for floor in before:
                file_in(self.folder, f"{floor_directory(floor)}/scene.json")
            carried = rebase(changes, before)
            if not (carried or rooms or documents):
                raise MansionError(ErrorCode.CONFLICT, "nothing to save")
            _refuse_mixed(carried, rooms, documents)
            refuse_in_session(self.folder, carried, before)
            after = self._replaced(before, documents)
            changes_of_floors: list[SceneChange] = [*carried, *rooms]
            for change in changes_of_floors:
                after[change.floor] = changed(after[change.floor], change)
            self._refuse_stale_records(rooms, before)
            self._refuse_faults(before, after)
            transaction = Transaction(
                number=len(self.edit_log) + 1,
                who=who,
                what=what,
                changes=carried,
                rooms=list(rooms),
                documents=list(documents),
                revisions=_next_revisions(before, after, carried, rooms, documents),
                undoes=undoes,
                redoes=redoes,
                time=self._clock(),
            )
            self._carry_out(transaction, files or {})
        return transaction

    def _carry_out(self, transaction: Transaction, needed: Mapping[str, bytes]) -> None:
        """Write a transaction; where anything fails, all is as it was before, and nothing of it lands later."""
        pending, log = self._edits / "pending.json", self.edit_log.file
        length = log.stat().st_size if log.exists() else None
        files = ReplacedFiles(self.folder, self._edits / "former")
        try:
            for name, data in needed.items():
                files.write(name, data)
            write_atomic(pending, encode_bytes(transaction), durable=True)
            self._finish(transaction, files)
        except BaseException as error:
            files.put_back()
            if length is None:
                log.unlink(missing_ok=True)
            else:
                os.truncate(log, length)
            pending.unlink(missing_ok=True)
            if isinstance(error, OSError):
                raise refused_by_system(error, "nothing was changed") from error
            raise
        finally:
            files.forget()

    def _replaced(self, before: Scenes, documents: Sequence[DocumentChange]) -> dict[int, FloorScene]:
        """Return the floors as they are once documents are replaced, which must be as their changes know them."""
        after = dict(before)
        floors = list(before)
        for change in documents:
            self.documents.require_unchanged(change)
            floor = floor_of(change.path)
            if floor is not None and is_scene(change.path) and change.after:
                after[floor] = decode(FloorScene, self.documents.copy(change.after))
                refuse_in_session(self.folder, _differences(before.get(floor), after[floor]), before)
                refuse_robots(self.folder, floor)
            elif change.path == INDEX:
                index = decode(Building, self.documents.copy(change.after))
                floors = [entry.floor for entry in index.floors]
        missing = [floor for floor in floors if floor not in after]
        if missing:
            raise MansionError(
                ErrorCode.INVALID_PAYLOAD,
                f"the new {INDEX} names floors {missing}, of which there is no scene",
                path="$.documents",
            )
        return {floor: after[floor] for floor in floors}

    def _refuse_stale_records(self, rooms: Sequence[RoomChange], scenes: Scenes) -> None:
        program = BuildingFolder(self.folder).building.program
        for change in rooms:
            records = records_of(program, self._topology(change.floor), change.floor, change.id)
            there = parts_of(scenes[change.floor], change.id, *records)
            if there != change.before:
                raise MansionError(
                    ErrorCode.CONFLICT,
                    f"{change.id} was changed since this edit began; look again and repeat the edit",
                    details={"room": change.id},
                )

    def new_faults(self, before: Scenes, after: Scenes) -> list[str]:
        """Return the faults that the validator finds after and not before."""
        return list(self._validator(before, after)) if self._validator else []

    def _refuse_faults(self, before: Scenes, after: Scenes) -> None:
        faults = self.new_faults(before, after)
        if faults:
            raise MansionError(
                ErrorCode.INFEASIBLE,
                f"the building would have {counted(len(faults), 'new fault')}: {'; '.join(faults[:5])}",
                details={"faults": faults},
            )

    def _recover(self) -> None:
        """Finish the transaction of a process that was killed; the lock is held."""
        pending = self._edits / "pending.json"
        if pending.exists():
            files = ReplacedFiles(self.folder, self._edits / "former")
            self._finish(decode(Transaction, pending.read_bytes()), files)

    def _finish(self, transaction: Transaction, files: ReplacedFiles) -> None:
        """Write what a transaction changes; done again after an interruption it does the same."""
        for document in transaction.documents:
            data = self.documents.after(document, transaction.revisions.get(str(floor_of(document.path))))
            files.remove(document.path) if data is None else files.write(document.path, data)
        scenes = self.scenes()
        for name, revision in transaction.revisions.items():
            self._raise(scenes[int(name)], revision, transaction, files)
        self._write_records(transaction.rooms, files)
        self._recount(files, scenes if transaction.documents else map(int, transaction.revisions))
        for name, data in (self._records(self.folder, self.scenes()) if self._records else {}).items():
            files.write(name, data)
        if len(self.edit_log) < transaction.number:
            append_line(self.edit_log.file, encode_bytes(transaction))
        (self._edits / "pending.json").unlink()
        files.forget()

    def _raise(self, scene: FloorScene, revision: int, transaction: Transaction, files: ReplacedFiles) -> None:
        """Write a scene with its changes, where it does not have the revision that they make yet."""
        if scene.revision >= revision:
            return
        changes: list[SceneChange] = [*transaction.changes, *transaction.rooms]
        for change in changes:
            if change.floor == scene.floor:
                scene = changed(scene, change)
        raised = msgspec.structs.replace(scene, revision=revision)
        files.write(f"{floor_directory(scene.floor)}/scene.json", encode_bytes(raised, indent=1))

    def _write_records(self, rooms: Sequence[RoomChange], files: ReplacedFiles) -> None:
        """Write rooms into the building's program and the room graphs of their floors."""
        building = BuildingFolder(self.folder).building
        program = building.program
        for change in rooms:
            program = program_with(program, change)
            graph = self._topology(change.floor)
            if graph is not None and topology_with(graph, change) != graph:
                changed_graph = encode_bytes(topology_with(graph, change), indent=1)
                files.write(f"{floor_directory(change.floor)}/topology.json", changed_graph)
        if program != building.program:
            files.write(INDEX, encode_bytes(msgspec.structs.replace(building, program=program), indent=1))

    def _recount(self, files: ReplacedFiles, floors: Iterable[int]) -> None:
        """Write the numbers of objects of some floors, and of all where it is stated, into ``building.json``."""
        building = msgspec.json.decode((self.folder / INDEX).read_bytes())
        counts = {floor: len(self._scene(floor).objects) for floor in floors}
        stale = [e for e in building["floors"] if e["objects"] != counts.get(e["floor"], e["objects"])]
        for entry in stale:
            entry["objects"] = counts[entry["floor"]]
        if stale:
            if "objects" in building.get("checks", {}):
                building["checks"]["objects"] = sum(entry["objects"] for entry in building["floors"])
            files.write(INDEX, encode_bytes(building, indent=1))

    def undo(self, who: str) -> Transaction:
        """Take back the last transaction of `who` that is not undone.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` when there is none, ``CONFLICT`` when later edits rest on it.
        """
        undoable = self.edit_log.landed_by(who)
        if not undoable:
            raise MansionError(ErrorCode.NOT_FOUND, f"there is no edit of {who!r} to undo")
        last = self.edit_log.transaction(undoable[-1])
        return self.land(
            [inverse(change) for change in reversed(last.changes)],
            who,
            f"undo {last.number}: {last.what}",
            rooms=[inverse(change) for change in reversed(last.rooms)],
            documents=[inverse(change) for change in reversed(last.documents)],
            undoes=_root(last),
        )

    def redo(self, who: str) -> Transaction:
        """Do again what `who` undid last.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` when there is nothing, ``CONFLICT`` when the building changed there since.
        """
        redoable = self.edit_log.taken_back_by(who)
        if not redoable:
            raise MansionError(ErrorCode.NOT_FOUND, f"there is no undone edit of {who!r} to redo")
        last = self.edit_log.transaction(redoable[-1])
        return self.land(
            last.changes,
            who,
            f"redo {last.number}: {last.what}",
            rooms=last.rooms,
            documents=last.documents,
            redoes=_root(last),
        )

    def _behind(self, record: Path) -> list[int]:
        """Return the floors whose derived files are of another revision than their scenes."""
        made = _revisions_made(record)
        return [floor for floor, scene in self.scenes().items() if scene.revision != made.get(str(floor), 1)]

    def refresh(self, kept: KeptFiles) -> list[int]:
        """Regenerate the derived files of floors whose revision changed since they were written.

        Parameters
        ----------
        kept : callable
            Returns the files that are remade, by path relative to the folder; asked when any floor changed.

        Returns
        -------
        list of int
            The floors that were behind and are written now; none of a building that this process may not write.
        """
        record = self._edits / "derived.json"
        if not self._allowed.allows(self.folder) or not self._behind(record):
            return []
        with locked(self._edits / "derived.lock", patience=600.0):
            behind = self._behind(record)
            if not behind:
                return []
            scenes = self.scenes()
            made = _revisions_made(record)
            files = kept(self.folder, [scenes[floor] for floor in sorted(scenes)], behind)
            for name, data in sorted(files.items()):
                write_atomic(file_in(self.folder, name), data, durable=True)
            made.update({str(floor): scenes[floor].revision for floor in behind})
            write_atomic(record, encode_bytes(made), durable=True)
        return behind


def _revisions_made(record: Path) -> dict[str, int]:
    """Return the revision of each floor's scene that its derived files were made from."""
    return decode(dict[str, int], record.read_bytes()) if record.exists() else {}


def _refuse_mixed(
    changes: Sequence[ObjectChange], rooms: Sequence[RoomChange], documents: Sequence[DocumentChange]
) -> None:
    replaced = {floor_of(document.path) for document in documents if is_scene(document.path)}
    mixed = [f for f in _floors_of(changes, rooms) if f in replaced]
    if mixed:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"the scenes of floors {mixed} are replaced, so that they can have no other changes",
            path="$.documents",
        )


def _floors_of(changes: Sequence[ObjectChange], rooms: Sequence[RoomChange]) -> list[int]:
    return sorted({change.floor for change in changes} | {change.floor for change in rooms})


def _next_revisions(
    before: Scenes,
    after: Scenes,
    changes: Sequence[ObjectChange],
    rooms: Sequence[RoomChange],
    documents: Sequence[DocumentChange],
) -> dict[str, int]:
    """Return the next revision of each floor that changes have touched."""
    touched = set(_floors_of(changes, rooms))
    touched |= {floor for document in documents if (floor := floor_of(document.path)) in after and floor is not None}
    last = {floor: (before.get(floor) or after[floor]).revision for floor in touched}
    return {str(floor): last[floor] + 1 for floor in sorted(touched)}


def _differences(before: FloorScene | None, after: FloorScene) -> list[ObjectChange]:
    """Return the changes of objects that the replacement of a scene amounts to, without additions."""
    if before is None:
        return []
    there = {item.id: item for item in after.objects}
    return [
        ObjectChange(floor=before.floor, index=index, before=item, after=there.get(item.id))
        for index, item in enumerate(before.objects)
        if there.get(item.id) != item
    ]


def _root(transaction: Transaction) -> int:
    return transaction.redoes or transaction.number


PATIENCE = 30.0
"""Seconds to wait for another editor; one holds the lock for a single transaction."""


def locked(path: Path, patience: float = PATIENCE) -> AbstractContextManager[None]:
    """Hold the lock file, waiting for its holder.

    Raises
    ------
    MansionError
        ``CONFLICT`` when another process keeps it for longer than `patience` seconds.
    """
    return hold_lock(path, f"another editor holds {path}; try again", patience=patience)
