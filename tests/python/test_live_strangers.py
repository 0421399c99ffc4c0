"""Strangers at the live service's port, and at the place of it: pages of browsers, connections that
say nothing, too many of them, and a program that would like to have the token.
"""

from __future__ import annotations

import asyncio
import contextlib
import http.client
import importlib
import json
import os
import resource
import socket
import subprocess
import time
import unittest
from pathlib import Path

import underact
from test_live import Served
from underact.live import LiveError

UPGRADE = {
    "Connection": "Upgrade",
    "Upgrade": "websocket",
    "Sec-WebSocket-Version": "13",
    "Sec-WebSocket-Key": "MDEyMzQ1Njc4OWFiY2RlZg==",
}


class Strangers(Served):
    def port(self, of: str = "serving") -> int:
        return int(self.said[of].rsplit(":", 1)[1])

    def asks(self, port: int, host: str, path: str = "/devices", **headers: str) -> int:
        """The status of the answer to a request over plain HTTP."""
        with contextlib.closing(http.client.HTTPConnection("127.0.0.1", port)) as where:
            where.putrequest("GET", path, skip_host=True)
            for name, value in {"Host": host, **headers}.items():
                where.putheader(name, value)
            where.endheaders()
            return where.getresponse().status

    def test_answers_at_its_own_address_alone_and_its_own_origin_at_both_ports(self):
        lab = {"Origin": "https://lab.example"}
        with self.service("--haply", "0", "--allow-origin", lab["Origin"]):
            live, haply = self.port(), self.port("haply")
            for port, well in ((live, 426), (haply, 200)):
                own = [f"{name}:{port}" for name in ("127.0.0.1", "localhost", "[::1]")]
                for host in (*own, "127.0.0.1", "LocalHost"):
                    self.assertEqual(self.asks(port, host), well, host)
                    self.assertEqual(self.asks(port, own[0], Origin=f"http://{own[1]}"), well)
                for host in (f"rebound.example:{port}", "127.0.0.1.example", f"localhost:{port}0"):
                    self.assertEqual(self.asks(port, host), 421, host)
                    self.assertEqual(self.asks(port, host, "/", **UPGRADE), 421, host)
                for origin in ("null", "http://localhost", f"http://rebound.example:{port}"):
                    self.assertEqual(self.asks(port, own[0], Origin=origin), 403)
                    self.assertEqual(self.asks(port, own[0], Origin=origin, **UPGRADE), 403)
                own_page = {"Origin": f"http://127.0.0.1:{port}", **UPGRADE}
                self.assertEqual(self.asks(port, own[0], "/", **own_page), 101)
                self.assertEqual(self.asks(port, "localhost", **lab), well)
                self.assertEqual(self.asks(port, "localhost", **lab, **UPGRADE), 101)

    def test_ends_connections_that_do_not_say_who_they_are_whatever_they_drip(self):
        words = {"Host": "localhost", **UPGRADE}.items()
        upgrade = b"GET / HTTP/1.1\r\n" + b"".join(f"{a}: {b}\r\n".encode() for a, b in words)
        accepted = upgrade + b"\r\n"
        ping, part = b"\x89\x80\0\0\0\0", b"\x81\xfe\x10\x00\0\0\0\0"
        drips = [(b"", b"", b""), (b"", b"", b"G"), (upgrade, b"", b"X: y\r\n")]
        drips += [(accepted, b"", ping), (accepted, part, b"{")]
        with self.service():
            open_ones = []
            for first, after, drip in drips:
                one = socket.create_connection(("127.0.0.1", self.port()))
                self.addCleanup(one.close)
                one.sendall(first)
                if first == accepted:
                    self.assertIn(b" 101 ", one.recv(4096))
                one.sendall(after)
                one.settimeout(0.02)
                open_ones.append((one, drip))
            begun, ends = time.monotonic(), []
            while open_ones and time.monotonic() < begun + 20:
                time.sleep(0.2)
                for one, drip in list(open_ones):
                    try:
                        with contextlib.suppress(ConnectionError):
                            one.sendall(drip)
                        is_open = bool(one.recv(4096))
                    except TimeoutError:
                        continue
                    except ConnectionError:
                        is_open = False
                    if not is_open:
                        open_ones.remove((one, drip))
                        ends.append(time.monotonic() - begun)
            self.assertEqual(open_ones, [])
            self.assertLess(ends[-1] - ends[0], 3.0, "whatever they drip")

    def processor_s(self, process: subprocess.Popen[str]) -> float:
        words = Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(words[11]) + int(words[12])) / os.sysconf("SC_CLK_TCK")

    def test_does_not_spin_where_no_descriptors_are_left(self):
        with self.service() as process, self.connect() as live:
            used = {int(one) for one in os.listdir(f"/proc/{process.pid}/fd")}
            count = next(one for one in range(len(used) + 1) if one not in used)
            _, most = resource.prlimit(process.pid, resource.RLIMIT_NOFILE)
            resource.prlimit(process.pid, resource.RLIMIT_NOFILE, (count, most))
            with contextlib.closing(socket.create_connection(("127.0.0.1", self.port()))):
                used_s = self.processor_s(process)
                time.sleep(2)  # it tries ten times a second; else all the time
                self.assertLess(self.processor_s(process) - used_s, 0.6)
                self.assertEqual(live.status()["clients"], ["test"])
            resource.prlimit(process.pid, resource.RLIMIT_NOFILE, (most, most))
            with self.connect("next") as late:
                self.assertEqual(late.status()["clients"], ["test", "next"])

    def test_sends_no_token_to_a_stranger_at_its_port(self):
        websockets = importlib.import_module("websockets")
        heard: list[str] = []

        async def stranger(socket) -> None:
            async for frame in socket:
                heard.append(frame)
                proof = {"id": json.loads(frame)["id"], "ok": True, "proof": "0" * 64}
                await socket.send(json.dumps(proof))

        async def meet() -> None:
            async with websockets.serve(stranger, "127.0.0.1", 0) as server:
                port = server.sockets[0].getsockname()[1]
                await underact.connect_async(port=port, token_file=self.folder / "token")

        (self.folder / "token").write_text("a-token-of-my-own-0123456789\n")
        with self.assertRaises(LiveError) as refused:
            asyncio.run(meet())
        self.assertIn("does not know this token", str(refused.exception))
        self.assertEqual([json.loads(one)["do"] for one in heard], ["challenge"])
        self.assertNotIn("a-token", "".join(heard))


if __name__ == "__main__":
    unittest.main()
