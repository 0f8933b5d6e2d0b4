"""The gallery shows every system on each page, names none, and its key undoes the shuffle."""

import msgspec
import pytest

from mansion_export.pictures.gallery import Answer, GalleryKey, gallery_files, tally
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.placement import PlacedObject, PlacementObject, PlacementOpening, PlacementResult, PlacementRoom


def room(name: str) -> PlacementRoom:
    return PlacementRoom(
        room_id=name,
        room_type="private_office",
        polygon=[(0.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)],
        doors=[PlacementOpening(segment=((1.0, 0.0), (1.9, 0.0)))],
        windows=[PlacementOpening(segment=((1.0, 3.0), (2.5, 3.0)))],
        objects=[PlacementObject(name="desk", category="office_desk", size=(1.4, 0.7, 0.75))],
    )


def placed(name: str, x: float) -> PlacementResult:
    desk = PlacedObject(id="d", name="desk", center=(x, 2.0), rotation=0.0, size=(1.4, 0.7, 0.75))
    return PlacementResult(room_id=name, placements=[desk])


ROOMS = [room(f"office_{number}") for number in range(4)]
SYSTEMS = {
    "secret_one": [placed(entry.room_id, 1.0) for entry in ROOMS],
    "secret_two": [placed(entry.room_id, 2.0) for entry in ROOMS],
    "secret_three": [placed(entry.room_id, 3.0) for entry in ROOMS[:3]],
}


@pytest.fixture(scope="module")
def files():
    return gallery_files(ROOMS, SYSTEMS, seed=3)


def test_only_rooms_that_all_systems_placed_are_shown_in_an_order_of_their_own(files):
    key = msgspec.json.decode(files["key.json"], type=GalleryKey)
    assert [page.room_id for page in key.pages] == ["office_0", "office_1", "office_2"]
    assert all(sorted(page.panels.values()) == sorted(SYSTEMS) for page in key.pages)
    assert len({tuple(page.panels.values()) for page in key.pages}) > 1
    assert set(files) == {page.page for page in key.pages} | {"form.html", "key.json"}


def test_pages_and_form_name_no_system_and_ask_for_diversity_only_of_several_runs(files):
    text = files["form.html"].decode()
    assert "secret" not in text
    assert "page_01.png.realism" in text
    assert "page_01.png.diversity" not in text
    twice = {name: [*results, *results] for name, results in SYSTEMS.items()}
    both = gallery_files(ROOMS[:1], twice, seed=3)["form.html"].decode()
    assert "page_01.png.diversity" in both


def test_the_same_seed_gives_the_same_bytes_and_the_pictures_differ(files):
    assert files == gallery_files(ROOMS, SYSTEMS, seed=3)
    assert len({files[name] for name in files if name.endswith(".png")}) > 1


def test_answers_are_counted_for_the_system_behind_the_letter(files):
    key = msgspec.json.decode(files["key.json"], type=GalleryKey)
    answers = []
    for page in key.pages:
        letter = next(name for name, system in page.panels.items() if system == "secret_two")
        answers.append(Answer(page=page.page, choices={"realism": letter}))
    assert tally(answers, key)["realism"] == {"secret_one": 0.0, "secret_three": 0.0, "secret_two": 1.0}
    with pytest.raises(MansionError):
        tally([Answer(page="page_01.png", choices={"realism": "Z"})], key)


def test_one_system_is_no_comparison():
    with pytest.raises(MansionError):
        gallery_files(ROOMS, {"alone": SYSTEMS["secret_one"]})
