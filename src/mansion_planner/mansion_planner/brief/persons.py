"""Words for those who live, work or call somewhere, for the groups that they form and for what they try out there."""

from mansion_planner.brief.phrase import PEOPLE

__all__ = ["COLLECTIVES", "PERSONS", "PRONOUNS", "ROBOTS", "is_person"]

PERSONS = PEOPLE | frozenset(
    """
    mother father mum mom dad parent nan nana gran grandad granddad
    missus fiance fiancee grandparent grandmother grandfather grandma grandpa granny grandchild aunt uncle
    cousin nephew niece son daughter husband wife partner baby toddler teenager twin sibling relative
    couple pensioner retiree bachelor senior owner landlord neighbour neighbor host
    painter singer writer poet author sculptor potter gamer collector gardener
    solicitor accountant librarian director headteacher headmaster principal mayor imam vicar pastor pharmacist
    surgeon vet paramedic carer caregiver ambassador manager boss secretary receptionist assistant employer specialist
    trustee nun insurer investor founder freelancer
    entrepreneur professional expert everyone everybody nobody anyone someone personnel
    head chief mechanic carpenter electrician plumber farmer fisherman hunter shopkeeper trader seller buyer shopper
    reader
    cat dog kitten puppy
    planner commander captain sergeant officer colonel coach trainer instructor lecturer professor researcher scientist
    engineer technician architect lawyer attorney judge clerk cashier cook chef waiter bartender baker butcher brewer
    tailor hairdresser barber therapist psychologist midwife dentist surveyor inspector diplomat consul minister bishop
    conductor composer dj photographer editor journalist programmer developer designer consultant contractor builder
    plaintiff prisoner guard watchman caretaker janitor cleaner housekeeper volunteer intern apprentice trainee
    grandchildren cousins buddy mate colleague coworker roommate flatmate tenant
    footballer musician dancer actor sailor
    listener walker hiker skier cyclist runner athlete player fan lover enthusiast
    """.split()
)
"""Nouns for single people: who is there asks for nothing that a building could have, unless it is said how many."""

COLLECTIVES = frozenset(
    """
    team group company firm crew staff troupe ensemble choir orchestra society association committee charity
    cooperative collective startup practice community commune congregation
    """.split()
)
"""Nouns for people together, of whom a number may follow: "a team of twenty"."""

ROBOTS = frozenset({"robot", "drone", "agent", "rover", "quadruped", "humanoid", "cobot", "algorithm", "policy"})
"""What buildings are tried with; its errands ask for nothing that the building could have."""

PRONOUNS = frozenset({"i", "we", "they", "he", "she", "you", "who", "one"})
"""Subjects that are people."""


def is_person(word: str) -> bool:
    """Whether a word is a noun for a person."""
    return word in PERSONS
