"""What several tests share: a folder that goes away, the programs, the exit of a command line."""

from __future__ import annotations

import contextlib
import importlib
import io
import os
import tempfile
import unittest
from pathlib import Path

from underact.__main__ import main

ROOT = Path(__file__).resolve().parents[2]
CLI = Path(os.environ.get("UNDERACT_CLI", ROOT / "build/release/underact-cli"))
SOAK = os.environ.get("UNDERACT_SOAK") == "1"


class InFolder(unittest.TestCase):
    """A test with a folder of its own, self.folder."""

    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)


def command(*words: object) -> tuple[int, str, str]:
    """`python3 -m underact WORDS`: exit status, standard output, standard error."""
    out, error = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(error):
        try:
            status = main([str(word) for word in words])
        except SystemExit as end:
            status = end.code
    return status, out.getvalue(), error.getvalue()


def works(package: str) -> bool:
    """Whether a library can be loaded here."""
    try:
        importlib.import_module(package)
    except ImportError:
        return False
    return True
