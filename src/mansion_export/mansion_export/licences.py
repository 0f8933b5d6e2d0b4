"""Licences of an exported building: the project's, stated once, and those of the user's assets."""

from collections.abc import Sequence
from typing import Final

from mansion_assets.catalogue import Asset, Catalogue, load_catalogue
from mansion_msgs_py.scene import FloorScene

__all__ = ["PROJECT", "licence_lines", "licence_records", "xml_notice"]

PROJECT: Final = "Building, textures and all furniture that is not listed: made with Mansion, Apache-2.0"
"""What holds for whatever does not come from a user's library."""

NOT_STATED: Final = "not stated"


def licence_records(scenes: Sequence[FloorScene], catalogue: Catalogue | None = None) -> list[dict[str, str]]:
    """Return key, licence, author and source of each of the user's assets that scenes show, by key; empty fields out.

    Parameters
    ----------
    catalogue : Catalogue, optional
        Where the assets are, when they are not all in the one at hand.
    """
    known = (catalogue or load_catalogue()).assets
    keys = sorted({item.asset for scene in scenes for item in scene.objects})
    return [_record(known[key]) for key in keys if key in known and known[key].record]


def _record(asset: Asset) -> dict[str, str]:
    said = {"author": asset.author, "source": asset.source, "sha256": asset.sha256}
    return {"asset": asset.key, "licence": asset.licence or NOT_STATED} | {k: v for k, v in said.items() if v}


def licence_lines(records: Sequence[dict[str, str]]) -> list[str]:
    """Return the project's line, and one for each record."""
    return [PROJECT, *(_line(record) for record in records)]


def _line(record: dict[str, str]) -> str:
    told = [f"licence {record['licence']}"]
    told += [f"by {record['author']}"] if "author" in record else []
    told += [f"from {record['source']}"] if "source" in record else []
    return f"{record['asset']}: {', '.join(told)}"


def xml_notice(records: Sequence[dict[str, str]]) -> str:
    """Return the lines as an XML comment of its own line; what a comment may not hold is written with spaces."""
    joined = " ".join("; ".join(licence_lines(records)).split())
    text = "".join(character for character in joined if character.isprintable())
    while "--" in text:
        text = text.replace("--", "- -")
    return f"<!-- {text} -->\n"
