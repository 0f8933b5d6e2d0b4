"""Decoding gives a value or the documented error; encoding is repeatable."""

import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from decoding import check_decoding
from mansion_msgs_py.codec import decode, decode_reply, encode, encode_bytes, to_builtins
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.payloads import PAYLOADS
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.topology import FloorTopology
from mansion_msgs_py.world import Pose2D

FIRST_USE_BY_TWO_THREADS = """
import threading
import time
import msgspec
from mansion_msgs_py.codec import {names}

looking = threading.Event()

def slow():
    looking.set()
    time.sleep(0.5)
    return int

class Inner(msgspec.Struct):
    count: "slow()"

class Outer(msgspec.Struct):
    inner: Inner

def read():
    assert {call}.inner.count == 3

first = threading.Thread(target=read)
first.start()
looking.wait()
read()
first.join()
print("read by both")
"""


@pytest.mark.parametrize(
    ("names", "call"),
    [
        ("decode", """decode(Outer, '{"inner": {"count": 3}}')"""),
        ("convert", """convert(Outer, {"inner": {"count": 3}})"""),
        ("prepared", """msgspec.convert({"inner": {"count": "3"}}, prepared(Outer), strict=False)"""),
    ],
)
def test_two_threads_may_be_the_first_to_read_a_type(names: str, call: str) -> None:
    code = FIRST_USE_BY_TWO_THREADS.replace("{names}", names).replace("{call}", call)
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=False)
    assert (ended.returncode, ended.stdout) == (0, "read by both\n"), ended.stderr


@pytest.mark.parametrize("name", sorted(PAYLOADS))
@given(data=st.data())
@settings(max_examples=25, deadline=None)
def test_any_bytes_give_a_value_or_the_documented_error(name: str, data: st.DataObject) -> None:
    check_decoding(PAYLOADS[name], data)


@pytest.mark.parametrize("text", ["\ud800", "[" * 100_000, '{"description": ' + "[" * 100_000, "nul", b"\xff\xfe"])
def test_hostile_texts_are_refused_as_invalid_payloads(text: str | bytes) -> None:
    with pytest.raises(MansionError) as caught:
        decode(BuildRequest, text)
    assert caught.value.code == ErrorCode.INVALID_PAYLOAD


def test_the_path_of_the_fault_is_in_the_error() -> None:
    text = '{"nodes": [{"id": "a", "type": "main", "area": -1}], "edges": []}'
    with pytest.raises(MansionError) as caught:
        decode(FloorTopology, text)
    assert caught.value.info.path == "$.nodes[0].area"


def test_a_misspelt_field_of_a_request_is_named() -> None:
    with pytest.raises(MansionError, match="descripton"):
        decode(BuildRequest, '{"descripton": "a flat"}')


def test_an_empty_text_counts_as_no_arguments() -> None:
    with pytest.raises(MansionError, match="description"):
        decode(BuildRequest, "  ")


def test_equal_values_have_equal_bytes() -> None:
    first = BuildRequest(description="a flat", seed=3)
    assert encode_bytes(first) == encode_bytes(decode(BuildRequest, encode(first, indent=2)))


def test_a_failed_reply_becomes_the_error_that_the_server_raised() -> None:
    sent = MansionError("CONFLICT", "busy", path="$.output", details={"stage": "export"})
    with pytest.raises(MansionError) as caught:
        decode_reply(dict, encode(sent.reply()), success=False)
    assert caught.value.info == sent.info
    assert caught.value.stage == "export"


def test_a_failed_reply_that_is_no_error_object_still_becomes_an_error() -> None:
    with pytest.raises(MansionError, match="out of paper"):
        decode_reply(dict, "out of paper", success=False)


def test_floats_of_numpy_are_floats() -> None:
    origin = Pose2D(x=np.float64(0.1), y=2.0, yaw=np.float64(90.0))
    assert encode(origin) == '{"x":0.1,"y":2.0,"yaw":90.0}'
    assert to_builtins([np.float64(0.1)]) == [0.1]
    with pytest.raises(TypeError, match="no JSON for int64"):
        encode([np.int64(3)])
