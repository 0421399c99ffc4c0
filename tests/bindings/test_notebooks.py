"""The guide's notebooks run, and print what they show; each is opened from a page of the guide, and is small."""

from __future__ import annotations

import json
import unittest

from beside import ROOT
from run_notebooks import GUIDE, NOTEBOOKS, run

MAX_BYTES = 60_000  # of each, with its pictures: they are part of the Debian package


class Notebooks(unittest.TestCase):
    def test_they_run_and_print_what_they_show(self):
        for path in NOTEBOOKS:
            with self.subTest(path.name):
                try:
                    self.assertEqual(run(path), [])
                except ImportError as error:
                    self.skipTest(f"{error} (python3-nbclient, python3-ipykernel), so the notebooks were not run")

    def test_each_is_small_has_its_outputs_and_nothing_of_who_ran_it(self):
        self.assertEqual(len(NOTEBOOKS), 5)
        for path in NOTEBOOKS:
            text = path.read_text(encoding="utf-8")
            self.assertLess(len(text), MAX_BYTES, path.name)
            self.assertNotIn("/work/", text)
            self.assertNotIn("/home/", text)
            cells = [cell for cell in json.loads(text)["cells"] if cell["cell_type"] == "code"]
            without = [cell for cell in cells if not cell["outputs"]]
            self.assertLessEqual(len(without), 2, path.name)
            self.assertFalse([cell for cell in cells if any(one["output_type"] == "error" for one in cell["outputs"])])

    def test_the_guide_names_each(self):
        page = (GUIDE / "python.md").read_text(encoding="utf-8")
        for path in ROOT.glob("resources/guide/*.ipynb"):
            self.assertIn(f"[{path.name}]({path.name})", page)  # opens it


if __name__ == "__main__":
    unittest.main()
