"""Figures 4.2 to 4.14: the stylus held to a point, sphere, line, plane, circle and cylinder."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from .. import style
from ..plots.forces import draw_path
from ..plots.over_time import line
from ..plots.view import View
from ..shapes import across
from .held import CLAMP_N, KP_N_PER_MM, common_numbers, held_rms_mm, unlimited
from .number import Number, worst

WIDTH_IN = 7.0


def _two_over_time(view: View, upper: tuple, lower: tuple) -> Figure:
    """Two panels over one time axis; each (values, y label, colour)."""
    figure = style.new_figure(WIDTH_IN, 4.4)
    panels = figure.subplots(2, 1, sharex=True)
    for axes, (values, name, color) in zip(panels, (upper, lower)):
        line(axes, view.time_s, values, color=color)
        axes.set_ylabel(name)
    panels[-1].set_xlabel("time [s]")
    panels[-1].set_xlim(view.time_s[0], view.time_s[-1])
    figure.align_ylabels(list(panels))
    style.footer(figure, view.footer)
    return figure


def _size(view: View) -> np.ndarray:
    return np.linalg.norm(view["force_sent_N"], axis=1)


def point_sizes(view: View) -> Figure:
    """4.2: distance from the point and magnitude of the force over time."""
    figure = _two_over_time(
        view,
        (view["error_mm"], "distance [mm]", style.STYLUS),
        (_size(view), "force [N]", style.FORCE),
    )
    figure.axes[1].axhline(CLAMP_N, color=style.LIMITED, linestyle="--", label="clamp, 0.88 N")
    style.legend_outside(figure.axes[1])
    return figure


def point_size_numbers(view: View) -> list[Number]:
    """4.2: the magnitude of the force is K_p times the distance, up to the clamp."""
    rows = view["gate_level"] == 1
    due = np.minimum(KP_N_PER_MM * view["error_mm"], CLAMP_N)
    off = (_size(view) - due)[rows & np.isin(view["limits"], (0, 1))]
    return [
        *common_numbers(view),
        worst(off, "force magnitude: maximum deviation from min(K_p |e|, clamp)", 1e-9, "N"),
        Number("maximum force", float(_size(view).max()), CLAMP_N, 1e-9, "N"),
    ]


def point_x(view: View) -> Figure:
    """4.3: displacement and force in x, over time and against each other."""
    x, force = view["p_WT_mm"][:, 0], view["force_sent_N"][:, 0]
    figure = style.new_figure(WIDTH_IN, 3.6)
    grid = figure.add_gridspec(2, 2, width_ratios=(1.5, 1))
    upper = figure.add_subplot(grid[0, 0])
    lower = figure.add_subplot(grid[1, 0], sharex=upper)
    against = figure.add_subplot(grid[:, 1])
    line(upper, view.time_s, x, color=style.STYLUS)
    line(lower, view.time_s, force, color=style.FORCE)
    upper.set_ylabel("displacement in x [mm]")
    lower.set_ylabel("force in x [N]")
    lower.set_xlabel("time [s]")
    lower.set_xlim(view.time_s[0], view.time_s[-1])
    rows = unlimited(view)
    against.plot(
        x[~rows],
        force[~rows],
        "o",
        mfc="none",
        mec=style.LIMITED,
        mew=0.3,
        markersize=2.5,
        label="limited",
    )
    against.plot(x[rows], force[rows], ".", color=style.STYLUS, markersize=2, label="unlimited")
    against.set_xlabel("displacement in x [mm]")
    against.set_ylabel("force in x [N]")
    against.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=2, markerscale=2)
    figure.align_ylabels([upper, lower])
    style.footer(figure, view.footer)
    return figure


def point_x_numbers(view: View) -> list[Number]:
    """4.3: for a positive displacement the force is negative, and the other way about."""
    x, force = view["p_WT_mm"][:, 0], view["force_sent_N"][:, 0]
    moved = (np.abs(x) > 0.05) & (view["gate_level"] > 0)
    rows = unlimited(view)
    slope = float(np.polyfit(x[rows], force[rows], 1)[0])
    return [
        Number(
            "ticks with displaced x whose force in x points back",
            float(np.mean(force[moved] * x[moved] < 0)),
            1,
            0,
        ),
        Number("slope of force in x against x, without limits", slope, -KP_N_PER_MM, 1e-6, "N/mm"),
        Number(
            "excursion of x, the smaller of both sides",
            min(float(x.max()), -float(x.min())),
            6,
            5,
            "mm",
        ),
    ]


def sphere_path(view: View) -> Figure:
    """4.5: the path of the stylus over the sphere."""
    return _path(view)


def sphere_path_numbers(view: View) -> list[Number]:
    """4.5: the target stays on the sphere, the stylus near it while it slides."""
    radius = np.linalg.norm(view["p_WP_mm"], axis=1)
    rows = (view.time_s > 1.5) & (view.time_s < 7.5)
    off = np.sqrt(np.mean((np.linalg.norm(view["p_WT_mm"], axis=1)[rows] - 50) ** 2))
    return [
        *common_numbers(view),
        worst(radius - 50, "target: maximum distance from the sphere of 50 mm", 1e-9, "mm"),
        Number(
            "stylus: distance from the sphere while it slides (rms)",
            float(off),
            0,
            CLAMP_N / KP_N_PER_MM,
            "mm",
        ),
    ]


def sphere_sizes(view: View) -> Figure:
    """4.6: distance from the centre and magnitude of the force over time."""
    distance = np.linalg.norm(view["p_WT_mm"], axis=1)
    upper, lower = (distance, "distance from the centre [mm]", style.STYLUS), (
        _size(view),
        "force [N]",
        style.FORCE,
    )
    figure = _two_over_time(view, upper, lower)
    figure.axes[0].axhline(50, color=style.CONSTRAINT, linestyle="--", label="radius, 50 mm")
    style.legend_outside(figure.axes[0])
    return figure


def sphere_size_numbers(view: View) -> list[Number]:
    """4.6: the force grows with the distance from the surface to either side, up to the clamp."""
    distance = np.linalg.norm(view["p_WT_mm"], axis=1)
    rows = (view["gate_level"] == 1) & np.isin(view["limits"], (0, 1))
    off = (_size(view) - np.minimum(KP_N_PER_MM * np.abs(distance - 50), CLAMP_N))[rows]
    clamped = float(_size(view)[rows & (distance < 45)].min(initial=np.inf))
    return [
        worst(
            off, "force magnitude: maximum deviation from min(K_p |r - 50 mm|, clamp)", 1e-9, "N"
        ),
        Number("minimum force deep inside the sphere", clamped, CLAMP_N, 1e-6, "N"),
    ]


def _path(view: View, extra=None) -> Figure:
    figure = style.new_figure(WIDTH_IN, 5.0)
    axes = figure.add_subplot(projection="3d")
    draw_path(axes, view, figure)
    if extra is not None:
        extra(axes)
    style.footer(figure, view.footer + " · orthographic")
    return figure


def line_path(view: View) -> Figure:
    """4.8: where the stylus was, with the line's point and direction."""
    constraint = view.scene["constraints"][0]
    point = np.asarray(constraint["point_mm"], dtype=float)[[2, 0, 1]]
    direction = 15 * across(constraint["direction"])[2][[2, 0, 1]]

    def mark(axes) -> None:
        axes.quiver(
            *point, *direction, color=style.CONSTRAINT, linewidth=2, arrow_length_ratio=0.25
        )
        axes.plot(*point[:, None], "s", color=style.CONSTRAINT, markersize=4)
        axes.text(*(point + [0, 3, 0]), "$P_0$", color=style.CONSTRAINT)
        axes.text(*(point + direction + [0, 2, 0]), "$\\vec V$", color=style.CONSTRAINT)

    return _path(view, mark)


