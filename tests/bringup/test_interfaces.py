"""The whole interface table: the skills are in it, and the pages are made from it."""

from pathlib import Path

import pytest

from mansion_bringup.interfaces import PAGES, PAYLOADS, SERVICES, markdown_table, page, payload_type
from mansion_msgs_py.codec import schema
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.interfaces import TOPICS

DOCS = Path(__file__).parents[2] / "docs"


def test_names_are_unique() -> None:
    names = [entry.name for entry in (*SERVICES, *TOPICS)]
    assert len(names) == len(set(names))


def test_only_services_without_arguments_are_triggers() -> None:
    for entry in SERVICES:
        assert (entry.type == "std_srvs/srv/Trigger") == (entry.arguments is None)


def test_every_service_takes_and_returns_a_listed_payload() -> None:
    for entry in SERVICES:
        for kind in (entry.arguments, entry.reply):
            assert kind in (None, dict) or PAYLOADS[kind.__name__] is kind


def test_the_documented_table_is_the_one_in_the_code() -> None:
    assert markdown_table() in (DOCS / "interfaces.md").read_text()


@pytest.mark.parametrize("name", PAGES)
def test_a_page_is_as_it_is_made(name: str) -> None:
    text = (DOCS / name).read_text()
    assert page(name, text) == text


@pytest.mark.parametrize("name", sorted(PAYLOADS))
def test_every_payload_has_a_schema_that_names_it(name: str) -> None:
    found = schema(payload_type(name))
    assert found["$ref"].endswith(f"/{name}")
    assert found["$schema"].startswith("https://json-schema.org/")


def test_an_unknown_payload_is_answered_with_the_known_ones() -> None:
    with pytest.raises(MansionError, match="FloorScene"):
        payload_type("Nonsense")
