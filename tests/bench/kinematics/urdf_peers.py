"""Usage: urdf_peers.py UNDERACT_CLI [POSES]. Compares `underact-cli fk` and `jacobian` with Pinocchio (PyPI: pin) on the
URDF files of example-robot-data (PyPI): every robot with a serial chain of one to eight joints. Prints, for each, the
largest differences of the pose (mm, and of the rotation's entries) and of the Jacobian; ends with 1 where one is above
1e-10 mm or 1e-11."""
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
import pinocchio as pin

try:
    from example_robot_data import path as found

    DATA = pathlib.Path(found.EXAMPLE_ROBOT_DATA_MODEL_DIR)
except ImportError:
    from example_robot_data.robots_loader import getModelPath

    DATA = pathlib.Path(getModelPath("ur_description")) / "example-robot-data/robots"

# File, base and tip of one arm of each robot.
ARMS = [
    ("ur_description/urdf/ur3_robot.urdf", "base_link", "tool0"),
    ("ur_description/urdf/ur5_robot.urdf", "base_link", "tool0"),
    ("ur_description/urdf/ur10_robot.urdf", "base_link", "tool0"),
    ("panda_description/urdf/panda.urdf", "panda_link0", "panda_link8"),
    ("iris_description/robots/iris_simple.urdf", None, None),
    ("kinova_description/robots/kinova.urdf", "base_link", "j2s6s200_end_effector"),
    ("xarm_description/urdf/xarm7.urdf", "link_base", "link7"),
    ("fetch_description/robots/fetch.urdf", "torso_lift_link", "gripper_link"),
    ("tiago_description/robots/tiago.urdf", "torso_lift_link", "arm_7_link"),
    ("baxter_description/urdf/baxter.urdf", "torso", "left_gripper_base"),
    ("double_pendulum_description/urdf/double_pendulum.urdf", None, None),
    ("ur_description/urdf/ur5_gripper.urdf", "base_link", "tool0"),
    ("talos_data/robots/talos_reduced.urdf", "torso_2_link", "arm_left_7_link"),
    ("tiago_pro_description/robots/tiago_pro.urdf", "torso_lift_link", "arm_left_7_link"),
    ("z1_description/urdf/z1.urdf", "link00", "link06"),
    ("so_arm101_description/urdf/so_arm101.urdf", None, None),
]


def ends_of(model):
    """The first and the last link of the longest chain."""
    bodies = [f for f in model.frames if f.type == pin.FrameType.BODY]
    return bodies[0].name, bodies[-1].name


def ask(cli, command, arm, lines):
    done = subprocess.run(
        [cli, command, "--arm", arm], input="\n".join(lines) + "\n", capture_output=True, text=True, check=False
    )
    if done.returncode != 0:
        raise RuntimeError(done.stderr or done.stdout[:300])
    return [json.loads(line) for line in done.stdout.splitlines()]


def compare(cli, urdf, base, tip, poses):
    """Largest differences of the pose's position (mm) and rotation, and of the Jacobian (mm and rad)."""
    model = pin.buildModelFromUrdf(str(urdf))
    data = model.createData()
    if base is None:
        base, tip = ends_of(model)
    with tempfile.NamedTemporaryFile("w", suffix=".json") as arm:
        done = subprocess.run(
            [cli, "arm", "convert", str(urdf), "--base", base, "--tip", tip, "--to", "poe"],
            capture_output=True, text=True, check=False,
        )
        if done.returncode != 0:
            raise RuntimeError(done.stderr)
        arm.write(done.stdout)
        arm.flush()
        joints = json.loads(done.stdout)["joints"]
        slides = np.array([joint["type"] == "prismatic" for joint in joints])
        rng = np.random.default_rng(1)
        q = rng.uniform(-np.pi, np.pi, (poses, len(joints)))
        q[:, slides] *= 100.0  # mm
        lines = [json.dumps({"q_rad": list(row)}) for row in q]
        X = np.array([answer["X_WT"] for answer in ask(cli, "fk", arm.name, lines)])
        J = [np.array(answer["J"]) for answer in ask(cli, "jacobian", arm.name, lines)]
    ids = [model.getJointId(joint["name"]) for joint in joints]
    base_id, tip_id = model.getFrameId(base), model.getFrameId(tip)
    worst = np.zeros(3)
    for row, X_ours, J_ours in zip(q, X, J):
        full = pin.neutral(model)
        for joint, value, slide in zip(ids, row, slides):
            at = model.joints[joint].idx_q
            if model.joints[joint].nq == 2:
                full[at], full[at + 1] = np.cos(value), np.sin(value)
            else:
                full[at] = value / 1000.0 if slide else value
        pin.computeJointJacobians(model, data, full)
        pin.updateFramePlacements(model, data)
        base_now = data.oMf[base_id]
        M = base_now.actInv(data.oMf[tip_id])
        J_all = pin.getFrameJacobian(model, data, tip_id, pin.LOCAL_WORLD_ALIGNED)
        turn = np.kron(np.eye(2), base_now.rotation.T)
        theirs = turn @ J_all[:, [model.joints[joint].idx_v for joint in ids]]
        theirs[:3] *= 1000.0
        theirs[:, slides] /= 1000.0
        worst[0] = max(worst[0], np.abs(M.translation * 1000.0 - X_ours[:3, 3]).max())
        worst[1] = max(worst[1], np.abs(M.rotation - X_ours[:3, :3]).max())
        worst[2] = max(worst[2], np.abs((theirs - J_ours) / np.array([[1000.0]] * 3 + [[1.0]] * 3)).max())
    return len(joints), worst


def main():
    cli, poses = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 10000
    failed, compared = False, 0
    for name, base, tip in ARMS:
        urdf = DATA / name
        if not urdf.exists():
            continue
        try:
            joints, worst = compare(cli, urdf, base, tip, poses)
        except RuntimeError as error:
            print(f"{name:58} {str(error).strip()[:150]}")
            continue
        compared += 1
        bad = worst[0] > 1e-10 or worst[1] > 1e-11 or worst[2] > 1e-11
        failed |= bad
        print(f"{name:58} {joints} joints {worst[0]:.1e} mm {worst[1]:.1e} J {worst[2]:.1e} {'<-' if bad else ''}")
    print(f"{compared} robots, {poses} poses each")
    sys.exit(1 if failed or compared == 0 else 0)


main()
