"""Commands are imported one module at a time, and the table of the modules says what they have."""

import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest
import typer
import typer.main

from mansion_bringup.cli import command_group
from mansion_bringup.cli.command_group import MODULES

CLI = Path(command_group.__file__).parent


@pytest.mark.parametrize("module", MODULES)
def test_the_table_names_the_commands_of_a_module(module: str) -> None:
    carrier = typer.Typer()
    import_module(f"mansion_bringup.cli.{module}").register(carrier)
    assert tuple(typer.main.get_group(carrier).commands) == MODULES[module]


def test_the_table_names_every_module_with_commands() -> None:
    registering = {path.stem for path in CLI.glob("*.py") if "\ndef register(app" in path.read_text()}
    assert registering == set(MODULES)


def test_a_command_imports_no_other_module_of_commands() -> None:
    script = (
        "import sys, typer.main; from mansion_bringup.cli.app import app; group = typer.main.get_command(app)\n"
        "assert group.get_command(None, 'schema').name == 'schema' and group.get_command(None, 'nothing') is None\n"
        f"print(*[name for name in {list(MODULES)} if 'mansion_bringup.cli.' + name in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=120)
    assert done.stdout.split() == ["schema"], done.stderr


def test_the_help_imports_no_numerical_library() -> None:
    script = (
        "import sys\n"
        "from typer.testing import CliRunner\n"
        "from mansion_bringup.cli.app import app\n"
        "assert CliRunner().invoke(app, ['--help']).exit_code == 0\n"
        "print(*[name for name in ('numpy', 'shapely', 'networkx', 'trimesh', 'numba') if name in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=120)
    assert (done.returncode, done.stdout.split()) == (0, []), done.stderr
