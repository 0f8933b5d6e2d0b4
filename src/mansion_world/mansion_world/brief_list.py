"""Worlds from a list of briefs: a request for each brief, in order, and a table of what became of each."""

import csv
import io
import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import Final

import msgspec

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.request import BuildRequest, identified
from mansion_world.requests import Terms
from mansion_world.sampling import WorldRequest
from mansion_world.world_folder import WorldFolder, building_path

__all__ = ["BriefList", "NamedRequest", "Result", "results", "results_as_csv"]

_KIND: Final = "list"
_MOST_NAMED: Final = 3
_TERMS: Final = Terms(1, math.inf, distinct=False)


class NamedRequest(msgspec.Struct, frozen=True, kw_only=True):
    """A request of a list, with the name of its building's folder; named after what it asks for where empty."""

    request: BuildRequest
    name: str = ""


@dataclass(frozen=True)
class BriefList:
    """The requests of a list; each is tried once, and buildings may be alike and of any size.

    Attributes
    ----------
    entries : sequence of WorldRequest
        As `of` makes them.
    """

    entries: Sequence[WorldRequest]
    seed: int = 0
    origin: str = ""
    terms: Terms = _TERMS

    @classmethod
    def of(cls, named: Sequence[NamedRequest]) -> "BriefList":
        """Return the list of requests; those without a name are named after what they ask for.

        Examples
        --------
        >>> flat = NamedRequest(request=BuildRequest(description="A small flat", seed=3))
        >>> [entry.name for entry in BriefList.of([flat, flat]).entries]
        ['a-small-flat-0ebd0d5d', 'a-small-flat-0ebd0d5d-2']
        """
        taken = {entry.name for entry in named if entry.name}
        entries = []
        for index, entry in enumerate(named):
            entries.append(_entry(index, entry, taken))
            taken.add(entries[-1].name)
        return cls(entries)

    def __len__(self) -> int:
        return len(self.entries)

    def at(self, index: int, attempt: int = 0) -> WorldRequest:
        """Return the request of a line."""
        return self.entries[index]

    def prepare(self, world: WorldFolder) -> None:
        """Let buildings that are there follow their lines, which may have moved.

        Raises
        ------
        MansionError
            ``CONFLICT`` where the folder holds buildings that the list does not have.
        """
        indices = {building_path(entry.index, entry.name): entry.index for entry in self.entries}
        paths = [row.path for row in world.buildings() if (world.path / row.path).is_dir()]
        if strange := [path for path in paths if path not in indices]:
            named = ", ".join(strange[:_MOST_NAMED]) + (", ..." if len(strange) > _MOST_NAMED else "")
            raise MansionError(
                ErrorCode.CONFLICT,
                f"{world.path} holds buildings that the list does not have: {named}; "
                "remove their folders, or name another folder for this list",
            )
        world.move_records({path: indices[path] for path in paths})


def _entry(index: int, named: NamedRequest, taken: Collection[str]) -> WorldRequest:
    request = identified(named.request)
    name, number = named.name, 1
    while not name:
        again = f"-{number}" if number > 1 else ""
        name = "" if f"{request.building_id}{again}" in taken else f"{request.building_id}{again}"
        number += 1
    return WorldRequest(
        index=index, attempt=0, kind=_KIND, sub_kind=_KIND, wording="", outline="", style="", request=request, name=name
    )


class Result(msgspec.Struct, frozen=True, kw_only=True):
    """What became of a line.

    Attributes
    ----------
    path : str
        The building's folder, relative to that of the list; empty where there is none.
    wishes, wishes_met : int
        What the brief asks for, and how much of that the building meets.
    reason : str
        Why there is no building; empty where there is one.
    """

    name: str
    path: str = ""
    floors: int = 0
    rooms: int = 0
    objects: int = 0
    wishes: int = 0
    wishes_met: int = 0
    reason: str = ""


def results(world: WorldFolder, briefs: BriefList) -> list[Result]:
    """Return what became of each line of a list, in its order."""
    return [_result(world, entry) for entry in briefs.entries]


def _result(world: WorldFolder, entry: WorldRequest) -> Result:
    record = world.record(entry.index)
    if record is None:
        aside = world.set_aside_at(entry.index, entry.attempt)
        why = f"{aside.reason}: {'; '.join(aside.details)}" if aside else "not built yet"
        return Result(name=entry.name, reason=why)
    row = record.building
    return Result(
        name=entry.name,
        path=row.path,
        floors=row.floors,
        rooms=row.rooms,
        objects=row.objects,
        wishes=row.wishes,
        wishes_met=row.wishes_met,
    )


def results_as_csv(rows: Sequence[Result]) -> bytes:
    """Return the table as CSV with a heading."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(Result.__struct_fields__)
    writer.writerows(msgspec.structs.astuple(row) for row in rows)
    return text.getvalue().encode()
