"""Make ``data/thor.json`` from the databases of the PyPI package ``procthor`` (Apache-2.0).

Run ``python -m mansion_assets.catalogue.import_thor DATABASES OUT``, where DATABASES is the package's folder
``procthor/databases``. Only facts are kept: asset ids, bounding boxes and physical properties.
"""

import sys
from pathlib import Path
from typing import Any

import msgspec

__all__ = ["FLAGS", "convert", "main"]

FLAGS = {
    "CanPickup": "p",
    "Moveable": "m",
    "Static": "s",
    "ObjectSpecificReceptacle": "r",
    "Receptacle": "r",
    "CanOpen": "o",
    "CanToggleOnOff": "t",
    "CanBreak": "b",
    "CanBeFilled": "f",
    "CanBeDirty": "d",
    "CanBeSliced": "c",
    "CanBeCooked": "k",
    "CanBeUsedUp": "u",
    "isHeatSource": "h",
    "isColdSource": "x",
}
"""Letter of each AI2-THOR property in the compact table."""


def convert(database: dict[str, list[dict[str, Any]]]) -> dict[str, Any]:
    """Return the compact table: for each object type rows of ``[assetId, w, d, h, flags]``.

    AI2-THOR's boxes are (x, y, z) with y up and the front towards +z; width, depth and height are x, z and y.
    """
    types: dict[str, list[list[Any]]] = {}
    for kind in sorted(database):
        rows: list[list[Any]] = []
        for asset in database[kind]:
            box = asset["boundingBox"]
            names = [asset.get("primaryProperty", ""), *asset.get("secondaryProperties", [])]
            flags = "".join(sorted({FLAGS[name] for name in names if name in FLAGS}))
            size = [round(float(box[axis]), 4) for axis in ("x", "z", "y")]
            rows.append([asset["assetId"], *size, flags])
        types[kind] = sorted(rows)
    return {
        "source": "asset-database.json of the PyPI package procthor 0.0.1.dev2",
        "licence": "Apache-2.0",
        "flags": {letter: name for name, letter in FLAGS.items()},
        "types": types,
    }


def main(argv: list[str]) -> int:
    """Read ``DATABASES/asset-database.json`` and write OUT, one asset type on a line."""
    source, target = Path(argv[0]), Path(argv[1])
    table = convert(msgspec.json.decode((source / "asset-database.json").read_bytes()))
    types = table.pop("types")
    lines = [f"{msgspec.json.encode(k).decode()}: {msgspec.json.encode(v).decode()}" for k, v in types.items()]
    head = msgspec.json.encode(table).decode()[:-1]
    target.write_text(head + ',"types":{\n' + ",\n".join(lines) + "\n}}\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
