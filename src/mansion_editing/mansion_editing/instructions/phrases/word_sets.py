"""Groups of words that clauses, ways, questions and sentences are told apart by, each with its meaning."""

from typing import Final

__all__ = [
    "ABILITIES",
    "AFTER_CHECKS",
    "AFTER_CLAUSES",
    "AFTER_COUNTED",
    "AFTER_MODALS",
    "AFTER_NEGATED",
    "AFTER_PURPOSES",
    "AFTER_REASONS",
    "AFTER_STAYING",
    "AFTER_THANKS",
    "AFTER_WHAT",
    "AFTER_WHERE",
    "AFTER_WHICH_ROOMS",
    "ALL_THE_REST",
    "ALONG_WAYS",
    "ANY_LONGER",
    "ASSURING",
    "AWAY",
    "BACK_IN_PLACE",
    "BARE_PRONOUNS",
    "BEFORE_ALL_OF",
    "BEFORE_AREAS",
    "BEFORE_ASKED_STATES",
    "BEFORE_COLOURS",
    "BEFORE_COLOUR_WORDS",
    "BEFORE_COUNTED",
    "BEFORE_DOORS",
    "BEFORE_ENDS_OF_WAYS",
    "BEFORE_NAMES",
    "BEFORE_PLACES",
    "BEFORE_PREDICATES",
    "BEFORE_REQUESTS",
    "BEFORE_SPOTS",
    "BEFORE_STATES",
    "BEFORE_STOREYS",
    "BEFORE_SURFACES",
    "BEFORE_VERBS",
    "DOOR_KINDS",
    "BEFORE_WISHES",
    "BEGIN_CLAUSES",
    "BEING_SOMEWHERE",
    "BESIDE_RELATIONS",
    "BETWEEN_CLAUSES",
    "CHANGED",
    "DIRECTIONS",
    "DISTURBING",
    "EARLIER_STEPS",
    "EVENTS",
    "EXISTENCE",
    "FAILING",
    "FREE_WAYS",
    "GOING",
    "GOING_OR_WAYS",
    "GOING_SOMEWHERE",
    "GOOD_AS_IT_IS",
    "HAVING",
    "HEADINGS",
    "JOINING",
    "KEPT_AS_IT_IS",
    "LEFT_ALONE",
    "LEFT_AS_IT_IS",
    "LEFT_SO",
    "LYING",
    "MASSES",
    "NEAR_SPOTS",
    "NOT_MEANT",
    "NO_FRONTED_PLACES",
    "OPEN_QUESTIONS",
    "OPEN_TO_ALL",
    "OUTER_DOORS",
    "PAIRED",
    "OPINIONS",
    "PAST_VERBS",
    "PEOPLE",
    "PRAISE",
    "PREDICATE_VERBS",
    "PRINTED",
    "PROPERTIES",
    "RELATIVES",
    "RESTING_VERBS",
    "ROLLING",
    "TELLING_WHERE",
    "SOMEBODY",
    "SO_DOING",
    "STAYING",
    "STAYING_AS_IT_IS",
    "THIRD_PERSON_WISHES",
    "TOPICS",
    "TOLD_EXISTENCE",
    "TOWARDS",
    "WANTING",
    "WAYS",
    "WHOLES",
    "WISHES",
]

# Asking, wishing and judging

OPINIONS: Final = frozenset("think believe guess feel suggest propose ask hope".split())
WISHES: Final = frozenset("like love want need prefer require have wish expect fancy appreciate".split())
THIRD_PERSON_WISHES: Final = frozenset("wants want needs need likes requires expects lacks".split())
BEFORE_WISHES: Final = frozenset("really also just do still ve d ll".split())
BEFORE_REQUESTS: Final = frozenset("please maybe just also perhaps kindly possibly be so kind as to mind".split())
AFTER_MODALS: Final = frozenset("be go get have stand move come face lie sit hang stay rest disappear".split())
ANY_LONGER: Final = frozenset("any more anymore at all there longer".split())
AFTER_CHECKS: Final = frozenset("that whether if for to , :".split())
EXISTENCE: Final = frozenset("be is are was were to need has have not also always ought supposed no longer".split())
TOLD_EXISTENCE: Final = frozenset("there is are no not currently still".split())
PRAISE: Final = frozenset("nice good great lovely fine helpful appreciated perfect ideal welcome".split())
PEOPLE: Final = frozenset(
    "guest visitor client customer patient person staff user child nurse employee teacher student pupil colleague "
    "manager boss director chef cook waiter tenant neighbour neighbor cleaner receptionist officer family grandma "
    "grandpa mother father mum dad son daughter doctor mayor secretary caretaker janitor librarian coach trainer "
    "instructor baker barista bartender dentist surgeon therapist architect engineer designer developer intern trainee "
    "apprentice headmaster headmistress principal professor researcher scientist curator landlord landlady owner clerk "
    "cashier inspector auditor accountant lawyer granny grandad auntie aunt uncle cousin husband wife partner toddler "
    "teenager team crew lodger flatmate housemate roommate class party delivery porter coordinator commander "
    "warden".split()
)
SOMEBODY: Final = frozenset("robot agent i we one guest visitor people everyone whoever someone subject".split())

