"""The prose of a file: what a person reads in Markdown and in Python, without the code."""

import ast
import re

from pages import FENCED

CODE = "\x00"
"""Replacement of everything that is not prose, so that no phrase matches across it."""
EXAMPLES = "tests/project/test_language.py"
"""File whose string literals are examples of wrong phrases."""
COMMENT = re.compile(r"""(?:[^'"#]|'(?:[^'\\]|\\.)*'|"(?:[^"\\]|\\.)*")*(#.*)""")


def blank(match):
    """The match with `CODE` for every character that is not white space."""
    return re.sub(r"\S", CODE, match[0])


def markdown_prose(text):
    """Markdown without code, but with the comments of commands."""

    def comments(match):
        return re.sub(r"^(?:(?! # ).)*", blank, match[0], flags=re.MULTILINE)

    text = FENCED.sub(comments, text)
    text = re.sub(r"^    .*$", comments, text, flags=re.MULTILINE)
    return re.sub(r"\]\([^)]*\)", blank, text)


def comments_of(text, tree):
    """Line -> text of comments; those of consecutive lines are one text."""
    within = {
        line
        for node in ast.walk(tree)
        if isinstance(node, (ast.Constant, ast.JoinedStr)) and node.end_lineno > node.lineno
        for line in range(node.lineno, node.end_lineno)
    }
    found, begin, end = {}, 0, 0
    for line, code in enumerate(text.split("\n"), start=1):
        match = "#" in code and line not in within and COMMENT.match(code)
        if match:
            begin = begin if line == end + 1 else line
            end = line
            comment = re.sub(r"# (noqa|type:|fmt:|pragma:).*", "", match[1]).replace("#", " ")
            found[begin] = f"{found[begin]}\n{comment}" if begin in found else comment
    return found


def strings_of(path, text, tree):
    """(line, text) of docstrings and of strings of several words, but for raw ones: those are regular expressions.

    In tests, other strings in triple quotes or of several lines are data, such as programs and YAML.
    """
    lines = text.split("\n")
    docstrings = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
    parts = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr):
            parts.update(id(part) for part in ast.walk(node) if part is not node)
            content = "".join(part.value if isinstance(part, ast.Constant) else CODE for part in node.values)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            content = node.value
        else:
            continue
        if id(node) in parts or not re.search(r"\s", content):
            continue
        start = lines[node.lineno - 1].encode()[node.col_offset :].decode()
        prefix, quote = re.match(r"(\w*)(\"{3}|'{3}|\"|')", start).groups()
        is_data = path == EXAMPLES or (path.startswith("tests/") and (len(quote) == 3 or "\n" in content))
        if "r" not in prefix.lower() and (id(node) in docstrings or not is_data):
            yield node.lineno, content


def has_prose(path):
    """True for a file that `prose` can read."""
    return path.endswith((".md", ".py"))


def prose(path, text):
    """(line, text in lower case) of a file's prose, every run of other characters of a line as one `CODE`."""
    pieces = [(1, markdown_prose(text))]
    if path.endswith(".py"):
        # Two strings of one line are one piece.
        grouped, tree = {}, ast.parse(text)
        for line, piece in (*comments_of(text, tree).items(), *strings_of(path, text, tree)):
            grouped[line] = f"{grouped[line]} {CODE} {piece}" if line in grouped else piece
        pieces = grouped.items()
    for line, piece in pieces:
        # Inline code, quoted names and addresses.
        readable = re.sub(r"`[^`]*`|'[\w./-]+'|https?://\S+", blank, piece)
        yield line, re.sub(rf"{CODE}[ \t{CODE}]*", CODE, readable.lower())


def docstrings(text):
    """(line, text, whether it stands under an assignment) of every docstring."""
    for node in ast.walk(ast.parse(text)):
        body = getattr(node, "body", None)
        if not isinstance(body, list):
            continue
        for before, statement in zip([None, *body], body, strict=False):
            value = getattr(statement, "value", None)
            if isinstance(statement, ast.Expr) and isinstance(getattr(value, "value", None), str):
                assigned = isinstance(before, ast.Assign | ast.AnnAssign)
                if before is None or assigned:
                    yield statement.lineno, value.value, assigned
