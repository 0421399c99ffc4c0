"""Plots of distributions: spectra, latency."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from .. import layout, style
from .over_time import _say
from .view import View


def density(
    values: np.ndarray, rate_hz: float, segment: int = 4096
) -> tuple[np.ndarray, np.ndarray]:
    """One-sided power spectral density by Welch: Hann windows, half overlapping, no means.

    values: evenly sampled at rate_hz. Gives frequencies (Hz) and the density (unit^2 / Hz); the
    sum of
    density times the spacing of frequencies is the variance. Fewer than 8 values give empty arrays.
    """
    values = np.asarray(values, dtype=float)
    size = min(segment, len(values))
    if size < 8:
        return np.array([]), np.array([])
    window = np.hanning(size + 1)[:-1]
    scale = 1.0 / (rate_hz * (window**2).sum())
    total = np.zeros(size // 2 + 1)
    starts = range(0, len(values) - size + 1, max(1, size // 2))
    for start in starts:
        part = values[start : start + size]
        total += np.abs(np.fft.rfft((part - part.mean()) * window)) ** 2 * scale
    total /= len(starts)
    total[1 : None if size % 2 else -1] *= 2
    return np.fft.rfftfreq(size, 1 / rate_hz), total


def spectrum(view: View, width_in: float) -> Figure:
    """Amplitude spectral densities of error (mm / sqrt Hz) and magnitude of the force sent
    (N / sqrt Hz).
    """
    figure = style.new_figure(width_in, 0.62 * width_in + 0.5)
    panels = figure.subplots(2, 1, sharex=True).tolist()
    force = np.linalg.norm(view["force_sent_N"], axis=1)
    rows = ((view["error_mm"], style.STYLUS, "error", "mm"), (force, style.FORCE, "force", "N"))
    for axes, (values, color, name, unit) in zip(panels, rows):
        whole = np.nan_to_num(values)  # where nothing acts there is no error
        frequency, power = density(whole, view.rate_hz)
        if len(frequency) > 1 and power[1:].max() > 0:
            axes.loglog(frequency[1:], np.sqrt(power[1:]), color=color, linewidth=0.8)
        else:
            _say(axes, "Nothing moves here, or too few ticks for a spectrum.")
        axes.set_ylabel(f"{name} [{unit}/√Hz]")
    panels[-1].set_xlabel("frequency [Hz]")
    figure.align_ylabels(panels)
    style.footer(figure, view.footer)
    return figure


def lateness(view: View, width_in: float) -> Figure:
    """How late ticks began and how long they took: counts, both axes logarithmic; a dashed line at
    one period.
    """
    figure = style.new_figure(width_in, 0.45 * width_in + 0.5)
    axes = figure.subplots()
    late, took = view["lateness_us"], view["tick_us"]
    edges = np.logspace(-1, 6, 141)
    if (late > 0).any():
        axes.hist(np.maximum(late, edges[0]), edges, color=style.SKY, label="latency")
    axes.hist(
        np.maximum(took, edges[0]),
        edges,
        histtype="step",
        color=style.STYLUS,
        label="time of a tick",
    )
    period_us = 1e6 / view.rate_hz
    axes.axvline(period_us, color=style.VERMILLION, linestyle="--", label="one period")
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(edges[0], max(2 * period_us, 1.3 * float(max(late.max(), took.max()))))
    axes.set_xlabel(f"latency, time of a tick [{layout.unit('lateness_us')}]")
    axes.set_ylabel("ticks")
    if not (late > 0).any():
        axes.set_title("No latency: it ran as fast as possible.", color=style.GREY)
    style.legend_outside(axes)
    style.footer(figure, view.footer)
    return figure
