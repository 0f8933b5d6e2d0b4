"""``mansion record``: episodes and sessions of the graph as MCAP files, or as recordings for Rerun."""

import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from mansion_bringup.cli.console import AsJson, check_output_file, err, out, print_json
from mansion_bringup.extras import ensure_extra
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.interfaces import DEFAULT_NAMESPACE
from mansion_msgs_py.task import read_task_set
from mansion_msgs_py.wording import choices, counted

if TYPE_CHECKING:
    from mansion_tasks.episodes.log import EpisodeLog
    from mansion_tasks.recordings.episode import RecordedEpisode

__all__ = ["register"]

EXTRA, RERUN_EXTRA = "record", "rerun"

FOR_RERUN = ".rrd"
"""How the name of a file ends that is for Rerun; any other is an MCAP file."""

LOOK = 0.2
"""Seconds between looks for new topics."""

Output = Annotated[Path, typer.Option("--output", "-o", help="File to write: MCAP, or for Rerun if it ends in .rrd.")]
Pictures = Annotated[bool, typer.Option("--pictures", help="Also record the camera at each step.")]


def register(app: typer.Typer) -> None:
    """Add the command group to `app`."""
    group = typer.Typer(help="Record for Foxglove, ros2 bag and others, or for Rerun.", no_args_is_help=True)
    group.command("episode", no_args_is_help=True)(episode)
    group.command("task", no_args_is_help=True)(task)
    group.command("graph", no_args_is_help=True)(graph)
    app.add_typer(group, name="record")


def episode(
    log: Annotated[Path, typer.Argument(help="A log that `mansion bench agents` wrote.")],
    output: Output,
    building: Annotated[Path | None, typer.Option("--building", "-b", help="Where its building is now.")] = None,
    pictures: Pictures = False,
    as_json: AsJson = False,
) -> None:
    """Record a logged episode: its skills are run again in a copy of the building, on the world's clock.

    Examples:

      mansion record episode out/agents/episodes/oracle/office_tasks/deliver_1.jsonl -o deliver.mcap
    """
    from mansion_tasks.episodes.log import read_log

    _prepare(output, pictures=pictures)
    read = read_log(log)
    _record(read, building or Path(read.start.building), output, pictures=pictures, as_json=as_json)


def task(
    tasks: Annotated[Path, typer.Argument(help="A task set, as `mansion task generate` writes it.")],
    name: Annotated[str, typer.Argument(help="A task's id.")],
    output: Output,
    agent: Annotated[str, typer.Option("--agent", "-a", help="Who does it.")] = "oracle",
    seed: Annotated[int, typer.Option(min=0)] = 0,
    building: Annotated[Path | None, typer.Option("--building", "-b", help="Instead of the set's building.")] = None,
    pictures: Pictures = False,
    as_json: AsJson = False,
) -> None:
    """Let an agent do a task, and record it.

    Examples:

      mansion record task tasks.json search_s0_3 -o search.mcap

      mansion record task tasks.json search_s0_3 --agent explorer --pictures -o search.rrd
    """
    from mansion_tasks.agents.registry import make_agent
    from mansion_tasks.episodes.port import LocalPort
    from mansion_tasks.episodes.running import EpisodeOptions, run_episode

    _prepare(output, pictures=pictures)
    read = read_task_set(tasks)
    found = {each.id: each for each in read.tasks}
    if name not in found:
        raise MansionError(ErrorCode.NOT_FOUND, f"there is no task {name!r}; {choices(name, found, 'tasks')}")
    folder = building or tasks.parent / read.building
    options = EpisodeOptions(seed=seed, building=str(folder))
    log = run_episode(found[name], folder, make_agent(agent), LocalPort(), options)
    _record(log, folder, output, pictures=pictures, as_json=as_json)


def graph(
    output: Output,
    topics: Annotated[
        list[str] | None,
        typer.Option("--topic", "-t", help="Topic to record; may be repeated. All except images by default."),
    ] = None,
    seconds: Annotated[float, typer.Option(min=0, help="How long; 0: until Ctrl-C.")] = 0,
    namespace: Annotated[str, typer.Option("--namespace", "-n", help="Where the graph lives.")] = DEFAULT_NAMESPACE,
    building: Annotated[
        Path | None,
        typer.Option(
            "--building", "-b", help="For Rerun: the building to draw, if it is not built during the recording."
        ),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Record the topics of the running graph as they come.

    Examples:

      mansion record graph -o session.mcap

      mansion record graph -t robot_pose -t /map -t camera/image --seconds 60 -o minute.mcap

      mansion record graph --building /tmp/clinic -o session.rrd
    """
    from mansion_bringup.client import MansionClient

    _prepare(output, pictures=False)
    with MansionClient(namespace="/" + namespace.strip("/")) as client:
        from mansion_bringup.graph.recording import GraphRecording

        begun = time.monotonic()
        with _session_file(output, building) as file, GraphRecording(client, file, topics or ()) as recording:
            err.print(f"recording to {output}; Ctrl-C ends it", highlight=False)
            try:
                while not seconds or time.monotonic() - begun < seconds:
                    recording.look()
                    time.sleep(LOOK)
            except KeyboardInterrupt:
                err.print("ending the recording")
    for topic, why in recording.missing.items():
        err.print(f"left out {topic}: {why}", markup=False, highlight=False)
    _say(output, dict(sorted(recording.counts.items())), time.monotonic() - begun, as_json=as_json)


@contextmanager
def _session_file(output: Path, building: Path | None) -> Iterator[Path]:
    """Yield the MCAP file of a session: the output itself, or one that becomes the output in the end."""
    if output.suffix != FOR_RERUN:
        yield output
        return
    from mansion_bringup.rerun_files.session import convert_session, starting_world

    begun = None if building is None else starting_world(building)
    messages = output.with_suffix(".mcap")
    check_output_file(messages)
    try:
        yield messages
        err.print(f"writing {output}", highlight=False)
        convert_session(messages, output, begun)
    except BaseException:
        if messages.exists():
            err.print(f"the messages are kept in {messages}", markup=False, highlight=False)
        raise
    messages.unlink()


def _prepare(output: Path, *, pictures: bool) -> None:
    check_output_file(output)
    ensure_extra(EXTRA)
    if output.suffix == FOR_RERUN:
        ensure_extra(RERUN_EXTRA)
    if pictures:
        ensure_extra("sim")


def _record(log: "EpisodeLog", building: Path, output: Path, *, pictures: bool, as_json: bool) -> None:
    from mansion_tasks.episodes.port import LocalPort

    if output.suffix == FOR_RERUN:
        from mansion_bringup.rerun_files.episode import record_episode_for_rerun as write
    else:
        from mansion_tasks.recordings.episode import record_episode as write
    made: RecordedEpisode = write(log, building, LocalPort(), output, pictures=pictures)
    _say(output, made.messages, made.seconds, as_json=as_json)


def _say(output: Path, messages: dict[str, int], seconds: float, *, as_json: bool) -> None:
    if as_json:
        print_json({"file": str(output), "messages": messages, "seconds": round(seconds, 3)})
        return
    count = counted(sum(messages.values()), "message")
    out.print(f"{output}: {count} on {counted(len(messages), 'topic')}, {seconds:.1f} s", highlight=False)
