"""Usage: PYTHONPATH=build/release/python arm_peers.py UNDERACT_CLI [POSES]. Inverse kinematics of
the arms that ship, in one run: this program's (the module underact), Orocos KDL's (Debian:
python3-pykdl), Pinocchio's (PyPI: pin; its iteration is the example of its manual, in Python), the
Robotics Toolbox's (roboticstoolbox-python) and EAIK's. POSES (1000) random configurations within
the limits of each arm; each pose is one call from Python. Prints for each arm and method the
microseconds of processor time per pose (the least of five rounds), the share of poses that are
solved, how many solutions there are on average, and the largest error of a solution, by Pinocchio's
kinematics, m and rad. Solved: within 1e-6 m and rad. A peer that is not installed is left out, but
for Pinocchio, without which nothing is compared (0, SKIPPED)."""

import importlib
import json
import pathlib
import subprocess
import sys
import time

try:
    import numpy as np
    import pinocchio as pin
    from underact import arm as underact_arm
except ImportError as error:
    print(f"SKIPPED: {error}.")
    sys.exit(0)

ARMS = ("puma-560", "ur5e", "kr5", "stanford", "panda", "iiwa7")
ROUNDS = 5
OFF_RAD = 0.1  # of each joint, or tens of mm where it slides, from the joints that solve the pose
GOOD = 1e-6


def optional(name):
    """A module, or None."""
    try:
        return importlib.import_module(name)
    except ImportError:
        return None


def text_of(cli, name, form):
    """The arm in another form."""
    words = [cli, "arm", "convert", name, "--to", form]
    return subprocess.run(words, capture_output=True, check=True).stdout.decode()


class Case:
    """An arm with its poses: in SI, joints that slide in m."""

    def __init__(self, cli, name, poses):
        self.ours = underact_arm.load(name)
        self.poe = json.loads(text_of(cli, name, "poe"))
        self.urdf = text_of(cli, name, "urdf")
        self.model = pin.buildModelFromXML(self.urdf)
        self.data = self.model.createData()
        self.tip = self.model.getFrameId("tip")
        self.slides = np.array([not joint.turns for joint in self.ours.joints])
        low, high = np.array([(joint.min, joint.max) for joint in self.ours.joints]).T
        low, high = np.maximum(low, -np.pi), np.where(self.slides, high, np.minimum(high, np.pi))
        rng = np.random.default_rng(32)
        self.q_mm = rng.uniform(low, high, (poses, len(low)))
        self.q = np.where(self.slides, self.q_mm / 1000, self.q_mm)
        off = rng.uniform(-OFF_RAD, OFF_RAD, self.q.shape)
        self.near = self.q + np.where(self.slides, off / 10, off)
        self.X_mm = self.ours.fk(self.q_mm)
        self.X = self.X_mm.copy()
        self.X[:, :3, 3] /= 1000

    def full(self, q):
        """q as Pinocchio has it: two numbers for a joint without limits."""
        parts = [np.atleast_1d(v) for v in q]
        for i, joint in enumerate(list(self.model.joints)[1:]):
            if joint.nq == 2:
                parts[i] = np.array([np.cos(q[i]), np.sin(q[i])])
        return np.concatenate(parts)

    def error(self, q, X):
        """How far its tip is from X, m and rad, the larger."""
        pin.framesForwardKinematics(self.model, self.data, self.full(q))
        M = self.data.oMf[self.tip]
        off = np.linalg.norm(M.translation - X[:3, 3])
        return max(off, np.linalg.norm(M.rotation - X[:3, :3]) / np.sqrt(2))

    def row(self, what, solve, solve_all=None):
        """solve(i): the solutions of pose i, a list of joint values in SI. solve_all(): the same of
        all poses in one call, to be timed as well. Prints a line.
        """
        least, least_all = np.inf, np.inf
        for _ in range(ROUNDS):
            begin = time.process_time_ns()
            found = [solve(i) for i in range(len(self.X))]
            between = time.process_time_ns()
            least = min(least, (between - begin) / len(self.X) / 1000)
            if solve_all is not None:
                solve_all()
                least_all = min(least_all, (time.process_time_ns() - between) / len(self.X) / 1000)
        errors = [[self.error(q, X) for q in all_q] for all_q, X in zip(found, self.X)]
        good = [[one for one in all_errors if one <= GOOD] for all_errors in errors]
        solved = sum(bool(one) for one in good) / len(good)
        count = sum(map(len, good)) / len(good)
        worst = max((max(one) for one in good if one), default=float("nan"))
        together = f", all in one call {least_all:.1f} us" if solve_all is not None else ""
        figures = f"{least:8.1f} us  {100 * solved:5.1f} %  {count:5.2f}  {worst:.0e}"
        print(f"  {what:50} {figures}{together}", flush=True)


def ours(case):
    """This program's."""

    def values(found):
        q = found.q[: int(found.count)]
        return np.where(case.slides, q / 1000, q)

    near_mm = np.where(case.slides, case.near * 1000, case.near)
    if case.ours.ik(case.X_mm[0]).branch:
        case.row(
            "Underact, closed form, all solutions",
            lambda i: values(case.ours.ik(case.X_mm[i])),
            lambda: case.ours.ik(case.X_mm),
        )
    case.row(
        "Underact, iteration, from 0.1 rad off",
        lambda i: values(case.ours.ik(case.X_mm[i], method="iterative", prefer=near_mm[i])),
    )
    case.row(
        "Underact, iteration, from anywhere",
        lambda i: values(case.ours.ik(case.X_mm[i], method="iterative")),
        lambda: case.ours.ik(case.X_mm, method="iterative"),
    )


