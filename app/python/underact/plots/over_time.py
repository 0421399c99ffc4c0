"""Plots over time: error, force, angles of influence, joints, energy."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from .. import layout, style
from ..thin import evenly, thin
from .view import View

_MAX_EVENTS = 200  # marks, and faults, that are drawn: more are one black bar, and take hours
_TURN = np.pi  # a step of more than half a turn between two ticks is a wrap, not a motion


def line(axes: Axes, time_s: np.ndarray, values: np.ndarray, **more) -> None:
    """A line thinned to the pixels of the figure."""
    columns = int(axes.figure.get_figwidth() * style.DPI)
    axes.plot(*thin(time_s, values, columns), **more)


def _start(view: View, width_in: float, rows: int = 1) -> tuple[Figure, list[Axes]]:
    figure = style.new_figure(width_in, (0.45 if rows == 1 else 0.62) * width_in + 0.5 * rows)
    panels = figure.subplots(rows, 1, sharex=True, squeeze=False)[:, 0].tolist()
    style.footer(figure, view.footer)
    return figure, panels


def _finish(view: View, figure: Figure, panels: list[Axes]) -> Figure:
    """The time axis, and what happened when: faults as red crosses on a line, markers as lines with
    their labels.
    """
    faults, marks = _some(view.faults), _some(view.marks)
    drawn, all_ = len(faults) + len(marks), len(view.faults) + len(view.marks)
    left_out = f", {drawn:,} of {all_:,} markers and faults" if drawn < all_ else ""
    panels[-1].set_xlabel(f"time [s]{left_out}")
    if view.time_s[-1] > view.time_s[0]:
        panels[-1].set_xlim(view.time_s[0], view.time_s[-1])
    for axes in panels:
        for time_s, _ in faults:
            axes.axvline(
                time_s,
                color=style.VERMILLION,
                linewidth=0.8,
                marker="x",
                markevery=[1],
                clip_on=False,
            )
        for time_s, _ in marks:
            axes.axvline(time_s, color=style.GREY, linewidth=0.6, linestyle=(0, (1, 2)))
    for time_s, words in faults + marks:
        panels[0].annotate(
            words[:24],
            (time_s, 1),
            xycoords=("data", "axes fraction"),
            rotation=90,
            fontsize=6,
            color=style.GREY,
            ha="right",
            va="top",
            textcoords="offset points",
            xytext=(-1, -2),
            parse_math=False,
        )
    for axes in panels:
        style.legend_outside(axes)
    figure.align_ylabels(panels)
    return figure


def _some(events: list[tuple[float, str]]) -> list[tuple[float, str]]:
    return [events[index] for index in evenly(len(events), _MAX_EVENTS)]


def error_time(view: View, width_in: float) -> Figure:
    """The distance between stylus and target over time, mm."""
    figure, (axes,) = _start(view, width_in)
    line(axes, view.time_s, view["error_mm"], color=style.STYLUS, label="error")
    axes.set_ylabel(f"distance to target [{layout.unit('error_mm')}]")
    axes.set_ylim(bottom=0)
    return _finish(view, figure, [axes])


def force_time(view: View, width_in: float) -> Figure:
    """The force that was sent over time, N: its size and, below, its components; a bar where a
    limit cuts it.
    """
    figure, (sizes, parts) = _start(view, width_in, rows=2)
    sent = np.linalg.norm(view["force_sent_N"], axis=1)
    line(sizes, view.time_s, sent, color=style.FORCE, label="magnitude, as sent", linewidth=1.3)
    cut = view["limits"] != 0
    if cut.any():
        height = np.where(cut, 1.04 * max(float(np.nanmax(sent)), 1e-6), np.nan)
        line(sizes, view.time_s, height, color=style.LIMITED, linewidth=2.5, label="limited")
    if (view["passive_N"] > 0).any():
        line(
            sizes,
            view.time_s,
            view["passive_N"],
            color=style.PURPLE,
            linestyle=":",
            label="passive",
        )
    sizes.set_ylim(bottom=0)
    sizes.set_ylabel(f"force [{layout.unit('force_sent_N')}]")
    for index, (name, color, dashes) in enumerate(style.AXES):
        force = view["force_sent_N"][:, index]
        line(parts, view.time_s, force, color=color, linestyle=dashes, label=f"$f_{name}$")
    parts.set_ylabel(f"components [{layout.unit('force_sent_N')}]")
    return _finish(view, figure, [sizes, parts])


def unbroken(angle_rad: np.ndarray) -> np.ndarray:
    """Angles in degrees with a gap at each jump from one end of the turn to the other."""
    degrees = np.degrees(angle_rad)
    jumps = np.flatnonzero(np.abs(np.diff(angle_rad)) > _TURN)
    degrees[jumps + 1] = np.nan
    return degrees


def angles(view: View, width_in: float) -> Figure:
    """Angles of stylus, tip and target about the shape's axis over time, degrees (thesis figure
    5.7).
    """
    figure, (axes,) = _start(view, width_in)
    alpha, beta, theta = (unbroken(column) for column in view["alpha_beta_theta_rad"].T)
    line(axes, view.time_s, alpha, color=style.SKY, linestyle="--", label="stylus, α")
    line(axes, view.time_s, beta, color=style.PURPLE, label="tip, β")
    line(axes, view.time_s, theta, color=style.TARGET, linewidth=1.8, label="target, θ")
    axes.set_ylabel("angle about the axis [deg]")
    if np.isnan(theta).all():
        _say(axes, "This scene has no influence: there are no angles.")
    return _finish(view, figure, [axes])


def joints(view: View, width_in: float) -> Figure:
    """The six joint angles over time, degrees (DH angles)."""
    figure, (axes,) = _start(view, width_in)
    for joint, (color, dashes) in enumerate(style.JOINTS):
        degrees = np.degrees(view["q_rad"][:, joint])
        line(axes, view.time_s, degrees, color=color, linestyle=dashes, label=f"$q_{joint + 1}$")
    axes.set_ylabel("joint angle [deg]")
    return _finish(view, figure, [axes])


def energy(view: View, width_in: float) -> Figure:
    """What the stylus has put into all constraints and not got back over time, mJ; below zero:
    active.
    """
    figure, (axes,) = _start(view, width_in)
    stored = view["energy_mJ"]
    line(axes, view.time_s, stored, color=style.STYLUS, label="energy")
    if np.nanmin(stored) < 0:
        time_s, values = thin(view.time_s, stored, int(width_in * style.DPI))
        axes.fill_between(
            time_s,
            np.minimum(values, 0),
            0,
            color=style.LIMITED,
            alpha=0.35,
            hatch="////",
            linewidth=0,
            label="active",
        )
    axes.axhline(0, color=style.DARK, linewidth=0.6)
    axes.set_ylabel(f"energy put in [{layout.unit('energy_mJ')}]")
    return _finish(view, figure, [axes])


def _say(axes: Axes, words: str) -> None:
    axes.text(0.5, 0.5, words, transform=axes.transAxes, ha="center", va="center", color=style.GREY)
