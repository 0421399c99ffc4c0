"""What the guide shows of the Python package runs, and prints numbers."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from beside import CLI, ROOT


class Page(unittest.TestCase):
    def test_its_example_runs_and_its_session_is_made_again(self):
        page = (ROOT / "resources/guide/python.md").read_text(encoding="utf-8")
        code = re.search(r"\n\n((?:    .*\n|\n)+)", page)[1]
        self.assertIn("from underact import", code)
        with tempfile.TemporaryDirectory() as folder:
            program = Path(folder) / "example.py"
            program.write_text(re.sub(r"^    ", "", code, flags=re.M))
            done = subprocess.run([sys.executable, program], cwd=folder, env=os.environ, capture_output=True, text=True, check=False)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("8 solutions", done.stdout)
            self.assertRegex(done.stdout, r"\d mm\n$")
            again = subprocess.run([CLI, "rerun", "ball.h5"], cwd=folder, capture_output=True, text=True, check=False)
            self.assertEqual(again.returncode, 0, again.stderr)

    def test_each_call_that_it_lists_is_there(self):
        import underact.arm
        import underact.scene
        import underact.sim

        page = (ROOT / "resources/guide/python.md").read_text(encoding="utf-8")
        rows = re.findall(r"^\| (`.*?) \|", page, re.M)
        found = [name for row in rows for name in re.findall(r"`(?:arm|scene|sim)\.(\w+)", row)]
        self.assertGreater(len(found), 12)
        holders = (underact.arm, underact.arm.Arm, underact.scene, underact.scene.Scene, underact.sim)
        for name in found:
            self.assertTrue(any(hasattr(holder, name) for holder in holders), name)
