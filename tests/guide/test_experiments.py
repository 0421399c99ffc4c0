"""The experiments: every number that the page of answers says comes out is what the program says.
A row of a number is (value, decimals); they stand in the order of the paragraph."""

import importlib.machinery
import importlib.util
import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest
from math import acos, atan, cos, degrees, exp, hypot, log, pi, radians, sin, sqrt

from pages import GUIDE, ROOT, prose
from test_commands import commands
from test_course import CLI, ask

import numpy as np

LOADER = importlib.machinery.SourceFileLoader("languages", str(ROOT / "packaging/languages"))
languages = importlib.util.module_from_spec(importlib.util.spec_from_loader("languages", LOADER))
LOADER.exec_module(languages)
SHEETS = (GUIDE / "experiments.md").read_text(encoding="utf-8")
ANSWERS = (GUIDE / "experiments_answers.md").read_text(encoding="utf-8")


def sections(text):
    """The text of each experiment by its heading."""
    return {part.split("\n", 1)[0]: part for part in re.split(r"^## ", text, flags=re.M)[1:]}


def claimed(section):
    """The numbers of what comes out, as they are printed."""
    paragraph = re.search(r"\*\*Comes out\.\*\*(.*?)\n\n", prose(section), re.S).group(1)
    return re.findall(r"-?\d+(?:\.\d+)?", paragraph.replace("−", "-"))


def edited(scene, **control):
    """A shipped scene with another control: what it answers to places of the tip, mm."""
    file = json.loads((ROOT / f"scenes/{scene}.json").read_text(encoding="utf-8"))
    file["control"].update(control)
    return file


def answers_of(file, rows):
    """What a scene does to the stylus at these places."""
    with tempfile.NamedTemporaryFile("w", suffix=".json") as scene:
        json.dump(file, scene)
        scene.flush()
        return ask(f"target {scene.name}", rows)


def limit(rate_hz=1000, damping=4, more=""):
    """Above it a wall swings, N/mm, and what the two formulas say."""
    words = f"lab stability --mass_kg 0.1 --damping_N_s_per_m {damping} --rate_hz {rate_hz} --json"
    found = ask(f"{words} {more}", [])[0]
    keys = ("exact_limit_N_per_m", "colgate_schenkel_N_per_m", "gil_hulin_N_per_m")
    return [found[key] / 1000 for key in keys]


def arm_of(rows):
    """An arm file's text: rows of alpha, a, theta in degrees and mm, filled up to six."""
    rows = [*rows, *[(0, 0, 0)] * (6 - len(rows))]
    keys = ("alpha_deg", "a_mm", "theta_deg")
    return {
        "underact_arm": 1,
        "name": "made",
        "title": "Made",
        "provenance": "A test.",
        "dh": [{**dict(zip(keys, row)), "d_mm": 0} for row in rows],
        "X_WB": [[0, 1, 0, 0], [0, 0, 1, 30], [1, 0, 0, -176], [0, 0, 0, 1]],
    }


def tip_of(rows):
    """Where an arm of these rows ends: the program's forward kinematics."""
    with tempfile.NamedTemporaryFile("w", suffix=".json") as arm:
        json.dump(arm_of(rows), arm)
        arm.flush()
        return np.array(ask(f"fk --arm {arm.name}", [{"q_rad": [0] * 6}])[0]["X_WT"])


def spring():
    soft = edited("01_point", kp_N_per_mm=0.1)
    at = [2, 8, 8.8, 40]
    rows = [{"p_mm": [x, 0, 0]} for x in at]
    sent = [hypot(*row["safe_force_N"]) for row in answers_of(soft, rows)]
    assert abs(sent[2] - sent[3]) < 1e-9
    command = next(one.text for one in commands() if "pull.csv" in one.text)
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(ROOT / "scenes", f"{folder}/scenes")
        env = {**os.environ, "PATH": f"{CLI.parent}:/usr/bin:{os.environ['PATH']}"}
        done = subprocess.run(
            ["bash", "-c", command], cwd=folder, env=env, capture_output=True, text=True, check=True
        )
    slope = float(done.stdout.split()[-1])
    return [
        *[(0.1, 1), (sent[0], 2), (2, 0), (sent[1], 2), (8, 0)],
        *[(8.8, 1), (sent[3], 2), (slope, 1)],
    ]


def claps(gain, late):
    """How far the pencil is after the fifth."""
    before = now = 8.0
    for _ in range(5):
        before, now = now, now - gain * (before if late else now)
    return now


