"""All sets of textures on one sheet, each tile twice by twice: ``python benchmarks/catalogue/material_sheet.py OUT``.

Pictures, which do not repeat, are shown once. Grey ones are tinted by the materials that show them.
"""

import io
import sys

import numpy as np
from PIL import Image, ImageDraw

from mansion_assets.materials import material_set, set_names, texture_set

SIDE, LINE, COLUMNS = 116, 14, 10


def main(argv: list[str]) -> int:
    """Write the sheet and the figures of each set: texels a metre and bytes of its three pictures."""
    names = set_names()
    rows = -(-len(names) // COLUMNS)
    sheet = Image.new("RGB", (COLUMNS * SIDE, rows * (SIDE + LINE)), "white")
    pen = ImageDraw.Draw(sheet)
    total = 0
    for number, name in enumerate(names):
        chosen, made = material_set(name), texture_set(name)
        base = np.asarray(Image.open(io.BytesIO(made.base)).convert("RGB"))
        tile = base if chosen.fitted else np.tile(base, (2, 2, 1))
        x, y = number % COLUMNS * SIDE, number // COLUMNS * (SIDE + LINE)
        sheet.paste(Image.fromarray(tile).resize((SIDE - 4, SIDE - 4), Image.Resampling.LANCZOS), (x, y))
        pen.text((x + 2, y + SIDE - 4), name, fill="black")
        size = len(made.base) + len(made.normal) + len(made.surface)
        total += size
        print(f"{name:20} {chosen.density[0]:5.0f} x {chosen.density[1]:5.0f} texels/m {size:7} B")
    print(f"{len(names)} sets, {total} B")
    sheet.save(argv[0])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
