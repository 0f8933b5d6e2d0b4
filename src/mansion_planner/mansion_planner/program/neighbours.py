"""Rooms that are to be side by side: which are wished, which a sketch keeps apart, and what is recorded of it."""

from mansion_msgs_py.program import Downgrade
from mansion_planner.brief.facts import AdjacencyFact
from mansion_planner.program.decisions import Decisions
from mansion_planner.program.model import Storey
from mansion_planner.program.placement import Sketch, touching

__all__ = ["apart_pairs", "neighbours", "wanted_pairs"]


def wanted_pairs(decisions: Decisions) -> list[tuple[str, str]]:
    """Return room types to be side by side: the brief's wishes last, so that they win."""
    usual = [("kitchen", "dining_room"), ("commercial_kitchen", "restaurant"), ("commercial_kitchen", "cafeteria")]
    return usual + [_names(fact) for fact in decisions.facts.adjacent]


def _names(fact: AdjacencyFact) -> tuple[str, str]:
    return fact.first_name or fact.first, fact.second_name or fact.second


def apart_pairs(decisions: Decisions, storey: Storey, sketch: Sketch) -> list[AdjacencyFact]:
    """Return the wished neighbours that both are on the storey and do not touch."""
    apart = []
    for fact in decisions.facts.adjacent:
        firsts, seconds = ([p for p in sketch.rooms if p.room.called(name)] for name in _names(fact))
        if storey.hub.name in (fact.first, fact.second) or not firsts or not seconds:
            continue
        if not sketch.loose and not any(a is not b and touching(a, b) for a in firsts for b in seconds):
            apart.append(fact)
    return apart


def neighbours(decisions: Decisions, storey: Storey, sketch: Sketch) -> dict[str, list[str]]:
    """Return the neighbours that the brief wishes, by room id; what the storey cannot give is recorded."""
    beside: dict[str, list[str]] = {}
    apart = apart_pairs(decisions, storey, sketch) if not decisions.free_form else []
    for fact in decisions.facts.adjacent:
        firsts, seconds = ([p for p in sketch.rooms if p.room.called(name)] for name in _names(fact))
        pairs = [(a, b) for a in firsts for b in seconds if a is not b]
        if fact in apart:
            decisions.downgrades.append(
                Downgrade(
                    wish=fact.span.words, got="both on one storey, reached from one corridor", stage="program",
                    reason="their sizes leave no place side by side", floor=storey.index,
                )
            )  # fmt: skip
        elif pairs and storey.hub.name not in (fact.first, fact.second):
            pair = next((p for p in pairs if decisions.free_form or sketch.loose or touching(*p)), pairs[0])
            beside.setdefault(pair[0].room.id, []).append(pair[1].room.id)
    return beside
