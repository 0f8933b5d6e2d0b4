"""The rules of building are complete records of known buildings, rooms and sources."""

from pathlib import Path

import pytest

from mansion_knowledge import default_knowledge
from mansion_knowledge import norms as module
from mansion_knowledge.norms import Norm, load_norms
from mansion_msgs_py.errors import MansionError

RULES = list(load_norms().rules.values())


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.id)
def test_a_rule_names_known_buildings_and_rooms_only(rule: Norm) -> None:
    knowledge = default_knowledge()
    assert {kind.family for kind in knowledge.buildings.values()} >= set(rule.families)
    assert {*rule.rooms, *rule.others, *rule.yields_to} <= set(knowledge.rooms)


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.id)
def test_a_rule_has_words_a_unit_and_a_source_and_practice_is_called_so(rule: Norm) -> None:
    assert rule.statement.endswith(".")
    assert rule.unit
    assert any(letter.isdigit() for letter in rule.source) or "no code" in rule.source


def written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: str) -> None:
    file = tmp_path / "norms.toml"
    file.write_text(text, encoding="utf-8")
    monkeypatch.setattr(module, "_FILE", file)
    load_norms.cache_clear()
    monkeypatch.setattr(module, "load_norms", load_norms.__wrapped__)


@pytest.mark.parametrize(
    ("line", "told"),
    [
        ('severity = "grave"', "severity 'grave' is not one of deviation, advice"),
        ('colour = "red"', "unknown ['colour'], missing []"),
    ],
)
def test_a_faulty_record_is_refused_by_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, line: str, told: str
) -> None:
    record = f'[occupants]\n[lift]\nstatement = "s"\nsource = "t"\nunit = "m"\nfigure = 1\n{line}\n'
    written(tmp_path, monkeypatch, record)
    with pytest.raises(MansionError) as raised:
        module.load_norms()
    assert str(raised.value).endswith(f"rule 'lift' of norms.toml: {told}")
