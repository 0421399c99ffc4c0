"""The one file: the same bytes each time, whole or refused, unpacked once."""

import concurrent.futures
import filecmp
import glob
import os
import shutil
import stat
import tempfile
import unittest

from bundles import call, made


class Archive(unittest.TestCase):
    def setUp(self):
        self.home = tempfile.mkdtemp(prefix="a home ")
        self.addCleanup(shutil.rmtree, self.home)
        self.run_file = made("run")

    def call(self, *arguments, file=None):
        return call(file or self.run_file, *arguments, HOME=self.home)

    def unpacked(self):
        return glob.glob(os.path.join(self.home, ".cache/underact/bundle/*/*.AppDir/AppRun"))

    def test_two_makings_give_the_same_bytes(self):
        self.assertTrue(filecmp.cmp(self.run_file, made("run", "two elsewhere"), shallow=False))
        self.assertTrue(
            filecmp.cmp(made("spdx.json"), made("spdx.json", "two elsewhere"), shallow=False)
        )

    def test_every_file_has_one_time_and_a_public_mode(self):
        for here, folders, files in os.walk(made("AppDir", "two elsewhere")):
            for name in folders + files:
                facts = os.lstat(os.path.join(here, name))
                self.assertEqual(facts.st_mtime, 1700000000, name)
                if not stat.S_ISLNK(facts.st_mode):
                    self.assertIn(stat.S_IMODE(facts.st_mode), (0o644, 0o755), name)

    def test_it_unpacks_itself_once_and_starts(self):
        first = self.call("cli", "--version")
        self.assertEqual(first.returncode, 0, first.stderr)
        self.assertIn("Unpacking into", first.stderr)
        self.assertEqual(len(self.unpacked()), 1)
        second = self.call("cli", "--version")
        self.assertEqual((second.stdout, second.stderr), (first.stdout, ""))
        self.assertEqual(self.call("--remove").returncode, 0)
        self.assertEqual(self.unpacked(), [])

    def test_removing_takes_only_what_it_has_unpacked(self):
        place = os.path.join(self.home, "shared")
        os.mkdir(place)
        kept = os.path.join(place, "letter.txt")
        with open(kept, "w", encoding="utf-8") as file:
            file.write("mine")
        for arguments in (["cli", "--version"], ["--remove"]):
            answer = call(self.run_file, *arguments, HOME=self.home, UNDERACT_BUNDLE_DIR=place)
            self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertEqual(os.listdir(place), ["letter.txt"])

    def test_three_first_starts_at_once_share_one_folder(self):
        with concurrent.futures.ThreadPoolExecutor(3) as pool:
            answers = list(pool.map(lambda _: self.call("cli", "--version"), range(3)))
        self.assertEqual([one.returncode for one in answers], [0, 0, 0], answers)
        self.assertEqual(len(self.unpacked()), 1)
        left = glob.glob(os.path.join(self.home, ".cache/underact/bundle/*/.part*"))
        self.assertEqual(left, [])

    def test_it_unpacks_where_it_is_told_to(self):
        place = os.path.join(self.home, "in here")
        answer = self.call("--unpack", place)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        (folder,) = os.listdir(place)
        self.assertEqual(
            call(os.path.join(place, folder, "underact-cli"), "--version").returncode, 0
        )

    def test_one_that_did_not_come_whole_is_refused(self):
        self.assertEqual(self.call("--check").returncode, 0)
        damaged = os.path.join(self.home, "damaged.run")
        shutil.copy(self.run_file, damaged)
        size = os.path.getsize(damaged)
        with open(damaged, "r+b") as file:
            file.seek(size // 2)
            byte = file.read(1)
            file.seek(size // 2)
            file.write(bytes([byte[0] ^ 1]))
        for change in ("one bit", "cut short"):
            if change == "cut short":
                os.truncate(damaged, size // 2)
            for arguments in (["--check"], ["cli", "--version"]):
                answer = self.call(*arguments, file=damaged)
                self.assertEqual(answer.returncode, 4, change)
                self.assertIn("is incomplete or damaged", answer.stderr)
        self.assertEqual(self.unpacked(), [])
