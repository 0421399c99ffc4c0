"""Whoever builds one of the programs has built what it starts and opens, too."""

import os
import pathlib
import re
import subprocess
import unittest

BUILD = os.environ["UNDERACT_BUILD"]
NINJA = os.environ["UNDERACT_NINJA"]
ROOT = pathlib.Path(__file__).resolve().parents[2]


def helpers():
    """The programs that only other programs start, as the rooms say."""
    rooms = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.findall(r"PROGRAM (\S+) IN \$\{UNDERACT_HELPERS\}", rooms)


def inputs(program):
    """The names of all files that are made before the program is; none: it is not built here."""
    done = subprocess.run(  # not its tool "inputs", which of several files made together tells the first
        [NINJA, "-C", BUILD, "-t", "graph", program], capture_output=True, text=True, check=False
    )
    return {pathlib.Path(name).name for name in re.findall(r'label="([^"]+)"\]', done.stdout)}


@unittest.skipUnless(NINJA, "not built with Ninja, which could be asked")
class BuiltWith(unittest.TestCase):
    def setUp(self):
        all_programs = ("underact", "underact-cli", "underact-sweep")
        self.inputs = {program: inputs(program) for program in all_programs}
        if not self.inputs["underact"]:
            del self.inputs["underact"]  # built without the window

    def test_the_helpers(self):
        self.assertIn("underact-guard", helpers())
        self.assertIn("underact-mesh-reader", helpers())
        for program, made in self.inputs.items():
            for helper in helpers():
                self.assertIn(helper, made, f"{program} does not bring {helper}")

    def test_the_meshes_that_scenes_name(self):
        wanted = set()
        for scene in (ROOT / "scenes").glob("*.json"):
            wanted.update(re.findall(r'"meshes/([^"]+)"', scene.read_text(encoding="utf-8")))
        self.assertGreaterEqual(len(wanted), 3)
        for program, made in self.inputs.items():
            self.assertEqual(wanted - made, set(), program)

    def test_the_command_line_behind_the_window(self):
        for program in self.inputs:
            if program == "underact":
                self.assertIn("underact-cli", self.inputs[program])
