"""Figures 5.6 to 5.8: the influence of the stylus's turn, and the virtual manipulator."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from .. import style
from ..plots.over_time import line, unbroken
from ..plots.view import View
from .nearest import stylus_axis, wrap
from .number import Number, worst

ALPHA, BETA, SHARE = -5 * np.pi / 6, np.pi / 2, 0.4  # figure 5.6
RADIUS_MM = 50.0
K_ROTATE, KP, LENGTH_MM = 250.0, 0.5, 50.0  # figure 5.8: N mm/rad, N/mm, mm


def angle_question() -> dict:
    """Figure 5.6 as a question to `target`: tip at angle beta, a little off the rim, z of frame 6
    at alpha.
    """
    z = np.array([np.cos(ALPHA), np.sin(ALPHA), 0.0])
    x = np.array([0.0, 0.0, 1.0])
    R_WT = np.stack([x, np.cross(z, x), z], axis=1)
    p_mm = 1.1 * RADIUS_MM * np.array([np.cos(BETA), np.sin(BETA), 0.0])
    return {"p_mm": p_mm.tolist(), "R_WT": R_WT.tolist()}


def right_angle(answer: dict) -> Figure:
    """5.6: the target lies on the shorter arc from alpha to beta, not on the longer one."""
    figure = style.new_figure(3.5, 3.4)
    axes = figure.subplots()
    _rim(axes, RADIUS_MM)
    theta = float(np.arctan2(answer["q_mm"][1], answer["q_mm"][0]))
    long_way = ALPHA + SHARE * (BETA - ALPHA)
    short = ALPHA + np.linspace(0, 1, 60) * wrap(np.array(BETA - ALPHA))
    inner = 0.8 * RADIUS_MM
    axes.plot(inner * np.cos(short), inner * np.sin(short), color=style.TARGET, linewidth=1.5)
    marks = (
        (ALPHA, "α = −5π/6", style.SKY, "o"),
        (BETA, "β = π/2", style.PURPLE, "o"),
        (theta, f"θ = {theta / np.pi:.1f}π", style.TARGET, "s"),
        (long_way, "the long way: −0.3π", style.GREY, "x"),
    )
    for angle, words, color, sign in marks:
        at = RADIUS_MM * np.array([np.cos(angle), np.sin(angle)])
        axes.plot(*np.stack([0 * at, at], axis=1), color=color, linewidth=0.8, linestyle="--")
        axes.plot(*at, sign, color=color, markersize=6, label=words)
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14), ncol=2)
    _flat(axes)
    return figure


def right_angle_numbers(answer: dict) -> list[Number]:
    """5.6: eq. 5.32, not 5.31."""
    q = np.asarray(answer["q_mm"])
    return [
        Number(
            "angle of the target, eq. 5.32",
            float(np.arctan2(q[1], q[0])),
            0.9 * np.pi,
            1e-12,
            "rad",
        ),
        Number(
            "distance of the target from the centre",
            float(np.linalg.norm(q)),
            RADIUS_MM,
            1e-9,
            "mm",
        ),
        worst(
            np.asarray(answer["force_N"]) - KP * (q - angle_question()["p_mm"]),
            "force: maximum deviation from K_p e",
            1e-9,
            "N",
        ),
    ]


def angle_histories(view: View) -> Figure:
    """5.7: the angles of stylus, tip and target over time."""
    figure = style.new_figure(7.0, 3.4)
    axes = figure.subplots()
    alpha, beta, theta = (unbroken(column) for column in view["alpha_beta_theta_rad"].T)
    line(axes, view.time_s, alpha, color=style.SKY, linestyle="--", label="stylus, α")
    line(axes, view.time_s, theta, color=style.TARGET, linewidth=1.5, label="target, θ")
    axes.plot(view.time_s[::250], theta[::250], "x", color=style.TARGET, markersize=4)
    line(axes, view.time_s, beta, color=style.PURPLE, label="tip, β")
    axes.set_xlabel("time [s]")
    axes.set_ylabel("angle about the axis [deg]")
    axes.set_xlim(view.time_s[0], view.time_s[-1])
    style.legend_outside(axes)
    style.footer(figure, view.footer + " · t = 0.5")
    return figure


def angle_history_numbers(view: View) -> list[Number]:
    """5.7: theta = alpha + t wrap(beta - alpha) (eq. 5.4), with alpha and beta found from pose and
    tip (5.2, 5.3).
    """
    alpha, beta, theta = view["alpha_beta_theta_rad"].T
    share = view.scene["constraints"][0]["influence"]["t"]
    z, p = stylus_axis(view["quat_WT"]), view["p_WT_mm"]
    due = wrap(alpha + share * wrap(beta - alpha))
    target = RADIUS_MM * np.stack([np.cos(due), np.sin(due), 0 * due], axis=1)
    along = (view.time_s > 8.2) & (view.time_s < 9.0)
    return [
        worst(wrap(theta - due), "θ: maximum deviation from α + t wrap(β − α)", 1e-9, "rad"),
        worst(
            wrap(alpha - np.arctan2(z[:, 1], z[:, 0])),
            "α: maximum deviation from atan2 of z of frame 6",
            1e-9,
            "rad",
        ),
        worst(
            wrap(beta - np.arctan2(p[:, 1], p[:, 0])),
            "β: maximum deviation from atan2 of the tip",
            1e-9,
            "rad",
        ),
        worst(
            (view["p_WP_mm"] - target).ravel(),
            "target: maximum distance from the point at θ",
            1e-9,
            "mm",
        ),
        Number(
            "maximum difference of α and β",
            float(np.degrees(np.abs(wrap(beta - alpha)).max())),
            60,
            40,
            "deg",
        ),
        Number(
            "maximum difference of α and β, 8.2 s to 9 s", _apart(alpha, beta, along), 0, 5, "deg"
        ),
    ]


def _apart(alpha: np.ndarray, beta: np.ndarray, rows: np.ndarray) -> float:
    return float(np.degrees(np.abs(wrap(beta - alpha))[rows].max(initial=0)))


def code_5_2(p_mm: np.ndarray, z: np.ndarray) -> np.ndarray:
    """The force of code 5.2 with its misprints corrected, pivot at the origin: (n, 3), N."""
    turn_v, turn_r = np.arctan2(p_mm[:, 1], p_mm[:, 0]), np.arctan2(z[:, 1], z[:, 0])
    c, s = np.cos(turn_v), np.sin(turn_v)
    error_x, error_y = LENGTH_MM * c - p_mm[:, 0], LENGTH_MM * s - p_mm[:, 1]
    across = K_ROTATE * wrap(turn_v - turn_r) / LENGTH_MM
    radial = KP * (c * error_x + s * error_y)
    return np.stack([c * radial + s * across, s * radial - c * across, -KP * p_mm[:, 2]], axis=1)


def manipulator_moments(view: View) -> Figure:
    """5.8: circle, stylus, nearest point, tangent and force, at four moments of the run."""
    figure = style.new_figure(7.0, 5.8)
    panels = figure.subplots(2, 2, sharex=True, sharey=True)
    z = stylus_axis(view["quat_WT"])
    for axes, at_s in zip(panels.ravel(), (2.0, 4.0, 6.0, 8.0)):
        row = int(np.searchsorted(view.time_s, at_s))
        _moment(axes, view["p_WT_mm"][row], z[row], view["force_sent_N"][row])
        axes.set_title(
            f"{view.time_s[row]:.1f} s, force {np.linalg.norm(view['force_sent_N'][row]):.2f} N"
        )
    for axes in panels.ravel():
        axes.label_outer()
    style.legend_outside(panels[0, 1])
    style.footer(figure, view.footer + " · forces 20 mm for 1 N")
    return figure


def manipulator_numbers(view: View) -> list[Number]:
    """5.8: the commanded force is that of code 5.2 as corrected, and turns the stylus's way with
    k_theta / L.
    """
    p, asked = view["p_WT_mm"], view["force_asked_N"]
    z = stylus_axis(view["quat_WT"])
    turn = np.arctan2(p[:, 1], p[:, 0])
    tangent = np.stack([-np.sin(turn), np.cos(turn), 0 * turn], axis=1)
    turned = wrap(turn - np.arctan2(z[:, 1], z[:, 0]))
    pull = np.sum(asked * tangent, axis=1)
    sent = view["force_sent_N"]
    pushes = (np.linalg.norm(sent, axis=1) > 1e-3) & (np.linalg.norm(asked, axis=1) > 1e-3)
    cosine = np.sum(sent * asked, axis=1)[pushes] / np.linalg.norm(sent[pushes], axis=1)
    cosine /= np.linalg.norm(asked[pushes], axis=1)
    slope = float(turned @ pull / max(float(turned @ turned), 1e-300))
    return [
        worst(
            (asked - code_5_2(p, z)).ravel(),
            "commanded force: maximum deviation from code 5.2 (corrected)",
            1e-9,
            "N",
        ),
        Number(
            "slope of tangential force against orientation error",
            slope,
            -K_ROTATE / LENGTH_MM,
            1e-6,
            "N/rad",
        ),
        Number(
            "minimum cosine between force sent and commanded",
            float(cosine.min(initial=np.inf)),
            1,
            1e-9,
        ),
        Number("maximum orientation error", float(np.degrees(np.abs(turned).max())), 20, 17, "deg"),
        Number("maximum force", float(np.linalg.norm(sent, axis=1).max()), 0.88, 1e-6, "N"),
    ]


def _rim(axes: Axes, radius: float) -> None:
    turn = np.linspace(0, 2 * np.pi, 181)
    axes.plot(radius * np.cos(turn), radius * np.sin(turn), color=style.CONSTRAINT, linewidth=1.5)
    axes.plot(0, 0, "+", color=style.CONSTRAINT)


def _flat(axes: Axes) -> None:
    axes.set_aspect("equal")
    axes.set_xlabel("x [mm]")
    axes.set_ylabel("y [mm]")


def _moment(axes: Axes, p: np.ndarray, z: np.ndarray, force: np.ndarray) -> None:
    _rim(axes, LENGTH_MM)
    out = p[:2] / np.linalg.norm(p[:2])
    nearest, tangent = LENGTH_MM * out, np.array([-out[1], out[0]])
    ends = np.stack([nearest - 35 * tangent, nearest + 35 * tangent], axis=1)
    axes.plot(*ends, color=style.GREY, linestyle="--", linewidth=0.8, label="tangent")
    axes.plot(
        *np.stack([p[:2], p[:2] + 25 * z[:2]], axis=1),
        color=style.STYLUS,
        linewidth=2.5,
        label="stylus",
    )
    axes.plot(*p[:2], "o", mfc="white", mec=style.STYLUS, mew=2, markersize=6)
    axes.plot(*nearest, "s", color=style.TARGET, markersize=5, label="nearest point")
    axes.annotate(
        "",
        p[:2] + 20 * force[:2],
        p[:2],
        arrowprops={"arrowstyle": "-|>", "color": style.FORCE, "linewidth": 2},
    )
    axes.plot([], [], color=style.FORCE, linewidth=2, label="force")
    _flat(axes)
