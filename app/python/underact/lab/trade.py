"""The cost of each choice against its accuracy, and the fronts of combinations of choices."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from .. import style
from .tables import groups, read


def _grid(width_in: float, count: int, columns: int, height: float) -> tuple[Figure, list]:
    """A figure of `count` small axes, row by row, height x width_in high each row."""
    lines = -(-count // columns)
    figure = style.new_figure(width_in, height * width_in * lines + 0.4)
    return figure, [figure.add_subplot(lines, columns, index + 1) for index in range(count)]


def _positive(values: list[float], floor: float) -> np.ndarray:
    """Values for a logarithmic axis: exact zeros stand at the floor."""
    array = np.array(values, dtype=float)
    return np.where(array > 0.0, array, floor)


@style.styled
def choices(rows: list[dict], width_in: float = 7.0) -> Figure:
    """Cost against error of each choice's options; bound, default and what is recommended."""
    by_choice = groups(rows, "choice")
    figure, all_axes = _grid(width_in, len(by_choice), 2, 0.36)
    for axes, (key, options) in zip(all_axes, by_choice.items()):
        errors = _positive([row["error"] for row in options], 0.1 * options[0]["bound"])
        costs = [row["us_per_s"] for row in options]
        axes.plot(costs, errors, "o", color=style.GREY, markersize=3)
        for row, cost, error in zip(options, costs, errors):
            axes.annotate(
                str(row["option"]).removesuffix(".0"),
                (cost, error),
                fontsize=4.5,
                xytext=(3, 2),
                textcoords="offset points",
            )
            if row["default"]:
                axes.plot([cost], [error], "s", color=style.BLUE, markersize=6, fillstyle="none")
            if row["recommended"]:
                axes.plot([cost], [error], "*", color=style.VERMILLION, markersize=7)
        axes.axhline(options[0]["bound"], color=style.GREEN, linewidth=0.8, linestyle="--")
        if max(costs) > 3.0 * min(costs):  # else a logarithmic axis has no room for its numbers
            axes.set_xscale("log")
        axes.set_yscale("log")
        axes.margins(0.15)
        zero = " (lowest: none)" if any(row["error"] == 0.0 for row in options) else ""
        axes.set_ylabel(f"error [{options[0]['unit']}]{zero}")
        axes.set_title(key, loc="left")
        axes.set_xlabel("processor time [us per second]")
    style.footer(
        figure,
        "error: root mean square that nine of ten runs do not exceed · "
        "dashed: bound · square: default · star: recommended",
    )
    return figure


@style.styled
def fronts(rows: list[dict], width_in: float = 7.0) -> Figure:
    """All combinations of choices for each scene: processor time against the error of the path."""
    scenes = groups(rows, "scene")
    figure, all_axes = _grid(width_in, len(scenes), 4, 0.2)
    for index, (axes, (name, points)) in enumerate(zip(all_axes, scenes.items())):
        errors = _positive([row["error_mm"] for row in points], 1e-6)
        costs = np.array([row["us_per_s"] for row in points], dtype=float)
        front = [row["on_front"] for row in points]
        axes.plot(costs, errors, ".", color="#BBBBBB", markersize=2)
        order = np.argsort(costs[front])
        axes.plot(costs[front][order], errors[front][order], "o-", color=style.BLUE, markersize=2.5)
        for cost, error, row in zip(costs, errors, points):
            if row["own"]:
                axes.plot(
                    [cost], [error], "s", color=style.VERMILLION, markersize=5, fillstyle="none"
                )
        axes.set_xscale("log")
        axes.set_yscale("log")
        axes.set_title(str(name), loc="left", fontsize=6.0, parse_math=False)
        axes.tick_params(labelsize=5.0)
        if index % 4 == 0:
            axes.set_ylabel("error [mm]", fontsize=6.0)
        if index >= len(scenes) - 4:
            axes.set_xlabel("us per second", fontsize=6.0)
    style.footer(
        figure,
        "tick and simulated arm, the median over five hands · line: the front · "
        "square: as the scene is, at 1 kHz",
    )
    return figure


def draw_all(tables: Path, out: Path, width_in: float) -> list[Path]:
    """All pictures that the tables in a folder allow, as SVG and PNG; gives their paths."""
    drawings = {
        "trade_choices": choices,
        "trade_fronts": fronts,
    }
    written = []
    for name, drawing in drawings.items():
        table = tables / f"{name}.csv"
        if not table.exists():
            continue
        figure = drawing(read(table), width_in)
        for ending in ("svg", "png"):
            style.save(figure, out / f"{name}.{ending}")
            written.append(out / f"{name}.{ending}")
    return written
