"""Arms, scenes and sessions in 3D, in a notebook or a file. Lengths mm.

axes: 3D axes of matplotlib; a plotter of PyVista, or "pyvista" for a new one; None: a new figure of
matplotlib. Each function gives what it drew into, for the next one. line: color, linewidth, and
what else `plot` of matplotlib or `add_mesh` of PyVista takes.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import shapes
from .canvas import Canvas, canvas

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from .arm import Arm, Joint
    from .scene import Scene
    from .session import Session

_LINKS, _TIP, _SHAPE = "#1A1A1A", "#D55E00", "#0072B2"  # as in the figures of sessions


def plot_arm(arm: Arm, q: ArrayLike, axes: Any = None, **line: Any) -> Any:
    """The arm at q, (n,), or at each of (m, n): its links as a line, its joints and its tip as
    dots.
    """
    to = canvas(axes)
    points = arm.skeleton(np.atleast_2d(np.asanyarray(q, dtype=float)))
    color, width = line.pop("color", _LINKS), line.pop("linewidth", 2.0)
    for at in points:
        to.line(at, color, width, **line)
        to.dots(at[:-1], color, 3.0)
        to.dots(at[-1:], _TIP, 5.0)
    to.finish()
    return to.into


def plot_scene(scene: Scene, axes: Any = None, extent_mm: float = 80.0) -> Any:
    """The shapes of a scene as lines, and its meshes; what has no ends as far as extent_mm from the
    origin.
    """
    to = canvas(axes)
    corners = extent_mm * np.array(
        [[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=float
    )
    for index, constraint in enumerate(scene.as_dict()["constraints"]):
        _draw_shape(to, constraint, corners)
        if constraint["type"] == "mesh":
            to.surface(*scene.mesh(index), _SHAPE)
    to.finish()
    return to.into


def _draw_shape(to: Canvas, constraint: dict[str, Any], reach_mm: NDArray[np.float64]) -> None:
    for outline in shapes.outlines(constraint, reach_mm):
        to.line(outline, _SHAPE, 0.8)


def plot_path(p_mm: ArrayLike, axes: Any = None, **line: Any) -> Any:
    """A path, (m, 3), as of the tip in a session."""
    to = canvas(axes)
    color, width = line.pop("color", _TIP), line.pop("linewidth", 1.0)
    to.line(np.asarray(p_mm, dtype=float), color, width, **line)
    to.finish()
    return to.into


def plot_session(session: Session, axes: Any = None) -> Any:
    """Where the tip went in a session, and the shapes of the scene with which it began, as far as
    the tip went; meshes are files of their own and are left out.
    """
    to = canvas(axes)
    path_mm = session.ticks["p_WT_mm"]
    for constraint in session.scene["constraints"]:
        _draw_shape(to, constraint, path_mm)
    return plot_path(path_mm, to.into)


def sliders(arm: Arm, q: ArrayLike | None = None, scene: Scene | None = None) -> Any:
    """The arm with a slider for each joint in a notebook, and its scene; one picture, at q, where
    ipywidgets is not installed.

    q: (n,), where the sliders begin; None: 0, or the limit nearest to it. Gives the widget, or the
    axes.
    """
    low, high = np.array([_range(joint) for joint in arm.joints]).T
    start = np.clip(np.zeros(arm.n) if q is None else np.asanyarray(q, dtype=float), low, high)

    def draw(values: ArrayLike) -> Any:
        axes = plot_arm(arm, values)
        return plot_scene(scene, axes) if scene is not None else axes

    try:
        import ipywidgets
    except ImportError:
        return draw(start)
    names = [joint.name or f"q{number}" for number, joint in enumerate(arm.joints, start=1)]
    all_ = {
        name: ipywidgets.FloatSlider(float(at), min=least, max=most, step=(most - least) / 200)
        for name, at, least, most in zip(names, start, low, high)
    }
    return ipywidgets.interactive(lambda **values: draw([values[name] for name in names]), **all_)


def _range(joint: Joint) -> tuple[float, float]:
    """From where to where a slider goes: a turn, or a metre, where the joint has no limit."""
    far = np.pi if joint.turns else 1000.0
    return (
        joint.min if np.isfinite(joint.min) else -far,
        joint.max if np.isfinite(joint.max) else far,
    )
