"""Clients of the live service who mean no good: `hostile_clients.py URL TOKEN_FILE SECONDS SEED
[REQUEST]`, which they leave out.

Four of them, each with every request there is, well and badly formed, floods, frames of a
megabyte, scenes that take long to be read, connections that say nothing and that read nothing.
None of them starts the servo: a force that is on again after a Stop was somebody's wish.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import random
import sys
import time
from pathlib import Path

import websockets

PLANE = {"type": "plane", "point_mm": [0, -80, 0], "normal": [0, 1, 0], "side": "outside"}
SPHERE = {"name": "ball", "type": "sphere", "center_mm": [0, 0, 0], "radius_mm": 40}
WORDS = ["", "x" * 5000, "\x1b[2J", "<img src='/dev/zero'>", "ü", 7, -1e308, None, [], {}, True]
KINDS = (
    "hello scene load settings get set stop force mark record subscribe unsubscribe status lease "
    "challenge constraint.add constraint.remove constraint.move no_such"
).split()
KEYS = (
    "paths values f_N for_ms text file stop columns hz format lease nonce constraint name".split()
)


def scene(draw: random.Random) -> dict:
    balls = [{**SPHERE, "name": f"b{n}", "radius_mm": 30 + n} for n in range(draw.choice([1, 64]))]
    return {"underact_scene": 1, "title": "H", "constraints": balls, "combine": "nearest"}


def any_request(draw: random.Random) -> dict:
    request = {"do": draw.choice(KINDS), "id": draw.choice([1, "a", *WORDS])}
    for key in draw.sample(KEYS, draw.randrange(4)):
        request[key] = draw.choice(WORDS)
    return request


def large(draw: random.Random) -> str:
    """Close to a megabyte of what has to be read before it can be refused."""
    count = 14_000
    if draw.random() < 0.5:
        values = {f"/constraints/{n}/no_such_setting_of_anybody/{n}": n for n in range(count)}
        return json.dumps({"id": 1, "do": "set", "values": values})
    paths = [f"/control/kp_N_per_mn/{n}" for n in range(draw.choice([9_999, count]))]
    return json.dumps(
        {"id": 1, "do": draw.choice(["get", "subscribe"]), "paths": paths, "columns": paths}
    )


async def misbehave(live, draw: random.Random, end: float) -> None:
    async def say(request: dict) -> None:
        await live.send(json.dumps({"id": 1, **request}))

    acts = draw.randrange(9)
    if acts == 0:
        for _ in range(draw.randrange(20_000)):  # a flood
            await say({"do": "force", "f_N": [draw.uniform(-0.2, 0.2), 0, 0], "for_ms": 20})
    elif acts == 1:
        for _ in range(draw.randrange(5)):
            await live.send(large(draw))
    elif acts == 2:
        for _ in range(draw.randrange(50)):
            await say({"do": "load", "scene": scene(draw)})
    elif acts == 3:
        for n in range(draw.randrange(200)):
            await say({"do": "constraint.add", "constraint": {**PLANE, "name": f"p{n}"}})
            await say({"do": "constraint.move", "name": f"p{n}", "values": {}, "over_ms": 10})
            await say({"do": "constraint.remove", "name": f"p{n}"})
    elif acts == 4:
        for n in range(draw.randrange(5_000)):
            await say({"do": "mark", "text": str(n) * 200})
    elif acts == 5:
        every = {"columns": ["q_rad", "p_WT_mm", "force_sent_N", "heat"], "hz": 1000}
        await say({"do": "subscribe", **every, "format": draw.choice(["json", "binary"])})
        await asyncio.sleep(draw.uniform(0, 2))  # without reading
    elif acts == 6:
        await live.send(draw.choice(["{" * 60_000, "[" * 64, "nonsense", draw.randbytes(5_000)]))
    elif acts == 7:
        for _ in range(draw.randrange(300)):
            await say(any_request(draw))
    else:
        await say({"do": "set", "values": {"/control/kp_N_per_mm": draw.uniform(0.1, 0.5)}})
    with contextlib.suppress(asyncio.TimeoutError):
        while time.monotonic() < end:
            await asyncio.wait_for(live.recv(), 0.01)


async def drip(host: str, port: int, draw: random.Random) -> None:
    _, writer = await asyncio.open_connection(host, port)
    for one in b"GET / HTTP/1.1\r\n"[: draw.randrange(16)]:
        writer.write(bytes([one]))
        await asyncio.sleep(0.3)
    writer.close()


async def client(url: str, token: str, draw: random.Random, end: float) -> None:
    host, port = url.removeprefix("ws://").split(":")
    while time.monotonic() < end:
        with contextlib.suppress(OSError, websockets.WebSocketException, asyncio.TimeoutError):
            if draw.random() < 0.2:
                await asyncio.wait_for(drip(host, int(port), draw), 6)
            async with websockets.connect(url, max_size=None, close_timeout=0.2) as live:
                await live.send(json.dumps({"id": 0, "do": "hello", "token": token, "name": "H"}))
                while time.monotonic() < end and draw.random() < 0.8:
                    await misbehave(live, draw, end)


async def main(url: str, token_file: str, seconds: str, seed: str, unused: str = "") -> None:
    KINDS[:] = [kind for kind in KINDS if kind != unused]
    end = time.monotonic() + float(seconds)
    token = Path(token_file).read_text(encoding="utf-8").strip()
    draws = [random.Random(f"{seed} {one}") for one in range(4)]
    await asyncio.wait(
        [asyncio.create_task(client(url, token, one, end)) for one in draws],
        timeout=float(seconds) + 5,
    )


if __name__ == "__main__":
    asyncio.run(main(*sys.argv[1:]))
