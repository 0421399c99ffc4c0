"""resources/guide/glossary.md holds: none of the words it rules out is used, and each of its terms is."""

import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).parents[2]
GLOSSARY = ROOT / "resources/guide/glossary.md"
ROW = re.compile(r"^\| (?P<term>[^|]+) \| [^|]+ \|[^|]*\|(?P<banned>[^|]*)\| (?P<german>[^|]+) \|$")


def rows():
    """The terms with what is ruled out beside each; heads of tables are left out."""
    found = [match for line in GLOSSARY.read_text().splitlines() if (match := ROW.match(line))]
    return [
        (row["term"].split(", "), re.findall(r"`([^`]+)`", row["banned"]))
        for row in found
        if row["term"] not in ("term", "---")
    ]


def texts():
    """What people read: pages, texts of the window, scenes and lessons, and of the programs."""
    files = [ROOT / "README.md", ROOT / "CHANGELOG.md", ROOT / "CONTRIBUTING.md", ROOT / "resources/languages/underact_de.ts"]
    files += [page for page in (ROOT / "resources/guide").glob("*.md") if page != GLOSSARY]
    for folder, ending in [("scenes", "*.json"), ("resources/lessons", "*.json")]:
        files += (ROOT / folder).glob(ending)
    for folder in ["core", "device", "app"]:
        files += [path for end in ("*.h", "*.cpp", "*.py") for path in (ROOT / folder).rglob(end)]
    return files


def pattern(words):
    """The words in a text, and run together in a name: "turning stiffness", turning_stiffness, turningStiffness."""
    parts = [re.escape(word) for word in words.split()]
    joined = "".join([parts[0]] + [f"[{part[0].upper()}{part[0]}]{part[1:]}" for part in parts[1:]])
    return re.compile(rf"(?<![A-Za-z])(?:(?i:{'[ _-]'.join(parts)})|{joined})(?![a-z])")


class Glossary(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.texts = {path: path.read_text(encoding="utf-8") for path in texts()}

    def test_it_has_terms_and_words_ruled_out(self):
        self.assertGreater(len(rows()), 50)
        self.assertGreater(sum(len(banned) for _, banned in rows()), 20)

    def test_each_term_is_used(self):
        everything = "\n".join(self.texts.values()).lower()
        unused = [term for terms, _ in rows() for term in terms if term.lower() not in everything]
        self.assertEqual(unused, [])

    def test_no_word_that_is_ruled_out_is_used(self):
        found = []
        for _, banned in rows():
            for words in banned:
                wrong = pattern(words)
                for path, text in self.texts.items():
                    found += [
                        f"{path.relative_to(ROOT)}:{text.count(chr(10), 0, match.start()) + 1}: {match.group()}"
                        for match in wrong.finditer(text)
                    ]
        self.assertEqual(found, [], "\n".join(found))

    def test_a_comment_says_what_a_thing_is_not_that_it_is_the_same(self):
        found = [
            f"{path.relative_to(ROOT)}: {line.strip()}"
            for path, text in self.texts.items()
            if path.suffix in (".h", ".cpp")
            for line in re.findall(r"^\s*///? The same\b.*", text, re.M)
        ]
        self.assertEqual(found, [], "\n".join(found))

    def test_a_word_is_found_in_a_text_and_in_a_name(self):
        for text in ["Turning stiffness", "turning_stiffness_N", "setTurningStiffness", "turningStiffness"]:
            wrong = pattern("turning stiffness")
            self.assertTrue(wrong.search(text) or re.search("TurningStiffness", text), text)


if __name__ == "__main__":
    unittest.main()
