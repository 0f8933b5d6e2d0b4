"""A building in one object: what is in it, pictures of it, changes to it, robots and tasks for it."""

import base64
import html
import shutil
import weakref
from collections.abc import Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from mansion.backend import Backend, History, InProcess, Planner
from mansion.edits import Edit, edit_between
from mansion.homes import Home
from mansion.pictures import FloorPlan
from mansion.selections import Floors, Objects, Rooms, Wishes
from mansion_msgs_py.building import Building as Index
from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.closing import Closing
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.program import BuildingProgram
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.task import Task, TaskKind, read_tasks
from mansion_msgs_py.wording import counted

if TYPE_CHECKING:
    import gymnasium
    import networkx as nx
    import numpy.typing as npt

    from mansion.robot import Robot
    from mansion.viewpoints import Part, Viewpoints
    from mansion_bringup.check import Fault
__all__ = ["Building"]


class Building(Closing):
    """A building in its folder; `mansion.build` and `mansion.load` make one.

    Parameters
    ----------
    home : Home
        Its folder.
    backend : Backend, optional
        Who edits it and moves its robots; this process when absent.

    Examples
    --------
    >>> b = mansion.build("a small flat for two", seed=4)
    >>> [floor.number for floor in b.floors], b.seed
    ([1], 4)
    >>> b.rooms["bathroom"].area < b.area
    True
    """

    def __init__(self, home: Home, backend: Backend | None = None) -> None:
        self._home = home
        self._backend = backend or InProcess(home.folder)
        self._views: dict[tuple[int, int, float], tuple[Viewpoints, weakref.finalize[[], Building]]] = {}
        self.reload()

    def reload(self) -> None:
        """Read the folder again, after someone else has edited it."""
        reader = BuildingFolder(self.folder)
        self._index: Index = reader.building
        self._scenes: tuple[FloorScene, ...] = tuple(reader.scenes())
        self.__dict__.pop("floors", None)
        self._close_views()

    @property
    def folder(self) -> Path:
        """Where its files are."""
        return self._home.folder

    @property
    def id(self) -> str:
        """What payloads call it."""
        return self._index.building_id

    @property
    def request(self) -> BuildRequest:
        """What was asked for."""
        return self._index.request

    @property
    def description(self) -> str:
        """The brief."""
        return self.request.description

    @property
    def seed(self) -> int:
        """What everything random in it follows from."""
        return self._index.seed

    @property
    def program(self) -> BuildingProgram:
        """What was planned."""
        return self._index.program

    @property
    def area(self) -> float:
        """Total area of the rooms, square metres."""
        return sum(floor.area for floor in self.floors)

    @cached_property
    def floors(self) -> Floors:
        """The storeys from below, by number: ``b.floors[2]``."""
        return Floors.of(self._scenes)

    @property
    def rooms(self) -> Rooms:
        """All rooms: ``b.rooms["kitchen"]``, ``b.rooms.filter(type="office")``, ``b.rooms.find("largest bedroom")``."""
        return self.floors.rooms

    @property
    def objects(self) -> Objects:
        """All objects: ``b.objects.filter(category="chair")``, ``b.objects.find("something to sit on")``."""
        return self.floors.objects

    @property
    def wishes(self) -> Wishes:
        """The receipt: what the brief asks for, and what became of it."""
        return Wishes(self._index.wishes)

    def graph(self) -> "nx.Graph[str]":
        """Return rooms, stairs and lifts as a networkx graph, with an edge for each door or opening.

        Nodes have ``kind``, ``type``, ``floor`` and ``area``; edges ``door``, ``kind`` and ``width`` in metres. A stair
        or a lift is one node, which leads to every floor that it serves.

        Examples
        --------
        >>> import networkx as nx
        >>> nx.is_connected(b.graph())
        True
        """
        return _room_graph(self._scenes)

    def plan(self, floor: int | str = 1) -> FloorPlan:
        """Return the plan of a floor, by number or label.

        Examples
        --------
        >>> b.plan(1)
        <plan of floor 1>
        >>> b.plan(7)
        Traceback (most recent call last):
            ...
        mansion_msgs_py.errors.MansionError: NOT_FOUND: there is no floor 7; floors: 1
        """
        return self.floors[floor].plan

    def look(
        self,
        place: str = "",
        *,
        floor: int | None = None,
        turn: float = 0.0,
        part: "Part" = "rgb",
        width: int = 640,
        height: int = 480,
        fov: float = 90.0,
    ) -> "npt.NDArray[Any]":
        """Return a view of a room, a stair or a lift, as the building is built; nothing is moved.

        Parameters
        ----------
        place : str
            A room, seen from where most of it is in view, or a stair or lift; where robots start when empty.
        floor : int, optional
            The floor of the place, where its name does not say it.
        turn : float
            Degrees to the left of the usual view.
        part : {"rgb", "depth", "segmentation", "panorama"}
            Colours, ``(height, width, 3)``; metres; labels, of which -1 is the sky; or colours all around.
        width, height : int
            Pixels.
        fov : float
            Across, degrees.

        Raises
        ------
        MansionError
            ``UNAVAILABLE`` naming the extra ``sim``, where it is missing; ``NOT_FOUND`` with the places there are.

        Examples
        --------
        >>> b.look("kitchen", width=64, height=48).shape
        (48, 64, 3)
        """
        with importing:
            from mansion_bringup.extras import require_extra

        require_extra("sim")
        with importing:
            from mansion.viewpoints import Viewpoints, close_with

        key = (width, height, fov)
        if key not in self._views:
            views = Viewpoints(self.folder, width, height, fov)
            self._views[key] = (views, close_with(self, views))
        return self._views[key][0].look(place, floor, turn, part)

    def show(self, *, browser: bool = True) -> Path:
        """Open the page with the 3D building in the browser, and return its file.

        Examples
        --------
        >>> b.show(browser=False).name
        'view.html'
        """
        with importing:
            import webbrowser

            from mansion_bringup.exporting import write_page

        page = write_page(self.folder)
        if browser:
            webbrowser.open(page.absolute().as_uri())
        return page

    def edit(self, instruction: str, *, planner: Planner = "rules", physics: str | None = None) -> Edit:
        """Carry out an instruction, or answer a question; all of it lands, checked, or nothing does.

        Parameters
        ----------
        instruction : str
        planner : {"rules", "llm"}
            Who plans it.
        physics : {"mujoco", "static", "thor"}, optional
            What settles objects that are placed: MuJoCo, of the extra ``sim``, when absent.

        Returns
        -------
        Edit
            What changed, object by object.

        Raises
        ------
        MansionError
            ``INFEASIBLE`` with the reason when it is not done, and in ``details["candidates"]`` what words may mean
            that fit several things; ``UNAVAILABLE`` naming a missing extra.

        Examples
        --------
        >>> done = b.edit("put a red mug on the coffee table")
        >>> done.added.ids
        ('F1/living_room/mug_1',)
        >>> b.undo().removed.ids
        ('F1/living_room/mug_1',)
        >>> b.edit("how many fridges are in the kitchen?").message
        'There is 1 fridge in the kitchen.'
        """
        self.reload()
        before = self._scenes
        report = self._backend.instruct(instruction, planner, physics)
        if not report.done:
            details = {"failed": report.failed, "candidates": report.candidates}
            raise MansionError(ErrorCode.INFEASIBLE, report.message, details=details)
        self.reload()
        return edit_between(report.message, before, self._scenes)

    def undo(self) -> Edit:
        """Take back your last edit.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` when there is none, ``CONFLICT`` when others have changed the same since.
        """
        return self._step_in_history("Undo")

    def redo(self) -> Edit:
        """Do again what was undone last."""
        return self._step_in_history("Redo")

    def _step_in_history(self, tool: History) -> Edit:
        self.reload()
        before = self._scenes
        message = self._backend.history(tool)
        self.reload()
        return edit_between(message, before, self._scenes)

    def check(self) -> "tuple[Fault, ...]":
        """Verify the building from its geometry and its request, as ``mansion check``; empty for a sound one.

        Examples
        --------
        >>> b.check()
        ()
        """
        with importing:
            from mansion_bringup.verify import verify_building

        return tuple(verify_building(self.folder))

    def export(self, to: str, folder: str | Path | None = None) -> tuple[Path, ...]:
        """Write the building in another program's format, and return the files.

        Parameters
        ----------
        to : str
            ``thor``, ``glb``, ``mjcf``, ``nav2``, ``rmf``, ``sdf``, ``usd``, ... as ``mansion export --to``.
        folder : path, optional
            The building's own when absent.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` with the formats that there are, ``UNAVAILABLE`` naming a missing extra.

        Examples
        --------
        >>> [file.name for file in b.export("glb")]
        ['building.glb', 'floor.glb']
        """
        with importing:
            from mansion_bringup.exporting import format_named, write_export
            from mansion_bringup.extras import require_extra

        chosen = format_named(to)
        if chosen.extra:
            require_extra(chosen.extra)
        return tuple(write_export(self.folder, chosen, None if folder is None else Path(folder)))

    def save(self, folder: str | Path) -> "Building":
        """Copy the building, without what robots left in it, to a new folder and return the copy.

        Raises
        ------
        MansionError
            ``CONFLICT`` when the folder exists.
        """
        target = Path(folder)
        if target.exists():
            raise MansionError(ErrorCode.CONFLICT, f"{target} exists; name a new folder")
        shutil.copytree(self.folder, target, ignore=shutil.ignore_patterns("state"))
        return Building(Home(target))

    def robot(self, session: str = "", *, reset: bool = False) -> "Robot":
        """Put a robot into the building, where a former run of its session left it.

        Parameters
        ----------
        session : str
            Which robot; the default one when empty.
        reset : bool
            Start over: everything back where it was built, the robot at its start.

        Raises
        ------
        MansionError
            ``CONFLICT`` for a reset while other robots are in the building.

        Examples
        --------
        >>> robot = b.robot(reset=True)
        >>> robot.go_to("kitchen").status.value
        'SUCCESS'
        """
        with importing:
            from mansion.robot import Robot

        return Robot(self._backend.robot(session, reset=reset), self._home)

    def tasks(self, count: int = 10, *, seed: int = 0, kind: TaskKind | str | None = None) -> tuple[Task, ...]:
        """Make tasks for a robot, each proven by the oracle; fewer where the building has no more that differ.

        Parameters
        ----------
        kind : {"deliver", "search", "open_and_put", "collect"}, optional
            Only tasks of this kind.

        Examples
        --------
        >>> task, = b.tasks(1)
        >>> task.instruction.endswith(".")
        True
        """
        with importing:
            from mansion_tasks.tasks.generate import generate
            from mansion_tasks.tasks.sandbox import Sandbox

        return tuple(generate(Sandbox(self.folder), count, seed, None if kind is None else _kind(kind)))

    def env(
        self, task: Task | Sequence[Task] | str | Path | None = None, **options: Any
    ) -> "gymnasium.Env[Mapping[str, Any], Any]":
        """Return a Gymnasium environment of the building.

        Parameters
        ----------
        task : Task, sequence of Task, or path, optional
            The task, several to choose from at a reset, or a file of ``mansion task generate``; ten are made when
            absent.
        **options
            ``actions``, ``observation``, ``image_size``, ``max_steps``, ``task_seed``, ``render_mode``: see
            `mansion_tasks.env.building_env.BuildingEnv`, and what ``gymnasium.make`` takes.

        Raises
        ------
        MansionError
            ``UNAVAILABLE`` naming the extra ``sim``, where it is missing.

        Examples
        --------
        >>> env = b.env(actions="skill")
        >>> observation, info = env.reset(seed=1)
        >>> info["success"], env.unwrapped.task.instruction == info["instruction"]
        (False, True)
        """
        with importing:
            from mansion_bringup.extras import require_extra

        require_extra("sim")
        with importing:
            import gymnasium

            from mansion_tasks.env import ENV_ID

        made: gymnasium.Env[Mapping[str, Any], Any] = gymnasium.make(
            ENV_ID, building=self.folder, tasks=_tasks(task), **options
        )
        # The environment reads the folder when it needs a picture: a temporary one has to outlive it.
        weakref.finalize(made.unwrapped, _forget, self._home)
        return made

    def close(self) -> None:
        """Free its cameras, and remove its folder if that is a temporary one."""
        self._close_views()
        self._home.remove()

    def _close_views(self) -> None:
        for _, closing in self._views.values():
            closing()
        self._views.clear()

    def __repr__(self) -> str:
        parts = (counted(len(self.floors), "floor"), counted(len(self.rooms), "room"))
        return f"<{self.description!r}: {', '.join(parts)}, {counted(len(self.objects), 'object')}, in {self.folder}>"

    def _repr_png_(self) -> bytes:
        drawn = self.folder / "building.png"
        if drawn.is_file():
            return drawn.read_bytes()
        with importing:
            from mansion_export.pictures.overview import overview_png

        return overview_png(self._scenes)

    def _repr_html_(self) -> str:
        picture = base64.b64encode(self._repr_png_()).decode()
        title = html.escape(repr(self)[1:-1])
        return f'<p>{title}</p><img src="data:image/png;base64,{picture}" style="max-width:100%">'


