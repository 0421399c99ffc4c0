"""The list of breakages is true: it cannot rot while nobody runs it."""

import fnmatch
import importlib.util
import re
import tempfile
import time
import unittest
from collections import Counter
from pathlib import Path

from breakages import BREAKAGES

FOLDER = Path(__file__).resolve().parent
ROOT = FOLDER.parents[1]
SPEC = importlib.util.spec_from_file_location("mutants", FOLDER / "__main__.py")
mutants = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(mutants)


def rooms() -> list[str]:
    """All of them, the deepest first."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    found = re.findall(r"^\s*underact_room\((\S+)", text, re.MULTILINE)
    return sorted(found, key=len, reverse=True)


def suites_and_names() -> set[str]:
    """Of all tests of GoogleTest, as a filter has them."""
    pattern = re.compile(r"^TEST(?:_[FP])?\(\s*(\w+),\s*(\w+)\)", re.MULTILINE)
    found = set()
    for path in (ROOT / "tests").rglob("*.cpp"):
        found |= {".".join(words) for words in pattern.findall(path.read_text(encoding="utf-8"))}
    return found


class Breakages(unittest.TestCase):
    def test_are_sixty_three_and_each_another(self):
        self.assertGreaterEqual(len(BREAKAGES), 60)
        self.assertEqual(len({(one.file, one.old) for one in BREAKAGES}), len(BREAKAGES))
        self.assertEqual(len({one.says for one in BREAKAGES}), len(BREAKAGES))

    def test_stand_exactly_once_in_their_files_and_change_them(self):
        for one in BREAKAGES:
            mutants.line_of(ROOT, one)  # says which, and raises
            self.assertNotEqual(one.old.split(), one.new.split(), one.file)

    def test_are_of_every_room(self):
        of = Counter(
            next(room for room in rooms() if one.file.startswith(room + "/")) for one in BREAKAGES
        )
        # The Python module is not in the build of the mutants; its tests are in Python.
        self.assertEqual(set(rooms()) - set(of), {"app/bindings"})
        window = sum(count for room, count in of.items() if room.startswith("app/gui"))
        self.assertGreaterEqual(window, 10)

    def test_have_tests_that_there_are(self):
        known = suites_and_names()
        self.assertGreater(len(known), 1000)
        for one in BREAKAGES:
            for pattern in one.only.split(":"):
                self.assertTrue(fnmatch.filter(known, pattern), f"{one.file}: {pattern}")

    def test_live_in_three_places_at_most(self):
        self.assertLessEqual(sum(bool(one.lives) for one in BREAKAGES), mutants.MAX_ALIVE)


class ATextThatIsNotThereOnce(unittest.TestCase):
    def test_is_an_error_of_the_list(self):
        for old in ("no such text", "#include"):
            wrong = mutants.Breakage("", "core/tick/step.cpp", old, "", "", "")
            with self.assertRaisesRegex(mutants.ListError, "not once"):
                mutants.line_of(ROOT, wrong)


class WhatIsRun(unittest.TestCase):
    def test_ends_with_all_that_it_started_when_its_time_is_over(self):
        with tempfile.TemporaryDirectory() as folder:
            script = "set -m; sleep 600 & echo $! > pid; wait"  # in a process group of its own
            passed, output = mutants.run(["bash", "-c", script], 1.0, Path(folder), {})
            self.assertFalse(passed)
            self.assertIn("more than 1 s", output)
            status = Path("/proc", (Path(folder) / "pid").read_text().strip(), "stat")
            for _ in range(100):
                if not status.is_file() or status.read_text().rpartition(")")[2].split()[0] == "Z":
                    return
                time.sleep(0.1)
            self.fail("It is still there.")


class AFolderWithOtherFiles(unittest.TestCase):
    def test_is_not_built_in(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "letter.txt").write_text("dear all")
            with self.assertRaisesRegex(mutants.ListError, "other origin"):
                mutants.copy_tracked(Path(folder))
            self.assertTrue((Path(folder) / "letter.txt").is_file())


if __name__ == "__main__":
    unittest.main()
