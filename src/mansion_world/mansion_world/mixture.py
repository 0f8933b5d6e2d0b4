"""The mixture of a world: kinds of buildings with their shares, and what varies within a kind, as data."""

import tomllib
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Annotated, Final, Literal

import msgspec

from mansion_msgs_py.codec import convert
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import read_bytes
from mansion_msgs_py.program import Clutter

__all__ = ["MOST_FLOOR_AREA", "Kind", "Mixture", "SubKind", "load_clutter_sentences", "load_mixture", "load_sentences"]

MOST_FLOOR_AREA: Final = 500.0
"""Greatest area of a floor, m2 (section B.1 of the supplement)."""

Share = Annotated[float, msgspec.Meta(gt=0.0)]
FloorCount = Annotated[int, msgspec.Meta(ge=1, le=10)]
FloorArea = Annotated[float, msgspec.Meta(ge=20.0, le=MOST_FLOOR_AREA)]


class SubKind(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """What varies within a sub-kind.

    Attributes
    ----------
    share : float
        Share of the sub-kind in its kind; only ratios count.
    floors : tuple of int
        Fewest and most floors.
    tail : float
        How many times as likely each further floor is as the one before.
    floor_area : tuple of float
        Least and greatest gross area of a floor, m2.
    skew : float
        Skew of the area between the two: 1 is uniform, more leans to the small end.
    outlines, styles : dict of str to float
        Words with their shares; the empty word, or none at all, where the sentence says nothing.
    clutter : dict of {"", "sparse", "dense"} to float
        Shares of rooms with few and with many small objects; the empty word for the usual number.
    sentences : str
        Group of sentences; that of the sub-kind's name when empty.
    """

    share: Share
    floors: tuple[FloorCount, FloorCount]
    floor_area: tuple[FloorArea, FloorArea]
    tail: Share = 0.5
    skew: Share = 1.0
    outlines: dict[str, Share] = {}
    styles: dict[str, Share] = {}
    clutter: dict[Literal[""] | Clutter, Share] = {}
    sentences: str = ""

    def __post_init__(self) -> None:
        for name, (least, most) in (("floors", self.floors), ("floor_area", self.floor_area)):
            if least > most:
                raise ValueError(f"{name} {least} to {most}: the first may not be greater")


class Kind(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A kind of buildings with its share and its sub-kinds."""

    share: Share
    kinds: Annotated[dict[str, SubKind], msgspec.Meta(min_length=1)]


class Mixture(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Kinds of buildings by name."""

    kinds: Annotated[dict[str, Kind], msgspec.Meta(min_length=1)]

    def shares(self) -> dict[tuple[str, str], float]:
        """Return the share of each (kind, sub-kind) in the whole; they add up to 1."""
        whole = sum(kind.share for kind in self.kinds.values())
        shares = {}
        for name, kind in self.kinds.items():
            parts = sum(part.share for part in kind.kinds.values())
            for part_name, part in kind.kinds.items():
                shares[name, part_name] = kind.share / whole * part.share / parts
        return shares


def load_mixture(path: Path | None = None) -> Mixture:
    """Return the mixture in a TOML file, or MansionWorld's own.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` or ``INVALID_PAYLOAD``; both name the file.
    """
    data = read_bytes(path, "a TOML file of kinds") if path else _data("mix.toml")
    source = str(path or "mix.toml")
    try:
        mixture = convert(Mixture, tomllib.loads(data.decode()))
    except (tomllib.TOMLDecodeError, UnicodeError) as error:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{source} is not valid TOML: {error}") from None
    except MansionError as error:
        raise error.with_message(f"{source}: {error.info.message}") from None
    groups = load_sentences()
    for kind in mixture.kinds.values():
        for name, part in kind.kinds.items():
            if (part.sentences or name) not in groups:
                raise MansionError(
                    ErrorCode.INVALID_PAYLOAD,
                    f"{source}: no sentences for {part.sentences or name!r}; `sentences` may be {', '.join(groups)}",
                )
    return mixture


@cache
def load_sentences() -> dict[str, list[str]]:
    """Return the wordings of each group."""
    return convert(dict[str, list[str]], tomllib.loads(_data("sentences.toml").decode()))


@cache
def load_clutter_sentences() -> dict[str, list[str]]:
    """Return what may be added to a wording for ``dense`` and for ``sparse``."""
    return convert(dict[str, list[str]], tomllib.loads(_data("clutter.toml").decode()))


def _data(name: str) -> bytes:
    return (files("mansion_world") / "data" / name).read_bytes()
