"""Run the code of a notebook as its kernel would, cell by cell in one namespace, without a kernel."""

import ast
import json
from pathlib import Path
from typing import Any

__all__ = ["cells_of", "run_notebook"]


def cells_of(notebook: Path) -> list[dict[str, Any]]:
    """Return the cells of a notebook of format 4."""
    read = json.loads(notebook.read_text(encoding="utf-8"))
    assert read["nbformat"] == 4
    cells: list[dict[str, Any]] = read["cells"]
    return cells


def run_notebook(notebook: Path) -> tuple[dict[str, Any], list[str]]:
    """Run every code cell, and return the names that it leaves and how the last expression of each cell is shown."""
    space: dict[str, Any] = {"__name__": "__main__"}
    shown = []
    for cell in cells_of(notebook):
        if cell["cell_type"] != "code":
            continue
        tree = ast.parse("".join(cell["source"]), str(notebook))
        last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
        exec(compile(tree, f"{notebook.name}, {cell['id']}", "exec"), space)
        if last is not None:
            value = eval(compile(ast.Expression(last.value), f"{notebook.name}, {cell['id']}", "eval"), space)
            if value is not None:
                shown.append(_shown(value))
    return space, shown


def _shown(value: Any) -> str:
    """Return what a notebook would display: a picture or a table where the value has one."""
    for name in ("_repr_html_", "_repr_svg_"):
        if (method := getattr(value, name, None)) is not None and (found := method()):
            return str(found)
    return repr(value)
