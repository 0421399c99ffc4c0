"""Haply's clients drive the arm as an Inverse3, unchanged: their crate and Isaac Lab's driver are
fetched in the soak; a client in their way of talking is here always.
"""

from __future__ import annotations

import contextlib
import importlib.util
import json
import os
import shutil
import signal
import subprocess
import sys
import threading
import time
import types
import unittest
import urllib.error
import urllib.request
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import underact
from support import CLI, SOAK, InFolder, works

FAR = {  # nothing of it is ever felt: the force is the client's alone
    "underact_scene": 1,
    "title": "Nothing",
    "constraints": [
        {
            "name": "far",
            "type": "plane",
            "side": "outside",
            "point_mm": [0, -500, 0],
            "normal": [0, 1, 0],
        }
    ],
}
SPHERE = Path(__file__).parents[2] / "scenes/02_sphere.json"
CENTRE_H, RADIUS, STIFFNESS = np.array([0.0, -0.1, 0.18]), 0.05, 500.0  # of haptic_sample
ORIGIN_H = np.array([0.0, -0.12, 0.15])  # of W


def in_w(p_h: np.ndarray) -> np.ndarray:
    """A place of theirs in W, mm."""
    x, y, z = p_h - ORIGIN_H
    return 1e3 * np.array([x, z, -y])


