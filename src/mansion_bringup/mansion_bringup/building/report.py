"""``building.json`` and ``report.json`` from what the stages returned."""

from collections.abc import Mapping, Sequence

from mansion_assets.catalogue import Asset
from mansion_bringup import __version__
from mansion_bringup.building.files import building_file_names, floor_file_names
from mansion_bringup.building.own_assets import asset_uses
from mansion_bringup.building.receipt import receipt
from mansion_export.formats import Outputs
from mansion_msgs_py.building import Building, BuildingReport, FloorEntry, FloorReport
from mansion_msgs_py.building_folder import floor_directory
from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.program import Downgrade
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.stages import PlanReply
from mansion_msgs_py.topology import FloorTopology
from mansion_msgs_py.usage import total_usage

__all__ = ["building_index", "building_report"]


def building_index(request: BuildRequest, plan: PlanReply, scenes: Sequence[FloorScene], outputs: Outputs) -> Building:
    """Return the content of ``building.json`` of a folder that has `outputs`."""
    program = plan.program
    return Building(
        building_id=program.building_id,
        request=request,
        program=program,
        floors=[_entry(scene, floor_file_names(outputs.floor)) for scene in scenes],
        cores=program.vertical_connectivity.cores,
        seed=request.seed,
        versions={"mansion": __version__},
        checks={
            "rooms": sum(_rooms(scene) for scene in scenes),
            "doors": sum(len(scene.doors) for scene in scenes),
            "objects": sum(len(scene.objects) for scene in scenes),
        },
        files=building_file_names(outputs.building),
        wishes=receipt(program.wishes, program, scenes),
    )


def _rooms(scene: FloorScene) -> int:
    """How many rooms a floor has, its cores left out."""
    return sum(room.kind not in ("stair", "elevator") for room in scene.rooms)


def _entry(scene: FloorScene, names: Mapping[str, str]) -> FloorEntry:
    folder = floor_directory(scene.floor)
    return FloorEntry(
        floor=scene.floor,
        label=scene.label,
        elevation=scene.elevation,
        height=scene.height,
        area=round(sum(room.area for room in scene.rooms), 3),
        rooms=_rooms(scene),
        objects=len(scene.objects),
        files={key: f"{folder}/{name}" for key, name in names.items()},
    )


def building_report(
    plan: PlanReply,
    layouts: Sequence[FloorLayout],
    scenes: Sequence[FloorScene],
    seconds: dict[str, float],
    own: Sequence[Asset] = (),
) -> BuildingReport:
    """Return the content of ``report.json``: what was asked, what was met, what was downgraded."""
    floors = [
        _floor_report(topology, layout, scene) for topology, layout, scene in zip(plan.topologies, layouts, scenes)
    ]
    downgrades = [*plan.program.downgrades]
    for layout, scene in zip(layouts, scenes):
        downgrades += _downgrades(layout, scene)
    return BuildingReport(
        building_id=plan.program.building_id,
        floors=floors,
        downgrades=downgrades,
        seconds=dict(seconds),
        sources=_sources(plan, scenes),
        llm=total_usage([u for u in (plan.llm, *(scene.llm for scene in scenes)) if u is not None]),
        wishes=receipt(plan.program.wishes, plan.program, scenes),
        warnings=[f"floor {lay.floor}: {text}" for lay in layouts for text in lay.messages],
        assets=asset_uses(own, scenes),
    )


def _sources(plan: PlanReply, scenes: Sequence[FloorScene]) -> dict[str, str]:
    """Return where each piece came from, in the order of the stages."""
    found = dict(plan.sources)
    for scene in scenes:
        found |= scene.sources
    return found


def _floor_report(topology: FloorTopology, layout: FloorLayout, scene: FloorScene) -> FloorReport:
    asked = {node.id: node.area * layout.area_scale for node in topology.nodes if node.type in ("main", "Entities")}
    prefix = f"F{scene.floor}/"
    got = {room.id.removeprefix(prefix): room.area for room in scene.rooms}
    errors = [abs(got.get(name, 0.0) - area) / area for name, area in asked.items()]
    discarded = sum(entry.count for entry in scene.discarded)
    return FloorReport(
        floor=scene.floor,
        rooms_asked=len(asked),
        rooms_made=sum(1 for name in asked if name in got),
        edges_asked=len(topology.edges),
        edges_met=len(topology.edges) - len(layout.unmet_edges),
        area_scale=round(layout.area_scale, 6),
        area_error=round(sum(errors) / max(1, len(errors)), 4),
        objects_asked=len(scene.objects) + discarded,
        objects_placed=len(scene.objects),
    )


def _downgrades(layout: FloorLayout, scene: FloorScene) -> list[Downgrade]:
    edges = [
        Downgrade(
            wish=f"{edge.source} {edge.kind} {edge.target}",
            got="not realised",
            reason=edge.reason,
            stage="solve_floor",
            floor=scene.floor,
        )
        for edge in layout.unmet_edges
    ]
    objects = [
        Downgrade(
            wish=f"{entry.count} x {entry.name} in {entry.room}",
            got="left out",
            reason=entry.reason,
            stage="furnish_floor",
            floor=scene.floor,
        )
        for entry in scene.discarded
    ]
    return edges + list(scene.downgrades) + objects
