"""What is wrong with a payload is said with the place and with what would be accepted."""

from enum import StrEnum

import msgspec
import pytest

from mansion_msgs_py.codec import convert, decode
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.task import Task, TaskSet
from mansion_skills.skills.between_floors import UseElevatorArgs


class Colour(StrEnum):
    RED = "red"
    GREEN = "green"


class Leaf(msgspec.Struct, forbid_unknown_fields=True):
    colour: Colour = Colour.RED
    size: int = 1


class Tree(msgspec.Struct, forbid_unknown_fields=True):
    leaves: list[Leaf] = []
    named: dict[str, Leaf] = {}
    crown: Leaf | None = None
    pair: tuple[int, Leaf] | None = None


def fault(kind: type, text: str) -> MansionError:
    with pytest.raises(MansionError) as caught:
        decode(kind, text)
    assert caught.value.code == "INVALID_PAYLOAD"
    return caught.value


def test_an_unknown_field_is_answered_with_the_fields() -> None:
    error = fault(UseElevatorArgs, '{"floor": 2}')
    assert error.info.path == "$.floor"
    assert "did you mean target_floor?" in error.info.message
    assert "fields: target_floor (required), session, token" in error.info.message


def test_a_missing_field_is_named_among_the_others() -> None:
    error = fault(UseElevatorArgs, "{}")
    assert "'target_floor' is missing" in error.info.message
    assert "target_floor (required), session" in error.info.message


@pytest.mark.parametrize(
    ("text", "path"),
    [
        ('{"leaves": [{}, {"color": "red"}]}', "$.leaves[1].color"),
        ('{"named": {"a": {"color": "red"}}}', "$.named[...].color"),
        ('{"crown": {"color": "red"}}', "$.crown.color"),
        ('{"pair": [1, {"color": "red"}]}', "$.pair[1].color"),
    ],
)
def test_fields_are_those_of_the_place(text: str, path: str) -> None:
    error = fault(Tree, text)
    assert error.info.path == path
    assert "did you mean colour? fields: colour, size" in error.info.message


def test_a_value_outside_of_a_choice_is_answered_with_the_values() -> None:
    error = fault(Tree, '{"leaves": [{"colour": "rad"}]}')
    assert error.info.path == "$.leaves[0].colour"
    assert "'rad' is not accepted; did you mean red? values: red, green" in error.info.message
    assert "values: deliver" in fault(Task, '{"id": "a", "kind": "x"}').info.message


def test_a_wrong_type_keeps_its_place() -> None:
    error = fault(Tree, '{"leaves": [{"size": "x"}]}')
    assert (error.info.message, error.info.path) == ("Expected `int`, got `str`", "$.leaves[0].size")
    assert fault(list[Leaf], '{"size": 1}').info.path == "$"
    assert "Expected" in fault(TaskSet, "[]").info.message


def test_values_that_are_decoded_already_are_judged_alike() -> None:
    assert convert(Leaf, {"size": 3}).size == 3
    with pytest.raises(MansionError, match="did you mean colour"):
        convert(Leaf, {"colours": 3})


def test_a_monstrous_name_is_cut() -> None:
    assert len(str(fault(Leaf, '{"' + "x" * 100_000 + '": 1}'))) < 1000


class Begin(msgspec.Struct, tag="begin", tag_field="line"):
    pass


class End(msgspec.Struct, tag="end", tag_field="line"):
    pass


def test_of_several_kinds_the_field_that_tells_them_apart_is_named() -> None:
    kind: type = Begin | End  # type: ignore[assignment]
    assert "'line' is missing; values: begin, end" in fault(kind, "{}").info.message
