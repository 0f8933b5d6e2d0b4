"""``mansion task``: make tasks for a building, read them, ground the paper's, and let the oracle do them."""

import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from rich.table import Table

from mansion_bringup.cli.console import AsJson, BuildingArgument, check_output_file, err, out, print_json
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import decode_from, read_bytes, write_atomic
from mansion_msgs_py.task import Task, TaskKind, TaskSet, read_task_set
from mansion_msgs_py.wording import choices, counted

if TYPE_CHECKING:
    from mansion_tasks.tasks.sandbox import Sandbox

__all__ = ["register"]

group = typer.Typer(no_args_is_help=True, help="Tasks for a robot in a building.")

Output = Annotated[Path | None, typer.Option("--output", "-o", help="File to write; else standard output.")]


def register(app: typer.Typer) -> None:
    """Add the commands to `app`."""
    app.add_typer(group, name="task")


def _sandbox(building: Path) -> "Sandbox":
    from mansion_tasks.tasks.sandbox import Sandbox

    return Sandbox(building)


def _set_sandbox(read: TaskSet, tasks: Path, building: Path | None) -> "Sandbox":
    """Return the world of a task set's building, or of the one that is named instead."""
    try:
        sandbox = _sandbox(building or tasks.parent / read.building)
    except MansionError as error:
        if building is None and error.code == ErrorCode.NOT_FOUND:
            advice = f"{tasks} names it, --building DIR names where it is now"
            raise error.with_message(f"{error.info.message}; {advice}") from None
        raise
    _check_building(read, tasks, sandbox)
    return sandbox


def _write(tasks: list[Task], building: Path, building_id: str, output: Path | None) -> None:
    """Write a task set whose building is named relative to its file."""
    base = Path.cwd() if output is None else output.resolve().parent
    folder = os.path.relpath(building.resolve(), base)
    made = TaskSet(building=folder, building_id=building_id, tasks=tasks)
    if output is None:
        print_json(made)
        return
    write_atomic(output, encode_bytes(made))
    err.print(f"{output}: {counted(len(tasks), 'task')}", highlight=False)


def _check_output(output: Path | None) -> None:
    if output is not None:
        check_output_file(output)


def _chosen(tasks: list[Task], name: str) -> list[Task]:
    found = [task for task in tasks if name in ("", task.id)]
    if not found:
        known = choices(name, (task.id for task in tasks), "tasks")
        raise MansionError(ErrorCode.NOT_FOUND, f"there is no task {name!r}; {known}")
    return found


def _in_words(name: str) -> Task:
    """Return the paper's task of that id, or the task that a file holds."""
    from mansion_tasks.tasks.paper_tasks import PAPER_TASKS

    if name in PAPER_TASKS:
        return PAPER_TASKS[name].task
    file = Path(name)
    if not file.is_file():
        known = choices(name, PAPER_TASKS, "the paper's tasks")
        raise MansionError(ErrorCode.NOT_FOUND, f"{name!r} is neither a file nor a task of the paper; {known}")
    data = read_bytes(file)
    if "tasks" in decode_from(dict[str, Any], data, file):
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"{file} is a set of tasks that are already grounded: `mansion task run {file}` does them; "
            "`mansion task ground` takes one task in words, as `mansion task paper NAME -o FILE` writes it",
        )
    return decode_from(Task, data, file)


def _advised(error: MansionError, name: str, building: Path) -> MansionError:
    """Say how the building, or another one, can have what a task lacks: objects can be added, rooms cannot."""
    from mansion_tasks.tasks.paper_tasks import PAPER_TASKS

    missing = error.info.details.get("missing", [])
    if not missing:
        return error
    entry = PAPER_TASKS.get(name)
    if all(need["noun"] for need in missing):
        file = f"{name}.json" if entry else name
        first = f"mansion task paper {name} -o {file} && " if entry else ""
        advice = f"`{first}mansion edit {building} --task {file}` adds what can be added"
    elif entry:
        advice = f'a building that has it: `mansion build "{entry.sentence}" -o DIR`'
    else:
        advice = "rooms and floors cannot be added: ground it in another building"
    return error.with_message(f"{error.info.message}; {advice}")


def _check_building(read: TaskSet, tasks: Path, sandbox: "Sandbox") -> None:
    """Refuse a set of tasks of another building."""
    found = sandbox.building
    if read.building_id and read.building_id != found.building_id:
        raise MansionError(
            ErrorCode.CONFLICT,
            f"the tasks of {tasks} are for building {read.building_id!r}, {found.path} is {found.building_id!r}; "
            f"`mansion task generate {found.path}` makes tasks for it",
            path="$.building_id",
        )


