"""The plots of a session, by name in KINDS: `draw(kind, view, width_in)` gives a matplotlib
Figure.
"""

from __future__ import annotations

import math

from matplotlib.figure import Figure

from ..errors import drawing_errors
from ..style import styled
from .forces import displacement_force, path
from .statistics import lateness, spectrum
from .over_time import angles, energy, error_time, force_time, joints
from .view import View, view_of

KINDS = {
    "error": error_time,
    "force": force_time,
    "displacement-force": displacement_force,
    "path": path,
    "angles": angles,
    "joints": joints,
    "energy": energy,
    "spectrum": spectrum,
    "lateness": lateness,
}


@styled
def draw(kind: str, view: View, width_in: float = 7.0) -> Figure:
    """The plot `kind` (a key of KINDS) of what view_of() took from a session, width_in inches
    wide.
    """
    if kind not in KINDS:
        raise ValueError(f"There is no plot {kind}; there are {', '.join(KINDS)}.")
    if not (math.isfinite(width_in) and 2.0 <= width_in <= 40.0):
        raise ValueError("The width is 2 to 40 inches; print takes 3.5 or 7.")
    with drawing_errors():
        return KINDS[kind](view, width_in)


__all__ = ["KINDS", "View", "draw", "view_of", *(kind.__name__ for kind in KINDS.values())]
