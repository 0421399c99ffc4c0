"""The page for the browser, in Chromium, with a service behind it: how it looks, what it asks, who
steers, the keyboard. Its pictures are left in UNDERACT_PICTURES where that names a folder.
"""

from __future__ import annotations

import base64
import contextlib
import json
import os
import pathlib
import subprocess
import tempfile
import time
import unittest
from collections.abc import Callable, Iterator
from typing import Any

from chromium import Browser, browser, program

ROOT = pathlib.Path(__file__).resolve().parents[2]
CLI = os.environ.get("UNDERACT_CLI", str(ROOT / "build/release/underact-cli"))
PAGE = pathlib.Path(
    os.environ.get("UNDERACT_PAGE", ROOT / "build/release/browser/underact-live.html")
)
CHECKS = (ROOT / "tests/guide/in_browser/checks.js").read_text(encoding="utf-8")
SCHEMA = json.loads((ROOT / "resources/guide/live_service.schema.json").read_text())
WIDTHS = {375: 812, 768: 1024, 1280: 900, 1920: 1080}
LIMIT_S = 30

if program() is None:
    raise unittest.SkipTest(
        "chromium is not installed, so nobody looked at the page for the browser"
    )
if os.environ.get("UNDERACT_SOAK") == "1":
    done = subprocess.run([ROOT / "packaging/browser-page", PAGE], stdout=subprocess.DEVNULL)
    if done.returncode not in (0, 77):
        raise AssertionError("packaging/browser-page failed")
if not PAGE.exists():
    raise unittest.SkipTest("the page for the browser was not made: target browser_page, with npm")


class Service:
    """A service, and its token."""

    def __init__(self, folder: str, *options: str, scene: str = "02_sphere") -> None:
        words = [CLI, "serve", str(ROOT / f"scenes/{scene}.json"), "--port", "0", "--hand", "sweep"]
        self.process = subprocess.Popen(
            [*words, *options],
            stdout=subprocess.PIPE,
            text=True,
            env={**os.environ, "XDG_RUNTIME_DIR": folder},
        )
        said = json.loads(self.process.stdout.readline())
        self.url = said["serving"]
        self.token = pathlib.Path(said["token_file"]).read_text().strip()

    def end(self) -> None:
        self.process.terminate()
        self.process.wait(30)
        self.process.stdout.close()


class Shown:
    """The page in a browser."""

    def __init__(self, shown: Browser) -> None:
        self.browser = shown
        shown.ask("Network.enable")
        shown.resize(1280, 900)
        shown.prefer("light")
        shown.open(PAGE.as_uri())
        shown.run(CHECKS)

    def text(self, name: str) -> str:
        return self.browser.run(f"document.getElementById({name!r}).textContent")

    def of(self, name: str, what: str) -> Any:
        return self.browser.run(f"document.getElementById({name!r}).{what}")

    def connect(self, service: Service, token: str = "") -> None:
        """As by hand, with the keyboard alone."""
        self.browser.run("document.getElementById('address').select()")
        self.browser.type(service.url)
        self.press("Tab")
        self.browser.type(token or service.token)
        self.press("Enter", "\r")

    def press(self, key: str, text: str = "") -> None:
        self.browser.press(key, text)

    def comes(self, condition: Callable[[], Any]) -> bool:
        end = time.monotonic() + LIMIT_S
        while time.monotonic() < end:
            if condition():
                return True
            time.sleep(0.05)
        return False

    def frames(self, kind: str) -> list[dict[str, Any]]:
        """Sent or Received, all so far."""
        self.browser.run("0")
        events = (
            e for e in self.browser._events if e.get("method") == f"Network.webSocketFrame{kind}"
        )
        return [json.loads(e["params"]["response"]["payloadData"]) for e in events]

    def asked(self, what: str) -> list[dict[str, Any]]:
        return [frame for frame in self.frames("Sent") if frame["do"] == what]

    def picture(self, name: str) -> None:
        folder = os.environ.get("UNDERACT_PICTURES")
        if folder:
            data = self.browser.ask("Page.captureScreenshot")["data"]
            pathlib.Path(folder, f"{name}.png").write_bytes(base64.b64decode(data))


