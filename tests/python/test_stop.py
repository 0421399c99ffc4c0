"""Stop, tried at random moments while strangers do to a service what they can.

When a Stop came into effect is read from the session: the first tick in which the servo was not to
push, at the time that its clock says. In a soak (UNDERACT_SOAK=1) that has to be within 20 ms; in
a sample nothing is timed, since the machine does other things, too.
"""

from __future__ import annotations

import json
import os
import random
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

import h5py
import numpy as np
from support import CLI, SOAK, works
from test_live import Served

import underact

TRIALS, STOPS_A_RUN = (1000, 25) if SOAK else (9, 3)
WITHIN_MS = 20.0
PUSHES = 2  # of the column "input"


def ends_ms(parts: list[Path], stops_ns: list[int]) -> list[float]:
    """How long after each of these moments (CLOCK_MONOTONIC) the servo was not to push any more.

    parts: of one recording, in order. Ticks are a period apart, and more where deadlines were left
    out. A row of /clock is read after its tick, so the one that was read the soonest says when the
    ticks were, or a little later.
    """
    columns: dict[str, list[np.ndarray]] = {}
    for part in parts:
        with h5py.File(part) as file:
            for name in (
                "ticks/tick",
                "ticks/input",
                "ticks/lateness_us",
                "clock/tick",
                "clock/monotonic_ns",
            ):
                columns.setdefault(name, []).append(file[name][:])
    of = {name: np.concatenate(rows) for name, rows in columns.items()}
    late_ms = of["ticks/lateness_us"] / 1000
    at_ms = np.cumsum(1 + np.floor(late_ms)) + late_ms % 1
    rows = np.searchsorted(of["ticks/tick"], of["clock/tick"])
    at_ms += (of["clock/monotonic_ns"] / 1e6 - at_ms[rows]).min()
    idle_ms = at_ms[(of["ticks/input"] & PUSHES) == 0]
    return [min(idle_ms[idle_ms >= one / 1e6], default=np.inf) - one / 1e6 for one in stops_ns]


@unittest.skipUnless(works("websockets"), "python3-websockets is not installed")
class Stop(Served):
    def attack(self, seed: int) -> subprocess.Popen:
        words = [
            Path(__file__).with_name("hostile_clients.py"),
            self.url,
            self.token_file,
            3600,
            seed,
        ]
        return subprocess.Popen([sys.executable, *map(str, words)], stderr=subprocess.DEVNULL)

    def press(self, draw: random.Random, live: underact.Live) -> int | None:
        """Starts, and stops at some moment: when, or none if another had stopped it before."""
        live.start()
        time.sleep(0.4 + draw.uniform(0, 0.2))
        if live.status()["mode"] != "running":
            return None
        now_ns = time.monotonic_ns()
        live.stop()
        return now_ns

    def test_takes_effect_at_once_whatever_four_hostile_clients_do(self):
        draw, tried, worst_ms, run = random.Random(50), 0, 0.0, 0
        while tried < TRIALS:
            run += 1
            session = self.folder / f"run_{run}.h5"
            stops_ns = []
            with self.service(
                "--record", session, "--anyone-steers", "--sessions", self.folder / "theirs"
            ) as process:
                attack = self.attack(run)
                try:
                    with self.connect("person") as live:
                        for _ in range(STOPS_A_RUN):
                            pressed_ns = self.press(draw, live)
                            stops_ns += [pressed_ns] if pressed_ns else []
                        live.start()
                        time.sleep(0.4)
                        interrupted_ns = time.monotonic_ns()
                        process.send_signal(signal.SIGINT)
                        _, said = process.communicate(timeout=60)
                finally:
                    attack.kill()
                    attack.wait()
            self.assertEqual(process.returncode, 0, said)
            for part in sorted(self.folder.glob("**/*.h5")):
                done = subprocess.run(
                    [CLI, "log", "verify", part], capture_output=True, text=True, check=False
                )
                self.assertEqual(done.returncode, 0, f"{part.name}: {done.stdout} {done.stderr}")
            # Under a flood of marks it may have gone on in other parts.
            others = self.folder.glob(f"run_{run}_*.h5")
            parts = [session, *sorted(others, key=lambda part: int(part.stem.rsplit("_")[-1]))]
            took_ms = ends_ms(parts, [*stops_ns, interrupted_ns])
            if SOAK:
                self.assertLess(max(took_ms), WITHIN_MS, f"seed {run}: {took_ms}")
            worst_ms = max(worst_ms, *took_ms)
            self.assertTrue(np.isfinite(took_ms).all())
            tried += len(stops_ns) + 1
            for old in self.folder.glob("**/*.h5"):
                old.unlink()
        print(f"\n{tried} Stops, each within {worst_ms:.1f} ms", file=sys.stderr)


if __name__ == "__main__":
    unittest.main()
