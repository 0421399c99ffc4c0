"""The bundles that make_bundles.py left, and how a program of one is run."""

import glob
import os
import shutil
import subprocess
import tempfile
import unittest

try:
    import elftools  # noqa: F401  what packaging/portable reads programs with: import this module first
except ImportError as missing:
    raise unittest.SkipTest(
        "pyelftools is not installed; packaging/install-deps package brings it"
    ) from missing

MADE = os.environ["UNDERACT_MADE"]


def made(kind, name="one"):
    """kind: AppDir, run or spdx.json."""
    found = glob.glob(os.path.join(MADE, name, f"Underact-*-x86_64.{kind}"))
    if len(found) != 1:
        raise unittest.SkipTest("the bundle was not made")
    return found[0]


def plain(**more):
    """An environment that knows nothing of this system's Qt, libraries or settings."""
    return {"PATH": "/usr/bin:/bin:/usr/sbin:/sbin", "LANG": "C.UTF-8", **more}


def call(*command, **more):
    """What a command said and how it ended, at home in a folder of its own."""
    with tempfile.TemporaryDirectory() as home:
        more.setdefault("HOME", home)
        return subprocess.run(
            command,
            capture_output=True,
            text=True,
            timeout=300,
            env=plain(**more),
            cwd=more["HOME"],
        )


class Moved(unittest.TestCase):
    """With a copy of the bundle in a folder with spaces, which may be changed."""

    def setUp(self):
        self.scratch = tempfile.mkdtemp(prefix="under act ")
        self.addCleanup(shutil.rmtree, self.scratch)
        self.folder = os.path.join(self.scratch, "moved to", "here.AppDir")
        shutil.copytree(made("AppDir"), self.folder, symlinks=True)
        self.app_run = os.path.join(self.folder, "AppRun")
        self.scene = os.path.join(self.folder, "usr/share/underact/scenes/02_sphere.json")
