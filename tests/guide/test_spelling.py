"""The guide's spelling: British English, and words of ours in words.txt, one a line."""

import re
import shutil
import subprocess
import unittest

from pages import ROOT, pages, prose

WORDS = ROOT / "tests/guide/words.txt"


def unknown(text):
    """Words that the dictionary does not have; those with digits are names and numbers."""
    done = subprocess.run(
        ["hunspell", "-d", "en_GB", "-i", "utf-8", "-l"],
        input=text,
        capture_output=True,
        text=True,
        timeout=120,
        check=True,
    )
    return {word for word in done.stdout.split() if not re.search(r"\d", word)}


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
            wrong = {w for w in unknown(prose(text)) if w not in ours and bare(w) not in ours}
            self.assertEqual(wrong, set(), path.name)

    def test_a_slip_is_seen(self):
        self.assertEqual(unknown("The coulor of the stylus"), {"coulor"})

    def test_our_words_are_in_use_and_in_order(self):
        ours = WORDS.read_text(encoding="utf-8").split()
        self.assertEqual(ours, sorted(set(ours)))
        text = "\n".join(prose(text) for _, text in pages())
        for word in ours:
            self.assertIn(word, text)


if __name__ == "__main__":
    unittest.main()
