"""How the pictures look: white, for print, colours that colour-blind people tell apart, never by
colour alone.
"""

from __future__ import annotations

from pathlib import Path

import matplotlib
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from .output import new_file

# Okabe and Ito's palette, with the meanings that the window gives them.
BLUE, SKY, GREEN = "#0072B2", "#56B4E9", "#009E73"
ORANGE, VERMILLION, PURPLE, DARK, GREY = "#E69F00", "#D55E00", "#CC79A7", "#1A1A1A", "#777777"
CONSTRAINT, TARGET, FORCE, LIMITED, STYLUS = BLUE, GREEN, ORANGE, VERMILLION, DARK

#: x, y, z of a frame: colour, dashes
AXES = (("x", "#B2453C", "-"), ("y", "#3B7D3F", "--"), ("z", "#3A5FA8", "-."))
#: six joints: colour, dashes
JOINTS = ((DARK, "-"), (ORANGE, "-"), (SKY, "--"), (GREEN, "--"), (VERMILLION, "-."), (PURPLE, ":"))

WIDTHS_IN = (3.5, 7.0)  # a column and a page
DPI = 300
_LONGEST_FOOTER = 500  # characters: a title may have a mebibyte
FORMATS = ("png", "svg", "pdf")

RC = {
    "font.family": "DejaVu Sans",
    "font.size": 8.0,
    "axes.titlesize": 8.0,
    "axes.labelsize": 8.0,
    "legend.fontsize": 7.0,
    "xtick.labelsize": 7.0,
    "ytick.labelsize": 7.0,
    "axes.linewidth": 0.6,
    "lines.linewidth": 1.0,
    "axes.grid": True,
    "grid.color": "#DDDDDD",
    "grid.linewidth": 0.5,
    "axes.axisbelow": True,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "legend.frameon": False,
    "figure.facecolor": "white",
    "savefig.facecolor": "white",
    "svg.hashsalt": "underact",  # the same names of parts, so the same bytes, each time
    "svg.fonttype": "path",
    "pdf.fonttype": 42,
    "axes.unicode_minus": True,
}


def new_figure(width_in: float, height_in: float) -> Figure:
    """A white figure with its canvas, outside of pyplot: needs no display and leaves nothing
    behind.
    """
    figure = Figure(figsize=(width_in, height_in), dpi=DPI, constrained_layout=True)
    FigureCanvasAgg(figure)
    figure.get_layout_engine().set(w_pad=0.04, h_pad=0.04, hspace=0.03, wspace=0.03)
    return figure


def legend_outside(axes, columns: int = 1, **more) -> None:
    """A legend right of the axes (3D: below), where it covers no data."""
    handles, labels = axes.get_legend_handles_labels()
    if not handles:
        return
    if axes.figure.get_figwidth() < 5.0:  # a column is too narrow for a legend at the side
        axes.legend(
            loc="lower center", bbox_to_anchor=(0.5, 1.0), ncol=min(4, len(handles)), **more
        )
    else:
        axes.legend(
            loc="upper left", bbox_to_anchor=(1.01, 1.0), borderaxespad=0.0, ncol=columns, **more
        )


def footer(figure: Figure, words: str) -> None:
    """One small line under the axes: where the data come from."""
    words = words.replace("\n", " ")[:_LONGEST_FOOTER]
    narrow = figure.get_figwidth() < 5.0
    lines = words.replace(" · ", "\n", 1) if narrow and len(words) > 60 else words
    label = figure.supxlabel(lines, fontsize=5.5, color=GREY, x=0.01, ha="left")
    label.set_parse_math(False)  # a name is a name, also with $


def save(figure: Figure, path: str | Path, session_id: str = "") -> None:
    """Writes a .png, .svg or .pdf; the same figure gives the same bytes. session_id: of the session
    that it shows, which the file then names. Raises ValueError at another ending.
    """
    path = Path(path)
    ending = path.suffix.lower().lstrip(".")
    if ending not in FORMATS:
        raise ValueError(f"{path}: a picture ends in .png, .svg or .pdf.")
    metadata = {
        "png": {"Software": None},
        "svg": {"Date": None, "Creator": None},
        "pdf": {"CreationDate": None, "Creator": None, "Producer": None},
    }[ending]
    if session_id:
        key = {"png": "Source", "svg": "Identifier", "pdf": "Keywords"}[ending]
        metadata[key] = f"underact session {session_id}"
    with matplotlib.rc_context(RC):
        with new_file(path, "wb", 0o666) as file:
            figure.savefig(file, format=ending, dpi=DPI, metadata=metadata)


def styled(draw):
    """A decorator: runs a drawing function with this style, whatever the reader's matplotlibrc
    says.
    """

    def with_style(*arguments, **more):
        with matplotlib.rc_context(
            {**matplotlib.rcParamsDefault, **RC, "backend": matplotlib.get_backend()}
        ):
            return draw(*arguments, **more)

    with_style.__name__, with_style.__doc__ = draw.__name__, draw.__doc__
    return with_style
