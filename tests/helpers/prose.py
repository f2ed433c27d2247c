"""The prose of a file: its text in its own shape, with everything else blanked out.

Prose is what a person reads: Markdown without code, Python's comments, docstrings and messages, the comments of other
files. Line numbers stay. In tests, string literals that are data do not count as prose.
"""

import ast
import io
import re
import tokenize
from pathlib import Path

from pages import FENCED

CODE = "\x00"
"""Replacement of everything that is not prose, so that no phrase matches across it."""
EXAMPLES = "tests/project/test_language.py"
"""File whose string literals are examples of wrong phrases."""


def blank(match):
    """The match with `CODE` for every character that is not white space."""
    return re.sub(r"\S", CODE, match[0])


def without_code(text):
    """Text without inline code, quoted names and addresses."""
    return re.sub(r"`[^`]*`|'[\w./-]+'|https?://\S+", blank, text)


def without_directives(text):
    """Comments without the directives for linters and type checkers."""
    return re.sub(r"# (noqa|type:|fmt:|pragma:).*", blank, text)


def markdown_prose(text):
    def comments(match):
        return re.sub(r"^(?:(?! # ).)*", blank, match[0], flags=re.MULTILINE)

    text = FENCED.sub(comments, text)
    text = re.sub(r"^    .*$", comments, text, flags=re.MULTILINE)
    text = re.sub(r"\]\([^)]*\)", blank, text)
    return without_code(text)


def _is_data(path, quote):
    """True for a string literal in a test that is data: text in triple quotes (YAML, programs), or an example."""
    return path == EXAMPLES or (path.startswith("tests/") and len(quote) == 3)


def python_prose(text, path=""):
    """Comments, and strings of more than one word; regular expressions are written as raw strings."""
    lines = [re.sub(r"\S", CODE, line) for line in text.splitlines(keepends=True)]
    fstring_start, fstring_middle, fstring_end = (
        getattr(tokenize, f"FSTRING_{part}", None) for part in ("START", "MIDDLE", "END")
    )
    starts_statement, fstring_quotes = True, []
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        is_docstring = starts_statement and token.type == tokenize.STRING
        if token.type not in (tokenize.NL, tokenize.COMMENT):
            starts_statement = token.type in (tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT)
        if token.type == fstring_start:
            fstring_quotes.append(token.string.lstrip("fFrR"))
        elif token.type == fstring_end:
            fstring_quotes.pop()
        if token.type not in (tokenize.COMMENT, tokenize.STRING, fstring_middle):
            continue
        if token.type == fstring_middle and _is_data(path, fstring_quotes[-1]):
            continue
        content = token.string
        if token.type == tokenize.COMMENT:
            content = without_directives(content).replace("#", " ")
        elif token.type == tokenize.STRING:
            prefix, quote = re.match(r"(\w*)(\"{3}|'{3}|\"|')", content).groups()
            if set(prefix.lower()) & set("rb") or not re.search(r"\s", content):
                continue
            if not is_docstring and _is_data(path, quote):
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
    readable = python_prose(text, path) if kind is python_prose else kind(text)
    return re.sub(rf"{CODE}[ \t{CODE}]*", CODE, readable.lower())


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
