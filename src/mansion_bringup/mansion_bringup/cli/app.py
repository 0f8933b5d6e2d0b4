"""All commands in one place; each lives in the module of its kind."""

from typing import Annotated

import typer

from mansion_bringup.about import about
from mansion_bringup.cli import (
    bench,
    build,
    edit,
    export,
    graph,
    look,
    plan,
    quality,
    schema,
    skill,
    solve,
    task,
    world,
)

__all__ = ["app"]

app = typer.Typer(
    name="mansion",
    help="One sentence in, a furnished multi-storey building out, and a robot that works in it through ROS 2.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode="rich",
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _print_version(wanted: bool) -> None:
    if wanted:
        for name, value in about().items():
            typer.echo(f"{name} {value}" if name == "mansion" else f"  {name:<11} {value}")
        raise typer.Exit


@app.callback()
def common(
    version: Annotated[
        bool,
        typer.Option("--version", "-V", callback=_print_version, is_eager=True, help="Say what is running, and end."),
    ] = False,
) -> None:
    """Take what every command has in common; the help of the whole is the text of `app`."""


for module in (build, bench, plan, edit, export, graph, solve, schema, quality, skill, look, task, world):
    module.register(app)
