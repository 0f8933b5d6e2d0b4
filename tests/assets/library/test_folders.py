"""Where libraries are."""

from pathlib import Path

import pytest

from mansion_assets.library.folders import known_libraries, libraries_root, library_folder, library_folders
from mansion_msgs_py.errors import ErrorCode, MansionError


def test_a_name_is_below_the_users_data_and_a_path_is_itself(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("MANSION_LIBRARIES", raising=False)
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    assert library_folder("shop") == tmp_path / "mansion" / "libraries" / "shop"
    assert library_folder("./shop") == Path("shop")
    monkeypatch.setenv("MANSION_LIBRARIES", str(tmp_path / "all"))
    assert libraries_root() == tmp_path / "all"


@pytest.mark.parametrize("name", ["", "..", "a b", ".hidden"])
def test_a_name_that_is_none_is_refused(name: str) -> None:
    with pytest.raises(MansionError) as caught:
        library_folder(name)
    assert caught.value.info.code == ErrorCode.INVALID_PAYLOAD


def test_a_library_that_is_not_there_is_told_with_those_that_are(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("MANSION_LIBRARIES", str(tmp_path))
    (tmp_path / "shop" / "assets").mkdir(parents=True)
    assert known_libraries() == ["shop"]
    assert library_folders(["shop"]) == ((tmp_path / "shop").resolve(),)
    with pytest.raises(MansionError, match="libraries: shop"):
        library_folders(["lab"])
