"""The account of a language model's answers."""

import msgspec

from mansion_msgs_py.usage import LlmUsage, total_usage


def test_every_figure_of_the_parts_is_added_to_its_own_sum() -> None:
    numbers = [f.name for f in msgspec.structs.fields(LlmUsage) if f.name != "model"]
    first = LlmUsage(model="small", **{name: 2**k for k, name in enumerate(numbers)})
    second = LlmUsage(model="small", **{name: 3**k for k, name in enumerate(numbers)})
    whole = total_usage([first, second])
    assert whole is not None
    assert whole.model == "small"
    assert [getattr(whole, name) for name in numbers] == [2**k + 3**k for k in range(len(numbers))]


def test_no_parts_have_no_account() -> None:
    assert total_usage([]) is None