# Clauses and subjects

BEFORE_VERBS: Final = frozenset("please then also just not never do finally".split())
BEGIN_CLAUSES: Final = frozenset("there i we you nothing make let if because nobody".split())
PREDICATE_VERBS: Final = frozenset(
    "is are stay remain need has have go get belong come lack want face become suffice".split()
)
AFTER_THANKS: Final = frozenset("you very so much a lot in advance for your help".split())
BEFORE_PREDICATES: Final = frozenset(
    "to not also always never do does now all both still get longer each supposed going itself themselves has have no "
    "just only".split()
)
WANTING: Final = frozenset("need require lack get want deserve miss missing keep".split())
BEING_SOMEWHERE: Final = frozenset("belong come sit stand lie live rest hang".split())
FAILING: Final = frozenset(
    "died broke fell leaks squeaks smells wobbles cracked burst wobble squeak smell leak flicker flickers rattle "
    "rattles creak creaks stink stinks drip drips".split()
)
BEFORE_COLOURS: Final = frozenset("be is are in get painted have become turn made".split())
BEFORE_STATES: Final = frozenset("switched turned left kept powered standing both all wide fully be always ,".split())
DISTURBING: Final = frozenset("touch disturb alter bother affect move break mess".split())
AFTER_NEGATED: Final = frozenset("on off any more either yet at all anymore there away".split())

# What stays, goes back or goes away

ALL_THE_REST: Final = frozenset("everything else all the other thing rest of it anything".split())
LEFT_ALONE: Final = frozenset("as where alone unchanged untouched in like".split())
LEFT_AS_IT_IS: Final = frozenset("as where alone unchanged untouched in place it is they are".split())
LEFT_SO: Final = frozenset("switched turned standing wide fully both all".split())
KEPT_AS_IT_IS: Final = frozenset(
    "alone as where it they is are untouched in place be there unchanged exactly like that stand the way was".split()
)
STAYING_AS_IT_IS: Final = frozenset("put there here as it is where they are untouched alone in on place".split())
CHANGED: Final = frozenset(
    "change changed moved touched altered disturbed replaced modified rearranged moving touching changing".split()
)
GOOD_AS_IT_IS: Final = frozenset("fine good ok okay alright perfect great".split())
ASSURING: Final = frozenset("also too naturally obviously definitely certainly please simply still".split())
AFTER_STAYING: Final = frozenset(
    "put out up here inside so the same dark locked empty dry now still always also too this".split()
)
NOT_MEANT: Final = frozenset("affected concerned included involved meant touched".split())
LYING: Final = frozenset("lying standing sitting hanging lie stand sit hang".split())
RESTING_VERBS: Final = frozenset("is are lies stands sits hangs".split())
SO_DOING: Final = frozenset("do does is are shall should may".split())
STAYING: Final = frozenset("stay remain fine untouched unchanged alone".split())
BACK_IN_PLACE: Final = frozenset("where it they was were to in its the place there again".split())
AWAY: Final = frozenset("away out off completely altogether entirely too".split())
EARLIER_STEPS: Final = frozenset(
    "the that it this last latest previous my your edit change step one instruction thing what you did just again "
    "recent most action have done both two three all step".split()
)

# Rooms, surfaces and sizes

PROPERTIES: Final = frozenset("colour color name material type kind use".split())
BEFORE_COLOUR_WORDS: Final = frozenset("a an the new in light dark pale bright deep soft to of as made".split())
BEFORE_SURFACES: Final = frozenset("the all its a whole four every".split())
BEFORE_NAMES: Final = frozenset('to as into " the be called named :'.split())
BEFORE_DOORS: Final = frozenset("a an another the new connecting internal one extra".split())
BEFORE_AREAS: Final = frozenset(", by to about of around up at an another extra roughly approximately".split())
TOWARDS: Final = frozenset("to towards toward so that it face at is they and facing them".split())
NO_FRONTED_PLACES: Final = frozenset("next back there here second first third".split())

# Ways

WAYS: Final = frozenset("way path route access door doorway passage".split())
ROLLING: Final = frozenset("wheelchair pram pushchair stroller trolley cart bed".split())
"""What has to get from room to room on its wheels."""
GOING_SOMEWHERE: Final = frozenset("be get go walk drive reach travel come move enter roll".split())
ABILITIES: Final = frozenset("can could able possible must should may has have need will".split())
DIRECTIONS: Final = frozenset(
    "to from into in inside through around up down over all out there everywhere anywhere across freely back "
    "upstairs towards straight safely easily between".split()
)
GOING: Final = frozenset("get go walk drive travel come navigate move pass roll".split())
ALONG_WAYS: Final = frozenset(
    "all the way leading down up over through straight that leads lead clear free open unobstructed around easily "
    "safely still always directly back".split()
)
BEFORE_ENDS_OF_WAYS: Final = frozenset("to into towards inside and , in".split())
FREE_WAYS: Final = frozenset(
    "be is are clear free open possible without being blocked stay there unobstructed should must obstacle any by "
    "robot on foot a".split()
)
GOING_OR_WAYS: Final = frozenset("get go walk drive travel come navigate move reach enter way path route".split())

