"""Rooms that people pass from one into the other."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_knowledge.leads_into import CalledRoom, _rules, leading_rules


@pytest.mark.parametrize(
    ("room", "into", "family"),
    [
        (CalledRoom("commercial_kitchen"), CalledRoom("cafeteria"), "office"),
        (CalledRoom("operating_room"), CalledRoom("study_room", "prep room"), "health"),
        (CalledRoom("assembly_hall"), CalledRoom("storage", "Chair store"), "civic"),
        (CalledRoom("mechanical_room", "machine room"), CalledRoom("storage", "wood store"), "industry"),
        (CalledRoom("indoor_pool"), CalledRoom("security_room", "lifeguard room"), "sport"),
    ],
)
def test_rooms_that_are_used_together_lead_into_each_other(room: CalledRoom, into: CalledRoom, family: str) -> None:
    assert leading_rules(room, into, family)


@pytest.mark.parametrize(
    ("room", "into", "family"),
    [
        (CalledRoom("assembly_hall"), CalledRoom("storage"), "civic"),
        (CalledRoom("sales_area"), CalledRoom("stock_room"), "home"),
        (CalledRoom("restaurant"), CalledRoom("cold_storage"), "food"),
        (CalledRoom("garage"), CalledRoom("bedroom"), "home"),
    ],
)
def test_other_rooms_do_not(room: CalledRoom, into: CalledRoom, family: str) -> None:
    assert not leading_rules(room, into, family)


def test_no_rule_asks_for_a_door_that_a_rule_of_building_forbids() -> None:
    from mansion_knowledge.norms import load_norms

    barred = [rule for name, rule in load_norms().rules.items() if name.endswith("_door")]
    for rule in _rules():
        for norm in barred:
            joined = set(norm.rooms) & set(rule.rooms) and set(norm.others) & set(rule.into)
            assert not joined, (rule.why, norm.id)


def test_rules_name_families_that_there_are() -> None:
    families = {building.family for building in default_knowledge().buildings.values()}
    assert {family for rule in _rules() for family in rule.families} <= families
