"""Damaged variants of documents and texts, drawn from a seed."""

import copy
import json
import math
import re
from xml.etree import ElementTree

VALUES = (
    None, True, False, 0, -1, 1.5, math.nan, math.inf, 1e300, -1e300, 10**300, 2**63, "x", "", "\0", "1", "../..",
    [], {}, [1], [[1]], ["x"], {"a": 1}, [None], {"total": "x"},
)  # fmt: skip
"""Values that replace a document's."""
WORDS = ("x", "", "nan", "inf", "1e999", "9" * 400, "-1", "1.5", "[", "{", '"', ",", "---", "\0", "true", "ü")
"""Words that replace a text's."""
NUMBERS = (
    "", "0", "-1", "1", "1e-9", "1e9", "1e300", "-1e300", "nan", "inf", "1e999", "x", "0 0", "9" * 400, "fixed", "base",
    "floating", "mesh", "../../x.stl", "/etc/passwd", "package://x/y.stl",
)  # fmt: skip
"""Words that replace a word of an attribute."""


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


def mutated_xml(text, rng):
    """XML with an attribute replaced, or an element left out, repeated or moved; or as `mutated_text`."""
    if rng.random() < 0.2:
        return mutated_text(text, rng)
    root = ElementTree.fromstring(text)  # noqa: S314
    for _ in range(int(rng.integers(1, 4))):
        parents = [(parent, i) for parent in root.iter() for i in range(len(parent))]
        parent, i = parents[int(rng.integers(len(parents)))]
        node, kind = parent[i], rng.random()
        if kind < 0.1:
            parent.remove(node)
        elif kind < 0.2:
            parent.insert(i, copy.deepcopy(node))
        elif kind < 0.3:
            other, _ = parents[int(rng.integers(len(parents)))]
            other.append(copy.deepcopy(node))
        elif node.attrib:
            name = sorted(node.attrib)[int(rng.integers(len(node.attrib)))]
            words = node.attrib[name].split() or [""]
            words[int(rng.integers(len(words)))] = NUMBERS[int(rng.integers(len(NUMBERS)))]
            node.set(name, " ".join(words))
    return ElementTree.tostring(root, encoding="unicode")
