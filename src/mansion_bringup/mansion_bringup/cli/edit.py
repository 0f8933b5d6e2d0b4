"""``mansion edit``: the scene editor's tools and its agent, on a building's folder."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from mansion_bringup.cli.console import BuildingArgument, err, print_json
from mansion_bringup.cli.request_options import Assets, library_names
from mansion_bringup.cli.text_argument import TextCommand
from mansion_bringup.extras import ensure_extra
from mansion_msgs_py.editing.instructions import AgentReport
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.task import read_tasks

if TYPE_CHECKING:
    from mansion_editing.editor import SceneEditor

__all__ = ["register"]

_WRITES = ("PlaceInContainer", "PlaceOnSurface", "MoveObject")
"""Tools that may need physics."""


def register(app: typer.Typer) -> None:
    """Add the command to `app`."""
    app.command("edit", cls=TextCommand, no_args_is_help=True)(edit)


def edit(
    building: BuildingArgument,
    what: Annotated[str, typer.Argument(help="An instruction, or the name of a tool.")] = "",
    arguments: Annotated[str | None, typer.Argument(help="The tool's arguments as JSON.")] = None,
    task: Annotated[Path | None, typer.Option(help="Make a task possible: its JSON, or a set of tasks.")] = None,
    task_id: Annotated[str, typer.Option("--id", help="Which task of a set; all when absent.")] = "",
    planner: Annotated[str, typer.Option(help="Who plans an instruction: rules or llm.")] = "rules",
    physics: Annotated[str, typer.Option(help="What settles objects: mujoco, static or thor.")] = "mujoco",
    who: Annotated[str, typer.Option(help="Name for the log; yours when absent.")] = "",
    assets: Assets = "",
    dry_run: Annotated[bool, typer.Option("--dry-run", help="Show what would change; change nothing.")] = False,
    partly: Annotated[
        bool, typer.Option("--partly", help="Carry out the part that is understood and possible.")
    ] = False,
    as_json: Annotated[bool, typer.Option("--json", help="The agent's report as JSON.")] = False,
) -> None:
    """Change what stands in a building, or ask about it; every change is checked before it lands, and can be undone.

    Examples:

      mansion edit out/office "make sure there is a cold cola in the fridge on the second floor"

      mansion edit out/office SearchContents '{"keyword": "fridge"}'

      mansion edit out/office PlaceOnSurface '{"asset_id": "cola_can_1", "receptacle_id": "F1/lobby/coffee_table_1"}'

      mansion edit out/office Undo

      mansion edit out/office --task tasks.json --id deliver_3
    """
    from mansion_bringup.editor import open_editor, write_derived
    from mansion_editing.editor import TOOLS

    if (task is None) == (not what):
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "give an instruction, a tool's name, or --task TASK.json")
    is_tool = what in TOOLS
    if arguments is not None and not is_tool:
        raise MansionError(ErrorCode.NOT_FOUND, f"there is no tool {what!r}; tools are {', '.join(TOOLS)}")
    settled = physics if not is_tool or what in _WRITES else "static"
    editor = open_editor(building, physics=settled, who=who, assets=library_names(assets))
    editor.autosave = not dry_run
    reports: list[AgentReport] = []
    if is_tool:
        print_json(editor.call(what, arguments or "{}"))
    elif task is not None:
        reports = _provision(editor, task, task_id)
    else:
        reports = [_instruct(editor, what, planner, partly=partly)]
    for report in reports:
        print_json(report) if as_json else _show(report)
    if not dry_run and (floors := write_derived(editor)):
        names = ", ".join(map(str, floors))
        err.print(f"updated the files of floor {names}", highlight=False)
    if not all(report.done for report in reports):
        raise typer.Exit(1)


def _instruct(editor: "SceneEditor", instruction: str, planner: str, *, partly: bool) -> AgentReport:
    from mansion_editing.instructions.instruct import instruct

    if planner == "llm":
        ensure_extra("llm")
    return instruct(editor, instruction, planner, partly=partly)


def _provision(editor: "SceneEditor", file: Path, task_id: str) -> list[AgentReport]:
    from mansion_editing.provisioning.provision import provision

    return [provision(editor, task) for task in read_tasks(file, task_id)]


def _show(report: AgentReport) -> None:
    for step in report.steps:
        observation: Any = step.observation
        error = observation.get("error") if isinstance(observation, dict) else None
        seen = error["message"] if error else observation.get("message", "")
        typer.echo(f"{step.thought}\n  {step.tool}: {str(seen)[:160]}")
    typer.echo(report.message)
    if report.saved:
        typer.echo(f"edit {report.transaction}: {', '.join(report.object_ids)}")
