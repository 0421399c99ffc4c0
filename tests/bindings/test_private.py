"""No use of the compiled classes ends the interpreter: made without __init__, copied, pickled, subclassed, built by hand."""

import copy
import copyreg
import os
import pickle
import subprocess
import sys
import unittest

PRELOADED = {key: os.environ[key] for key in ["LD_PRELOAD"] if key in os.environ}  # ASan, for the interpreter asked below

import beside  # noqa: E402
from underact import _core  # noqa: E402

TEXT = '{"underact_scene": 1, "title": "A point", "constraints": [{"type": "point", "position_mm": [0, 0, 0], "name": "p"}]}'
SCENE = _core.read_scene_text(TEXT, "point.json")
WORDS = ("still", "", 1000, 1, _core.DEFAULT_ARM_MODEL, "", "", False)
MADE = (_core.Arm("omni-thesis"), SCENE, _core.Simulation(SCENE, *WORDS))
CLASSES = [type(one) for one in MADE]
ARGUMENTS = [(), (None,), (1,), ("omni-thesis",), ([0.0] * 6,), (None, None), (0, [0.0] * 3), (b"",) * 5]
COPIES = [copy.copy, copy.deepcopy, *(lambda it, n=n: pickle.dumps(it, n) for n in range(6))]


def tried(what, *words):
    """What it gives; None, where it is an error of Python."""
    try:
        return what(*words)
    except Exception:  # any one is well: what is tried here may be nonsense
        return None


def hollow(cls):
    """Ways to an object that no __init__ has filled."""
    child = type("Child", (cls,), {"__init__": lambda self: None})
    other = _core.Scene if cls is _core.Arm else _core.Arm
    both = tried(type, "Both", (cls, other), {}) or child  # of two compiled classes
    for base in (*cls.__mro__, child):
        for wanted in (cls, child, both):
            yield lambda base=base, wanted=wanted: base.__new__(wanted)
            yield lambda base=base, wanted=wanted: copyreg._reconstructor(wanted, base, None)
    yield from (cls, child, both, lambda: copyreg.__newobj__(cls), lambda: type(cls)("Bare", (), {})())
    name = f"{cls.__module__}\n{cls.__name__}"
    for base in ("__builtin__\nobject", name):  # as pickle.dumps(..., 0) writes it, and by NEWOBJ
        yield lambda base=base: pickle.loads(f"ccopy_reg\n_reconstructor\n(c{name}\nc{base}\nNtR.".encode())
    yield lambda: pickle.loads(b"\x80\x02c" + name.encode() + b"\n)\x81.")


def use(one):
    """Calls each method with all arguments, reads and sets each property, copies and pickles."""
    for name in dir(type(one)):
        member = tried(getattr, one, name)
        for words in ARGUMENTS if callable(member) and name not in ("__class__", "__init_subclass__") else []:
            tried(member, *words)
        tried(setattr, one, name, 1)
    for copied in COPIES:
        tried(copied, one)
    for protocol in range(6):
        tried(one.__reduce_ex__, protocol)
        tried(copyreg._reduce_ex, one, protocol)
    for name in ("__setstate__", "__getstate__", "__init__"):
        tried(lambda name=name: getattr(one, name)({}))


def attack():
    """All of it, in an interpreter that may end."""
    for cls in {base for one in CLASSES for base in one.__mro__[:-1]}:
        for way in hollow(cls):
            if (one := tried(way)) is not None:
                use(one)
    for one in MADE:
        for other in CLASSES:  # neither class has the content of the other
            tried(setattr, one, "__class__", other)
            tried(setattr, one, "__class__", type("Child", (other,), {}))
        use(one)


class Private(unittest.TestCase):
    def test_nothing_that_is_tried_with_a_class_of_the_module_ends_the_interpreter(self):
        self.assertEqual({one for one in vars(_core).values() if isinstance(one, type)}, set(CLASSES))
        words = [sys.executable, "-B", "-X", "faulthandler", __file__]
        done = subprocess.run(words, capture_output=True, text=True, check=False, env={**os.environ, **PRELOADED})
        self.assertEqual((done.returncode, done.stdout), (0, "all tried\n"), done.stderr)

    def test_an_object_without_content_says_so_in_every_call(self):
        for cls in CLASSES:
            for name in (name for name, member in vars(cls).items() if isinstance(member, property)):
                with self.subTest(f"{cls}.{name}"), self.assertRaisesRegex(TypeError, "__init__ was not called"):
                    getattr(cls.__new__(cls), name)
        with self.assertRaisesRegex(TypeError, "__init__ was not called"):
            _core.Simulation(_core.Scene.__new__(_core.Scene), *WORDS)

    def test_copies_and_pickles_are_refused_by_their_name(self):
        for one in MADE:
            for way in COPIES:
                with self.assertRaisesRegex(TypeError, "cannot be copied or pickled"):
                    way(one)

    def test_the_base_of_all_classes_is_not_made(self):
        base = _core.Arm.__base__
        for way in (base, lambda: base.__new__(base), type("Child", (base,), {})):
            with self.assertRaisesRegex(TypeError, "cannot be made"):
                way()


if __name__ == "__main__":
    attack()
    print("all tried")
