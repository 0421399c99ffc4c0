"""The programs that the figures are made with: underact-cli, and the window for pictures of its
view.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path

from ..errors import SessionError

_USAGE = 2  # the exit status of wrong usage


class ProgramError(SessionError):
    """A program did not do what a figure needs; `str()` holds what it said, `status` its exit
    status.
    """

    def __init__(self, sentence: str, status: int | None = None):
        super().__init__(sentence)
        self.status = status


class Programs:
    """cli: underact-cli. window: underact, or None."""

    def __init__(self, cli: Path, window: Path | None):
        self.cli, self.window = cli, window
        self._has_lab: bool | None = None

    def _call(self, words: list[str], given: str | None = None) -> str:
        try:
            done = subprocess.run(
                [str(self.cli), *words], input=given, capture_output=True, text=True, check=False
            )
        except OSError as error:
            raise ProgramError(f"{self.cli} cannot be run: {error.strerror}.") from error
        if done.returncode != 0:
            output = (done.stderr or done.stdout).strip()
            sentence = f"{self.cli.name} {' '.join(words)} ended with {done.returncode}: {output}"
            raise ProgramError(sentence, done.returncode)
        return done.stdout

    def run(self, scene: Path, hand: Path, seconds: float, record: Path) -> dict:
        """Runs a scene with a scripted hand into a session file; gives the run's summary."""
        words = [
            "run",
            str(scene),
            "--hand",
            str(hand),
            "--seconds",
            f"{seconds:g}",
            "--fast",
            "--seed",
            "1",
        ]
        return json.loads(self._call([*words, "--record", str(record), "--overwrite"]))

    def answers(self, words: list[str], questions: list[dict]) -> list[dict]:
        """A command that answers each JSON line with one: target, ik, fk."""
        text = self._call(words, "".join(json.dumps(question) + "\n" for question in questions))
        return [json.loads(line) for line in text.splitlines()]

    def lab_step(self, numerator: list[float], denominator: list[float]) -> dict | None:
        """The marks of a unit step as the program finds them; None where this version has no
        lab.
        """
        if self._has_lab is None:
            try:  # a program without a lab answers "wrong usage"
                self._call(["lab", "step", "--num=1", "--den=1,1", "--json"])
                self._has_lab = True
            except ProgramError as error:
                if error.status != _USAGE:
                    raise
                self._has_lab = False
        if not self._has_lab:
            return None
        terms = [",".join(repr(float(term)) for term in side) for side in (numerator, denominator)]
        return json.loads(
            self._call(["lab", "step", f"--num={terms[0]}", f"--den={terms[1]}", "--json"])
        )

    def picture(self, scene: Path, out: Path) -> str:
        """Draws the 3D view of a scene; gives "" or, where that cannot be done here, why."""
        if self.window is None:
            return "Left out: the window draws this picture, and --window was not given."
        if not self.window.is_file():
            return f"Left out: {self.window.name}, which draws it, was not found."
        command, surroundings = [
            str(self.window),
            "--picture",
            str(scene),
            "--out",
            str(out),
        ], dict(os.environ)
        if not (surroundings.get("DISPLAY") or surroundings.get("WAYLAND_DISPLAY")):
            if shutil.which("xvfb-run") is None:
                return "Left out: drawing it needs a display or xvfb-run."
            command = ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", *command]
            surroundings.update(QT_QPA_PLATFORM="xcb", LIBGL_ALWAYS_SOFTWARE="1")
        try:
            done = subprocess.run(
                command, env=surroundings, capture_output=True, text=True, timeout=120, check=False
            )
        except (OSError, subprocess.TimeoutExpired) as error:
            return f"Left out: the window did not draw it ({error})."
        if done.returncode != 0 or not out.is_file():
            return f"Left out: the window did not draw it (it ended with {done.returncode})."
        return ""
