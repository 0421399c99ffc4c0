"""Every figure that is remade: how it is run, drawn, and checked. A new figure is a row here."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from matplotlib.figure import Figure

from . import appendix_b, chapter4, chapter5, eight
from .number import Number


@dataclass(frozen=True)
class Entry:
    """A figure.

    key: the thesis's number. scene: a file of resources/figures (and its hand, NAME_hand.json).
    kind: "run" (scene and hand are run; draw and check get the View), "target" (a question to a
    scene), "ik", "step" (a step response), or "view" (a picture of the 3D view, nothing checked).
    """

    key: str
    title: str
    caption: str
    kind: str
    scene: str = ""
    seconds: float = 0.0
    draw: Callable[..., Figure] | None = None
    check: Callable[..., list[Number]] | None = None


def _view(key: str, title: str, scene: str) -> Entry:
    return Entry(key, title, "The scene in the program's own view.", "view", scene)


CATALOGUE: tuple[Entry, ...] = (
    Entry(
        "3.4",
        "The eight solution sets for joint angles",
        "One pose and all its solutions: two shoulders, two elbows for each, two wrists for each.",
        "ik",
        draw=eight.tree,
        check=eight.numbers,
    ),
    _view("4.1", "Point constraint", "point"),
    Entry(
        "4.2",
        "Results for point constraint",
        "Distance of the stylus from (0, 0, 0) and magnitude of the force. Pulls of 4 mm along "
        "each half axis, then two of 14 mm; the force stops at the arm's continuous 0.88 N.",
        "run",
        "point",
        13.5,
        chapter4.point_sizes,
        chapter4.point_size_numbers,
    ),
    Entry(
        "4.3",
        "Point constraint in the x-direction",
        "Displacement and force in x: a positive displacement gives a negative force.",
        "run",
        "point",
        13.5,
        chapter4.point_x,
        chapter4.point_x_numbers,
    ),
    _view("4.4", "Sphere constraint", "sphere"),
    Entry(
        "4.5",
        "Results of the sphere constraint, in space",
        "A sphere of 50 mm about (0, 0, 0): the path of the stylus, coloured by the force.",
        "run",
        "sphere",
        11.5,
        chapter4.sphere_path,
        chapter4.sphere_path_numbers,
    ),
    Entry(
        "4.6",
        "Results of the sphere constraint, over time",
        "Distance from (0, 0, 0) and magnitude of the force. At the end the hand presses deep into "
        "the sphere, and comes out.",
        "run",
        "sphere",
        11.5,
        chapter4.sphere_sizes,
        chapter4.sphere_size_numbers,
    ),
    _view("4.7", "Line constraint", "line"),
    Entry(
        "4.8",
        "Results for arbitrary line",
        "P0 = (0, 30, 0) mm, V = [-1, -2, 1]. The stylus begins at (0, 0, 0) and is drawn to the "
        "line.",
        "run",
        "line",
        9.0,
        chapter4.line_path,
        chapter4.line_numbers,
    ),
    _view("4.9", "Plane constraint", "plane"),
    Entry(
        "4.10",
        "Results for arbitrary plane",
        "Through (0, 0, 0), normal [1, 1, 1].",
        "run",
        "plane",
        9.0,
        chapter4.plane_path,
        chapter4.plane_numbers,
    ),
    _view("4.11", "Circular constraint", "circle"),
    Entry(
        "4.12",
        "Circular constraint results",
        "C = (10, 20, 30) mm, R = 40 mm, axis [-1, 1, -1].",
        "run",
        "circle",
        10.5,
        chapter4.circle_path,
        chapter4.circle_numbers,
    ),
    _view("4.13", "The arbitrary cylinder constraint", "cylinder"),
    Entry(
        "4.14",
        "Results for an arbitrary cylinder",
        "C = (30, 0, 30) mm, R = 30 mm, axis [-1, 1, -1].",
        "run",
        "cylinder",
        13.0,
        chapter4.cylinder_path,
        chapter4.cylinder_numbers,
    ),
    _view("5.1", "Circle constraint", "influence"),
    _view("5.2", "Position- and orientation-based angles", "influence_angles"),
    _view("5.3", "Planar virtual manipulator setup", "manipulator"),
    _view("5.4", "Planar virtual manipulator schematic", "manipulator"),
    Entry(
        "5.6",
        "Choosing the right angle for combination constraint",
        "Stylus at α = -5π/6, tip at β = π/2, t = 0.4: the target is at 0.9π on the shorter arc, "
        "not at -0.3π.",
        "target",
        "influence_angles",
        draw=chapter5.right_angle,
        check=chapter5.right_angle_numbers,
    ),
    Entry(
        "5.7",
        "Angle histories of the influence method",
        "Angles of stylus, target (crosses) and tip about the circle's axis, t = 0.5. From 8 s "
        "to 9 s the stylus stands "
        "along the circle's normal, and the three meet. (The thesis calls the method a Bezier "
        "curve; it goes along the arc.)",
        "run",
        "influence",
        11.0,
        chapter5.angle_histories,
        chapter5.angle_history_numbers,
    ),
    Entry(
        "5.8",
        "Virtual manipulator results",
        "One joint of 50 mm, 0.5 N/mm and 250 N mm/rad, the thesis's force law with its "
        "misprints corrected: circle, stylus, "
        "nearest point, tangent and force; turned one way, the other way, not at all, and "
        "pressed inwards.",
        "run",
        "manipulator",
        10.0,
        chapter5.manipulator_moments,
        chapter5.manipulator_numbers,
    ),
    Entry(
        "B.1",
        "First order system response",
        "a / (s + a): 1 at the end, whatever a is.",
        "step",
        draw=appendix_b.first_order,
        check=appendix_b.first_order_numbers,
    ),
    Entry(
        "B.2",
        "Generic second order responses",
        "Eq. B.9 with C = 1 and a natural frequency of 1 rad/s.",
        "step",
        draw=appendix_b.second_orders,
        check=appendix_b.second_order_numbers,
    ),
    Entry(
        "B.3",
        "Comparing third and second order responses",
        "Eq. B.10, and B.12 with its signs corrected.",
        "step",
        draw=appendix_b.third_order,
        check=appendix_b.third_order_numbers,
    ),
    Entry(
        "B.4",
        "First order system step response",
        "1 / (s + a) with a = 1: rise from 10 to 90 %, settling to 2 %.",
        "step",
        draw=appendix_b.first_order_marks,
        check=appendix_b.first_order_mark_numbers,
    ),
    Entry(
        "B.5",
        "Second order system step response",
        "A damping ratio of 0.2943, whose overshoot is 38 %.",
        "step",
        draw=appendix_b.second_order_marks,
        check=appendix_b.second_order_mark_numbers,
    ),
)
