"""The sources of the page for the browser, by node alone: where it draws the links of each arm, and
that its list of parts names hashes and no address.
"""

import json
import os
import pathlib
import shutil
import subprocess
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCES = ROOT / "app/browser"
CLI = os.environ.get("UNDERACT_CLI", str(ROOT / "build/release/underact-cli"))

DRAWN = """
import { readFileSync } from "node:fs";
import { linkOrigins } from "%s";
const [arm, q] = process.argv.slice(2);
console.log(JSON.stringify(linkOrigins(JSON.parse(readFileSync(arm, "utf8")), JSON.parse(q))));
"""
RINGS = """
import { History } from "%s";
const history = new History(1, 4);
for (let tick = 0; tick < 10; ++tick)
  history.take({ tick: [250 * tick], q_rad: [[1, 2, 3, 4, 5, 6]], q_more_rad: [[7, 8]],
                 p_WT_mm: [[]], p_WP_mm: [[]], cut_N: [0], error_mm: [tick], force_sent_N: [[3 * tick, 0, 4 * tick]] });
const rows = [];
history.each((age_s, force_N, error_mm) => rows.push([age_s, force_N, error_mm]));
const { time_s: latest, q_rad: q } = history.latest;
console.log(JSON.stringify({ rows, latest, q, count: history.rows }));
"""
READ = """
import { readFileSync } from "node:fs";
import { isUpright, jointTexts, reachOf } from "%s";
const [arm, q] = process.argv.slice(2);
const file = JSON.parse(readFileSync(arm, "utf8"));
console.log(JSON.stringify([jointTexts(file, JSON.parse(q)), isUpright(file), reachOf(file)]));
"""


def said_by(script, source, *words):
    """What a module that imports a source prints, as JSON."""
    text = script % (SOURCES / source).as_uri()
    done = subprocess.run(
        ["node", "--input-type=module", "-e", text, "-", *words], capture_output=True, text=True
    )
    if done.returncode != 0:
        raise AssertionError(done.stderr)
    return json.loads(done.stdout)


@unittest.skipUnless(shutil.which("node"), "nodejs is not installed")
class Sources(unittest.TestCase):
    def test_the_tip_of_each_arm_is_where_forward_kinematics_has_it(self):
        files = sorted((ROOT / "resources/arms").glob("*.json"))
        self.assertGreater(len(files), 10)
        for file in files:
            rows = json.loads(file.read_text())["dh"]
            slides = [row.get("type") == "prismatic" for row in rows]
            q = [0.31, 0.62, -0.47, 0.23, 0.54, -0.71, 0.12][: len(rows)]
            shown = [1000 * one if slide else one for one, slide in zip(q, slides)]  # mm
            said = subprocess.run(
                [CLI, "fk", "--arm", file.stem],
                input=json.dumps({"q_rad": shown}) + "\n",
                capture_output=True,
                text=True,
            )
            self.assertEqual(said.returncode, 0, said.stdout + said.stderr)
            tip = [row[3] for row in json.loads(said.stdout)["X_WT"][:3]]
            drawn = said_by(DRAWN, "kinematics.js", str(file), json.dumps(q))[-1]
            for one, other in zip(tip, drawn):
                self.assertAlmostEqual(one, other, 9, file.stem)

    def test_the_last_second_is_kept_and_no_more(self):
        said = said_by(RINGS, "history.js")
        self.assertEqual([row[0] for row in said["rows"]], [0.75, 0.5, 0.25, 0.0])
        self.assertEqual(said["rows"][-1][1:], [45, 9])
        self.assertEqual((said["latest"], said["count"]), (2.25, 10))
        self.assertEqual(said["q"], [1, 2, 3, 4, 5, 6, 7, 8])

    def test_joints_are_read_in_degrees_and_slides_in_mm(self):
        q = json.dumps([0.5, -1, 0.05, 0.25, 1, 1, -0.1, 0])

        def read(arm):
            return said_by(READ, "kinematics.js", str(ROOT / f"resources/arms/{arm}.json"), q)

        texts, is_upright, reach_mm = read("cobra-600")
        self.assertEqual(texts, ["28.6°", "-57.3°", "50.0 mm", "14.3°"])
        self.assertTrue(is_upright)
        texts, is_upright, reach_mm = read("panda")
        self.assertEqual((len(texts), texts[6], is_upright), (7, "-5.7°", True))
        self.assertGreater(reach_mm, 1000)
        self.assertFalse(read("omni-thesis")[1])


class Parts(unittest.TestCase):
    def test_are_locked_by_their_hashes_and_name_no_address(self):
        lock = json.loads((SOURCES / "package-lock.json").read_text())
        wished = json.loads((SOURCES / "package.json").read_text())["devDependencies"]
        self.assertEqual(sorted(wished), ["esbuild", "three"])
        for name, part in lock["packages"].items():
            if name == "":
                continue
            self.assertTrue(part["integrity"].startswith("sha512-"), name)
            self.assertNotIn("resolved", part, name)
        for name, version in wished.items():
            self.assertEqual(lock["packages"][f"node_modules/{name}"]["version"], version)


if __name__ == "__main__":
    unittest.main()
