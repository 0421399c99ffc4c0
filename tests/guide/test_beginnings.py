"""Every page begins with what it is for and one example, before its first section ends."""

import re
import unittest

from pages import blocks, pages

EXAMPLE = re.compile(
    r"[Ff]or example|[Ee]xample|[Tt]ry|[Bb]egin with|[Tt]o (see|feel|begin)|[Ff]eel one|short version|"
    r"\((scene|lesson|action):|^1\. ",
    re.M,
)
GENERATED = ("command_reference", "scene_reference", "scene_list", "session_columns")
FIRST_SCREEN = 16  # lines


class Beginnings(unittest.TestCase):
    def test_each_page_begins_with_what_it_is_for(self):
        for path, text in pages():
            title, paragraph = text.split("\n\n")[:2]
            self.assertTrue(title.startswith("# "), path.name)
            self.assertRegex(paragraph, r"\A[A-Z][^|]{60}", f"{path.name} begins with no sentence")

    def test_and_has_one_example_on_its_first_screen(self):
        for path, text in pages():
            if path.stem in GENERATED:
                continue
            lines = text.splitlines()[:FIRST_SCREEN]
            code = [block for block in blocks(text) if block[0][0] <= FIRST_SCREEN]
            self.assertTrue(code or EXAMPLE.search("\n".join(lines)), path.name)


if __name__ == "__main__":
    unittest.main()
