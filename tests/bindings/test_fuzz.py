"""Anything at all is answered or refused with a sentence: numbers, arrays, texts and files that hypothesis makes up."""

from __future__ import annotations

import json
import tempfile
import unittest
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from beside import ROOT, SOAK
from underact import arm, scene, sim

try:
    from hypothesis import HealthCheck, assume, given, settings
    from hypothesis import strategies as some
    from hypothesis.extra import numpy as arrays
except ImportError as error:
    raise unittest.SkipTest("python3-hypothesis is not installed, so input was not fuzzed") from error

# The same inputs each time in CI; others, and more of them, in the soak.
trying = settings(
    max_examples=20_000 if SOAK else 150,
    derandomize=not SOAK,
    deadline=None,
    database=None,
    suppress_health_check=list(HealthCheck),
)

OMNI = arm.load("omni-thesis")
ROBOT = scene.build(
    "A robot",
    [
        scene.virtual_manipulator(
            [scene.revolute((0, 0, 1), (0, 0, 0), stiffness_N_mm_per_rad=40), scene.prismatic((1, 0, 0), min=-30, max=30)],
            np.diag([1.0, 1.0, 1.0, 1.0]),
            name="robot",
        ),
        scene.sphere((0, 0, 0), 30, name="ball"),
    ],
)

shapes = some.one_of(
    some.sampled_from([(6,), (3,), (4, 4), (2, 6), (2, 3), (3, 3), (2, 4, 4), (0, 6), (0, 3), (0, 4, 4), (2,), (5,), ()]),
    arrays.array_shapes(min_dims=0, max_dims=4, min_side=0, max_side=7),
)
types = some.one_of(
    some.sampled_from(["f8", "f4", ">f8", "i4"]),
    arrays.scalar_dtypes(),
    some.sampled_from(["longdouble", "O", "V8"]),
)
numbers = some.one_of(
    some.sampled_from([0.0, -0.0, 1.0, -1.0, 1e-310, 1e6, 1e7, 1e300, np.nan, np.inf, -np.inf]),
    some.floats(-3, 3),
)


@some.composite
def held(draw: Callable[[Any], Any]) -> Any:
    """An array in one of the ways in which numpy holds one: read-only, strided, reversed, transposed, unaligned."""
    shape, type_ = draw(shapes), draw(types)
    if str(type_) in ("float64", "f8", ">f8", "f4", "float32"):
        array = draw(arrays.arrays(np.float64, shape, elements=numbers))
        with np.errstate(all="ignore"):
            array = array.astype(type_)
    else:
        array = np.zeros(shape, type_)
    way = draw(some.sampled_from(["", "read-only", "strided", "reversed", "transposed", "unaligned", "list", "subclass"]))
    if way == "read-only":
        array.flags.writeable = False
    elif way == "strided" and array.ndim:
        array = np.repeat(array, 2, axis=-1)[..., ::2]
    elif way == "reversed" and array.ndim:
        array = array[::-1]
    elif way == "transposed":
        array = array.T
    elif way == "unaligned" and array.size and array.dtype.kind == "f":
        bytes_ = np.frombuffer(b"x" + array.tobytes(), np.uint8)[1:]
        array = bytes_.view(array.dtype).reshape(array.shape)
    elif way == "list":
        return array.tolist()
    elif way == "subclass" and array.ndim:
        return array.view(np.ma.MaskedArray)
    return array


anything = some.one_of(
    held(),
    held(),
    held(),
    some.none(),
    some.text(max_size=5),
    some.binary(max_size=5),
    some.floats(),
    some.integers(),
    some.booleans(),
    some.complex_numbers(),
    some.recursive(some.one_of(some.floats(), some.none(), some.text(max_size=2)), some.lists, max_leaves=8),
    some.builds(object),
    some.dictionaries(some.text(max_size=2), some.floats(), max_size=2),
    some.sets(some.integers(), max_size=3),
    some.builds(lambda: np.zeros(6)[:0]),
)
small = some.one_of(some.none(), some.text(max_size=6), some.integers(-(2**70), 2**70), some.floats(), some.booleans())

#: What a refusal may be of: KeyError and IndexError of a name or number that a scene has not.
REFUSED = (TypeError, ValueError, KeyError, IndexError)


class Sentences(unittest.TestCase):
    def answered(self, call: Callable[..., object], *given_: object, **named: object) -> object:
        """What it gives; None where it refuses, in a sentence."""
        try:
            return call(*given_, **named)
        except REFUSED as error:
            self.sentence(error)
            return None

    def sentence(self, error: Exception) -> None:
        text = str(error.args[0] if isinstance(error, KeyError) else error)
        self.assertRegex(text, r"(?s)^\S.{10,}[.!?)]\"?$", repr(error))
        for word in ("incompatible function arguments", "incompatible constructor", "Traceback", "pybind11"):
            self.assertNotIn(word, text)


