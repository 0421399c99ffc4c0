"""Every command that the guide and the README show runs, in a folder with what its readers have:
the scenes, a recorded session, a mesh, some poses; the commands of a block one after the other.
What a page shows below a command is what the command prints (shown.py). What cannot run here is in
not_run.txt, with the reason; what takes long is in soak_only.txt, and runs where UNDERACT_SOAK is
set.
"""

import concurrent.futures
import dataclasses
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

from pages import ROOT, blocks, commanding, pages
from shown import difference

BUILD = pathlib.Path(os.environ["UNDERACT_BUILD"])
STARTS = (
    "underact-cli ",
    "underact-sweep ",
    "underact ",
    "echo ",
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
LESSON = ("springs.json", "pull.json")  # as writing_lessons.md shows them
GIVEN = ("scenes", "build", "my_scene.json", "bracket.stl", "poses.txt")
RECORD = "underact-cli run scenes/02_sphere.json --hand sweep --seconds 5 --fast --record first.h5"


@dataclasses.dataclass(frozen=True)
class Command:
    """A command as a page shows it, with what it shows of the output. differs: from run to run, in
    its numbers."""

    page: str
    line: int
    text: str
    output: str = ""
    differs: bool = False


def command_at(page, block, index):
    """The command that begins there, without its output, and the index after it; none: another
    line."""
    number, line = block[index]
    text, *remark = re.split(r"\s{3,}", line.removeprefix("$ ").strip(), maxsplit=1)
    if not line.startswith("$ ") and not text.startswith(STARTS):
        return None, index
    while text.endswith("\\") and index + 1 < len(block):
        index += 1
        text = text[:-1] + block[index][1].strip()
    return Command(page, number, text, differs="differs" in "".join(remark)), index + 1


def commands_of(page, block):
    """The commands of a block in order. Where they have a dollar, their output is below them, which
    may be a command itself."""
    found, index = [], 0
    has_output = block[0][1].startswith("$ ")

    def begins_at(at):
        return (not has_output or block[at][1].startswith("$ ")) and command_at(page, block, at)[0]

    while index < len(block):
        command, after = command_at(page, block, index)
        index = max(after, index + 1)
        if not command:
            continue
        lines = []
        while index < len(block) and not begins_at(index):
            lines.append(block[index][1])
            index += 1
        found.append(dataclasses.replace(command, output="\n".join(lines) if has_output else ""))
    return found


def sessions():
    """The commands of each block that has some."""
    for path, text in commanding():
        for block in blocks(text):
            found = commands_of(path.name, block)
            if found:
                yield found


def commands():
    """All commands."""
    return [command for session in sessions() for command in session]


def listed(name):
    """How commands begin that a file lists, with the reason."""
    rows = (ROOT / "tests/guide" / name).read_text(encoding="utf-8").splitlines()
    pairs = [row.rsplit(" | ", 1) for row in rows if row and not row.startswith("#")]
    return {start.strip(): reason.strip() for start, reason in pairs}


def begins(command, starts):
    """Whether a command begins with one of these."""
    return any(command == start or command.startswith(start + " ") for start in starts)


def is_run(command):
    """Whether no reason speaks against it here."""
    if begins(command, listed("not_run.txt")):
        return False
    return bool(os.environ.get("UNDERACT_SOAK")) or not begins(command, listed("soak_only.txt"))


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
        page = (ROOT / "resources/guide/writing_lessons.md").read_text(encoding="utf-8")
        for name, text in zip(LESSON, re.findall(r"```json\n(.*?)```", page, re.DOTALL)):
            (cls.folder / name).write_text(text)
        (cls.folder / "build").mkdir()
        (cls.folder / "build/release").symlink_to(BUILD)
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
            timeout=1800 if os.environ.get("UNDERACT_SOAK") else 80,
        )

    def check(self, session):
        """What is wrong with the commands of a block; nothing: None. In a folder of their own, so
        that they need nothing that another block left, nor meet it."""
        with tempfile.TemporaryDirectory(dir=self.folder) as name:
            folder = pathlib.Path(name)
            for path in self.folder.iterdir():
                if path.name in (*GIVEN, *LESSON):
                        (folder / path.name).symlink_to(path)
            if not any("--record first.h5" in command.text for command in session):
                shutil.copy(self.folder / "kept.h5", folder / "first.h5")
            for command in session:
                wrong = is_run(command.text) and self.wrong_with(command, folder)
                if wrong:
                    return f"{command.page}:{command.line}: {command.text}\n{wrong}"
        return None

    def wrong_with(self, command, folder):
        """What is wrong with one command; nothing: None."""
        try:
            done = self.run_one(command.text, folder)
        except subprocess.TimeoutExpired as late:
            return f"took more than {late.timeout} s"
        if done.returncode != 0:
            return f"exit status {done.returncode}\n{done.stderr[-600:]}"
        if not command.output:
            return None
        return difference(command.output, done.stdout + done.stderr, not command.differs)

    def test_each_runs_and_prints_what_the_page_shows(self):
        alike = {tuple((c.text, c.output) for c in session): session for session in sessions()}
        wanted = [session for session in alike.values() if any(is_run(c.text) for c in session)]
        self.assertGreater(sum(len(session) for session in wanted), 30)
        shown = [c for session in wanted for c in session if c.output and is_run(c.text)]
        self.assertGreater(len(shown), 8, "outputs are found no longer")
        if self.run_one("python3 -c 'import h5py, matplotlib, pandas'").returncode != 0:
            wanted = [session for session in wanted if "python3 " not in session[0].text]
        with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
            wrong = [said for said in pool.map(self.check, wanted) if said]
        self.assertEqual(wrong, [], "\n\n".join(wrong))

    def test_a_number_that_was_changed_by_hand_is_found(self):
        command = next(c for c in commands() if c.output and "calibrate" in c.text)
        printed = self.run_one(command.text)
        self.assertIsNone(difference(command.output, printed.stdout), printed.stderr)
        numbers = re.findall(r"\d\.\d+", command.output)
        self.assertGreater(len(numbers), 2)
        for number in numbers:
            other = number[:-1] + str((int(number[-1]) + 1) % 10)
            changed = command.output.replace(number, other, 1)
            said = difference(changed, printed.stdout)
            self.assertIn(f"{other} is shown", said or "", f"nobody notices {other} for {number}")

    def test_those_that_are_not_run_have_options_that_exist(self):
        for command in commands():
            where = f"{command.page}:{command.line}"
            if is_run(command.text):
                continue
            if not command.text.startswith(("underact-cli ", "underact-sweep ")):
                continue
            words = command.text.split()
            path = [word for word in words[1:3] if re.fullmatch(r"[a-z][a-z-]*", word)]
            said = self.run_one(" ".join([words[0], *path, "--help"]))
            self.assertEqual(said.returncode, 0, f"{where}: {said.stderr}")
            for option in (word.split("=")[0] for word in words if word.startswith("--")):
                self.assertIn(option, said.stdout, where)

    def test_programs_that_are_not_run_are_there(self):
        for command in commands():
            program = command.text.split()[0]
            if program.startswith("build/release/"):
                path = BUILD / program.removeprefix("build/release/")
            elif program.startswith("packaging/"):
                path = ROOT / program
            else:
                continue
            self.assertTrue(os.access(path, os.X_OK), f"{command.page}:{command.line}: {path}")

    def test_every_reason_is_needed(self):
        shown = [command.text for command in commands()]
        for start, reason in (listed("not_run.txt") | listed("soak_only.txt")).items():
            self.assertGreater(len(reason), 10, start)
            self.assertTrue(any(begins(text, [start]) for text in shown), start)


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
