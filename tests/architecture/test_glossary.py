"""resources/guide/glossary.md holds: none of the words it rules out is used, and each of its terms is."""

import fnmatch
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).parents[2]
GLOSSARY = ROOT / "resources/guide/glossary.md"
ROW = re.compile(r"^\| (?P<term>[^|]+) \| [^|]+ \|[^|]*\|(?P<banned>[^|]*)\| (?P<german>[^|]+) \|$")
NAMES = re.compile(r"^\| [^|]+ \| (?P<banned>`[^|]+) \|(?P<fixed>[^|]*)\|$", re.M)
# What of a source is no code: a raw string, a string, a comment.
NO_CODE = {
    ".py": re.compile(r"\"\"\".*?\"\"\"|\"(?:\\.|[^\"\\\n])*\"|'(?:\\.|[^'\\\n])*'|#[^\n]*", re.S),
    "": re.compile(r"R\"(\w*)\(.*?\)\1\"|\"(?:\\.|[^\"\\\n])*\"|(?<!\w)'(?:\\.|[^'\\\n])*'|//[^\n]*|/\*.*?\*/", re.S),
}


def rows():
    """The terms with what is ruled out beside each; heads of tables are left out."""
    found = [match for line in GLOSSARY.read_text().splitlines() if (match := ROW.match(line))]
    return [
        (row["term"].split(", "), re.findall(r"`([^`]+)`", row["banned"]))
        for row in found
        if row["term"] not in ("term", "---")
    ]


def names_ruled_out():
    """Of the table for code: a pattern of the names ruled out, and one of those that are fixed phrases."""
    found = [[], []]
    for row in NAMES.finditer(GLOSSARY.read_text()):
        for globs, cell in zip(found, (row["banned"], row["fixed"])):
            globs += re.findall(r"`([^`]+)`", cell)
    return [re.compile("|".join(fnmatch.translate(glob) for glob in globs)) for globs in found]


def names_in(text, suffix):
    """The names in the code of a source, without its strings and comments."""
    return set(re.findall(r"[A-Za-z_]\w*", NO_CODE.get(suffix, NO_CODE[""]).sub(" ", text)))


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

    def test_no_name_in_code_is_one_that_is_ruled_out(self):
        banned, fixed = names_ruled_out()
        found = [
            f"{path.relative_to(ROOT)}: {name}"
            for folder in ["core", "device", "app"]
            for path in sorted((ROOT / folder).rglob("*"))
            if path.suffix in (".h", ".cpp", ".py", ".js")
            for name in sorted(names_in(path.read_text(encoding="utf-8"), path.suffix))
            if banned.match(name) and not fixed.match(name)
        ]
        self.assertEqual(found, [], "\n".join(found))

    def test_a_name_is_found_in_code_alone(self):
        banned, fixed = names_ruled_out()
        names = names_in('int kMostRows = way_m + least_squares;  // said\nauto t = R"(usual "x)" + "isWell";', ".cpp")
        self.assertEqual({name for name in names if banned.match(name)}, {"kMostRows", "way_m", "least_squares"})
        self.assertTrue(fixed.match("least_squares") and not fixed.match("least_mass_kg"))
        self.assertEqual(names_in('"""said"""\nway = "most"  # least\n', ".py"), {"way"})

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
