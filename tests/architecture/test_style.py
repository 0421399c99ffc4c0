"""The style of what people read: no phrase of style.diction, and no word twice. GNU diction looks for them."""

import itertools
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).parents[2]
RULES = pathlib.Path(__file__).with_name("style.diction")
PHRASE = re.compile(r"\[(.+?) -> (.+?)\]", re.DOTALL)


def prose(markdown):
    """A page without what is no prose: code, formulas, bars of tables, addresses of links, names of sources. Lines stay
    where they are."""
    count = itertools.count()

    def stand_in(match):
        return f"thing{chr(97 + next(count) % 26)}" + "\n" * match.group().count("\n")

    code, formulas = [r"```.*?```", r"(?m)^ {4,}\S.*$", r"`[^`]*`"], [r"\$\$.*?\$\$", r"\$[^$\n]+\$"]
    for pattern in [*code, *formulas, r"\[[A-Z][^]]*\](?!\()"]:
        markdown = re.sub(pattern, stand_in, markdown, flags=re.DOTALL)
    return re.sub(r"\]\([^)]*\)", "", markdown).replace("[", "").replace("|", " . ").replace("*", "")


def pages():
    """Name and prose of each page of the guide, the README and CONTRIBUTING."""
    files = [ROOT / "README.md", ROOT / "CHANGELOG.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "resources/guide").glob("*.md"))]
    return [(str(path.relative_to(ROOT)), prose(path.read_text(encoding="utf-8"))) for path in files]


def window_texts():
    """The English texts that are translated: the window's, the messages, scenes and lessons; a paragraph each."""
    tree = xml.etree.ElementTree.parse(ROOT / "resources/languages/underact_de.ts")
    texts = [source.text or "" for source in tree.iter("source")]
    return "\n\n".join(prose(re.sub(r"<[^>]*>", " ", text)) + "." for text in texts)


def found_in(text):
    """What diction complains of: line, phrase and advice."""
    with tempfile.NamedTemporaryFile("w", suffix=".txt", encoding="utf-8") as file:
        file.write(text)
        file.flush()
        words = ["diction", "--no-default-file", "--file", str(RULES), "--suggest", "--quiet", file.name]
        said = subprocess.run(words, capture_output=True, text=True, errors="replace", timeout=60, check=False)
    if said.returncode != 0:
        raise AssertionError(said.stderr)
    return [
        f"{line.split(':')[0].strip()}: {phrase} -> {advice}"
        for line in re.split(r"\n(?=\S*\d+: )", said.stdout)
        for phrase, advice in PHRASE.findall(line)
        if advice != "Double word." or re.search(rf"\b{phrase}\s+{phrase}\b", text)  # "to 5 mm, 25 mm" is none
    ]


@unittest.skipUnless(shutil.which("diction"), "diction is not installed")
class Style(unittest.TestCase):
    def test_pages(self):
        for name, text in pages():
            with self.subTest(page=name):
                self.assertEqual(found_in(text), [])

    def test_window_messages_scenes_and_lessons(self):
        self.assertEqual(found_in(window_texts()), [])

    def test_a_phrase_and_a_doubled_word_are_found(self):
        self.assertEqual(len(found_in("It pushes in order to hold the stylus. It bears for good.\n")), 2)
        self.assertEqual(len(found_in("It pushes the the stylus.\n")), 1)
        self.assertEqual(found_in("It pushes the stylus.\n"), [])

    def test_what_is_no_prose_is_not_looked_at(self):
        text = "Say `in order to`, $thus$.\n\n    a line of code, in order to\n\n[a](thus) sphere\n"
        self.assertEqual(found_in(prose(text)), [])


if __name__ == "__main__":
    unittest.main()
