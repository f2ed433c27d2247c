"""The prose of a file: its text in its own shape, with everything else blanked out.

Prose is what a person reads: Markdown without code, Python's comments, docstrings and messages, the comments of other
files. Line numbers stay.
"""

import ast
import io
import re
import tokenize
from pathlib import Path

from pages import FENCED

CODE = "\x00"
"""Stands for what is not prose, so that no phrase goes over it."""


def blank(match):
    """As many blanks, line ends kept."""
    return re.sub(r"\S", CODE, match[0])


def without_code(text):
    """Text without inline code, quoted names and addresses."""
    return re.sub(r"`[^`]*`|'[\w./-]+'|https?://\S+", blank, text)


def without_directives(text):
    """Comments without what linters and type checkers read."""
    return re.sub(r"# (noqa|type:|fmt:|pragma:).*", blank, text)


def markdown_prose(text):
    def comments(match):
        return re.sub(r"^(?:(?! # ).)*", blank, match[0], flags=re.MULTILINE)

    text = FENCED.sub(comments, text)
    text = re.sub(r"^    .*$", comments, text, flags=re.MULTILINE)
    text = re.sub(r"\]\([^)]*\)", blank, text)
    return without_code(text)


def python_prose(text):
    """Comments, and strings of more than one word; regular expressions are written as raw strings."""
    lines = [re.sub(r"\S", CODE, line) for line in text.splitlines(keepends=True)]
    kept = (tokenize.COMMENT, tokenize.STRING, getattr(tokenize, "FSTRING_MIDDLE", tokenize.STRING))
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type not in kept:
            continue
        content = token.string
        if token.type == tokenize.COMMENT:
            content = without_directives(content).replace("#", " ")
        elif token.type == tokenize.STRING:
            prefix, quote = re.match(r"(\w*)(\"{3}|'{3}|\"|')", content).groups()
            if set(prefix.lower()) & set("rb") or not re.search(r"\s", content):
                continue
            content = " " * len(prefix + quote) + content[len(prefix + quote) : -len(quote)] + " " * len(quote)
            if "f" in prefix.lower():
                content = re.sub(r"\{[^{}]*\}", blank, content)
        (row, column), _ = token.start, token.end
        for i, part in enumerate(content.splitlines(keepends=True)):
            start = column if i == 0 else 0
            line = lines[row - 1 + i]
            lines[row - 1 + i] = line[:start] + part + line[start + len(part) :]
    return without_code("".join(lines))


def hash_prose(text):
    """Comments after '#'."""
    return without_code(re.sub(r"^[^#\n]*#?", blank, text, flags=re.MULTILINE))


def markup_prose(text):
    """Text and comments between tags and template expressions."""
    text = re.sub(r"\{\{.*?\}\}|\{%.*?%\}|<(script|style)\b.*?</\1>|<(?!!--)[^>]*>", blank, text, flags=re.DOTALL)
    return without_code(text)


_PROSE = {
    ".md": markdown_prose,
    ".py": python_prose,
    ".toml": hash_prose,
    ".html": markup_prose,
    ".xml": markup_prose,
    ".urdf": markup_prose,
    "Makefile": hash_prose,
}


def has_prose(path):
    """True for a file that `prose` can read."""
    return Path(path).name in _PROSE or Path(path).suffix in _PROSE


def prose(path, text):
    """A file's prose in lower case, every run of other characters of a line as one `CODE`."""
    kind = _PROSE.get(Path(path).name) or _PROSE[Path(path).suffix]
    return re.sub(rf"{CODE}[ \t{CODE}]*", CODE, kind(text).lower())


def docstrings(text):
    """(line, text, whether it stands under an assignment) of every docstring."""
    pending = [ast.parse(text)]
    while pending:
        body = pending.pop().body
        for before, statement in zip([None, *body], body, strict=False):
            if isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant):
                assigned = isinstance(before, ast.Assign | ast.AnnAssign)
                if isinstance(statement.value.value, str) and (before is None or assigned):
                    yield statement.lineno, statement.value.value, assigned
            elif isinstance(getattr(statement, "body", None), list):
                pending.append(statement)
