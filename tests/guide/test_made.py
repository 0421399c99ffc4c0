"""Pages that are made from something else are as it is now; and the static pages' search works."""

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
            script.write_text("\n".join(parts) + asks)
            said = subprocess.run(["duk", script], capture_output=True, text=True, timeout=60)
        self.assertEqual(said.stderr, "")
        self.assertEqual(
            said.stdout.split(),
            ["safety", "energy", "servo", "course_jacobian", "0", "0", "true"],
        )


if __name__ == "__main__":
    unittest.main()