def pinocchio(case):
    """Its manual's damped iteration, at most 200 steps."""

    def solve(i):
        q = case.full(case.near[i])
        goal = pin.SE3(case.X[i])
        for _ in range(200):
            pin.framesForwardKinematics(case.model, case.data, q)
            off = case.data.oMf[case.tip].actInv(goal)
            error = pin.log(off).vector
            if np.linalg.norm(error) < 1e-9:
                break
            J = pin.computeFrameJacobian(case.model, case.data, q, case.tip, pin.LOCAL)
            J = -pin.Jlog6(off.inverse()) @ J
            step = -J.T @ np.linalg.solve(J @ J.T + 1e-12 * np.eye(6), error)
            q = pin.integrate(case.model, q, step)
        values, at = [], 0
        for joint in list(case.model.joints)[1:]:
            both = q[at : at + joint.nq]
            values.append(np.arctan2(both[1], both[0]) if joint.nq == 2 else both[0])
            at += joint.nq
        return [np.array(values)]

    case.row("Pinocchio, iteration in Python, from 0.1 rad off", solve)


def kdl(case):
    """Levenberg and Marquardt, without restarts."""
    kdl_module = optional("PyKDL")
    if kdl_module is None:
        return
    k = kdl_module
    chain, last = k.Chain(), np.zeros(3)
    chain.addSegment(k.Segment(k.Joint("base", k.Joint.Fixed), k.Frame()))
    home = np.array(case.poe["X_WT_home"])
    places = [np.array(j.get("point_mm", [0, 0, 0])) / 1000 for j in case.poe["joints"]]
    for i, joint in enumerate(case.poe["joints"]):
        slides = joint["type"] == "prismatic"
        place = last if slides else places[i]
        way = k.Frame(k.Vector(*(place - last)))
        chain.addSegment(k.Segment(k.Joint(f"to{i}", k.Joint.Fixed), way))
        kind = k.Joint.TransAxis if slides else k.Joint.RotAxis
        one = k.Joint(f"j{i}", k.Vector(0, 0, 0), k.Vector(*joint["axis"]), kind)
        chain.addSegment(k.Segment(one, k.Frame()))
        last = place
    R = k.Rotation(*home[:3, :3].flatten())
    tip = k.Frame(R, k.Vector(*(home[:3, 3] / 1000 - last)))
    chain.addSegment(k.Segment(k.Joint("tip", k.Joint.Fixed), tip))
    solver = k.ChainIkSolverPos_LMA(chain, 1e-9)
    count = len(places)

    def solve(i):
        start, q = k.JntArray(count), k.JntArray(count)
        for joint in range(count):
            start[joint] = case.near[i][joint]
        X = case.X[i]
        goal = k.Frame(k.Rotation(*X[:3, :3].flatten()), k.Vector(*X[:3, 3]))
        solver.CartToJnt(start, goal, q)
        return [np.array([q[joint] for joint in range(count)])]

    case.row("Orocos KDL, LMA, from 0.1 rad off", solve)


def toolbox(case):
    """Levenberg and Marquardt in C++, from near, and with its 100 restarts."""
    toolbox_module = optional("roboticstoolbox")
    if toolbox_module is None:
        return
    ET, last, ets = toolbox_module.ET, np.eye(4), None
    for joint in case.poe["joints"]:
        z = np.array(joint["axis"])
        x = np.cross(z, np.eye(3)[np.argmin(abs(z))])
        x /= np.linalg.norm(x)
        X = np.eye(4)
        X[:3, :3] = np.column_stack([x, np.cross(z, x), z])
        X[:3, 3] = np.array(joint.get("point_mm", last[:3, 3] * 1000)) / 1000
        moves = ET.tz() if joint["type"] == "prismatic" else ET.Rz()
        part = ET.SE3(np.linalg.inv(last) @ X) * moves
        ets, last = part if ets is None else ets * part, X
    home = np.array(case.poe["X_WT_home"], dtype=float)
    home[:3, 3] /= 1000
    ets = ets * ET.SE3(np.linalg.inv(last) @ home)

    def solve(start):
        def one(i):
            q0 = None if start is None else start[i]
            tries = 100 if start is None else 1
            found = ets.ik_LM(case.X[i], q0=q0, slimit=tries, tol=1e-14, joint_limits=False)
            return [np.array(found[0])] if found[1] else []

        return one

    case.row("Robotics Toolbox, LM, from 0.1 rad off", solve(case.near))
    case.row("Robotics Toolbox, LM, from anywhere", solve(None))


def eaik(case):
    """Closed forms, of six joints that turn."""
    eaik_module = optional("eaik.IK_HP")
    if eaik_module is None or case.slides.any() or len(case.slides) != 6:
        return
    axes = np.array([joint["axis"] for joint in case.poe["joints"]], dtype=float)
    home = np.array(case.poe["X_WT_home"], dtype=float)
    places = np.array([joint["point_mm"] for joint in case.poe["joints"]] + [home[:3, 3]]) / 1000
    offsets = np.vstack([places[:1], np.diff(places, axis=0)])
    robot = eaik_module.HPRobot(axes, offsets)
    poses = case.X.copy()
    poses[:, :3, :3] = poses[:, :3, :3] @ home[:3, :3].T  # its tip has the base's axes at home

    def solve(i):
        found = robot.IK(poses[i])
        return [q for q, least in zip(found.Q, found.is_LS) if not least]

    case.row("EAIK, closed form, all solutions", solve)


def main():
    """All arms."""
    cli, poses = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 1000
    cli = str(pathlib.Path(cli).resolve())
    for name in ARMS:
        case = Case(cli, name, poses)
        print(f"{name}: {len(case.slides)} joints, {poses} poses")
        for peer in (ours, kdl, pinocchio, toolbox, eaik):
            peer(case)
    return 0


sys.exit(main())
