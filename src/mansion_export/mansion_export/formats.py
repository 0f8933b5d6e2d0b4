"""Export formats: what each is called, which functions make its files, and which of them a build writes.

A format is a module and a registration below. ``mansion export --to`` and its help, the files of ``mansion build`` and
of ``mansion edit``, and the index ``building.json`` follow from the registrations; a test compares the table in
``docs/exports.md`` with them.
Functions are named and imported on use, so that the command line can list the formats without loading any.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pkgutil import resolve_name
from typing import Any

from mansion_msgs_py.scene import FloorScene

__all__ = ["Format", "Output", "built_building_outputs", "built_floor_outputs", "export_formats", "register"]


@dataclass(frozen=True, slots=True)
class Output:
    """Files that one function makes, of a floor or of a building.

    Attributes
    ----------
    function : str
        ``module:function``; takes the floor's scene, or the scenes of all floors, and returns bytes by path in the
        building's folder.
    files : tuple of str
        Their names in the folder of the floor, or of the building; meshes are left out.
    keys : tuple of str
        Their keys in ``building.json``; empty where ``mansion build`` does not write them.
    jointed : bool
        Whether the function takes ``articulated=True``, for parts that move.
    """

    function: str
    files: tuple[str, ...]
    keys: tuple[str, ...] = ()
    jointed: bool = False

    @property
    def module(self) -> str:
        """Name of the module that defines the function."""
        return self.function.partition(":")[0]

    def make(self, scenes: FloorScene | Sequence[FloorScene], *, articulated: bool = False) -> dict[str, bytes]:
        """Return the files by path in the building's folder, with joints where they are asked for and can be had."""
        function: Any = resolve_name(self.function)
        files: dict[str, bytes] = (
            function(scenes, articulated=True) if articulated and self.jointed else function(scenes)
        )
        return files


@dataclass(frozen=True, slots=True)
class Format:
    """An export format.

    Attributes
    ----------
    name : str
        As ``mansion export --to`` takes it.
    title : str
        What it is, in the documentation's words.
    building, floor : Output, optional
        What is made of all floors together, and of each.
    extra : str
        Optional dependency that it needs; empty for none.
    """

    name: str
    title: str
    building: Output | None = None
    floor: Output | None = None
    extra: str = ""

    @property
    def jointed(self) -> bool:
        """Whether the format has joints for parts that move."""
        return any(output is not None and output.jointed for output in (self.building, self.floor))

    def make(self, scenes: Sequence[FloorScene], *, articulated: bool = False) -> dict[str, bytes]:
        """Return all files of the format, those of the whole building first, by path in the building's folder."""
        made = [self.building.make(scenes, articulated=articulated)] if self.building else []
        made += [self.floor.make(scene, articulated=articulated) for scene in scenes] if self.floor else []
        return {path: data for files in made for path, data in files.items()}


_formats: dict[str, Format] = {}


def register(new: Format) -> None:
    """Add a format.

    Raises
    ------
    ValueError
        A format has this name, or a file's number of keys is not that of the files.
    """
    if new.name in _formats:
        raise ValueError(f"an export format is already called {new.name!r}")
    for output in (new.building, new.floor):
        if output is not None and output.keys and len(output.keys) != len(output.files):
            raise ValueError(f"{new.name}: {len(output.files)} files have {len(output.keys)} keys")
    _formats[new.name] = new


def export_formats() -> dict[str, Format]:
    """Return all formats by name, in the order of their registration."""
    return dict(_formats)


def built_floor_outputs() -> Iterator[Output]:
    """Yield what a build writes of each floor."""
    for each in _formats.values():
        if each.floor is not None and each.floor.keys:
            yield each.floor


def built_building_outputs() -> Iterator[Output]:
    """Yield what a build writes of all floors together."""
    for each in _formats.values():
        if each.building is not None and each.building.keys:
            yield each.building


register(
    Format("thor", "AI2-THOR house", floor=Output("mansion_export.thor.house:house_files", ("house.json",), ("house",)))
)
register(
    Format(
        "plan",
        "floor plan",
        floor=Output("mansion_export.plan:plan_files", ("plan.svg", "plan.png"), ("plan_svg", "plan_png")),
    )
)
register(
    Format(
        "nav2",
        "occupancy map for Nav2",
        floor=Output("mansion_export.nav2:map_files", ("map.yaml", "map.pgm"), ("map", "map_image")),
    )
)
register(
    Format(
        "mjcf", "MuJoCo model", floor=Output("mansion_export.mjcf:mjcf_files", ("model.xml",), ("model",), jointed=True)
    )
)
register(
    Format(
        "glb",
        "binary glTF",
        building=Output("mansion_export.glb:building_files", ("building.glb",), ("model",)),
        floor=Output("mansion_export.glb:floor_files", ("floor.glb",)),
    )
)
register(
    Format(
        "overview",
        "picture of the building",
        building=Output("mansion_export.overview:overview_files", ("building.png",), ("picture",)),
    )
)
register(Format("html", "page with a 3D view", building=Output("mansion_export.html:page_files", ("view.html",))))
register(
    Format("sdf", "Gazebo world", building=Output("mansion_export.sdf:sdf_files", ("building.sdf",), jointed=True))
)
register(
    Format(
        "usd",
        "OpenUSD stage",
        building=Output("mansion_export.usd:usd_files", ("building.usdc",), jointed=True),
        extra="usd",
    )
)
register(
    Format(
        "rmf",
        "map and lanes for Open-RMF",
        building=Output("mansion_export.rmf.maps:rmf_files", ("NAME.building.yaml", "nav_graphs/0.yaml")),
    )
)
