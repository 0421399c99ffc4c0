"""The package underact beside C++, Pinocchio, KDL, Robotics Toolbox and EAIK, on the same arm, in one run: `python beside_others.py`.

Each is left out where it is not installed (`pip install pin roboticstoolbox-python EAIK`; python3-pykdl). Prints microseconds a pose,
the best of several runs, and how far the poses of the others are from ours.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

from underact import arm


def best_us(call: Callable[[], object], poses: int, repeats: int) -> float:
    """Microseconds for each pose, of the fastest of so many runs."""
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        call()
        times.append(time.perf_counter() - start)
    return 1e6 * min(times) / poses


def each_us(call: Callable[[object], object], given: list, repeats: int) -> float:
    """The same of one call after the other, whose results are not kept."""

    def all_() -> None:
        for one in given:
            call(one)

    return best_us(all_, len(given), repeats)


def ours(name: str, q: np.ndarray, repeats: int) -> np.ndarray:
    """Prints our rows; gives the poses of q."""
    loaded = arm.load(name)
    X = loaded.fk(q)
    count, one, one_X = len(q), q[0].copy(), X[0].copy()
    rows = {
        "fk, an array": best_us(lambda: loaded.fk(q), count, repeats),
        "jacobian, an array": best_us(lambda: loaded.jacobian(q), count, repeats),
        "ik (all), an array": best_us(lambda: loaded.ik(X), count, repeats),
        "fk, one by one": each_us(loaded.fk, [one] * 1000, repeats),
        "ik (all), one by one": each_us(loaded.ik, [one_X] * 1000, repeats),
    }
    for what, us in rows.items():
        print(f"{'underact':22}{what:24}{us:10.3f} us")
    return X


def cpp(name: str, q: np.ndarray, X: np.ndarray, repeats: int) -> None:
    """The same functions in C++, of the Omni alone."""
    built = Path(__file__).resolve().parents[3] / "build/release/tests/bench/python/underact-array-bench"
    program = Path(os.environ.get("UNDERACT_ARRAY_BENCH", built))
    if name != "omni-thesis" or not program.exists():
        raise ImportError(f"{program} is not built, or the arm is not omni-thesis")
    done = subprocess.run([program, str(len(q))], capture_output=True, text=True, check=True)
    for line in done.stdout.splitlines():
        what, ns = line.split()
        print(f"{'C++':22}{what + ', an array':24}{float(ns) / 1e3:10.3f} us")


def axes_of(name: str) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """At home: (n, 3), the axes' directions; (n, 3), a point on each, mm; the pose of the tip."""
    loaded = arm.load(name)
    at = np.zeros(loaded.n)
    return loaded.jacobian(at)[3:].T, loaded.skeleton(at)[1:-1], loaded.fk(at)


def kdl(name: str, q: np.ndarray, X: np.ndarray, repeats: int) -> None:
    """KDL's solvers, of the same axes."""
    import PyKDL

    axes, points, home = axes_of(name)
    chain = PyKDL.Chain()
    before = np.zeros(3)
    for axis, point in zip(axes, points):
        joint = PyKDL.Joint("joint", PyKDL.Vector(), PyKDL.Vector(*axis), PyKDL.Joint.RotAxis)
        # A segment turns about its beginning and ends where the next one begins.
        chain.addSegment(PyKDL.Segment("to", PyKDL.Joint(PyKDL.Joint.Fixed), PyKDL.Frame(PyKDL.Vector(*(point - before)))))
        chain.addSegment(PyKDL.Segment("turns", joint))
        before = point
    tip = PyKDL.Frame(PyKDL.Rotation(*home[:3, :3].ravel()), PyKDL.Vector(*(home[:3, 3] - before)))
    chain.addSegment(PyKDL.Segment("tip", PyKDL.Joint(PyKDL.Joint.Fixed), tip))
    solver, frame = PyKDL.ChainFkSolverPos_recursive(chain), PyKDL.Frame()
    given = []
    for one in q[:2000]:
        joints = PyKDL.JntArray(len(one))
        for i, value in enumerate(one):
            joints[i] = value
        given.append(joints)
    far_mm = 0.0
    for joints, pose in zip(given[:100], X):
        solver.JntToCart(joints, frame)
        far_mm = max(far_mm, max(abs(frame.p[i] - pose[i, 3]) for i in range(3)))
    us = each_us(lambda joints: solver.JntToCart(joints, frame), given, repeats)
    print(f"{'KDL':22}{'fk, one by one':24}{us:10.3f} us   {far_mm:.1e} mm from ours")
    jacobians, J = PyKDL.ChainJntToJacSolver(chain), PyKDL.Jacobian(len(q[0]))
    us = each_us(lambda joints: jacobians.JntToJac(joints, J), given, repeats)
    print(f"{'KDL':22}{'jacobian, one by one':24}{us:10.3f} us")


