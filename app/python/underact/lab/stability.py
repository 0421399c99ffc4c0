"""Maps of stability: the largest stable stiffness against the damping of the wall."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure

from .. import style
from .tables import groups, read

TITLES = {
    "rate": "Rate of the servo",
    "delay": "Delay",
    "hand": "Hand",
    "filter": "Velocity filter",
    "quantization": "Steps of the encoders",
    "friction": "Friction of the arm",
}
COLOURS = (style.DARK, style.BLUE, style.GREEN, style.ORANGE, style.VERMILLION, style.PURPLE)
MARKS = ("o", "s", "^", "D", "v", "P")
NOMINAL_N_PER_M = 500.0
MIN_KD = 0.03  # where B = 0 stands on a logarithmic axis


def _kd(rows: list[dict]) -> np.ndarray:
    return np.maximum([row["kd_N_s_per_m"] for row in rows], MIN_KD)


def _column(rows: list[dict], key: str) -> np.ndarray:
    values = np.array([row[key] for row in rows], dtype=float)
    values[values <= 0.0] = np.nan  # nothing is stable there: no point of a logarithmic axis
    return values


def _axes(axes, title: str) -> None:
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("damping of the wall B [N s/m]")
    axes.set_ylabel("stiffness K [N/m]")
    axes.set_title(title, loc="left")
    axes.set_xticks([MIN_KD, 0.1, 1.0, 10.0], ["0", "0.1", "1", "10"])
    axes.minorticks_off()


def _nominal(axes) -> None:
    axes.plot(
        [MIN_KD],
        [NOMINAL_N_PER_M],
        "*",
        color=style.VERMILLION,
        markersize=9,
        zorder=5,
        label="the arm's nominal 500 N/m",
    )


@style.styled
def limits(rows: list[dict], key: str, width_in: float = 7.0) -> Figure:
    """One map: simulated limits as points, eigenvalues as lines, the formulas for one variant."""
    figure = style.new_figure(width_in, 0.5 * width_in)
    axes = figure.add_subplot()
    variants = groups([row for row in rows if row["map"] == key], "variant")
    for (name, own), colour, mark in zip(variants.items(), COLOURS, MARKS):
        axes.plot(
            _kd(own),
            _column(own, "simulated_N_per_m"),
            mark,
            color=colour,
            markersize=3.5,
            label=str(name),
        )
        axes.plot(_kd(own), _column(own, "exact_N_per_m"), "-", color=colour, linewidth=0.9)
    first = variants["1000 Hz"] if "1000 Hz" in variants else next(iter(variants.values()))
    axes.plot(
        _kd(first),
        _column(first, "colgate_schenkel_N_per_m"),
        ":",
        color=style.GREY,
        label="2 (b - B) / T",
    )
    axes.plot(
        _kd(first),
        _column(first, "gil_hulin_N_per_m"),
        "--",
        color=style.GREY,
        label="(b + B) / (T/2 + td)",
    )
    _nominal(axes)
    _axes(axes, f"{TITLES.get(key, key)}: largest stable stiffness")
    style.legend_outside(axes)
    style.footer(
        figure,
        "points: by halving in the simulated loop · lines: by eigenvalues; formulas for "
        + ("1000 Hz" if key == "rate" else str(next(iter(variants)))),
    )
    return figure


@style.styled
def labels(rows: list[dict], by: str, width_in: float = 7.0) -> Figure:
    """What a push becomes in each cell of B and K, a small map for each value of `by`."""
    variants = groups(rows, by)
    columns = min(3, len(variants))
    lines = -(-len(variants) // columns)
    figure = style.new_figure(width_in, 0.36 * width_in * lines)
    words = ("rest", "limit_cycle", "grows")
    colours = ListedColormap(["#BFE3D6", "#F6D58E", "#EFB39A"])
    for index, (name, own) in enumerate(variants.items()):
        axes = figure.add_subplot(lines, columns, index + 1)
        dampings = sorted({row["kd_N_s_per_m"] for row in own})
        stiffnesses = sorted({row["stiffness_N_per_m"] for row in own})
        field = np.zeros((len(stiffnesses), len(dampings)))
        for row in own:
            at = stiffnesses.index(row["stiffness_N_per_m"]), dampings.index(row["kd_N_s_per_m"])
            field[at] = words.index(row["label"])
            sign = {"rest": "", "limit_cycle": "~", "grows": "×"}[row["label"]] + (
                "p" if row["passive"] else ""
            )
            axes.text(at[1], at[0], sign, ha="center", va="center", fontsize=4.5)
        axes.imshow(field, cmap=colours, vmin=-0.5, vmax=2.5, origin="lower", aspect="auto")
        axes.grid(False)
        axes.set_xticks(range(0, len(dampings), 2), [f"{d:g}" for d in dampings[::2]])
        axes.set_yticks(range(0, len(stiffnesses), 3), [f"{k:g}" for k in stiffnesses[::3]])
        axes.set_title(str(name), loc="left", parse_math=False)
        if index % columns == 0:
            axes.set_ylabel("K [N/m]")
        if index >= len(variants) - columns:
            axes.set_xlabel("B [N s/m]")
    style.footer(
        figure, "green: comes to rest · amber ~: swings on · red ×: grows · p: passive"
    )
    return figure


@style.styled
def scenes(rows: list[dict], width_in: float = 7.0) -> Figure:
    """Scenes for which there is no formula: the limit against the rate, a line a damping."""
    by_scene = groups(rows, "scene")
    columns = min(3, len(by_scene))
    lines = -(-len(by_scene) // columns)
    figure = style.new_figure(width_in, 0.33 * width_in * lines)
    for index, (name, own) in enumerate(by_scene.items()):
        axes = figure.add_subplot(lines, columns, index + 1)
        for (kd, line), colour, mark in zip(groups(own, "kd_N_s_per_m").items(), COLOURS, MARKS):
            axes.plot(
                [row["rate_hz"] for row in line],
                _column(line, "simulated_N_per_m"),
                mark + "-",
                color=colour,
                markersize=3,
                label=f"B = {kd:g} N s/m",
            )
        axes.axhline(NOMINAL_N_PER_M, color=style.VERMILLION, linewidth=0.8, linestyle=":")
        axes.set_xscale("log", base=2)
        axes.set_yscale("log")
        axes.set_xticks([500, 1000, 2000, 4000], ["500", "1000", "2000", "4000"])
        axes.set_title(str(name), loc="left", parse_math=False)
        if index % columns == 0:
            axes.set_ylabel("K [N/m]")
        if index >= len(by_scene) - columns:
            axes.set_xlabel("rate [Hz]")
    figure.axes[min(columns, len(figure.axes)) - 1].legend(
        loc="upper left", bbox_to_anchor=(1.01, 1.0), borderaxespad=0.0
    )
    style.footer(
        figure,
        "largest stable stiffness, full tick without limits · dotted: the arm's nominal 500 N/m",
    )
    return figure


def draw_all(tables: Path, out: Path, width_in: float) -> list[Path]:
    """All pictures that the tables in a folder allow, as SVG and PNG; gives their paths."""
    pictures: list[tuple[str, Figure]] = []
    if (tables / "stability_limits.csv").exists():
        rows = read(tables / "stability_limits.csv")
        pictures += [
            (f"stability_{key}", limits(rows, key, width_in)) for key in groups(rows, "map")
        ]
    if (tables / "stability_labels.csv").exists():
        rows = read(tables / "stability_labels.csv")
        pictures += [
            (f"stability_{key}_labels", labels(own, "variant", width_in))
            for key, own in groups(rows, "map").items()
        ]
    if (tables / "stability_scenes.csv").exists():
        pictures.append(
            ("stability_scenes", scenes(read(tables / "stability_scenes.csv"), width_in))
        )
    if (tables / "stability_scene_labels.csv").exists():
        rows = [
            row for row in read(tables / "stability_scene_labels.csv") if row["rate_hz"] == 1000
        ]
        pictures += [("stability_scenes_labels", labels(rows, "scene", width_in))] if rows else []
    written = []
    for name, figure in pictures:
        for ending in ("svg", "png"):
            style.save(figure, out / f"{name}.{ending}")
            written.append(out / f"{name}.{ending}")
    return written
