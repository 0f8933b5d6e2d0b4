"""A file that holds no payload is named in the error."""

from pathlib import Path

import pytest

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import decode_from, read_bytes, read_payload
from mansion_msgs_py.request import BuildRequest


def test_a_payload_is_read(tmp_path: Path) -> None:
    file = tmp_path / "request.json"
    file.write_text('{"description": "a flat"}')
    assert read_payload(BuildRequest, file).description == "a flat"


@pytest.mark.parametrize("name", ["missing.json", "."])
def test_what_cannot_be_read_is_named_with_what_was_expected(tmp_path: Path, name: str) -> None:
    with pytest.raises(MansionError) as caught:
        read_bytes(tmp_path / name, "a request")
    assert caught.value.code == ErrorCode.NOT_FOUND
    assert str(tmp_path / name) in str(caught.value)
    assert str(caught.value).endswith("; expected a request")


@pytest.mark.parametrize(("text", "path"), [('{"descr', "$"), ("[]", "$"), ('{"description": 3}', "$.description")])
def test_a_fault_is_told_with_file_and_place(tmp_path: Path, text: str, path: str) -> None:
    file = tmp_path / "request.json"
    file.write_text(text)
    with pytest.raises(MansionError) as caught:
        read_payload(BuildRequest, file)
    assert caught.value.code == ErrorCode.INVALID_PAYLOAD
    assert caught.value.info.message.startswith(f"{file}: ")
    assert caught.value.info.path == path
    with pytest.raises(MansionError, match=r"^INVALID_PAYLOAD.*: line 7: "):
        decode_from(BuildRequest, text, "line 7")
