"""``mansion plan``: the program of a brief, without building it."""

from typing import Annotated

import msgspec
import typer

from mansion_bringup.cli.console import out, print_json
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
from mansion_msgs_py.program import BuildingProgram, FloorProgram
from mansion_msgs_py.stages import PlanReply

__all__ = ["register"]


def register(app: typer.Typer) -> None:
    """Add the command to `app`."""
    app.command("plan", cls=TextCommand, no_args_is_help=True)(plan)


def plan(
    description: Annotated[str, typer.Argument(help="The brief: English, or any language with --planner llm.")] = "",
    floors: Floors = None,
    area: Area = None,
    floor_area: FloorArea = None,
    footprint: FootprintFile = None,
    plan: PlanFile = None,
    complete: Complete = "",
    layers: Layers = "",
    seed: Annotated[int, typer.Option(min=0)] = 0,
    planner: Planner = "rules",
    assets: Assets = "",
    strict: Annotated[
        bool, typer.Option("--strict", help="Refuse a plan that does not fully meet every wish.")
    ] = False,
    as_json: Annotated[bool, typer.Option("--json", help="Print only the program, as JSON.")] = False,
) -> None:
    """Show the program of a brief: floors, rooms, areas, and which words led to what.

    Examples:

      mansion plan "a two-storey library with a reading room on the top floor"

      mansion plan "a clinic" --floors 2 --json

      mansion plan --plan house.json          (what is wrong with a plan, and what is made of it)
    """
    from mansion_bringup.building.receipt import receipt_of_plan
    from mansion_bringup.cli.receipt_table import print_plan_notes, print_receipt, refuse_unmet
    from mansion_bringup.pipeline.planning import plan_request

    given = given_plan(plan, complete, layers)
    request = request_from_options(
        description, floors, area, floor_area, footprint, seed, planner_name(planner), given, assets
    )
    reply = plan_request(request)
    wishes = receipt_of_plan(reply.program, reply.topologies)
    if strict:
        refuse_unmet(wishes)
    if as_json:
        print_json(msgspec.structs.replace(reply.program, wishes=wishes))
        return
    _print_program(reply.program)
    _print_sources(reply)
    print_receipt(wishes)
    if given is not None:
        print_plan_notes(reply.program.downgrades)


def _print_sources(reply: PlanReply) -> None:
    """Say which pieces a language model planned, and what that took."""
    if reply.llm is None:
        return
    out.print("[bold]planned by[/bold]")
    for piece, source in reply.sources.items():
        out.print(f"  {piece}: {source}", markup=False, highlight=False)
    usage = reply.llm
    out.print(
        f"  {usage.answers} answers of {usage.model}, {usage.input_tokens} + {usage.output_tokens} tokens, "
        f"{usage.seconds:.1f} s, cost {usage.cost:g}",
        markup=False,
        highlight=False,
    )


def _print_program(program: BuildingProgram) -> None:
    out.print(f"[bold]{program.building_type}[/bold]  {program.reasoning}", highlight=False)
    for floor in program.floors:
        _print_floor(floor)
    cores = program.vertical_connectivity
    out.print(f"vertical: {cores.method}  {cores.justification}", highlight=False)
    if program.trace:
        out.print("[bold]what led to what[/bold]")
    for entry in program.trace:
        words = f"“{entry.words}”" if entry.words else "(not said)"
        out.print(f"  {words} -> {entry.effect}", markup=False, highlight=False)


def _print_floor(floor: FloorProgram) -> None:
    from rich.table import Table

    summary = floor.area_summary
    title = (
        f"floor {floor.index} ({floor.label}), {floor.gross_floor_area:.0f} m2 gross, "
        f"{summary.reserve_ratio:.0%} in reserve"
    )
    if floor.copy is not None:
        out.print(f"{title}: as floor {floor.copy}", highlight=False)
        return
    table = Table("room", "type", "net m2", "floor", "walls", title=title, title_justify="left")
    table.columns[2].justify = "right"
    for room in floor.rooms:
        table.add_row(room.id, room.room_type, f"{room.area_estimate:.1f}", room.floor_material, room.wall_material)
    out.print(table)
