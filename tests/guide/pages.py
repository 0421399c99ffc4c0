"""The guide's pages, as its tests read them."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
GUIDE = ROOT / "resources/guide"


def pages():
    """Every page with its text."""
    for path in sorted(GUIDE.glob("*.md")):
        yield path, path.read_text(encoding="utf-8")


def commanding():
    """What shows commands: the pages, and the project's first page."""
    yield from pages()
    yield ROOT / "README.md", (ROOT / "README.md").read_text(encoding="utf-8")


def blocks(text):
    """Indented blocks of code: lists of (line's number, line). A list's own text is indented, too,
    so a block comes after an empty line that follows something else than a list."""
    found, inside = [], False
    for number, line in enumerate(text.splitlines(), start=1):
        if line.startswith("    ") and (inside or not line.strip().startswith(("-", "*"))):
            if not inside:
                found.append([])
            inside = True
            found[-1].append((number, line[4:]))
        elif line.strip():
            inside = False
    return found


def prose(text):
    """The text without code, formulas, addresses and targets of links: what is spelt."""
    code = {number for block in blocks(text) for number, _ in block}
    lines = [
        "" if number in code else line for number, line in enumerate(text.splitlines(), start=1)
    ]
    plain = "\n".join(lines)
    plain = re.sub(r"``.+?``|`[^`]*`", " ", plain, flags=re.S)
    plain = re.sub(r"\$\$.+?\$\$", " ", plain, flags=re.S)
    plain = re.sub(r"\$[^$\n]+(\n[^$\n]+)?\$", " ", plain)
    plain = re.sub(r"\]\([^)]*\)", "] ", plain)
    plain = re.sub(r"https?://\S+", " ", plain)
    return plain
