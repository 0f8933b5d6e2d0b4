"""Training list of phrasings: ``{a}`` is an object with its number, ``{on}`` a place with its preposition.

The parser was mended on them. Each list is for one kind of case of `varied.py`, which fills its words from a building.
"""

PLACE = [
    "There ought to be {a} {on}.",
    "Could you put {a} {on}, please?",
    "{A} should be {on}.",
    "I need {a} {on}.",
    "Please see to it that {a} is {on}.",
    "We're missing {a} {on}.",
    "{A} belongs {on}.",
    "Let there be {a} {on}.",
    "Make certain that there's {a} {on}.",
    "{A} must be lying {on}.",
    "I'd like {a} {on}, thanks.",
    "Leave {a} {on}.",
    "Would you kindly set {a} down {on}?",
    "There has to be {a} {on}!",
    "{A} is supposed to be {on}.",
    "Have {a} {on}.",
    "Check whether there is {a} {on}, and if not, add one.",
    "If there is no {n} {on}, put one there.",
    "Go ahead and place {a} {on}.",
    "{On}, there must be {a}.",
    "{On} I want {a}.",
    "The robot will look for it later, so make sure {a} is {on}.",
    "Someone should find {a} {on}; please provide it.",
    "Ensure the presence of {a} {on}.",
    "You should lay {a} {on}.",
    "We want {a} to be {on}.",
    "It is important that there is {a} {on}.",
    "Drop {a} {on}.",
    "{A} {on}, please.",
    "Verify that {a} can be found {on}.",
    "Deposit {a} {on} because the guests arrive soon.",
]
HOLD = [
    "{Y} should have {a} on it.",
    "{Y} needs {a}.",
    "{Y} lacks {a}.",
    "Provide {y} with {a}.",
    "{Y} must hold {a}.",
    "Equip {y} with {a}.",
    "Make sure {y} has {a} on it.",
    "I want {y} to have {a} on it.",
    "Give {y} {a}.",
]
TWO = [
    "Put {a} and {b} {on}.",
    "{A} and {b} should be {on}.",
    "There ought to be {a} as well as {b} {on}.",
    "I'd like {a} plus {b} {on}.",
    "Make sure that both {a} and {b} are {on}.",
    "Add {a} {on}, and {b} too.",
    "{Y} should carry {a} and {b}.",
    "Place {a} {on}. Then place {b} there as well.",
    "Set {a} {on}; {b} belongs {on} too.",
    "We need {a} {on} and also {b}.",
]
SEVERAL = [
    "Put two {colour} {ns} {on}.",
    "There should be a couple of {colour} {ns} {on}.",
    "A pair of {colour} {ns} ought to be {on}.",
    "Make sure at least two {colour} {ns} are {on}.",
    "I want two {ns} {on}, and they must be {colour}.",
    "2 {colour} {ns} belong {on}.",
    "{Y} needs two {colour} {ns}.",
    "Have two {colour}-coloured {ns} {on}.",
]
COLD = [
    "Make sure {y} contains a cold {n} and that I can get to {room}.",
    "There has to be a chilled {n} in {y}, and {room} must be reachable.",
    "Stock {y} with a cold {n} and make sure the robot can reach {room}.",
    "I'd like a cold {n} waiting in {y} and a clear path to {room}.",
    "A cold {n} should be in {y}. {Room} has to be accessible as well.",
    "Put a {n} into {y}, and check that there's a route to {room}.",
    "Is there a cold {n} in {y}? There should be. And I need to be able to walk to {room}.",
]
ABSENT = [
    "There shouldn't be any {ns} {on}.",
    "Get rid of every {n} {on}.",
    "No {ns} should be left {on}.",
    "{Y} must not have any {ns} on it.",
    "Take all {ns} off {y}.",
    "Throw away the {ns} {on}.",
    "Please remove each {n} from {y}.",
    "Don't leave any {ns} {on}.",
    "Keep {y} free of {ns}.",
    "Clear {y} of {ns}.",
    "All the {ns} {on} must go.",
    "Make sure that no {n} remains {on}.",
    "The {ns} {on} should be removed.",
]
EMPTY = [
    "{Y} must be empty.",
    "Clear {y}.",
    "Nothing should be on {y}.",
    "Empty {y} completely, please.",
    "Remove everything from {y}.",
    "I want {y} to be cleared.",
    "Tidy up {y}.",
    "Make sure nothing is left on {y}.",
]
OPEN = [
    "{Y} should be open.",
    "Leave {y} open.",
    "I'd like {y} to be open.",
    "Make sure {y} is open.",
    "Please open {y}.",
    "{Y} must stand open.",
    "Have {y} opened.",
]
ON = [
    "Switch {y} on.",
    "Turn on {y}.",
    "{Y} should be switched on.",
    "Make sure {y} is turned on.",
    "I want {y} on.",
    "Could you turn {y} on?",
]
WAY = [
    "Everyone should be able to reach {b} from {a}.",
    "Is there a way from {a} to {b}? There must be.",
    "{B} has to be accessible from {a}.",
    "Make sure nothing blocks the way from {a} to {b}.",
    "A robot must be able to drive from {a} to {b}.",
    "Ensure a clear path between {a} and {b}.",
    "I want to be able to walk from {a} to {b}.",
    "It must be possible to get from {a} to {b}.",
    "Keep the route from {a} to {b} open.",
    "Verify that {b} can be reached from {a}.",
    "There should be a connection from {a} to {b}.",
]
MOVE = [
    "Take the {n} from {y} to {z}.",
    "The {n} on {y} should be moved to {z}.",
    "Bring the {n} on {y} to {z}.",
    "Move the {n} from {y} onto {z}.",
    "Relocate the {n} on {y} to {z}, please.",
    "Carry the {n} over from {y} to {z}.",
    "Shift the {n} on {y} to {z}.",
    "Put the {n} from {y} on {z}.",
    "Could you transfer the {n} on {y} to {z}?",
]
SWAP = [
    "Replace the {n} on {y} with {a}.",
    "Swap the {n} on {y} for {a}.",
    "Instead of the {n}, there should be {a} on {y}; remove the {n} from {y}.",
    "Remove the {n} from {y} and put {a} there.",
    "Exchange the {n} on {y} for {a}.",
    "Take the {n} off {y}, then place {a} on it.",
]
EXACT = [
    "There should be exactly {k} {ns} {on}.",
    "{Y} must have exactly {k} {ns} on it.",
    "I want precisely {k} {ns} {on}.",
    "Only {k} {ns} should be {on}.",
]
BESIDE = [
    "Put {a} next to the {n} {on}.",
    "{A} should be beside the {n} {on}.",
    "Place {a} right beside the {n} {on}.",
    "There ought to be {a} near the {n} {on}.",
    "Set {a} close to the {n} {on}.",
]
FURNISH = [
    "There should be a {colour} {f} in {room} with {a} on it.",
    "Put a {colour} {f} into {room} and place {a} on it.",
    "I want a {colour} {f} in {room}, and {a} should be on it.",
    "{Room} needs a {colour} {f} with {a} on top.",
]
MIXED = [
    "Put {a} {on}, open {y}, and make sure I can get to {room}.",
    "{A} should be {on}; {y} must be open and {room} reachable.",
    "Open {y}. Then put {a} {on}. Finally, check that there is a path to {room}.",
    "Make sure {y} is open, {a} is {on} and the robot can get to {room}.",
]
LEADING = [
    "In {room}, put {a} on the {c}.",
    "In {room} there should be {a} on the {c}.",
    "{Room} should have {a} on the {c}.",
    "Place {a} on the {c} of {room}.",
    "Put {a} on {room}'s {c}.",
]
