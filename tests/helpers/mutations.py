"""Damaged variants of documents and texts, drawn from a seed."""

import copy
import json
import math
import re

VALUES = (
    None, True, False, 0, -1, 1.5, math.nan, math.inf, 1e300, -1e300, 10**300, 2**63, "x", "", "\0", "1", "../..",
    [], {}, [1], [[1]], ["x"], {"a": 1}, [None], {"total": "x"},
)  # fmt: skip
"""Values that replace a document's."""
WORDS = ("x", "", "nan", "inf", "1e999", "9" * 400, "-1", "1.5", "[", "{", '"', ",", "---", "\0", "true", "ü")
"""Words that replace a text's."""


def mutated_json(text, rng):
    """JSON text with a few values replaced, or entries left out, added or moved; or as `mutated_text`."""
    if rng.random() < 0.15:
        return mutated_text(text, rng)
    document = json.loads(text)
    for _ in range(int(rng.integers(1, 3))):
        document = _changed(document, rng)
    return json.dumps(document)


def mutated_text(text, rng):
    """Text that is cut off, or in which a word is replaced or a line left out or repeated."""
    kind = int(rng.integers(4))
    if kind == 0:
        return text[: int(rng.integers(len(text)))]
    if kind == 1:
        lines = text.splitlines(keepends=True)
        at = int(rng.integers(len(lines)))
        return "".join(lines[:at] + lines[at : at + 1] * int(rng.choice([0, 2])) + lines[at + 1 :])
    words = list(re.finditer(r"[\w.+-]+", text))
    word = words[int(rng.integers(len(words)))]
    return text[: word.start()] + WORDS[int(rng.integers(len(WORDS)))] + text[word.end() :]


def _changed(document, rng):
    document = copy.deepcopy(document)
    places = list(_places(document))
    if not places:
        return VALUES[int(rng.integers(len(VALUES)))]
    parent, key = places[int(rng.integers(len(places)))]
    kind = rng.random()
    if kind < 0.2:
        del parent[key]
    elif kind < 0.3:
        other, other_key = places[int(rng.integers(len(places)))]
        parent[key] = copy.deepcopy(other[other_key])
    else:
        parent[key] = copy.deepcopy(VALUES[int(rng.integers(len(VALUES)))])
    return document


def _places(value):
    """Containers of nested values and keys in them."""
    entries = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, entry in list(entries):
        yield value, key
        yield from _places(entry)
