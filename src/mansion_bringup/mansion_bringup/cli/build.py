"""``mansion build``: one sentence to a building folder."""

import os
import shlex
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Final

import typer

from mansion_bringup.building.workspace import require_free_target
from mansion_bringup.cli.build_list import build_briefs
from mansion_bringup.cli.console import (
    EXIT_INTERRUPTED,
    AsJson,
    complaints,
    details,
    err,
    out,
    print_json,
    progress_bar,
)
from mansion_bringup.cli.receipt_table import print_own_assets, print_plan_notes, print_receipt, refuse_unmet
from mansion_bringup.cli.request_options import (
    Area,
    Assets,
    Complete,
    FloorArea,
    Floors,
    FootprintFile,
    Layers,
    PlanFile,
    Planner,
    given_plan,
    planner_name,
    request_from_options,
)
from mansion_bringup.cli.text_argument import TextCommand
from mansion_bringup.exporting import format_names
from mansion_export.formats import ALL, export_formats, formats_of_build
from mansion_msgs_py.building import Building, BuildingReport
from mansion_msgs_py.building_folder import is_building_folder
from mansion_msgs_py.codec import decode, to_builtins
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.wording import counted

if TYPE_CHECKING:
    from mansion_bringup.pipeline.build import BuildResult

__all__ = ["register"]

FORMATS_HELP: Final = f"What to write besides plans and a picture: {ALL}, or some of {', '.join(export_formats())}."


def register(app: typer.Typer) -> None:
    """Add the command to `app`."""
    app.command("build", cls=TextCommand, no_args_is_help=True)(build)


