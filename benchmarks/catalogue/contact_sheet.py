"""Contact sheets of the catalogue's meshes: ``python benchmarks/catalogue/contact_sheet.py OUT [CATEGORY ...]``.

Each tile is one asset seen from the front, right and above, in its materials.
"""

import sys
from pathlib import Path

from mansion_assets.catalogue import load_catalogue
from mansion_export.pictures.asset_picture import contact_sheet

ON_A_SHEET = 64


def main(argv: list[str]) -> int:
    """Write sheets of 64 tiles; without categories, the first own or AI2-THOR asset of each."""
    out, names = Path(argv[0]), argv[1:]
    out.mkdir(parents=True, exist_ok=True)
    catalogue = load_catalogue()
    assets = [catalogue.by_category(name)[0] for name in names or catalogue.categories]
    for sheet, start in enumerate(range(0, len(assets), ON_A_SHEET)):
        picture = contact_sheet(assets[start : start + ON_A_SHEET], catalogue)
        (out / f"sheet_{sheet + 1:02}.png").write_bytes(picture)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
