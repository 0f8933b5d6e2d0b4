"""Words that ask for nothing by themselves: when, why and how people do things, what they feel, say, own and pay."""

from functools import cache

from mansion_planner.brief.reading import Reading

__all__ = ["is_date_or_age", "is_idle", "is_idle_word"]

_TIMES = frozenset(
    """
    night
    monday tuesday wednesday thursday friday saturday sunday january february march april june july august september
    october november december spring summer autumn winter season day week weekend fortnight month year decade
    century hour minute morning noon afternoon evening tonight today tomorrow yesterday nowadays now currently soon
    later eventually sometime someday once twice abroad often sometimes usually mostly always never again already
    still yet ago meanwhile meantime finally lately recently formerly originally previously afterwards christmas
    easter ramadan holiday holidays vacation semester term shift deadline schedule timetable birthday anniversary
    wedding funeral
    """.split()
)
_TALK = frozenset(
    """
    hey hi hello quick dear greetings thanks thank cheers please regards sincerely faithfully right okay ok well anyway
    honestly frankly basically actually obviously clearly apparently supposedly incidentally btw fyi eh ah aha hm
    alas yeah yep nope sir madam respect pardon apology sorry bless god heaven word question answer story joke
    thus indulge leaflet brochure life
    advice opinion idea head how thought kind sort thing stuff matter lot bit bunch example instance fact point case
    detail way why how long reason respect obvious mind heart soul hand eye taste mood feeling feel atmosphere charm
    dream luck nonsense list brief email mail letter message note attachment maths math sum counted above-mentioned
    etc muddle mistake error hint tip favour favor promise
    """.split()
)
_FEELINGS = frozenset(
    """
    glad sad afraid scared worried nervous proud jealous angry mad crazy silly stupid clever wise lazy tired sick
    ill busy hungry thirsty alive asleep awake retired married divorced single-handed pregnant deaf blind stubborn
    fussy picky cool nice great good better best bad worse worst awful terrible horrible ugly boring weird odd
    strange funny excited keen fond happy grateful welcome sure certain unsure curious careful serious honest hard
    easy difficult important special famous wonderful unusual sensible reasonable able unable ready willing fine
    true wrong clear noisy loud smelly messy dirty dusty
    """.split()
)
_MONEY_AND_LAW = frozenset(
    """
    money budget cost price rent mortgage loan bank-loan euro dollar pound cent tax fee insurance grant subsidy
    invoice contract lawyer permit permission law rule regulation ministry municipality authority council-house
    investor business trade market demand revenue profit sale career job salary
    """.split()
)
_HAPPENINGS = frozenset(
    """
    noise smell fume dust mess risk danger contamination infection accident trouble problem complaint argument
    hassle war peace flood storm rain snow weather sun climate season health knee hip allergy disease stroke age
    youth childhood tradition culture religion faith history generation heritage memory lesson homework habit hobby
    game card music football tennis chess yoga penguin disability novel book poem painting film movie hobby sport
    theme
    """.split()
)
_VERBS = frozenset(
    """
    use work live stay sleep eat drink cook bake play sing dance read write study learn teach train practise
    practice visit come go arrive leave return travel move walk run drive ride cycle fly swim ski hike sit stand lie
    rest relax grow age turn become happen start begin finish end stop continue last wait watch look see hear listen
    talk speak say tell ask answer call phone mention explain promise agree argue complain shout laugh cry smile
    think believe know guess suppose expect assume wonder remember forget worry fear care mind matter love hate
    enjoy prefer hope decide choose try manage fail succeed win lose buy sell pay cost rent save spend earn afford
    own inherit found count calculate measure compare check test prove show hire employ retire marry divorce die
    pass raise bring take carry keep let help deserve suit fit belong depend mean build rebuild renovate demolish
    burn leak break outgrow inspire invent exist remain consist regret apologise apologize dispose boast photograph
    hide paint escape dream burst rescue support celebrate gather attend invite host join rejoin recover heal pray
    perform send accept approve refuse concentrate disturb spawn admit
    """.split()
)
_PAST = frozenset(
    """
    was were been had did done made went gone came left grew grown became began begun stood sat lay lain slept ate
    eaten drank drunk sang sung wrote written read taught thought knew known said told heard saw seen met found
    bought sold paid cost spent kept let brought took taken gave given got gotten won lost broke broken burnt built
    rebuilt outgrew outgrown fell fallen drove driven rode ridden flew flown swam swum ran run meant felt held sent
    set shut hurt changed
    """.split()
)
_RESEARCH = frozenset(
    """
    dataset datasets generating generate embodied qa vqa spec specs specification robot robots robotics simulation
    simulator benchmark benchmarks agent agents navigation episode episodes paper thesis objects altitude team draft
    insist insists picked
    """.split()
)
"""What researchers and people who plan say of their work, where it names no part of the building."""

