"""Every Python example of the pages runs, and every command, source file and link that they show exists.

An example that needs what no test machine has is preceded by ``<!-- not run: REASON -->``.
"""

import re
import shlex
from pathlib import Path
from typing import Any

import pytest
import typer.main

from mansion_bringup.cli.app import app
from mansion_knowledge.norms import load_norms

ROOT = Path(__file__).parents[2]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]
BLOCK = re.compile(r"(<!-- not run: [^>]+-->\s*)?```python\n(.*?)```", re.DOTALL)
COMMAND = re.compile(r"^\s*(?:\$ )?(?:\./)?mansion ((?!.*…)[a-z].*)$", re.MULTILINE)
USAGE_ERROR = typer.BadParameter.__base__
"""Of typer's own copy of click, or of click, which older ones import."""
SOURCE = re.compile(r"`((?:\w+/)*[a-z]\w*\.py)`|(?<![\w/.])((?:tests|benchmarks)/[\w/.-]*\w)")
SOURCES = {
    f"/{path.relative_to(ROOT)}"
    for folder in ("src", "tests", "benchmarks", "examples", "docs")
    for path in (ROOT / folder).rglob("*")
}
LINK = re.compile(r"\]\(([^)#:]+)(?:#[^)]*)?\)")


def examples() -> list[tuple[str, str]]:
    found = []
    for page in PAGES:
        code = [block for excuse, block in BLOCK.findall(page.read_text()) if not excuse]
        if code:
            found.append((page.name, "\n".join(code)))
    return found


def commands() -> list[tuple[str, str]]:
    return [
        (page.name, line.split("   #")[0].rstrip(" &\\"))
        for page in PAGES
        for line in COMMAND.findall(page.read_text())
    ]


@pytest.mark.parametrize(("page", "code"), examples(), ids=[name for name, _ in examples()])
def test_the_python_examples_of_a_page_run_in_order(page: str, code: str, workplace: Path) -> None:
    exec(compile(code, page, "exec"), {"__name__": "__main__"})


@pytest.mark.parametrize(("page", "line"), commands())
def test_a_command_that_a_page_shows_exists(page: str, line: str) -> None:
    words = shlex.split(line)
    command: Any = typer.main.get_command(app)
    context = typer.Context(command)
    while hasattr(command, "get_command"):
        name = words.pop(0)
        found = command.get_command(context, name)
        assert found is not None, f"{page}: there is no command {name!r} in: mansion {line}"
        command = found
    try:
        command.make_context(command.name, words)
    except (typer.BadParameter, typer.Exit):
        pass
    except USAGE_ERROR as error:
        pytest.fail(f"{page}: mansion {line}: {error.format_message()}")


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_lead_to_files(page: Path) -> None:
    missing = [target for target in LINK.findall(page.read_text()) if not (page.parent / target).exists()]
    assert missing == []


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_the_sources_that_a_page_names_exist(page: Path) -> None:
    named = {file or path for file, path in SOURCE.findall(page.read_text())} - {"tests/NAME"}
    missing = [name for name in sorted(named) if not any(path.endswith(f"/{name}") for path in SOURCES)]
    assert missing == []


def test_the_page_of_rules_has_every_rule_with_its_severity() -> None:
    page = (ROOT / "docs/norms.md").read_text(encoding="utf-8")
    rows = dict(re.findall(r"^\| `(\w+)`( \(advice\))? \|", page, re.MULTILINE))
    assert rows == {rule.id: " (advice)" * (rule.severity == "advice") for rule in load_norms().rules.values()}
