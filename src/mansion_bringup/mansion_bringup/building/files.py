"""What a build writes: the payloads of each floor, and the formats made from scenes (`mansion_export.formats`)."""

from collections.abc import Sequence

from mansion_export.formats import built_building_outputs, built_floor_outputs
from mansion_msgs_py.building_folder import floor_directory
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.topology import FloorTopology

__all__ = ["building_exports", "building_file_names", "floor_exports", "floor_file_names", "floor_files"]

_PAYLOADS = {"topology": "topology.json", "layout": "layout.json", "scene": "scene.json"}


def floor_file_names() -> dict[str, str]:
    """Return the names of a floor's files by their keys in ``building.json``."""
    return _PAYLOADS | {
        key: name for output in built_floor_outputs() for key, name in zip(output.keys, output.files, strict=True)
    }


def building_file_names() -> dict[str, str]:
    """Return the names of a building's own files by their keys in ``building.json``."""
    return {"report": "report.json"} | {
        key: name for output in built_building_outputs() for key, name in zip(output.keys, output.files, strict=True)
    }


def floor_files(topology: FloorTopology, layout: FloorLayout, scene: FloorScene) -> dict[str, bytes]:
    """Return all files of a floor, by path relative to the building's folder."""
    folder = floor_directory(scene.floor)
    payloads = {"topology": topology, "layout": layout, "scene": scene}
    files = {f"{folder}/{_PAYLOADS[key]}": encode_bytes(payload, indent=1) for key, payload in payloads.items()}
    return files | floor_exports(scene)


def floor_exports(scene: FloorScene) -> dict[str, bytes]:
    """Return what is made from one scene, the scene itself left out, by path relative to the building's folder."""
    return {path: data for output in built_floor_outputs() for path, data in output.make(scene).items()}


def building_exports(scenes: Sequence[FloorScene]) -> dict[str, bytes]:
    """Return what is made from all scenes, by path relative to the building's folder."""
    return {path: data for output in built_building_outputs() for path, data in output.make(scenes).items()}
