"""Usage: urdf_peers.py UNDERACT_CLI [POSES]. Compares `underact-cli fk`, `jacobian` and `ik` with
Pinocchio (PyPI: pin) on the URDF files of example-robot-data (PyPI). For each robot, at POSES
(10000) random joints: the largest differences of the position (mm), of the entries of the rotation,
and of the Jacobian (m and rad). For the first thousand: how far the answers of `ik` are from the
pose by Pinocchio's kinematics (m and rad), how many there are, and for how many poses there are
none. Ends with 1 where a difference is above 1e-10 mm or 1e-11, an answer of `ik` is off by more
than 1e-9, or a closed form finds none; with 0, SKIPPED, where a module is not installed."""

import importlib.metadata
import json
import os
import pathlib
import subprocess
import sys
import tempfile

try:
    import numpy as np
    import pinocchio as pin

    ROBOTS = importlib.metadata.version("example-robot-data")
except ImportError as error:  # also where a package is not there
    print(f"SKIPPED: {error}.")
    sys.exit(0)

MAX_MM, MAX_J = 1e-10, 1e-11
MAX_IK = 1.001e-9  # the iteration stops below 1e-9 by its own kinematics
FOR_INVERSE = 1000

# A file, and the links between which the arm lies; one arm of each robot.
ARMS = [
    ("ur3_robot.urdf", "base_link", "tool0"),
    ("ur5_robot.urdf", "base_link", "tool0"),
    ("ur10_robot.urdf", "base_link", "tool0"),
    ("panda.urdf", "panda_link0", "panda_hand_tcp"),
    ("kinova.urdf", "base", "j2s6s200_end_effector"),
    ("xarm7.urdf", "link_base", "link7"),
    ("z1.urdf", "link00", "link06"),
    ("so101.urdf", "base_link", "gripper_frame_link"),
    ("baxter.urdf", "torso", "left_hand_link"),
    ("pr2.urdf", "base_link", "r_gripper_palm_link"),  # its torso slides
    ("tiago.urdf", "base_link", "arm_7_link"),  # and that of the next
    ("tiago_pro.urdf", "base_link", "arm_left_7_link"),
    ("talos_reduced.urdf", "torso_2_link", "arm_left_7_link"),
    ("icub.urdf", "chest", "l_hand"),
    ("centauro.urdf", "pelvis", "ball1_tip"),
    ("solo12.urdf", "base_link", "FL_FOOT"),
    ("TwoDofs.urdf", "world", "Tip"),
]


def files():
    """The path of each URDF file of the package, by its name."""
    listed = importlib.metadata.files("example-robot-data") or []
    return {file.name: str(file.locate()) for file in listed if file.suffix == ".urdf"}


def run(cli, *words, text=""):
    """What a command prints; its problems as an exception."""
    done = subprocess.run([cli, *words], input=text, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise RuntimeError((done.stderr or done.stdout).strip())
    return done.stdout


def answers(cli, command, arm, lines, *more):
    """The answers of a command to lines, as objects."""
    text = "".join(json.dumps(line) + "\n" for line in lines)
    out = run(cli, command, "--arm", arm, *more, text=text)
    return [json.loads(line) for line in out.splitlines()]


class Peer:
    """The arm as Pinocchio has it: pose and Jacobian of the tip, in the frame of the base."""

    def __init__(self, urdf, base, tip, joints):
        self.model = pin.buildModelFromUrdf(urdf)
        self.data = self.model.createData()
        self.base, self.tip = self.model.getFrameId(base), self.model.getFrameId(tip)
        self.joints = [self.model.joints[self.model.getJointId(one["name"])] for one in joints]
        self.slides = np.array([one["type"] == "prismatic" for one in joints])

    def at(self, q):
        """q: rad and mm. Gives the pose (m) and the Jacobian (m and rad, also per m)."""
        full = pin.neutral(self.model)
        for joint, value, slides in zip(self.joints, q, self.slides):
            if joint.nq == 2:  # a continuous one
                full[joint.idx_q : joint.idx_q + 2] = np.cos(value), np.sin(value)
            else:
                full[joint.idx_q] = value / 1000 if slides else value
        pin.computeJointJacobians(self.model, self.data, full)
        pin.updateFramePlacements(self.model, self.data)
        base = self.data.oMf[self.base]
        all_columns = pin.getFrameJacobian(self.model, self.data, self.tip, pin.LOCAL_WORLD_ALIGNED)
        columns = all_columns[:, [joint.idx_v for joint in self.joints]]
        return base.actInv(self.data.oMf[self.tip]), np.kron(np.eye(2), base.rotation.T) @ columns


def compare(cli, urdf, base, tip, poses):
    """A line of the table, and whether it is bad."""
    poe = run(cli, "arm", "convert", urdf, "--base", base, "--tip", tip, "--to", "poe")
    joints = json.loads(poe)["joints"]
    peer = Peer(urdf, base, tip, joints)
    q = np.random.default_rng(1).uniform(-np.pi, np.pi, (poses, len(joints)))
    q[:, peer.slides] *= 100.0  # mm
    with tempfile.TemporaryDirectory() as folder:
        arm = os.path.join(folder, "arm.json")
        pathlib.Path(arm).write_text(poe, encoding="utf-8")
        lines = [{"q_rad": list(row)} for row in q]
        ours = answers(cli, "fk", arm, lines)
        slopes = answers(cli, "jacobian", arm, lines)
        inverse = answers(cli, "ik", arm, ours[:FOR_INVERSE])
    worst = np.zeros(3)
    for row, pose, slope in zip(q, ours, slopes):
        X, J = np.array(pose["X_WT"]), np.array(slope["J"])
        J[:3] /= 1000
        J[:, peer.slides] *= 1000
        M, J_peer = peer.at(row)
        off = (M.translation * 1000 - X[:3, 3], M.rotation - X[:3, :3], J_peer - J)
        worst = np.maximum(worst, [np.abs(one).max() for one in off])
    off_ik, count, missed, closed = 0.0, 0, 0, False
    for pose, answer in zip(ours, inverse):
        X = np.array(pose["X_WT"])
        X[:3, 3] /= 1000
        solutions = answer["solutions"]
        count += len(solutions)
        missed += not solutions
        for one in solutions:
            closed |= one["branch"] is not None
            M, _ = peer.at(one["q_rad"])
            off_ik = max(off_ik, np.linalg.norm(M.translation - X[:3, 3]))
            if len(joints) > 3:  # of fewer, `ik` asks for the position
                off_ik = max(off_ik, np.linalg.norm(M.rotation - X[:3, :3]) / np.sqrt(2))
    bad = worst[0] > MAX_MM or worst[1:].max() > MAX_J or off_ik > MAX_IK or (closed and missed)
    return (
        f"{len(joints)} joints  fk {worst[0]:.1e} mm {worst[1]:.1e}  J {worst[2]:.1e}"
        f"  ik {off_ik:.1e}, {count / len(inverse):.2f} {'closed' if closed else 'numeric'}"
        f", none for {missed}{'  <- bad' if bad else ''}",
        bad,
    )


def main():
    cli, poses = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 10000
    found, failed, compared = files(), False, 0
    print(f"pin {pin.__version__}, example-robot-data {ROBOTS}, {poses} poses")
    for name, base, tip in ARMS:
        if name not in found:
            continue
        try:
            line, bad = compare(cli, found[name], base, tip, poses)
        except RuntimeError as error:
            line, bad = str(error), True
        print(f"{name:24} {line}", flush=True)
        failed |= bad
        compared += 1
    print(f"{compared} robots")
    return 1 if failed or compared < 10 else 0


sys.exit(main())
