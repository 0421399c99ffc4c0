"""The package as a wheel lays it out, in a folder of its own: with the compiled part, and without. Wheels themselves, by pip, are
packaging/soak's, since making them takes tools from PyPI.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from beside import CLI, ROOT

BUILD = CLI.resolve().parent
FIRST_STEPS = """
from underact import arm, scene, sim
omni = arm.load("omni-thesis")
assert len(omni.ik(omni.fk([0.1, 0.5, -0.3, 0.2, 0.7, 0.4]))) == 8
knot = scene.read({scene!r})
assert len(knot.mesh(0)[0]) > 100
with sim.simulate(knot, "sweep", 0.2, {session!r}) as session:
    assert len(session.ticks["tick"]) == 200
print(arm.__file__)
"""


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.holder.cleanup)
        cls.folder = Path(cls.holder.name)
        shutil.copytree(ROOT / "app/python/underact", cls.folder / "underact", ignore=shutil.ignore_patterns("__pycache__"))
        command = ["cmake", "--install", BUILD, "--component", "module", "--prefix", cls.folder]
        subprocess.run(command, check=True, capture_output=True)
        cls.module = next((cls.folder / "underact").glob("_core.*.so"))

    def python(self, program: str) -> subprocess.CompletedProcess:
        """Runs it where nothing of the build is found."""
        path = {name: value for name, value in os.environ.items() if not name.startswith(("UNDERACT_", "PYTHONPATH"))}
        words = f"import sys; sys.path.insert(0, {str(self.folder)!r})\n{program}"
        return subprocess.run([sys.executable, "-P", "-c", words], cwd="/", env=path, capture_output=True, text=True, check=False)

    def test_it_runs_from_there_and_reads_meshes_with_its_own_reader(self):
        scene = str(ROOT / "scenes/25_torus_knot.json")
        done = self.python(FIRST_STEPS.format(scene=scene, session=str(self.folder / "a.h5")))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(done.stdout.startswith(str(self.folder)), done.stdout)

    def test_it_takes_no_library_of_the_window_and_shows_one_name(self):
        libraries = subprocess.run(["ldd", self.module], capture_output=True, text=True, check=True).stdout
        self.assertIn("libhdf5", libraries)
        self.assertIsNone(re.search(r"libQt|libvtk|libGL|libX11|not found", libraries), libraries)
        names = subprocess.run(["nm", "-D", "--defined-only", self.module], capture_output=True, text=True, check=True).stdout
        self.assertEqual([line.split()[-1] for line in names.splitlines()], ["PyInit__core"])

    def test_without_the_compiled_part_sessions_are_read_and_arms_say_what_is_missing(self):
        away = self.module.with_suffix(".away")
        self.module.rename(away)
        try:
            done = self.python("import underact; underact.Session\ntry:\n underact.arm\nexcept ImportError as e: print(e)")
        finally:
            away.rename(self.module)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"^The compiled part of the package underact cannot be loaded .*pip install \.")


if __name__ == "__main__":
    unittest.main()
