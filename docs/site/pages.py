"""Hooks of mkdocs: the pages of the Python reference, and links that leave ``docs/``.

The reference has a page for each package of ``src``, made from the docstrings of its modules. Files of the repository
that pages link to, and that are no pages, are laid beside the site.
"""

import ast
import posixpath
import re
from pathlib import Path
from typing import Any, Final

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files

__all__ = ["on_config", "on_files", "on_page_markdown"]

ROOT: Final = Path(__file__).resolve().parents[2]
REFERENCE: Final = "reference"
"""Stands in the navigation where the pages of the packages shall be, and is their folder."""

FILES: Final = "files"
"""Folder of the site with files of the repository."""

_LINK: Final = re.compile(r"\]\((?P<target>(?:\.\./)[^)#:\s]+)(?P<anchor>#[^)\s]*)?\)")


def _packages() -> list[str]:
    """Return the packages of the repository, the front door first."""
    return sorted(path.name for path in (ROOT / "src").iterdir() if (path / path.name).is_dir())


def _modules(package: str) -> list[str]:
    """Return the public modules at the top of a package, by their dotted names."""
    folder = ROOT / "src" / package / package
    names = [path.stem for path in sorted(folder.glob("*.py")) if not path.stem.startswith("_")]
    return [f"{package}.{name}" for name in names if _is_public(folder / f"{name}.py")]


def _is_public(module: Path) -> bool:
    """Whether a module says what it exports."""
    body = ast.parse(module.read_text(encoding="utf-8")).body
    return any(isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__all__" for node in body)


def on_config(config: MkDocsConfig) -> MkDocsConfig:
    """Put the pages of the reference into the navigation."""
    for section in config.nav or []:
        for entries in section.values():
            for entry in entries:
                if isinstance(entry, dict) and entry.get("Python") == REFERENCE:
                    entry["Python"] = [{name: f"{REFERENCE}/{name}.md"} for name in _packages()]
    return config


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Add the pages of the packages."""
    for package in _packages():
        blocks = [f"# {package}", f"::: {package}\n    options:\n      members: false\n      show_root_heading: false"]
        blocks += [f"::: {module}" for module in _modules(package)]
        files.append(File.generated(config, f"{REFERENCE}/{package}.md", content="\n\n".join(blocks) + "\n"))
    return files


def on_page_markdown(markdown: str, page: Any, config: MkDocsConfig, files: Files) -> str:
    """Lead links to files of the repository that are no pages to copies of them."""
    folder = posixpath.join("docs", posixpath.dirname(page.file.src_uri))

    def led(found: re.Match[str]) -> str:
        path = posixpath.normpath(posixpath.join(folder, found["target"]))
        if path.startswith("docs/"):
            return found[0]
        return f"]({_copied(path, page, config, files)})"

    return _LINK.sub(led, markdown)


def _copied(path: str, page: Any, config: MkDocsConfig, files: Files) -> str:
    """Lay a file, or the list of a folder, beside the site and return the link to it."""
    source = ROOT / path
    place = f"{FILES}/{path}" + (".txt" if source.suffix != ".txt" else "")
    if files.get_file_from_path(place) is None:
        listed = source.is_dir()
        content = "\n".join(sorted(each.name for each in source.iterdir())) if listed else source.read_text("utf-8")
        made = File.generated(config, place, content=content)
        files.append(made)
    return posixpath.relpath(place, posixpath.dirname(page.file.src_uri) or ".")
