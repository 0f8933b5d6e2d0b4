"""Read a brief: storeys, areas, building type, rooms and wishes, each from the words that state it."""

from mansion_knowledge import KnowledgeBase
from mansion_planner.brief.areas import read_areas
from mansion_planner.brief.building import read_building
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.brief.finishes import read_materials, read_style
from mansion_planner.brief.neighbours import read_adjacency, repeated_mentions
from mansion_planner.brief.places import find_places
from mansion_planner.brief.quantities import read_floor_counts, read_occupants
from mansion_planner.brief.reading import start_reading
from mansion_planner.brief.rooms import read_rooms
from mansion_planner.brief.stacking import read_stacking
from mansion_planner.brief.wishes import read_copies, read_exclusions, read_massing, read_shape, read_vertical

__all__ = ["read_brief"]


def read_brief(text: str, knowledge: KnowledgeBase) -> BriefFacts:
    """Return what `text` states; never raises, whatever the text.

    Parameters
    ----------
    text : str
        English, any length; words of other scripts are passed over.
    knowledge : KnowledgeBase
        Gives the names of rooms, buildings and styles.

    Examples
    --------
    >>> from mansion_knowledge import default_knowledge
    >>> facts = read_brief("A two-storey house with three bedrooms", default_knowledge())
    >>> [quantity.value for quantity in facts.floors], facts.building[0][0]
    ([2.0], 'house')
    >>> [(room.room_type, room.count) for room in facts.rooms]
    [('bedroom', 3)]
    """
    reading = start_reading(text, knowledge)
    read_materials(reading)
    read_shape(reading)
    read_vertical(reading)
    read_massing(reading)
    read_exclusions(reading)
    read_floor_counts(reading)
    places = find_places(reading)
    read_copies(reading, places)
    read_stacking(reading)
    read_building(reading, places)
    read_style(reading)
    read_areas(reading)
    read_occupants(reading)
    read_adjacency(reading)
    read_rooms(reading, places, repeated_mentions(reading))
    return reading.facts
