"""One self-contained HTML page with the 3D building; it loads nothing from anywhere."""

import base64
import gzip
import html
import json
from collections.abc import Sequence
from importlib import resources

from mansion_export.glb import building_glb
from mansion_msgs_py.scene import FloorScene

__all__ = ["page_files", "view_page"]

SCRIPTS = ("matrix.js", "scene.js", "renderer.js", "camera.js", "labels.js", "input.js", "main.js")


def view_page(building: bytes | Sequence[FloorScene], *, site: bool = True) -> str:
    """Make the page that ``mansion view`` writes.

    Parameters
    ----------
    building : bytes or sequence of FloorScene
        A building's ``building.glb``, or its floors.
    site : bool
        With the plot around the building, where its floors are given.

    Returns
    -------
    str
        An HTML document with the model inside (gzip, base64) and a viewer in plain JavaScript over WebGL 2: floors
        shown and hidden, spread and cut open, room names, what is pointed at.
    """
    glb = building if isinstance(building, bytes) else building_glb(building, site=site)
    parts = {
        "title": html.escape(_name(glb).replace("_", " ")),
        "style": _text("style.css"),
        "model": base64.b64encode(gzip.compress(glb, compresslevel=9, mtime=0)).decode(),
        "script": "\n".join(_text(name) for name in SCRIPTS),
    }
    page = _text("page.html")
    for key, value in parts.items():
        page = page.replace("{{" + key + "}}", value)
    return page


def page_files(scenes: Sequence[FloorScene], *, site: bool = True) -> dict[str, bytes]:
    """Return ``view.html`` by its path in the building's folder."""
    return {"view.html": view_page(scenes, site=site).encode()}


def _text(name: str) -> str:
    folder = resources.files("mansion_export").joinpath("data/viewer")
    return folder.joinpath(name).read_text(encoding="utf-8")


def _name(glb: bytes) -> str:
    """Return the title of the root node, or its name."""
    length = int.from_bytes(glb[12:16], "little")
    document = json.loads(glb[20 : 20 + length])
    root = document["nodes"][document["scenes"][0]["nodes"][0]]
    return str(root.get("extras", {}).get("title", root["name"]))
