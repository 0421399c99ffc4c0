"""Scenes: read, checked, built in code, changed by path, and evaluated over arrays of poses.

>>> from underact import scene
>>> rim = scene.circle(center_mm=(10, 20, 30), normal=(-1, 1, -1), radius_mm=40, name="rim")
>>> held = scene.build("A rim", [rim], control={"law": "P", "kp_N_per_mm": 0.5})
>>> found = held.target([[0, 0, 0], [20, 40, 10]])
>>> found.force_N.shape, found.status.tolist()
((2, 3), ['unique', 'unique'])

A scene never changes: with_values() gives another one. Lengths mm, forces N, angles rad. What
cannot be read raises SceneError, with all problems; check() gives them as objects. Everything
equals the answers of `underact-cli`, to the last bit.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import given
from .canvas import SHAPE, canvas, draw_shape
from .compiled import core as _compiled
from .shapes import *  # point(), sphere() and so on
from .shapes import constraint as _constraint
from .shapes import plain as _plain
from .shapes import sphere

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from . import _core
else:
    _core = _compiled()

_STATUS = np.array(["unique", "degenerate", "free"])

#: Whatever setting a value can have: see `settings()`.
Value = float | bool | str | tuple[float, float, float] | None


@dataclass(frozen=True)
class Problem:
    """What is wrong with a scene, in a sentence, and where: line and column from 1, 0 where there
    is none.
    """

    sentence: str
    file: str
    line: int
    column: int
    key: str

    def __str__(self) -> str:
        return (
            f"{self.file}:{self.line}:{self.column}: {self.key}: {self.sentence}"
            if self.file
            else self.sentence
        )


class SceneError(ValueError):
    """A scene that cannot be. problems: all of them; `str()` has one a line."""

    def __init__(self, problems: list[Problem]):
        super().__init__("\n".join(str(problem) for problem in problems))
        self.problems = problems


@dataclass(frozen=True)
class Setting:
    """A setting that scenes have. path: with a star for each constraint or joint. words: of a
    choice.
    """

    path: str
    label: str
    tip: str
    unit: str
    least: float
    most: float
    words: list[str] | None


@dataclass(frozen=True, eq=False)  # of arrays
class Targets:
    """Where a scene pulls a stylus at rest, and how hard; c constraints.

    force_N: (..., 3), of all constraints; safe_force_N: the same within the arm's limit. status:
    (...), "unique", "degenerate" or "free". Of each constraint: target_mm (..., c, 3), NaN unless
    its status is "unique"; each_force_N (..., c, 3); distance_mm (..., c); each_status (..., c);
    acts (..., c).
    """

    force_N: NDArray[np.float64]
    safe_force_N: NDArray[np.float64]
    status: NDArray[np.str_]
    target_mm: NDArray[np.float64]
    each_force_N: NDArray[np.float64]
    distance_mm: NDArray[np.float64]
    each_status: NDArray[np.str_]
    acts: NDArray[np.bool_]


@dataclass(frozen=True, eq=False)  # of arrays
class Energy:
    """The energy of a virtual manipulator held by a stylus.

    energy_J: (...). slope: (..., n), its gradient: N mm/rad, N where the joint slides. force_N,
    moment_N_mm: (..., 3), on the hand.
    """

    energy_J: NDArray[np.float64]
    slope: NDArray[np.float64]
    force_N: NDArray[np.float64]
    moment_N_mm: NDArray[np.float64]


@dataclass(frozen=True, eq=False)  # of arrays
class Posture:
    """Joint values of least energy. theta: (..., n), rad or mm. n_W: (..., 3), z of the end
    effector. moment_N_mm: (..., 3).
    """

    theta: NDArray[np.float64]
    n_W: NDArray[np.float64]
    moment_N_mm: NDArray[np.float64]


def _text_of(value: Value) -> str:
    """A value as a scene file has it."""
    if value is None:
        return "none"
    if isinstance(value, str):
        return given.text(value, "value")
    return _json(value, "value")


def _json(value: Any, name: str) -> str:
    """A value as JSON; TypeError where JSON has none for it."""
    try:
        return json.dumps(_plain(value))
    except TypeError as error:
        reason = str(error).rstrip(".")
        raise TypeError(f"{name} must be numbers, texts, lists and dicts: {reason}.") from None
    except (ValueError, RecursionError) as error:
        raise ValueError(f"{name} must be a tree of lists and dicts: {error}.") from None


class Scene:
    """A scene, checked. Made by read(), read_text() and build()."""

    def __init__(self, compiled: _core.Scene):
        self._core = compiled

    def __repr__(self) -> str:
        return f"<underact.scene.Scene {self.title!r}: {', '.join(self.constraints) or 'nothing'}>"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Scene) and self.text == other.text

    def __hash__(self) -> int:
        return hash(self.text)

    def __reduce__(self) -> tuple[Any, ...]:
        return (_again, (self.text, self._core.file))

    @property
    def title(self) -> str:
        """The title."""
        return self._core.title

    @property
    def about(self) -> str:
        """What it shows, in some sentences."""
        return self._core.about

    @property
    def arm(self) -> str:
        """Its arm: a name, or a file."""
        return self._core.arm

    @property
    def max_force_N(self) -> float:
        """The largest force that the arm is sent."""
        return self._core.max_force_N

    @property
    def constraints(self) -> dict[str, str]:
        """The type of each constraint, by its name, in order."""
        return dict(self._core._constraints())

    @property
    def text(self) -> str:
        """The scene as a file; read back, it is the same to the last bit."""
        return self._core.text

    @property
    def notes(self) -> list[Problem]:
        """What is worth knowing about its meshes."""
        return [Problem(*one) for one in self._core._notes()]

    def as_dict(self) -> dict[str, Any]:
        """The scene as a file has it, as a dict."""
        return json.loads(self.text)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes it to a scene file, which `underact-cli` and the window open."""
        Path(path).write_text(self.text, encoding="utf-8")

    def __getitem__(self, path: str) -> Value:
        """The value of a setting: scene["/constraints/0/influence/t"].

        >>> build("A point", [point(position_mm=(0, 0, 0))])["/control/kp_N_per_mm"]
        (0.5, 0.5, 0.5)
        """
        try:
            return self._core._value(given.text(path, "path"))
        except ValueError as error:
            raise KeyError(str(error)) from None

    def with_values(self, values: Mapping[str, Value]) -> Scene:
        """The scene with other values by path, all at once. A star stands for each constraint; None
        leaves a key out.

        >>> hard = build("A point", [point(position_mm=(0, 0, 0))])
        >>> softer = hard.with_values({"/control/kp_N_per_mm": 0.1})
        >>> softer["/control/kp_N_per_mm"]
        (0.1, 0.1, 0.1)
        """
        words = [(given.text(path, "path"), _text_of(value)) for path, value in values.items()]
        return _scene(self._core._with(words))

    def target(self, p_mm: ArrayLike, R_WT: ArrayLike | None = None) -> Targets:
        """Where the scene pulls a stylus that rests with its tip at p_mm, (..., 3), as
        `underact-cli target` does.

        R_WT: (..., 3, 3), or one rotation for all; None: unrotated. Raises ValueError where a scene
        in joint space has a position out of the arm's reach.
        """
        force, safe, status, q, each, distance, statuses, acts = self._core._targets(p_mm, R_WT)
        return Targets(force, safe, _STATUS[status], q, each, distance, _STATUS[statuses], acts)

    def nearest(self, p_mm: ArrayLike) -> NDArray[np.float64]:
        """The point of each constraint nearest to p_mm, (..., 3): (..., c, 3), NaN where there is
        not exactly one.
        """
        return self.target(p_mm).target_mm

    def _index(self, constraint: int | str) -> int:
        if isinstance(constraint, str):
            names = list(self.constraints)
            if constraint not in names:
                raise KeyError(
                    f"The scene has no constraint {constraint!r}; it has {', '.join(names)}."
                )
            return names.index(constraint)
        return given.whole(constraint, "constraint", 0, 2**62)  # IndexError beyond

    def energy(self, constraint: int | str, theta: ArrayLike, X_WT: ArrayLike) -> Energy:
        """The energy of a virtual manipulator and its gradient, at joint values theta, (..., n),
        rad or mm.

        constraint: its name or index. X_WT: (4, 4), mm, the stylus, or one pose for each theta.
        """
        return Energy(*self._core._energy(self._index(constraint), X_WT, theta))

    def least_energy(
        self, constraint: int | str, p_mm: ArrayLike, R_WT: ArrayLike | None = None
    ) -> Posture:
        """The joint values of least energy of a virtual manipulator, for a stylus at p_mm, (...,
        3).
        """
        return Posture(*self._core._least_energy(self._index(constraint), p_mm, R_WT))

    def mesh(self, constraint: int | str) -> tuple[NDArray[np.float64], NDArray[np.int32]]:
        """Corners, (m, 3), mm in W, and faces, (k, 3), of a mesh as it is felt."""
        return self._core._mesh(self._index(constraint))

    def plot(self, axes: Any = None, extent_mm: float = 80.0) -> Any:
        """Draws its shapes as lines, and its meshes, and gives what it drew into.

        axes: 3D axes of matplotlib, a plotter of PyVista or "pyvista"; None: a new figure of
        matplotlib. extent_mm: how far what has no ends is drawn.
        """
        to = canvas(axes)
        corners = extent_mm * np.array(
            [[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=float
        )
        for index, constraint in enumerate(self.as_dict()["constraints"]):
            draw_shape(to, constraint, corners)
            if constraint["type"] == "mesh":
                to.surface(*self.mesh(index), SHAPE)
        to.finish()
        return to.into


def _again(text: str, file: str) -> Scene:
    return read_text(text, file)


def _scene(made: Any) -> Scene:
    if isinstance(made, list):
        raise SceneError([Problem(*one) for one in made])
    return Scene(made)


def read(path: str | os.PathLike[str]) -> Scene:
    """The scene of a file, with its meshes. Raises SceneError with all problems, OSError where it
    cannot be read.
    """
    name = given.path(path, "path")
    Path(name).open("rb").close()  # Python's own errors for a file that cannot be read
    return _scene(_core.read_scene_file(name))


def read_text(text: str, file: str = "") -> Scene:
    """The scene of a text in JSON. file: what meshes are relative to, and what problems name."""
    words = given.text(text, "text"), given.text(os.fspath(file), "file")
    return _scene(_core.read_scene_text(*words))


def check(source: str | os.PathLike[str] | Mapping[str, Any]) -> list[Problem]:
    """All problems of a scene file, or of a scene as a dict; none: it is a scene.

    >>> empty = {"underact_scene": 1, "title": "Nothing", "constraints": []}
    >>> [problem.key for problem in check(empty)]
    ['constraints']
    """
    try:
        read_text(_json(source, "source")) if isinstance(source, Mapping) else read(source)
    except SceneError as error:
        return error.problems
    return []


def build(
    title: str, constraints: Iterable[Mapping[str, Any]], file: str = "", **keys: Any
) -> Scene:
    """A scene made in code. constraints: of point(), circle() and so on, or dicts as in a file.

    keys: others of a scene file: about, arm, control, combine, simulation. file: what meshes are
    relative to.
    """
    scene = {"underact_scene": 1, "title": title, **keys, "constraints": list(constraints)}
    return read_text(_json(scene, "constraints"), file)


def settings() -> list[Setting]:
    """All settings that a scene can have.

    >>> any(one.path == "/control/kp_N_per_mm" for one in settings())
    True
    """
    return [Setting(*one) for one in _core.settings()]


def nearest(shape: Mapping[str, Any], p_mm: ArrayLike) -> NDArray[np.float64]:
    """The point of a shape nearest to p_mm, (..., 3); NaN where several are equally near.

    >>> nearest(sphere(center_mm=(0, 0, 0), radius_mm=10), (0, 0, 40)).tolist()
    [0.0, 0.0, 10.0]
    """
    return build("A shape", [shape]).nearest(p_mm)[..., 0, :]


def mesh(file: str, **others: Any) -> dict[str, Any]:
    """A mesh of a file: STL, PLY, OBJ or OFF, relative to the scene's."""
    return _constraint("mesh", others, file=file)


def virtual_manipulator(
    joints: Iterable[Mapping[str, Any]], X_WV_home: ArrayLike, **others: Any
) -> dict[str, Any]:
    """A virtual robot of revolute() and prismatic() joints. X_WV_home: (4, 4), mm, its end effector
    with all joints at 0.
    """
    required = {"joints": list(joints), "X_WV_home": np.asanyarray(X_WV_home)}
    return _plain({"type": "virtual_manipulator", **required, **others})


def revolute(axis: ArrayLike, point_mm: ArrayLike, **others: Any) -> dict[str, Any]:
    """A joint that turns about an axis. others: min, max (rad), stiffness_N_mm_per_rad, rest."""
    return _constraint("revolute", others, axis=axis, point_mm=point_mm)


def prismatic(axis: ArrayLike, **others: Any) -> dict[str, Any]:
    """A joint that slides along an axis. others: min, max (mm), stiffness_N_per_mm, rest."""
    return _constraint("prismatic", others, axis=axis)
