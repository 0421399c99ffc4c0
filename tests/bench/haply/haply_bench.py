"""The delay through Haply's messages, both ways. Prints figures, asserts nothing.

    PYTHONPATH=app/python /usr/bin/python3 -B tests/bench/haply/haply_bench.py build/release/underact-cli [S]

S: seconds of each measurement, 20 if left out.

1. From a frame of a client of `serve --haply` to the tick that has its force, which is found in the
   session by its size.
2. The loop of the driver `haply` against `serve --haply`: from the tick there whose state is told to
   the tick there that has the force that answers it.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import underact

ROOT = Path(__file__).resolve().parents[3]
FAR = {  # its own force is zero: what is asked is the client's
    "underact_scene": 1,
    "title": "Nothing",
    "constraints": [{"name": "far", "type": "point", "position_mm": [0, 0, 0]}],
    "control": {"law": "P", "kp_N_per_mm": 0},
}


@contextlib.contextmanager
def served(cli: str, folder: Path) -> Iterator[dict[str, str]]:
    (folder / "far.json").write_text(json.dumps(FAR))
    words = [cli, "serve", str(folder / "far.json"), "--port", "0", "--start", "--haply", "0"]
    words += ["--hand", "sweep", "--record", str(folder / "far.h5")]
    surroundings = {**os.environ, "XDG_RUNTIME_DIR": str(folder)}
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True, env=surroundings) as process:
        try:
            yield json.loads(process.stdout.readline())
        finally:
            process.terminate()
            process.wait(20)


def shown(numbers: np.ndarray, unit: str) -> str:
    p50, p99, most = np.percentile(numbers, [50, 99, 100])
    return f"p50 {p50:.2f}, p99 {p99:.2f}, max {most:.2f} {unit}, of {len(numbers)}"


async def push(
    url: str, live_url: str, token: str, seconds: float
) -> tuple[dict[int, int], list[float], list[float]]:
    """Frames with forces of their own, each beside a `mark` of the live service, whose tick is the
    newest at their arrival: micronewtons to that tick; round trips of marks and of frames, ms.
    """
    import websockets

    newest, ways_ms, rounds_ms = {}, [], []
    async with websockets.connect(url) as socket:
        async with await underact.connect_async(live_url, token=token) as live:
            told = json.loads(await socket.recv())
            end = time.monotonic() + seconds
            while time.monotonic() < end:
                number = len(newest) + 1
                force = {"x": 1e-6 * number, "y": 0.0, "z": 0.0}
                arm = {"device_id": told["inverse3"][0]["device_id"]}
                arm["commands"] = {"set_cursor_force": {"vector": force}}
                begin = time.monotonic()
                await live.mark("")
                ways_ms.append(1e3 * (time.monotonic() - begin) / 2)
                begin = time.monotonic()
                marked = asyncio.ensure_future(live.mark(""))
                await socket.send(json.dumps({"inverse3": [arm]}))
                told = json.loads(await socket.recv())
                rounds_ms.append(1e3 * (time.monotonic() - begin))
                newest[number] = await marked
                await asyncio.sleep(0.003)
    return newest, ways_ms, rounds_ms


def from_frame_to_tick(cli: str, seconds: float) -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        with served(cli, folder) as said:
            token = Path(said["token_file"]).read_text().strip()
            run = push(said["haply"], said["serving"], token, seconds)
            newest, ways_ms, rounds_ms = asyncio.run(run)
        with underact.Session(folder / "far.h5") as session:
            asked_N = np.asarray(session.ticks["force_asked_N"])[:, 0]
            ticks = np.asarray(session.ticks["tick"])
    felt: dict[int, int] = {}
    for tick, number in zip(ticks, np.rint(1e6 * asked_N).astype(int)):
        felt.setdefault(int(number), int(tick))
    both = [one for one in newest if one in felt]
    waits = np.array([felt[one] - newest[one] for one in both])
    print(f"a client's frames for {seconds:g} s: {len(newest)} sent, {len(both)} felt")
    print("  way of a request (half of a round trip): " + shown(np.array(ways_ms), "ms"))
    print("  from its arrival to the tick that has it: " + shown(waits, "ticks"))
    sums = np.array([ways_ms[one - 1] for one in both]) + waits
    print("  both: " + shown(sums, "ms"))
    print("  from frame to the state that answers it: " + shown(np.array(rounds_ms), "ms"))


def loop_of_the_driver(cli: str, seconds: float) -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        with served(cli, folder) as told_by:
            url = told_by["haply"]
            words = [cli, "run", str(ROOT / "scenes/02_sphere.json"), "--seconds", str(seconds)]
            words += [
                "--device",
                "haply:" + url[5:].strip("/"),
                "--record",
                str(folder / "here.h5"),
            ]
            done = subprocess.run(words, stdout=subprocess.PIPE, text=True)  # 3: there was a fault
            said = json.loads(done.stdout)
        with underact.Session(folder / "far.h5") as session:
            asked_N = np.asarray(session.ticks["force_asked_N"])
            there_mm = np.asarray(session.ticks["p_WT_mm"])
        with underact.Session(folder / "here.h5") as session:
            sent_N = np.asarray(session.ticks["force_sent_N"])
            here_mm = np.asarray(session.ticks["p_WT_mm"])
    told = {tuple(np.round(row, 6)): at for at, row in enumerate(there_mm)}
    felt: dict[tuple[float, ...], int] = {}
    for at, row in enumerate(asked_N):
        felt.setdefault(tuple(np.round(row, 9)), at)
    ticks = []
    for place, force in zip(here_mm, sent_N):
        key, answer = tuple(np.round(place, 6)), tuple(np.round(force, 9))
        if np.linalg.norm(force) > 0.05 and key in told and answer in felt:
            ticks.append(felt[answer] - told[key])
    print(f"the driver for {seconds:g} s: {said['ticks']} ticks, faults {said['faults']}")
    loops = np.array([one for one in ticks if 0 <= one < 1000])
    print("  from the tick that tells to the tick that feels: " + shown(loops, "ticks"))


def main(cli: str, seconds: float) -> None:
    print(f"load average {os.getloadavg()[0]:.1f}, {os.cpu_count()} cores")
    from_frame_to_tick(cli, seconds)
    loop_of_the_driver(cli, seconds)


if __name__ == "__main__":
    main(sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else 20.0)
