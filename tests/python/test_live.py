"""The live service through its sockets, and the client in Python: what is steered from outside is
in the session, a client that dies or sleeps harms nobody, and browsers stay out.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import re
import signal
import stat
import subprocess
import sys
import textwrap
import time
import unittest
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import underact
from support import CLI, ROOT, InFolder, works
from underact.live import LiveError, Refused

ROOM = {
    "underact_scene": 1,
    "title": "Room",
    "constraints": [
        {"name": "ball", "type": "sphere", "center_mm": [0, 0, 20], "radius_mm": 40},
        {
            "name": "wall",
            "type": "plane",
            "point_mm": [0, -20, 0],
            "normal": [0, 1, 0],
            "side": "outside",
        },
    ],
}


@unittest.skipUnless(works("websockets"), "python3-websockets is not installed")
class Served(InFolder):
    """A test with a service of its own."""

    def setUp(self) -> None:
        super().setUp()
        (self.folder / "room.json").write_text(json.dumps(ROOM))

    @contextlib.contextmanager
    def service(self, *options: object) -> Iterator[subprocess.Popen[str]]:
        words = [CLI, "serve", self.folder / "room.json", "--port", 0, *options]
        surroundings = {**os.environ, "XDG_RUNTIME_DIR": str(self.folder)}
        with subprocess.Popen(
            [str(word) for word in words],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env=surroundings,
        ) as process:
            try:
                assert process.stdout is not None
                line = process.stdout.readline()
                self.assertTrue(line, process.poll() is not None and process.stderr.read())
                self.said = said = json.loads(line)
                self.url, self.token_file = said["serving"], Path(said["token_file"])
                self.token = self.token_file.read_text().strip()
                yield process
            finally:
                process.kill()

    def connect(self, name: str = "test") -> underact.Live:
        return underact.connect(self.url, token=self.token, name=name)

    def end(self, process: subprocess.Popen[str]) -> None:
        process.send_signal(signal.SIGTERM)
        _, errors = process.communicate(timeout=20)
        self.assertEqual((process.returncode, errors), (0, ""))

    def printed(self, *words: object) -> str:
        done = subprocess.run(
            [CLI, *map(str, words)], capture_output=True, text=True, timeout=120, check=False
        )
        self.assertEqual(done.returncode, 0, f"{words}: {done.stdout} {done.stderr}")
        return done.stdout

    def cli(self, *words: object) -> dict:
        return json.loads(self.printed(*words))


class Service(Served):
    def test_says_where_it_is_and_keeps_its_token_to_its_owner(self):
        with self.service() as process:
            self.assertRegex(self.url, r"^ws://127\.0\.0\.1:\d+$")
            self.assertEqual(stat.S_IMODE(self.token_file.stat().st_mode), 0o600)
            self.end(process)
        self.assertFalse(self.token_file.exists())

    def test_takes_a_token_from_a_file_and_refuses_one_that_others_can_read(self):
        file = self.folder / "token"
        file.write_text("a-token-of-my-own-0123456789\n")
        file.chmod(0o600)
        with self.service("--token-file", file) as process:
            with self.connect() as live:
                self.assertEqual(live.about["version"], 1)
            self.end(process)
        self.assertTrue(file.exists())
        file.chmod(0o644)
        done = subprocess.run(
            [CLI, "serve", "--port", "0", "--token-file", file], capture_output=True, timeout=60
        )
        self.assertEqual(done.returncode, 4)
        self.assertIn(b"chmod 600", done.stderr)

    def test_closes_where_a_frame_is_too_long_or_the_token_is_wrong(self):
        with self.service():
            with self.assertRaises(Refused) as refused:
                underact.connect(self.url, token="x" * 64)
            self.assertEqual(refused.exception.problems[0][0], "/token")
            with self.connect() as live, self.assertRaises(LiveError):
                live.mark("x" * (1 << 20))
            with self.connect() as live:  # the service is still there
                self.assertEqual(live.about["mode"], "stopped")

    def test_thousands_of_connections_leave_it_as_it_was(self):
        import socket

        count = 10_000 if os.environ.get("UNDERACT_SOAK") == "1" else 300
        port = 0
        with self.service() as process, self.connect() as live:
            port = int(self.url.rsplit(":", 1)[1])
            for _ in range(count):
                with contextlib.closing(socket.create_connection(("127.0.0.1", port))) as one:
                    one.sendall(b"GET / HTTP/1.1\r\n")
            self.assertEqual(live.status()["clients"], ["test"])
            open_files = len(os.listdir(f"/proc/{process.pid}/fd"))
            self.assertLess(open_files, 100)


class Client(Served):
    def test_reads_and_sets_settings_by_their_paths(self):
        with self.service(), self.connect() as live:
            live.settings["/control/kp_N_per_mm"] = 0.25
            self.assertEqual(live.settings["/control/kp_N_per_mm"], 0.25)
            self.assertIn("/constraints/1/side", live.settings._ipython_key_completions_())
            row = live.settings.table()["/control/kp_N_per_mm"]
            self.assertEqual((row["type"], row["unit"], row["default"]), ("gain", "N/mm", 0.5))
            self.assertFalse(live.settings.table()["/control/kd_N_s_per_mm"]["applies"])
            with self.assertRaises(Refused) as refused:
                live.settings["/control/kp"] = 1.0
            self.assertEqual(refused.exception.problems[0][0], "/control/kp")

    def test_has_ticks_as_arrays(self):
        with self.service("--start"), self.connect() as live:
            columns = ["p_WT_mm", "force_sent_N", "fault"]
            seen = []
            for ticks in live.ticks(columns, hz=1000):
                self.assertEqual(ticks["p_WT_mm"].shape, (len(ticks["tick"]), 3))
                seen.extend(ticks["tick"])
                if len(seen) >= 300:
                    break
            self.assertEqual(live.lost, 0)
            self.assertTrue((np.diff(seen) == 1).all())

    def test_works_with_asyncio(self):
        async def steer() -> int:
            async with await underact.connect_async(self.url, token=self.token) as live:
                await live.start()
                await live.move("wall", over_ms=20, point_mm=np.array([0.0, -10.0, 0.0]))
                count = 0
                async for ticks in live.ticks(["error_mm"], hz=100):
                    count += len(ticks["tick"])
                    if count >= 10:
                        return count
            return 0

        with self.service():
            self.assertGreaterEqual(asyncio.run(steer()), 10)

    def test_tells_what_to_do_where_nobody_serves(self):
        with self.assertRaises(LiveError) as gone:
            underact.connect("ws://127.0.0.1:9", token="x")
        self.assertIn("underact-cli serve", str(gone.exception))


class ThePage(Served):
    """What resources/guide/live_service.md shows is what happens."""

    def blocks(self) -> list[str]:
        text = (ROOT / "resources/guide/live_service.md").read_text(encoding="utf-8")
        found = re.findall(r"(?:^(?:    .*)?\n)+", text, flags=re.MULTILINE)
        return [textwrap.dedent(block).strip("\n") for block in found if block.strip()]

    def test_has_examples_that_run(self):
        shown = [block for block in self.blocks() if "underact.connect" in block]
        self.assertEqual(len(shown), 5)
        for lines in shown:
            self.assertLess(len(lines.splitlines()), 25)
            port = 0
            with self.service("--token-file", self.folder / "token"):
                port = int(self.url.rsplit(":", 1)[1])
                here = f"port={port}, token_file={str(self.folder / 'token')!r}, "
                done = subprocess.run(
                    [sys.executable, "-B", "-c", lines.replace("(name=", f"({here}name=")],
                    cwd=self.folder,
                    env={**os.environ, "MPLBACKEND": "agg"},
                    capture_output=True,
                    text=True,
                    timeout=120,
                )
                self.assertEqual(done.returncode, 0, lines + "\n" + done.stderr)
        rows = (self.folder / "trials.csv").read_text().splitlines()
        self.assertEqual(len(rows), 6)

    def test_shows_a_transcript_that_is_one(self):
        block = next(block for block in self.blocks() if block.startswith('> {"id": 1'))
        lines = block.splitlines()

        def form(value: object) -> object:
            """Without what differs from run to run: numbers."""
            if isinstance(value, dict):
                return {key: form(one) for key, one in value.items()}
            if isinstance(value, list):
                return [form(one) for one in value]
            return "a number" if type(value) in (int, float) else value

        async def talk() -> list[dict]:
            import websockets

            heard = []
            async with websockets.connect(self.url) as socket:
                for at, line in enumerate(lines):
                    if line.startswith("> "):
                        await socket.send(line[2:].replace("THE TOKEN", self.token))
                        continue
                    wanted = json.loads(line[2:])
                    while True:
                        message = json.loads(await asyncio.wait_for(socket.recv(), 20))
                        same = message.get("id") == wanted.get("id")
                        if same and message.keys() == wanted.keys():
                            break
                    heard.append((at, wanted, message))
            return heard

        with self.service():
            for at, wanted, message in asyncio.run(talk()):
                if "ticks" in wanted:
                    self.assertEqual(list(message["ticks"]), list(wanted["ticks"]))
                else:
                    self.assertEqual(form(message), form(wanted), lines[at])


class Typed(unittest.TestCase):
    @unittest.skipUnless(works("mypy"), "mypy is not installed")
    def test_by_mypy_strictly(self):
        words = ["--strict", "--follow-imports=silent", "--ignore-missing-imports"]
        file = ROOT / "app/python/underact/live.py"
        done = subprocess.run(
            [sys.executable, "-m", "mypy", *words, file], capture_output=True, text=True
        )
        self.assertEqual(done.returncode, 0, done.stdout)


STEER = """
import random, sys, underact
random.seed(int(sys.argv[3]))
with underact.connect(sys.argv[1], token=sys.argv[2], name="steerer") as live:
    live.start()
    print("steers", flush=True)
    while True:
        act = random.randrange(5)
        if act == 0:
            live.force([random.uniform(-1, 1) for _ in range(3)], for_ms=random.randrange(1, 200))
        elif act == 1:
            live.set({"/control/kp_N_per_mm": random.uniform(0, 0.8)})
        else:
            y_mm = random.uniform(-30, 0)
            live.move("wall", over_ms=random.choice([0, 5, 10]), point_mm=[0, y_mm, 0])
