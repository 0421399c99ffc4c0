"""The scripts that start the portable bundle run nothing of the folder one stands in."""

import pathlib
import shutil
import subprocess
import tempfile
import unittest

PORTABLE = pathlib.Path(__file__).resolve().parents[2] / "packaging/portable"
TOOLS = "readlink dirname basename uname grep sed sort head tail sha256sum cut mkdir mktemp find".split()
PATHS = ["", ":/usr/bin:/bin", "/usr/bin:/bin:", "/usr/bin::/bin", ".:/usr/bin:/bin", "bin:/usr/bin"]


class BundleScripts(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)
        self.strange = self.folder / "strange"
        for tool in TOOLS:
            for path in (self.strange / tool, self.strange / "bin" / tool):
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(f"#!/bin/sh\n: >'{self.folder}/mark'\n")
                path.chmod(0o755)

    def run_there(self, *words, path):
        done = subprocess.run(
            words,
            cwd=self.strange,
            env={"PATH": path, "HOME": str(self.folder)},
            capture_output=True,
            text=True,
            check=False,
        )
        self.assertFalse((self.folder / "mark").exists(), f"PATH={path}")
        return done

    def test_of_the_folder_that_is_unpacked(self):
        programs = self.folder / "usr/bin"
        programs.mkdir(parents=True)
        shutil.copy(PORTABLE / "AppRun", self.folder)
        shutil.copy("/bin/echo", programs / "underact-cli")
        for path in PATHS:
            done = self.run_there(self.folder / "AppRun", "cli", "started", path=path)
            self.assertEqual(done.stdout, "started\n", done.stderr)

    def test_of_the_file_itself(self):
        script = (PORTABLE / "header.sh").read_text(encoding="utf-8")
        for name, word in (("LINES", "9999"), ("SUM", "0"), ("NAME", "n"), ("VERSION", "1")):
            script = script.replace(f"@{name}@", word)
        file = self.folder / "Underact.run"
        file.write_text(script, encoding="utf-8")
        file.chmod(0o755)
        for path in PATHS:
            done = self.run_there(file, "--check", path=path)
            self.assertEqual(done.returncode, 4)
            self.assertIn("is incomplete or damaged", done.stderr)
