"""Paths, sessions and arms with sliders in 3D, in a notebook or a file. Lengths mm.

axes: 3D axes of matplotlib; a plotter of PyVista, or "pyvista" for a new one; None: a new figure of
matplotlib. Each function gives what it drew into, for the next one. line: color, linewidth, and
what else `plot` of matplotlib or `add_mesh` of PyVista takes.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .canvas import TIP, canvas, draw_shape

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from .arm import Arm, Joint
    from .scene import Scene
    from .session import Session


def plot_path(p_mm: ArrayLike, axes: Any = None, **line: Any) -> Any:
    """A path, (m, 3), as of the tip in a session."""
    to = canvas(axes)
    color, width = line.pop("color", TIP), line.pop("linewidth", 1.0)
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
        draw_shape(to, constraint, path_mm)
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
        axes = arm.plot(values)
        return scene.plot(axes) if scene is not None else axes

    try:
        import ipywidgets
    except ImportError:
        return draw(start)
    names = [joint.name or f"q{number}" for number, joint in enumerate(arm.joints, start=1)]
    all_ = {
        name: ipywidgets.FloatSlider(float(at), min=a, max=b, step=(b - a) / 200)
        for name, at, a, b in zip(names, start, low, high)
    }
    return ipywidgets.interactive(lambda **values: draw([values[name] for name in names]), **all_)


def _range(joint: Joint) -> tuple[float, float]:
    """From where to where a slider goes: a turn, or a metre, where the joint has no limit."""
    far = np.pi if joint.turns else 1000.0
    return (
        joint.min if np.isfinite(joint.min) else -far,
        joint.max if np.isfinite(joint.max) else far,
    )
