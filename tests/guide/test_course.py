"""The formulas of the course, as its pages print them, against the program at random poses."""

import json
import os
import pathlib
import random
import subprocess
import unittest
from math import atan2, cos, hypot, pi, sin, sqrt

from pages import ROOT

try:
    import numpy as np
except ImportError as error:
    raise unittest.SkipTest(f"{error}: packaging/install-deps brings it") from error

CLI = pathlib.Path(os.environ["UNDERACT_BUILD"]) / "underact-cli"
L1, L2 = 127.508, 149.352
X_WB = np.array([[0, 1, 0, 0], [0, 0, 1, 30], [1, 0, 0, -176], [0, 0, 0, 1]])
ROWS = [(0, 0, 0), (pi / 2, 0, 0), (0, L1, 0), (pi / 2, 0, L2), (-pi / 2, 0, 0), (pi / 2, 0, 0)]


def ask(command, rows):
    """What the program answers, line by line."""
    done = subprocess.run(
        [CLI, *command.split()],
        input="".join(json.dumps(row) + "\n" for row in rows),
        capture_output=True,
        text=True,
        check=True,
        timeout=60,
    )
    return [json.loads(line) for line in done.stdout.splitlines()]


def turn(axis, angle):
    """About one of the axes."""
    c, s = cos(angle), sin(angle)
    rows = {
        "x": [[1, 0, 0], [0, c, -s], [0, s, c]],
        "y": [[c, 0, s], [0, 1, 0], [-s, 0, c]],
        "z": [[c, -s, 0], [s, c, 0], [0, 0, 1]],
    }
    return np.array(rows[axis])


def step(alpha, a, theta, d):
    """course_frames.md: from one frame to the next."""
    ct, st, ca, sa = cos(theta), sin(theta), cos(alpha), sin(alpha)
    return np.array(
        [
            [ct, -st, 0, a],
            [st * ca, ct * ca, -sa, -d * sa],
            [st * sa, ct * sa, ca, d * ca],
            [0, 0, 0, 1],
        ]
    )


