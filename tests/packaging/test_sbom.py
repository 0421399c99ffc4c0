"""The list of parts has what SPDX 2.3 requires, and says what is so. packaging/soak asks the
official validator, too.
"""

import hashlib
import json
import os
import re
import subprocess
import tempfile
import unittest

from bundles import made
from portable import elf

SBOM = os.path.join(os.path.dirname(__file__), "..", "..", "packaging", "sbom")
EXPRESSION = re.compile(r"^(NOASSERTION|[A-Za-z0-9.-]+( (AND|WITH) [A-Za-z0-9.-]+)*)$")


class Sbom(unittest.TestCase):
    def check(self, document):
        """The fields that clauses 6 to 11 of the specification require."""
        self.assertEqual(document["spdxVersion"], "SPDX-2.3")
        self.assertEqual(document["dataLicense"], "CC0-1.0")
        self.assertEqual(document["SPDXID"], "SPDXRef-DOCUMENT")
        self.assertRegex(document["documentNamespace"], r"^https://[^#\s]+$")
        self.assertRegex(document["creationInfo"]["created"], r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ$")
        self.assertTrue(document["creationInfo"]["creators"])
        names = [document["SPDXID"]] + [
            one["SPDXID"] for one in document["packages"] + document["files"]
        ]
        self.assertEqual(len(names), len(set(names)))
        for one in document["packages"]:
            self.assertTrue(
                one["name"] and one["versionInfo"] and one["downloadLocation"] and one["supplier"]
            )
            self.assertRegex(one["licenseDeclared"], EXPRESSION)
        for one in document["files"]:
            self.assertTrue(one["fileName"].startswith("./"))
            self.assertEqual({sum_["algorithm"] for sum_ in one["checksums"]}, {"SHA1", "SHA256"})
            self.assertRegex(one["licenseConcluded"], EXPRESSION)
        for name in names[1:]:
            self.assertRegex(name, r"^SPDXRef-[A-Za-z0-9.-]+$")
        for relation in document["relationships"]:
            self.assertIn(relation["spdxElementId"], names)
            self.assertIn(relation["relatedSpdxElement"], names)
        described = [
            one for one in document["relationships"] if one["relationshipType"] == "DESCRIBES"
        ]
        self.assertEqual(len(described), 1)
        text = json.dumps(document["packages"])
        for one in set(re.findall(r"LicenseRef-[\w.-]+", text)):
            self.assertIn(one, [own["licenseId"] for own in document["hasExtractedLicensingInfos"]])

    def test_the_bundles_list_names_every_file_with_its_sum(self):
        with open(made("spdx.json"), encoding="utf-8") as file:
            document = json.load(file)
        self.check(document)
        folder = made("AppDir")
        listed = {
            one["fileName"][2:]: one["checksums"][1]["checksumValue"] for one in document["files"]
        }
        self.assertEqual(
            sorted(listed), [os.path.relpath(path, folder) for path in elf.elf_files(folder)]
        )
        for path, value in listed.items():
            with open(os.path.join(folder, path), "rb") as file:
                self.assertEqual(hashlib.sha256(file.read()).hexdigest(), value, path)
        text = json.dumps(document)
        self.assertNotIn("libjbig", text)
        self.assertNotIn(os.environ["UNDERACT_BUILD"] + "/", text)  # nothing of the machine that made it
        version = subprocess.run(
            ["dpkg-query", "-W", "-f", "${Version}", "libqt6core6"], capture_output=True, text=True
        )
        self.assertIn(
            ("libqt6core6", version.stdout),
            [(one["name"], one["versionInfo"]) for one in document["packages"]],
        )

    def test_a_builds_list_says_what_the_system_loads_the_programs_with(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "build.spdx.json")
            subprocess.run(
                [SBOM, "--build", os.environ["UNDERACT_BUILD"], "--out", path],
                check=True,
                capture_output=True,
                env={**os.environ, "SOURCE_DATE_EPOCH": "1700000000"},
            )
            with open(path, encoding="utf-8") as file:
                document = json.load(file)
        self.check(document)
        names = [one["name"] for one in document["packages"]]
        for name in ("libc6", "libhdf5-103-1", "libqt6widgets6", "libeigen3-dev"):
            self.assertIn(name, names)
