"""A session is followed while another program writes it."""

import os
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

import numpy as np
from session_writer import Writer, sphere_ticks, write_session
from support import CLI, ROOT, InFolder
from underact import Session, SessionError

WRITER = """
import sys, time
from session_writer import Writer, sphere_ticks
writer = Writer(sys.argv[1])
writer.start_swmr()
writer.flush()
print("ready", flush=True)
for block in range(8):
    writer.ticks(sphere_ticks(100, 1 + 100 * block))
    writer.flush()
    time.sleep(0.05)
writer.ticks(sphere_ticks(37, 801))
writer.end(837)
"""


def opened(path: Path, wait_s: float = 20.0) -> Session:
    """The session as soon as there is one: a program that begins has to make the file first."""
    until = time.monotonic() + wait_s
    while True:
        try:
            return Session(path)
        except SessionError:
            if time.monotonic() > until:
                raise
            time.sleep(0.02)


class Following(InFolder):
    def test_gives_every_row_once_as_it_comes(self):
        path = self.folder / "a.h5"
        writer = subprocess.Popen(
            [sys.executable, "-c", WRITER, str(path)], stdout=subprocess.PIPE, text=True
        )
        self.addCleanup(writer.wait)
        self.addCleanup(writer.stdout.close)
        self.assertEqual(writer.stdout.readline(), "ready\n")
        with Session(path) as session:
            self.assertFalse(session.complete)
            parts = list(session.follow(poll_s=0.01, timeout_s=30))
            self.assertTrue(session.complete)
        self.assertGreater(len(parts), 1)  # it came while it was written, not all at the end
        for name, values in sphere_ticks(837).items():
            if name in (
                "v_WT_mm_per_s",
                "lateness_us",
                "tick_us",
            ):  # differ by where a call of sphere_ticks begins
                continue
            np.testing.assert_array_equal(
                np.concatenate([part[name] for part in parts]), values, name
            )

    def test_of_a_whole_session_gives_it_and_ends(self):
        with Session(write_session(self.folder / "a.h5", 250)) as session:
            self.assertEqual([len(part["tick"]) for part in session.follow()], [250])

    def test_ends_when_nothing_comes(self):
        writer = Writer(self.folder / "a.h5")
        writer.start_swmr()
        writer.ticks(sphere_ticks(200))
        writer.flush()
        with Session(self.folder / "a.h5") as session:
            self.assertEqual(
                sum(len(part["tick"]) for part in session.follow(0.01, timeout_s=0.2)), 200
            )
        writer.file.close()

    def test_waits_for_a_block_to_be_whole(self):
        writer = Writer(self.folder / "a.h5")
        writer.start_swmr()
        writer.ticks(sphere_ticks(150))
        writer.flush()
        with Session(self.folder / "a.h5") as session:
            rows = [len(part["tick"]) for part in session.follow(0.01, timeout_s=0.2)]
        self.assertEqual(rows, [100])
        writer.end(150)
        with Session(self.folder / "a.h5") as session:
            self.assertEqual([len(part["tick"]) for part in session.follow()], [150])

    def test_ends_when_told(self):
        writer = Writer(self.folder / "a.h5")
        writer.start_swmr()
        writer.ticks(sphere_ticks(200))
        writer.flush()
        seen = []
        with Session(self.folder / "a.h5") as session:
            for part in session.follow(0.01, stop=lambda: bool(seen)):
                seen.append(len(part["tick"]))
        self.assertEqual(seen, [200])
        writer.file.close()


class TheProgram(InFolder):
    """What underact-cli writes, not the double of the tests."""

    def start(self, *more: str) -> subprocess.Popen:
        words = [
            "run",
            ROOT / "scenes/02_sphere.json",
            "--hand",
            "sweep",
            "--record",
            self.folder / "a.h5",
            *more,
        ]
        program = subprocess.Popen(
            [CLI, *words], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        self.addCleanup(program.wait)
        return program

    def test_is_followed_while_it_records(self):
        program = self.start("--seconds", "1.5")
        with opened(self.folder / "a.h5") as session:
            parts = list(session.follow(poll_s=0.02, timeout_s=30))
            self.assertTrue(session.complete)
            self.assertEqual(session.end.dropped, 0)
        self.assertEqual(program.wait(), 0)
        self.assertGreater(len(parts), 1)
        ticks = np.concatenate([part["tick"] for part in parts])
        np.testing.assert_array_equal(ticks, ticks[0] + np.arange(1500))

    def test_that_is_killed_leaves_what_opens(self):
        program = self.start("--seconds", "60")
        with opened(self.folder / "a.h5") as session:
            next(session.follow(poll_s=0.02, timeout_s=30))
        time.sleep(0.5)
        os.kill(program.pid, signal.SIGKILL)
        program.wait()
        with Session(self.folder / "a.h5") as session:
            self.assertFalse(session.complete)
            self.assertGreaterEqual(session.ticks.rows, 100)
            self.assertEqual(session.scene["title"], "Sphere")
            self.assertEqual(session.ticks.damage, [])


if __name__ == "__main__":
    unittest.main()
