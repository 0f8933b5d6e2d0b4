"""Plan fuzzed briefs: each ends as a plan or as a documented refusal.

``fuzz_briefs.py tests/briefs/briefs.json --count 1000``
"""

import argparse
import json
import time
import traceback
from pathlib import Path

import numpy as np

from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building

ODD = [
    "",
    "\x00\x01\x07",
    "🏢🏠🚪",
    "医院 十层 大楼",
    "мебель дом",
    "مستشفى",
    "١٢ طابق",
    "999999999999 floors",
    "-3 floors",
    "0 floors",
    "0 m2",
    "1e309 m2",
    "floor " * 50,
    "no " * 80,
    "1,2,3,4 floors of of of",
    "½ floor",
    "L-shaped U-shaped",
    ") ( ; : , . -",
    "ﬁrst ﬂoor",
    "İstanbul İ",
    "a\u200bfour\u200bstorey",
    "4" * 200,
    "m2 m2 m2",
    "top floor basement roof every floor",
    "10000 bedrooms",
    "a 90000 m2 bedroom",
    "500 toilets in a flat of 20 m2",
    "\n\n\n\t",
]


def fuzzed(generator: np.random.Generator, briefs: list[str]) -> str:
    """Return a brief made of others by mixing, cutting, misspelling and odd characters."""
    text = briefs[int(generator.integers(len(briefs)))]
    kind = int(generator.integers(8))
    other = briefs[int(generator.integers(len(briefs)))]
    if kind == 0:
        return ODD[int(generator.integers(len(ODD)))]
    if kind == 1:
        words = (text + " " + other).split()
        return " ".join(words[int(i)] for i in generator.permutation(len(words)))
    if kind == 2:
        return text[: int(generator.integers(len(text) + 1))]
    if kind == 3:
        return text + ". " + other
    if kind == 4:
        letters = list(text)
        for _ in range(max(1, len(letters) // 12)):
            letters[int(generator.integers(len(letters)))] = chr(int(generator.integers(32, 0x2FA0)))
        return "".join(letters)
    if kind == 5:
        return text + ODD[int(generator.integers(len(ODD)))]
    if kind == 6:
        words = text.split()
        return " ".join(words[int(i)] for i in generator.integers(len(words), size=200))
    count = int(generator.integers(1, 400))
    return " ".join(briefs[int(i)] for i in generator.integers(len(briefs), size=count // 10 + 1))[:60_000]


def main() -> None:
    """Plan the fuzzed briefs and count how they end."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("corpus", type=Path)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=0)
    options = parser.parse_args()
    briefs = [entry["brief"] for entry in json.loads(options.corpus.read_text())]
    generator = np.random.default_rng(options.seed)
    ends: dict[str, int] = {}
    crashes, slowest = 0, 0.0
    for _ in range(options.count):
        text = fuzzed(generator, briefs)
        begin = time.process_time()
        try:
            plan_building(BuildRequest(description=text, seed=int(generator.integers(100))))
            end = "planned"
        except MansionError as error:
            end = error.code
        except Exception:
            end = "crash"
            crashes += 1
            print(repr(text[:300]))
            traceback.print_exc(limit=-3)
        slowest = max(slowest, time.process_time() - begin)
        ends[end] = ends.get(end, 0) + 1
    print(", ".join(f"{name} {count}" for name, count in sorted(ends.items())))
    print(f"crashes: {crashes}; slowest: {slowest:.2f} s of processor time")


if __name__ == "__main__":
    main()
