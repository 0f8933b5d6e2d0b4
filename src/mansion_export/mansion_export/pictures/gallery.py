"""The same rooms from several systems side by side, unlabelled, for a study of people's preferences.

Each page shows one room; its panels, ``A``, ``B``, ..., are the systems in an order drawn for that page. The key, kept
apart from the pages, says which is which, and `tally` counts answers by system.
"""

import html
import io
import json
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import msgspec

from mansion_geometry.randomness import item_generator
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.placement import PlacementResult, PlacementRoom

if TYPE_CHECKING:
    from mansion_assets.catalogue import Catalogue

__all__ = ["QUESTIONS", "Answer", "GalleryKey", "GalleryPage", "gallery_files", "tally"]

QUESTIONS = {
    "realism": "Which room looks most like one that you could walk into? Are its things where people put them?",
    "diversity": "Whose rooms in a row differ most from each other, and still are rooms of this kind?",
    "layout": "Which room is best organised: clear structure, room to move, things that belong together close by?",
}
"""What each page asks."""

PANEL = (560, 420)
"""Width and height of one picture, pixels."""

_LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"


class GalleryPage(msgspec.Struct, frozen=True, kw_only=True):
    """One page: its picture, the room, and which system each panel shows."""

    page: str
    room_id: str
    panels: dict[str, str]


class GalleryKey(msgspec.Struct, frozen=True, kw_only=True):
    """What the pages do not say."""

    seed: int
    systems: list[str]
    pages: list[GalleryPage]


class Answer(msgspec.Struct, frozen=True, kw_only=True):
    """What a participant chose on a page: a panel's letter for each question."""

    page: str
    choices: dict[str, str]
    participant: str = ""


def gallery_files(
    rooms: Sequence[PlacementRoom],
    systems: Mapping[str, Sequence[PlacementResult]],
    *,
    seed: int = 0,
    runs: int = 2,
    catalogue: "Catalogue | None" = None,
) -> dict[str, bytes]:
    """Make the pages, the form that shows them, and the key.

    Parameters
    ----------
    rooms : sequence of PlacementRoom
    systems : mapping of str to sequence of PlacementResult
        Each system's results; several with one ``room_id`` are its runs of that room.
    seed : int
        Decides the order of panels and which runs are shown.
    runs : int
        Most runs of a room shown for each system; diversity is asked about where all show two or more.

    Returns
    -------
    dict of str to bytes
        ``page_01.png`` ..., ``form.html`` and ``key.json``.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for fewer than two systems or more than 26, or when no room has results of all systems.
    """
    if not 2 <= len(systems) <= len(_LETTERS):
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"{len(systems)} systems; a comparison takes 2 to {len(_LETTERS)}",
            path="$.systems",
        )
    files: dict[str, bytes] = {}
    key = GalleryKey(seed=seed, systems=sorted(systems), pages=[])
    asked: list[list[str]] = []
    for room in rooms:
        shown = {name: _runs_of(room, systems[name], runs, seed, name) for name in sorted(systems)}
        if not all(shown.values()):
            continue
        least = min(len(results) for results in shown.values())
        order = item_generator(seed, "gallery", room.room_id).permutation(len(shown))
        names = [sorted(systems)[i] for i in order.tolist()]
        page = f"page_{len(key.pages) + 1:02d}.png"
        panels = dict(zip(_LETTERS, names))
        key.pages.append(GalleryPage(page=page, room_id=room.room_id, panels=panels))
        asked.append([name for name in QUESTIONS if name != "diversity" or least > 1])
        files[page] = _page(room, [shown[name][:least] for name in names], catalogue)
    if not key.pages:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "no room has results of every system", path="$.systems")
    files["form.html"] = _form(key, rooms, asked).encode()
    files["key.json"] = msgspec.json.format(msgspec.json.encode(key), indent=1) + b"\n"
    return files


