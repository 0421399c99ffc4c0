"""Figure 3.4: the eight solutions for the joint angles of one pose, as a tree."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.figure import Figure

from .. import style
from .number import Number, worst
from .programs import Programs

_JOINTS_RAD = [0.25, 0.6, 0.3, 0.4, 1.2, -0.5]  # of the pose whose solutions are sought
_L1_MM, _L2_MM = 127.508, 149.352  # table 3.1


def forward(q: list[float]) -> np.ndarray:
    """Table 3.1 and eq. 3.1 (Craig's parameters), written out on its own: X_WT, 4 x 4, mm."""
    X = np.array([[0.0, 1, 0, 0], [0, 0, 1, 30], [1, 0, 0, -176], [0, 0, 0, 1]])
    rows = ((0, 0, 0), (90, 0, 0), (0, _L1_MM, 0), (90, 0, _L2_MM), (-90, 0, 0), (90, 0, 0))
    for (twist_deg, a, d), theta in zip(rows, q):
        ca, sa = round(math.cos(math.radians(twist_deg))), round(math.sin(math.radians(twist_deg)))
        c, s = math.cos(theta), math.sin(theta)
        X = X @ np.array(
            [
                [c, -s, 0, a],
                [s * ca, c * ca, -sa, -sa * d],
                [s * sa, c * sa, ca, ca * d],
                [0, 0, 0, 1],
            ]
        )
    return X


def solve(programs: Programs) -> dict:
    """The answer of `ik` to that pose."""
    return programs.answers(["ik"], [{"X_WT": forward(_JOINTS_RAD).tolist()}])[0]


def tree(answer: dict) -> Figure:
    """3.4: two shoulders, two elbows each, two wrists each; at the leaves the six angles."""
    figure = style.new_figure(7.0, 3.6)
    axes = figure.subplots()
    axes.axis("off")
    order = sorted(
        answer["solutions"],
        key=lambda one: [-one["branch"][part] for part in ("shoulder", "elbow", "wrist")],
    )
    levels = (("θ₁", 4), ("θ₃, θ₂", 2), ("θ₅, θ₄, θ₆", 1))
    parents = {0: (0.0, 3.5)}
    for depth, ((name, span), sign_key) in enumerate(
        zip(levels, ("shoulder", "elbow", "wrist")), start=1
    ):
        children = {}
        for index in range(8 // span):
            y = index * span + (span - 1) / 2
            start = parents[index // 2]
            axes.plot([start[0], depth], [start[1], y], color=style.GREY, linewidth=0.8)
            sign = order[index * span]["branch"][sign_key] if index * span < len(order) else 0
            axes.text(
                depth,
                y,
                f" {sign:+d} ",
                ha="center",
                va="center",
                bbox={"fc": "white", "ec": style.GREY, "pad": 1.5},
            )
            children[index] = (float(depth), y)
        parents = children
        axes.text(depth, -0.9, f"{sign_key}\n({name})", ha="center", va="bottom", color=style.BLUE)
    axes.text(0, 3.5, " pose ", ha="center", va="center", bbox={"fc": "white", "ec": style.DARK})
    axes.text(3.4, -0.9, "θ₁ to θ₆ [deg]", va="bottom", color=style.BLUE)
    for index, one in enumerate(order):
        words = "  ".join(f"{math.degrees(angle):7.1f}" for angle in one["q_rad"])
        axes.text(3.35, index, words, va="center", family="DejaVu Sans Mono", fontsize=6.5)
    axes.set_xlim(-0.3, 6.3)
    axes.set_ylim(7.6, -2.4)
    return figure


def numbers(answer: dict) -> list[Number]:
    """3.4: eight solutions, all different, each reaching the pose by forward kinematics written
    apart.
    """
    pose = forward(_JOINTS_RAD)
    joints = [one["q_rad"] for one in answer["solutions"]]
    different = {tuple(round(angle, 6) for angle in q) for q in joints}
    known = min(
        (float(np.abs(np.subtract(q, _JOINTS_RAD)).max()) for q in joints), default=math.nan
    )
    return [
        Number("solutions that differ", len(different), 8, 0),
        worst(
            np.ravel([forward(q) - pose for q in joints]),
            "maximum error of the poses reached",
            1e-9,
            "mm, 1",
        ),
        Number(
            "distance of the nearest solution from the joints that made the pose",
            known,
            0,
            1e-9,
            "rad",
        ),
    ]
