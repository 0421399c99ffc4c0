"""A part of every table under resources/lab is measured again: the scenes, errors, bounds and
limits, digit by digit; all of it where UNDERACT_SOAK is set. Times are those of one machine."""

import csv
import io
import json
import re
import subprocess
import unittest

from pages import ROOT
from test_tables import CLI, SOAK, printed

SCENES = {
    path.stem: json.loads(path.read_text(encoding="utf-8"))
    for path in ROOT.glob("scenes/[0-9]*.json")
}
TRADE = ["lab", "trade", "--scenes"]
WALLS = ["lab", "stability", "--map", "scenes", "--scenes"]


def rows(text):
    return list(csv.DictReader(io.StringIO(text)))


def shipped(name):
    return rows((ROOT / f"resources/lab/{name}.csv").read_text(encoding="utf-8"))


def columns(table, *keys):
    return [[row[key] for key in keys] for row in table]


def rounded(limits):
    """Compilers order the sums of eigenvalues and of the passivity each in its own way."""
    number = re.compile(r"\d+\.\d{9,}")
    cells = [cell for row in limits for cell in row.values()]
    return [number.sub(lambda found: f"{float(found[0]):.9g}", cell) for cell in cells]


def has_no_formula(scene):
    """Its first constraint is a robot, or the joints hold it."""
    control = {**scene.get("control", {}), **scene["constraints"][0].get("control", {})}
    is_robot = scene["constraints"][0]["type"] == "virtual_manipulator"
    return is_robot or control.get("space") == "joint"


class LabTables(unittest.TestCase):
    def test_choices_have_the_errors_and_bounds_of_all_scenes(self):
        """Those of open loops in all runs; the others in the runs that the defaults' rows name."""
        table = shipped("trade_choices")
        keys = ("option", "error", "unit", "bound", "default", "question", "error_is", "reason")
        loops = ("search", "solver", "steps", "velocity")
        made = rows(printed("lab", "trade", "--choices", ",".join(loops)))
        own = [row for row in table if row["choice"] in loops]
        self.assertEqual(columns(made, "runs", *keys), columns(own, "runs", *keys))
        for row in table:
            if row["choice"] in ("rate", "simulation", "blocks"):
                self.assertEqual(int(row["runs"]), 5 * len(SCENES), row["option"])
            if row not in own and (SOAK or row["default"] == "true"):
                words = ["--hands", row["hand"], "--choices", row["choice"]]
                made = rows(printed(*TRADE, f"scenes/{row['scene']}.json", *words))
                self.assertIn(columns([row], *keys)[0], columns(made, *keys))

    def test_every_scene_has_its_front(self):
        table = shipped("trade_fronts")
        self.assertEqual({row["scene"] for row in table}, set(SCENES))
        keys = ("settings", "error_mm", "error_N", "own")
        for scene in SCENES if SOAK else ["05_circle"]:
            made = rows(printed(*TRADE, f"scenes/{scene}.json", "--table", "fronts"))
            own = columns([row for row in table if row["scene"] == scene], *keys)
            self.assertCountEqual(columns(made, *keys), own, scene)

    def test_walls_have_the_limits_of_the_maps(self):
        table = shipped("stability_limits")
        for key in {row["map"] for row in table} if SOAK else ("delay", "friction", "hand"):
            made = rows(printed("lab", "stability", "--map", key))
            self.assertEqual(rounded(made), rounded(row for row in table if row["map"] == key))

    def test_scenes_without_a_formula_have_their_limits(self):
        table = shipped("stability_scenes")
        there = {row["scene"] for row in table}
        left = {name for name, scene in SCENES.items() if has_no_formula(scene)} - there
        words = [CLI, *WALLS, *(f"scenes/{scene}.json" for scene in left)]
        done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout, "", "these hold the tip, and are not in the table")
        self.assertEqual(len(done.stderr.splitlines()), len(left), done.stderr)
        for scene in there if SOAK else ["13_joint_space"]:
            made = rows(printed(*WALLS, f"scenes/{scene}.json"))
            self.assertEqual(rounded(made), rounded(row for row in table if row["scene"] == scene))


if __name__ == "__main__":
    unittest.main()
