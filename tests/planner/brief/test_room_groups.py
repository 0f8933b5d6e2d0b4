"""Desks that are counted as places to work are one area."""

from mansion_knowledge import default_knowledge
from mansion_planner.brief.reader import read_brief


def test_hot_desks_are_furniture_of_one_area_on_each_storey() -> None:
    brief = (
        "A coworking with a cafe on the ground floor, 2 upper floors with 30 hot desks each and 4 private offices each"
    )
    facts = read_brief(brief, default_knowledge())
    rooms = {fact.name: (fact.count, fact.each, [ref.kind for ref in fact.floors]) for fact in facts.rooms}
    assert rooms["hot_desk_area"] == (1, True, ["upper"])
    assert rooms["private_office"] == (4, True, ["upper"])
    assert [(o.category, o.count, o.room, o.each) for o in facts.objects] == [("desk", 30, "hot_desk_area", True)]