def pinocchio(name: str, q: np.ndarray, X: np.ndarray, repeats: int) -> None:
    """Its forward kinematics and Jacobian, of the same axes, in m."""
    import pinocchio

    model, parent, before = pinocchio.Model(), 0, np.zeros(3)
    axes, points, home = axes_of(name)
    for number, (axis, point) in enumerate(zip(axes, points)):
        placed = pinocchio.SE3(np.eye(3), 1e-3 * (point - before))
        parent = model.addJoint(parent, pinocchio.JointModelRevoluteUnaligned(*axis), placed, f"q{number + 1}")
        before = point
    placed = pinocchio.SE3(home[:3, :3].copy(), 1e-3 * (home[:3, 3] - before))
    tip = model.addFrame(pinocchio.Frame("tip", parent, placed, pinocchio.FrameType.OP_FRAME))
    data = model.createData()

    def forward(one: np.ndarray) -> np.ndarray:
        pinocchio.framesForwardKinematics(model, data, one)
        return data.oMf[tip].homogeneous

    far_mm = max(np.abs(1e3 * forward(one)[:3, 3] - pose[:3, 3]).max() for one, pose in zip(q[:100], X))
    some = q[:2000]
    us = each_us(forward, list(some), repeats)
    print(f"{'pinocchio':22}{'fk, one by one':24}{us:10.3f} us   {far_mm:.1e} mm from ours")
    frame = pinocchio.ReferenceFrame.LOCAL_WORLD_ALIGNED
    us = each_us(lambda one: pinocchio.computeFrameJacobian(model, data, one, tip, frame), list(some), repeats)
    print(f"{'pinocchio':22}{'jacobian, one by one':24}{us:10.3f} us")


def toolbox(name: str, q: np.ndarray, X: np.ndarray, repeats: int) -> None:
    """Its forward kinematics and an iteration, of the same axes."""
    import roboticstoolbox

    transforms = roboticstoolbox.ETS()
    axes, points, tip = axes_of(name)
    home = np.eye(4)
    # Each joint as a turn about the z axis of a frame on it: the pose of the frame at home, then back.
    for z, point in zip(axes, points):
        x = np.cross(z, np.eye(3)[np.argmin(np.abs(z))])
        x /= np.linalg.norm(x)
        frame = np.eye(4)
        frame[:3, :3] = np.column_stack([x, np.cross(z, x), z])
        frame[:3, 3] = point
        transforms = transforms * roboticstoolbox.ET.SE3(np.linalg.inv(home) @ frame) * roboticstoolbox.ET.Rz()
        home = frame
    transforms = transforms * roboticstoolbox.ET.SE3(np.linalg.inv(home) @ tip)
    far_mm = np.abs(np.array([transforms.eval(one)[:3, 3] for one in q[:100]]) - X[:100, :3, 3]).max()
    some = q[:2000]
    us = best_us(lambda: transforms.fkine(some), len(some), repeats)
    print(f"{'roboticstoolbox':22}{'fk, an array':24}{us:10.3f} us   {far_mm:.1e} mm from ours")
    us = each_us(transforms.eval, list(some), repeats)
    print(f"{'roboticstoolbox':22}{'fk, one by one':24}{us:10.3f} us")
    few = X[:100]
    us = each_us(transforms.ik_LM, list(few), 1)
    print(f"{'roboticstoolbox':22}{'ik (one), one by one':24}{us:10.3f} us")


def eaik(name: str, q: np.ndarray, X: np.ndarray, repeats: int) -> None:
    """Its inverse kinematics, all solutions, of the same axes. Its tip has the base's axes at home."""
    from eaik.IK_HP import HPRobot

    axes, points, home = axes_of(name)
    points = 1e-3 * np.vstack([np.zeros(3), points, home[:3, 3]])
    robot = HPRobot(axes, np.diff(points, axis=0))
    poses = X[:2000].copy()
    poses[:, :3, 3] *= 1e-3
    poses[:, :3, :3] = poses[:, :3, :3] @ home[:3, :3].T
    us = each_us(robot.IK, list(poses), repeats)
    print(f"{'EAIK':22}{'ik (all), one by one':24}{us:10.3f} us")


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--arm", default="omni-thesis")
    options.add_argument("--poses", type=int, default=100_000)
    options.add_argument("--repeats", type=int, default=5)
    given = options.parse_args()
    loaded = arm.load(given.arm)
    q = np.random.default_rng(1).uniform(-2.5, 2.5, (given.poses, loaded.n))
    print(f"{given.arm}, {given.poses} poses")
    X = ours(given.arm, q, given.repeats)
    for other in (cpp, pinocchio, kdl, toolbox, eaik):
        try:
            other(given.arm, q, X, given.repeats)
        except ImportError as error:
            print(f"{other.__name__:22}SKIPPED: {error}")


if __name__ == "__main__":
    main()
