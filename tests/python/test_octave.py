"""The Octave lines of the page do what it says, on a session that the program recorded."""

import shutil
import subprocess
import unittest

from support import CLI, ROOT, InFolder
from test_pages import blocks


@unittest.skipUnless(
    shutil.which("octave"), "octave is not installed, so the page's lines for it were not checked."
)
class Octave(InFolder):
    def test_opens_a_session_with_the_lines_of_the_page(self):
        words = [
            "run",
            ROOT / "scenes/02_sphere.json",
            "--hand",
            "probe",
            "--seconds",
            "1.25",
            "--fast",
        ]
        subprocess.run(
            [CLI, *words, "--record", self.folder / "first.h5"],
            check=True,
            stdout=subprocess.DEVNULL,
        )
        lines = blocks("## Octave and MATLAB")[0]
        self.assertIn('load("-hdf5"', lines)
        done = subprocess.run(
            ["octave", "--no-gui", "--norc", "--eval", lines],
            cwd=self.folder,
            capture_output=True,
            text=True,
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"^1250 ticks, largest force 0\.\d\d\d N\n")
        self.assertIn('"title": "Sphere"', done.stdout)
        self.assertTrue(done.stdout.rstrip().endswith("}"))


if __name__ == "__main__":
    unittest.main()
