"""Storeys to change, and what changing them needs."""

from collections.abc import Callable

import pytest

import sample_storeys
from mansion_assets.catalogue import Catalogue
from mansion_bringup.check import check_floors
from mansion_editing.structure import Storey, Workshop
from mansion_msgs_py.scene import FloorScene
from mansion_scene.refurnishing import furnish_room


@pytest.fixture(scope="session")
def office() -> Storey:
    """Return an office storey."""
    return sample_storeys.office()


@pytest.fixture(scope="session")
def flat() -> Storey:
    """Return a flat."""
    return sample_storeys.flat()


@pytest.fixture(scope="session")
def workshop_of(catalogue: Catalogue) -> Callable[[Storey], Workshop]:
    """Return what makes the workshop of a storey: the placer, and the independent check as its judge."""

    def make(storey: Storey) -> Workshop:
        known = set(_faults(storey.scene, storey))
        return Workshop(catalogue, furnish_room, lambda scene: [f for f in _faults(scene, storey) if f not in known])

    return make


def _faults(scene: FloorScene, storey: Storey) -> list[str]:
    """Return the faults of a scene; which doors it should have is what a change may change."""
    found = check_floors(scene.building_id, [scene], [storey.topology])
    return [str(fault) for fault in found if fault.kind != "DOOR_MISSING"]
