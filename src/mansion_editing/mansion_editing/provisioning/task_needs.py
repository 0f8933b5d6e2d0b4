"""A task's needs as facts of a building (the check-and-provision workflow, supplement D.2)."""

from collections.abc import Generator, Iterable

from mansion_assets.catalogue.vocabulary import stems, vocabulary_of
from mansion_editing.editor import SceneEditor
from mansion_editing.provisioning.facts import Fact, ObjectDescription, ObjectFact, PathFact, Scope
from mansion_editing.provisioning.object_search import find_objects, rooms_of
from mansion_editing.provisioning.satisfying import satisfy
from mansion_editing.runs.policies import Action, Outcome, Policy, Unmet, Verdict
from mansion_editing.state import SceneState
from mansion_editing.tools.perception import find_rooms
from mansion_language.colours import COLOUR_WORDS
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.task import Need, Task, TaskStart
from mansion_msgs_py.wording import counted

__all__ = ["facts_of_needs", "task_policy"]


def task_policy(editor: SceneEditor, task: Task) -> Policy:
    """Check each need of a task and provide what is missing; then check the paths from the robot's start.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for a task of another building or without needs; see `facts_of_needs`.
    """
    state = editor.state
    own = editor.store.building.building_id
    if task.building_id and task.building_id != own:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"task {task.id} is for building {task.building_id!r}, this is {own!r}",
            path="$.building_id",
        )
    if not task.needs:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"task {task.id} lists no needs", path="$.needs")
    facts = facts_of_needs(state, task.needs)
    provided = yield from satisfy(facts, state)
    if provided.failed:
        return provided
    ends = yield from _ends(facts, state)
    start = _start(state, task.start)
    routes: list[Fact] = [PathFact(start, end) for end in ends]
    paths = yield from satisfy(routes, state)
    return Verdict(
        f"met: {counted(len(facts), 'need')} and {counted(len(routes), 'path')}" if not paths.failed else paths.summary,
        [*provided.facts, *paths.facts],
        paths.failed,
    )


def facts_of_needs(state: SceneState, needs: Iterable[Need]) -> list[Fact]:
    """Return a fact for each need; a room that is needed itself becomes a way to it.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a room, a floor or a noun that is unknown here.
    """
    return [_add_facts(state, need, f"$.needs[{number}]") for number, need in enumerate(needs)]


def _add_facts(state: SceneState, need: Need, path: str) -> Fact:
    floor = need.floor
    if floor is not None and floor not in state.scenes:
        known = ", ".join(map(str, state.floors))
        raise MansionError(
            ErrorCode.NOT_FOUND, f"there is no floor {floor}; the building has floors {known}", path=f"{path}.floor"
        )
    rooms = _rooms(state, need.room, floor, f"{path}.room") if need.room else ()
    if not need.noun:
        if not rooms and floor is None:
            raise _unknown(need.noun, f"{path}.noun")
        return PathFact("", (rooms or rooms_of(Scope(floor=floor), state))[0])
    if state.find(need.noun) is None and not _is_thing(state, need.noun):
        return PathFact("", _rooms(state, need.noun, floor, f"{path}.noun")[0])
    receptacle = need.receptacle
    if receptacle and state.find(receptacle) is None and not vocabulary_of(state.catalogue).nouns(receptacle):
        raise _unknown(receptacle, f"{path}.receptacle")
    scope = Scope(
        relation=need.relation if receptacle else "room",
        receptacle=receptacle,
        rooms=rooms,
        floor=floor,
        colour=_colour(need.receptacle_color, f"{path}.receptacle_color"),
    )
    return ObjectFact(ObjectDescription(need.noun, 1, _colour(need.color, f"{path}.color")), scope)


def _is_thing(state: SceneState, noun: str) -> bool:
    """Whether a noun names objects: exactly, or in part where no room has that name."""
    words = vocabulary_of(state.catalogue)
    if words.exact(stems(noun)):
        return True
    return bool(words.nouns(noun)) and not find_rooms(state, noun)


def _rooms(state: SceneState, words: str, floor: int | None, path: str) -> tuple[str, ...]:
    found = tuple(room.id for _, room in find_rooms(state, words, floor)) if words else ()
    if not found:
        raise _unknown(words, path)
    return found


def _unknown(words: str, path: str) -> MansionError:
    return MansionError(
        ErrorCode.NOT_FOUND,
        f"{words[:80]!r} is neither a room of this building nor an object of the catalogue",
        path=path,
    )


def _colour(word: str, path: str) -> str:
    if word and word.lower() not in COLOUR_WORDS:
        known = ", ".join(sorted(set(COLOUR_WORDS.values())))
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"unknown colour {word[:40]!r}; known are {known}", path=path)
    return COLOUR_WORDS[word.lower()] if word else ""


def _ends(facts: Iterable[Fact], state: SceneState) -> Generator[Action, Outcome, list[str]]:
    """Return the rooms in which the needs are met."""
    out: dict[str, None] = {}
    for fact in facts:
        if isinstance(fact, PathFact):
            out[fact.end] = None
        elif isinstance(fact, ObjectFact):
            try:
                found = yield from find_objects(fact.object, fact.where, state)
            except Unmet:
                continue
            if found:
                out[found[0].room] = None
    return list(out)


def _start(state: SceneState, start: TaskStart | None) -> str:
    if start is None or start.floor not in state.scenes:
        return ""
    room = state.index(start.floor).room_at(start.pose.x, start.pose.y)
    return "" if room is None else room.id
