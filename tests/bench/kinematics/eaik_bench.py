"""Usage: eaik_bench.py FILE. Times EAIK's inverse kinematics over the poses of FILE (see eaik.cpp) and prints its
version, the median ns for a pose, how many exact answers there were, the share of them within 1e-6 m and rad, and the
worst of those in m and rad. Ends with 1 where the module is not there."""
import importlib.metadata
import sys
import time

try:
    import numpy as np
    from eaik.IK_HP import HPRobot
except ImportError:
    sys.exit(1)


def turned(axis, angle):
    k = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k


def forward(axes, offsets, q):
    R, p = np.eye(3), offsets[0].copy()
    for axis, offset, angle in zip(axes, offsets[1:], q):
        R = R @ turned(axis, angle)
        p += R @ offset
    return R, p


rows = [np.array(line.split(), dtype=float) for line in open(sys.argv[1], encoding="ascii")]
axes, offsets, home = np.array(rows[:6]), np.array(rows[6:13]), rows[13].reshape(3, 3)
poses = [row.reshape(4, 4) for row in rows[14:]]
for pose in poses:
    pose[:3, :3] = pose[:3, :3] @ home.T  # EAIK's tip has the base's axes at home
robot = HPRobot(axes, offsets)

rounds = []
for _ in range(15):
    begin = time.perf_counter_ns()
    for pose in poses:
        robot.IK(pose)
    rounds.append((time.perf_counter_ns() - begin) / len(poses))

answers, good, worst_m, worst_rad = 0, 0, 0.0, 0.0
for pose in poses:
    found = robot.IK(pose)
    for q, least_squares in zip(found.Q, found.is_LS):
        if least_squares:
            continue
        answers += 1
        R, p = forward(axes, offsets, q)
        off_m = np.linalg.norm(p - pose[:3, 3])
        off_rad = np.linalg.norm(R - pose[:3, :3]) / np.sqrt(2)
        if off_m <= 1e-6 and off_rad <= 1e-6:
            good += 1
            worst_m, worst_rad = max(worst_m, off_m), max(worst_rad, off_rad)
print(importlib.metadata.version("EAIK"), sorted(rounds)[7], answers, good / max(answers, 1), worst_m, worst_rad)