class Numbers(Sentences):
    @trying
    @given(anything, some.sampled_from(["fk", "jacobian", "ik", "statics", "dexterity", "skeleton", "within_limits", "null_space"]))
    def test_joints_and_poses(self, value: object, name: str) -> None:
        self.answered(getattr(OMNI, name), value)

    @trying
    @given(anything, anything, anything)
    def test_wrenches(self, q: object, f_N: object, moment_N_mm: object) -> None:
        self.answered(OMNI.statics, np.zeros(6), f_N, moment_N_mm)
        self.answered(OMNI.statics, q, f_N, moment_N_mm)

    @trying
    @given(some.one_of(some.sampled_from(["auto", "closed_form", "iterative"]), small), small, small, anything)
    def test_options_of_the_inverse(self, method: object, seed: object, search: object, prefer: object) -> None:
        X = OMNI.fk(np.zeros(6))
        assume(not (isinstance(search, (int, float)) and search > 50))  # takes long
        self.answered(OMNI.ik, X, method=method)
        self.answered(OMNI.ik, X, seed=seed)
        self.answered(OMNI.ik, X, method="iterative", search=search)
        self.answered(OMNI.ik, X, prefer=prefer)
        self.answered(OMNI.convert, method)

    @trying
    @given(anything, anything, small)
    def test_scenes(self, p_mm: object, R_WT: object, which: object) -> None:
        self.answered(ROBOT.target, p_mm, R_WT)
        self.answered(ROBOT.target, [1, 2, 3], R_WT)
        self.answered(ROBOT.nearest, p_mm)
        self.answered(ROBOT.energy, which, [0.0, 0.0], np.eye(4))
        self.answered(ROBOT.energy, "robot", p_mm, R_WT)
        self.answered(ROBOT.least_energy, "robot", p_mm, R_WT)
        self.answered(ROBOT.least_energy, which, [0, 0, 0])
        self.answered(ROBOT.mesh, which)

    @trying
    @given(anything, anything, small)
    def test_simulations(self, p_mm: object, R_WT: object, number: object) -> None:
        assume(not (isinstance(number, (int, float)) and number > 50))
        with sim.Simulation(ROBOT, keep=False) as run:
            self.answered(run.want, p_mm, R_WT)
            self.answered(run.push, p_mm, 0.01)
            self.answered(run.push, [0, 0, 0], number)
            self.answered(run.step, number)
            self.answered(run.mark, number)
            self.answered(run.set, {"/control/kp_N_per_mm": number})
            run.step(20)
            self.assertTrue(np.isfinite(run.state.p_mm).all())

    @trying
    @given(small, small, some.one_of(small, some.dictionaries(some.sampled_from(["path", "underact_hand"]), anything, max_size=2)))
    def test_what_simulations_are_made_of(self, number: object, name: object, hand: object) -> None:
        for options in ({"rate_hz": number}, {"seed": number}, {"arm_model": name}, {"every": number}, {"hand": hand}):
            try:
                self.answered(sim.Simulation, ROBOT, **options)
            except OSError as error:  # a name with a dot or a slash is a file
                self.assertTrue(str(error))


class Files(Sentences):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.file = Path(holder.name) / "file.json"

    @trying
    @given(some.one_of(some.binary(max_size=40), some.text(max_size=40).map(lambda text: text.encode("utf-8", "surrogatepass"))))
    def test_bytes(self, content: bytes) -> None:
        self.file.write_bytes(content)
        self.assertIsNone(self.answered(arm.load, self.file))
        self.assertIsNone(self.answered(scene.read, self.file))
        self.assertGreater(len(scene.check(self.file)), 0)

    @trying
    @given(some.data())
    def test_a_scene_with_one_thing_changed(self, data: some.DataObject) -> None:
        whole = json.loads((ROOT / "scenes/05_circle.json").read_text(encoding="utf-8"))
        at: Any = whole
        while isinstance(at, (dict, list)) and at:
            keys = list(at) if isinstance(at, dict) else list(range(len(at)))
            key = data.draw(some.sampled_from(keys))
            if not isinstance(at[key], (dict, list)) or data.draw(some.booleans()):
                at[key] = data.draw(some.one_of(small, some.just([]), some.just({}), some.lists(small, max_size=4)))
                break
            at = at[key]
        built = self.answered(scene.read_text, json.dumps(whole), str(ROOT / "scenes/05_circle.json"))
        if isinstance(built, scene.Scene):
            self.answered(built.target, [10.0, 0.0, 0.0])
            self.assertEqual(scene.read_text(built.text, str(ROOT / "scenes/05_circle.json")).text, built.text)

    @trying
    @given(small, some.one_of(small, some.lists(some.floats(), max_size=4)))
    def test_settings(self, path: object, value: object) -> None:
        self.answered(lambda: ROBOT[path])
        self.answered(ROBOT.with_values, {path: value})
        for known in ("/control/kp_N_per_mm", "/control/law", "/constraints/1/influence/t"):
            self.answered(ROBOT.with_values, {known: value})

    @trying
    @given(some.one_of(small, some.lists(small, max_size=2)))
    def test_names(self, name: object) -> None:
        for call in (arm.load, scene.read, scene.read_text, scene.check):
            try:
                self.answered(call, name)
            except OSError as error:
                self.assertTrue(str(error))


if __name__ == "__main__":
    unittest.main()
