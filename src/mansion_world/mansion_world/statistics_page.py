"""The statistics of a world as one HTML page with pictures of buildings."""

from collections.abc import Iterator, Sequence
from html import escape
from itertools import islice
from typing import Final

from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.wording import counted
from mansion_world.records import BuildingRow
from mansion_world.statistics import AGENTS, WorldStatistics
from mansion_world.world_folder import WorldFolder

__all__ = ["statistics_page"]

_PICTURES: Final = 60
"""Most pictures on the page: those of the first buildings."""

_STYLE: Final = """
body { font: 15px/1.5 system-ui, sans-serif; margin: 2rem auto; max-width: 70rem; padding: 0 1rem; color: #222 }
section { display: inline-block; vertical-align: top; margin: 0 2.5rem 1.5rem 0 }
h2 { font-size: 1.1rem; margin: .5rem 0 }
td { padding: .1rem 1rem .1rem 0; font-variant-numeric: tabular-nums }
.bar { position: relative; background: #eef1f4; width: 16rem; height: .8rem }
.bar i { position: absolute; inset: 0 auto 0 0; background: #4778a8 }
.bar b { position: absolute; top: -2px; bottom: -2px; width: 2px; background: #c0392b }
.wall { display: grid; grid-template-columns: repeat(auto-fill, minmax(13rem, 1fr)); gap: 1rem }
figure { margin: 0 } figure img { width: 100%; border: 1px solid #ddd } figcaption { font-size: .8rem; color: #555 }
"""


def statistics_page(world: WorldFolder, statistics: WorldStatistics) -> str:
    """Return the page; pictures are linked relative to the world's folder, where it belongs."""
    sections = [_section(statistics, title, rows) for title, rows in statistics.tables().items() if rows]
    pictures = "\n".join(_figure(world, row) for row in islice(_shown(world), _PICTURES))
    return (
        '<!doctype html>\n<html lang="en"><meta charset="utf-8">\n'
        f"<title>{escape(world.path.name)}</title>\n<style>{_STYLE}</style>\n"
        f"<h1>{escape(world.path.name)}: {statistics.buildings} buildings</h1>\n"
        + "\n".join(sections)
        + f'\n<h2>Buildings</h2>\n<div class="wall">\n{pictures}\n</div>\n</html>\n'
    )


def _section(statistics: WorldStatistics, title: str, rows: list[tuple[str, str]]) -> str:
    if title == "Mixture":
        return _mixture(statistics)
    if title == AGENTS:
        return _bars(title, rows, list(statistics.success().values()), whole=1.0)
    counts = statistics.distributions().get(title)
    return _bars(title, rows, list(counts.values())) if counts else _table(title, rows)


def _bars(title: str, rows: list[tuple[str, str]], counts: Sequence[float], whole: float = 0.0) -> str:
    """Return a bar for each row; a full one stands for `whole`, or else for the greatest count."""
    most = whole or max(counts) or 1
    body = "\n".join(
        f'<tr><td>{escape(name)}</td><td><div class="bar"><i style="width:{count / most:.1%}"></i></div></td>'
        f"<td>{escape(value)}</td></tr>"
        for (name, value), count in zip(rows, counts, strict=True)
    )
    return f"<section><h2>{escape(title)}</h2>\n<table>\n{body}\n</table></section>"


def _table(title: str, rows: list[tuple[str, str]]) -> str:
    body = "\n".join(f"<tr><td>{escape(name)}</td><td>{escape(value)}</td></tr>" for name, value in rows)
    return f"<section><h2>{escape(title)}</h2>\n<table>\n{body}\n</table></section>"


def _mixture(statistics: WorldStatistics) -> str:
    """Return a bar for each sub-kind: what is there in blue, what was asked as a red line."""
    most = max([*statistics.asked.values(), *(n / statistics.buildings for n in statistics.found.values())])
    rows = []
    for (name, value), (part, asked) in zip(statistics.tables()["Mixture"], statistics.asked.items(), strict=True):
        found = statistics.found[part] / statistics.buildings if statistics.buildings else 0.0
        bar = f'<i style="width:{found / most:.1%}"></i><b style="left:{asked / most:.1%}"></b>'
        rows.append(f'<tr><td>{escape(name)}</td><td><div class="bar">{bar}</div></td><td>{escape(value)}</td></tr>')
    return f"<section><h2>Mixture</h2>\n<table>\n{chr(10).join(rows)}\n</table></section>"


def _shown(world: WorldFolder) -> Iterator[BuildingRow]:
    return (row for row in world.buildings() if world.building(row.index).is_dir())


def _figure(world: WorldFolder, row: BuildingRow) -> str:
    picture = BuildingFolder(world.path / row.path).building.files.get("picture", "")
    source = escape(f"{row.path}/{picture}", quote=True)
    size = f"{counted(row.floors, 'floor')}, {counted(row.rooms, 'room')}"
    caption = f"{row.index}: {row.description} ({size}, {row.difficulty}, {row.split})"
    return f'<figure><img loading="lazy" src="{source}" alt=""><figcaption>{escape(caption)}</figcaption></figure>'
