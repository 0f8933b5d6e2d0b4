"""What a long call says on standard error."""

import io

import pytest

from mansion_bringup.graph.call_progress import CallProgress, progress_line
from mansion_msgs_py.codec import encode
from mansion_msgs_py.world import Progress, SkillProgress


class Clock:
    """Seconds that a test sets."""

    def __init__(self) -> None:
        self.now = 0.0

    def __call__(self) -> float:
        return self.now


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.fixture
def clock() -> Clock:
    return Clock()


def test_a_build_says_its_step_and_a_skill_its_part_of_the_way() -> None:
    build = encode(Progress(stage="solve", message="laid out floor 2", done=3, total=9))
    assert progress_line("progress", build) == "[3/9] laid out floor 2"
    skill = encode(SkillProgress(session="default", skill="MoveTo", message="driving", fraction=0.4))
    assert progress_line("skill_progress", skill) == "40% driving"
    assert progress_line("skill_progress", skill, {"session": "default"}) == "40% driving"


def test_what_another_session_does_is_not_said() -> None:
    skill = encode(SkillProgress(session="second", skill="MoveTo", message="driving", fraction=0.4))
    assert progress_line("skill_progress", skill) is None
    assert progress_line("skill_progress", skill, {"session": "second"}) == "40% driving"


def test_a_short_call_says_nothing(clock: Clock) -> None:
    stream = io.StringIO()
    progress = CallProgress("build_building", stream=stream, clock=clock)
    progress.told("[0/1] planning")
    clock.now = 0.9
    progress.told("[1/1] done")
    progress.end()
    assert stream.getvalue() == ""


def test_lines_in_a_pipe_are_plain_and_each_step_comes_once(clock: Clock) -> None:
    stream = io.StringIO()
    progress = CallProgress("build_building", stream=stream, clock=clock)
    progress.told("[0/9] planning")
    for clock.now in (0.5, 1.5, 2.0, 3.0):
        progress.tick()
    progress.told("[1/9] 4 floors")
    progress.end()
    assert stream.getvalue() == "[0/9] planning, 2 s\n[1/9] 4 floors, 3 s\n"


def test_a_call_of_which_nothing_is_known_says_now_and_then_that_it_lasts(clock: Clock) -> None:
    stream = io.StringIO()
    progress = CallProgress("scene/instruct", stream=stream, clock=clock)
    for clock.now in (0.5, 1.0, 5.0, 10.0, 12.0, 15.0):
        progress.tick()
    assert stream.getvalue() == "scene/instruct: no answer yet, 1 s\nscene/instruct: no answer yet, 12 s\n"


def test_a_terminal_has_one_line_that_goes_in_the_end(clock: Clock, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TERM", "xterm")
    stream = Terminal()
    progress = CallProgress("build_building", stream=stream, clock=clock)
    clock.now = 2.0
    progress.told("[1/9] 4 floors")
    clock.now = 3.0
    progress.tick()
    progress.end()
    assert stream.getvalue() == "\r\033[K[1/9] 4 floors, 2 s\r\033[K[1/9] 4 floors, 3 s\r\033[K"


def test_a_dumb_terminal_has_plain_lines(clock: Clock, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TERM", "dumb")
    stream = Terminal()
    progress = CallProgress("build_building", stream=stream, clock=clock)
    clock.now = 2.0
    progress.told("[1/9] 4 floors")
    progress.end()
    assert stream.getvalue() == "[1/9] 4 floors, 2 s\n"


def test_quiet_says_nothing(clock: Clock) -> None:
    stream = Terminal()
    progress = CallProgress("build_building", quiet=True, stream=stream, clock=clock)
    clock.now = 5.0
    progress.told("[1/9] 4 floors")
    progress.end()
    assert stream.getvalue() == ""