def build(
    output: Annotated[Path, typer.Option("--output", "-o", help="Folder to write.")],
    description: Annotated[
        str | None, typer.Argument(help="The brief: English, or any language with --planner llm.")
    ] = None,
    briefs: Annotated[
        Path | None,
        typer.Option(
            "--from", help="Many briefs: a .txt file with one per line, a .csv or a .jsonl; other options fill gaps."
        ),
    ] = None,
    floors: Floors = None,
    area: Area = None,
    floor_area: FloorArea = None,
    footprint: FootprintFile = None,
    plan: PlanFile = None,
    complete: Complete = "",
    layers: Layers = "",
    seed: Annotated[int, typer.Option(min=0, help="Same seed, same building.")] = 0,
    planner: Planner = "rules",
    assets: Assets = "",
    formats: Annotated[str, typer.Option(help=FORMATS_HELP)] = "",
    graph: Annotated[bool, typer.Option("--graph", help="Build through the node graph.")] = False,
    jobs: Annotated[int, typer.Option(min=0, help="Floors built at once, or buildings with --from; 0: all cores.")] = 0,
    timeout: Annotated[float, typer.Option(min=1, help="Seconds, for --graph.")] = 900.0,
    strict: Annotated[
        bool, typer.Option("--strict", help="Refuse a building that does not fully meet every wish.")
    ] = False,
    force: Annotated[
        bool, typer.Option("--force", help="Replace a building even if it was edited or robots left state in it.")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Build a furnished building from one sentence, or one from each line of a file.

    The folder appears whole or not at all; an interrupted build continues where it stopped when run again. It holds the
    floors, their plans and a picture; maps and models come with --formats, or later from `mansion export`.

    Examples:

      mansion build "A four-storey office with a cafeteria on the ground floor" -o out/office

      mansion build "a small flat for two" --seed 7 -o out/flat

      mansion build "a library" --floors 3 --floor-area 400 --graph -o out/library

      mansion build "a clinic" --formats mjcf,nav2 -o out/clinic

      mansion build "a cafe with an espresso bar" --assets shop -o out/cafe      (docs/tutorial_assets.md)

      mansion build --plan house.json --complete windows -o out/house      (docs/plans.md)

      mansion build --from briefs.csv --jobs 2 -o out/many     (columns: brief, and name, seed, floors, floor_area, ...)
    """
    if briefs is not None:
        beside = {"--graph": graph, "--strict": strict, "--force": force, "--plan": plan is not None}
        _refuse_beside_a_list(description, beside)
    given = given_plan(plan, complete, layers) if briefs is None else None
    if description is None and given is None and briefs is None:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD, "there is no brief; give a sentence, a plan with --plan, or a file with --from"
        )
    request = request_from_options(
        description or "", floors, area, floor_area, footprint, seed, planner_name(planner), given, assets
    )
    names = _prepared_formats(formats)
    if briefs is not None:
        build_briefs(briefs, output, request, jobs, names)
        return
    require_free_target(output.absolute(), force=force)
    if strict:
        _refuse_unmet_plan(request)
    if is_building_folder(output):
        err.print(f"{output} holds a building, which will be replaced when this one is finished")
    try:
        if graph:
            result = _through_graph(request, output, timeout, names, force=force)
        else:
            result = _in_processes(request, output, jobs, names, force=force)
    except KeyboardInterrupt:
        err.print("interrupted; run the same command again to continue with the remaining floors")
        raise typer.Exit(EXIT_INTERRUPTED) from None
    _report(result, as_json=as_json)
    if strict:
        refuse_unmet(result.building.wishes)
    _refuse_faults(result)
    if not as_json:
        _suggest_next_steps(output)


def _report(result: "BuildResult", *, as_json: bool) -> None:
    """Print what was built, and with ``--verbose`` how long each stage took."""
    if as_json:
        print_json({"path": str(result.path), **to_builtins(result.report)})
    else:
        _print_summary(result)
    for stage, seconds in result.report.seconds.items():
        details.print(f"{stage}: {seconds:.2f} s", markup=False, highlight=False)


def _suggest_next_steps(output: Path) -> None:
    """Name a few commands that take the finished building further."""
    folder = shlex.quote(str(output))
    steps = {
        f"mansion view {folder} --open": "look at it in 3D",
        f'mansion edit {folder} "put a red mug on a table"': "change it",
        f"mansion export {folder} --to usd": "take it to another program",
    }
    width = max(map(len, steps))
    for number, (command, purpose) in enumerate(steps.items()):
        lead = "next: " if number == 0 else "      "
        err.print(f"{lead}{command:<{width}}  # {purpose}", markup=False, highlight=False)


def _refuse_beside_a_list(description: str | None, options: Mapping[str, bool]) -> None:
    beside = ["the brief"] if description is not None else []
    beside += [name for name, given in options.items() if given]
    if beside:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"--from takes all briefs from its file; leave out {beside[0]}")


def _refuse_faults(result: "BuildResult") -> None:
    """Name the faults of a building that does not pass the check, and end with status 1."""
    faults = result.report.faults
    for fault in faults:
        complaints.print(fault, markup=False, highlight=False)
    if faults:
        complaints.print(
            f"{result.path} does not pass `mansion check`: {counted(len(faults), 'fault')}", highlight=False
        )
        raise typer.Exit(1)


def _refuse_unmet_plan(request: BuildRequest) -> None:
    """Plan first, so that a brief whose wishes no plan meets is refused before anything is built."""
    from mansion_bringup.building.receipt import receipt_of_plan
    from mansion_bringup.pipeline.planning import plan_request

    reply = plan_request(request)
    refuse_unmet(receipt_of_plan(reply.program, reply.topologies))


def _prepared_formats(listed: str) -> list[str]:
    """Return the names of the formats in a list, all known and what they need installed."""
    from mansion_bringup.extras import ensure_extra

    names = format_names(listed)
    for each in formats_of_build(names):
        if each.extra:
            ensure_extra(each.extra)
    return names


def _in_processes(
    request: BuildRequest, output: Path, jobs: int, formats: Sequence[str], *, force: bool
) -> "BuildResult":
    from mansion_bringup.pipeline.build import build_building
    from mansion_bringup.pipeline.planning import prepare_planner

    prepare_planner(request)
    workers = jobs or min(os.cpu_count() or 1, 8)
    with progress_bar() as report:
        return build_building(request, output, jobs=workers, report=report, formats=formats, force=force)


def _through_graph(
    request: BuildRequest, output: Path, timeout: float, formats: Sequence[str], *, force: bool
) -> "BuildResult":
    from mansion_bringup.graph.processes import graph_client
    from mansion_bringup.pipeline.build import BuildResult
    from mansion_msgs_py.stages import BuildJob, BuildReply

    with graph_client(allow=[output.absolute().parent], notice=err.print) as client, progress_bar() as report:
        from mansion_msgs_py.request import identified
        from mansion_msgs_py.world import Progress

        known = identified(request)

        def show(text: str) -> None:
            progress = decode(Progress, text)
            if progress.building_id == known.building_id:
                report(progress)

        client.listen("progress", show)
        job = BuildJob.of(request, output=str(output.absolute()), force=force, formats=formats)
        reply = client.call("build_building", job, reply=BuildReply, timeout=timeout)
    path = Path(reply.path)
    summary = decode(BuildingReport, (path / "report.json").read_bytes())
    return BuildResult(path, reply.building, summary)


def _print_summary(result: "BuildResult") -> None:
    building: Building = result.building
    program = building.program
    area = sum(floor.gross_floor_area for floor in program.floors)
    out.print(
        f"[bold]{result.path}[/bold]: {program.building_type or 'building'}, "
        f"{counted(len(building.floors), 'floor')}, {area:.0f} m2 gross, "
        f"{counted(building.checks['rooms'], 'room')}, {counted(building.checks['objects'], 'object')}, "
        f"{result.report.seconds.get('total', 0.0):.1f} s",
        highlight=False,
    )
    print_receipt(building.wishes)
    print_own_assets(result.report, building.request.libraries)
    if building.request.plan is not None:
        print_plan_notes(program.downgrades)
