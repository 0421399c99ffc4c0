"""Looks at the guide's static pages in Chromium, without a screen: tests/guide/in_browser DESCRIBE [GUIDE].

DESCRIBE is the program underact-describe, which makes the pages. Each is shown at five widths, light
and dark, and as on paper. Exit status 1 where a page is wider than its window, is cut on paper, has
text of too little contrast, a link that leads nowhere, or a search that does not work by the
keyboard; 77, and SKIPPED, without Chromium.
"""

from __future__ import annotations

import json
import pathlib
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from typing import Any
from urllib.parse import unquote

from chromium import Browser, browser, program

ROOT = pathlib.Path(__file__).resolve().parents[3]
CHECKS = (pathlib.Path(__file__).parent / "checks.js").read_text(encoding="utf-8")
WIDTHS = (320, 480, 768, 1280, 1920)
PAPER = 680  # A4 within its margins, in pixels of 1/96 inch
DOORS = ("start", "demonstrate", "teach", "research", "developers")
SCREEN = (1280, 1000)  # what a page that is one screen fits into


def looks(shown: Browser, page: pathlib.Path) -> Iterator[str]:
    """What is wrong with a page to the eye."""
    for width in WIDTHS:
        shown.resize(width, 800)
        yield from (f"{width} px: {what}" for what in shown.run("checks.tooWide(false)"))
    shown.resize(*SCREEN)
    for scheme in ("light", "dark"):
        shown.prefer(scheme)
        yield from (f"{scheme}: {what}" for what in shown.run("checks.tooFaint()"))
    if page.stem in DOORS:
        high = shown.run("document.querySelector('main').scrollHeight")
        if high > SCREEN[1]:
            yield f"is {high} px high, more than a screen"
    shown.resize(PAPER, 1000)
    shown.prefer("dark", media="print")
    yield from (f"paper: {what}" for what in shown.run("checks.tooWide(true)"))
    yield from (f"paper: {what}" for what in shown.run("checks.onPaper()"))
    shown.prefer("light")


def lost(pages: dict[str, dict[str, Any]]) -> Iterator[str]:
    """Links to pages and anchors that are not there."""
    for page, facts in pages.items():
        for link in set(facts["links"]):
            if link.startswith("https://"):
                continue
            to, _, anchor = link.partition("#")
            if to.endswith(".ipynb"):
                if not pathlib.Path(unquote(to.removeprefix("file://"))).is_file():
                    yield f"{name_of(page)}: {name_of(to)} is not there"
                continue
            if to not in pages:
                yield f"{name_of(page)}: {name_of(to)} is no page"
            elif anchor and unquote(anchor) not in pages[to]["anchors"]:
                yield f"{name_of(page)}: {name_of(to)} has no #{unquote(anchor)}"


def name_of(address: str) -> str:
    return address.rsplit("/", 1)[-1]


def comes(shown: Browser, condition: str) -> bool:
    """Whether a condition in JavaScript comes true, within what a busy machine may take."""
    end = time.monotonic() + 10
    while not shown.run(condition):
        if time.monotonic() > end:
            return False
        time.sleep(0.05)
    return True


def search(shown: Browser, folder: pathlib.Path) -> Iterator[str]:
    """Looks for something as one without a mouse does."""
    shown.resize(1280, 800)
    shown.open((folder / "start.html").as_uri())

    def focus() -> str:
        return shown.run("document.activeElement.id || document.activeElement.tagName")

    def said() -> str:
        return shown.run("document.getElementById('found').textContent")

    shown.press("Tab")
    if shown.run("document.activeElement.className") != "skip":
        yield "the first thing that Tab comes to is not the link past the contents"
    shown.press("/")
    if focus() != "search":
        yield "/ does not lead to the search"
    shown.type("no such thing")
    if "Nothing" not in said():
        yield f"where nothing is found, it says: {said()}"
    shown.press("Escape")
    if said() or not shown.run("document.getElementById('contents').checkVisibility()"):
        yield "Escape does not bring the contents back"
    shown.type("singularities")
    if not said().endswith("sections."):
        yield f"what is found is announced as: {said()}"
    shown.press("ArrowDown")
    wanted = shown.run("document.activeElement.href || ''")
    if "course_jacobian.html" not in wanted:
        yield f"the first that is found is {wanted or focus()}"
    shown.press("ArrowUp")
    if focus() != "search":
        yield "the arrow does not lead back to the field"
    shown.press("Enter")
    if not comes(shown, f"location.href === {json.dumps(wanted)}"):
        yield f"Enter leads to {shown.run('location.href')} instead of {wanted}"


def narrow(shown: Browser, folder: pathlib.Path) -> Iterator[str]:
    """On a telephone the page comes before its contents, which open by a click."""
    shown.resize(320, 640)
    shown.open((folder / "safety.html").as_uri())
    # A page that was laid out before it knew its width folds them up with its next picture.
    if not comes(shown, "document.querySelector('h1').getBoundingClientRect().top <= 320"):
        top = shown.run("document.querySelector('h1').getBoundingClientRect().top")
        yield f"320 px: the page begins {top:.0f} px below the top"
    shown.run("document.querySelector('summary').click()")
    if not comes(shown, "document.querySelector('#contents a').checkVisibility()"):
        yield "320 px: the contents do not open"


def check(folder: pathlib.Path, path: str) -> list[str]:
    wrong: list[str] = []
    facts: dict[str, dict[str, Any]] = {}
    began = time.monotonic()
    with browser(path) as shown:
        for page in sorted(folder.glob("*.html")):
            shown.open(page.as_uri())
            shown.run(CHECKS)
            wrong += [f"{page.name}: {what}" for what in looks(shown, page)]
            facts[page.as_uri()] = shown.run("checks.facts()")
            wrong += [f"{page.name}: {what}" for what in facts[page.as_uri()]["wrong"]]
            wrong += [f"{page.name}: {what}" for what in shown.errors()]
        for trial in (search, narrow):
            wrong += trial(shown, folder)
    wrong += lost(facts)
    links = sum(len(page["links"]) for page in facts.values())
    seconds = time.monotonic() - began
    print(f"{len(facts)} pages, {len(WIDTHS)} widths, {links} links: {seconds:.0f} s")
    if len(facts) < 50:
        wrong.append(f"there are {len(facts)} pages only")
    return wrong


def main() -> int:
    if len(sys.argv) not in (2, 3):
        print(__doc__, file=sys.stderr)
        return 2
    path = program()
    if path is None:
        print("SKIPPED: chromium is not installed, so nobody looked at the guide's static pages.")
        return 77
    guide = sys.argv[2] if len(sys.argv) == 3 else str(ROOT / "resources/guide")
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([sys.argv[1], "guide", guide, folder], timeout=120)
        if done.returncode != 0:
            return 1
        wrong = check(pathlib.Path(folder), path)
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
