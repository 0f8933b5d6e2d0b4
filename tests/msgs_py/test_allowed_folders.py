"""Services write below the folders that were named at the start, and say which these are."""

from pathlib import Path

import pytest

from mansion_msgs_py import allowed_folders
from mansion_msgs_py.allowed_folders import EVERYWHERE, AllowedFolders, allowed_at_start
from mansion_msgs_py.errors import ErrorCode, MansionError


@pytest.fixture
def allowed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> AllowedFolders:
    """The folders of a process in ``here`` whose temporary folder is ``temporary``, and which was given ``named``."""
    for name in ("here", "temporary", "named", "other"):
        (tmp_path / name).mkdir()
    monkeypatch.chdir(tmp_path / "here")
    monkeypatch.setattr(allowed_folders, "SYSTEM_TEMPORARY", tmp_path / "temporary")
    monkeypatch.setattr("tempfile.gettempdir", lambda: str(tmp_path / "temporary"))
    return allowed_at_start(["", tmp_path / "named"])


@pytest.mark.parametrize("place", ["here/out/office", "temporary/clinic", "named", "named/a/b", "other/../named/a"])
def test_the_working_folder_the_temporary_one_and_those_named_may_be_written(
    allowed: AllowedFolders, tmp_path: Path, place: str
) -> None:
    allowed.check(tmp_path / place)


def test_a_relative_path_is_below_the_working_folder(allowed: AllowedFolders) -> None:
    allowed.check(Path("out/office"))
    assert not allowed.allows(Path("../other"))


@pytest.mark.parametrize("place", ["other/a", "named/../other", "named2", "."])
def test_any_other_folder_is_refused_with_those_that_are_accepted(
    allowed: AllowedFolders, tmp_path: Path, place: str
) -> None:
    with pytest.raises(MansionError, match=rf"{tmp_path}/here or .*named, or start .*--allow") as caught:
        allowed.check(tmp_path / place, "$.output")
    assert (caught.value.code, caught.value.info.path) == (ErrorCode.FORBIDDEN, "$.output")


def test_a_link_counts_as_where_it_leads(allowed: AllowedFolders, tmp_path: Path) -> None:
    (tmp_path / "named" / "out").symlink_to(tmp_path / "other")
    (tmp_path / "other" / "in").symlink_to(tmp_path / "named")
    assert not allowed.allows(tmp_path / "named" / "out" / "a")
    assert allowed.allows(tmp_path / "other" / "in" / "a")


def test_a_process_that_was_started_at_the_root_may_not_write_everywhere(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir("/")
    assert not allowed_at_start([]).allows(Path("/etc/a"))
    assert allowed_at_start(["/"]).allows(Path("/etc/a"))
    assert EVERYWHERE.allows(Path("/etc/a"))
