"""The guide names menus, panels and buttons as the window does: each name in bold or italics is a text of the window.

Emphasis looks the same. So a name is every path such as *View > Layers*, and what begins with a capital within a
sentence; a whole sentence, and what begins a paragraph, an item or a cell, may be emphasis. packaging/languages
checks the lessons.
"""

import pathlib
import re
import unittest
import xml.etree.ElementTree as ElementTree

ROOT = pathlib.Path(__file__).parents[2]
PAGES = [*(ROOT / "resources/guide").glob("*.md"), ROOT / "README.md", ROOT / "CONTRIBUTING.md"]
CODE = re.compile(r"^ {4,}(?![-*\d]).*$|`[^`\n]*`|\$[^$\n]*\$", re.MULTILINE)
BEGINNING = r"(?P<beginning>(?:\A|\n[ \t]*\n|^[ ]*(?:[-*>]|\d+\.)[ ]|\|)[ \n]*)?"  # of a paragraph, an item, a cell
NAME = re.compile(BEGINNING + r"(?<![*\w])(?P<mark>\*\*?)(?P<name>[A-Z][^*]*?)(?P=mark)(?![*\w])", re.MULTILINE)
TITLES = {  # of books and papers, and what the pages stress
    *("Comes out", "Esc is Stop, from anywhere", "Feedback Control of Dynamic Systems"),
    *("IEEE Trans. Control Systems Technology", "IROS 2006", "Introduction to Robotics", "J. Robotic Systems"),
    *("Psychophysics: The Fundamentals", "Robotics: Modelling, Planning and Control"),
    "The PHANTOM Omni as an under-actuated robot",
}


def plain(text):
    """Without menu letters, dots and placeholders: "&Open %1…" is "Open"."""
    return " ".join(re.sub(r"\(&\w\)|&|…|%\d", "", text).split()).rstrip(":")


def texts_of_the_window():
    tree = ElementTree.parse(ROOT / "resources/languages/underact_de.ts")
    return {plain(source.text) for source in tree.iter("source")} | TITLES


def names(page):
    """Line and name of what the page says is in the window."""
    page = CODE.sub(lambda code: "x" * len(code.group()), page)
    for match in NAME.finditer(page):
        name = " ".join(match["name"].split())
        if ">" in name or (match["beginning"] is None and not name.endswith((".", "?"))):
            yield page.count("\n", 0, match.start("name")) + 1, name


def unknown(page, texts):
    return [(line, name) for line, name in names(page) if not {plain(part) for part in name.split(" > ")} <= texts]


class QuotedNames(unittest.TestCase):
    def test_are_those_of_the_window(self):
        texts = texts_of_the_window()
        found = [f"{path.name}:{line}: {name}" for path in PAGES for line, name in unknown(path.read_text(), texts)]
        self.assertEqual(found, [], "\n".join(found))

    def test_are_found_within_sentences_and_in_paths(self):
        page = "**Lead** in.\n\n- **Item**: **Go\non…** or\n**View > No**, `**Code**`.\n\n*Open*, **All is well.**"
        self.assertEqual([name for _, name in names(page)], ["Go on…", "View > No"])
        self.assertEqual(unknown(page, {"Go on", "View"}), [(5, "View > No")])
        self.assertGreater(sum(1 for path in PAGES for _ in names(path.read_text())), 200)


if __name__ == "__main__":
    unittest.main()
