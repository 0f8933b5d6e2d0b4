"""``mansion bench agents``: agents at tasks, as a table, logs and pictures."""

import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from msgspec.structs import replace

from mansion_bringup.cli.console import EXIT_INTERRUPTED, AsJson, check_output_folder, err, print_json, progress_bar
from mansion_bringup.extras import ensure_extra
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.wording import counted
from mansion_msgs_py.world import Progress

if TYPE_CHECKING:
    from mansion_tasks.episodes.bench import Bench, Ports
    from mansion_tasks.episodes.results import BenchResult

__all__ = ["agents", "chosen_agents", "follow_bench", "provide_for_agents"]


def agents(
    tasks: Annotated[
        list[Path] | None, typer.Option("--tasks", "-t", help="Task set, or a folder of them; may be repeated.")
    ] = None,
    names: Annotated[
        str, typer.Option("--agents", "-a", help="Names with commas between them.")
    ] = "random,oracle,explorer",
    output: Annotated[Path | None, typer.Option("--output", "-o", help="Folder of logs and results.")] = None,
    seed: Annotated[int, typer.Option(min=0)] = 0,
    jobs: Annotated[int, typer.Option(min=0, help="Processes, 0: all cores; the result is the same.")] = 1,
    graph: Annotated[bool, typer.Option(help="Call skills over services of a node graph.")] = False,
    sheets: Annotated[
        int, typer.Option(min=0, help="Number of episodes of each agent to draw as contact sheets and animations.")
    ] = 0,
    replay: Annotated[Path | None, typer.Option(help="Repeat the episode of a log instead, and compare.")] = None,
    building: Annotated[Path | None, typer.Option(help="With --replay: the building, where it has moved.")] = None,
    as_json: AsJson = False,
) -> None:
    """Let agents do tasks and print success and progress per number of floors, with 95% intervals.

    Agents: random, oracle, explorer; with a language model (MANSION_LLM_...) bumble, bumble_text, come. An interrupted
    run continues where it ended: finished episodes are read from their logs.

    Examples:

      mansion bench agents --tasks out/tasks --agents random,oracle,explorer -o out/agents --jobs 2

      mansion bench agents --replay out/agents/episodes/oracle/office_tasks/deliver_1.jsonl
    """
    if replay is not None:
        _repeat(replay, building, output, graph=graph, as_json=as_json)
        return
    if not tasks or output is None:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "--tasks and --output are needed (or --replay LOG)")
    workers = jobs or os.cpu_count() or 1
    _run(tasks, names, output, seed=seed, jobs=workers, graph=graph, sheets=sheets, as_json=as_json)


def _run(
    tasks: list[Path], names: str, output: Path, *, seed: int, jobs: int, graph: bool, sheets: int, as_json: bool
) -> None:
    """Run the bench, print its table, and draw what was asked for."""
    from mansion_tasks.episodes.bench import Bench, local_port
    from mansion_tasks.episodes.results import render

    chosen = chosen_agents(names)
    bench = Bench(
        files=tuple(_task_files(tasks)),
        agents=chosen,
        output=output,
        seed=seed,
        ports=_graph_port() if graph else local_port,
        graph=graph,
    )
    check_output_folder(output)
    provide_for_agents(chosen, sheets)
    result, taken_over = follow_bench(bench, jobs)
    print_json(result) if as_json else typer.echo(render(result.summary))
    seen: dict[str, int] = {}
    for row in result.episodes:
        seen[row.agent] = seen.get(row.agent, 0) + 1
        if seen[row.agent] <= sheets:
            _picture(output / row.log, output)
    earlier = f", {taken_over} of them taken over from an earlier run" if taken_over else ""
    episodes = counted(len(result.episodes), "episode")
    err.print(f"{output / 'results.json'}: {episodes}{earlier}", highlight=False)


def chosen_agents(names: str) -> tuple[str, ...]:
    """Return the agents of an option; ``INVALID_PAYLOAD`` where it names none or one that there is not."""
    from mansion_tasks.agents.registry import AGENTS, check_agents

    chosen = tuple(name.strip() for name in names.split(",") if name.strip())
    if not chosen:
        known = ", ".join(AGENTS)
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"--agents names no agent; agents are {known}")
    check_agents(list(chosen))
    return chosen