def servo():
    assert claps(1.5, False) == -claps(0.5, False)
    calm, late = limit()[0], limit(more="--delay_ticks 1")[0]
    return [
        *[(claps(0.5, False), 2), (1.5, 1), (2, 0), (abs(claps(2, False)), 0)],
        *[(2.5, 1), (abs(claps(2.5, False)), 2), (1, 0), (abs(claps(1, True)), 0)],
        *[(1.5, 1), (claps(1.5, True), 0), (1000, 0), (calm, 2), (4, 0), (late, 2)],
    ]


def wall():
    rates = (500, 1000, 2000)
    amber = [(limit(rate, more="--delay_ticks 1")[2], rate) for rate in rates]
    rows = [limit(rate) for rate in rates]
    return [
        *[pair for stiff, rate in amber for pair in ((stiff, 2), (rate, 0))],
        *[(row[0], 2) for row in rows],
        *[(row[1], 0) for row in rows],
        *[(limit(damping=2)[0], 2), (1000, 0), (2, 0)],
    ]


def swing():
    def overshoot(damping):
        found = ask(f"lab step --num 5000 --den 1,{damping / 0.1},5000 --json", [])[0]
        return 100 * (found["overshoot_fraction"] or 0)

    words = f"lab step --scene {ROOT}/scenes/01_point.json --json"
    more = "--mass_kg 0.055 --damping_N_s_per_m 4"  # the arm has 0.045 kg
    zeta = ask(f"{words} {more}", [])[0]["model"]["zeta"]
    dampings = (0.002, 0.005, 0.01)
    critical = (2 * sqrt(500 * 0.1) - 4) / 1000
    assert overshoot(4 + 1000 * critical + 0.01) == 0
    return [
        *[(8, 0), (10, 0), (log(10 / 8) / (2 * pi), 3), (zeta, 2), (overshoot(4), 1)],
        *[(0.002, 3), (0.005, 3), (0.01, 2)],
        *[(overshoot(4 + 1000 * kd), 1) for kd in dampings],
        (critical, 5),
    ]


def own_arm():
    def wrist(q1):
        tip = tip_of([(0, 0, q1), (0, 280, 60), (0, 250, 0)])
        return tip[2, 3] + 176, tip[0, 3]

    ahead, aside = wrist(30)
    more = wrist(31)
    return [(ahead, 1), (aside, 1), (hypot(more[0] - ahead, more[1] - aside), 1)]


def book():
    def apart(angle):
        first = tip_of([(angle, 0, angle)])[:3, :3]  # Rx, then Rz
        other = tip_of([(0, 0, angle), (angle, 0, 0)])[:3, :3]
        return degrees(acos((np.trace(first.T @ other) - 1) / 2))

    return [(apart(90), 1), (45, 0), (apart(45), 1), (10, 0), (apart(10), 1)]


def solutions(q_rad):
    """How many there are of where these joints bring the stylus, and how many within the limits."""
    found = ask("ik", ask("fk", [{"q_rad": q_rad}]))[0]["solutions"]
    return len(found), sum(one["within_limits"] for one in found)


def elbows():
    def border(sign):
        low, high = 0.0, 1.0
        while high - low > 1e-4:
            middle = (low + high) / 2
            two = solutions([0, 0.53, 0.36, sign * middle, pi / 2, -pi / 2])[1] == 2
            low, high = (low, middle) if two else (middle, high)
        return sign * degrees(high)

    first, second = solutions([0, 0.6, 0.3, 0, 1.2, 0]), solutions([0, 0.6, 0.3, 0.8, 1.2, -1.57])
    assert first[0] == second[0]
    return [(first[0], 0), (first[1], 0), (second[1], 0), (border(1), 1), (border(-1), 1)]


def reach():
    def string(bend):
        tip = tip_of([(0, 0, 0), (0, 280, bend), (0, 250, 0)])
        return hypot(tip[2, 3] + 176, tip[0, 3])

    def least(place):
        pose = [[1, 0, 0, place[0]], [0, 0, 1, place[1]], [0, -1, 0, place[2]], [0, 0, 0, 1]]
        q_rad = ask("ik", [{"X_WT": pose}])[0]["solutions"][0]["q_rad"]
        J = np.array(ask("jacobian", [{"q_rad": q_rad}])[0]["J"])
        return np.linalg.svd(J[:3, :3])[1][2] / 1000

    middle, end = least((0, 0, 0)), least((0, 25, 98))
    return [
        *[(280, 0), (250, 0), (string(80) - string(90), 1), (string(0) - string(10), 1)],
        *[(middle, 3), (end, 3), (0.01, 2), (10 * middle, 2), (10 * end, 2)],
        *[(0.1, 1), (0.1 / middle, 2), (0.1 / end, 2)],
    ]


