"""The bundle runs from a folder with spaces, and says what is missing where it cannot."""

import json
import os
import subprocess
import unittest

from bundles import Moved, call, plain


class CommandLine(Moved):
    def test_it_says_its_version_by_both_ways(self):
        for command in ([self.app_run, "cli"], [os.path.join(self.folder, "underact-cli")]):
            answer = call(*command, "--version")
            self.assertEqual((answer.returncode, answer.stderr), (0, ""))
            self.assertRegex(answer.stdout, r"^underact-cli \d+\.\d+\.\d+\n$")

    def test_it_is_loaded_with_its_own_libraries(self):
        answer = call(self.app_run, "cli", "--version", LD_DEBUG="libs")
        inits = [
            line.split("calling init: ")[1]
            for line in answer.stderr.splitlines()
            if "calling init: " in line
        ]
        hdf5 = [path for path in inits if "libhdf5" in path]
        self.assertEqual(
            [os.path.realpath(path) for path in hdf5],
            [os.path.realpath(os.path.join(self.folder, "usr/lib/libhdf5_serial.so.103"))],
        )

    def test_a_run_is_recorded_and_replays_to_the_bit(self):
        session = os.path.join(self.scratch, "one.h5")
        answer = call(
            self.app_run,
            "cli",
            "run",
            self.scene,
            "--hand",
            "probe",
            "--seconds",
            "1",
            "--fast",
            "--record",
            session,
        )
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertEqual(json.loads(answer.stdout)["ticks"], 1000)
        answer = call(self.app_run, "cli", "replay", session, "--verify")
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertTrue(json.loads(answer.stdout)["identical"])

    def test_a_mesh_is_read_by_the_helper_that_is_carried(self):
        scene = os.path.join(self.scratch, "mesh.json")
        with open(os.path.join(self.scratch, "one.obj"), "w", encoding="utf-8") as file:
            file.write(
                "v 0 0 0\nv 10 0 0\nv 0 10 0\nv 0 0 10\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"
            )
        with open(scene, "w", encoding="utf-8") as file:
            json.dump(
                {
                    "underact_scene": 1,
                    "title": "One",
                    "constraints": [{"name": "one", "type": "mesh", "file": "one.obj"}],
                },
                file,
            )
        answer = call(
            self.app_run, "cli", "run", scene, "--hand", "probe", "--seconds", "0.1", "--fast"
        )
        self.assertEqual(answer.returncode, 0, answer.stderr)

    def test_it_bears_being_told_to_look_up_everything_at_start(self):
        answer = call(self.app_run, "cli", "--version", LD_BIND_NOW="1")
        self.assertEqual(answer.returncode, 0, answer.stderr)

    def test_sweeps_are_refused_with_a_sentence(self):
        answer = call(self.app_run, "sweep", "hands")
        self.assertEqual(answer.returncode, 2)
        self.assertIn("underact-sweep is not in this bundle", answer.stderr)


class Missing(Moved):
    def test_a_library_of_the_display_is_named_with_its_package(self):
        program = os.path.join(self.folder, "usr/bin/underact")
        subprocess.run(["patchelf", "--add-needed", "libnosuchdisplay.so.1", program], check=True)
        with open(
            os.path.join(self.folder, "usr/share/underact/bundle/system-libraries"),
            "a",
            encoding="utf-8",
        ) as file:
            file.write("libnosuchdisplay.so.1 libnosuchdisplay1\n")
        answer = call(self.app_run)
        self.assertEqual(answer.returncode, 2)
        self.assertIn("are missing: libnosuchdisplay.so.1", answer.stderr)
        self.assertIn("sudo apt install libnosuchdisplay1\n", answer.stderr)

    def test_a_bundle_that_is_not_whole_says_so(self):
        # One that no system has: Debian's own would be found otherwise.
        program = os.path.join(self.folder, "usr/bin/underact-cli")
        subprocess.run(["patchelf", "--add-needed", "libnosuchpart.so.1", program], check=True)
        answer = call(self.app_run, "cli", "--version")
        self.assertEqual(answer.returncode, 4)
        self.assertIn("incomplete: libnosuchpart.so.1 is missing", answer.stderr)

    def test_a_desktop_without_x_is_told_of_xwayland(self):
        answer = call(self.app_run, WAYLAND_DISPLAY="wayland-0", QT_QPA_PLATFORM="wayland")
        self.assertEqual(answer.returncode, 2)
        self.assertIn("sudo apt install xwayland", answer.stderr)

    def test_figures_without_their_libraries_say_so(self):
        out = os.path.join(self.scratch, "figures")
        alone = os.path.join(self.scratch, "python3")  # one without the system's packages
        with open(alone, "w", encoding="utf-8") as file:
            file.write('#!/bin/sh\nexec /usr/bin/python3 -S "$@"\n')
        os.chmod(alone, 0o755)
        for python, wanted in (
            (alone, "h5py|matplotlib|numpy"),
            ("/nonexistent", "Install python3"),
        ):
            answer = call(self.app_run, "cli", "figures", "--out", out, UNDERACT_PYTHON=python)
            self.assertNotEqual(answer.returncode, 0)
            self.assertRegex(answer.stderr, wanted)
            self.assertNotIn("Traceback", answer.stderr)

    def test_without_a_screen_the_window_says_so(self):
        answer = call(self.app_run)
        self.assertEqual(answer.returncode, 2)
        self.assertIn("No display", answer.stderr)


class Window(Moved):
    def test_it_draws_its_first_picture(self):
        environment = plain(HOME=self.scratch, LIBGL_ALWAYS_SOFTWARE="1", UNDERACT_TIMING="1")
        window = subprocess.Popen(
            ["xvfb-run", "-a", "-s", "-screen 0 1280x800x24", "timeout", "240", self.app_run],
            env=environment,
            stderr=subprocess.PIPE,
            text=True,
        )
        said = []
        try:
            for line in window.stderr:
                said.append(line)
                if "first picture" in line:
                    break
            self.assertRegex("".join(said), r"first picture after \d+ ms")
        finally:
            subprocess.run(["pkill", "-TERM", "-P", str(window.pid)], check=False)
            window.stderr.close()
            window.wait(60)

    def test_a_picture_of_a_scene_is_drawn(self):
        picture = os.path.join(self.scratch, "sphere.png")
        answer = call(
            "xvfb-run",
            "-a",
            "-s",
            "-screen 0 1280x800x24",
            self.app_run,
            "--picture",
            self.scene,
            "--out",
            picture,
            LIBGL_ALWAYS_SOFTWARE="1",
        )
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertGreater(os.path.getsize(picture), 20000)
