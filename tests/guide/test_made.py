"""Pages that are made from something else are as it is now; and the static pages' search works."""

import html.parser
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

from pages import GUIDE, ROOT

BUILD = pathlib.Path(os.environ["UNDERACT_BUILD"])
MADE = {
    "command_reference": ["commands"],
    "scene_reference": ["scene-keys", str(ROOT / "scenes/scene.schema.json")],
    "scene_list": ["scene-list", str(ROOT / "scenes")],
    "session_columns": ["session-columns"],
}


def describe(*words):
    """What underact-describe says."""
    return subprocess.run(
        [BUILD / "underact-describe", *words], capture_output=True, text=True, timeout=120
    )


class Made(unittest.TestCase):
    def test_each_page_is_as_its_source(self):
        for page, words in MADE.items():
            done = describe(*words)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(
                (GUIDE / f"{page}.md").read_text(encoding="utf-8"),
                done.stdout,
                f"{page}.md is old: cmake --build build/release --target guide_pages",
            )

    def test_the_python_package_has_the_columns_as_their_table(self):
        done = describe("columns-json")
        self.assertEqual(
            (ROOT / "app/python/underact/columns.json").read_text(encoding="utf-8"), done.stdout
        )

    def test_the_schema_has_the_settings_as_their_table(self):
        path = ROOT / "scenes/scene.schema.json"
        whole = path.read_text(encoding="utf-8")
        schema = json.loads(whole)
        del schema["$defs"]["friction"]["properties"]["dynamic"]
        schema["$defs"]["curve_guide"]["properties"]["lead_mm"]["maximum"] = 7
        schema["$defs"]["side"]["description"] = "Another."
        with tempfile.TemporaryDirectory() as folder:
            old = pathlib.Path(folder) / "schema.json"
            old.write_text(json.dumps(schema))
            for source in (path, old):
                done = describe("scene-schema", str(source))
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(
                    whole, done.stdout, "It is old: cmake --build build/release --target guide_pages"
                )
            old.write_text("{}")
            self.assertEqual(describe("scene-schema", str(old)).returncode, 1)

    def test_every_key_of_the_schema_is_in_the_reference(self):
        page = (GUIDE / "scene_reference.md").read_text(encoding="utf-8")
        schema = json.loads((ROOT / "scenes/scene.schema.json").read_text(encoding="utf-8"))

        def keys(part):
            if isinstance(part, dict):
                for key in part.get("properties", {}):
                    yield key
                for value in part.values():
                    yield from keys(value)
            elif isinstance(part, list):
                for value in part:
                    yield from keys(value)

        for key in set(keys(schema)) - {"type", "filter"}:  # said by headings
            self.assertIn(f"`{key}`", page)

    def test_a_key_without_a_description_is_refused(self):
        schema = json.loads((ROOT / "scenes/scene.schema.json").read_text(encoding="utf-8"))
        del schema["properties"]["title"]["description"]
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "schema.json"
            path.write_text(json.dumps(schema))
            done = describe("scene-keys", str(path))
        self.assertEqual(done.returncode, 1)
        self.assertIn("title", done.stderr)

    def test_wrong_usage_and_missing_files_are_said(self):
        self.assertEqual(describe("guide").returncode, 2)
        self.assertEqual(describe("scene-list", "/no/such/folder").returncode, 1)
        self.assertEqual(describe("guide", "/no/such/folder", "/tmp").returncode, 1)


class Page(html.parser.HTMLParser):
    """What a browser is told of a page: its attributes by tag, and its title."""

    def __init__(self, path):
        super().__init__()
        self.tags, self.title, self.in_title = {}, "", False
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        self.tags.setdefault(tag, []).append(dict(attrs))
        self.in_title = tag == "title"

    def handle_data(self, data):
        self.title += data if self.in_title else ""
        self.in_title = False

    def all(self, tag, key):
        return [found[key] for found in self.tags.get(tag, []) if key in found]

    def ids(self):
        return {found["id"] for tags in self.tags.values() for found in tags if "id" in found}


