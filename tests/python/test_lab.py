"""The lab's tables and pictures."""

from __future__ import annotations

import math
import tempfile
import unittest
from pathlib import Path

from underact.errors import SessionError, Unreadable
from underact.lab import stability, tables, trade

HEAD = "map,variant,kd_N_s_per_m,simulated_N_per_m,exact_N_per_m,"
LIMITS = HEAD + """colgate_schenkel_N_per_m,gil_hulin_N_per_m
delay,"0 ticks",0,200,200.1,200,200
delay,"0 ticks",0.5,1187,1187.2,0,1200
delay,"1 tick",0,66.7,,200,66.7
delay,"1 tick",0.5,395,395.3,0,400
"""
LABELS = """map,variant,kd_N_s_per_m,stiffness_N_per_m,label,amplitude_mm,passive
delay,"0 ticks",0,100,rest,0,true
delay,"0 ticks",0,300,grows,5,false
delay,"0 ticks",0.5,100,rest,0,false
delay,"0 ticks",0.5,300,limit_cycle,0.1,false
"""
CHOICES = """choice,option,us_per_s,error,unit,bound,default,recommended
rate,250 Hz,50,0.27,mm,0.11,false,false
rate,1000 Hz,200,0.07,mm,0.11,true,true
search,global,1000,0,mm,1e-09,true,true
search,local,700,9.5,mm,1e-09,false,false
"""


class Tables(unittest.TestCase):
    def setUp(self) -> None:
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def write(self, name: str, text: str) -> Path:
        path = self.folder / name
        path.write_text(text, encoding="utf-8")
        return path

    def test_fields_are_numbers_truths_and_words(self) -> None:
        rows = tables.read(self.write("t.csv", "# a comment\n" + LIMITS))
        self.assertEqual(len(rows), 4)
        self.assertEqual(rows[0]["variant"], "0 ticks")
        self.assertEqual(rows[1]["simulated_N_per_m"], 1187.0)
        self.assertTrue(math.isnan(rows[2]["exact_N_per_m"]))
        self.assertIs(tables.read(self.write("l.csv", LABELS))[0]["passive"], True)

    def test_what_is_no_table_is_told(self) -> None:
        with self.assertRaises(Unreadable):
            tables.read(self.folder / "none.csv")
        with self.assertRaises(SessionError):
            tables.read(self.write("empty.csv", "a,b\n"))

    def test_stability_draws_what_there_is(self) -> None:
        self.write("stability_limits.csv", LIMITS)
        self.write("stability_labels.csv", LABELS)
        written = stability.draw_all(self.folder, self.folder, 7.0)
        names = {path.name for path in written}
        self.assertEqual(
            names,
            {f"stability_delay{kind}.{end}" for kind in ("", "_labels") for end in ("svg", "png")},
        )
        for path in written:
            self.assertGreater(path.stat().st_size, 2000)

    def test_a_limit_of_zero_is_no_point(self) -> None:
        rows = tables.read(self.write("t.csv", LIMITS))
        axes = stability.limits(rows, "delay").axes[0]
        formula = next(line for line in axes.lines if line.get_label() == "2 (b - B) / T")
        self.assertEqual(formula.get_ydata()[0], 200.0)
        self.assertTrue(math.isnan(formula.get_ydata()[1]))

    def test_trade_marks_the_default_and_what_is_recommended(self) -> None:
        figure = trade.choices(tables.read(self.write("c.csv", CHOICES)))
        self.assertEqual([axes.get_title("left") for axes in figure.axes], ["rate", "search"])
        for axes in figure.axes:
            marks = [line.get_marker() for line in axes.lines]
            self.assertIn("s", marks)
            self.assertIn("*", marks)
        search = figure.axes[1].lines[0].get_ydata()
        self.assertAlmostEqual(search[0], 1e-10)  # an exact zero stands a decade below the bound

    def test_the_same_table_gives_the_same_bytes(self) -> None:
        self.write("trade_choices.csv", CHOICES)
        one, other = self.folder / "one", self.folder / "other"
        for folder in (one, other):
            folder.mkdir()
            trade.draw_all(self.folder, folder, 7.0)
        for name in ("trade_choices.svg", "trade_choices.png"):
            self.assertEqual((one / name).read_bytes(), (other / name).read_bytes())


if __name__ == "__main__":
    unittest.main()
