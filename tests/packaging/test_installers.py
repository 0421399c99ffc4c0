"""What is given to other systems is made where its tool is installed, and read where it is not."""

import glob
import os
import shutil
import subprocess
import tempfile
import unittest

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
CONFIG = os.path.join(ROOT, "packaging", "cpack", "underact.cmake")
MANIFEST = os.path.join(ROOT, "packaging", "flatpak", "org.underact.underact.yml")


def said(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


class Installers(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder)

    def pack(self, generator, ending):
        answer = subprocess.run(
            ["cpack", "--config", CONFIG, "-G", generator, "-B", self.folder],
            capture_output=True,
            text=True,
            env={**os.environ, "SOURCE_DATE_EPOCH": "1700000000"},
        )
        self.assertEqual(answer.returncode, 0, answer.stdout + answer.stderr)
        (made,) = glob.glob(os.path.join(self.folder, "*" + ending))
        return made

    @unittest.skipUnless(shutil.which("rpmbuild"), "rpmbuild is not installed, no RPM was made")
    def test_the_rpm_has_the_programs_and_owns_no_folder_of_others(self):
        made = self.pack("RPM", ".rpm")
        files = said("rpm", "-qpl", made).splitlines()
        for name in ("bin/underact", "bin/underact-cli", "share/underact/scenes/02_sphere.json"):
            self.assertIn("/usr/" + name, files)
        self.assertFalse(
            {"/usr/bin", "/usr/share", "/usr/lib/udev", "/usr/lib/udev/rules.d"} & set(files)
        )
        self.assertIn("libQt6Widgets.so.6", said("rpm", "-qp", "--requires", made))
        version = said(
            os.path.join(os.environ["UNDERACT_BUILD"], "underact-cli"), "--version"
        ).split()[-1]
        self.assertEqual(
            said("rpm", "-qp", "--qf", "%{VERSION} %{BUILDTIME} %{BUILDHOST}", made),
            f"{version} 1700000000 underact",
        )

    @unittest.skipUnless(shutil.which("makensis"), "makensis is not installed, NSIS was not run")
    def test_the_nsis_configuration_is_one_that_makensis_takes(self):
        # With what this system builds inside: only the installer's own script is looked at.
        self.assertGreater(os.path.getsize(self.pack("NSIS64", "-win64.exe")), 1000000)

    def test_the_configuration_packs_what_the_build_installs(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.unpack_archive(self.pack("TGZ", ".tar.gz"), folder)
            for name in (
                "bin/underact",
                "bin/underact-cli",
                "share/underact/scenes/02_sphere.json",
            ):
                self.assertTrue(glob.glob(os.path.join(folder, "*", name)), name)

    @unittest.skipUnless(shutil.which("flatpak-builder"), "flatpak-builder is not installed")
    def test_flatpak_builder_reads_its_manifest(self):
        self.assertIn(
            '"id" : "org.underact.underact"', said("flatpak-builder", "--show-manifest", MANIFEST)
        )
