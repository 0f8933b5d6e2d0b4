"""``mansion build``: one sentence to a building folder."""

import os
import shlex
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Final, Literal

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
from mansion_bringup.cli.text_argument import TextCommand
from mansion_bringup.exporting import format_names
from mansion_export.formats import ALL, export_formats, formats_of_build
from mansion_msgs_py.building import Building, BuildingReport
from mansion_msgs_py.building_folder import is_building_folder
from mansion_msgs_py.building_plan import BuildingPlan
from mansion_msgs_py.codec import convert, decode, to_builtins
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import read_bytes
from mansion_msgs_py.request import BuildRequest, Footprint
from mansion_msgs_py.wording import counted

if TYPE_CHECKING:
    from mansion_bringup.pipeline.build import BuildResult

__all__ = [
    "ASSETS_HELP",
    "COMPLETE_HELP",
    "LAYERS_HELP",
    "PLAN_HELP",
    "given_plan",
    "library_names",
    "planner_name",
    "read_footprint",
    "register",
    "request_from_options",
]

PLAN_HELP: Final = "A plan to furnish as it is: our JSON, GeoJSON, IFC, DXF or a room graph."
COMPLETE_HELP: Final = "What may be added where the plan lacks it: doors, windows, or doors,windows."
ASSETS_HELP: Final = "Libraries of your own assets that come first: NAME,NAME (mansion assets add)."
LAYERS_HELP: Final = "Layers of a drawing: rooms=NAME,names=NAME,doors=NAME,windows=NAME."

FORMATS_HELP: Final = f"What to write beside plans and a picture: {ALL}, or some of {', '.join(export_formats())}."


def register(app: typer.Typer) -> None:
    """Add the command to `app`."""
    app.command("build", cls=TextCommand, no_args_is_help=True)(build)


def request_from_options(
    description: str,
    floors: int | None,
    area: float | None,
    floor_area: float | None,
    footprint: Path | None,
    seed: int,
    planner: Literal["rules", "llm"],
    plan: BuildingPlan | None = None,
    assets: str = "",
) -> BuildRequest:
    """Return the validated request that the options make.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for options that do not fit, ``NOT_FOUND`` for a library of own assets that is not there.
    """
    fields = {
        "description": description,
        "floors": floors,
        "area": area,
        "floor_area": floor_area,
        "footprint": read_footprint(footprint) if footprint else None,
        "seed": seed,
        "planner": planner,
        "plan": None if plan is None else to_builtins(plan),
    }
    if names := library_names(assets):
        fields["assets"] = names
    return convert(BuildRequest, fields)


def library_names(listed: str) -> list[str]:
    """Return the libraries in a list with commas between them, all there; paths lead from the root.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` with those that there are.
    """
    named = [name.strip() for name in listed.split(",") if name.strip()]
    if not named:
        return []
    from mansion_assets.library.folders import stated_libraries

    return stated_libraries(named)


def given_plan(file: Path | None, complete: str, layers: str) -> BuildingPlan | None:
    """Return the plan that the options name.

    Parameters
    ----------
    complete : str
        ``doors``, ``windows`` or both with a comma.
    layers : str
        ``rooms=NAME,doors=NAME``, for drawings.
    """
    for name, said in (("--complete", complete), ("--layers", layers)):
        if file is None and said:
            raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{name} needs a plan (--plan)")
    if file is None:
        return None
    from mansion_bringup.plan_files import plan_from_file

    added = convert(list[Literal["doors", "windows"]], [part.strip() for part in complete.split(",") if part.strip()])
    pairs = [part.partition("=") for part in layers.split(",") if part.strip()]
    return plan_from_file(file, added, {name.strip(): layer.strip() for name, _, layer in pairs})


def read_footprint(path: Path) -> Footprint:
    """Read a footprint: ``{"boundary": ring, "holes": [ring]}`` in metres, or GeoJSON with one polygon.

    Raises
    ------
    MansionError
        ``NOT_FOUND``, or ``INVALID_PAYLOAD`` with what would be accepted.
    """
    from mansion_msgs_py.request import footprint_from_json

    expected = 'a file of {"boundary": [[x, y], ...]} or GeoJSON'
    return footprint_from_json(read_bytes(path, expected), str(path))


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
    floors: Annotated[int | None, typer.Option(min=1, max=100, help="Number of floors.")] = None,
    area: Annotated[float | None, typer.Option(min=1, help="Gross area of the building, m2.")] = None,
    floor_area: Annotated[float | None, typer.Option(min=1, help="Gross area of a floor, m2.")] = None,
    footprint: Annotated[Path | None, typer.Option(help="Outline: our JSON or GeoJSON.")] = None,
    plan: Annotated[Path | None, typer.Option(help=PLAN_HELP)] = None,
    complete: Annotated[str, typer.Option(help=COMPLETE_HELP)] = "",
    layers: Annotated[str, typer.Option(help=LAYERS_HELP)] = "",
    seed: Annotated[int, typer.Option(min=0, help="Same seed, same building.")] = 0,
    planner: Annotated[
        str, typer.Option(help="rules, or llm: a language model reads and plans, rules fill its gaps.")
    ] = "rules",
    assets: Annotated[str, typer.Option(help=ASSETS_HELP)] = "",
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


def planner_name(name: str) -> Literal["rules", "llm"]:
    """Return the planner of that name, or refuse it."""
    if name == "rules":
        return "rules"
    if name == "llm":
        return "llm"
    raise MansionError(ErrorCode.INVALID_PAYLOAD, f"unknown planner {name!r}; use rules or llm", path="$.planner")


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
