"""The tables of the guide, as cells of text."""

import dataclasses
import re

from pages import pages


@dataclasses.dataclass(frozen=True)
class Table:
    """A table with the page and the line where it begins, the heading above it, and its cells."""

    page: str
    line: int
    heading: str
    head: list
    rows: list

    def name(self):
        """As a list names it: the page, the heading, and the first cells of its head."""
        return f"{self.page}: {self.heading}: {' | '.join(self.head[:2])}"


def cells_of(line):
    """The cells of a row; a bar after a backslash is text."""
    return [cell.strip() for cell in re.split(r"(?<!\\)\|", line.strip())[1:-1]]


def tables():
    """All tables of all pages."""
    for path, text in pages():
        lines, heading, index = text.splitlines(), "", 0
        while index < len(lines):
            line = lines[index]
            if line.startswith("#"):
                heading = line.lstrip("# ")
            if line.startswith("|"):
                end = index
                while end < len(lines) and lines[end].startswith("|"):
                    end += 1
                rows = [cells_of(row) for row in lines[index + 2 : end]]
                yield Table(path.name, index + 1, heading, cells_of(line), rows)
                index = end
            index += 1


def decimals(table):
    """How many cells are measurements: numbers with decimals, not code."""
    cells = [cell for row in table.rows for cell in row]
    short = [cell for cell in cells if "`" not in cell and len(cell) < 40]
    return sum(1 for cell in short if re.search(r"\d\.\d", cell))
