"""What the live service costs: from `set` to the tick that has it, and a subscriber of all columns
beside a servo that is listened to by nobody. Prints figures, asserts nothing.

    PYTHONPATH=app/python python3 -B tests/bench/live/live_bench.py build/release/underact-cli [S]

S: seconds of each measurement, 20 if left out.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import underact
from underact.layout import DESCRIBED

ROOT = Path(__file__).resolve().parents[3]
COLUMNS = list(DESCRIBED["ticks"])


@contextlib.contextmanager
def service(cli: str, rate_hz: int) -> Iterator[tuple[str, str]]:
    with tempfile.TemporaryDirectory() as folder:
        words = [cli, "serve", str(ROOT / "scenes/02_sphere.json"), "--port", "0", "--start"]
        words += ["--rate", str(rate_hz), "--token-file", f"{folder}/token"]
        with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as process:
            said = json.loads(process.stdout.readline())
            try:
                yield said["serving"], Path(said["token_file"]).read_text().strip()
            finally:
                process.terminate()


def shown(numbers: list[float] | np.ndarray, unit: str) -> str:
    p50, p99, most = np.percentile(numbers, [50, 99, 100])
    return f"p50 {p50:.3f}, p99 {p99:.3f}, max {most:.3f} {unit}"


async def from_set_to_tick(url: str, token: str, count: int) -> None:
    """`mark` and `set` leave together: the one's tick is the newest at their arrival."""
    async with await underact.connect_async(url, token=token) as live:
        rate_hz = live.about["rate_hz"]
        ticks, way_ms, whole_ms = [], [], []
        for turn in range(count):
            begin = time.perf_counter()
            await live.mark("")
            way_ms.append(1e3 * (time.perf_counter() - begin) / 2)
            begin = time.perf_counter()
            marked = asyncio.ensure_future(live.mark(""))
            done = asyncio.ensure_future(live.set({"/control/kp_N_per_mm": 0.2 + 0.001 * turn}))
            ticks.append(await done - await marked)
            whole_ms.append(1e3 * (time.perf_counter() - begin))
            await asyncio.sleep(0.003)
        print(f"set, {rate_hz} Hz, {count} times")
        print("  way of the request (half of a round trip): " + shown(way_ms, "ms"))
        print("  from its arrival to the tick that has it: " + shown(ticks, "ticks"))
        print("  until the answer was read: " + shown(whole_ms, "ms"))
        # The answer leaves after the tick and takes the shortest way at least.
        print("  to the tick, at most: " + shown(np.array(whole_ms) - min(way_ms), "ms"))


async def lateness(url: str, token: str, columns: list[str], hz: int, seconds: float) -> np.ndarray:
    async with await underact.connect_async(url, token=token) as live:
        seen, late_us = [], []
        end = time.perf_counter() + seconds
        async for ticks in live.ticks(columns, hz):
            seen.append(ticks["tick"])
            late_us.append(ticks["lateness_us"])
            if time.perf_counter() > end:
                break
        numbers = np.concatenate(seen)
        gaps = int((np.diff(numbers) != live.about["rate_hz"] // hz).sum())
        what = f"{len(numbers)} rows of {len(columns)} columns at {hz} Hz"
        print(f"  {what}: {gaps} gaps, {live.lost} lost")
        return np.concatenate(late_us)


async def steps(url: str, token: str, over_ms: float) -> None:
    """A point that swings at 1 Hz, moved a hundred times a second: what of it is felt as steps."""
    async with await underact.connect_async(url, token=token) as live:
        scene = {
            "underact_scene": 1,
            "title": "Swing",
            "constraints": [{"name": "post", "type": "point", "position_mm": [0, 0, 0]}],
        }
        await live.load(scene)
        await live.start()
        await live.subscribe(["force_asked_N"], live.about["rate_hz"])

        async def swing() -> None:
            begin = time.perf_counter()
            for turn in range(400):
                x_mm = 3 * np.sin(2 * np.pi * turn / 100)
                await live.move("post", position_mm=[x_mm, 0, 0], over_ms=over_ms)
                await asyncio.sleep(max(0.0, begin + 0.01 * (turn + 1) - time.perf_counter()))

        swings = asyncio.ensure_future(swing())
        rows = []
        while not swings.done():
            rows.append((await live.next_ticks())["force_asked_N"][:, 0])
        force_N = np.concatenate(rows)[1000:3048]
        spectrum_N = np.abs(np.fft.rfft(force_N * np.hanning(2048))) / 512
        hz = np.fft.rfftfreq(2048, 1e-3)
        parts = []
        for low, high in ((0.5, 5), (80, 120), (180, 220), (280, 320)):
            in_band = spectrum_N[(hz >= low) & (hz < high)]
            parts.append(f"{low} to {high} Hz {1e3 * np.sqrt((in_band**2).sum()):.2f}")
        print(f"  over_ms {over_ms:g}: " + ", ".join(parts) + " mN")


def main(cli: str, seconds: float) -> None:
    print("a point moved at 100 Hz on the simulated arm: amplitude of the force before the gate")
    for over_ms in (0.0, 10.0):
        with service(cli, 1000) as (url, token):
            asyncio.run(steps(url, token, over_ms))
    with service(cli, 1000) as (url, token):
        asyncio.run(from_set_to_tick(url, token, 500))
    for rate_hz in (1000, 4000):
        print(f"subscribers, {rate_hz} Hz, {seconds:g} s each")
        with service(cli, rate_hz) as (url, token):
            # Few rows tell the lateness of a servo that is listened to by hardly anybody.
            few = asyncio.run(lateness(url, token, ["lateness_us"], 50, seconds))
            print("  lateness, hardly listened to: " + shown(few, "us"))
            every = asyncio.run(lateness(url, token, COLUMNS, rate_hz, seconds))
            print("  lateness, all columns of all ticks: " + shown(every, "us"))

            async def eight() -> None:
                await asyncio.gather(
                    *(lateness(url, token, COLUMNS, rate_hz // 4, seconds) for _ in range(8))
                )

            asyncio.run(eight())


if __name__ == "__main__":
    main(sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 20.0)
