"""Draws tick.png beside itself: the five steps of a tick, and how little of the period they take.

    /usr/bin/python3 resources/pictures/guide/tick.py

The two times are those that the page real_time.md shows of servo-check, 1000 Hz.
"""

import pathlib

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot as plt
from matplotlib.patches import FancyArrowPatch, FancyBboxPatch

WIDTH, HEIGHT = 720, 252  # px, as the guide shows it
SCALE = 2  # of the file: sharp on a dense screen
BLACK, ORANGE, SKY, GREEN = "#000000", "#E69F00", "#56B4E9", "#009E73"  # Okabe and Ito
YELLOW, VERMILLION, GREY = "#F0E442", "#D55E00", "#555555"
STEPS = [
    ("sample", SKY, "core/servo/", "loop.cpp"),
    ("kinematics", SKY, "core/tick/", "motion.cpp"),
    ("target", GREEN, "core/target/", "constraint.cpp"),
    ("control\nlaw", YELLOW, "core/tick/", "forces.cpp"),
    ("safety\ngate", ORANGE, "core/safety/", "gate.cpp"),
]
BETWEEN = ["joints", "tip", "error", "force"]
PERIOD_US, LATE_US, TICK_US = 1000.0, 52.2, 1.3


def text(axes, x, y, words, size=14, **how):
    """Size in px of the guide."""
    axes.text(x, y, words, fontsize=size * 0.72, **{"ha": "center", "va": "center", **how})


def arrow(axes, start, end, colour=BLACK, width=1.6):
    axes.add_patch(
        FancyArrowPatch(
            start,
            end,
            arrowstyle="-|>",
            mutation_scale=9,
            lw=width,
            color=colour,
            shrinkA=0,
            shrinkB=0,
        )
    )


def steps(axes):
    left, wide, gap, top, high = 8, 102, 29, 174, 54
    for index, (name, colour, folder, file) in enumerate(STEPS):
        x = left + index * (wide + gap)
        axes.add_patch(
            FancyBboxPatch(
                (x, top),
                wide,
                high,
                boxstyle="round,pad=0,rounding_size=6",
                facecolor=colour,
                edgecolor=BLACK,
                lw=1.2,
            )
        )
        text(axes, x + wide / 2, top + high / 2, name, 15.5, weight="bold", linespacing=1.05)
        for line, part in enumerate((folder, file)):
            text(axes, x + wide / 2, top - 14 - 15 * line, part, 12, family="monospace")
        end = x + wide + gap - 2
        arrow(axes, (x + wide + 2, top + high / 2), (end, top + high / 2))
        if index < len(BETWEEN):
            text(axes, x + wide + gap / 2, top + high + 11, BETWEEN[index], 13)
    text(axes, left + 5 * (wide + gap) + 2, top + high / 2, "force", 15.5, weight="bold", ha="left")


def budget(axes):
    left, right, bottom, high = 8, 712, 62, 24

    def at(time_us):
        return left + (right - left) * time_us / PERIOD_US

    axes.plot([left, right], [bottom, bottom], color=BLACK, lw=1.4)
    ends = ((left, 6, "deadline", "left"), (right, -6, "next deadline, 1 ms later", "right"))
    for x, aside, words, side in ends:
        axes.plot([x, x], [bottom - 6, bottom + high + 16], color=BLACK, lw=1.4)
        text(axes, x + aside, bottom + high + 10, words, 13, ha=side)
    tick = at(LATE_US)
    axes.fill_between([left, tick], bottom, bottom + high, color="#CCCCCC", lw=0)
    axes.plot([tick, tick], [bottom, bottom + high], color=VERMILLION, lw=2)
    text(axes, (tick + right) / 2, bottom + high / 2, "the servo thread sleeps", 14, color=GREY)
    arrow(axes, (tick, bottom - 18), (tick, bottom - 2), VERMILLION, 1.2)
    words = f"the tick, all five steps: {TICK_US} µs, less than the width of this line"
    text(axes, tick + 6, bottom - 17, words, 14, ha="left")
    arrow(axes, ((left + tick) / 2, bottom - 38), ((left + tick) / 2, bottom - 2), GREY, 1.2)
    words = f"latency: 99 of 100 ticks start within {LATE_US:.0f} µs of their deadline"
    text(axes, left, bottom - 48, words, 14, ha="left")


def main():
    figure = plt.figure(figsize=(WIDTH / 100, HEIGHT / 100), dpi=100 * SCALE, facecolor="white")
    axes = figure.add_axes((0, 0, 1, 1))
    axes.set(xlim=(0, WIDTH), ylim=(0, HEIGHT))
    axes.axis("off")
    steps(axes)
    budget(axes)
    figure.savefig(pathlib.Path(__file__).with_suffix(".png"), metadata={"Software": None})


main()
