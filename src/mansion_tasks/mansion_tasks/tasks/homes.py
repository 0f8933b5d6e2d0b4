"""Where kinds of things are used or kept: the rooms to which somebody would have them brought.

Room types are matched by their end (``open_office`` is an office), as the catalogue's room programs name them.
"""

from collections.abc import Iterable
from typing import Final

__all__ = ["at_home_in"]

_GROUPS: Final = {
    "eating": (
        "kitchen kitchenette break_room cafe cafeteria dining_room dining_hall restaurant bar canteen food_court "
        "pantry staff_room teachers_room coffee_room dining_area"
    ),
    "meeting": (
        "lobby reception lounge living_room meeting_room conference_room boardroom waiting_room common_room team_room "
        "atrium vip_room family_room foyer business_center"
    ),
    "desks": (
        "office classroom study study_room library library_room reading_room book_stacks computer_lab training_room "
        "team_room coworking_area nurse_station reception consultation_room studio_room security_room control_room "
        "teachers_room business_center workspace principal_office phone_booth art_room music_room lecture_hall"
    ),
    "machines": "print_room server_room mail_room copy_room radiology_room recording_studio",
    "beds": (
        "bedroom nursery hotel_room guest_room hotel_suite dormitory patient_room nap_room on_call_room recovery_room "
        "dorm_room"
    ),
    "homes": "apartment hotel_suite flat loft",
    "lounging": "living_room lounge common_room family_room home_theater game_room",
    "care": (
        "patient_room treatment_room nurse_station nurse_office emergency_room triage_room consultation_room exam_room "
        "operating_room pharmacy icu recovery_room dental_room scrub_room sterilization_room ward radiology_room"
    ),
    "washing": "bathroom restroom toilet shower_room washroom ensuite powder_room wc shower scrub_room changing_room",
    "stores": (
        "storage storage_room closet garage workshop utility_room janitor_closet warehouse mechanical_room "
        "maintenance_room boiler_room"
    ),
    "laundry": "laundry_room housekeeping_room linen_room",
    "wraps": "cloakroom walk_in_closet locker_room luggage_room changing_room stroller_room",
    "play": "playroom kindergarten_classroom nursery childrens_area game_room nap_room",
    "sport": "gym home_gym fitness_room sports_hall",
    "labs": "lab laboratory science_lab",
    "shops": "shop store boutique supermarket",
    "showing": "gallery exhibition_hall museum_hall",
    "post": "mail_room reception lobby office",
}
"""Ends of room types."""

_KEPT: Final = {
    "chilled": "eating homes",
    "food": "eating homes shops",
    "drink": "eating meeting desks beds homes care",
    "baked": "eating homes",
    "tableware": "eating homes",
    "cookware": "eating homes",
    "stationery": "meeting desks machines homes post labs",
    "reading": "meeting desks beds homes lounging showing",
    "medical": "care beds",
    "lab": "labs",
    "cultures": "labs",
    "bath": "washing homes laundry",
    "linen": "beds homes lounging laundry care",
    "towels": "washing laundry homes",
    "clothing": "beds homes wraps",
    "personal": "meeting desks beds homes lounging",
    "toy": "play homes lounging bedroom",
    "sport": "sport play wraps stores",
    "tool": "stores",
    "decor": "meeting desks eating beds homes lounging showing shops",
    "post": "post stores machines",
    "device": "desks machines meeting_room conference_room boardroom homes lounging",
}
"""From a kind to the groups of rooms in which it is used or kept."""

_ROOMS: Final = {
    kind: tuple(end for group in groups.split() for end in _GROUPS.get(group, group).split())
    for kind, groups in _KEPT.items()
}
_KNOWN: Final = tuple(end for ends in _GROUPS.values() for end in ends.split())
_PASSED: Final = ("corridor", "hallway", "hall", "wing", "entryway", "passage", "vestibule", "aisle")
"""Rooms that people only walk through."""


def at_home_in(kinds: Iterable[str], room_type: str) -> bool:
    """Whether one of some kinds is used or kept in a room; in rooms of an unknown type anything may be.

    Examples
    --------
    >>> at_home_in(["personal"], "private_office"), at_home_in(["personal"], "commercial_kitchen")
    (True, False)
    """
    if not room_type.endswith(_KNOWN):
        return not room_type.endswith(_PASSED)
    return any(room_type.endswith(_ROOMS.get(kind, ())) for kind in kinds)
