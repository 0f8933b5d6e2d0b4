"""The gallery shows every building of a world from the world's own files."""

import json
import re
import shutil
from pathlib import Path

import msgspec
from typer.testing import CliRunner

from mansion_bringup.cli.app import app
from mansion_msgs_py.codec import encode_bytes
from mansion_world.gallery import gallery_page
from mansion_world.world_folder import WorldFolder


def cards(page: str) -> list[dict[str, object]]:
    found = re.search(r"^const buildings = (.*);$", page, re.MULTILINE)
    assert found is not None
    return list(json.loads(found[1]))


def test_each_building_has_a_picture_plans_and_what_it_is_filtered_by(small_world: Path, tmp_path: Path) -> None:
    world = WorldFolder(shutil.copytree(small_world, tmp_path / "world"))
    done = CliRunner().invoke(app, ["world", "show", str(world.path)])
    assert done.exit_code == 0 and "gallery.html" in done.stdout
    found = cards((world.path / "gallery.html").read_text())
    for card, record in zip(found, world.records(), strict=True):
        row = record.building
        assert (card["kind"], card["part"], card["split"], card["difficulty"], card["floors"]) == (
            row.kind,
            row.sub_kind,
            row.split,
            row.difficulty,
            row.floors,
        )
        pictures = [card["picture"], *card["plans"]]  # type: ignore[misc]
        assert len(pictures) == 1 + row.floors
        assert all((world.path / str(picture)).is_file() for picture in pictures)
        assert card["tasks"] == [task.instruction for task in record.tasks]


def test_the_page_uses_no_network(small_world: Path) -> None:
    assert "//" not in re.sub(r"^const buildings = .*$", "", gallery_page(WorldFolder(small_world)), flags=re.MULTILINE)


def test_a_sentence_cannot_end_the_script(small_world: Path, tmp_path: Path) -> None:
    world = WorldFolder(shutil.copytree(small_world, tmp_path / "a < b"))
    record = world.record(0)
    assert record is not None
    sentence = "A flat </script><script>alert(1)</script>"
    row = msgspec.structs.replace(record.building, description=sentence)
    file = world.path / "records/000/000000.json"
    file.write_bytes(encode_bytes(msgspec.structs.replace(record, building=row)))
    page = gallery_page(world)
    assert page.count("</script>") == 1 and cards(page)[0]["text"] == sentence
    assert "<title>a &lt; b</title>" in page