def pressed(depth, steps):
    """How far aside the tip is of the bracket's target when it lets go, and while it slides or, in
    steps with a rest after each, where it rests after it has slipped; mm."""
    scene = edited("27_bracket", kp_N_per_mm=0.1)
    scene["constraints"][0]["file"] = str(ROOT / "scenes" / scene["constraints"][0]["file"])
    face, y = -17, -15
    path = [(0, 0, 10), (1, 0, face - depth), (2, 0, face - depth), (6, 8, face - depth)]
    if steps:
        path[3:] = [(2 + k / 2 - rest, k, face - depth) for k in range(1, 9) for rest in (0.4, 0)]
    firm = {"mass_kg": 0.1, "damping_N_s_per_m": 40, "stiffness_N_per_m": 20000}
    points = [{"t_s": t, "p_mm": [x, y, z]} for t, x, z in path]
    with tempfile.TemporaryDirectory() as folder:
        files = {"scene": scene, "hand": {"underact_hand": 1, "hand": firm, "path": points}}
        for name, value in files.items():
            pathlib.Path(folder, f"{name}.json").write_text(json.dumps(value), encoding="utf-8")
        words = f"run {folder}/scene.json --hand {folder}/hand.json --seconds 6 --fast"
        ask(f"{words} --record {folder}/ticks.csv", [])
        ticks = np.genfromtxt(f"{folder}/ticks.csv", delimiter=",", names=True)
    ticks = ticks[ticks["time_s"] > 1.9]
    aside = np.hypot(ticks["x_mm"] - ticks["target_x_mm"], ticks["y_mm"] - ticks["target_y_mm"])
    share = aside / (ticks["target_z_mm"] - ticks["z_mm"])
    if steps:
        ends = np.searchsorted(ticks["time_s"], [2.49 + k / 2 for k in range(8)])
        slides = ends[np.diff(ticks["target_x_mm"][ends], prepend=0) > 1]
    else:
        slides = np.abs(np.diff(ticks["target_x_mm"], prepend=ticks["target_x_mm"][0])) > 1e-3
    return depth * np.max(share), depth * np.median(share[slides])


def slope():
    friction = json.loads((ROOT / "scenes/27_bracket.json").read_text(encoding="utf-8"))
    friction = friction["constraints"][0]["friction"]
    angles = [degrees(atan(friction[key])) for key in ("static", "dynamic")]
    lets_go, rests = pressed(5, steps=True)
    again, behind = pressed(5, steps=False)
    return [
        *[(friction["static"], 1), (friction["dynamic"], 1), (angles[0], 1), (angles[1], 1)],
        *[(5, 0), (lets_go, 1), (rests, 1), (again, 1), (behind, 1)],
    ]


def point():
    def target(beta, alpha, t):
        file = edited("14_circle_influence")
        file["constraints"][0]["influence"]["t"] = t
        b, a = radians(beta), radians(alpha)
        turned = [[-sin(a), 0, cos(a)], [cos(a), 0, sin(a)], [0, 1, 0]]
        row = {"p_mm": [50 * cos(b), 50 * sin(b), 0], "R_WT": turned}
        x, y, _ = answers_of(file, [row])[0]["q_mm"]
        return degrees(np.arctan2(y, x))

    half, quarter, back = target(0, 90, 0.5), target(0, 90, 0.25), abs(target(170, -170, 0.5))
    assert abs(target(0, 90, 0) - 90) < 1e-9 and abs(target(0, 90, 1)) < 1e-9
    return [(half, 0), (quarter, 1), (170, 0), (-170, 0), (back, 0), (0, 0)]


def cardboard():
    def pulls(angle):
        a = radians(180 - angle)  # the base lies to the left of the rocker's pivot
        row = {"p_mm": [30 + 50 * cos(a), -20 + 50 * sin(a), 0]}
        return hypot(*ask(f"target {ROOT}/scenes/19_four_bar.json", [row])[0]["force_N"]) > 1e-5

    def end(inside, outside):
        while abs(outside - inside) > 1e-4:
            middle = (inside + outside) / 2
            inside, outside = (inside, middle) if pulls(middle) else (middle, outside)
            inside, outside = (inside, outside) if not pulls(inside) else (outside, inside)
        return inside

    ends = end(90, 20), end(90, 160)
    return [(ends[0], 1), (ends[1], 1), (ends[1] - ends[0], 1)]


def coins():
    words = f"calibrate {ROOT}/scenes/23_two_beams.json --weber 0.15 --seed"
    found = [log(ask(f"{words} {seed}", [])[0]["threshold"]) for seed in range(1, 61)]
    formula = exp(0.771 * 0.15) - 1
    beams = formula * (0.5 + 0.03) / 0.5
    return [
        *[(15, 0), (100 * formula, 1), (100 * beams, 1), (100 * exp(found[0]), 1)],
        *[(1, 0), (10, 0), (100 * exp(np.mean(found[:10])), 1)],
        *[(1, 0), (60, 0), (100 * exp(np.mean(found)), 1)],
    ]