_IDLE = _TIMES | _TALK | _FEELINGS | _MONEY_AND_LAW | _HAPPENINGS | _PAST | _RESEARCH

_ASKS = frozenset("building rest study practice end last set kept fixed".split())
"""Forms that may also say how rooms lie or how many there are."""

_FIRST_YEAR, _LAST_YEAR = 1500, 2100
_OLDEST = 115
_HOURS = 24
_AGED = frozenset({"is", "am", "are", "was", "aged", "age", "turn", "turns", "turned", "be", "'s", "s", "'m", "m"})
_YEAR_LEADS = frozenset(
    {"in", "since", "of", "from", "founded", "built", "established", "est", "before", "after", "by"}
)


def is_idle_word(word: str) -> bool:
    """Whether a word asks for nothing by itself: "Tuesday", "bless", "leaks", "outgrew".

    Examples
    --------
    >>> [is_idle_word(word) for word in ("leak", "leaks", "leaking", "outgrew", "sauna", "white")]
    [True, True, True, True, False, False]
    """
    return word not in _ASKS and (word in _IDLE or word in _inflected())


@cache
def _inflected() -> frozenset[str]:
    """Return the regular forms of the verbs."""
    forms = set(_VERBS)
    for verb in _VERBS:
        stem = verb[:-1] if verb.endswith("e") else verb
        doubled = verb + verb[-1]
        forms |= {f"{verb}s", f"{verb}es", f"{stem}ed", f"{stem}ing", f"{doubled}ed", f"{doubled}ing"}
        if verb.endswith("y"):
            forms |= {f"{verb[:-1]}ies", f"{verb[:-1]}ied"}
    return frozenset(forms)


def is_idle(reading: Reading, index: int) -> bool:
    """Whether a token asks for nothing by itself: an idle word, but for what a thing does or looks out on."""
    of_thing = reading.word(index - 1) in ("that", "which") and not is_idle_word(reading.word(index - 2))
    if of_thing or not is_idle_word(reading.word(index)):
        return False
    return not (reading.word(index).startswith("look") and reading.word(index + 1) in _OUTLOOKS)


_OUTLOOKS = frozenset({"onto", "over", "into", "towards", "toward", "out", "to"})


def is_date_or_age(reading: Reading, index: int) -> bool:
    """Whether a number is a year, or how old somebody is: "founded 1987", "she is 81"."""
    token = reading.tokens[index]
    value, before, after = token.value, reading.word(index - 1), reading.word(index + 1)
    if token.kind != "number" or value != int(value) or reading.kind(index + 1) == "unit":
        return False
    closes = reading.breaks(index + 1) or after in (",", ")", "and", "but", "so", "when")
    now = before in ("it", "is")
    if _FIRST_YEAR <= value <= _LAST_YEAR and closes and (before in _YEAR_LEADS or before == "(" or now):
        return True  # "founded 1987", "no bathroom, it's 1790"
    if before in ("at", "until", "till") and closes and value <= _HOURS:
        return True  # "we open at seven"
    if after in _SPANS or after == "h":
        return True  # "in three weeks", "three generations"
    if (
        before in ("over", "almost", "nearly", "past")
        and closes
        and reading.word(index - 2) in _BOTH
        and value <= _OLDEST
    ):
        return True  # "my parents (both over 70)"
    if before == "and" and reading.kind(index - 2) == "number" and closes:
        return is_date_or_age(reading, index - 2)
    old = _SENIOR <= value <= _OLDEST and closes
    if old and before in ("are", "is") and reading.word(index - 2) in ("they", "who"):
        return True  # "they are 75 and 80"
    aged = (before in _AGED or before in _SOMEBODY) and (closes or after == "year") and 1 < value <= _OLDEST
    return aged and (before in _SOMEBODY or _has_somebody(reading, index - 1))


_SENIOR = 50
"""Years from which on a bare number behind "they are" is no number of people."""
_BOTH = frozenset({"both", "are", "is", "all", "am"})
_SPANS = frozenset("day week weekend month year decade century hour minute night season generation shift time".split())
_SOMEBODY = frozenset(
    {"i", "he", "she", "mother", "father", "mum", "mom", "dad", "grandma", "grandpa", "aunt", "uncle"}
)


def _has_somebody(reading: Reading, index: int) -> bool:
    """Whether one person stands right before the verb at a token."""
    return reading.word(index) == "aged" or reading.word(index - 1) in _SOMEBODY
