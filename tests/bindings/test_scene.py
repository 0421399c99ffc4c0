"""Scenes in Python give what the command line gives, to the last bit, and tell all that is wrong with one."""

from __future__ import annotations

import doctest
import json
import pickle
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

from beside import CLI, ROOT, SOAK, asked, golden, same
from underact import scene

SHIPPED = sorted((ROOT / "scenes").glob("[0-9]*.json"))


def rotations(count: int, seed: int) -> np.ndarray:
    q, r = np.linalg.qr(np.random.default_rng(seed).normal(size=(count, 3, 3)))
    q *= np.sign(np.diagonal(r, axis1=1, axis2=2))[:, None, :]
    q[:, :, 0] *= np.linalg.det(q)[:, None]
    return q


class BesideTheCommandLine(unittest.TestCase):
    def test_every_scene_that_ships_has_the_same_targets_and_forces(self):
        for seed, path in enumerate(SHIPPED):
            with self.subTest(path.name):
                read = scene.read(path)
                p_mm = np.random.default_rng(seed).uniform(-60, 60, (2000 if SOAK else 12, 3))
                R_WT = rotations(len(p_mm), seed)
                answers = asked(["target", path], [{"p_mm": p.tolist(), "R_WT": R.tolist()} for p, R in zip(p_mm, R_WT)])
                good = np.array(["error" not in one for one in answers])
                if not good.all():
                    with self.assertRaisesRegex(ValueError, "cannot reach"):
                        read.target(p_mm, R_WT)
                p_mm, R_WT = p_mm[good], R_WT[good]
                answers = [one for one in answers if "error" not in one]
                found = read.target(p_mm, R_WT)
                self.assertTrue(same(found.force_N, [one["force_N"] for one in answers]))
                self.assertTrue(same(found.safe_force_N, [one["safe_force_N"] for one in answers]))
                self.assertEqual(found.status.tolist(), [one["status"] for one in answers])
                nowhere = [np.nan] * 3
                each = [one["constraints"] for one in answers]
                self.assertTrue(same(found.target_mm, [[c["q_mm"] or nowhere for c in one] for one in each]))
                self.assertTrue(same(found.each_force_N, [[c["force_N"] for c in one] for one in each]))
                self.assertEqual(found.each_status.tolist(), [[c["status"] for c in one] for one in each])
                self.assertEqual(found.acts.tolist(), [[c["acts"] for c in one] for one in each])
                for index, (name, kind) in enumerate(read.constraints.items()):
                    if kind == "virtual_manipulator":
                        posture = read.least_energy(name, p_mm, R_WT)
                        self.assertTrue(same(posture.theta, [one[index]["theta"] for one in each]))
                        self.assertTrue(same(posture.n_W, [one[index]["n"] for one in each]))
                        self.assertTrue(same(posture.moment_N_mm, [one[index]["moment_N_mm"] for one in each]))

    def test_every_scene_that_ships_is_the_same_written_and_read(self):
        for path in SHIPPED:
            read = scene.read(path)
            again = scene.read_text(read.text, str(path))
            self.assertEqual(read.text, again.text)
            self.assertEqual(pickle.loads(pickle.dumps(read)), read)
            self.assertEqual(scene.check(path), [])

    def test_the_same_problems_are_told(self):
        text = '{"underact_scene": 1, "title": 3, "konstraints": [],\n "constraints": [{"type": "sphere", "radius_mm": -1}]}'
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "wrong.json"
            path.write_text(text)
            told = subprocess.run([CLI, "scene", "check", path], capture_output=True, text=True, check=False).stdout
            problems = scene.check(path)
            self.assertGreater(len(problems), 2)
            self.assertEqual([one.sentence for one in problems], [line.split(": ", 3)[3] for line in told.splitlines()])
            self.assertTrue(all(one.line and one.file == str(path) for one in problems))
            with self.assertRaises(scene.SceneError) as caught:
                scene.read(path)
            self.assertEqual(caught.exception.problems, problems)


