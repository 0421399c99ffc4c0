"""Unit step responses of transfer functions, and their marks, to check `underact-cli lab step`
against.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Marks:
    """What is read off a step response; times s. Settling and peak are NaN where there is none."""

    final_value: float
    rise_10_90_s: float
    settling_2pct_s: float
    peak_time_s: float
    overshoot_fraction: float


def _exponential(A: np.ndarray) -> np.ndarray:
    """exp(A) by halving, a Taylor series, and squaring; A: a few rows, any size of entries."""
    halvings = max(0, int(np.ceil(np.log2(max(np.abs(A).sum(axis=1).max(), 1e-300)))) + 2)
    small = A / 2.0**halvings
    total = term = np.eye(len(A))
    for order in range(1, 20):
        term = term @ small / order
        total = total + term
    for _ in range(halvings):
        total = total @ total
    return total


def step(
    numerator: list[float], denominator: list[float], end_s: float, points: int
) -> tuple[np.ndarray, np.ndarray]:
    """time_s and the response to a unit step, exact at each of `points` times from 0 to end_s.

    Coefficients in descending powers of s; the numerator's order is below the denominator's.
    """
    a = np.asarray(denominator, dtype=float) / denominator[0]
    order = len(a) - 1
    b = np.zeros(order)
    b[order - len(numerator) :] = np.asarray(numerator, dtype=float) / denominator[0]
    system = np.zeros(
        (order + 1, order + 1)
    )  # the states in companion form, and the step that drives them
    system[: order - 1, 1:order] = np.eye(order - 1)
    system[order - 1, :order] = -a[:0:-1]
    system[order - 1, order] = 1.0
    time_s = np.linspace(0.0, end_s, points)
    advance = _exponential(system * (time_s[1] - time_s[0]))
    states = np.zeros((1, order + 1))
    states[0, order] = 1.0
    while (
        len(states) < points
    ):  # all states so far, advanced by as many steps, are those that follow
        states = np.concatenate([states, states @ advance.T])
        advance = advance @ advance
    response = states[:points, :order] @ b[::-1]
    return time_s, response


def _crossing(time_s: np.ndarray, values: np.ndarray, level: float) -> float:
    """When values first reach level, between two samples on a straight line."""
    above = np.flatnonzero(values >= level)
    if len(above) == 0:
        return float("nan")
    index = int(above[0])
    if index == 0:
        return float(time_s[0])
    share = (level - values[index - 1]) / (values[index] - values[index - 1])
    return float(time_s[index - 1] + share * (time_s[index] - time_s[index - 1]))


def marks(
    numerator: list[float], denominator: list[float], end_s: float, points: int = 200_001
) -> Marks:
    """Rise from 10 to 90 %, settling within 2 %, peak and overshoot, from a response sampled finely
    up to end_s.
    """
    time_s, response = step(numerator, denominator, end_s, points)
    final = numerator[-1] / denominator[-1]
    share = response / final
    outside = np.flatnonzero(np.abs(share - 1) > 0.02)
    if len(outside) == 0 or outside[-1] == points - 1:
        settling = float("nan")
    else:
        last = int(outside[-1])
        here, next_ = abs(share[last] - 1), abs(share[last + 1] - 1)
        settling = float(time_s[last] + (here - 0.02) / (here - next_) * (time_s[1] - time_s[0]))
    top = int(np.argmax(share))
    overshoot = float(share[top]) - 1
    peaks = overshoot > 1e-9
    return Marks(
        final,
        _crossing(time_s, share, 0.9) - _crossing(time_s, share, 0.1),
        settling,
        _top(time_s, share, top) if peaks else float("nan"),
        overshoot if peaks else 0.0,
    )


def _top(time_s: np.ndarray, values: np.ndarray, index: int) -> float:
    """Where the parabola through the greatest sample and its neighbours has its top."""
    if not 0 < index < len(values) - 1:
        return float(time_s[index])
    before, here, after = values[index - 1 : index + 2]
    return float(
        time_s[index]
        + 0.5 * (before - after) / (before - 2 * here + after) * (time_s[1] - time_s[0])
    )
