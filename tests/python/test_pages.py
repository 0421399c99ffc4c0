"""The lines that the page shows do what it says. Octave's are checked in test_octave.py."""

import subprocess
import sys
import unittest

from session_writer import write_session
from support import ROOT, InFolder, command

PAGE = "resources/guide/python.md"


def blocks(heading: str) -> list[str]:
    """The indented blocks of the page below a heading, up to the next one."""
    text = (ROOT / PAGE).read_text(encoding="utf-8")
    section = text.split(f"\n{heading}\n")[1].split("\n#")[0]
    found, lines = [], []
    for line in [*section.splitlines(), "end"]:
        if line.startswith("    ") or (lines and not line):
            lines.append(line[4:])
        elif lines:
            found.append("\n".join(lines).rstrip())
            lines = []
    return found


class ThePage(InFolder):
    def setUp(self):
        super().setUp()
        write_session(self.folder / "first.h5", 4100)

    def test_shows_python_that_runs(self):
        shown = blocks("## Sessions")
        self.assertEqual(len(shown), 2)
        for lines in shown:
            done = subprocess.run(
                [sys.executable, "-c", lines], cwd=self.folder, capture_output=True, text=True
            )
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stdout, "at most [0-9.]+ mm off, 0.88 N\n|^4100 [0-9.]+\n")

    def test_shows_commands_that_run(self):
        import os

        lines = blocks("### From the command line")[0].splitlines()
        self.assertEqual(len(lines), 4)
        here = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, here)
        for line in lines:
            words = line.split()
            self.assertEqual(words[:3], ["python3", "-m", "underact"])
            self.assertEqual(command(*words[3:])[0], 0, line)
        self.assertTrue((self.folder / "path.pdf").is_file())
        self.assertTrue((self.folder / "first_energy.svg").is_file())
        self.assertTrue((self.folder / "first.csv").is_file())

    def test_names_every_kind_of_plot(self):
        from underact.plots import KINDS

        text = (ROOT / PAGE).read_text(encoding="utf-8")
        for kind in KINDS:
            self.assertIn(f"`{kind}`", text)


class EveryPublicThing(unittest.TestCase):
    def test_has_a_docstring(self):
        import ast

        for path in sorted((ROOT / "app/python/underact").rglob("*.py")):
            tree = ast.parse(path.read_text(encoding="utf-8"))
            self.assertTrue(ast.get_docstring(tree), path)
            for node in ast.walk(tree):
                if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and not node.name.startswith(
                    "_"
                ):
                    if node in tree.body or isinstance(node, ast.ClassDef):
                        self.assertTrue(ast.get_docstring(node), f"{path.name}: {node.name}")

    def test_keeps_to_100_columns(self):
        for folder in ("app/python", "tests/python", "tests/mutants"):
            for path in sorted((ROOT / folder).rglob("*.py")):
                for number, line in enumerate(
                    path.read_text(encoding="utf-8").splitlines(), start=1
                ):
                    self.assertLessEqual(len(line), 100, f"{path.name}:{number}")


if __name__ == "__main__":
    unittest.main()
