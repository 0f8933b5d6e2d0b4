"""What a brief says of things outside the building, and of itself, asks for nothing; what it could have does."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


def unread(text: str) -> str:
    return " | ".join(span.words for span in read_brief(text, default_knowledge()).unread)


@pytest.mark.parametrize(
    "text",
    [
        "Farmhouse in the Alps with three bedrooms",
        "Gin distillery near Oban. One storey",
        "Alpine refuge at 2,600 m altitude, three floors",
        "Emergency dispatch centre (112 calls): two storeys",
        "A clinic with two offices. Call 112 when there is a fire.",
        "Department of Linguistics, university building with five storeys",
        "An office with no cafeteria, the campus one is across the street.",
        "My budget is small: a house with two bedrooms",
        "Hostel called The Drowsy Otter, 5 floors",
        "House with no bathroom anywhere, it's 1790.",
        "Courtyard house for hot climate",
        "Theatre. A goods lift is needed for the sets.",
        "Our home has its own names for rooms. Label them so. Two bedrooms.",
        "Dear team, we are planning a research station. A sauna was in the first draft.",
        "Shelter for women with children, two storeys",
        "A swimming hall with a learner pool in its own room",
        "House in the Black Forest with two bedrooms",
        "Hotel on the seafront, 8 floors",
        "A house with two bedrooms. Please write the names in English in the drawing.",
        "Me and 3 friends want to share a house with two bathrooms",
        "Two bedrooms and a kitchen we share. A flat.",
        "Hi, my name is Petra and I teach in Graz. A house with a study.",
        "A house with a kitchen. My brother lives in Oslo and visits in summer.",
        "Good morning, I look for a house with two bedrooms. Best regards",
        "A flat with two bedrooms. Objects: one piano",
        "An apartment of five rooms, namely kitchen, living room, bedroom, bathroom and a corridor",
        "A clinic with a waiting room. The main hospital is in the next town, we only do day cases.",
        "A school with six classrooms. The swimming pool is at the other site, so none here.",
        "A house with two bedrooms for my parents, they are 75 and 80.",
        "I'm building a horror game level: a mansion with a library",
        "I need a test scene for a household robot: a flat with a kitchen",
        "We are building our retirement place near the coast. One storey, with a kitchen with space for a bed",
        "Hi, we search a shared house with two bedrooms",
        "Cabin in woods, one bedroom",
        "A house with two bedrooms. Pets: two cats.",
        "Test world for a delivery robot: an office with a reception",
        "A café with a kitchen. Warm colours.",
        "Mansion for a footballer and his family: three floors",
        "A house with two bedrooms and a lift, at first we wanted a slide. Sorry, wrong form.",
    ],
)
def test_remarks_ask_for_nothing(text: str) -> None:
    assert unread(text) == ""


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("House with a study and a ha-ha in the garden", "garden"),
        ("An office with 3 phone boxes", "3 phone boxes"),
        ("A ballet school with two studios and a barre", "barre"),
        ("House from shipping containers", "shipping containers"),
        ("Care home with three households called Rose, Oak and Lake", "Rose"),
        ("An apartment of six rooms, namely kitchen, living room, bedroom and bathroom", "six"),
        ("A house. The street side is for the shop", "street side"),
    ],
)
def test_what_a_building_could_have_is_told_of(text: str, words: str) -> None:
    assert words in unread(text)


def test_what_people_do_together_is_no_relation() -> None:
    text = "A clinic with a pharmacy, and a staff kitchen where shifts eat together."
    assert read_brief(text, default_knowledge()).adjacent == []
