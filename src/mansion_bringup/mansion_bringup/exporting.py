"""A finished building in another program's format, and as a page for people."""

from collections.abc import Sequence
from pathlib import Path

from mansion_bringup.extras import ensure_extra
from mansion_export.formats import PLAIN, ExportOptions, Format, export_formats
from mansion_msgs_py.building_folder import BuildingFolder, file_in
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import write_atomic
from mansion_msgs_py.late_imports import importing

__all__ = ["PAGE", "format_named", "format_names", "write_export", "write_page"]

PAGE = "view.html"
"""Name of the page in a building's folder."""


def format_named(name: str) -> Format:
    """Return an export format.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` with the formats that there are.
    """
    formats = export_formats()
    if name not in formats:
        known = ", ".join(formats)
        raise MansionError(ErrorCode.NOT_FOUND, f"no format {name!r}; use one of {known}", path="$.to")
    return formats[name]


def format_names(listed: str | Sequence[str]) -> list[str]:
    """Return names of formats that are given one by one, or in one text with commas between them.

    Examples
    --------
    >>> format_names("glb, nav2"), format_names(["all"]), format_names("")
    (['glb', 'nav2'], ['all'], [])
    """
    given = listed.split(",") if isinstance(listed, str) else listed
    return [name.strip() for name in given if name.strip()]


def write_export(building: Path, to: Format, output: Path | None = None, options: ExportOptions = PLAIN) -> list[Path]:
    """Write a building in a format, and return the files, those of the whole building first.

    Parameters
    ----------
    building : Path
        The building's folder.
    output : Path, optional
        Folder to write; the building's own when absent.
    options : ExportOptions

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` where joints are asked for and the format has none.
    """
    if options.articulated and not to.takes("articulated"):
        known = ", ".join(name for name, each in export_formats().items() if each.takes("articulated"))
        raise MansionError(ErrorCode.UNAVAILABLE, f"{to.name} has no joints; use one of {known}", path="$.to")
    with importing:
        from mansion_assets.library.building_assets import assets_of
        from mansion_geometry.sound_shapes import require_sound_shapes

    read, target = BuildingFolder(building), output or building
    if to.extra:
        ensure_extra(to.extra)
    scenes = read.scenes()
    require_sound_shapes(scenes)
    with assets_of(building):
        files = to.make(scenes, options)
    for name, data in files.items():
        write_atomic(file_in(target, name), data)
    return [target / name for name in files]


def write_page(building: Path, output: Path | None = None, *, site: bool = True) -> Path:
    """Write the self-contained page with the 3D building, ``view.html`` in its folder when no file is named."""
    with importing:
        from mansion_assets.library.building_assets import assets_of
        from mansion_export.html import view_page
        from mansion_geometry.sound_shapes import require_sound_shapes

    page = output or building / PAGE
    scenes = BuildingFolder(building).scenes()
    require_sound_shapes(scenes)
    with assets_of(building):
        text = view_page(scenes, site=site)
    write_atomic(page, text.encode())
    return page
