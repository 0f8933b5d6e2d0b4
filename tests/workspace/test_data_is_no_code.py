"""Nothing that Mansion reads becomes code: no pickles, no evaluated text, no shell that gets a command as a text."""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

SOURCES = sorted((Path(__file__).parents[2] / "src").glob("*/*/**/*.py"))
MODULES = {"pickle", "cPickle", "dill", "cloudpickle", "marshal", "shelve", "joblib", "code", "imp"}
CALLS = {"eval", "exec", "compile", "__import__"}
ATTRIBUTES = {("os", "system"), ("os", "popen"), ("yaml", "load"), ("yaml", "unsafe_load"), ("np", "fromregex")}


def faults(tree: ast.AST) -> Iterator[str]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names if alias.name.partition(".")[0] in MODULES)
        elif isinstance(node, ast.ImportFrom) and (node.module or "").partition(".")[0] in MODULES and not node.level:
            yield str(node.module)
        elif isinstance(node, ast.Call):
            yield from called(node)


def called(node: ast.Call) -> Iterator[str]:
    if isinstance(node.func, ast.Name) and node.func.id in CALLS:
        yield node.func.id
    if isinstance(node.func, ast.Attribute) and isinstance(owner := node.func.value, ast.Name):
        yield from (f"{module}.{name}" for module, name in ATTRIBUTES if (module, name) == (owner.id, node.func.attr))
    for keyword in node.keywords:
        if keyword.arg in ("shell", "allow_pickle") and ast.unparse(keyword.value) == "True":
            yield f"{keyword.arg}=True"


def test_nothing_makes_code_of_data() -> None:
    found = {str(file): bad for file in SOURCES if (bad := [*faults(ast.parse(file.read_text(encoding="utf-8")))])}
    assert len(SOURCES) > 500 and found == {}


@pytest.mark.parametrize(
    "source", ["import pickle", "from marshal import loads", "eval('1')", "os.system('ls')", "run('ls', shell=True)"]
)
def test_such_code_is_found(source: str) -> None:
    assert list(faults(ast.parse(source)))