def provide_for_agents(names: tuple[str, ...], sheets: int = 0) -> None:
    """Install what agents and pictures need; a model that is not configured is complained of when it is asked."""
    from mansion_llm import load_settings
    from mansion_tasks.agents.registry import ASKING

    asking = [name for name in names if name in ASKING]
    settings = load_settings() if asking else None
    if settings is not None and settings.base_url and settings.replay is None:
        ensure_extra("llm")
    if settings is not None and (settings.base_url or settings.replay):
        ensure_extra("sim")
    if sheets:
        try:
            ensure_extra("sim")
        except MansionError as error:
            err.print(f"the sheets show the plan alone: {error}", highlight=False)


def follow_bench(bench: "Bench", jobs: int) -> tuple["BenchResult", int]:
    """Run the bench and show its progress; return its result and how many episodes an earlier run had done."""
    from mansion_tasks.episodes.bench import TAKEN_OVER, run_bench

    taken_over, last = 0, Progress(stage="bench", message="", done=0, total=0)
    try:
        with progress_bar() as report:

            def show(payload: Progress) -> None:
                nonlocal taken_over, last
                last = payload
                if payload.stage == TAKEN_OVER:
                    taken_over += 1
                    payload = replace(payload, message=f"{payload.message} (of an earlier run)")
                report(payload)

            return run_bench(bench, jobs=jobs, progress=show), taken_over
    except KeyboardInterrupt:
        done = f"{last.done} of {last.total}" if last.total else "none of the"
        err.print(
            f"interrupted: {done} episodes are done; repeat the command to continue from the logs in {bench.output}",
            highlight=False,
        )
        raise typer.Exit(EXIT_INTERRUPTED) from None


def _graph_port() -> "Ports":
    """Return what starts a private skill server; rclpy is imported where it is used."""
    from mansion_bringup.graph.skill_port import graph_port

    return graph_port


def _task_files(given: list[Path]) -> list[Path]:
    """Return the task sets: files as given, and those of folders by name."""
    files = [file for path in given for file in (sorted(path.glob("*.json")) if path.is_dir() else [path])]
    if not files:
        raise MansionError(ErrorCode.NOT_FOUND, f"no *.json in {', '.join(map(str, given))}")
    return files


def _repeat(log_file: Path, building: Path | None, output: Path | None, *, graph: bool, as_json: bool) -> None:
    """Run a log's skills again; exit status 1 when something else comes of them."""
    from mansion_tasks.episodes.bench import local_port
    from mansion_tasks.episodes.log import read_log
    from mansion_tasks.episodes.replaying import replay

    log = read_log(log_file)
    folder = building or Path(log.start.building)
    with (_graph_port() if graph else local_port)() as port:
        differences = replay(log, folder, port)
    same = (
        f"the same: {len(log.steps)} skills, success {log.end.success}, retrieval {log.end.retrieval:g}, "
        f"navigation {log.end.navigation:g}"
    )
    if as_json:
        print_json({"differences": differences, "end": log.end})
    else:
        typer.echo("\n".join(differences or [same]))
    if differences:
        raise typer.Exit(1)
    if output is not None:
        _picture(log_file, output, folder)


def _picture(log_file: Path, output: Path, building: Path | None = None) -> None:
    """Write the contact sheet and the animation of an episode beside each other."""
    from mansion_tasks.episodes.contact_sheet import episode_frames, write_contact_sheet, write_gif
    from mansion_tasks.episodes.log import read_log
    from mansion_tasks.episodes.port import LocalPort

    log = read_log(log_file)
    frames = episode_frames(log, building or Path(log.start.building), LocalPort())
    stem = f"{log.start.agent}_{log.start.building_id}_{log.start.task.id}"
    write_contact_sheet(output / "sheets" / f"{stem}.png", log, frames)
    write_gif(output / "sheets" / f"{stem}.gif", frames)
    err.print(f"{output / 'sheets' / stem}.png", highlight=False)