class BuiltInCode(unittest.TestCase):
    def test_the_nearest_points_are_those_of_the_golden_vectors(self):
        functions = {
            "sphere": lambda shape: scene.sphere(shape["center"], shape["radius"]),
            "line": lambda shape: scene.line(shape["point"], shape["direction"]),
            "plane": lambda shape: scene.plane(shape["point"], shape["normal"]),
            "circle": lambda shape: scene.circle(shape["center"], shape["axis"], shape["radius"]),
            "cylinder": lambda shape: scene.cylinder(shape["center"], shape["axis"], shape["radius"]),
        }
        checked = 0
        for group in golden("constraints")["shapes"]:
            if len(group["cases"]) < 20 or group["shape"]["type"] not in functions:
                continue  # extreme sizes, which no scene has
            shape = functions[group["shape"]["type"]](group["shape"])
            # Near the axis the rounding of mm to m decides where the nearest point is.
            cases = [case for case in group["cases"] if not case["degenerate"] and np.abs(case["P"]).max() < 1e4]
            cases = [case for case in cases if "near" not in str(case.get("tag"))]
            found = scene.nearest(shape, [case["P"] for case in cases])
            np.testing.assert_allclose(found, [case["Q"] for case in cases], atol=1e-9)
            checked += len(cases)
        self.assertGreater(checked, 150)
        found = scene.nearest(scene.circle((10, 20, 30), (-1, 1, -1), 40), np.random.default_rng(1).normal(size=(50, 3)))
        np.testing.assert_allclose(np.linalg.norm(found - [10, 20, 30], axis=1), 40, atol=1e-12)
        np.testing.assert_allclose((found - [10, 20, 30]) @ [-1, 1, -1], 0, atol=1e-12)

    def test_each_shape_has_its_function(self):
        all_ = [
            scene.point((1, 2, 3)),
            scene.sphere((1, 2, 3), 4),
            scene.line((1, 2, 3), (0, 0, 2)),
            scene.plane(np.arange(3), np.ones(3)),
            scene.circle((1, 2, 3), (0, 1, 0), np.float64(5)),
            scene.cylinder((1, 2, 3), (0, 1, 0), 5, influence={"t": 0.5}),
            scene.box((1, 2, 3), (4, 5, 6), side="outside"),
        ]
        built = scene.build("All", all_, about="Every shape.")
        self.assertEqual(list(built.constraints.values()), [one["type"] for one in all_])
        self.assertEqual(built.about, "Every shape.")
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "all.json"
            built.save(path)
            self.assertEqual(scene.read(path).as_dict(), built.as_dict())

    def test_the_gradient_of_a_virtual_manipulator_is_that_of_its_energy(self):
        home = np.eye(4)
        home[:3, 3] = (50, 0, 0)
        joints = [scene.revolute((0, 0, 1), (0, 0, 0), stiffness_N_mm_per_rad=40), scene.prismatic((1, 0, 0), min=-30, max=30)]
        built = scene.build("A robot", [scene.virtual_manipulator(joints, home, name="robot")])
        X = np.eye(4)
        X[:3, 3] = (30, 20, 5)
        theta = np.random.default_rng(2).uniform(-1, 1, (20, 2)) * [1, 20]
        at = built.energy("robot", theta, X)
        for joint, step in ((0, 1e-5), (1, 1e-3)):
            shift = np.zeros(2)
            shift[joint] = step
            higher, lower = built.energy(0, theta + shift, X), built.energy(0, theta - shift, X)
            slope = (higher.energy_J - lower.energy_J) / (2 * step) * 1e3  # N mm/rad, or N
            np.testing.assert_allclose(at.slope[:, joint], slope, rtol=1e-5, atol=1e-5)
        least = built.least_energy("robot", X[:3, 3])
        np.testing.assert_allclose(built.energy("robot", least.theta, X).slope, 0, atol=1e-6)
        with self.assertRaisesRegex(ValueError, "no virtual manipulator"):
            scene.build("A point", [scene.point((0, 0, 0))]).energy(0, [0.0], X)
        with self.assertRaises(KeyError):
            built.energy("nobody", theta, X)
        with self.assertRaises(IndexError):
            built.energy(5, theta, X)

    def test_a_mesh_is_given_as_it_is_felt(self):
        path = ROOT / "scenes/25_torus_knot.json"
        both = scene.read(path).as_dict()
        del both["constraints"][0]["side"]  # held to the surface, so that every tip has a target
        read = scene.read_text(json.dumps(both), str(path))
        name = next(name for name, kind in read.constraints.items() if kind == "mesh")
        corners, faces = read.mesh(name)
        self.assertEqual((corners.shape[1], faces.shape[1], faces.min(), faces.max()), (3, 3, 0, len(corners) - 1))
        middle = corners[faces[:20]].mean(axis=1)
        np.testing.assert_allclose(read.nearest(middle)[:, 0], middle, atol=1e-3)


