"""What pictures in 3D are drawn into: axes of matplotlib, or a plotter of PyVista, which the mouse
turns. Lengths mm.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from . import shapes

if TYPE_CHECKING:
    from numpy.typing import NDArray

LINKS, TIP, SHAPE = "#1A1A1A", "#D55E00", "#0072B2"  # as in the figures of sessions


class Canvas(Protocol):
    """Lines, (m, 3), dots, (m, 3), and surfaces of triangles, (m, 3) and (k, 3).

    into: the axes or the plotter.
    """

    into: Any

    def line(self, points: NDArray[np.float64], color: str, width: float, **style: Any) -> None: ...
    def dots(self, points: NDArray[np.float64], color: str, size: float) -> None: ...
    def surface(self, at: NDArray[np.float64], faces: NDArray[np.int32], color: str) -> None: ...
    def finish(self) -> None: ...


def canvas(into: Any = None) -> Canvas:
    """The canvas of `into`: 3D axes of matplotlib, a plotter of PyVista, "pyvista" for a new
    plotter, or None for a new figure of matplotlib.

    Raises TypeError for anything else, ImportError where the library is missing.
    """
    if isinstance(into, str) and into == "pyvista":
        import pyvista

        return _PyVista(pyvista.Plotter())
    if into is None:
        return _Matplotlib(_new_axes())
    if hasattr(into, "plot_trisurf"):
        return _Matplotlib(into)
    if hasattr(into, "add_mesh") and hasattr(into, "add_lines"):
        return _PyVista(into)
    raise TypeError(
        'Pictures are drawn into 3D axes of matplotlib, a pyvista.Plotter, or "pyvista" for a new '
        f"one, not into {type(into).__name__}."
    )


def draw_shape(to: Canvas, constraint: dict[str, Any], reach_mm: NDArray[np.float64]) -> None:
    """The outlines of a constraint of a scene, as far as the corners of reach_mm, (8, 3)."""
    for outline in shapes.outlines(constraint, reach_mm):
        to.line(outline, SHAPE, 0.8)


def _new_axes() -> Any:
    import matplotlib.pyplot as pyplot

    axes = pyplot.figure(figsize=(5.0, 5.0)).add_subplot(projection="3d")
    axes.set(xlabel="x (mm)", ylabel="y (mm)", zlabel="z (mm)")
    return axes


class _Matplotlib:
    def __init__(self, into: Any):
        self.into = into

    def line(self, points: NDArray[np.float64], color: str, width: float, **style: Any) -> None:
        self.into.plot(*points.T, **{"color": color, "linewidth": width, **style})

    def dots(self, points: NDArray[np.float64], color: str, size: float) -> None:
        self.into.plot(*points.T, marker="o", markersize=size, color=color, linestyle="none")

    def surface(self, at: NDArray[np.float64], faces: NDArray[np.int32], color: str) -> None:
        self.into.plot_trisurf(*at.T, triangles=faces, color=color, alpha=0.3, linewidth=0)

    def finish(self) -> None:
        """Makes a millimetre as long along each axis as along the others."""
        box = self.into.xy_dataLim, self.into.zz_dataLim  # of all that was drawn, before and now
        limits = np.array([box[0].intervalx, box[0].intervaly, box[1].intervalx])
        half = max(np.ptp(limits, axis=1).max() / 2, 1.0)
        setters = (self.into.set_xlim, self.into.set_ylim, self.into.set_zlim)
        for middle, set_limits in zip(limits.mean(axis=1), setters):
            set_limits(middle - half, middle + half)
        self.into.set_box_aspect((1, 1, 1), zoom=0.85)  # room for the labels


class _PyVista:
    """A plotter shows itself: plotter.show()."""

    def __init__(self, into: Any):
        self.into = into

    def line(self, points: NDArray[np.float64], color: str, width: float, **style: Any) -> None:
        import pyvista

        look = {"color": color, "line_width": 2 * width, "render_lines_as_tubes": True, **style}
        self.into.add_mesh(pyvista.lines_from_points(points), **look)

    def dots(self, points: NDArray[np.float64], color: str, size: float) -> None:
        self.into.add_points(
            points, color=color, point_size=3 * size, render_points_as_spheres=True
        )

    def surface(self, at: NDArray[np.float64], faces: NDArray[np.int32], color: str) -> None:
        import pyvista

        counted = np.insert(faces, 0, 3, axis=1)  # each face after the number of its corners
        self.into.add_mesh(pyvista.PolyData(at, counted.ravel()), color=color, opacity=0.3)

    def finish(self) -> None:
        titles = {"xtitle": "x (mm)", "ytitle": "y (mm)", "ztitle": "z (mm)"}
        self.into.show_grid(**titles, font_size=10, fmt="%.0f")