class Page(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = holder.name

    @contextlib.contextmanager
    def page(self) -> Iterator[Shown]:
        with browser(program()) as shown:
            page = Shown(shown)
            yield page
            self.assertEqual(shown.errors(), [])

    def service(self, *options: str, **how: str) -> Service:
        service = Service(self.folder, *options, **how)
        self.addCleanup(service.end)
        return service

    def runs(self, page: Shown, service: Service) -> None:
        page.connect(service)
        self.assertTrue(page.comes(lambda: "mm" in page.text("tip")), page.text("message"))

    def test_shows_arm_constraint_force_and_plot_at_every_width(self) -> None:
        service = self.service("--start", "--allow-origin", "null")
        with self.page() as page:
            self.runs(page, service)
            self.assertEqual(page.text("seen-title"), "Sphere")
            self.assertEqual(page.text("not-drawn"), "")
            time.sleep(3)  # something to plot
            for width, height in WIDTHS.items():
                for scheme in ("light", "dark"):
                    page.browser.resize(width, height)
                    page.browser.prefer(scheme)
                    time.sleep(0.5)
                    page.picture(f"{width}_{scheme}")
                    what = f"{width} px, {scheme}"
                    self.assertEqual(page.browser.run("checks.tooWide(false)"), [], what)
                    self.assertEqual(page.browser.run("checks.tooFaint()"), [], what)
            self.assertRegex(page.of("view", "ariaLabel"), "The arm: tip at .* force .* error")

    def test_draws_as_often_as_it_can_of_all_ticks(self) -> None:
        """Prints how often; a busy machine, without a graphics card, draws less."""
        service = self.service("--start", "--allow-origin", "null")
        with self.page() as page:
            self.runs(page, service)
            counts = "[underactPage.pictures, underactPage.rows(), performance.now()]"
            time.sleep(3)
            before = page.browser.run(counts)
            time.sleep(5)
            after = page.browser.run(counts)
            pictures, rows, passed_ms = (b - a for a, b in zip(before, after))
            seconds = passed_ms / 1e3
            print(f"\n{pictures / seconds:.1f} pictures/s of {rows / seconds:.1f} ticks/s")
            self.assertGreater(rows / seconds, 150)
            self.assertGreater(pictures / seconds, 1)
            self.assertEqual([f for f in page.frames("Received") if f.get("event") == "lag"], [])

    def test_every_message_is_of_the_schema(self) -> None:
        try:
            import jsonschema
        except ImportError:
            self.skipTest("python3-jsonschema is not installed")
        service = self.service("--start", "--allow-origin", "null")
        with self.page() as page:
            self.runs(page, service)
            page.browser.run("document.querySelector('#sliders input').focus()")
            page.press("ArrowRight")
            self.assertTrue(page.comes(lambda: page.asked("set")))
            page.of("lease", "click()")
            page.press("Escape")
            self.assertTrue(page.comes(lambda: page.text("mode") == "Stopped"))
            page.of("start", "click()")
            self.assertTrue(page.comes(lambda: page.text("mode") == "Running"))
            for kind, part in (("Sent", "request"), ("Received", None)):
                frames = page.frames(kind)
                self.assertGreater(len(frames), 5)
                schema = (
                    {**SCHEMA, "anyOf": [{"$ref": f"#/definitions/{part}"}]} if part else SCHEMA
                )
                check = jsonschema.Draft4Validator(schema)
                for frame in frames[:300]:
                    self.assertTrue(check.is_valid(frame), frame)
            what = {frame["do"] for frame in page.frames("Sent")}
            self.assertLessEqual({"hello", "status", "scene", "settings", "subscribe"}, what)

    def test_slides_stops_and_starts_by_the_keyboard(self) -> None:
        service = self.service("--start", "--allow-origin", "null")
        with self.page() as page:
            self.runs(page, service)
            names = []
            for _ in range(16):
                page.press("Tab")
                names.append(
                    page.browser.run("document.activeElement.id || document.activeElement.tagName")
                )
            for name in ("view", "start", "stop", "lease", "SELECT", "INPUT"):
                self.assertIn(name, names)
            page.browser.run("document.querySelector('#sliders input').focus()")
            page.press("ArrowRight")
            self.assertTrue(page.comes(lambda: page.text("holder") == "This page is in control."))
            [path] = page.asked("set")[-1]["values"]
            self.assertEqual(path, "/control/kp_N_per_mm")
            self.assertRegex(
                page.browser.run("document.querySelector('#sliders input').ariaValueText"), "N/mm$"
            )
            page.press("Escape")
            self.assertTrue(page.comes(lambda: page.text("mode") == "Stopped"))
            page.of("start", "focus()")
            page.press("Enter", "\r")
            self.assertTrue(page.comes(lambda: page.text("mode") == "Running"))
            named = page.browser.run(
                "[...document.querySelectorAll('input,select,button,canvas')].filter((one) =>"
                " !(one.ariaLabel || one.labels?.length || one.textContent.trim())).length"
            )
            self.assertEqual(named, 0, "controls without a name for a screen reader")

    def test_where_another_steers_it_watches_and_may_stop(self) -> None:
        service = self.service("--start", "--allow-origin", "null")
        with self.page() as one, self.page() as other:
            self.runs(one, service)
            one.of("lease", "click()")
            self.assertTrue(one.comes(lambda: one.text("holder") == "This page is in control."))
            self.runs(other, service)
            self.assertTrue(
                other.comes(lambda: "is in control. You can watch, and stop." in other.text("holder"))
            )
            other.picture("another_steers")
            self.assertTrue(other.browser.run("document.querySelector('#sliders input').disabled"))
            self.assertTrue(other.of("start", "disabled"))
            other.of("lease", "click()")
            self.assertTrue(other.comes(lambda: "steers, and has to give" in other.text("message")))
            other.of("stop", "click()")
            self.assertTrue(one.comes(lambda: one.text("mode") == "Stopped"))
            one.of("lease", "click()")
            self.assertTrue(other.comes(lambda: other.text("holder").startswith("Nobody is in control.")))
            self.assertFalse(other.of("start", "disabled"))

    def test_says_why_it_has_no_connection(self) -> None:
        closed, opened = self.service(), self.service("--allow-origin", "null")
        with self.page() as page:
            page.connect(closed)
            self.assertTrue(page.comes(lambda: "--allow-origin null" in page.text("message")))
            page.connect(opened, "x" * 64)
            self.assertTrue(
                page.comes(lambda: "token" in page.text("message").lower()), page.text("message")
            )
            page.browser.run("document.getElementById('token').value = ''")
            self.runs(page, opened)
            opened.process.terminate()
            self.assertTrue(
                page.comes(lambda: page.text("message").startswith("The connection has ended."))
            )
            self.assertEqual(page.text("force"), "–")

    def test_says_which_constraints_it_does_not_draw(self) -> None:
        service = self.service("--allow-origin", "null", scene="21_puma_560")
        with self.page() as page:
            self.runs(page, service)
            self.assertTrue(
                page.comes(lambda: "virtual manipulator" in page.text("not-drawn")),
                page.text("not-drawn"),
            )

    def test_draws_an_arm_of_seven_joints_as_the_others_and_reads_all_of_them(self) -> None:
        for scene in ("38_panda_wall", "39_iiwa_pose"):
            service = self.service("--start", "--allow-origin", "null", scene=scene)
            with self.page() as page:
                self.runs(page, service)
                self.assertTrue(page.comes(lambda: page.text("joints").count("°") == 7))
                self.assertNotEqual(page.text("joints").split(", ")[6], "0.0°")
                seen = page.browser.run("underactPage.links()")
                self.assertGreaterEqual(len(seen), 8)  # base, seven frames, and a flange
                self.assertLess(max(abs(one) for place in seen for one in place), 1, "out of sight")
                (x, y), (x_tip, y_tip) = seen[0], seen[-1]
                bends = [abs((a - x) * (y_tip - y) - (b - y) * (x_tip - x)) for a, b in seen]
                self.assertGreater(max(bends), 0.05, "a line from base to tip")
                self.assertGreater(max(place[1] for place in seen), y + 0.4, "it lies on its side")
                page.picture(scene)
                self.assertEqual(page.browser.run("checks.tooWide(false)"), [])
                service.end()

    def test_reads_the_six_joints_of_a_haptic_arm(self) -> None:
        service = self.service("--start", "--allow-origin", "null")
        with self.page() as page:
            self.runs(page, service)
            self.assertTrue(page.comes(lambda: page.text("joints").count("°") == 6))

    def test_loads_nothing_from_elsewhere(self) -> None:
        with self.page() as page:
            time.sleep(0.5)
            page.browser.run("0")
            asked = [
                e["params"]["request"]["url"]
                for e in page.browser._events
                if e.get("method") == "Network.requestWillBeSent"
            ]
            self.assertEqual(
                [url for url in asked if not url.startswith(("file:", "data:", "blob:"))], []
            )
            self.assertIn("Permission is hereby granted", PAGE.read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