class Served(InFolder):
    """A test with a service of its own."""

    @contextlib.contextmanager
    def service(self, port: int, *options: str) -> Iterator[subprocess.Popen[str]]:
        (self.folder / "far.json").write_text(json.dumps(FAR))
        words = [CLI, "serve", str(self.folder / "far.json"), "--port", "0", "--start"]
        words += ["--haply", str(port), "--record", str(self.folder / "haply.h5"), *options]
        surroundings = {**os.environ, "XDG_RUNTIME_DIR": str(self.folder)}
        process = subprocess.Popen(words, stdout=subprocess.PIPE, text=True, env=surroundings)
        try:
            self.said = json.loads(process.stdout.readline())
            self.url = self.said["haply"]
            yield process
            process.send_signal(signal.SIGTERM)
            self.assertEqual(process.wait(20), 0)
        finally:
            process.kill()
            process.wait()
            process.stdout.close()

    def rows(self) -> dict[str, np.ndarray]:
        with underact.Session(self.folder / "haply.h5") as session:
            names = ("p_WT_mm", "force_asked_N", "force_sent_N")
            return {name: np.asarray(session.ticks[name]) for name in names}

    def replays(self) -> None:
        words = [CLI, "replay", str(self.folder / "haply.h5"), "--verify"]
        done = subprocess.run(words, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def sphere_is_felt(self) -> None:
        """Where the tip was in the sphere, the force was what their code asks for there."""
        rows = self.rows()
        depth_mm = 1e3 * RADIUS - np.linalg.norm(rows["p_WT_mm"] - in_w(CENTRE_H), axis=1)
        asked_N = np.linalg.norm(rows["force_asked_N"], axis=1)
        inside = (depth_mm > 0.5) & (asked_N > 0)
        self.assertGreater(inside.sum(), 100, "the hand goes into the sphere")
        ratio = asked_N[inside] / (1e-3 * STIFFNESS * depth_mm[inside])
        self.assertLess(abs(np.median(ratio) - 1.0), 0.05)
        self.assertLess(rows["force_sent_N"].max(), 0.89, "the gate is over it")


CLIENT = """
import asyncio, json, sys, websockets
async def main(url):
    async with websockets.connect(url) as socket:
        told = json.loads(await socket.recv())
        print(json.dumps([told["inverse3"][0]["config"]["type"],
                          sorted(told["wireless_verse_grip"][0]["state"]["buttons"])]), flush=True)
        while True:
            place = [told["inverse3"][0]["state"]["cursor_position"][axis] for axis in "xyz"]
            away = [one - centre for one, centre in zip(place, (0.0, -0.1, 0.18))]
            far = sum(one * one for one in away) ** 0.5
            push = max(0.0, 500.0 * (0.05 - far)) / far
            force = {axis: push * one for axis, one in zip("xyz", away)}
            await socket.send(json.dumps({"inverse3": [{
                "device_id": told["inverse3"][0]["device_id"],
                "commands": {"set_cursor_force": {"values": force}}}]}))
            told = json.loads(await socket.recv())
asyncio.run(main(sys.argv[1]))
"""


@unittest.skipUnless(works("websockets"), "python3-websockets is not installed")
class Client(Served):
    def test_feels_a_sphere_and_killed_it_leaves_no_force(self) -> None:
        with self.service(0, "--hand", "probe"):
            words = [sys.executable, "-c", CLIENT, self.url]
            with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as client:
                first = json.loads(client.stdout.readline())
                self.assertEqual(first, ["inverse3", ["a", "b", "c"]])
                time.sleep(6.0)
                client.kill()
            time.sleep(0.5)
        self.sphere_is_felt()
        asked_N = np.linalg.norm(self.rows()["force_asked_N"], axis=1)
        self.assertEqual(asked_N[-300:].max(), 0.0)
        self.replays()

    def test_answers_over_http(self) -> None:
        with self.service(0):
            base = self.url.replace("ws", "http", 1)
            with urllib.request.urlopen(f"{base}/version") as answer:
                self.assertEqual(json.load(answer)["project_version"], "3.5.0")
            with urllib.request.urlopen(f"{base}/devices?session=:-1") as answer:
                self.assertEqual(json.load(answer)["inverse3"][0]["config"]["type"], "inverse3")
            with self.assertRaises(urllib.error.HTTPError) as refused:
                urllib.request.urlopen(f"{base}/nothing")
            self.assertEqual(refused.exception.code, 404)


class Ours(Served):
    """Both ends are ours: serve --haply, and the driver haply:HOST:PORT."""

    def run_words(self, seconds: float) -> list[object]:
        words = [CLI, "run", SPHERE, "--seconds", seconds, "--record", self.folder / "driven.h5"]
        return [str(word) for word in [*words, "--device", "haply:" + self.url[5:].strip("/")]]

    def driven(self) -> dict[str, np.ndarray]:
        with underact.Session(self.folder / "driven.h5") as session:
            names = ("p_WT_mm", "force_sent_N")
            return {name: np.asarray(session.ticks[name]) for name in names}

    def test_force_is_felt_there_and_both_sessions_replay(self) -> None:
        for _ in range(5):  # a busy machine holds up the service, which is a fault here
            with self.service(0, "--hand", "sweep", "--overwrite"):
                words = [*self.run_words(4.0), "--overwrite"]
                done = subprocess.run(words, capture_output=True, text=True)
                time.sleep(0.3)
            if done.returncode == 0:
                break
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        sent_N = self.driven()["force_sent_N"]
        asked_N = self.rows()["force_asked_N"]
        self.assertGreater(np.linalg.norm(sent_N, axis=1).max(), 0.5, "the hand meets the sphere")
        pushed = asked_N[np.linalg.norm(asked_N, axis=1) > 0]
        self.assertGreater(len(pushed), 2000)
        told = {tuple(np.round(row, 9)) for row in sent_N}
        # Its last ones come down to zero after the end of what it records.
        known = np.array([tuple(np.round(row, 9)) in told for row in pushed[:-100]])
        self.assertGreater(known.mean(), 0.999, "what is asked there was sent here")
        self.assertEqual(np.abs(asked_N[-200:]).max(), 0.0, "its end is the end of its force")
        self.replays()
        words = [CLI, "replay", str(self.folder / "driven.h5"), "--verify"]
        self.assertEqual(subprocess.run(words, capture_output=True).returncode, 0)
        away_mm = np.linalg.norm(self.driven()["p_WT_mm"][2000] - self.rows()["p_WT_mm"], axis=1)
        self.assertLess(away_mm.min(), 1e-6, "the tip here is the tip there")

    def test_killed_in_mid_push_it_leaves_no_force(self) -> None:
        with self.service(0, "--hand", "sweep"):
            with subprocess.Popen(self.run_words(60.0), stdout=subprocess.DEVNULL) as driven:
                time.sleep(3.0)
                driven.kill()
            time.sleep(0.5)
        asked_N = np.linalg.norm(self.rows()["force_asked_N"], axis=1)
        self.assertGreater(asked_N.max(), 0.3)
        self.assertEqual(asked_N[-300:].max(), 0.0)

    def test_a_service_that_ends_is_a_fault_with_a_sentence(self) -> None:
        with self.service(0, "--hand", "sweep"):
            driven = subprocess.Popen(
                self.run_words(6.0), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True
            )
            time.sleep(2.0)
        said = driven.communicate(timeout=30)[1]
        self.assertEqual(driven.returncode, 3, said)
        self.assertIn("Haply's service at 127.0.0.1:", said)


READER = """
use haply::device_model::{ServiceData, ServiceMsg, ServiceState};
fn main() {
    let text = std::fs::read_to_string(std::env::args().nth(1).unwrap()).unwrap();
    let mut count = 0;
    for line in text.lines() {
        let (kind, message) = line.split_once(' ').unwrap();
        match kind {
            "full" => {
                let data: ServiceData = serde_json::from_str(message).unwrap();
                assert!(data.inverse3[0].config.is_some());
                assert!(data.wireless_verse_grip[0].config.is_some());
                assert!(data.inverse3[0].state.cursor_position.is_some());
            }
            "state" => { serde_json::from_str::<ServiceState>(message).unwrap(); }
            "frame" => {
                let mut all: serde_json::Value = serde_json::from_str(message).unwrap();
                for list in ["inverse3", "verse_grip", "wireless_verse_grip"] {
                    // It leaves empty lists out when it writes, and wants them when it reads.
                    all.as_object_mut().unwrap().entry(list).or_insert(serde_json::json!([]));
                }
                let frame: ServiceMsg = serde_json::from_value(all).unwrap();
                for arm in &frame.inverse3 {
                    let force = arm.commands.as_ref().unwrap().set_cursor_force.unwrap();
                    assert!(force.execute && force.vector.x == 0.5);
                }
            }
            _ => panic!("{kind}"),
        }
        count += 1;
    }
    println!("{count} read");
}
"""


@unittest.skipUnless(SOAK and shutil.which("cargo"), "only the soak fetches the crate, with cargo")
class Crate(Served):
    def probe(self, main: str, also: str = "") -> Path:
        """A program of one file that has the crate."""
        probe = self.folder / "probe"
        (probe / "src").mkdir(parents=True)
        (probe / "src/main.rs").write_text(main)
        (probe / "Cargo.toml").write_text(
            '[package]\nname = "probe"\nversion = "0.0.0"\nedition = "2021"\n'
            '[dependencies]\nhaply = "=1.3.1"\n' + also
        )
        return probe

    def examples(self) -> Path:
        """The crate's examples, built as they stand in it."""
        probe = self.probe("fn main() {}\n")
        said = subprocess.check_output(
            ["cargo", "metadata", "--format-version", "1"], cwd=probe, stderr=subprocess.DEVNULL
        )
        found = [one for one in json.loads(said)["packages"] if one["name"] == "haply"]
        source = self.folder / "haply"
        shutil.copytree(Path(found[0]["manifest_path"]).parent, source)
        subprocess.run(["cargo", "build", "--examples"], cwd=source, check=True)
        return source / "target/debug/examples"

    def test_messages_are_read_by_its_types(self) -> None:
        """Those of the driver, and of the stand-in of its tests."""
        written = self.folder / "messages"
        words = [str(Path(CLI).parent / "tests/device_test")]
        words += ["--gtest_filter=HaplyMessages.AreThoseOfThePublishedCrate"]
        surroundings = {**os.environ, "UNDERACT_HAPLY_MESSAGES": str(written)}
        subprocess.run(words, env=surroundings, check=True, stdout=subprocess.DEVNULL)
        probe = self.probe(READER, 'serde_json = "1"\n')
        done = subprocess.run(
            ["cargo", "run", "--quiet", "--", written], cwd=probe, capture_output=True, text=True
        )
        self.assertEqual(done.returncode, 0, done.stderr[-2000:])
        self.assertEqual(done.stdout.split(), ["5", "read"])

    def said_by(self, words: list[object], seconds: float) -> str:
        """What a client says that is ended after so long, if it does not end before."""
        with subprocess.Popen(
            [str(word) for word in words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT
        ) as client:
            timer = threading.Timer(seconds, client.kill)
            timer.start()
            said = client.stdout.read().decode().replace("\r", "\n")
            timer.cancel()
        print(f"\n{words[0].name}: {said[:300]}")
        return said

    def test_examples_run_unchanged(self) -> None:
        examples = self.examples()
        with self.service(10001, "--hand", "probe"):
            basics = self.said_by([examples / "device_basics"], 20)
            self.assertIn("Found 2 connected device(s)", basics)
            self.assertIn("#1: Inverse3 - ID: 0001", basics)
            alone = self.said_by([examples / "device_basics", "--http-only"], 20)
            self.assertIn("Inverse3 - ID: 0001", alone)
            profile = self.said_by([examples / "profile_demo"], 20)
            self.assertIn("WS confirmed profile: test_profile", profile)
            ping = self.said_by([examples / "ping_demo"], 3)
            self.assertIn("i3:0001", ping)
            sample = self.said_by([examples / "haptic_sample"], 8)
            self.assertRegex(sample, r"Force: \(-?\d+\.\d+")
        self.sphere_is_felt()
        self.replays()


def stubs() -> None:
    """What Isaac Lab's driver imports besides numpy and websockets, as little as it needs."""

    class Tensor(np.ndarray):
        pass

    torch = types.ModuleType("torch")
    torch.Tensor = Tensor
    torch.float32 = np.float32
    torch.tensor = lambda values, dtype, device: np.asarray(values, dtype).view(Tensor)
    base = types.ModuleType("lab.devices.device_base")

    class DeviceBase:
        def __init__(self, retargeters: object = None):
            pass

    @dataclass
    class DeviceCfg:
        sim_device: str = "cpu"

    base.DeviceBase, base.DeviceCfg = DeviceBase, DeviceCfg
    retargeters = types.ModuleType("lab.devices.retargeter_base")
    retargeters.RetargeterBase = object
    sys.modules["torch"] = torch
    for name in ("lab", "lab.devices", "lab.devices.haply"):
        sys.modules[name] = types.ModuleType(name)
        sys.modules[name].__path__ = []
    sys.modules[base.__name__], sys.modules[retargeters.__name__] = base, retargeters


@unittest.skipUnless(SOAK and shutil.which("pip"), "only the soak fetches the driver, with pip")
class IsaacLab(Served):
    def driver(self) -> types.ModuleType:
        words = ["pip", "download", "isaaclab==2.3.2.post1", "--no-deps", "--python-version", "311"]
        words += ["--only-binary=:all:", "--platform", "manylinux_2_35_x86_64"]
        subprocess.run(words, cwd=self.folder, check=True, stdout=subprocess.DEVNULL)
        wheel = zipfile.ZipFile(next(self.folder.glob("*.whl")))
        name = next(one for one in wheel.namelist() if one.endswith("haply/se3_haply.py"))
        file = Path(wheel.extract(name, self.folder))
        stubs()
        spec = importlib.util.spec_from_file_location("lab.devices.haply.se3_haply", file)
        module = importlib.util.module_from_spec(spec)
        sys.modules[spec.name] = module
        spec.loader.exec_module(module)
        return module

    def test_driver_runs_unchanged(self) -> None:
        module = self.driver()
        with self.service(0, "--hand", "sweep"):
            device = module.HaplyDevice(module.HaplyDeviceCfg(websocket_uri=self.url))
            print(f"\n{device}")
            first = np.array(device.advance())
            self.assertEqual(first.shape, (10,))
            self.assertAlmostEqual(float(np.linalg.norm(first[3:7])), 1.0, 5)
            with device.force_lock:  # push_force() sums tensors of torch
                device.feedback_force = {"x": 0.2, "y": 0.0, "z": 0.1}
            time.sleep(1.0)
            self.assertGreater(np.abs(np.array(device.advance())[:3] - first[:3]).max(), 1e-4)
            device.running = False
            device._websocket_thread.join(5)
        asked_N = self.rows()["force_asked_N"]
        felt = np.linalg.norm(asked_N - np.array([0.2, 0.1, 0.0]), axis=1) < 1e-6
        self.assertGreater(felt.sum(), 500, "x to the right, their z is y of W")
        self.replays()


if __name__ == "__main__":
    unittest.main()