class StaticPages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        done = describe("guide", str(GUIDE), cls.folder.name)
        assert done.returncode == 0, done.stderr
        paths = pathlib.Path(cls.folder.name).glob("*.html")
        cls.pages = {path.name: Page(path) for path in paths}

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_each_says_its_title_its_language_and_that_it_fits_small_and_dark_screens(self):
        self.assertGreater(len(self.pages), 50)
        titles = [page.title for name, page in self.pages.items() if name != "index.html"]
        self.assertEqual(len(set(titles)), len(titles), "two pages have the same title")
        for name, page in self.pages.items():
            self.assertTrue(page.title.endswith(" – Underact"), name)
            self.assertEqual(page.all("html", "lang"), ["en"], name)
            said = {meta.get("name"): meta["content"] for meta in page.tags["meta"][1:]}
            self.assertIn("width=device-width", said["viewport"], name)
            self.assertEqual(said["color-scheme"], "light dark", name)

    def test_every_link_leads_to_a_page_and_to_a_place_on_it(self):
        for name, page in self.pages.items():
            for link in page.all("a", "href"):
                if link.startswith("https://"):
                    continue
                to, _, anchor = link.partition("#")
                if to.endswith(".ipynb"):  # lies beside its pages
                    notebook = pathlib.Path(self.folder.name) / to
                    self.assertEqual(notebook.read_bytes(), (GUIDE / to).read_bytes())
                    continue
                self.assertIn(to or name, self.pages, f"{name}: {link}")
                if anchor:
                    self.assertIn(anchor, self.pages[to or name].ids(), f"{name}: {link}")

    def test_whoever_has_read_a_page_can_go_on_to_the_next(self):
        contents = json.loads((GUIDE / "contents.json").read_text(encoding="utf-8"))
        order = [name for chapter in contents["chapters"] for name in chapter["pages"]]
        for name, following in zip(order, order[1:]):
            links = self.pages[f"{name}.html"].tags["a"]
            to = [link["href"] for link in links if link.get("rel") == "next"]
            self.assertEqual(to, [f"{following}.html"])

    def test_the_first_page_has_four_doors_before_all_else(self):
        doors = ["demonstrate.html", "teach.html", "research.html", "developers.html"]
        links = self.pages["index.html"].all("a", "href")
        first = links.index("scene_list.html#02_sphere")
        self.assertEqual(links[first + 1 : first + 5], doors)

    def test_a_picture_with_a_dark_one_beside_it_has_both(self):
        pictures = self.pages["demonstrate.html"].tags["img"]
        self.assertEqual(
            [(picture["class"], picture["src"]) for picture in pictures],
            [("light", "pictures/visitor_light.png"), ("dark", "pictures/visitor_dark.png")],
        )
        self.assertEqual(pictures[0]["alt"], pictures[1]["alt"])
        for name, page in self.pages.items():
            for picture in page.all("img", "src"):
                self.assertTrue((pathlib.Path(self.folder.name) / picture).is_file(), name)


class StaticSearch(unittest.TestCase):
    """The pages' own JavaScript, by an interpreter that knows no browser."""

    def test_finds_what_the_window_finds(self):
        if not shutil.which("duk"):
            self.skipTest("duk (Debian's duktape) is not installed")
        with tempfile.TemporaryDirectory() as folder:
            done = describe("guide", str(GUIDE), folder)
            self.assertEqual(done.returncode, 0, done.stderr)
            script = pathlib.Path(folder) / "ask.js"
            files = ("search_index.js", "search.js")
            parts = [(pathlib.Path(folder) / name).read_text() for name in files]
            asks = "".join(
                f"print(guideSearch.find(guideIndex, '{words}')[0].page);"
                for words in ("safety", "energy", "hold to run", "Jacobian SINGULARITIES")
            )
            asks += "print(guideSearch.find(guideIndex, 'no such words here').length);"
            asks += "print(guideSearch.find(guideIndex, ' ').length);"
            asks += "print(guideSearch.find(guideIndex, 'buzz')[0].excerpt.length > 20);"
            asks += "print(guideSearch.said(0, 'x').indexOf('Nothing'), guideSearch.said(1, 'x'));"
            asks += "print(guideSearch.said(guideSearch.find(guideIndex, 'the').length, 'the'));"
            script.write_text("\n".join(parts) + asks)
            said = subprocess.run(["duk", script], capture_output=True, text=True, timeout=60)
        self.assertEqual(said.stderr, "")
        self.assertEqual(
            said.stdout.split(),
            ["safety", "energy", "servo", "course_jacobian", "0", "0", "true"]
            + "0 1 section. The best 60 sections.".split(),
        )


if __name__ == "__main__":
    unittest.main()
