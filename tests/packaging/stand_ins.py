"""A copy of some of our scripts in a folder of its own, with everything that they call replaced."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Notes that it was called, and with what.
CALLED = """#!/bin/sh
echo "$(basename "$0") $*" >>"$LOG"
"""


class Scripts(unittest.TestCase):
    """COPIES: scripts of ours, as they are. STAND_INS: the text of what they call, by place."""

    COPIES = ()
    STAND_INS = {}

    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="under act ")
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)
        for name in self.COPIES:
            (self.folder / name).parent.mkdir(exist_ok=True)
            shutil.copy(ROOT / name, self.folder / name)
        for name, text in self.STAND_INS.items():
            self.write(name, text)

    def write(self, name, text):
        (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
        (self.folder / name).write_text(text, encoding="utf-8")
        (self.folder / name).chmod(0o755)

    def call(self, script, *words, **more):
        """What the script said and how it ended, and the calls it made."""
        log = self.folder / "log"
        log.write_text("")
        more = {"PATH": f"{self.folder}/bin:{os.environ['PATH']}", "LOG": str(log), **more}
        done = subprocess.run(
            [self.folder / script, *words],
            cwd="/usr",
            env=more,
            capture_output=True,
            text=True,
            check=False,
            stdin=subprocess.DEVNULL,
        )
        return done, log.read_text().splitlines()
