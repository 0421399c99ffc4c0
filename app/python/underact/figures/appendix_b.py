"""Figures B.1 to B.5: step responses of systems of first, second and third order."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from .. import style
from .number import Number, worst
from .programs import Programs
from .response import Marks, marks, step

_COLORS = (style.DARK, style.ORANGE, style.SKY, style.GREEN, style.VERMILLION, style.PURPLE)
_DASHES = ("-", "--", "-.", ":", (0, (5, 1)), (0, (3, 1, 1, 1, 1, 1)))
_FIRST_ORDER = (0.5, 1.0, 2.0)  # a of eq. B.3
_DAMPING = (0.1, 0.3, 0.5, 0.7, 1.0, 2.0)  # zeta of eq. B.9
ZETA_38 = 0.29434709926523744  # the damping ratio whose overshoot is 38 %


def second_order(zeta: float, wn: float = 1.0) -> tuple[list[float], list[float]]:
    """Eq. B.9 with C = 1, as numerator and denominator."""
    return [wn * wn], [1.0, 2 * zeta * wn, wn * wn]


def _axes(height_in: float = 3.2) -> tuple[Figure, Axes]:
    figure = style.new_figure(7.0, height_in)
    axes = figure.subplots()
    axes.set_xlabel("time [s]")
    axes.set_ylabel("response to a unit step")
    return figure, axes


def _curves(axes: Axes, systems: list[tuple[str, list[float], list[float]]], end_s: float) -> None:
    for (words, numerator, denominator), color, dashes in zip(systems, _COLORS, _DASHES):
        axes.plot(
            *step(numerator, denominator, end_s, 1001), color=color, linestyle=dashes, label=words
        )
    axes.set_xlim(0, end_s)
    style.legend_outside(axes)


def program_marks(
    programs: Programs | None, numerator: list[float], denominator: list[float], end_s: float
) -> Marks:
    """The marks of a step as `underact-cli lab step` gives them; where there is no such command,
    our own.
    """
    step = programs.lab_step(numerator, denominator) if programs is not None else None
    if step is None:
        return marks(numerator, denominator, end_s)
    return Marks(
        *(math.nan if step[key] is None else float(step[key]) for key in Marks.__dataclass_fields__)
    )


def source(programs: Programs | None) -> str:
    """Where the measured numbers of these figures come from, for their captions."""
    if programs is not None and programs.lab_step([1.0], [1.0, 1.0]) is not None:
        return "Numbers measured by underact-cli lab step."
    return "This underact-cli has no lab: numbers measured on the curve as it is drawn."


def first_order(_: Programs | None) -> Figure:
    """B.1: a / (s + a)."""
    figure, axes = _axes()
    _curves(axes, [(f"a = {a:g}", [a], [1.0, a]) for a in _FIRST_ORDER], 8.0)
    return figure


def first_order_numbers(programs: Programs | None) -> list[Number]:
    """B.1: each ends at 1, whatever a is, and does not overshoot."""
    numbers = []
    for a in _FIRST_ORDER:
        found = program_marks(programs, [a], [1.0, a], 20 / a)
        time_s, response = step([a], [1.0, a], 8.0, 1001)
        numbers += [
            Number(f"a = {a:g}: final value", found.final_value, 1.0, 1e-9),
            Number(f"a = {a:g}: overshoot", found.overshoot_fraction, 0.0, 1e-9),
            worst(
                response - (1 - np.exp(-a * time_s)),
                f"a = {a:g}: maximum deviation from 1 - exp(-a t)",
                1e-9,
            ),
        ]
    return numbers


def second_orders(_: Programs | None) -> Figure:
    """B.2: eq. B.9 for damping ratios from 0.1 to 2."""
    figure, axes = _axes(3.6)
    _curves(axes, [(f"ζ = {zeta:g}", *second_order(zeta)) for zeta in _DAMPING], 20.0)
    return figure


def second_order_numbers(programs: Programs | None) -> list[Number]:
    """B.2: overshoot exp(-pi zeta / sqrt(1 - zeta^2)) at pi / w_d; none from zeta = 1 on."""
    numbers = []
    for zeta in _DAMPING:
        found = program_marks(programs, *second_order(zeta), 60.0 / min(zeta, 1.0 / zeta))
        if zeta < 1:
            damped = math.sqrt(1 - zeta * zeta)
            overshoot = math.exp(-math.pi * zeta / damped)
            numbers.append(
                Number(f"ζ = {zeta:g}: peak time", found.peak_time_s, math.pi / damped, 1e-3, "s")
            )
        else:
            overshoot = 0.0
        numbers.append(
            Number(f"ζ = {zeta:g}: overshoot", found.overshoot_fraction, overshoot, 1e-5)
        )
    return numbers


_THIRD = ([5.0], [1.0, 33.0, 92.0, 60.0])  # eq. B.10: (s + 1)(s + 2)(s + 30)
# Eq. B.12 with its signs corrected: 5/29 / (s + 1) - 5/28 / (s + 2).
_REDUCED = ([5 / 29 - 5 / 28, 10 / 29 - 5 / 28], [1.0, 3.0, 2.0])


def third_order(_: Programs | None) -> Figure:
    """B.3: the third order system, the second order that is left without its fast root, and their
    difference.
    """
    figure = style.new_figure(7.0, 4.6)
    upper, lower = figure.subplots(2, 1, sharex=True)
    time_s, full = step(*_THIRD, 6.0, 2001)
    _, reduced = step(*_REDUCED, 6.0, 2001)
    upper.plot(time_s, full, color=style.DARK, linewidth=1.8, label="third order, B.10")
    upper.plot(
        time_s,
        reduced,
        color=style.ORANGE,
        linestyle="--",
        label="second order, B.12 (signs corrected)",
    )
    lower.plot(time_s, 1e3 * (full - reduced), color=style.VERMILLION, label="difference")
    upper.set_ylabel("response to a unit step")
    lower.set_ylabel("difference [1e-3]")
    lower.set_xlabel("time [s]")
    lower.set_xlim(0, 6)
    for axes in (upper, lower):
        axes.legend(loc="lower right")
    figure.align_ylabels([upper, lower])
    return figure


def third_order_numbers(programs: Programs | None) -> list[Number]:
    """B.3: the difference is within the 3e-3 that the thesis claims, and the final value is
    1/12.
    """
    _, full = step(*_THIRD, 12.0, 4001)
    _, reduced = step(*_REDUCED, 12.0, 4001)
    found = program_marks(programs, *_THIRD, 20.0)
    return [
        Number("third order: final value", found.final_value, 1 / 12, 1e-9),
        worst(full - reduced, "difference, bound (the thesis: 3e-3)", 3e-3),
        Number("maximum difference", float(np.abs(full - reduced).max()), 2.0525e-4, 2e-8),
    ]


_WHITE = {"facecolor": "white", "edgecolor": "none", "pad": 1.0}


def _mark_time(axes: Axes, from_s: float, to_s: float, level: float, words: str) -> None:
    axes.annotate(
        "", (to_s, level), (from_s, level), arrowprops={"arrowstyle": "<->", "linewidth": 0.8}
    )
    axes.text((from_s + to_s) / 2, level, words, ha="center", va="center", fontsize=7, bbox=_WHITE)


def first_order_marks(_: Programs | None) -> Figure:
    """B.4: 1 / (s + a) with its rise and settling time, a = 1."""
    figure, axes = _axes()
    time_s, response = step([1.0], [1.0, 1.0], 6.0, 1001)
    axes.plot(time_s, response, color=style.DARK)
    axes.axhspan(0.98, 1.02, color=style.SKY, alpha=0.3, linewidth=0, label="2 %")
    rise_10, rise_90 = math.log(1 / 0.9), math.log(10)
    _mark_time(axes, rise_10, rise_90, 0.45, "rise time, $T_r$ = ln 9 / a")
    _mark_time(axes, 0, math.log(50), 0.12, "settling time, $T_s$ = ln 50 / a")
    for at, level in ((rise_10, 0.1), (rise_90, 0.9), (math.log(50), 0.98)):
        axes.plot([at, at], [0, level], color=style.GREY, linestyle=":", linewidth=0.8)
        axes.plot(at, level, "s", color=style.TARGET, markersize=4)
    axes.set_xlim(0, 6)
    axes.set_ylim(0, 1.1)
    style.legend_outside(axes)
    return figure


def first_order_mark_numbers(programs: Programs | None) -> list[Number]:
    """B.4: T_r = ln 9 / a, T_s = ln 50 / a, and 1 / a at the end."""
    numbers = []
    for a in (1.0, 4.0):
        found = program_marks(programs, [1.0], [1.0, a], 20 / a)
        numbers += [
            Number(f"a = {a:g}: final value", found.final_value, 1 / a, 1e-9),
            Number(f"a = {a:g}: rise, 10 to 90 %", found.rise_10_90_s, math.log(9) / a, 1e-4, "s"),
            Number(
                f"a = {a:g}: settling to 2 %",
                found.settling_2pct_s,
                math.log(50) / a,
                1e-4,
                "s",
            ),
        ]
    return numbers


def second_order_marks(_: Programs | None) -> Figure:
    """B.5: a second order system with 38 % overshoot, with rise, peak, settling and overshoot."""
    figure, axes = _axes(3.6)
    system, end_s = second_order(ZETA_38), 16.0
    time_s, response = step(*system, end_s, 2001)
    found = marks(*system, 60.0)
    axes.plot(time_s, response, color=style.DARK)
    axes.axhspan(0.98, 1.02, color=style.SKY, alpha=0.3, linewidth=0, label="2 %")
    rise_10 = float(
        np.interp(0.1, response[: int(np.argmax(response))], time_s[: int(np.argmax(response))])
    )
    rise_90 = rise_10 + found.rise_10_90_s
    axes.annotate(
        "", (rise_90, 0.6), (rise_10, 0.6), arrowprops={"arrowstyle": "<->", "linewidth": 0.8}
    )
    axes.text(rise_90 + 0.2, 0.6, "rise time, $T_r$", va="center", fontsize=7, bbox=_WHITE)
    peak = 1 + found.overshoot_fraction
    axes.plot([found.peak_time_s] * 2, [0, peak], color=style.GREY, linestyle=":", linewidth=0.8)
    axes.plot(found.peak_time_s, peak, "s", color=style.TARGET, markersize=4)
    _mark_time(axes, 0, found.peak_time_s, 0.25, "peak time, $T_p$")
    _mark_time(axes, 0, found.settling_2pct_s, 0.08, "settling time, $T_s$")
    axes.annotate(
        "",
        (found.peak_time_s, peak),
        (found.peak_time_s, 1),
        arrowprops={"arrowstyle": "<->", "linewidth": 0.8},
    )
    axes.text(
        found.peak_time_s + 0.2,
        (1 + peak) / 2,
        f"overshoot, {found.overshoot_fraction:.0%}",
        va="center",
        fontsize=7,
    )
    axes.set_xlim(0, end_s)
    axes.set_ylim(0, 1.5)
    style.legend_outside(axes)
    return figure


def second_order_mark_numbers(programs: Programs | None) -> list[Number]:
    """B.5: some 38 % of overshoot at pi / w_d; settling and rise from a response found apart."""
    found = program_marks(programs, *second_order(ZETA_38), 60.0)
    own = marks(*second_order(ZETA_38), 60.0)
    damped = math.sqrt(1 - ZETA_38**2)
    return [
        Number("overshoot", found.overshoot_fraction, 0.38, 1e-5),
        Number("peak time", found.peak_time_s, math.pi / damped, 1e-3, "s"),
        Number("rise, 10 to 90 %", found.rise_10_90_s, own.rise_10_90_s, 1e-4, "s"),
        Number("settling to 2 %", found.settling_2pct_s, own.settling_2pct_s, 1e-3, "s"),
        Number("final value", found.final_value, 1.0, 1e-9),
    ]
