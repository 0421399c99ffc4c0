"""Chromium without a screen, driven by its own protocol through two pipes."""

from __future__ import annotations

import contextlib
import fcntl
import json
import os
import select
import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterator
from typing import Any

LIMIT_S = 60.0  # for one answer, on a busy machine
HIGH = 20  # descriptors from here on are not those that Chromium is given, 3 and 4
OPTIONS = (
    "--headless=new --no-sandbox --disable-gpu --disable-dev-shm-usage --hide-scrollbars "
    "--no-first-run --disable-extensions --disable-background-networking --disable-sync "
    "--remote-debugging-pipe about:blank"
).split()


def program() -> str | None:
    """Chromium as the system has it."""
    names = ("chromium", "chromium-browser", "google-chrome")
    return next(filter(None, map(shutil.which, names)), None)


class Browser:
    """One page of a running Chromium."""

    def __init__(self, to_browser: int, from_browser: int) -> None:
        self._write, self._read = to_browser, from_browser
        self._got, self._number = b"", 0
        self._events: list[dict[str, Any]] = []
        self._session = ""
        page = self.ask("Target.createTarget", url="about:blank")["targetId"]
        attached = self.ask("Target.attachToTarget", targetId=page, flatten=True)
        self._session = attached["sessionId"]
        self.ask("Page.enable")
        self.ask("Page.setLifecycleEventsEnabled", enabled=True)
        self.ask("Runtime.enable")

    def ask(self, method: str, **values: Any) -> dict[str, Any]:
        """The answer to a command; RuntimeError where it is refused."""
        self._number += 1
        words = {"id": self._number, "method": method, "params": values}
        if self._session:
            words["sessionId"] = self._session
        os.write(self._write, json.dumps(words).encode() + b"\0")
        while True:
            message = self._next()
            if message.get("id") == self._number:
                break
            self._events.append(message)
        if "error" in message:
            raise RuntimeError(f"{method}: {message['error']}")
        return message["result"]

    def open(self, address: str) -> None:
        """Shows a page and waits until it is loaded: it, and not one that a link led to just before."""
        self._events.clear()
        asked = self.ask("Page.navigate", url=address)
        if asked.get("errorText"):
            raise RuntimeError(f"{address}: {asked['errorText']}")
        while "loaderId" in asked and not any(  # without one it stays in the document that it shows
            event.get("method") == "Page.lifecycleEvent"
            and (event["params"]["loaderId"], event["params"]["name"]) == (asked["loaderId"], "load")
            for event in self._events
        ):
            self._events.append(self._next())

    def errors(self) -> list[str]:
        """What the page's scripts failed with since it was opened."""
        thrown = (e["params"] for e in self._events if e.get("method") == "Runtime.exceptionThrown")
        return [json.dumps(event["exceptionDetails"].get("exception", event)) for event in thrown]

    def run(self, script: str) -> Any:
        """The value of an expression of JavaScript in the page."""
        done = self.ask("Runtime.evaluate", expression=script, returnByValue=True)
        if "exceptionDetails" in done:
            raise RuntimeError(json.dumps(done["exceptionDetails"]))
        return done["result"].get("value")

    def resize(self, width: int, height: int) -> None:
        self.ask(
            "Emulation.setDeviceMetricsOverride",
            width=width,
            height=height,
            deviceScaleFactor=1,
            mobile=False,
        )

    def prefer(self, scheme: str = "", media: str = "") -> None:
        """Light or dark, as a user's system says; media: "print" for paper."""
        features = [{"name": "prefers-color-scheme", "value": scheme}]
        self.ask("Emulation.setEmulatedMedia", media=media, features=features)

    def press(self, key: str, text: str = "") -> None:
        """A key, by its name in browsers ("Enter", "ArrowDown", "/")."""
        codes = {"Enter": 13, "Escape": 27, "ArrowDown": 40, "ArrowUp": 38, "Tab": 9}
        for kind in ("keyDown", "keyUp"):
            said = {"text": text} if text and kind == "keyDown" else {}
            code = codes.get(key, ord(key[0]))
            self.ask(
                "Input.dispatchKeyEvent", type=kind, key=key, windowsVirtualKeyCode=code, **said
            )

    def type(self, text: str) -> None:
        self.ask("Input.insertText", text=text)

    def _next(self) -> dict[str, Any]:
        end = time.monotonic() + LIMIT_S
        while b"\0" not in self._got:
            if not select.select([self._read], [], [], max(0.0, end - time.monotonic()))[0]:
                raise RuntimeError(f"Chromium said nothing for {LIMIT_S:.0f} s.")
            part = os.read(self._read, 1 << 20)
            if not part:
                raise RuntimeError("Chromium ended.")
            self._got += part
        message, self._got = self._got.split(b"\0", 1)
        return json.loads(message)


def _high(descriptor: int) -> int:
    moved = fcntl.fcntl(descriptor, fcntl.F_DUPFD, HIGH)
    os.close(descriptor)
    return moved


@contextlib.contextmanager
def browser(path: str) -> Iterator[Browser]:
    """Chromium while the block runs, with a profile of its own that is gone afterwards."""
    theirs_in, ours_out = map(_high, os.pipe())
    ours_in, theirs_out = map(_high, os.pipe())
    start = f'exec "$@" 3<&{theirs_in} 4>&{theirs_out}'  # bash: dash takes one digit only
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        words = ["bash", "-c", start, "bash", path, *OPTIONS, f"--user-data-dir={profile}"]
        running = subprocess.Popen(
            words, pass_fds=(theirs_in, theirs_out), stderr=subprocess.DEVNULL
        )
        os.close(theirs_in)
        os.close(theirs_out)
        try:
            shown = Browser(ours_out, ours_in)
            yield shown
            shown._session = ""
            with contextlib.suppress(RuntimeError, BrokenPipeError):
                shown.ask("Browser.close")
        finally:
            with contextlib.suppress(subprocess.TimeoutExpired):
                running.wait(timeout=10)
            if running.poll() is None:
                running.kill()
                running.wait()
            os.close(ours_out)
            os.close(ours_in)