def line_numbers(view: View) -> list[Number]:
    """4.8: the targets run along V through P0, and the stylus is drawn to the line and stays
    by it.
    """
    constraint = view.scene["constraints"][0]
    V = across(constraint["direction"])[2]
    along = (view["p_WP_mm"] - np.asarray(constraint["point_mm"])) @ V
    run = np.linalg.svd(view["p_WP_mm"] - view["p_WP_mm"].mean(axis=0), full_matrices=False)[2][0]
    turn_deg = float(np.degrees(np.arcsin(min(1.0, float(np.linalg.norm(np.cross(run, V)))))))
    pull = view["force_sent_N"] @ V
    return [
        *common_numbers(view),
        Number("angle between the line of the targets and V", turn_deg, 0, 1e-6, "deg"),
        worst(pull, "maximum force along the line", 1e-9, "N"),
        Number("travel along the line", float(np.ptp(along)), 60, 30, "mm"),
        Number(
            "stylus: distance from the line once on it (rms)", held_rms_mm(view, 2.5), 0, 2.0, "mm"
        ),
    ]


def plane_path(view: View) -> Figure:
    """4.10: where the stylus was, and the plane."""
    return _path(view)


def plane_numbers(view: View) -> list[Number]:
    """4.10: the force stands on the plane, and the stylus stays in it while it roams."""
    n = across(view.scene["constraints"][0]["normal"])[2]
    sent = view["force_sent_N"]
    in_plane = view["p_WT_mm"] - np.outer(view["p_WT_mm"] @ n, n)
    return [
        *common_numbers(view),
        worst((sent - np.outer(sent @ n, n)).ravel(), "maximum force in the plane", 1e-9, "N"),
        Number(
            "stylus: distance from the plane once on it (rms)", held_rms_mm(view, 2.0), 0, 2.0, "mm"
        ),
        Number(
            "travel in the plane (diagonal of its extent)",
            float(np.linalg.norm(np.ptp(in_plane, axis=0))),
            90,
            45,
            "mm",
        ),
    ]