def tally(answers: Sequence[Answer], key: GalleryKey) -> dict[str, dict[str, float]]:
    """Return for each question the share of answers that chose each system.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for a page or a panel that the key does not have.
    """
    pages = {page.page: page.panels for page in key.pages}
    counts = {name: dict.fromkeys(key.systems, 0) for name in QUESTIONS}
    for number, answer in enumerate(answers):
        for question, letter in answer.choices.items():
            system = pages.get(answer.page, {}).get(letter)
            if system is None or question not in counts:
                raise MansionError(
                    ErrorCode.INVALID_PAYLOAD,
                    f"no panel {letter!r} for {question!r} on {answer.page!r}",
                    path=f"$[{number}]",
                )
            counts[question][system] += 1
    return {
        question: {name: count / max(1, sum(by_system.values())) for name, count in by_system.items()}
        for question, by_system in counts.items()
    }


def _runs_of(
    room: PlacementRoom, results: Sequence[PlacementResult], runs: int, seed: int, name: str
) -> list[PlacementResult]:
    """Draw the runs of a room that are shown, in the order in which the system gave them."""
    own = [result for result in results if result.room_id == room.room_id]
    count = min(len(own), max(1, runs))
    chosen = item_generator(seed, "runs", room.room_id, name).permutation(len(own))[:count]
    return [own[i] for i in sorted(chosen.tolist())]


def _page(room: PlacementRoom, panels: Sequence[Sequence[PlacementResult]], catalogue: "Catalogue | None") -> bytes:
    """Draw a page: a row for each system where it shows several runs, else the systems in one row."""
    with importing:
        from PIL import Image, ImageDraw

        from mansion_export.pictures.room_picture import room_picture
        from mansion_export.plan.raster import load_font

    several = max(len(results) for results in panels) > 1
    columns = max(len(results) for results in panels) if several else len(panels)
    rows = len(panels) if several else 1
    head = 44
    sheet = Image.new("RGB", (columns * PANEL[0], rows * (PANEL[1] + head)), "#ffffff")
    pen = ImageDraw.Draw(sheet)
    for number, results in enumerate(panels):
        for run, result in enumerate(results):
            column, row = (run, number) if several else (number, 0)
            x, y = column * PANEL[0], row * (PANEL[1] + head)
            picture = room_picture(room, result, PANEL, catalogue=catalogue)
            sheet.paste(picture, (x, y + head))
            if run == 0:
                pen.text((x + 16, y + 8), _LETTERS[number], font=load_font(26, bold=True), fill="#222222")
    buffer = io.BytesIO()
    sheet.save(buffer, format="PNG", compress_level=6)
    return buffer.getvalue()


def _form(key: GalleryKey, rooms: Sequence[PlacementRoom], asked: Sequence[Sequence[str]]) -> str:
    """Return a page for a browser: pictures, questions, and a button that saves the answers as JSON."""
    types = {room.room_id: room.room_type or room.room_id for room in rooms}
    parts = []
    for page, questions in zip(key.pages, asked):
        title = html.escape(types[page.room_id].replace("_", " ").capitalize())
        parts.append(f'<section data-page="{page.page}"><h2>{title}</h2><img src="{page.page}">')
        for question in questions:
            choices = "".join(
                f'<label><input type="radio" name="{page.page}.{question}" value="{letter}"> {letter}</label>'
                for letter in page.panels
            )
            text = html.escape(QUESTIONS[question])
            parts.append(f"<p><b>{question.capitalize()}.</b> {text}<br>{choices}</p>")
        parts.append("</section>")
    return _FORM.replace("{{sections}}", "\n".join(parts)).replace("{{questions}}", json.dumps(list(QUESTIONS)))


_FORM = """<!doctype html>
<html lang="en"><meta charset="utf-8"><title>Which room is better?</title>
<style>
body { font: 16px/1.5 sans-serif; max-width: 1200px; margin: 2em auto; color: #222; }
img { max-width: 100%; border: 1px solid #ddd; }
label { margin-right: 1.5em; }
</style>
<h1>Which room is better?</h1>
<p>Name: <input id="participant"></p>
{{sections}}
<button id="save">Save answers</button>
<script>
document.getElementById("save").onclick = () => {
  const participant = document.getElementById("participant").value;
  const answers = [...document.querySelectorAll("section")].map((section) => {
    const page = section.dataset.page, choices = {};
    for (const question of {{questions}}) {
      const chosen = section.querySelector(`input[name="${page}.${question}"]:checked`);
      if (chosen) choices[question] = chosen.value;
    }
    return { page, choices, participant };
  });
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([JSON.stringify(answers, null, 1)]));
  link.download = "answers.json";
  link.click();
};
</script>
</html>
"""
