"""The guide's spelling: British English, and words of ours in words.txt, one a line."""

import re
import shutil
import subprocess
import unittest

from pages import ROOT, pages, prose

WORDS = ROOT / "tests/guide/words.txt"


def asked(text):
    """Words that the dictionary does not have."""
    done = subprocess.run(
        ["hunspell", "-d", "en_GB", "-i", "utf-8", "-l"],
        input=text,
        capture_output=True,
        text=True,
        timeout=120,
        check=True,
    )
    return set(done.stdout.split())


def unknown(text):
    """Words that are no British English; those with digits are names and numbers."""
    wrong = {word for word in asked(text) if not re.search(r"\d", word)}
    # Oxford's -ize, which Debian 12's dictionary has and Debian 13's has not: known if its -ise is.
    ours = {word: re.sub(r"i(z)(e|es|ed|er|ers|ing|able|ation|ations)$", r"is\2", word) for word in wrong}
    still = asked(" ".join(ours[word] for word in wrong if ours[word] != word))
    return {word for word in wrong if ours[word] == word or ours[word] in still}


def bare(word):
    """Without a genitive's end."""
    return word[:-2] if word.endswith(("'s", "’s")) else word


class Spelling(unittest.TestCase):
    def setUp(self):
        if not shutil.which("hunspell") or unknown("colour"):
            self.skipTest("hunspell or its dictionary en_GB is not installed")

    def test_every_word_of_the_guide_is_in_the_dictionary_or_ours(self):
        ours = set(WORDS.read_text(encoding="utf-8").split())
        for path, text in pages():
            with self.subTest(path.name):
                wrong = {w for w in unknown(prose(text)) if w not in ours and bare(w) not in ours}
                self.assertEqual(wrong, set())

    def test_a_slip_is_seen(self):
        self.assertEqual(unknown("The coulor of the stylus"), {"coulor"})
        self.assertEqual(unknown("It was quantized, and minimizes what it realizes"), set())
        self.assertEqual(unknown("It was quentized to two sizes"), {"quentized"})

    def test_our_words_are_in_use_and_in_order(self):
        ours = WORDS.read_text(encoding="utf-8").split()
        self.assertEqual(ours, sorted(set(ours)))
        text = "\n".join(prose(text) for _, text in pages())
        for word in ours:
            self.assertIn(word, text)


if __name__ == "__main__":
    unittest.main()
