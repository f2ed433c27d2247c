"""Tables of results, for a terminal and for pages."""

from collections.abc import Sequence
from typing import NamedTuple

from quadruped_env.errors import escaped


class Table(NamedTuple):
    """A table of texts, which pages show as HTML."""

    title: str
    head: Sequence[str]
    """Titles of the columns"""
    rows: Sequence[Sequence[str]]
    note: str = ""

    def text(self) -> str:
        """Return the table as plain text, between its title and its note."""
        note = [self.note] if self.note else []
        return "\n".join([self.title, text_table([self.head, *self.rows]), *note])


def text_table(rows: Sequence[Sequence[str]], left: int = 1) -> str:
    """Return lines of cells, two blanks apart: the first `left` columns are left-aligned, the others right-aligned."""
    rows = [[escaped(cell) for cell in row] for row in rows]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = (
        "  ".join(
            cell.ljust(width) if i < left else cell.rjust(width)
            for i, (cell, width) in enumerate(zip(row, widths, strict=True))
        )
        for row in rows
    )
    return "\n".join(line.rstrip() for line in lines)
