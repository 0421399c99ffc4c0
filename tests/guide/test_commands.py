"""Every command that the guide shows runs, in a folder with what its readers have: the scenes, a
recorded session, a mesh, some poses. What cannot run here is in not_run.txt, with the reason.
"""

import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

from pages import ROOT, blocks, pages

BUILD = pathlib.Path(os.environ["UNDERACT_BUILD"])
STARTS = (
    "underact-cli ",
    "underact-sweep ",
    "underact ",
    "packaging/",
    "build/",
    "python3 -m ",
    "cmake ",
    "ctest ",
    "sudo ",
    "mpirun ",
)
MESH = (
    "solid a\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 9 0 0\n"
    "   vertex 0 9 0\n  endloop\n endfacet\nendsolid a\n"
)
RECORD = "underact-cli run scenes/02_sphere.json --hand sweep --seconds 5 --fast --record first.h5"


def commands():
    """(page, line, command, what the page shows of its output)."""
    for path, text in pages():
        for block in blocks(text):
            for index, (number, line) in enumerate(block):
                command = re.split(r"\s{3,}", line.removeprefix("$ ").strip())[0]
                while command.endswith("\\"):
                    index += 1
                    command = command[:-1] + block[index][1].strip()
                if not line.startswith("$ ") and not command.startswith(STARTS):
                    continue
                shown = block[index + 1][1] if index + 1 < len(block) else ""
                yield path.name, number, command, shown if shown.startswith("{") else ""


def reasons():
    """How commands begin that are not run, with the reason."""
    rows = (ROOT / "tests/guide/not_run.txt").read_text(encoding="utf-8").splitlines()
    pairs = [row.split(" | ") for row in rows if row and not row.startswith("#")]
    return {start.strip(): reason.strip() for start, reason in pairs}


def is_run(command):
    """Whether no reason speaks against it."""
    return not any(command == s or command.startswith(s + " ") for s in reasons())


class Commands(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="underact-guide-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        cls.env = {
            **os.environ,
            "PATH": f"{BUILD}:/usr/bin:{os.environ['PATH']}",
            "HOME": str(cls.folder),
            "XDG_CONFIG_HOME": str(cls.folder / "config"),
            "XDG_DATA_HOME": str(cls.folder / "data"),
            "PYTHONPATH": str(ROOT / "app/python"),
            "PYTHONDONTWRITEBYTECODE": "1",
        }
        shutil.copytree(ROOT / "scenes", cls.folder / "scenes", symlinks=True)
        shutil.copy(ROOT / "scenes/05_circle.json", cls.folder / "my_scene.json")
        (cls.folder / "bracket.stl").write_text(MESH)
        (cls.folder / "poses.txt").write_text('{"p_mm": [30, 0, 0]}\n')
        done = cls.run_one(RECORD)
        assert done.returncode == 0, done.stderr
        shutil.copy(cls.folder / "first.h5", cls.folder / "kept.h5")

    @classmethod
    def run_one(cls, command, folder=None):
        """As somebody types it."""
        return subprocess.run(
            ["bash", "-o", "pipefail", "-c", command],
            cwd=folder or cls.folder,
            env=cls.env,
            capture_output=True,
            text=True,
            timeout=80,
        )

    def check(self, row):
        """What is wrong with a command; nothing: None. In a folder of its own, so that none needs
        what another left, nor meets it."""
        page, line, command, shown = row
        where = f"{page}:{line}: {command}"
        with tempfile.TemporaryDirectory(dir=self.folder) as name:
            folder = pathlib.Path(name)
            for path in self.folder.iterdir():
                if path.name in ("scenes", "my_scene.json", "bracket.stl", "poses.txt"):
                    (folder / path.name).symlink_to(path)
            shutil.copy(self.folder / "kept.h5", folder / "first.h5")
            try:
                done = self.run_one(command, folder)
            except subprocess.TimeoutExpired:
                return f"{where}\ntook more than 80 s"
        if done.returncode != 0:
            return f"{where}\nexit status {done.returncode}\n{done.stderr[-600:]}"
        if shown:
            said = done.stdout.splitlines()[0] if done.stdout else ""
            for key in re.findall(r'"(\w+)":', shown):
                if f'"{key}"' not in said:
                    return f"{where}\nshows “{key}”, which is not in {said[:200]}"
        return None

    def test_each_runs_and_says_what_the_page_shows(self):
        wanted = list({row[2]: row for row in commands() if is_run(row[2])}.values())
        self.assertGreater(len(wanted), 20)
        if self.run_one("python3 -c 'import h5py, matplotlib, pandas'").returncode != 0:
            wanted = [row for row in wanted if not row[2].startswith("python3 ")]
        with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
            wrong = [said for said in pool.map(self.check, wanted) if said]
        self.assertEqual(wrong, [], "\n\n".join(wrong))

    def test_those_that_are_not_run_have_options_that_exist(self):
        for page, line, command, _ in commands():
            if is_run(command) or not command.startswith(("underact-cli ", "underact-sweep ")):
                continue
            words = command.split()
            path = [word for word in words[1:3] if re.fullmatch(r"[a-z][a-z-]*", word)]
            said = self.run_one(" ".join([words[0], *path, "--help"]))
            self.assertEqual(said.returncode, 0, f"{page}:{line}: {said.stderr}")
            for option in (word.split("=")[0] for word in words if word.startswith("--")):
                self.assertIn(option, said.stdout, f"{page}:{line}")

    def test_programs_that_are_not_run_are_there(self):
        for page, line, command, _ in commands():
            program = command.split()[0]
            if program.startswith("build/release/"):
                path = BUILD / program.removeprefix("build/release/")
            elif program.startswith("packaging/"):
                path = ROOT / program
            else:
                continue
            self.assertTrue(os.access(path, os.X_OK), f"{page}:{line}: {path}")

    def test_every_reason_is_needed(self):
        shown = [row[2] for row in commands()]
        for start, reason in reasons().items():
            self.assertGreater(len(reason), 10, start)
            self.assertTrue(any(c == start or c.startswith(start + " ") for c in shown), start)


class Scenes(unittest.TestCase):
    def test_the_json_of_pages_is_json(self):
        """Whole objects that a page shows; parts of one, with dots, are none."""
        count = 0
        for path, text in pages():
            for block in blocks(text):
                lines = "\n".join(line for _, line in block)
                if not lines.startswith("{") or "..." in lines or "…" in lines:
                    continue
                with self.subTest(page=path.name, line=block[0][0]):
                    json.loads(lines)
                    count += 1
        self.assertGreater(count, 3)


if __name__ == "__main__":
    unittest.main()
