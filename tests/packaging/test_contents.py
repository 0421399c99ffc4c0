"""What is in the bundle, and what making it refuses."""

import os
import re
import unittest
from unittest import mock

from bundles import made
from portable import closure, elf, licences, parts


class Contents(unittest.TestCase):
    def setUp(self):
        self.folder = made("AppDir")
        self.files = elf.elf_files(self.folder)
        self.carried = {os.path.basename(path) for path in self.files}

    def test_every_library_is_carried_or_one_of_the_systems(self):
        self.assertGreater(len(self.files), 60)
        for path in self.files:
            lost = set(elf.needed(path)) - self.carried - set(parts.SYSTEM)
            self.assertFalse(lost, path)

    def test_none_of_the_systems_is_carried(self):
        self.assertFalse(self.carried & set(parts.SYSTEM))

    def test_every_library_is_looked_for_beside_the_program_alone(self):
        for path in self.files:
            way = elf.runpath(path)
            self.assertNotIn("", way.split(":"), path)  # which would be the folder one stands in
            self.assertTrue(way.startswith("$ORIGIN"), f"{path}: {way}")
            place = os.path.realpath(way.replace("$ORIGIN", os.path.dirname(path)))
            self.assertEqual(place, os.path.realpath(os.path.join(self.folder, "usr/lib")), path)

    def test_no_function_is_asked_for_that_nobody_has(self):
        self.assertEqual(closure.unresolved(self.folder), {})

    def test_none_wants_a_newer_c_library_than_that_of_early_2022(self):
        """glibc 2.35 and GCC 12, which Ubuntu 22.04 has, too: what the bundle's page promises."""
        most = {"GLIBC": (2, 35), "GLIBCXX": (3, 4, 30), "CXXABI": (1, 3, 13)}
        seen = set()
        for path in self.files:
            wanted = elf.versions(path)
            seen |= set(wanted)
            for family, newest in most.items():
                self.assertLessEqual(wanted.get(family, ()), newest, f"{path}: {family}")
        self.assertLessEqual(set(most), seen)

    def test_nothing_of_the_gpl_of_mpi_or_of_the_network(self):
        for name in sorted(self.carried):
            self.assertNotRegex(
                name, r"jbig|tiff|mpi|curl|libcrypto|ssl|gnutls|ldap|xdmf|InfovisCore|Qt5"
            )

    def test_the_text_of_every_licence_is_there(self):
        texts = os.path.join(self.folder, "usr/share/doc/underact/licences")
        origin = [elf.installed().get(name) for name in self.carried]
        packages = set(licences.packages_of([path for path in origin if path]).values()) | set(
            parts.HEADERS
        )
        self.assertGreater(len(packages), 40)
        for name in packages | {
            "underact",
            "SOURCES",
            "common/LGPL-3",
            "common/LGPL-2.1",
            "common/GPL-3",
        }:
            self.assertGreater(os.path.getsize(os.path.join(texts, name)), 100, name)
        if "libcom-err2" in packages:  # Debian's file leaves it out
            with open(os.path.join(texts, "libcom-err2.upstream"), encoding="utf-8") as file:
                self.assertIn("Student Information Processing Board", file.read())

    def test_the_texts_that_other_texts_name_are_there(self):
        texts = os.path.join(self.folder, "usr/share/doc/underact/licences")
        for name in os.listdir(texts):
            if os.path.isfile(os.path.join(texts, name)):
                with open(os.path.join(texts, name), encoding="utf-8", errors="replace") as file:
                    for common in re.findall(
                        r"common-licenses/(L?GPL-[23][.0-9]*[0-9])\b", file.read()
                    ):
                        self.assertTrue(
                            os.path.exists(os.path.join(texts, "common", common)),
                            f"{name}: {common}",
                        )

    def test_the_sweeps_that_take_mpi_are_not_there(self):
        self.assertIn("underact-cli", self.carried)
        self.assertIn("underact-guard", self.carried)
        self.assertIn("underact-mesh-reader", self.carried)
        self.assertIn("underact-session-reader", self.carried)
        self.assertNotIn("underact-sweep", self.carried)


class Refusals(unittest.TestCase):
    def test_the_gpls_libjbig_is_refused(self):
        with self.assertRaisesRegex(closure.Refused, "libjbig0 has no licence"):
            licences.check({"libvtk9.1", "libjbig0"}, licences.read_table())

    def test_a_licence_that_is_not_allowed_is_refused(self):
        allowed, of_package = licences.read_table()
        for expression in (
            "GPL-2.0-or-later",
            "MIT AND GPL-3.0-or-later",
            "GPL-3.0-or-later WITH another-exception",
        ):
            with self.assertRaisesRegex(closure.Refused, "libjbig0 is under .*GPL"):
                licences.check({"libjbig0"}, (allowed, {**of_package, "libjbig0": expression}))

    def test_a_function_more_of_a_library_left_out_is_refused(self):
        edge = ("libhdf5_serial.so.103", "libcurl.so.4")
        path = elf.installed()[edge[0]]
        closure.check_left_out(path, edge[0])
        with mock.patch.dict(parts.LEFT_OUT, {edge: set()}):
            with self.assertRaisesRegex(closure.Refused, "curl_easy_init"):
                closure.check_left_out(path, edge[0])

    def test_a_function_looked_up_at_start_is_refused(self):
        hdf5 = elf.installed()["libhdf5_serial.so.103"]
        self.assertTrue(elf.binds_lazily(hdf5, {"curl_easy_init"}))
        drawing = elf.installed()["libvtkRenderingOpenGL2-9.1.so.1"]
        self.assertFalse(elf.binds_lazily(drawing, {"_ZTI9vtkObject"}))  # data
        self.assertFalse(
            elf.binds_lazily(elf.installed()["libtiff.so.6"], {"jbg_dec_init"})
        )  # BIND_NOW

    def test_a_program_that_calls_what_is_left_out_is_refused(self):
        program = os.path.join(made("AppDir"), "usr/bin/underact")
        closure.check_programs([program])
        with mock.patch.object(parts, "NEVER_CALLED", ("vtkPolyDataNormals",)):
            with self.assertRaisesRegex(closure.Refused, "underact calls .*vtkPolyDataNormals"):
                closure.check_programs([program])

    def test_a_part_of_a_package_under_another_licence_is_refused(self):
        with mock.patch.object(elf, "needed", return_value=["libvtkxdmf2-9.1.so.1"]):
            with self.assertRaisesRegex(closure.Refused, "GPL-2.0-or-later"):
                closure.libraries(["program"])
