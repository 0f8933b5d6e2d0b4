"""Look at the meshes of all assets: which are closed, how their textures are stretched, and which pieces stand out.

python benchmarks/catalogue/asset_meshes.py [--every]
"""

import argparse
from collections import Counter

import numpy as np

from mansion_assets.catalogue import Asset, load_catalogue
from mansion_assets.convex import Hull
from mansion_assets.meshes import Link, MeshPart, links
from mansion_geometry.compiled import Floats

MERGED = 5
"""Digits of metres in which vertices are one."""

SLACK = 0.03
"""Share of an asset's longest edge by which a piece may stand out of its part."""

PRINTED = 20


def is_closed(link: Link) -> bool:
    """Whether every edge of a rigid part is passed as often in one direction as in the other."""
    passed: Counter[tuple[bytes, bytes]] = Counter()
    for part in link.parts:
        points = [row.tobytes() for row in np.round(part.vertices, MERGED) + 0.0]
        for a, b, c in part.faces.tolist():
            for start, end in ((a, b), (b, c), (c, a)):
                passed[points[start], points[end]] += 1
    return all(passed[end, start] == count for (start, end), count in passed.items() if start != end)


def stretch(part: MeshPart) -> Floats:
    """Return for each face its area on the texture, metres, as a share of its true area."""
    corners = part.vertices[part.faces]
    true = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    u, v = part.coordinates[:, 1] - part.coordinates[:, 0], part.coordinates[:, 2] - part.coordinates[:, 0]
    drawn = np.abs(u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0])
    shares: Floats = drawn[true > 1e-9] / true[true > 1e-9]
    return shares


def stands_out(asset: Asset, link: Link) -> bool:
    """Whether a piece that collides reaches out of the box of its part by more than the slack."""
    if not link.parts:
        return False
    points = np.concatenate([part.vertices for part in link.parts])
    slack = SLACK * max(asset.size)
    low, high = points.min(axis=0) - slack, points.max(axis=0) + slack
    for piece in link.pieces:
        if isinstance(piece, Hull):
            first, last = piece.vertices.min(axis=0), piece.vertices.max(axis=0)
        else:
            middle, half = np.array(piece.center), np.array(piece.size) / 2
            first, last = middle - half, middle + half
        if (first < low).any() or (last > high).any():
            return True
    return False


def main() -> None:
    """Print how many assets are closed and which are not, the shares of faces by stretch, and pieces that stand out."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--every", action="store_true", help="all assets instead of one of each category")
    options = parser.parse_args()
    known = load_catalogue()
    assets = list(known.assets.values()) if options.every else [known.by_category(c)[0] for c in known.categories]
    rigid = {asset.key: links(asset) for asset in assets}
    opened = [asset.key for asset in assets if not all(map(is_closed, rigid[asset.key]))]
    out = [asset.key for asset in assets if any(stands_out(asset, link) for link in rigid[asset.key])]
    shares = np.concatenate([stretch(part) for found in rigid.values() for link in found for part in link.parts])
    joints = sum(link.joint is not None for found in rigid.values() for link in found)
    print(f"{len(assets)} assets, {joints} joints")
    print(f"not closed: {len(opened)} {', '.join(opened[:PRINTED])}")
    print(f"pieces that stand out of their part: {len(out)} {', '.join(out[:PRINTED])}")
    between = float(((shares > 0.57) & (shares < 1.01)).mean())
    print(f"faces whose area on the texture is 0.57 to 1.01 of the true one: {between:.2%} of {len(shares):,}")


if __name__ == "__main__":
    main()
