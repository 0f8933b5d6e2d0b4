"""``mansion task``: make tasks for a building, read them, ground the paper's, and let the oracle do them."""

import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from rich.table import Table

from mansion_bringup.cli.console import err, out, print_json
from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import write_atomic
from mansion_msgs_py.task import Task, TaskKind, TaskSet

if TYPE_CHECKING:
    from mansion_skills.tasks.sandbox import Sandbox

__all__ = ["register"]

group = typer.Typer(no_args_is_help=True, help="Tasks for a robot in a building.")

Building = Annotated[Path, typer.Argument(help="Folder that `mansion build` wrote.")]
Output = Annotated[
    Path | None, typer.Option("--output", "-o", help="File to write; else standard output.")
]


def register(app: typer.Typer) -> None:
    """Add the commands to `app`."""
    app.add_typer(group, name="task")


def _task_set(file: Path) -> TaskSet:
    from mansion_skills.tasks.files import read_task_set

    return read_task_set(file)


def _sandbox(building: Path) -> "Sandbox":
    from mansion_skills.tasks.sandbox import Sandbox

    return Sandbox(building)


def _write(tasks: list[Task], building: Path, building_id: str, output: Path | None) -> None:
    """Write a task set whose building is named relative to its file."""
    base = Path.cwd() if output is None else output.resolve().parent
    folder = os.path.relpath(building.resolve(), base)
    made = TaskSet(building=folder, building_id=building_id, tasks=tasks)
    if output is None:
        print_json(made)
        return
    write_atomic(output, encode_bytes(made))
    err.print(f"{output}: {len(tasks)} tasks", highlight=False)


def _bytes(file: Path) -> bytes:
    try:
        return file.read_bytes()
    except OSError as error:
        raise MansionError(ErrorCode.NOT_FOUND, f"{file}: {error.strerror}") from None


def _chosen(tasks: list[Task], name: str) -> list[Task]:
    found = [task for task in tasks if name in ("", task.id)]
    if not found:
        known = ", ".join(task.id for task in tasks)
        raise MansionError(ErrorCode.NOT_FOUND, f"there is no task {name!r}; known are {known}")
    return found


@group.command(no_args_is_help=True)
def generate(
    building: Building,
    count: Annotated[int, typer.Option("--count", "-n", min=1, help="How many tasks.")] = 10,
    seed: Annotated[int, typer.Option(min=0)] = 0,
    kind: Annotated[TaskKind | None, typer.Option(help="Only tasks of this kind.")] = None,
    output: Output = None,
) -> None:
    """Make tasks for a building; each was done by the oracle.

    Examples:

      mansion task generate out/office -n 10 --seed 0 -o tasks.json

      mansion task generate out/office --kind search
    """
    from mansion_skills.tasks.generate import generate as make

    sandbox = _sandbox(building)
    tasks = make(sandbox, count, seed, kind)
    if len(tasks) < count:
        err.print(f"the building has no more than {len(tasks)} tasks that differ", highlight=False)
    _write(tasks, building, sandbox.building.building_id, output)


@group.command(no_args_is_help=True)
def show(
    tasks: Annotated[Path, typer.Argument(help="A task set, as `generate` writes it.")],
    name: Annotated[str, typer.Argument(help="A task's id: all of it, as JSON.")] = "",
) -> None:
    """List the tasks of a file, or print one.

    Examples:

      mansion task show tasks.json

      mansion task show tasks.json search_s0_3
    """
    read = _task_set(tasks)
    if name:
        print_json(_chosen(read.tasks, name)[0])
        return
    table = Table("id", "difficulty", "floors", "plan", "instruction", title=read.building_id)
    for task in read.tasks:
        figures = (str(task.floors_spanned), str(len(task.oracle)))
        table.add_row(task.id, task.difficulty.value, *figures, task.instruction)
    out.print(table)


@group.command()
def paper(
    name: Annotated[str, typer.Argument(help="A task's id; all are listed when absent.")] = "",
    output: Output = None,
) -> None:
    """List the paper's tasks with the sentence that builds a building for each, or print one in words.

    Examples:

      mansion task paper

      mansion task paper office_laptop -o laptop.json
    """
    from mansion_skills.tasks.paper import PAPER_TASKS, paper_task

    if not name:
        for entry in PAPER_TASKS.values():
            out.print(f"[bold]{entry.task.id}[/bold] ({entry.source})\n  {entry.task.instruction}")
            out.print(f'  mansion build "{entry.sentence}"', highlight=False)
        return
    task = paper_task(name).task
    if output is None:
        print_json(task)
    else:
        write_atomic(output, encode_bytes(task))


@group.command(no_args_is_help=True)
def ground(
    task: Annotated[str, typer.Argument(help="File of a task in words, or a paper task's id.")],
    building: Building,
    output: Output = None,
) -> None:
    """Find what a task names in a building; exit status 1 and what is missing where it lacks something.

    Examples:

      mansion task ground apartment_box out/apartment -o tasks.json

      mansion task ground laptop.json out/office
    """
    from mansion_skills.tasks.grounding import ground as find
    from mansion_skills.tasks.paper import PAPER_TASKS

    entry = PAPER_TASKS.get(task)
    words = decode(Task, _bytes(Path(task))) if entry is None else entry.task
    known = PAPER_TASKS.get(words.id)
    sandbox = _sandbox(building)
    made = find(words, sandbox, start_floor=None if known is None else known.start_floor)
    _write([made], building, made.building_id, output)


@group.command(no_args_is_help=True)
def run(
    tasks: Annotated[Path, typer.Argument(help="A task set.")],
    name: Annotated[str, typer.Argument(help="A task's id; all when absent.")] = "",
    building: Annotated[
        Path | None, typer.Option("--building", "-b", help="Instead of the set's building.")
    ] = None,
    plan: Annotated[bool, typer.Option(help="Run the plans of the file, else plan anew.")] = False,
) -> None:
    """Let the oracle do tasks in this process, and print how each went; exit status 1 when one fails.

    Examples:

      mansion task run tasks.json

      mansion task run tasks.json search_s0_3 --plan
    """
    from mansion_skills.tasks.solving import replay, solve

    read = _task_set(tasks)
    chosen = _chosen(read.tasks, name)
    sandbox = _sandbox(building or tasks.parent / read.building)
    failed = 0
    for task in chosen:
        solution = None if plan else solve(task, sandbox)
        steps = task.oracle if plan or solution is None else solution.plan
        score = replay(task, steps, sandbox)
        failed += not score.success
        word = "done" if score.success else "failed"
        out.print(
            f"{task.id}: {word}, {len(steps)} skills, {sandbox.world.time:.0f} s", highlight=False
        )
    if failed:
        raise typer.Exit(1)
