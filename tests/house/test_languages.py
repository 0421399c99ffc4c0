"""packaging/languages: what it writes it reads back, and it finds each kind of fault."""

import importlib.machinery
import importlib.util
import pathlib
import tempfile
import unittest

PATH = pathlib.Path(__file__).parents[2] / "packaging/languages"
LOADER = importlib.machinery.SourceFileLoader("languages", str(PATH))
languages = importlib.util.module_from_spec(importlib.util.spec_from_loader("languages", LOADER))
LOADER.exec_module(languages)


def text(source, context="underact::gui", numerus=False):
    return languages.Text(context, source, "", numerus)


class Languages(unittest.TestCase):
    def test_what_is_written_is_read_back(self):
        known = {
            text("&File"): ["&Datei"],
            text("%n step(s)", numerus=True): ["%n Schritt", "%n Schritte"],
            text("a < b & “c”\nd"): ["a < b & „c“\nd"],
        }
        new = text("New")
        with tempfile.TemporaryDirectory() as folder:
            path = folder + "/underact_de.ts"
            languages.write(path, [*known, new], known)
            self.assertEqual(languages.read(path), {**known, new: None})

    def test_what_is_missing_or_gone_is_said(self):
        here, gone = text("here"), text("gone")
        said = list(languages.complaints([here], {gone: ["fort"]}))
        self.assertEqual(len(said), 2)
        self.assertIn("is not translated", said[0])
        self.assertIn("is gone", said[1])

    def test_a_translation_that_disagrees_is_said(self):
        for source, form in [
            ("%1 of %2", "%1 von %1"),
            ("&File", "Datei"),
            ("so $x_1$", "so $x_2$"),
            ("[here](a.md)", "[hier](b.md)"),
            ("<b>now</b>", "<b>jetzt"),
            ("Open…", "Öffnen"),
            ("Points (*.csv);;All", "Punkte (*.txt);;Alle"),
            ("x: ", "x:"),
        ]:
            self.assertEqual(len(list(languages.disagreements(text(source), form))), 1, source)

    def test_one_that_agrees_is_not(self):
        for source, form in [
            ("%1 of %2", "%2: %1"),
            ("&File", "&Datei"),
            ("Feel & see", "Fühlen und sehen"),
            ("so $x_1$ and $y$", "also $y$ und $x_1$"),
        ]:
            self.assertEqual(list(languages.disagreements(text(source), form)), [], source)

    def test_the_texts_of_lessons_and_scenes_are_found(self):
        found = {t.context for t in languages.texts_of_data()}
        self.assertEqual(found, {"lesson text", "scene text"})
        check = {"ask": 1, "question": "q", "say": "s", "choices": ["c"]}
        lesson = {"title": "t", "steps": [{"title": "u", "text": ["a", "b"], "checks": [check]}]}
        self.assertEqual(
            [t for t in languages.texts_of_lesson(lesson) if t], ["t", "u", "a\nb", "q", "s", "c"]
        )


if __name__ == "__main__":
    unittest.main()
