"""Decoding of a payload type, whatever comes."""

import json
from typing import Any

from hypothesis import strategies as st

from mansion_msgs_py.codec import decode, encode
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["check_decoding"]

JSON_VALUES = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False) | st.text(),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(), inner, max_size=4),
    max_leaves=12,
)


def payload_like(kind: type[Any]) -> st.SearchStrategy[Any]:
    """Objects with the payload's own field names and arbitrary values: far into the decoder."""
    names = list(kind.__struct_encode_fields__)
    keys = st.sampled_from(names) if names else st.nothing()
    return st.dictionaries(keys, JSON_VALUES, max_size=len(names))


def check_decoding(kind: type[Any], data: st.DataObject) -> None:
    """Check that a drawn text gives a value that encodes to itself, or the documented error."""
    text = data.draw(
        st.binary(max_size=200)
        | st.text(max_size=200)
        | JSON_VALUES.map(json.dumps)
        | payload_like(kind).map(json.dumps)
    )
    try:
        value = decode(kind, text)
    except MansionError as error:
        assert error.code == ErrorCode.INVALID_PAYLOAD
        assert error.info.path.startswith("$")
        assert error.info.details["payload"] == kind.__name__
    else:
        assert isinstance(value, kind)
        assert decode(kind, encode(value)) == value
