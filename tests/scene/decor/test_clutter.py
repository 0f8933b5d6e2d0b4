"""Many, usual and few things lie about, on the same furniture."""

from itertools import pairwise

from mansion_assets.catalogue import load_catalogue
from mansion_scene.decor.clutter import with_clutter


def test_what_is_always_there_and_place_settings_stay() -> None:
    for arrangement in load_catalogue().arrangements.values():
        for clutter in ("sparse", "dense"):
            (other,) = with_clutter([arrangement], clutter)
            assert other.seats == arrangement.seats
            sure = [slot for slot in arrangement.slots if slot.p == 1.0]
            assert all(slot in other.slots for slot in sure)


def test_scattered_things_are_fewer_usual_and_more() -> None:
    for arrangement in load_catalogue().arrangements.values():
        levels = [with_clutter([arrangement], "sparse")[0], arrangement, with_clutter([arrangement], "dense")[0]]
        amounts = [sum(s.p * (s.min + s.max) / 2 for s in level.scatter) for level in levels]
        assert all(few <= more for few, more in pairwise(amounts)), arrangement.name
