"""A building folder appears whole or not at all, and an interrupted build goes on where it was."""

from pathlib import Path

import pytest

from mansion_bringup.building.workspace import Workspace
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.request import BuildRequest

REQUEST = BuildRequest(description="a small flat")


def test_nothing_is_at_the_target_before_the_commit(tmp_path: Path) -> None:
    target = tmp_path / "flat"
    with Workspace(target, REQUEST) as workspace:
        workspace.write({"building.json": b"{}", "floors/floor_1/scene.json": b"{}"})
        assert not target.exists()
        workspace.commit()
    assert sorted(path.name for path in target.iterdir()) == ["building.json", "floors"]
    assert [path.name for path in tmp_path.iterdir()] == ["flat"]


def test_an_interrupted_build_leaves_its_floors_for_the_next_run(tmp_path: Path) -> None:
    with pytest.raises(KeyboardInterrupt), Workspace(tmp_path / "flat", REQUEST) as workspace:
        workspace.write({"floors/floor_1/scene.json": b"one"})
        workspace.mark_floor(1)
        raise KeyboardInterrupt
    with Workspace(tmp_path / "flat", REQUEST) as workspace:
        assert workspace.floor_done(1)
        assert workspace.read("floors/floor_1/scene.json") == b"one"


def test_another_request_starts_afresh(tmp_path: Path) -> None:
    with Workspace(tmp_path / "flat", REQUEST) as workspace:
        workspace.mark_floor(1)
    with Workspace(tmp_path / "flat", BuildRequest(description="a castle")) as workspace:
        assert not workspace.floor_done(1)


def test_other_formats_start_afresh(tmp_path: Path) -> None:
    with Workspace(tmp_path / "flat", REQUEST, formats=["plan"]) as workspace:
        workspace.mark_floor(1)
    with Workspace(tmp_path / "flat", REQUEST, formats=["plan"]) as workspace:
        assert workspace.floor_done(1)
    with Workspace(tmp_path / "flat", REQUEST, formats=["plan", "mjcf"]) as workspace:
        assert not workspace.floor_done(1)


def test_two_builds_cannot_write_the_same_folder(tmp_path: Path) -> None:
    with Workspace(tmp_path / "flat", REQUEST), pytest.raises(MansionError) as caught:
        Workspace(tmp_path / "flat", REQUEST).__enter__()
    assert caught.value.code == ErrorCode.CONFLICT


def test_an_older_building_is_replaced_whole(tmp_path: Path) -> None:
    old = tmp_path / "flat"
    old.mkdir()
    (old / "building.json").write_text("old")
    (old / "left_over").write_text("old")
    with Workspace(old, REQUEST) as workspace:
        workspace.write({"building.json": b"new"})
        assert (old / "building.json").read_text() == "old"
        workspace.commit()
    assert [path.name for path in old.iterdir()] == ["building.json"]


def test_a_folder_that_holds_something_else_is_refused(tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").write_text("years of work")
    with pytest.raises(MansionError, match="holds other files"):
        Workspace(tmp_path, REQUEST)


def test_the_state_of_robots_is_kept_unless_forced(tmp_path: Path) -> None:
    (tmp_path / "state").mkdir()
    (tmp_path / "building.json").write_text("{}")
    with pytest.raises(MansionError, match=r"the state of robots, which would be lost.*--force"):
        Workspace(tmp_path, REQUEST)
    Workspace(tmp_path, REQUEST, force=True)


def test_edits_are_kept_unless_forced(tmp_path: Path) -> None:
    log = tmp_path / "edits" / "log.jsonl"
    log.parent.mkdir()
    log.write_text("")
    (tmp_path / "building.json").write_text("{}")
    Workspace(tmp_path, REQUEST)
    log.write_text("{}\n")
    with pytest.raises(MansionError, match=r"a building with edits, which would be lost.*--force"):
        Workspace(tmp_path, REQUEST)
    Workspace(tmp_path, REQUEST, force=True)


def test_a_build_that_comes_during_the_commit_of_another_waits_its_turn(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    refused: list[MansionError] = []
    rename = Path.rename

    def rename_while_another_comes(path: Path, target: Path) -> Path:
        with pytest.raises(MansionError) as caught:
            Workspace(tmp_path / "flat", REQUEST).__enter__()
        refused.append(caught.value)
        return rename(path, target)

    with Workspace(tmp_path / "flat", REQUEST) as workspace:
        workspace.write({"building.json": b"{}"})
        monkeypatch.setattr(Path, "rename", rename_while_another_comes)
        workspace.commit()
    assert [error.code for error in refused] == [ErrorCode.CONFLICT]
    assert sorted(path.name for path in tmp_path.rglob("*")) == ["building.json", "flat"]


def test_a_build_that_fails_leaves_no_lock(tmp_path: Path) -> None:
    with pytest.raises(ZeroDivisionError), Workspace(tmp_path / "flat", REQUEST):
        raise ZeroDivisionError
    assert [path.name for path in tmp_path.iterdir()] == [".flat.partial"]


@pytest.mark.parametrize("there", [True, False], ids=["to a folder", "dangling"])
def test_a_link_stays_and_the_building_is_where_it_leads(tmp_path: Path, there: bool) -> None:
    real, link = tmp_path / "disk" / "flat", tmp_path / "flat"
    if there:
        real.mkdir(parents=True)
    link.symlink_to(real)
    with Workspace(link, REQUEST) as workspace:
        workspace.write({"building.json": b"{}"})
        workspace.commit()
    assert link.is_symlink() and [path.name for path in real.iterdir()] == ["building.json"]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["disk", "flat"]
    assert [path.name for path in real.parent.iterdir()] == ["flat"]


def test_a_link_to_itself_is_refused(tmp_path: Path) -> None:
    (tmp_path / "flat").symlink_to("flat")
    with pytest.raises(MansionError, match="broken link"):
        Workspace(tmp_path / "flat", REQUEST)
