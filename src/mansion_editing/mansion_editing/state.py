"""The static semantic state: a building's scenes with quick answers about them, and the changes that edit them."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import TypeAlias, TypeVar

import msgspec
import numpy as np
import numpy.typing as npt

from mansion_assets.catalogue import Asset, Catalogue
from mansion_assets.retrieval.retriever import Retriever, TextRetriever
from mansion_editing.document_copies import floor_of, is_scene
from mansion_editing.robot_passages import Passages, passages_of
from mansion_editing.room_parts import scene_with
from mansion_msgs_py.codec import decode
from mansion_msgs_py.editing.changes import DocumentChange, ObjectChange, RoomChange
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import FloorScene, SceneObject, SceneRoom
from mansion_scene.decor.frames import room_polygon

__all__ = [
    "Change",
    "FloorIndex",
    "SceneChange",
    "SceneState",
    "changed",
    "inverse",
    "net_changes",
    "net_rooms",
    "rebase",
]

Change: TypeAlias = ObjectChange | RoomChange | DocumentChange
SceneChange: TypeAlias = ObjectChange | RoomChange
_Kind = TypeVar("_Kind", bound=Change)


class FloorIndex:
    """Index of the objects of one revision of a floor.

    Attributes
    ----------
    boxes : (n, 7) array
        Position, size and rotation (degrees) of each object, in the scene's order.
    """

    def __init__(self, scene: FloorScene) -> None:
        self.objects = scene.objects
        self.at = {item.id: number for number, item in enumerate(scene.objects)}
        self.boxes: npt.NDArray[np.float64] = np.array(
            [[*item.position, *item.size, item.rotation] for item in scene.objects], dtype=float
        ).reshape(-1, 7)
        self._scene = scene

    @cached_property
    def children(self) -> dict[str, list[SceneObject]]:
        """Objects by the receptacle that the scene names."""
        out: dict[str, list[SceneObject]] = {}
        for item in self.objects:
            if item.parent is not None:
                out.setdefault(item.parent, []).append(item)
        return out

    @cached_property
    def passages(self) -> Passages:
        """Where a robot passes between the furniture."""
        return passages_of(self._scene)

    def room_at(self, x: float, y: float) -> SceneRoom | None:
        """Return the room whose interior holds a point."""
        from shapely import Point

        for room in self._scene.rooms:
            if room_polygon(room.net_polygon, room.net_holes).covers(Point(x, y)):
                return room
        return None


class SceneState:
    """Scenes of a building while they are edited; scenes handed in are never changed.

    Parameters
    ----------
    scenes : sequence of FloorScene
    catalogue : Catalogue
    retriever : Retriever, optional
        What SearchAssets asks; text search when absent.
    copies : callable, optional
        Returns a stored copy of a document by its name; needed where documents are replaced.

    Attributes
    ----------
    pending : list of ObjectChange, RoomChange and DocumentChange
        What differs from the scenes handed in, in the order it was done.
    """

    def __init__(
        self,
        scenes: Sequence[FloorScene],
        catalogue: Catalogue,
        retriever: Retriever | None = None,
        copies: Callable[[str], bytes] | None = None,
    ) -> None:
        self._copies = copies
        self._replaced: list[FloorScene | None] = []
        self.catalogue = catalogue
        self.retriever: Retriever = retriever or TextRetriever()
        self.scenes = {scene.floor: scene for scene in scenes}
        self.pending: list[Change] = []
        self._indexes: dict[int, FloorIndex] = {}

    def copied(self) -> "SceneState":
        """Return the scenes as they are now, with nothing pending; later edits do not change them."""
        return SceneState([self.scenes[floor] for floor in self.floors], self.catalogue, self.retriever)

    @property
    def floors(self) -> list[int]:
        """Floor numbers, ascending."""
        return sorted(self.scenes)

    def index(self, floor: int) -> FloorIndex:
        """Return the index of a floor as it is now."""
        if floor not in self._indexes:
            self._indexes[floor] = FloorIndex(self.scenes[floor])
        return self._indexes[floor]

    def rooms(self) -> Iterator[tuple[int, SceneRoom]]:
        """Yield each room with its floor, from below; stairs and lifts are left out."""
        for floor in self.floors:
            for room in self.scenes[floor].rooms:
                if room.kind not in ("stair", "elevator"):
                    yield floor, room

    def objects(self) -> Iterator[tuple[int, SceneObject]]:
        """Yield each object with its floor, from below."""
        for floor in self.floors:
            for item in self.scenes[floor].objects:
                yield floor, item

    def find(self, object_id: str) -> tuple[int, SceneObject] | None:
        """Return an object and its floor by its whole id."""
        for floor in self.floors:
            index = self.index(floor)
            if object_id in index.at:
                return floor, index.objects[index.at[object_id]]
        return None

    def get(self, object_id: str, path: str = "$.object_id") -> tuple[int, SceneObject]:
        """Return an object and its floor.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` with the nearest ids.
        """
        found = self.find(object_id)
        if found is not None:
            return found
        import difflib

        known = [item.id for _, item in self.objects()]
        near = difflib.get_close_matches(object_id[:200], known, n=4, cutoff=0.6)
        raise MansionError(
            ErrorCode.NOT_FOUND,
            f"no object {object_id[:120]!r}; ListObjects names them all, nearest: {', '.join(near) or 'none'}",
            path=path,
            details={"nearest": near},
        )

    def room(self, room_id: str) -> tuple[int, SceneRoom] | None:
        """Return a room and its floor by its whole id."""
        for floor in self.floors:
            for room in self.scenes[floor].rooms:
                if room.id == room_id:
                    return floor, room
        return None

    def asset(self, item: SceneObject) -> Asset | None:
        """Return the asset of an object, None where the catalogue lacks it."""
        return self.catalogue.assets.get(item.asset)

    def subtree(self, floor: int, item: SceneObject) -> list[SceneObject]:
        """Return an object and all that it carries, by the scene's hierarchy, carriers first."""
        out, seen = [item], {item.id}
        for member in out:
            for child in self.index(floor).children.get(member.id, []):
                if child.id not in seen:
                    seen.add(child.id)
                    out.append(child)
        return out

    def new_id(self, floor: int, room_id: str, category: str) -> str:
        """Return the next free id ``ROOM/category_n``."""
        taken = self.index(floor).at
        number = 1
        while f"{room_id}/{category}_{number}" in taken:
            number += 1
        return f"{room_id}/{category}_{number}"

    def add(self, floor: int, item: SceneObject) -> None:
        """Append an object."""
        self.apply(ObjectChange(floor=floor, index=len(self.scenes[floor].objects), after=item))

    def remove(self, floor: int, item: SceneObject) -> None:
        """Take an object away."""
        self.apply(ObjectChange(floor=floor, index=self.index(floor).at[item.id], before=item))

    def replace(self, floor: int, item: SceneObject, by: SceneObject) -> None:
        """Put `by` where `item` was."""
        at = self.index(floor).at[item.id]
        self.apply(ObjectChange(floor=floor, index=at, before=item, after=by))

    def apply(self, change: Change) -> None:
        """Do one change and remember it."""
        if isinstance(change, DocumentChange):
            self._replace_document(change)
        else:
            self._put(change.floor, changed(self.scenes[change.floor], change))
        self.pending.append(change)

    def _replace_document(self, change: DocumentChange) -> None:
        floor = floor_of(change.path)
        if floor is not None and is_scene(change.path):
            assert self._copies is not None
            self._replaced.append(self.scenes.get(floor))
            self._put(floor, decode(FloorScene, self._copies(change.after)) if change.after else None)

    def _put(self, floor: int, scene: FloorScene | None) -> None:
        self._indexes.pop(floor, None)
        if scene is None:
            self.scenes.pop(floor, None)
        else:
            self.scenes[floor] = scene

    def roll_back(self, count: int) -> None:
        """Take back all but the first `count` pending changes."""
        while len(self.pending) > count:
            change = self.pending.pop()
            if not isinstance(change, DocumentChange):
                self._put(change.floor, changed(self.scenes[change.floor], inverse(change)))
            elif is_scene(change.path):
                floor = floor_of(change.path)
                assert floor is not None
                self._put(floor, self._replaced.pop())


def inverse(change: _Kind) -> _Kind:
    """Return the change that takes `change` back."""
    return msgspec.structs.replace(change, before=change.after, after=change.before)


def changed(scene: FloorScene, change: SceneChange) -> FloorScene:
    """Return `scene` with one change done.

    Raises
    ------
    MansionError
        ``CONFLICT`` when the object or the room is not as the change has it before.
    """
    if isinstance(change, RoomChange):
        return scene_with(scene, change)
    objects = list(scene.objects)
    before, after = change.before, change.after
    if before is not None:
        at = next((i for i, item in enumerate(objects) if item.id == before.id), None)
        if at is None or objects[at] != before:
            state = "was removed" if at is None else "was changed"
            raise MansionError(
                ErrorCode.CONFLICT,
                f"{before.id} {state} since this edit began; look again and repeat the edit",
                details={"object": before.id},
            )
        objects.pop(at)
        if after is not None:
            objects.insert(at, after)
    elif after is not None:
        if any(item.id == after.id for item in objects):
            raise MansionError(
                ErrorCode.CONFLICT,
                f"the id {after.id} was taken meanwhile; repeat the edit",
                details={"object": after.id},
            )
        objects.insert(min(change.index, len(objects)), after)
    return msgspec.structs.replace(scene, objects=objects)


def net_changes(changes: Sequence[Change]) -> list[ObjectChange]:
    """Return changes of objects that together do the same, at most one each; an object added and removed has none."""
    out: dict[tuple[int, str], ObjectChange] = {}
    for change in changes:
        if not isinstance(change, ObjectChange):
            continue
        key = (change.floor, change.id)
        first = out.get(key)
        if first is not None:
            change = msgspec.structs.replace(change, before=first.before, index=first.index)
        if change.before == change.after:
            out.pop(key, None)
        else:
            out[key] = change
    return list(out.values())


def net_rooms(changes: Sequence[Change]) -> list[RoomChange]:
    """Return changes of rooms that together do the same, at most one for each room."""
    out: dict[str, RoomChange] = {}
    for change in changes:
        if isinstance(change, RoomChange):
            first = out.get(change.id, change)
            out[change.id] = msgspec.structs.replace(change, before=first.before)
    return [change for change in out.values() if change.before != change.after]


def rebase(changes: Sequence[ObjectChange], scenes: Mapping[int, FloorScene]) -> list[ObjectChange]:
    """Return the changes as they apply to `scenes`, with new ids for additions whose id is taken by now.

    Each `index` is the place that the object has when its change is done after those before it, so that the inverse
    changes in reversed order bring back the floor's list as it was.

    Raises
    ------
    MansionError
        ``CONFLICT`` when something that carries an added object is gone.
    """
    taken = {floor: {item.id for item in scene.objects} for floor, scene in scenes.items()}
    kept = net_changes(changes)
    for change in kept:
        if change.after is None:
            taken[change.floor].discard(change.id)
    names: dict[str, str] = {}
    for change in kept:
        if change.before is None:
            ids = taken[change.floor]
            fresh = change.id if change.id not in ids else _next_id(change.id, ids)
            names[change.id] = fresh
            ids.add(fresh)
    out = [_renamed(change, names) for change in kept]
    for change in out:
        parent = change.after.parent if change.after is not None else None
        if parent is not None and parent not in taken[change.floor]:
            raise MansionError(
                ErrorCode.CONFLICT,
                f"{parent}, which should carry {change.id}, was removed meanwhile; look again and repeat the edit",
                details={"object": parent},
            )
    return _placed(out, scenes)


def _placed(changes: Sequence[ObjectChange], scenes: Mapping[int, FloorScene]) -> list[ObjectChange]:
    """Return the changes with the places that their objects have in the lists of their floors."""
    lists = {floor: [item.id for item in scene.objects] for floor, scene in scenes.items()}
    out = []
    for change in changes:
        ids = lists[change.floor]
        at = min(change.index, len(ids))
        if change.before is not None:
            at = ids.index(change.id) if change.id in ids else at
            if change.after is None:
                ids[at : at + 1] = []
        else:
            ids.insert(at, change.id)
        out.append(msgspec.structs.replace(change, index=at))
    return out


def _renamed(change: ObjectChange, names: Mapping[str, str]) -> ObjectChange:
    after = change.after
    if after is None:
        return change
    parent = names.get(after.parent, after.parent) if after.parent is not None else None
    own = names.get(after.id, after.id) if change.before is None else after.id
    if (own, parent) == (after.id, after.parent):
        return change
    return msgspec.structs.replace(change, after=msgspec.structs.replace(after, id=own, parent=parent))


def _next_id(wanted: str, taken: set[str]) -> str:
    stem = wanted.rstrip("0123456789")
    number = 1
    while f"{stem}{number}" in taken:
        number += 1
    return f"{stem}{number}"
