"""What the desktop is told of the window: the files that it opens, and its name, also in German."""

import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

LINUX = pathlib.Path(__file__).resolve().parents[2] / "packaging/linux"
ENTRY = LINUX / "org.underact.underact.desktop"
# shared-mime-info knows them.
KNOWN = {"model/stl": "*.stl", "model/obj": "*.obj"}
OWN = {
    "application/vnd.underact.scene+json": "*.underact.json",
    "application/vnd.underact.session": "*.underact.h5",
    "application/x-urdf+xml": "*.urdf",
    "model/x-ply": "*.ply",
    "model/x-geomview-off": "*.off",
}


def entry():
    lines = ENTRY.read_text(encoding="utf-8").splitlines()
    return dict(line.split("=", 1) for line in lines if "=" in line)


class Desktop(unittest.TestCase):
    def test_the_entry_opens_scenes_sessions_meshes_and_urdf(self):
        self.assertEqual(set(entry()["MimeType"].strip(";").split(";")), {*OWN, *KNOWN})
        metainfo = (LINUX / "org.underact.underact.metainfo.xml.in").read_text(encoding="utf-8")
        self.assertEqual(set(re.findall("<mediatype>(.*)</mediatype>", metainfo)), {*OWN, *KNOWN})

    def test_the_entry_and_the_types_are_in_german_too(self):
        for key in ["Name", "GenericName", "Comment", "Keywords"]:
            self.assertTrue(entry()[f"{key}[de]"], key)
        types = ElementTree.parse(LINUX / "underact.xml").getroot()
        language = "{http://www.w3.org/XML/1998/namespace}lang"
        for one in types:
            comments = [child.get(language) for child in one if child.tag.endswith("comment")]
            self.assertEqual(comments, [None, "de"], one.get("type"))

    @unittest.skipUnless(shutil.which("desktop-file-validate"), "desktop-file-utils is not installed")
    def test_the_entry_is_valid(self):
        told = subprocess.run(
            ["desktop-file-validate", "--no-hints", ENTRY], capture_output=True, text=True, check=False
        )
        self.assertEqual((told.returncode, told.stdout), (0, ""))

    @unittest.skipUnless(shutil.which("update-mime-database"), "shared-mime-info is not installed")
    def test_each_type_of_our_own_has_its_ending(self):
        with tempfile.TemporaryDirectory() as folder:
            packages = pathlib.Path(folder, "packages")
            packages.mkdir()
            shutil.copy(LINUX / "underact.xml", packages)
            subprocess.run(["update-mime-database", folder], capture_output=True, check=True)
            globs = pathlib.Path(folder, "globs2").read_text(encoding="utf-8")
        for kind, pattern in OWN.items():
            self.assertIn(f":{kind}:{pattern}\n", globs)
        system = pathlib.Path("/usr/share/mime/globs2")
        for kind, pattern in KNOWN.items() if system.exists() else ():
            self.assertIn(f":{kind}:{pattern}\n", system.read_text(encoding="utf-8"))


if __name__ == "__main__":
    unittest.main()
