"""Export formats: what each is called, which functions make its files, and which of them a build writes.

A format is a module and a registration below. ``mansion export --to`` and its help, the files of ``mansion build`` and
of ``mansion edit``, and the index ``building.json`` follow from the registrations; a test compares the table in
``docs/exports.md`` with them. Every build writes the few formats that people look at; the others it writes when asked.
Functions are named and imported on use, so that the command line can list the formats without loading any.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pkgutil import resolve_name
from typing import Any, Final

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.scene import FloorScene

__all__ = [
    "ALL",
    "PLAIN",
    "ExportOptions",
    "Format",
    "Output",
    "Outputs",
    "export_formats",
    "formats_of_build",
    "indexed_outputs",
    "outputs_of_build",
    "register",
]

ALL: Final = "all"
"""What a build is asked for to write every format that ``building.json`` has keys for."""


@dataclass(frozen=True, slots=True)
class ExportOptions:
    """What of a building is exported, beyond the format.

    Attributes
    ----------
    articulated : bool
        With joints for parts that move.
    site : bool
        With the plot around the building, and what stands before its doors.
    """

    articulated: bool = False
    site: bool = True


PLAIN: Final = ExportOptions()


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
        Their keys in ``building.json``; empty for what it does not name.
    options : tuple of str
        Names of the fields of `ExportOptions` that the function takes as keywords.
    """

    function: str
    files: tuple[str, ...]
    keys: tuple[str, ...] = ()
    options: tuple[str, ...] = ()

    @property
    def module(self) -> str:
        """Name of the module that defines the function."""
        return self.function.partition(":")[0]

    def make(self, scenes: FloorScene | Sequence[FloorScene], options: ExportOptions = PLAIN) -> dict[str, bytes]:
        """Return the files by path in the building's folder, with the options that the function takes."""
        with importing:
            function: Any = resolve_name(self.function)
        files: dict[str, bytes] = function(scenes, **{name: getattr(options, name) for name in self.options})
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
    always : bool
        Whether every build writes it, asked or not.
    """

    name: str
    title: str
    building: Output | None = None
    floor: Output | None = None
    extra: str = ""
    always: bool = False

    def takes(self, option: str) -> bool:
        """Whether a field of `ExportOptions` makes a difference to the format."""
        return any(output is not None and option in output.options for output in (self.building, self.floor))

    def make(self, scenes: Sequence[FloorScene], options: ExportOptions = PLAIN) -> dict[str, bytes]:
        """Return all files of the format, those of the whole building first, by path in the building's folder."""
        made = [self.building.make(scenes, options)] if self.building else []
        made += [self.floor.make(scene, options) for scene in scenes] if self.floor else []
        return {path: data for files in made for path, data in files.items()}


@dataclass(frozen=True, slots=True)
class Outputs:
    """What is made of each floor, and of all floors together, in the order of the formats."""

    floor: tuple[Output, ...]
    building: tuple[Output, ...]


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


def formats_of_build(names: Iterable[str] = ()) -> tuple[Format, ...]:
    """Return the formats that a build writes: those of every build, and those that it is asked for.

    Parameters
    ----------
    names : iterable of str
        Names of formats; `ALL` stands for those that ``building.json`` has keys for.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` at ``$.formats`` with the known names.
    """
    asked = set(names)
    unknown = sorted(asked - {ALL, *_formats})
    if unknown:
        raise MansionError(
            ErrorCode.NOT_FOUND,
            f"no format {', '.join(map(repr, unknown))}; use {ALL}, or some of {', '.join(_formats)}",
            path="$.formats",
        )
    return tuple(
        each
        for each in _formats.values()
        if each.always or each.name in asked or (ALL in asked and any(_indexed(each)))
    )


def outputs_of_build(names: Iterable[str] = ()) -> Outputs:
    """Return what a build writes; see `formats_of_build`.

    For a format with keys in ``building.json`` these are the files that they name, else all that an export writes.
    """
    chosen = formats_of_build(names)
    whole = [each.building for each in chosen if each.building and (each.building.keys or not any(_indexed(each)))]
    floor = [each.floor for each in chosen if each.floor and (each.floor.keys or not any(_indexed(each)))]
    return Outputs(tuple(floor), tuple(whole))


def indexed_outputs() -> Outputs:
    """Return what ``building.json`` has keys for, in all formats."""
    return outputs_of_build((ALL,))


def _indexed(each: Format) -> tuple[Output, ...]:
    return tuple(output for output in (each.floor, each.building) if output is not None and output.keys)


register(
    Format("thor", "AI2-THOR house", floor=Output("mansion_export.thor.house:house_files", ("house.json",), ("house",)))
)
register(
    Format(
        "plan",
        "floor plan",
        floor=Output("mansion_export.plan:plan_files", ("plan.svg", "plan.png"), ("plan_svg", "plan_png")),
        always=True,
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
        "mjcf",
        "MuJoCo model",
        floor=Output("mansion_export.mjcf:mjcf_files", ("model.xml",), ("model",), ("articulated",)),
    )
)
register(
    Format(
        "glb",
        "binary glTF",
        building=Output("mansion_export.glb:building_files", ("building.glb",), ("model",), ("site",)),
        floor=Output("mansion_export.glb:floor_files", ("floor.glb",)),
    )
)
register(
    Format(
        "overview",
        "picture of the building",
        building=Output("mansion_export.pictures.overview:overview_files", ("building.png",), ("picture",), ("site",)),
        always=True,
    )
)
register(
    Format(
        "html",
        "page with a 3D view",
        building=Output("mansion_export.html:page_files", ("view.html",), options=("site",)),
    )
)
register(
    Format(
        "sdf",
        "Gazebo world",
        building=Output("mansion_export.sdf:sdf_files", ("building.sdf",), options=("articulated", "site")),
    )
)
register(
    Format(
        "usd",
        "OpenUSD stage",
        building=Output("mansion_export.usd:usd_files", ("building.usdc",), options=("articulated", "site")),
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
register(
    Format(
        "ifc",
        "building model of architects, IFC4",
        building=Output("mansion_export.ifc:ifc_files", ("building.ifc",)),
        extra="ifc",
    )
)