def circle_path(view: View) -> Figure:
    """4.12: where the stylus was, and the circle."""
    return _path(view)


def circle_numbers(view: View) -> list[Number]:
    """4.12: the targets lie on the circle and go all the way round."""
    constraint = view.scene["constraints"][0]
    u, v, a = across(constraint["normal"])
    off = view["p_WP_mm"] - np.asarray(constraint["center_mm"])
    turned = np.unwrap(np.arctan2(off @ v, off @ u))
    tangent = np.cross(a, off / constraint["radius_mm"])
    return [
        *common_numbers(view),
        worst(
            np.linalg.norm(off, axis=1) - 40,
            "target: maximum deviation from the radius of 40 mm",
            1e-9,
            "mm",
        ),
        worst(off @ a, "target: maximum distance from the circle's plane", 1e-9, "mm"),
        worst(
            np.sum(view["force_sent_N"] * tangent, axis=1),
            "maximum force along the circle",
            1e-9,
            "N",
        ),
        Number(
            "angle travelled around the circle", float(np.degrees(np.ptp(turned))), 390, 30, "deg"
        ),
        Number("stylus: distance from the circle (rms)", held_rms_mm(view, 1.0), 0, 2.0, "mm"),
    ]


def cylinder_path(view: View) -> Figure:
    """4.14: where the stylus was, and the cylinder."""
    return _path(view)


def cylinder_numbers(view: View) -> list[Number]:
    """4.14: the targets lie on the cylinder; along its axis nothing holds."""
    constraint = view.scene["constraints"][0]
    u, v, a = across(constraint["axis"])
    off = view["p_WP_mm"] - np.asarray(constraint["point_mm"])
    radial = off - np.outer(off @ a, a)
    turned = np.unwrap(np.arctan2(off @ v, off @ u))
    return [
        *common_numbers(view),
        worst(
            np.linalg.norm(radial, axis=1) - 30,
            "target: maximum deviation from the radius of 30 mm",
            1e-9,
            "mm",
        ),
        worst(view["force_sent_N"] @ a, "maximum force along the axis", 1e-9, "N"),
        Number("travel along the axis", float(np.ptp(off @ a)), 45, 10, "mm"),
        Number(
            "angle travelled around the axis", float(np.degrees(np.ptp(turned))), 720, 40, "deg"
        ),
        Number("stylus: distance from the cylinder (rms)", held_rms_mm(view, 1.0), 0, 2.0, "mm"),
    ]
