"""Plots in space: force against displacement, and the path of the stylus over the shapes."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from mpl_toolkits.mplot3d.art3d import Line3DCollection

from .. import layout, style
from ..shapes import outlines
from ..thin import evenly
from .view import View

_POINTS = 6000  # of a cloud or a way in space: more are not told apart in print
_MAX_SHAPES = 200  # more of them hide each other, and take minutes
# Drawn axes: z of W towards the reader, x right, y up, which keeps a right hand a right hand.
_DRAWN = [2, 0, 1]


def displacement_force(view: View, width_in: float) -> Figure:
    """Force sent against displacement from the target, for x, y and z of W; hollow where
    it was limited.
    """
    figure = style.new_figure(width_in, 0.42 * width_in + 0.7 if width_in > 5 else 2.0 * width_in)
    narrow = width_in < 5
    panels = figure.subplots(
        3 if narrow else 1, 1 if narrow else 3, sharex=True, sharey=True
    ).tolist()
    away = view["p_WT_mm"] - view["p_WP_mm"]
    rows = evenly(len(away), _POINTS)
    cut = (view["limits"][rows] != 0) | (view["gate_level"][rows] < 1)
    for index, (axes, (name, color, _)) in enumerate(zip(panels, style.AXES)):
        x, y = away[rows, index], view["force_sent_N"][rows, index]
        axes.plot(x[~cut], y[~cut], ".", color=color, markersize=2, label="unlimited")
        if cut.any():
            axes.plot(
                x[cut],
                y[cut],
                "o",
                mfc="none",
                mec=style.LIMITED,
                mew=0.3,
                markersize=2.5,
                label="limited",
            )
        axes.set_xlabel(f"displacement in {name} [{layout.unit('p_WT_mm')}]")
        if axes is panels[0] or narrow:
            axes.set_ylabel(f"force sent [{layout.unit('force_sent_N')}]")
    style.legend_outside(panels[-1] if not narrow else panels[0], markerscale=3)
    style.footer(figure, view.footer)
    return figure


def draw_path(axes: Axes, view: View, figure: Figure, bar: bool = True) -> None:
    """The shapes of the scene in blue, over them the path of the tip, coloured and thickened by the
    force.
    """
    p_mm = view["p_WT_mm"]
    reach = [p_mm[:, _DRAWN]]
    for constraint in view.scene.get("constraints", [])[:_MAX_SHAPES]:
        lines = [line[:, _DRAWN] for line in outlines(constraint, p_mm)]
        if lines:
            width = 0.5 if len(lines) > 3 else 1.2
            axes.add_collection3d(
                Line3DCollection(lines, colors=style.CONSTRAINT, linewidths=width, alpha=0.7)
            )
            reach.extend(lines)
    path = p_mm[evenly(len(p_mm), _POINTS)][:, _DRAWN]
    force = np.linalg.norm(view["force_sent_N"], axis=1)[evenly(len(p_mm), _POINTS)]
    segments = (
        np.stack([path[:-1], path[1:]], axis=1) if len(path) > 1 else np.stack([path, path], axis=1)
    )
    size = force[: len(segments)]
    collection = Line3DCollection(
        segments, cmap="cividis_r", linewidths=0.8 + 1.4 * size / max(float(size.max()), 1e-9)
    )
    collection.set_array(size)
    axes.add_collection3d(collection)
    axes.plot(*path[0], "o", color=style.STYLUS, markersize=3)
    axes.text(*path[0], " start", fontsize=6, color=style.STYLUS)
    if bar:
        label = f"force sent [{layout.unit('force_sent_N')}]"
        figure.colorbar(collection, ax=axes, shrink=0.6, pad=0.09, label=label)
    frame_axes(axes, np.concatenate(reach))


def frame_axes(axes: Axes, reach: np.ndarray) -> None:
    """Equal lengths in all directions, orthographic, named axes, seen from above and the right.

    reach: (n, 3), what must be seen, mm, in the order of the drawn axes.
    """
    middle = (reach.min(axis=0) + reach.max(axis=0)) / 2
    half = np.maximum(np.ptp(reach, axis=0) / 2, 0.15 * np.ptp(reach, axis=0).max()) + 1.0
    for where, center, size in zip("xyz", middle, half):
        getattr(axes, f"set_{where}lim")(center - size, center + size)
    axes.set_box_aspect(half, zoom=0.86)
    axes.set_proj_type("ortho")
    axes.view_init(elev=22, azim=28)
    for letter, where in zip("zxy", ("x", "y", "z")):
        getattr(axes, f"set_{where}label")(f"{letter} [mm]", labelpad=-2)
    axes.tick_params(pad=-2, labelsize=6)


def path(view: View, width_in: float) -> Figure:
    """The way of the tip in space over the shapes of the scene, coloured by the size of the
    force.
    """
    figure = style.new_figure(width_in, 0.75 * width_in)
    draw_path(figure.add_subplot(projection="3d"), view, figure)
    style.footer(figure, view.footer + " · orthographic")
    return figure
