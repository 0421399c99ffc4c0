"""Makes the bundle twice for the tests beside, the second time as somebody else would. Exit status
77 where a tool is missing.
"""

import os
import shutil
import subprocess
import sys

MADE = os.environ["UNDERACT_MADE"]
BUNDLE = os.path.join(os.path.dirname(__file__), "..", "..", "packaging", "bundle")
TOOLS = ("patchelf", "readelf", "nm", "dpkg-query", "xvfb-run")

with open("/etc/os-release", encoding="utf-8") as file:
    RELEASE = file.read()
if "ID=debian\n" not in RELEASE or 'VERSION_ID="12"' not in RELEASE:
    print("SKIPPED: the bundle carries the libraries of Debian 12, so none was made here.")
    sys.exit(77)
lacking = [tool for tool in TOOLS if not shutil.which(tool)]
try:
    import elftools  # noqa: F401
except ModuleNotFoundError:
    lacking.append("pyelftools")
if lacking:
    print(
        f"SKIPPED: {', '.join(lacking)} not installed, so the portable bundle was not made. "
        "See packaging/install-deps package."
    )
    sys.exit(77)


def make(name, **other):
    """One making, in a folder of its own."""
    folder = os.path.join(MADE, name)
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    subprocess.run(
        [BUNDLE, "--build", os.environ["UNDERACT_BUILD"], "--out", folder],
        check=True,
        env={**os.environ, "SOURCE_DATE_EPOCH": "1700000000", **other},
    )


make("one")
os.umask(0o077)
make("two elsewhere", TZ="Asia/Tokyo", LC_ALL="C", HOME="/nonexistent")