class Course(unittest.TestCase):
    def setUp(self):
        draw = random.Random(20070701)
        self.joints = [[draw.uniform(-1.4, 1.4) for _ in range(6)] for _ in range(50)]
        self.poses = [
            np.array(answer["X_WT"]) for answer in ask("fk", [{"q_rad": q} for q in self.joints])
        ]

    def near(self, a, b, allowed=1e-9):
        """Both alike, as numbers or arrays."""
        self.assertLess(np.max(np.abs(np.asarray(a) - np.asarray(b))), allowed)

    def test_frames_three_turns_and_the_way_back(self):
        ca, sa, cb, sb, ct, st = cos(0.3), sin(0.3), cos(0.5), sin(0.5), cos(0.7), sin(0.7)
        printed = [
            [ct * cb, ct * sb * sa - st * ca, ct * sb * ca + st * sa],
            [st * cb, st * sb * sa + ct * ca, st * sb * ca - ct * sa],
            [-sb, cb * sa, cb * ca],
        ]
        self.near(turn("z", 0.7) @ turn("y", 0.5) @ turn("x", 0.3), printed)
        pose = self.poses[0]
        back = np.eye(4)
        back[:3, :3], back[:3, 3] = pose[:3, :3].T, -pose[:3, :3].T @ pose[:3, 3]
        self.near(back, np.linalg.inv(pose))

    def test_dh_and_forward(self):
        for q, pose in zip(self.joints, self.poses):
            steps = [step(al, a, angle, d) for (al, a, d), angle in zip(ROWS, q)]
            self.near(X_WB @ np.linalg.multi_dot(steps), pose)
            c1, s1, c2, s2 = cos(q[0]), sin(q[0]), cos(q[1]), sin(q[1])
            c23, s23 = cos(q[1] + q[2]), sin(q[1] + q[2])
            r = L1 * c2 + L2 * s23
            x, y, z = pose[2, 3] + 176, pose[0, 3], pose[1, 3] - 30
            self.near([x, y, z], [c1 * r, s1 * r, L1 * s2 - L2 * c23])
            R_03 = np.linalg.multi_dot(steps[:3])[:3, :3]
            W = turn("z", q[3]) @ turn("y", q[4]) @ turn("z", q[5])
            self.near(X_WB[:3, :3] @ R_03 @ turn("x", pi / 2) @ W, pose[:3, :3])

    def test_inverse(self):
        for answer, pose in zip(ask("ik", [{"X_WT": p.tolist()} for p in self.poses]), self.poses):
            x, y, z = pose[2, 3] + 176, pose[0, 3], pose[1, 3] - 30
            S = (x * x + y * y + z * z - L1 * L1 - L2 * L2) / (2 * L1 * L2)
            made = []
            for q1 in (atan2(y, x), atan2(-y, -x)):
                for root in (1, -1):
                    q3 = atan2(S, root * sqrt(1 - S * S))
                    A, B, C = cos(q1) * x + sin(q1) * y, L1 + L2 * S, L2 * cos(q3)
                    q2 = atan2(C * A + B * z, B * A - C * z)
                    R_03 = np.linalg.multi_dot(
                        [step(al, a, angle, d) for (al, a, d), angle in zip(ROWS, (q1, q2, q3))]
                    )[:3, :3]
                    R_BT = X_WB[:3, :3].T @ pose[:3, :3]
                    b = (R_03 @ turn("x", pi / 2)).T @ R_BT
                    for k in (1, -1):
                        q5 = atan2(k * hypot(b[0, 2], b[1, 2]), b[2, 2])
                        q4, q6 = atan2(k * b[1, 2], k * b[0, 2]), atan2(k * b[2, 1], -k * b[2, 0])
                        made.append([q1, q2, q3, q4, q5, q6])
            self.assertEqual(len(answer["solutions"]), 8)
            for solution in answer["solutions"]:
                wanted = np.array(solution["q_rad"])
                off = [np.max(np.abs(np.sin((np.array(q) - wanted) / 2))) for q in made]
                self.assertLess(min(off), 1e-6)

    def test_jacobian_and_statics(self):
        for q, answer in zip(self.joints, ask("jacobian", [{"q_rad": q} for q in self.joints])):
            c1, s1, c2, s2 = cos(q[0]), sin(q[0]), cos(q[1]), sin(q[1])
            c23, s23 = cos(q[1] + q[2]), sin(q[1] + q[2])
            r, u = L1 * c2 + L2 * s23, L2 * c23 - L1 * s2
            J_p = [
                [-s1 * r, c1 * u, c1 * L2 * c23],
                [c1 * r, s1 * u, s1 * L2 * c23],
                [0, r, L2 * s23],
            ]
            J = np.array(answer["J"])
            self.near(X_WB[:3, :3] @ np.array(J_p), J[:3, :3])
            self.near(J[:3, 3:], 0)
            det = L1 * L2 * cos(q[2]) * r
            self.near(det / answer["det_Jp"], 1)
            self.near(abs(np.linalg.det(J)) / abs(det * sin(q[4])), 1, 1e-6)

    def test_nearest_points(self):
        def across(D, axis):
            a = np.array(axis) / np.linalg.norm(axis)
            return D - (D @ a) * a, (D @ a) * a

        draw = random.Random(7)
        points = [np.array([draw.uniform(-80, 80) for _ in range(3)]) for _ in range(20)]
        for name in ("01_point", "02_sphere", "03_line", "04_plane", "05_circle", "06_cylinder"):
            path = ROOT / f"scenes/{name}.json"
            shape = json.loads(path.read_text(encoding="utf-8"))["constraints"][0]
            answers = ask(f"target {path}", [{"p_mm": p.tolist()} for p in points])
            for P, answer in zip(points, answers):
                keys = ("position_mm", "center_mm", "point_mm")
                P_0 = np.array(next(shape[key] for key in keys if key in shape))
                D = P - P_0
                if shape["type"] == "point":
                    Q = P_0
                elif shape["type"] == "sphere":
                    Q = P_0 + shape["radius_mm"] * D / np.linalg.norm(D)
                elif shape["type"] == "line":
                    V = np.array(shape["direction"])
                    Q = P_0 + (V @ D) / (V @ V) * V
                elif shape["type"] == "plane":
                    N = np.array(shape["normal"])
                    Q = P - (N @ D) / (N @ N) * N
                else:
                    E, along = across(D, shape.get("normal", shape.get("axis")))
                    Q = P_0 + shape["radius_mm"] * E / np.linalg.norm(E)
                    Q = Q + along if shape["type"] == "cylinder" else Q
                self.near(answer["q_mm"], Q)
                self.near(answer["force_N"], 0.5 * (Q - P))

    def test_samples_and_delay(self):
        def limit(more):
            words = "lab stability --mass_kg 0.045 --damping_N_s_per_m 0.1 --kd_N_s_per_m 0 --json"
            return ask(f"{words} {more}", [])[0]["exact_limit_N_per_m"]

        self.near(limit(""), 200, 0.1)  # b = K T / 2
        self.near(limit("--delay_ticks 1"), 66.7, 0.1)  # K = b / (T / 2 + t_d)


if __name__ == "__main__":
    unittest.main()
