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
SPHERE = {"type": "sphere", "center_mm": [0, 0, 0]}
WORDS = ["", "x" * 5000, "\x1b[2J", "<img src='/dev/zero'>", "ü", 7, -1e308, None, [], {}, True]
KINDS = (
    "hello scene load settings get set stop force mark record subscribe unsubscribe status lease "
    "challenge constraint.add constraint.remove constraint.move no_such"
).split()
KEYS = "paths values f_N for_ms text file columns hz format lease nonce constraint name".split()


def scene(draw: random.Random) -> dict:
    balls = [{**SPHERE, "name": f"b{n}", "radius_mm": 30 + n} for n in range(draw.choice([1, 64]))]
    return {"underact_scene": 1, "title": "H", "constraints": balls, "combine": "nearest"}


def any_request(draw: random.Random) -> dict:
    keys = {key: draw.choice(WORDS) for key in draw.sample(KEYS, draw.randrange(4))}
    return {"do": draw.choice(KINDS), "id": draw.choice([1, "a", *WORDS]), **keys}


def large(draw: random.Random) -> dict:
    """Close to a megabyte of what has to be read before it can be refused."""
    count = draw.choice([9_999, 14_000])
    values = {f"/constraints/{n}/no_such_setting_of_anybody/{n}": n for n in range(count)}
    paths = [f"/control/kp_N_per_mn/{n}" for n in range(count)]
    requests = {"set": {"values": values}, "get": {"paths": paths}, "subscribe": {"columns": paths}}
    do = draw.choice(list(requests))
    return {"do": do, **requests[do]}


def plane(n: int) -> list[dict]:
    name = {"name": f"p{n}"}
    add = {"do": "constraint.add", "constraint": {**PLANE, **name}}
    move = {"do": "constraint.move", **name, "values": {}, "over_ms": 10}
    return [add, move, {"do": "constraint.remove", **name}]


def floods(draw: random.Random) -> list:
    """How many at most, and what: requests, or frames that are none."""
    junk = ["{" * 60_000, "[" * 64, "nonsense", draw.randbytes(5_000)]
    columns = {"columns": ["q_rad", "p_WT_mm", "heat"], "format": draw.choice(["json", "binary"])}
    return [
        (20_000, lambda _: [{"do": "force", "f_N": [draw.random() / 5, 0, 0], "for_ms": 20}]),
        (5, lambda _: [large(draw)]),
        (50, lambda _: [{"do": "load", "scene": scene(draw)}]),
        (200, plane),
        (5_000, lambda n: [{"do": "mark", "text": str(n) * 200}]),
        (2, lambda _: [{"do": "subscribe", "hz": 1000, **columns}]),
        (2, lambda _: [draw.choice(junk)]),
        (300, lambda _: [any_request(draw)]),
        (2, lambda _: [{"do": "set", "values": {"/control/kp_N_per_mm": 0.1 + draw.random() / 2}}]),
    ]


async def misbehave(live, draw: random.Random, end: float) -> None:
    most, frames = draw.choice(floods(draw))
    for n in range(draw.randrange(1, most)):
        for one in frames(n):
            await live.send(json.dumps({"id": 1, **one}) if isinstance(one, dict) else one)
    await asyncio.sleep(draw.choice([0, 0, 0, 2]))  # without reading
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
    clients = [client(url, token, random.Random(f"{seed} {one}"), end) for one in range(4)]
    await asyncio.wait([*map(asyncio.create_task, clients)], timeout=float(seconds) + 5)


if __name__ == "__main__":
    asyncio.run(main(*sys.argv[1:]))
