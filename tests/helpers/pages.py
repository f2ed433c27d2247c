"""The repository's Markdown pages, and their commands, inline code, links and anchors."""

import re

from paths import ROOT

DOCS = tuple(sorted((ROOT / "docs").glob("*.md")))
CHINESE = tuple(sorted((ROOT / "docs" / "zh").glob("*.md")))
PAGES = (*sorted(ROOT.glob("*.md")), *sorted((ROOT / "assets").rglob("*.md")), *DOCS, *CHINESE)
FENCED = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def commands_of(text):
    """Every command of a page's text: indented and fenced lines, and inline code, without comments."""
    text = text.replace("\\\n", " ")
    blocks = FENCED.findall(text)
    text = FENCED.sub("", text)
    lines = [line.strip() for language, block in blocks if language in ("", "sh") for line in block.splitlines()]
    lines += [line.strip() for line in text.splitlines() if line.startswith("    ")]
    lines += inline_code(text)
    for line in lines:
        for command in line.split(" && "):
            yield re.split(r"\s+#\s|\s{2,}\[", command)[0].strip()


def inline_code(text):
    """The contents of a text's inline code, in order, each on one line."""
    text = re.sub(r"^    .*$", "", FENCED.sub("", text), flags=re.MULTILINE)
    return [" ".join(code.split()) for code in re.findall(r"(?<!`)`([^`]+)`(?!`)", text)]


def links(text):
    """The targets of a text's links and pictures, in order."""
    return re.findall(r"\]\(([^)\s]+)\)", FENCED.sub("", text))


def anchors(text):
    """The anchors that GitHub makes of a page's headings."""
    found = []
    for heading in re.findall(r"^#+ (.*)$", FENCED.sub("", text), re.MULTILINE):
        words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
        anchor = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
        # GitHub numbers anchors that repeat.
        count = sum(re.fullmatch(rf"{re.escape(anchor)}(-\d+)?", other) is not None for other in found)
        found.append(f"{anchor}-{count}" if count else anchor)
    return found
