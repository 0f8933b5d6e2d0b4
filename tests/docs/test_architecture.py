"""The pages about the whole are complete: every file of a package has its row, every page its link."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
ARCHITECTURE = (ROOT / "docs" / "architecture.md").read_text()
PACKAGES = sorted(path.name for path in (ROOT / "src").iterdir() if (path / path.name).is_dir())


def in_table(package: str) -> set[str]:
    """Return the files and folders that a package's section gives a row."""
    section = ARCHITECTURE.split(f"## {package}:")[1].split("\n## ")[0]
    rows = [row.split("|")[1] for row in section.splitlines() if row.startswith("| `")]
    return {name.rstrip("/") for row in rows for name in re.findall(r"`([^`]+)`", row)}


def on_disk(package: str) -> set[str]:
    """Return the modules and packages of a package."""
    folder = ROOT / "src" / package / package
    modules = {path.name for path in folder.glob("*.py")} - {"__init__.py"}
    return modules | {path.parent.name for path in folder.glob("*/__init__.py")}


@pytest.mark.parametrize("package", PACKAGES)
def test_every_file_and_folder_of_a_package_has_its_place_on_the_page(package: str) -> None:
    assert in_table(package) == on_disk(package)


def test_every_page_is_found_from_the_index() -> None:
    index = (ROOT / "docs" / "README.md").read_text()
    linked = set(re.findall(r"\]\((\w+\.md)\)", index))
    assert linked == {path.name for path in (ROOT / "docs").glob("*.md")} - {"README.md"}


def test_every_place_to_change_something_exists() -> None:
    section = ARCHITECTURE.split("## Where do I change")[1].split("\n## ")[0]
    rows = [line for line in section.splitlines() if line.startswith("| ") and "`" in line]
    places = [name for row in rows for name in re.findall(r"`(mansion_[^`]+)`", row)]
    assert len(rows) >= 15
    missing = [place for place in places if not (ROOT / "src" / place.split("/")[0] / place).exists()]
    assert missing == []
