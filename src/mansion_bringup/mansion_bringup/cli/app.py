"""All commands in one place; each lives in the module of its kind."""

import typer

from mansion_bringup.cli import bench, build, edit, export, graph, look, plan, quality, schema, skill, solve, task

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

for module in (build, bench, plan, edit, export, graph, solve, schema, quality, skill, look, task):
    module.register(app)
