"""A simulation in Python is the command line's, tick by tick to the bit, and its session is made again by the program."""

from __future__ import annotations

import doctest
import json
import subprocess
import tempfile
import threading
import unittest
from pathlib import Path

import numpy as np

from beside import CLI, ROOT, SOAK, same
from underact import Session, scene, sim

CIRCLE = ROOT / "scenes/05_circle.json"
OF_THE_CLOCK = ("tick_us", "tick_ns")  # how long a tick took here


def program(*words: object) -> dict:
    """What `underact-cli WORDS` says, as JSON; its exit status must be 0."""
    done = subprocess.run([CLI, *map(str, words)], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise AssertionError(f"{words}: {done.returncode}: {done.stderr}{done.stdout}")
    return json.loads(done.stdout.splitlines()[-1]) if done.stdout else {}


class InFolder(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)

    def same_ticks(self, session: Session, columns: dict) -> None:
        for name, values in columns.items():
            if name not in OF_THE_CLOCK:
                self.assertTrue(same(session.ticks[name], values), name)


class BesideTheCommandLine(InFolder):
    def test_every_hand_has_the_same_ticks(self):
        scenes = [CIRCLE, ROOT / "scenes/12_line_pid.json", ROOT / "scenes/20_scara.json"]
        if SOAK:
            scenes = [path for path in sorted((ROOT / "scenes").glob("[0-9]*.json"))]
        for path in scenes:
            for hand in sim.hands() if path == CIRCLE else ["tremor"]:
                with self.subTest(f"{path.stem}, {hand}"):
                    file = self.folder / "run.h5"
                    words = ["--hand", hand, "--seconds", 0.7, "--seed", 5, "--fast", "--record", file, "--overwrite"]
                    program("run", path, *words)
                    run = sim.Simulation(path, hand, seed=5)
                    for ticks in (1, 99, 350, 250):
                        run.step(ticks)
                    with Session(file) as session:
                        self.same_ticks(session, run.columns())

    def test_a_hand_of_a_file_is_the_same_as_its_content(self):
        hand = {"underact_hand": 1, "path": [{"t_s": 0, "p_mm": [0, 0, 0]}, {"t_s": 0.5, "p_mm": [20, 10, 0]}]}
        path = self.folder / "hand.json"
        path.write_text(json.dumps(hand))
        file = self.folder / "run.h5"
        program("run", CIRCLE, "--hand", path, "--seconds", 0.5, "--fast", "--record", file)
        with Session(file) as session:
            self.same_ticks(session, sim.Simulation(CIRCLE, hand).run(0.5).columns())
            self.same_ticks(session, sim.Simulation(CIRCLE, path).run(0.5).columns())


class Sessions(InFolder):
    def test_a_session_is_made_again_from_its_hand(self):
        file = self.folder / "a.h5"
        with sim.simulate(CIRCLE, "probe", 1.0, file, seed=7, name="probed") as session:
            self.assertTrue(session.complete)
            self.assertEqual(session.attributes["name"], "probed")
            self.assertEqual(len(session.ticks["tick"]), 1000)
        again = program("rerun", file)
        self.assertEqual((again["identical"], again["identical_ticks"], again["made_from"]), (True, 1000, "hand"))
        program("replay", file, "--verify")

    def test_a_function_as_a_hand_is_replayed_and_made_again_from_its_input(self):
        def hand(state: sim.State):
            if 0.3 < state.time_s < 0.4:
                return None  # lets go
            return [30 * np.cos(4 * state.time_s), 30 * np.sin(4 * state.time_s), 0.2 * state.error_mm]

        file = self.folder / "b.h5"
        with sim.Simulation(CIRCLE, hand, record=True, every=5) as run:
            run.run(0.5)
            run.set({"/control/kp_N_per_mm": 0.2})
            run.mark("softer")
            run.push([0.3, 0, 0], 0.05)
            run.run(0.5)
            columns = run.columns()
            with run.save(file) as session:
                self.same_ticks(session, columns)
                self.assertEqual([mark.label for mark in session.markers], ["softer"])
                self.assertEqual(len(session.changes), 2)
        self.assertGreater(np.ptp(columns["p_WT_mm"][:, 0]), 10)
        again = program("rerun", file)
        self.assertEqual((again["identical"], again["made_from"]), (True, "recorded input"))
        program("replay", file, "--verify")

    def test_a_file_is_not_replaced_unless_asked(self):
        file = self.folder / "c.h5"
        file.write_text("mine")
        with sim.Simulation(CIRCLE, "still", record=True) as run:
            run.run(0.1)
            with self.assertRaises(FileExistsError):
                run.save(file)
            run.save(file, overwrite=True).close()
            with self.assertRaises(ValueError):
                run.save(self.folder / "d.h5")
        with self.assertRaisesRegex(ValueError, "record=True"):
            sim.Simulation(CIRCLE, "still").save(self.folder / "e.h5")


class InLockstep(unittest.TestCase):
    def test_two_runs_are_the_same_and_another_seed_is_not(self):
        one, other, third = (sim.Simulation(CIRCLE, "tremor", seed=seed).run(0.3).columns() for seed in (1, 1, 2))
        self.assertTrue(all(same(one[name], other[name]) for name in one if name not in OF_THE_CLOCK))
        self.assertFalse(same(one["p_WT_mm"], third["p_WT_mm"]))

    def test_the_arm_pulls_the_hand_to_the_constraint(self):
        held = scene.build("A sphere", [scene.sphere((0, 0, 0), 30)], control={"law": "P", "kp_N_per_mm": 0.5})
        run = sim.Simulation(held, rate_hz=2000)
        run.want([0, 0, 45])
        run.run(1.0)
        state = run.state
        self.assertEqual((state.tick, state.mode, state.fault), (2000, "running", "none"))
        self.assertLess(state.force_N[2], -0.3)
        self.assertLess(30, np.linalg.norm(state.p_mm))
        self.assertLess(np.linalg.norm(state.p_mm), 45)
        run.forget()
        run.step(3)
        self.assertEqual(run.columns()["tick"].tolist(), [2001, 2002, 2003])

    def test_states_are_the_same_where_all_numbers_are(self):
        one, other = (sim.Simulation(CIRCLE, "tremor").run(0.1) for _ in range(2))
        self.assertEqual(one.state, other.state)
        self.assertEqual(len({one.state, other.state}), 1)
        other.step()
        self.assertNotEqual(one.state, other.state)
        self.assertNotEqual(one.state, "running")

    def test_before_the_first_tick_there_are_columns_without_rows(self):
        run = sim.Simulation(CIRCLE)
        self.assertEqual(run.columns()["p_WT_mm"].shape, (0, 3))
        run.step(2)
        run.forget()
        self.assertEqual((run.columns()["error_mm"].shape, run.state.tick), ((0,), 2))

    def test_a_second_thread_is_refused_while_the_first_runs(self):
        run = sim.Simulation(CIRCLE, keep=False)
        first = threading.Thread(target=run.step, args=(200_000,))
        first.start()
        refused = 0
        while first.is_alive():
            for call in (run.columns, lambda: run.step(1), lambda: run.want([0, 0, 0]), lambda: run.state, run.close):
                try:
                    call()
                except ValueError as error:
                    self.assertIn("Another thread", str(error))
                    refused += 1
        first.join()
        self.assertGreater(refused, 5)
        self.assertGreaterEqual(run.state.tick, 200_000)

    def test_what_a_hand_raises_is_raised(self):
        def wrong(_):
            raise RuntimeError("mine")

        with self.assertRaisesRegex(RuntimeError, "mine"):
            sim.Simulation(CIRCLE, wrong).step(1)
        for answer in ("left", [1, 2], [np.nan, 0, 0], ([0, 0, 0], 2 * np.eye(3))):
            with self.assertRaises((TypeError, ValueError)):
                sim.Simulation(CIRCLE, lambda _, answer=answer: answer).step(1)

    def test_what_cannot_be_is_refused(self):
        for options in ({"rate_hz": 10}, {"every": 0}, {"arm_model": "nobody"}, {"hand": "nobody"}, {"hand": {"path": []}}):
            with self.assertRaises(ValueError):
                sim.Simulation(CIRCLE, **options)
        with self.assertRaises(FileNotFoundError):
            sim.Simulation(CIRCLE, "./nowhere.json")
        run = sim.Simulation(CIRCLE, "still")
        for call in (lambda: run.step(-1), lambda: run.run(-1), lambda: run.run(float("nan")), lambda: run.set({"/x": 1})):
            with self.assertRaises(ValueError):
                call()
        with self.assertRaises(TypeError):
            run.push(None, 1)


class Documentation(unittest.TestCase):
    def test_its_examples_run(self):
        found = doctest.testmod(sim)
        self.assertEqual((found.failed, found.attempted > 4), (0, True))
