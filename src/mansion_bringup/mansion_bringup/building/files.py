"""The files of a building: payloads of each floor, and what `mansion_export.formats` makes from scenes."""

from collections.abc import Iterable, Sequence
from pathlib import Path

from mansion_assets.library.building_assets import assets_of
from mansion_export.formats import Output, Outputs, indexed_outputs
from mansion_msgs_py.building_folder import floor_directory
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.topology import FloorTopology

__all__ = ["building_file_names", "floor_file_names", "floor_files", "kept_files", "kept_outputs"]

_PAYLOADS = {"topology": "topology.json", "layout": "layout.json", "scene": "scene.json"}


def floor_file_names(outputs: Iterable[Output]) -> dict[str, str]:
    """Return the names of a floor's payloads and of what is made of it by their keys in ``building.json``."""
    return _PAYLOADS | _named(outputs)


def building_file_names(outputs: Iterable[Output]) -> dict[str, str]:
    """Return the names of a building's report and of what is made of all floors by their keys in ``building.json``."""
    return {"report": "report.json"} | _named(outputs)


def _named(outputs: Iterable[Output]) -> dict[str, str]:
    return {key: name for output in outputs if output.keys for key, name in zip(output.keys, output.files, strict=True)}


def floor_files(
    topology: FloorTopology, layout: FloorLayout, scene: FloorScene, outputs: Iterable[Output]
) -> dict[str, bytes]:
    """Return the payloads of a floor and what is made of it, by path relative to the building's folder."""
    folder = floor_directory(scene.floor)
    payloads = {"topology": topology, "layout": layout, "scene": scene}
    files = {f"{folder}/{_PAYLOADS[key]}": encode_bytes(payload, indent=1) for key, payload in payloads.items()}
    for output in outputs:
        files |= output.make(scene)
    return files


def kept_outputs(folder: Path, floors: Iterable[int]) -> Outputs:
    """Return what ``building.json`` may name and the folder has, of some floor or of the whole."""
    directories = [folder / floor_directory(floor) for floor in floors]
    known = indexed_outputs()
    return Outputs(
        tuple(output for output in known.floor if any(_has(place, output) for place in directories)),
        tuple(output for output in known.building if _has(folder, output)),
    )


def _has(place: Path, output: Output) -> bool:
    return any((place / name).is_file() for name in output.files)


def kept_files(folder: Path, scenes: Sequence[FloorScene], changed: Sequence[int]) -> dict[str, bytes]:
    """Return the files of a folder that are made from scenes, updated as far as they show the changed floors.

    Parameters
    ----------
    folder : Path
        The building's folder.
    scenes : sequence of FloorScene
        All floors as they are now.
    changed : sequence of int
        Numbers of the floors that changed.

    Returns
    -------
    dict of str to bytes
        By path relative to the folder. What the folder has of no floor is not added.
    """
    outputs = kept_outputs(folder, [scene.floor for scene in scenes])
    files: dict[str, bytes] = {}
    with assets_of(folder):
        for scene in scenes:
            for output in outputs.floor if scene.floor in changed else ():
                files |= output.make(scene)
        for output in outputs.building:
            files |= output.make(scenes)
    return files
