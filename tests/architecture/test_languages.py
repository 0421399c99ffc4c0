"""packaging/languages: what it writes it reads back, and it finds each kind of fault."""

import importlib.machinery
import importlib.util
import pathlib
import re
import tempfile
import unittest

ROOT = pathlib.Path(__file__).parents[2]
PATH = ROOT / "packaging/languages"
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

    def test_a_lesson_names_what_the_window_has_in_each_language(self):
        window = {text("Save &as…"): ["Speichern &unter …"], text("feel"): ["Fühlen"]}
        for source, form, count in [
            ("*Save as* in *Feel*", "*Speichern unter* in *Fühlen*", 0),
            ("*Save as* in *Feel*", "Im Bereich *Fühlen*: *Speichern unter*", 0),
            ("**Mind** $a*b*c$", "**Achtung** $a*b*c$", 0),
            ("*Save as*", "*Sichern*", 1),
            ("*Save as*", "Speichern unter", 1),
            ("*Save as*", "*Speichern unter* in *Fühlen*", 1),
            ("*Save it*", "*Speichern unter*", 2),
        ]:
            known = {**window, text(source, languages.LESSON): [form]}
            said = list(languages.strange_names(known, known))
            self.assertEqual(len(said), count, f"{source}: {said}")

    def test_the_german_has_one_word_for_a_thing(self):
        page = (ROOT / "resources/languages/README.md").read_text(encoding="utf-8")
        rows = [row.split("|") for row in page.splitlines() if row.count("|") == 4]
        never = [word for row in rows for word in re.findall(r"`([^`]+)`", row[3])]
        self.assertGreater(len(never), 15)
        known = languages.read(str(ROOT / "resources/languages/underact_de.ts"))
        for form in (form for forms in known.values() for form in forms or []):
            self.assertEqual([word for word in never if word in form], [], form)

    def test_the_texts_of_lessons_and_scenes_are_found(self):
        found = {t.context for t in languages.texts_of_data()}
        self.assertEqual(found, {"lesson text", "scene text"})
        check = {"ask": 1, "question": "q", "say": "s", "choices": ["c"]}
        lesson = {"title": "t", "steps": [{"title": "u", "text": ["a", "b"], "checks": [check]}]}
        self.assertEqual(
            [t for t in languages.texts_of_lesson(lesson) if t], ["t", "u", "a\nb", "q", "s", "c"]
        )

    def test_a_sentence_below_the_window_that_nobody_marked_is_said(self):
        code = """// It is only a comment.
#include "a file. Not a sentence."
const char* kKey = "kp_N_per_mm.";
said(QT_TRANSLATE_NOOP("problem", "This is "
                                  "known to them."));
return "The \\"key\\" is " // so
       "not there.";
"""
        self.assertEqual(list(languages.unmarked(code)), [(6, 'The \\"key\\" is not there.')])


if __name__ == "__main__":
    unittest.main()