"""


class Killed(Served):
    def steer(self, seed: int) -> subprocess.Popen[str]:
        words = [sys.executable, "-B", "-c", STEER, self.url, self.token, str(seed)]
        process = subprocess.Popen(words, stdout=subprocess.PIPE, text=True)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        assert process.stdout is not None
        self.assertEqual(process.stdout.readline().strip(), "steers")
        self.addCleanup(process.stdout.close)
        return process

    def test_a_session_that_killed_clients_steered_is_made_again_to_the_bit(self):
        session = self.folder / "steered.h5"
        with self.service("--record", session, "--hand", "tremor") as service:
            for seed in range(3):
                client = self.steer(seed)
                time.sleep(0.5)
                client.kill()
                client.wait()
            with self.connect() as live:
                deadline = time.monotonic() + 10
                while "steered_by" in live.status() and time.monotonic() < deadline:
                    time.sleep(0.02)
                self.assertNotIn("steered_by", live.status())  # the lease has ended with it
                live.mark("after them")
            self.end(service)
        verified = self.cli("replay", session, "--verify")
        self.assertTrue(verified["identical"])
        again = self.folder / "again.h5"
        self.assertTrue(self.cli("rerun", session, "--out", again)["identical"])
        self.assertTrue(self.cli("replay", again, "--verify")["identical"])
        with underact.Session(session) as read:
            self.assertEqual([marker.label for marker in read.markers], ["after them"])
            self.assertGreater(len(read.changes), 10)

    def test_one_that_sleeps_loses_rows_and_nobody_else_does(self):
        asleep = """
import sys, underact
with underact.connect(sys.argv[1], token=sys.argv[2], name="sleeper") as live:
    for ticks in live.ticks(["p_WT_mm", "q_rad", "force_sent_N"], hz=1000):
        print("gets", flush=True)
"""
        words = [sys.executable, "-B", "-c", asleep]
        with self.service("--start") as service:
            process = subprocess.Popen(
                [*words, self.url, self.token], stdout=subprocess.PIPE, text=True
            )
            self.addCleanup(process.wait)
            self.addCleanup(process.kill)
            assert process.stdout is not None
            self.addCleanup(process.stdout.close)
            self.assertEqual(process.stdout.readline().strip(), "gets")
            process.send_signal(signal.SIGSTOP)
            with self.connect() as live:
                seen: list[float] = []
                for ticks in live.ticks(["tick"], hz=1000):
                    seen.extend(ticks["tick"])
                    if len(seen) >= 1500:
                        break
                self.assertEqual(live.lost, 0)
                self.assertTrue((np.diff(seen) == 1).all())
                started = time.monotonic()
                live.stop()
                self.assertLess(time.monotonic() - started, 2.0)
            self.end(service)


if __name__ == "__main__":
    unittest.main()
