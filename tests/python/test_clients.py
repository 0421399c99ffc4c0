"""The clients for other languages that lie beside the guide build and steer as it says; and
the notebook runs from its first cell to its last.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import unittest

from support import CLI, ROOT, InFolder, works

GUIDE = ROOT / "resources/guide"
PAGE = GUIDE / "live_service.md"


def blocks(heading: str) -> list[str]:
    """The indented blocks below a heading, up to the next one."""
    section = PAGE.read_text(encoding="utf-8").split(f"\n### {heading}\n")[1].split("\n#")[0]
    found = re.findall(r"(?:^(?:    .*)?\n)*^    .*\n", section, re.MULTILINE)
    return ["\n".join(line[4:] for line in block.strip("\n").split("\n")) + "\n" for block in found]


class Clients(InFolder):
    """A test with a service that records."""

    def setUp(self) -> None:
        super().setUp()
        words = [CLI, "serve", str(ROOT / "scenes/02_sphere.json"), "--port", "0"]
        words += ["--record", str(self.folder / "steered.h5")]
        service = subprocess.Popen(
            words,
            stdout=subprocess.PIPE,
            text=True,
            env={**os.environ, "XDG_RUNTIME_DIR": str(self.folder)},
        )
        self.addCleanup(lambda: (service.terminate(), service.wait(), service.stdout.close()))
        self.service = service
        said = json.loads(service.stdout.readline())
        self.port = said["serving"].rpartition(":")[2]
        self.token_file = said["token_file"]

    def has_steered(self) -> None:
        """The session has a wall, and targets that were on their way."""
        import underact

        self.service.terminate()
        self.assertEqual(self.service.wait(), 0)
        with underact.Session(self.folder / "steered.h5") as session:
            self.assertIn("floor", json.dumps(session.changes[-1].scene))


class OfOtherLanguages(Clients):
    def test_cpp(self) -> None:
        (build,) = blocks("C++")
        shutil.copy(GUIDE / "live_wall.cpp", self.folder)
        compile_it, start = build.splitlines()
        words = [*compile_it.split(), "-Wall", "-Wextra", "-Werror"]
        subprocess.run(words, cwd=self.folder, check=True)
        words = [start.split()[0], self.port, self.token_file]
        said = subprocess.check_output(words, cwd=self.folder, text=True)
        self.assertRegex(said, r'"ok": true, "tick": \d+, "mode": "stopped"')
        self.has_steered()

    @unittest.skipUnless(shutil.which("octave"), "octave is not installed")
    def test_octave(self) -> None:
        (script,) = blocks("MATLAB and Octave")
        shutil.copy(GUIDE / "underact_live.m", self.folder)
        connect = f"underact_live({self.port}, '{self.token_file}')"
        script = re.sub(r"underact_live\(.*\)", connect, script)
        (self.folder / "script.m").write_text(
            script
            + "try, ask('set', 'values', containers.Map('/control/kp', 1))\n"
            + "catch e, disp(e.message), end\n"
            + "disp(numel(ask('settings').settings) > 20)\n"
        )
        done = subprocess.run(
            ["octave", "--no-gui", "--norc", "script.m"],
            cwd=self.folder,
            capture_output=True,
            text=True,
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        first, refused, has_settings = done.stdout.splitlines()
        self.assertRegex(first, r"^stopped in tick \d+$")
        self.assertIn("Did you mean", refused)
        self.assertEqual(has_settings.strip(), "1")
        self.has_steered()

    @unittest.skipUnless(works("websockets"), "python3-websockets is not installed")
    def test_notebook(self) -> None:
        notebook = json.loads((ROOT / "resources/guide/live_service.ipynb").read_text("utf-8"))
        cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
        # The last expression of a cell is what a notebook shows: it is run like any other line.
        lines = "\n".join("".join(cell["source"]) for cell in cells)
        lines = lines.replace('name="notebook"', f'name="notebook", port={self.port}')
        done = subprocess.run(
            [sys.executable, "-c", lines + "\nprint(force_N.max())"],
            capture_output=True,
            text=True,
            env={**os.environ, "XDG_RUNTIME_DIR": str(self.folder), "MPLBACKEND": "agg"},
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        refused, most_N = done.stdout.splitlines()
        self.assertIn("A gain must be 0 or above", refused)
        self.assertGreater(float(most_N), 0.5)
        kept = [cell for cell in cells if cell["outputs"]]
        self.assertEqual(len(kept), len(cells) - 1, "only the last cell shows nothing")
        self.has_steered()


if __name__ == "__main__":
    unittest.main()
