"""Arms, scenes and paths in 3D, in a notebook or a file: into axes of matplotlib. Lengths mm."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import shapes

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from .arm import Arm, Joint
    from .scene import Scene

_LINKS, _TIP, _SHAPE = "#1A1A1A", "#D55E00", "#0072B2"  # as in the figures of sessions


def new_axes() -> Any:
    """3D axes of a new figure of pyplot."""
    import matplotlib.pyplot as pyplot

    axes = pyplot.figure(figsize=(5.0, 5.0)).add_subplot(projection="3d")
    axes.set(xlabel="x (mm)", ylabel="y (mm)", zlabel="z (mm)")
    return axes


def same_scale(axes: Any) -> None:
    """Makes a millimetre as long along each axis as along the others."""
    box = axes.xy_dataLim, axes.zz_dataLim  # of all that was drawn, before and now
    limits = np.array([box[0].intervalx, box[0].intervaly, box[1].intervalx])
    half = max(np.ptp(limits, axis=1).max() / 2, 1.0)
    for middle, set_limits in zip(
        limits.mean(axis=1), (axes.set_xlim, axes.set_ylim, axes.set_zlim)
    ):
        set_limits(middle - half, middle + half)
    axes.set_box_aspect((1, 1, 1), zoom=0.85)  # room for the labels


def plot_arm(arm: Arm, q: ArrayLike, axes: Any = None, **line: Any) -> Any:
    """The arm at q, (n,), or at each of (m, n): its links as a line, its joints and its tip as
    points.
    """
    axes = new_axes() if axes is None else axes
    style = {"color": _LINKS, "linewidth": 2.0, **line}
    points = arm.skeleton(np.atleast_2d(np.asarray(q, dtype=float)))
    for at in points:
        axes.plot(*at.T, marker="o", markersize=3, **style)
        axes.plot(*at[-1:].T, marker="o", markersize=5, color=_TIP, linestyle="none")
    same_scale(axes)
    return axes


def plot_scene(scene: Scene, axes: Any = None, extent_mm: float = 80.0) -> Any:
    """The shapes of a scene as lines, and its meshes; what has no ends as far as extent_mm from the
    origin.
    """
    axes = new_axes() if axes is None else axes
    corners = extent_mm * np.array(
        [[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=float
    )
    for index, constraint in enumerate(scene.as_dict()["constraints"]):
        for outline in shapes.outlines(constraint, corners):
            axes.plot(*outline.T, color=_SHAPE, linewidth=0.8)
        if constraint["type"] == "mesh":
            at, faces = scene.mesh(index)
            axes.plot_trisurf(*at.T, triangles=faces, color=_SHAPE, alpha=0.3, linewidth=0)
    same_scale(axes)
    return axes


def plot_path(p_mm: ArrayLike, axes: Any = None, **line: Any) -> Any:
    """A path, (m, 3), as of the tip in a session."""
    axes = new_axes() if axes is None else axes
    axes.plot(*np.asarray(p_mm, dtype=float).T, **{"color": _TIP, "linewidth": 1.0, **line})
    same_scale(axes)
    return axes


def sliders(arm: Arm, q: ArrayLike | None = None, scene: Scene | None = None) -> Any:
    """The arm with a slider for each joint in a notebook, and its scene; one picture, at q, where
    ipywidgets is not installed.

    q: (n,), where the sliders begin; None: 0, or the limit nearest to it. Gives the widget, or the
    axes.
    """
    low, high = np.array([_range(joint) for joint in arm.joints]).T
    start = np.clip(np.zeros(arm.n) if q is None else np.asarray(q, dtype=float), low, high)

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
