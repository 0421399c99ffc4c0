"""Arms in Python give what the command line gives, to the last bit, and refuse what is no joint or pose."""

from __future__ import annotations

import doctest
import os
import pickle
import tempfile
import threading
import unittest
from pathlib import Path

import numpy as np

from beside import ARMS, ROOT, SOAK, asked, golden, random_joints, same
from underact import arm, scene, sim

# Of each arm; the soak takes 1e5 of the Omni and 1e4 of the others.
COUNT = 40


def count_of(name: str) -> int:
    return (100_000 if name == "omni-thesis" else 10_000) if SOAK else COUNT


def lines_of(key: str, rows: np.ndarray) -> list[dict]:
    return [{key: row.tolist()} for row in rows]


class BesideTheCommandLine(unittest.TestCase):
    def test_every_arm_has_the_same_poses_and_jacobians(self):
        for seed, name in enumerate(ARMS):
            with self.subTest(name):
                loaded = arm.load(name)
                q = random_joints(loaded, count_of(name), seed)
                q[0] = 0.0  # singular, and with zeros of both signs
                lines = lines_of("q_rad", q)
                answers = asked(["fk", "--arm", name], lines)
                self.assertTrue(same(loaded.fk(q), [one["X_WT"] for one in answers]))
                answers = asked(["jacobian", "--arm", name], lines)
                self.assertTrue(same(loaded.jacobian(q), [one["J"] for one in answers]))
                found = loaded.dexterity(q)
                for key, mine in (("manipulability", found.manipulability), ("condition", found.condition)):
                    self.assertTrue(same(mine, [one[key + "_Jp"] for one in answers]), key)
                self.assertTrue(same(found.det, [one.get("det_Jp", np.nan) for one in answers]))
                self.assertEqual([list(names) for names in found.singular], [one["singular"] for one in answers])

    def test_every_arm_has_the_same_solutions_branches_and_families(self):
        for seed, name in enumerate(ARMS):
            with self.subTest(name):
                loaded = arm.load(name)
                q = random_joints(loaded, count_of(name) // 4, 100 + seed)
                q[0] = 0.0
                X = loaded.fk(q)
                answers = asked(["ik", "--arm", name], lines_of("X_WT", X))
                found = loaded.ik(X)
                self.assertEqual(found.reachable.tolist(), [one["reachable"] for one in answers])
                self.assertEqual(found.singular.tolist(), [one["singular"] for one in answers])
                for i, one in enumerate(answers):
                    solutions = one["solutions"]
                    self.assertEqual(found.count[i], len(solutions))
                    for k, solution in enumerate(solutions):
                        self.assertTrue(same(found.q[i, k], solution["q_rad"]))
                        self.assertEqual(found.within_limits[i, k], solution["within_limits"])
                        self.assertEqual(found.family[i, k] or None, solution["family"])
                        branch = {key: int(all_[i, k]) for key, all_ in found.branch.items()}
                        self.assertEqual(branch or None, solution["branch"])
                    self.assertTrue(np.isnan(found.q[i, len(solutions) :]).all())

    def test_every_arm_has_the_same_statics(self):
        for seed, name in enumerate(ARMS):
            with self.subTest(name):
                loaded = arm.load(name)
                q = random_joints(loaded, count_of(name) // 4, 200 + seed)
                f_N = np.random.default_rng(seed).normal(size=(len(q), 3))
                lines = [{"q_rad": a.tolist(), "f_N": b.tolist(), "moment_N_mm": [1, -2, 3]} for a, b in zip(q, f_N)]
                answers = asked(["statics", "--arm", name], lines)
                found = loaded.statics(q, f_N, [1, -2, 3])
                self.assertTrue(same(found.torque_N_mm, [one["torque_N_mm"] for one in answers]))
                self.assertTrue(same(found.gains_mm, [one["gains_mm"] for one in answers]))
                self.assertTrue(same(found.axes_W, [one["axes_W"] for one in answers]))
                self.assertEqual(found.holding_N_mm is None, "holding_N_mm" not in answers[0])
                if found.holding_N_mm is not None:
                    self.assertTrue(same(found.holding_N_mm, [one["holding_N_mm"] for one in answers]))

    def test_the_iteration_is_the_same(self):
        loaded = arm.load("panda")
        X = loaded.fk(random_joints(loaded, 5, 7))
        posture = [0.0, -0.5, 0.0, -2.0, 0.0, 1.5, 0.7]
        answers = asked(["ik", "--arm", "panda", "--seed", 3, "--prefer", str(posture)], lines_of("X_WT", X))
        found = loaded.ik(X, seed=3, prefer=posture)
        for i, one in enumerate(answers):
            self.assertTrue(same(found.q[i, : found.count[i]], [each["q_rad"] for each in one["solutions"]]))
        answers = asked(["ik", "--arm", "panda", "--search", 20], lines_of("X_WT", X[:1]))
        self.assertTrue(same(loaded.ik(X[0], search=20).q, [each["q_rad"] for each in answers[0]["solutions"]]))

    def test_the_golden_vectors_are_met(self):
        omni = arm.load("omni-thesis")
        cases = golden("fk")["cases"]
        X = omni.fk([case["q"] for case in cases])
        self.assertTrue(same(X, [one["X_WT"] for one in asked(["fk"], [{"q_rad": case["q"]} for case in cases])]))
        np.testing.assert_allclose(X, [case["T"] for case in cases], atol=1e-9)
        cases = golden("ik")["cases"]
        X = np.array([case["T"] for case in cases])
        answers = asked(["ik"], lines_of("X_WT", X))
        found = omni.ik(X)
        for i, one in enumerate(answers):
            self.assertTrue(same(found.q[i, : found.count[i]], [s["q_rad"] for s in one["solutions"]] or np.empty((0, 6))))

    def test_files_are_read_as_the_program_reads_them(self):
        with tempfile.TemporaryDirectory() as folder:
            for form, ending in (("dh", ".json"), ("poe", ".json"), ("urdf", ".urdf")):
                path = Path(folder) / f"kuka_{form}{ending}"
                path.write_text(arm.load("kr5").convert(form))
                q = random_joints(arm.load(path), 10, 1)
                answers = asked(["fk", "--arm", path], lines_of("q_rad", q))
                self.assertTrue(same(arm.load(path).fk(q), [one["X_WT"] for one in answers]), form)


class Shapes(unittest.TestCase):
    def setUp(self):
        self.arm = arm.load("puma-560")
        self.q = random_joints(self.arm, 24, 1)

    def test_one_pose_some_and_a_grid_are_the_same(self):
        every = self.arm.fk(self.q)
        self.assertEqual(every.shape, (24, 4, 4))
        self.assertTrue(same(self.arm.fk(self.q.reshape(2, 3, 4, 6)), every.reshape(2, 3, 4, 4, 4)))
        for i in range(24):
            self.assertTrue(same(self.arm.fk(self.q[i]), every[i]))
            self.assertTrue(same(self.arm.jacobian(self.q[i]), self.arm.jacobian(self.q)[i]))
        one, some = self.arm.ik(every[3]), self.arm.ik(every)
        self.assertTrue(same(one.q, some.q[3, : len(one)]))
        self.assertEqual(self.arm.ik(every.reshape(4, 6, 4, 4)).q.shape[:2], (4, 6))

    def test_every_way_in_which_numpy_holds_numbers_is_the_same(self):
        expected = self.arm.fk(self.q)
        read_only = self.q.copy()
        read_only.flags.writeable = False
        wide = np.zeros((24, 12))
        wide[:, ::2] = self.q
        unaligned = np.frombuffer(b"x" + self.q.tobytes(), dtype=np.uint8)[1:].view(np.float64).reshape(24, 6)
        ways = [self.q.tolist(), tuple(map(tuple, self.q)), read_only, wide[:, ::2], np.asfortranarray(self.q), unaligned]
        ways += [self.q[::-1][::-1], self.q.astype(">f8"), self.q.astype(np.longdouble)]
        for given in ways:
            self.assertTrue(same(self.arm.fk(given), expected))
        whole = np.arange(6)
        for given in (whole, whole.astype(np.int8), whole.astype(np.uint64), whole.astype(np.float32), list(range(6))):
            self.assertTrue(same(self.arm.fk(given), self.arm.fk(whole.astype(float))))

    def test_nothing_is_an_answer_to_nothing(self):
        self.assertEqual(self.arm.fk(np.empty((0, 6))).shape, (0, 4, 4))
        self.assertEqual(self.arm.jacobian(np.empty((3, 0, 6))).shape, (3, 0, 6, 6))
        found = self.arm.ik(np.empty((0, 4, 4)))
        self.assertEqual((found.q.shape, found.count.shape), ((0, 0, 6), (0,)))
        self.assertEqual(self.arm.statics(np.empty((0, 6))).torque_N_mm.shape, (0, 6))

    def test_what_is_given_stays_and_what_is_got_is_ones_own(self):
        before = self.q.copy()
        got = self.arm.fk(self.q)
        got[:] = 0
        self.assertTrue(same(before, self.q))
        self.assertFalse(same(self.arm.fk(self.q), got))

    def test_an_arm_survives_pickle(self):
        again = pickle.loads(pickle.dumps(self.arm))
        self.assertTrue(same(again.fk(self.q), self.arm.fk(self.q)))


class BadInput(unittest.TestCase):
    def setUp(self):
        self.arm = arm.load("omni-thesis")
        self.q = np.zeros(6)

    def refused(self, kind, call, *arguments, words=""):
        with self.assertRaises(kind) as caught:
            call(*arguments)
        sentence = str(caught.exception)
        self.assertRegex(sentence, r"^\S.{10,}\.$")
        self.assertIn(words, sentence)

    def test_what_is_no_number_is_a_type_error(self):
        for given in (None, "zero", b"zero", {}, {1, 2}, ["a"] * 6, [None] * 6, np.zeros(6, complex), object()):
            for call in (self.arm.fk, self.arm.jacobian, self.arm.ik, self.arm.statics, self.arm.dexterity):
                self.refused(TypeError, call, given, words="must be numbers")
        for given in (np.zeros(6, bool), np.zeros(6, "M8[s]"), np.zeros(6, "S1"), np.zeros(6, [("a", float)])):
            self.refused(TypeError, self.arm.fk, given, words="must be numbers")

    def test_masked_arrays_are_refused_wherever_numbers_are_given(self):
        masked = np.ma.masked_greater(np.arange(6.0), 4.0)
        for given in (masked, masked.astype("f4"), np.ma.zeros(6), [masked, masked], ([0.0] * 5 + [masked[5]],)):
            self.refused(TypeError, self.arm.fk, given, words="not a masked array")
        three = np.ma.masked_less(np.zeros(3), 1.0)
        self.refused(TypeError, self.arm.statics, self.q, three, words="f_N must")
        with sim.Simulation(ROOT / "scenes/02_sphere.json") as run:
            self.refused(TypeError, run.want, three, words="p_mm must")
            self.refused(TypeError, run.set, {"/control/kp_N_per_mm": three}, words="masked array")
        self.refused(TypeError, scene.line, (0, 0, 0), three, words="masked array")
        self.refused(TypeError, scene.build, "x", [{"type": "point", "position_mm": three}], words="masked array")

    def test_another_shape_is_a_value_error(self):
        for given in (0.0, [], [[]], np.zeros(5), np.zeros(7), np.zeros((6, 5)), np.zeros((6, 0))):
            self.refused(ValueError, self.arm.fk, given, words="must have the shape (..., 6)")
        for given in (np.eye(3), np.zeros((4, 3)), np.zeros(16), [[]]):
            self.refused(ValueError, self.arm.ik, given, words="must have the shape (..., 4, 4)")
        self.refused(ValueError, self.arm.fk, [[0.0] * 6, [0.0] * 5], words="must have the same length")
        self.refused(ValueError, self.arm.statics, np.zeros((4, 6)), np.zeros((3, 3)), words="one vector for each")

    def test_numbers_that_are_not_finite_are_named(self):
        for number in (np.nan, np.inf, -np.inf, 1.1e6, -1e300):
            given = np.zeros((3, 2, 6))
            given[2, 1, 4] = number
            self.refused(ValueError, self.arm.fk, given, words="q[2, 1, 4] is")
            self.refused(ValueError, self.arm.statics, self.q, [0, 0, number], words="f_N[2] is")
        X = np.eye(4)
        X[0, 3] = np.nan
        self.refused(ValueError, self.arm.ik, X, words="X[0, 3] is nan")

    def test_no_rotation_is_refused(self):
        for change in ((0, 0, 1.01), (3, 0, 0.1), (3, 3, 2.0), (0, 0, -1.0)):
            X = np.eye(4)
            X[change[0], change[1]] = change[2]
            self.refused(ValueError, self.arm.ik, X)
            self.refused(ValueError, self.arm.ik, [np.eye(4), X], words="Pose 1 of X")

    def test_a_rotation_of_four_decimals_is_the_nearest_one(self):
        X = self.arm.fk([0.1, 0.5, -0.3, 0.2, 0.7, 0.4])
        rounded = X.copy()
        rounded[..., :3, :3] = X[..., :3, :3].round(4)
        self.assertTrue(np.allclose(self.arm.ik(rounded).q, self.arm.ik(X).q, atol=0.01, equal_nan=True))

    def test_an_arm_that_is_not_there_is_refused(self):
        self.refused(ValueError, arm.load, "nobody", words="There is no arm")
        self.refused(OSError, arm.load, "./nowhere.json", words="cannot be opened")
        with self.assertRaises(TypeError):
            arm.load(3)
        with tempfile.TemporaryDirectory() as folder:
            wrong = Path(folder) / "wrong.json"
            for text in ("", "{", "[]", '{"underact_arm": 1}', "\0\0", '{"underact_arm": "x"}'):
                wrong.write_text(text)
                with self.assertRaises(ValueError, msg=text) as caught:
                    arm.load(wrong)
                self.assertIn("wrong.json", str(caught.exception))
            with self.assertRaises(OSError):
                arm.load(folder + "/")

    def test_options_out_of_range_are_refused(self):
        X = self.arm.fk(self.q)
        self.refused(ValueError, lambda: self.arm.ik(X, method="fast"))
        self.refused(ValueError, lambda: self.arm.ik(X, search=-1))
        self.refused(ValueError, lambda: self.arm.ik(X, prefer=[0.0] * 5), words="prefer must have the shape")
        self.refused(ValueError, lambda: self.arm.convert("xml"))
        self.refused(ValueError, lambda: self.arm.ik(X, seed=-1), words="seed must be from 0")
        self.refused(TypeError, lambda: self.arm.ik(X, seed=1.5), words="a whole number, not float")

    def test_anything_at_all_is_answered_or_refused(self):
        """A sweep of a fixed seed over shapes, types and values: an array, TypeError or ValueError, and no crash."""
        random = np.random.default_rng(36)
        values = [0.0, -0.0, 1.0, 1e-310, 1e6, -1e6, 1e7, np.nan, np.inf, -np.inf, 2**40]
        types = ["f8", "f4", "f2", ">f8", "i1", "i8", "u4", "c16", "?", "O", "S3", "U2", "M8[s]", "longdouble"]
        answered = 0
        for _ in range(100_000 if SOAK else 3000):
            shape = [random.choice([0, 1, 2, 3, 4, 6, 6, 6, 7]) for _ in range(random.integers(0, 4))]
            if random.random() < 0.3:
                shape += [6] if random.random() < 0.5 else [4, 4]
            with np.errstate(all="ignore"):
                given = random.choice(values[: random.choice([3, 11])], shape).astype(random.choice(types[: random.choice([7, 14])]))
            if random.random() < 0.3:
                given = np.atleast_1d(given.T)[..., ::-1]
            if random.random() < 0.3:
                given.flags.writeable = False
            if random.random() < 0.2:
                given = given.tolist()
            call = random.choice([self.arm.fk, self.arm.ik, self.arm.jacobian, self.arm.statics, self.arm.skeleton])
            try:
                call(given)
                answered += 1
            except (TypeError, ValueError) as error:
                self.assertTrue(str(error).endswith("."), error)
        self.assertGreater(answered, 100)


class Threads(unittest.TestCase):
    def test_four_of_them_get_what_one_gets(self):
        omni = arm.load("omni-thesis")
        q = random_joints(omni, 20_000, 5)
        expected = omni.fk(q)
        solutions = omni.ik(expected).q
        wrong = []

        def work():
            for _ in range(3):
                X = omni.fk(q)
                if not (same(X, expected) and same(omni.ik(X).q, solutions)):
                    wrong.append(threading.get_ident())

        threads = [threading.Thread(target=work) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(wrong, [])

    def test_the_lock_is_released_while_an_array_is_computed(self):
        omni = arm.load("omni-thesis")
        q = random_joints(omni, 300_000, 5)
        done, counted = threading.Event(), [0]

        def count():
            while not done.is_set():
                counted[0] += 1

        thread = threading.Thread(target=count)
        thread.start()
        try:
            before = counted[0]
            omni.fk(q)
            during = counted[0] - before
        finally:
            done.set()
            thread.join()
        self.assertGreater(during, 100)


class Documentation(unittest.TestCase):
    def test_its_examples_run(self):
        found = doctest.testmod(arm)
        self.assertEqual((found.failed, found.attempted > 5), (0, True))

    def test_its_types_are_stated_for_all_that_there_is(self):
        from underact import _core

        stub = (ROOT / "app/python/underact/_core.pyi").read_text()
        for name in dir(_core):
            if name.startswith("__"):
                continue
            self.assertIn(name, stub)
            if isinstance(getattr(_core, name), type):
                for member in vars(getattr(_core, name)):
                    if not member.startswith("__") and member != "_pybind11_conduit_v1_":
                        self.assertRegex(stub, rf"(def {member}\(|    {member}: )", f"{name}.{member}")

    @unittest.skipIf("UNDERACT_UNDER_ASAN" in os.environ, "ASan keeps memory that is freed")
    def test_memory_stays_flat(self):
        import resource

        omni = arm.load("omni-thesis")
        q = random_joints(omni, 2000, 5)
        for repeats in (30, 300):
            for _ in range(repeats):
                omni.ik(omni.fk(q))
                omni.statics(q)
            peak_kB = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
            first_kB = peak_kB if repeats == 30 else first_kB
        self.assertLess(peak_kB - first_kB, 20_000)
