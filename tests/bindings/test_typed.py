"""The package's types are right by mypy, and the stubs of the compiled part are what it has."""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from beside import ROOT

PACKAGE = ROOT / "app/python/underact"
FILES = ("arm.py", "canvas.py", "compiled.py", "given.py", "gym.py", "pictures.py", "scene.py", "shapes.py", "sim.py", "_core.pyi")


def mypy(*words: object) -> subprocess.CompletedProcess:
    """What mypy says."""
    try:
        import mypy  # noqa: F401
    except ImportError as error:
        raise unittest.SkipTest("mypy is not installed, so types were not checked") from error
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "mypy", "--strict", "--ignore-missing-imports", "--cache-dir", folder]
        return subprocess.run([*command, *map(str, words)], capture_output=True, text=True, check=False, cwd=ROOT / "app/python")


class Types(unittest.TestCase):
    def test_the_package_is_right_strictly(self):
        # gymnasium has types of its own, which are not there everywhere.
        words = ("--follow-imports=silent", "--disable-error-code=misc", "--disable-error-code=no-any-return")
        done = mypy(*words, *(PACKAGE / name for name in FILES))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_a_program_that_uses_it_is_told_what_it_does_wrong(self):
        with tempfile.TemporaryDirectory() as folder:
            program = Path(folder) / "program.py"
            program.write_text("from underact import arm\nX = arm.load('omni-thesis').fk([0.0] * 6)\nX.wrong\narm.load(3)\n")
            before = os.environ.get("MYPYPATH")
            os.environ["MYPYPATH"] = str(ROOT / "app/python")
            try:
                done = mypy("--follow-imports=silent", program)
            finally:
                os.environ.pop("MYPYPATH")
                if before is not None:
                    os.environ["MYPYPATH"] = before
        lines = [line for line in done.stdout.splitlines() if "error" in line and "program.py" in line]
        self.assertEqual(len(lines), 2, done.stdout + done.stderr)
        self.assertIn('no attribute "wrong"', lines[0])
        self.assertIn('incompatible type "int"', lines[1])


if __name__ == "__main__":
    unittest.main()