# Amounts and places

WHOLES: Final = frozenset("all both every each everything any either".split())
BEFORE_ALL_OF: Final = frozenset("of the these those my our your their".split())
BARE_PRONOUNS: Final = frozenset("this that these those both another all each".split())
BEFORE_SPOTS: Final = frozenset("the a an one any far back free main front room".split())
BEFORE_PLACES: Final = frozenset(
    "somewhere anywhere just right directly all still already currently straight exactly".split()
)
NEAR_SPOTS: Final = frozenset("over by at next near beside close to in opposite under right against".split())
PAIRED: Final = frozenset("scissors pliers tongs tweezers headphones binoculars".split())
MASSES: Final = frozenset(
    "beer wine milk juice water cola alcohol coffee tea cheese butter bread food fruit medicine paper sugar salt "
    "rubbish furniture stuff".split()
)
OUTER_DOORS: Final = frozenset("front main entrance outside outer exterior house street".split())
DOOR_KINDS: Final = {
    "balcony": "balcony",
    "patio": "balcony",
    "garage": "garage",
    "double": "double",
    "glass": "glazed",
}
BEFORE_STOREYS: Final = frozenset("the all both each every our of".split())

# Sentences around clauses

BETWEEN_CLAUSES: Final = frozenset(
    "also now then just simply finally afterwards again too meanwhile next first and but so quickly immediately "
    "kindly maybe perhaps once still already today asap else as well there here back together instead "
    "carefully neatly nicely thus therefore yet while plus for".split()
) | frozenset([",", "-", "*", ":", ".", ")", "(", "!", '"', "\n", "?", ";"])
RELATIVES: Final = frozenset("my our one somebody her his their daughter son mother father boss".split())
AFTER_REASONS: Final = frozenset("i we the they it there my our he she".split())
AFTER_PURPOSES: Final = frozenset("that we i they people the it everyone guest nobody".split())
PAST_VERBS: Final = frozenset(
    "is are was were has have had will like likes stole came got said left arrive arrives visit".split()
)
HEADINGS: Final = frozenset("thing state task list step change order room scene set data shot setup".split())
JOINING: Final = frozenset("and but then while plus so &".split())
AFTER_CLAUSES: Final = frozenset(
    "too also again instead anymore altogether now there here already completely together each only ) first back "
    "neatly nicely somewhere asap today overnight both either yet visible properly immediately away".split()
)

# Questions

BEFORE_COUNTED: Final = frozenset("all the everything number of what is are me thing object".split())
OPEN_QUESTIONS: Final = frozenset("is are do does has have was were can could there any".split())
HAVING: Final = frozenset("have has got contain hold already still include get need".split())
AFTER_COUNTED: Final = frozenset(
    "there do does we have has i got you find it exist in total altogether currently now right at moment the".split()
)
AFTER_WHERE: Final = frozenset("can i find do we have does one did leave put my you keep see".split())
AFTER_WHICH_ROOMS: Final = frozenset("have has contain hold there do can i find with that".split())
AFTER_WHAT: Final = frozenset(
    "object thing item furniture there kind of else stand lie sit all can i see do we have".split()
)
BEFORE_ASKED_STATES: Final = frozenset(
    "currently still already switched turned all now either completely really".split()
)

BESIDE_RELATIONS: Final = frozenset("beside near left right behind front".split())
"""Relations of what stands on the same floor or surface as its anchor."""

EVENTS: Final = frozenset(
    "meeting training workshop interview class course lesson rehearsal party dinner lunch breakfast audit visit "
    "inspection conference seminar presentation exam drill delivery event birthday".split()
)
"""What takes place in rooms, some of which are called after it."""

TOPICS: Final = frozenset(
    "law legal history art science math maths physic chemistry biology geography language english french german "
    "spanish music poetry travel cook cooking cookery comic story fairytale tax medical fashion sport sports nature "
    "gardening business trade reference philosophy religion economic".split()
)
"""What printed things are about, which no scene records: ``law books``, ``fashion magazines``."""

PRINTED: Final = frozenset("book magazine newspaper folder notebook journal poster brochure textbook".split())

OPEN_TO_ALL: Final = frozenset("day evening night house week".split())
"""What ``open`` is no state of: ``open day on Saturday``."""

TELLING_WHERE: Final = frozenset("is are lies lie stands stand sits hangs hang lives live rests was were".split())
"""Verbs that say where something is or was, as they are written."""