def _tasks(task: Task | Sequence[Task] | str | Path | None) -> list[Task] | None:
    if task is None:
        return None
    if isinstance(task, (str, Path)):
        return read_tasks(Path(task))
    return [task] if isinstance(task, Task) else list(task)


def _kind(kind: TaskKind | str) -> TaskKind:
    try:
        return TaskKind(kind)
    except ValueError:
        known = ", ".join(entry.value for entry in TaskKind)
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"there is no kind of task {kind!r}; kinds: {known}") from None


def _forget(home: Home) -> None:
    """Let go of a home; holding it until now is what this is for."""


def _room_graph(scenes: Sequence[FloorScene]) -> "nx.Graph[str]":
    """Return the graph of `Building.graph`."""
    import networkx as nx

    graph: nx.Graph[str] = nx.Graph()
    for scene in scenes:
        cores = {core.id for core in scene.cores}
        for room in scene.rooms:
            if room.kind not in ("stair", "elevator"):
                graph.add_node(room.id, kind=room.kind, type=room.room_type, floor=scene.floor, area=room.area)
        for core in scene.cores:
            graph.add_node(core.id, kind=core.type, type=core.type, floor=None, area=None)
        for door in scene.doors:
            one, other = (_node(name, cores) for name in door.rooms)
            if one and other:
                graph.add_edge(one, other, door=door.id, kind=door.kind, width=door.width)
    return graph


def _node(room: str | None, cores: set[str]) -> str:
    """Return the node of what a door joins; a core is one node on all floors, the outside is none."""
    name = room or ""
    last = name.rpartition("/")[2]
    return last if last in cores else name