class Settings(unittest.TestCase):
    def test_values_are_read_and_changed_by_path_all_at_once(self):
        rim = scene.circle((0, 0, 0), (0, 0, 1), 30, influence={"t": 0.5})
        before = scene.build("Two", [rim, scene.point((1, 2, 3))], control={"anisotropy": "euclidean"})
        after = before.with_values({"/control/kp_N_per_mm": [0.1, 0.2, 0.3], "/constraints/0/influence/t": 0.25})
        self.assertEqual(after["/control/kp_N_per_mm"], (0.1, 0.2, 0.3))
        self.assertEqual(after["/constraints/0/influence/t"], 0.25)
        self.assertEqual(before["/constraints/0/influence/t"], 0.5)
        self.assertEqual(before.with_values({"/control/law": "PD"})["/control/law"], "PD")
        self.assertNotIn("influence", before.with_values({"/constraints/0/influence/t": None}).as_dict()["constraints"][0])
        for values in ({"/control/kp_N_per_mm": -1}, {"/control/law": "X"}, {"/nothing": 1}, {"/constraints/7/influence/t": 1}):
            with self.assertRaises(scene.SceneError):
                before.with_values(values)
        with self.assertRaises(KeyError):
            before["/nothing"]

    def test_all_of_them_are_listed(self):
        paths = {one.path: one for one in scene.settings()}
        self.assertEqual(paths["/control/kp_N_per_mm"].unit, "N/mm")
        self.assertIn("PID", paths["/control/law"].words)


class BadInput(unittest.TestCase):
    def test_what_is_no_pose_is_refused(self):
        point = scene.build("A point", [scene.point((0, 0, 0))])
        for given in (None, "here", [1, 2], np.zeros((3, 2)), np.zeros(3, complex)):
            with self.assertRaises((TypeError, ValueError)):
                point.target(given)
        for given in (np.nan, np.inf, 1e101):
            with self.assertRaisesRegex(ValueError, r"p_mm\[1\] is"):
                point.target([0, given, 0])
        for given in (2 * np.eye(3), np.diag([1, 1, -1]), np.zeros((2, 3, 3)), np.eye(4)):
            with self.assertRaisesRegex(ValueError, "R_WT (must|is not a rotation)"):
                point.target([0, 0, 0], given)
        self.assertEqual(point.target(np.empty((0, 3))).force_N.shape, (0, 3))

    def test_what_is_no_scene_is_refused(self):
        with self.assertRaises(FileNotFoundError):
            scene.read("nowhere.json")
        for text in ("", "{", "[]", "\0", json.dumps({"underact_scene": 1})):
            with self.assertRaises(scene.SceneError):
                scene.read_text(text)
        self.assertEqual(len(scene.check({"underact_scene": 1, "title": "x", "constraints": [{"type": "cube"}]})), 1)
        with self.assertRaises(TypeError):
            scene.read(None)


class Documentation(unittest.TestCase):
    def test_its_examples_run(self):
        found = doctest.testmod(scene)
        self.assertEqual((found.failed, found.attempted > 5), (0, True))
