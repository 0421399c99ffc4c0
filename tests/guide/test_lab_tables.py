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

MEASURED = ("error", "unit", "bound", "default", "question", "timed", "error_is", "reason")
SCENES = {
    path.stem: json.loads(path.read_text(encoding="utf-8"))
    for path in ROOT.glob("scenes/*.json")
    if "schema" not in path.name
}


def rows(text):
    return list(csv.DictReader(io.StringIO(text)))


def shipped(name):
    return rows((ROOT / f"resources/lab/{name}.csv").read_text(encoding="utf-8"))


def files(scenes):
    return [f"scenes/{scene}.json" for scene in scenes]


def points(fronts):
    """What does not depend on the machine."""
    return {
        tuple(row[key] for key in ("scene", "settings", "error_mm", "error_N", "own"))
        for row in fronts
    }


def rounded(limits):
    """Compilers order the sums of the eigenvalues and of the passivity each in its own way."""
    return [
        {key: f"{float(cell):.9g}" if re.fullmatch(r"[-\d.e]+", cell) else cell}
        for row in limits
        for key, cell in row.items()
    ]


def has_no_formula(scene):
    """Its first constraint is a robot, or held in the space of the joints."""
    first = scene["constraints"][0]
    control = {**scene.get("control", {}), **first.get("control", {})}
    return first["type"] == "virtual_manipulator" or control.get("space") == "joint"


class LabTables(unittest.TestCase):
    def test_an_option_has_the_error_of_the_run_that_its_row_names(self):
        runs = {}
        for row in shipped("trade_choices"):
            runs.setdefault((row["choice"], row["scene"], row["hand"]), []).append(row)
        for (choice, scene, hand), wanted in runs.items():
            if not SOAK and all(row["default"] == "false" for row in wanted):
                continue
            words = ["--scenes", *files([scene]), "--hands", hand, "--choices", choice]
            made = {row["option"]: row for row in rows(printed("lab", "trade", *words))}
            for row in wanted:
                with self.subTest(choice=choice, option=row["option"]):
                    again = [made[row["option"]][key] for key in MEASURED]
                    self.assertEqual(again, [row[key] for key in MEASURED])

    def test_every_scene_has_its_front(self):
        table = points(shipped("trade_fronts"))
        self.assertEqual({point[0] for point in table}, set(SCENES))
        for scene in SCENES if SOAK else ["05_circle"]:
            with self.subTest(scene=scene):
                words = ["--table", "fronts", "--scenes", *files([scene])]
                made = points(rows(printed("lab", "trade", *words)))
                self.assertEqual(made, {point for point in table if point[0] == scene})

    def test_walls_have_the_limits_of_the_maps(self):
        table = shipped("stability_limits")
        for key in sorted({row["map"] for row in table}) if SOAK else ("delay", "friction", "hand"):
            with self.subTest(map=key):
                made = rows(printed("lab", "stability", "--map", key))
                self.assertEqual(rounded(made), rounded(row for row in table if row["map"] == key))

    def test_scenes_without_a_formula_have_their_limits(self):
        table = shipped("stability_scenes")
        there = {row["scene"] for row in table}
        left = {name for name, scene in SCENES.items() if has_no_formula(scene)} - there
        words = ["lab", "stability", "--map", "scenes", "--scenes"]
        command = [CLI, *words, *files(sorted(left))]
        done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, timeout=60)
        self.assertEqual(done.stdout, "", "these hold the tip, and are not in the table")
        self.assertEqual(len(done.stderr.splitlines()), len(left), done.stderr)
        for scene in sorted(there) if SOAK else ["13_joint_space"]:
            made = rows(printed(*words, *files([scene])))
            self.assertEqual(rounded(made), rounded(row for row in table if row["scene"] == scene))


if __name__ == "__main__":
    unittest.main()