def account(scene, hand, seconds, *more):
    """The energy account of a run, mJ, tick by tick. hand: a name, or places ahead (t, z), mm."""
    with tempfile.TemporaryDirectory() as folder:
        if not isinstance(hand, str):
            points = [{"t_s": t, "p_mm": [0, 0, z]} for t, z in hand]
            hand = f"{folder}/hand.json"
            text = json.dumps({"underact_hand": 1, "path": points})
            pathlib.Path(hand).write_text(text, encoding="utf-8")
        words = f"run {ROOT}/scenes/{scene}.json --hand {hand} --seconds {seconds} --fast"
        ask(" ".join([words, *more, f"--record {folder}/ticks.csv"]), [])
        ticks = np.genfromtxt(f"{folder}/ticks.csv", delimiter=",", names=True)
    return ticks["energy_mJ"]


def energy():
    """The steps 3 to 5 of the experiment of energy.md."""
    stiff, ideal, control = "24_too_stiff", "--arm-model ideal", "--set /control/passivity=control"
    at_rest = account(stiff, [(0, 60), (1, 40)], 6)
    assert abs(at_rest[-1] - at_rest[2000]) < 1e-9
    buzzing = account(stiff, [(0, 60), (1, 40)], 6, ideal)
    sweeps = ([], [ideal], [ideal, control], [control])
    lowest = [min(account(stiff, "sweep", 20, *more)) for more in sweeps]
    pushes = [(0, 50), *[(1 + 0.3 * k, 46 if k % 2 else 50) for k in range(13)]]
    damped = "--set /control/law=PD --set /control/kd_N_s_per_mm=0.002"
    ends = [account("02_sphere", pushes, 5, *more)[4600] for more in ([], [damped])]
    return [
        *[((buzzing[2000] - buzzing[-1]) / 4, 0), (20, 0), (lowest[0], 1), (lowest[1], 1)],
        *[(lowest[2], 2), (lowest[3], 1), (4, 0), (0.3, 1)],
        *[(ends[0], 2), (2, 0), (ends[1], 2), (2, 0)],
        *[(500 / 2000, 2), (0.5, 1), (1000, 0), (5000 / 2000, 1), (5, 0)],
    ]


MEASURED = {
    "1. A spring, a scale, a line": spring,
    "2. Be the servo": servo,
    "3. The wall that buzzes": wall,
    "4. A swing that dies out": swing,
    "5. The table of your own arm": own_arm,
    "6. A book does not commute": book,
    "7. One cup, many elbows": elbows,
    "8. Reach straight out": reach,
    "9. A coin on a slope": slope,
    "10. Point and go": point,
    "11. Four strips of cardboard": cardboard,
    "12. Coins in envelopes": coins,
}


class Experiments(unittest.TestCase):
    def test_every_number_that_comes_out_is_the_programs(self):
        answers = sections(ANSWERS)
        self.assertEqual(list(answers), list(MEASURED))
        for title, measured in MEASURED.items():
            with self.subTest(experiment=title):
                wanted = [f"{value:.{decimals}f}" for value, decimals in measured()]
                self.assertEqual(claimed(answers[title]), wanted)

    def test_what_the_page_of_energy_says_happens(self):
        page = (GUIDE / "energy.md").read_text(encoding="utf-8")
        steps = prose(page).replace("−", "-").split("\n3. ")[1]
        wanted = [f"{value:.{decimals}f}" for value, decimals in energy()]
        self.assertEqual(re.findall(r"-?\d+(?:\.\d+)?(?!\.\s\w)", steps), wanted)

    def test_each_worksheet_has_its_answers_and_fits_on_a_sheet(self):
        sheets, answers = sections(SHEETS), sections(ANSWERS)
        self.assertEqual(list(sheets), list(answers))
        for title, sheet in sheets.items():
            for part in ("**Question.**", "**Needed.**", "**Write down.**"):
                self.assertEqual(sheet.count(part), 1, title)
            for part in ("**Comes out.**", "**Why.**", "**Goes wrong.**"):
                self.assertEqual(answers[title].count(part), 1, title)
            self.assertLess(len(sheet.splitlines()), 50, title)

    def test_what_a_worksheet_names_is_in_the_window(self):
        if languages.lupdate() is None:
            self.skipTest("lupdate of Qt 6 is not installed (qt6-l10n-tools)")
        names = set(languages.names_in(SHEETS))
        self.assertGreater(len(names), 20)
        there = {languages.plain(text.source) for text in languages.texts_of_code()}
        self.assertEqual(names - there, set())


if __name__ == "__main__":
    unittest.main()
