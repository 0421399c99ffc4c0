"""No place of the window turns words into HTML: labels are plain (app/gui/kit/application.cpp), and what can show rich
text is used only where the program itself wrote it."""

import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).parents[2]

# What Qt reads as HTML or Markdown, or guesses that it is.
RICH = re.compile(
    r"\b(RichText|AutoText|MarkdownText|setHtml|insertHtml|setMarkdown|fromHtml|QWhatsThis|setWhatsThis|QErrorMessage"
    r"|QSplashScreen|QStaticText|QGraphicsTextItem|QTextDocument\b(?!::)|QTextEdit\b(?!::)|QTextBrowser\b(?!::))"
)

# What stands there is the program's own, or escaped by app/page.
ALLOWED = {
    "app/gui/help/help_dialog.cpp",
    "app/gui/kit/accessible_widgets.cpp",
    "app/gui/kit/application.cpp",
    "app/gui/kit/page_print.cpp",
    "app/gui/kit/page_view.cpp",
    "app/gui/kit/page_view.h",
}


def places(text):
    """The words that can show rich text, without comments and includes."""
    return set(RICH.findall(re.sub(r"//.*|#include.*", "", text)))


class PlainWords(unittest.TestCase):
    def test_only_the_listed_files_can_show_rich_text(self):
        found = {
            str(path.relative_to(ROOT))
            for path in (ROOT / "app/gui").rglob("*")
            if path.suffix in (".h", ".cpp") and places(path.read_text(encoding="utf-8"))
        }
        self.assertEqual(found, ALLOWED)
