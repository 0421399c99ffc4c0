"""A number that a figure asserts."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass


@dataclass(frozen=True)
class Number:
    """What was measured, what it should be, and how far it may be off, all in `unit`."""

    what: str
    measured: float
    expected: float
    tolerance: float
    unit: str = ""

    @property
    def passed(self) -> bool:
        """Whether it is as it should be; what is no number is not."""
        return abs(self.measured - self.expected) <= self.tolerance

    def as_dict(self) -> dict:
        """For figures.json; what is no number becomes null, for JSON has no word for it."""
        finite = {
            k: None if isinstance(v, float) and not math.isfinite(v) else v
            for k, v in asdict(self).items()
        }
        return {**finite, "passed": self.passed}


def worst(values, what: str, tolerance: float, unit: str = "") -> Number:
    """The greatest size of `values`, which should be zero; of no values at all it is no number, and
    fails.
    """
    sizes = [abs(float(value)) for value in values]
    measured = max(sizes, default=math.nan)
    if any(math.isnan(size) for size in sizes):
        measured = math.nan
    return Number(what, measured, 0.0, tolerance, unit)
