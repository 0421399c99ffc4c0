"""Arms: forward and inverse kinematics, Jacobians, statics, by the program's own code.

>>> from underact import arm
>>> omni = arm.load("omni-thesis")
>>> omni.fk([0, 0.5, -0.3, 0, 0.7, 0]).shape
(4, 4)

Lengths are mm, forces N. Joint values q are DH angles in rad, in the maker's convention (mm where a
joint slides), of shape (..., n) for an arm of n joints. Whatever numpy makes float64 of can be
passed: lists, views, read-only arrays. Numbers that are not finite, or of the wrong shape, raise
ValueError; what is no number raises TypeError. Arrays are computed without Python's lock.
Everything equals the answers of `underact-cli`, to the last bit.
"""

from __future__ import annotations

import functools
import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from . import given
from .canvas import LINKS, TIP, canvas
from .compiled import core as _compiled

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from . import _core
else:
    _core = _compiled()

__all__ = ["Arm", "Dexterity", "Joint", "Solutions", "Statics", "load", "names"]

_NONE = np.zeros(3)  # no force, no moment
_NONE.flags.writeable = False


@functools.cache
def _facts(solutions: int) -> np.dtype[np.void]:
    """What stands in a pose's record, as app/bindings/inverse.cpp writes it."""
    fields = [
        ("count", np.int32, ()),
        ("reachable", np.bool_, ()),
        ("singular", np.bool_, ()),
        ("within", np.bool_, (solutions,)),
        ("branch", np.int8, (solutions, 3)),
        ("family", np.uint8, (solutions,)),
    ]
    return np.dtype(fields, align=True)


@dataclass(frozen=True)
class Joint:
    """A joint: its limits in rad, or mm where it slides (turns is False); infinite where it has
    none.
    """

    name: str
    turns: bool
    min: float
    max: float
    driven: bool
    sensed: bool


@dataclass(frozen=True, eq=False)  # of arrays
class Dexterity:
    """How well the tip moves.

    det: (...), mm^3, of the block of joints 1 to 3; NaN of an arm that has not six joints that
    turn. manipulability: (...), Yoshikawa's measure. condition: (...), largest over smallest gain;
    NaN where singular. singular: for one pose a tuple of names ("shoulder", "elbow", "wrist",
    "position"); for several an array of them.
    """

    det: NDArray[np.float64]
    manipulability: NDArray[np.float64]
    condition: NDArray[np.float64]
    singular: Any


@dataclass(frozen=True, eq=False)  # of arrays
class Statics:
    """What the joints do for a wrench at the tip.

    torque_N_mm: (..., n), N where the joint slides. holding_N_mm: the same that hold the arm's own
    weight; None where its file has no masses. gains_mm: (..., 3), semi-axes of the ellipsoid of the
    tip's velocities by the driven joints, largest first; axes_W: (..., 3, 3), their directions, a
    row each. Forces have the same axes, and 1 / gain.
    """

    torque_N_mm: NDArray[np.float64]
    holding_N_mm: NDArray[np.float64] | None
    gains_mm: NDArray[np.float64]
    axes_W: NDArray[np.float64]


class Solutions:
    """All joint values that reach a pose, or each of many.

    q: (..., k, n), NaN beyond the count of a pose; k is the largest count. count: (...). reachable,
    singular: (...). within_limits: (..., k). branch: name ("shoulder", "elbow", "wrist", or "arm")
    to (..., k), +1 or -1, or 1, 2, ...; empty for an arm without a closed form. family: (..., k),
    "" for an isolated solution, else what stays the same along the self-motion: "q1 free", "q4+q6",
    "q6-q4" and so on.
    """

    q: NDArray[np.float64]

    def __init__(self, found: tuple[Any, ...]):
        q, self._bytes, self._most, self._branches, self._families = found
        self.q = q if self._most == q.shape[-2] else q[..., : self._most, :]
        self._k = q.shape[-2]

    # Views, made when they are asked for: one pose is solved in the time that making all takes.
    def _fact(self, name: str) -> NDArray[Any]:
        facts: NDArray[Any] = self._bytes.view(_facts(self._k))[..., 0][name]
        return facts

    @property
    def count(self) -> NDArray[np.int32]:
        """How many solutions there are."""
        return self._fact("count")

    @property
    def reachable(self) -> NDArray[np.bool_]:
        """Whether the arm is long enough."""
        return self._fact("reachable")

    @property
    def singular(self) -> NDArray[np.bool_]:
        """Whether it is a singular pose."""
        return self._fact("singular")

    @property
    def within_limits(self) -> NDArray[np.bool_]:
        """Whether all joints are within their limits."""
        return self._fact("within")[..., : self._most]

    @property
    def branch(self) -> dict[str, NDArray[np.int8]]:
        """The branch of each solution, by name."""
        branch = self._fact("branch")
        return {name: branch[..., : self._most, i] for i, name in enumerate(self._branches)}

    @property
    def family(self) -> NDArray[np.str_]:
        """What stays the same along a self-motion; "" for an isolated solution."""
        family = self._fact("family")[..., : self._most]
        named: NDArray[np.str_] = np.array(self._families)[family]
        return named

    def __repr__(self) -> str:
        return f"<underact.arm.Solutions of {self.count.size} poses, {self._most} or fewer of each>"

    def __len__(self) -> int:
        """The number of solutions of one pose."""
        if self.count.ndim:
            raise TypeError("len() is for the solutions of one pose; use count.")
        return int(self.count)