@group.command(no_args_is_help=True)
def generate(
    building: BuildingArgument,
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
    from mansion_tasks.tasks.generate import generate as make

    _check_output(output)
    sandbox = _sandbox(building)
    tasks = make(sandbox, count, seed, kind)
    if len(tasks) < count:
        found = counted(len(tasks), "task")
        err.print(f"the building has only {found} without repeating one", highlight=False)
    _write(tasks, building, sandbox.building.building_id, output)


@group.command(no_args_is_help=True)
def show(
    tasks: Annotated[Path, typer.Argument(help="A task set, as `generate` writes it.")],
    name: Annotated[str, typer.Argument(help="A task's id: print that task in full, as JSON.")] = "",
    as_json: AsJson = False,
) -> None:
    """List the tasks of a file, or print one.

    Examples:

      mansion task show tasks.json

      mansion task show tasks.json search_s0_3
    """
    read = read_task_set(tasks)
    if name:
        print_json(_chosen(read.tasks, name)[0])
        return
    if as_json:
        print_json(read)
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
    as_json: AsJson = False,
) -> None:
    """List the paper's tasks with the sentence that builds a building for each, or print one in words.

    Examples:

      mansion task paper

      mansion task paper office_laptop -o laptop.json
    """
    from mansion_tasks.tasks.paper_tasks import PAPER_TASKS, paper_task

    if not name and as_json:
        print_json([{"task": entry.task, "sentence": entry.sentence} for entry in PAPER_TASKS.values()])
        return
    if not name:
        for entry in PAPER_TASKS.values():
            out.print(f"[bold]{entry.task.id}[/bold] ({entry.source})\n  {entry.task.instruction}")
            out.print(f'  mansion build "{entry.sentence}"', highlight=False)
        return
    _check_output(output)
    task = paper_task(name).task
    if output is None:
        print_json(task)
    else:
        write_atomic(output, encode_bytes(task))


@group.command(no_args_is_help=True)
def ground(
    task: Annotated[str, typer.Argument(help="File of a task in words, or a paper task's id.")],
    building: BuildingArgument,
    output: Output = None,
) -> None:
    """Find what a task names in a building; exit status 2 and what is missing where it lacks something.

    Examples:

      mansion task ground apartment_box out/apartment -o tasks.json

      mansion task ground laptop.json out/office
    """
    from mansion_tasks.tasks.grounding import ground as find
    from mansion_tasks.tasks.paper_tasks import PAPER_TASKS

    _check_output(output)
    words = _in_words(task)
    known = PAPER_TASKS.get(words.id)
    sandbox = _sandbox(building)
    try:
        made = find(words, sandbox, start_floor=None if known is None else known.start_floor)
    except MansionError as error:
        raise _advised(error, task, building) from None
    _write([made], building, made.building_id, output)


@group.command(no_args_is_help=True)
def run(
    tasks: Annotated[Path, typer.Argument(help="A task set.")],
    name: Annotated[str, typer.Argument(help="A task's id; all when absent.")] = "",
    building: Annotated[Path | None, typer.Option("--building", "-b", help="Instead of the set's building.")] = None,
    plan: Annotated[bool, typer.Option(help="Run the file's plans instead of planning again.")] = False,
    as_json: AsJson = False,
) -> None:
    """Let the oracle do tasks in this process, and print how each went; exit status 1 when one fails.

    Examples:

      mansion task run tasks.json

      mansion task run tasks.json search_s0_3 --plan
    """
    from mansion_tasks.tasks.solving import replay, solve

    read = read_task_set(tasks)
    chosen = _chosen(read.tasks, name)
    sandbox = _set_sandbox(read, tasks, building)
    rows: list[dict[str, Any]] = []
    for task in chosen:
        solution = None if plan else solve(task, sandbox)
        steps = task.oracle if plan or solution is None else solution.plan
        score = replay(task, steps, sandbox)
        rows.append({"task": task.id, "success": score.success, "skills": len(steps), "time": sandbox.world.time})
        word = "done" if score.success else "failed"
        if not as_json:
            out.print(f"{task.id}: {word}, {counted(len(steps), 'skill')}, {sandbox.world.time:.0f} s", highlight=False)
    if as_json:
        print_json(rows)
    if not all(row["success"] for row in rows):
        raise typer.Exit(1)