class Arm(_core.Arm):
    """An arm, by name or file; made by load()."""

    def __init__(self, name: str | os.PathLike[str], base: str = "", tip: str = ""):
        words = (given.path(name, "name"), given.text(base, "base"), given.text(tip, "tip"))
        super().__init__(*words)
        self._made_from = words

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), self._made_from)

    def __repr__(self) -> str:
        return f"<underact.arm.Arm {self.name}: {self.title}, {self.n} joints>"

    @property
    def joints(self) -> list[Joint]:
        """Names and limits of the joints.

        >>> load("omni-thesis").joints[0].turns
        True
        """
        return [Joint(*facts) for facts in self._joints()]

    @property
    def limits(self) -> NDArray[np.float64]:
        """(n, 2): least and largest value of each joint, rad or mm."""
        return np.array([[joint.min, joint.max] for joint in self.joints])

    def dexterity(self, q: ArrayLike) -> Dexterity:
        """Determinant, manipulability, condition and singularities. q: (..., n).

        >>> load("omni-thesis").dexterity([0, 0.5, -0.3, 0, 0, 0]).singular
        ('wrist',)
        """
        det, manipulability, condition, names = self._dexterity(q)
        if det.ndim == 0:
            return Dexterity(det, manipulability, condition, names[0])
        singular = np.empty(det.size, dtype=object)
        singular[:] = names
        return Dexterity(det, manipulability, condition, singular.reshape(det.shape))

    def statics(
        self,
        q: ArrayLike,
        f_N: ArrayLike = _NONE,
        moment_N_mm: ArrayLike = _NONE,
    ) -> Statics:
        """Joint torques for a wrench of the arm on its surroundings at the tip, in W, and the
        ellipsoid of the tip.

        q: (..., n). f_N, moment_N_mm: (3,), or one for each q.
        """
        return Statics(*self._statics(q, f_N, moment_N_mm))

    def ik(
        self,
        X: ArrayLike,
        method: str = "auto",
        seed: int = 1,
        search: int = 0,
        prefer: ArrayLike | None = None,
    ) -> Solutions:
        """All joint values for the pose X of the stylus or tool.

        X: (..., 4, 4), rotations to 1e-3, lengths mm. method: "auto", "closed_form" or "iterative";
        an arm without a closed form is solved by iteration within its limits, which gives one
        solution, or with search those that so many starts find. seed: of the starts. prefer: (n,),
        a posture: the solutions nearest to it come first, each joint by the full turn nearest to
        it, and an iteration starts from it.

        >>> omni = load("omni-thesis")
        >>> found = omni.ik(omni.fk([0.1, 0.5, -0.3, 0.2, 0.7, 0.4]))
        >>> len(found), sorted(found.branch)
        (8, ['elbow', 'shoulder', 'wrist'])
        """
        if method not in ("auto", "closed_form", "iterative"):
            raise ValueError('method must be "auto", "closed_form" or "iterative".')
        if seed != 1 or search != 0 or not type(seed) is type(search) is int:
            seed = given.whole(seed, "seed", 0, 2**64 - 1)
            search = given.whole(search, "search", 0, 100_000)
        return Solutions(self._ik(X, method, seed, search, prefer))

    def convert(self, form: str) -> str:
        """The text of an arm file: "dh" (a table in modified convention), "poe" (a product of
        exponentials), "urdf".
        """
        return self._text(given.text(form, "form"))

    def plot(self, q: ArrayLike, axes: Any = None, **line: Any) -> Any:
        """Draws the arm at q, (n,) or (m, n), its links as a line, its joints and its tip as dots,
        and gives what it drew into.

        axes: 3D axes of matplotlib, a plotter of PyVista or "pyvista"; None: a new figure of
        matplotlib. line: how the links look: color, linewidth and so on.
        """
        to = canvas(axes)
        points = self.skeleton(np.atleast_2d(np.asanyarray(q, dtype=float)))
        color, width = line.pop("color", LINKS), line.pop("linewidth", 2.0)
        for at in points:
            to.line(at, color, width, **line)
            to.dots(at[:-1], color, 3.0)
            to.dots(at[-1:], TIP, 5.0)
        to.finish()
        return to.into


def names() -> list[str]:
    """The names of the arms that ship with the program.

    >>> "omni-thesis" in names()
    True
    """
    return _core.arm_names()


def load(name: str | os.PathLike[str], base: str = "", tip: str = "") -> Arm:
    """The arm of a name in names(), or of a file (a name with a dot or a slash): an arm file, or
    URDF.

    base, tip: of URDF, the links between which the arm lies; else its root, and the only link
    without children. Raises ValueError with all problems of the file, OSError where it cannot be
    read.
    """
    return Arm(name, base, tip)
