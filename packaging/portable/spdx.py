"""The list of what the bundle carries, as SPDX 2.3 in JSON."""

import datetime
import hashlib
import json
import os
import re

from . import licences

NOTHING = "NOASSERTION"


def _id(kind, name):
    return f"SPDXRef-{kind}-" + re.sub(r"[^A-Za-z0-9.-]", "-", name)


def _package(name, expression):
    known = licences.facts(name)
    where = f"pkg:deb/debian/{name}@{known['version']}?arch=amd64"
    return {
        "SPDXID": _id("Package", name),
        "name": name,
        "versionInfo": known["version"],
        "supplier": "Organization: Debian",
        "downloadLocation": f"https://snapshot.debian.org/package/{known['source']}/{known['source_version']}/",
        "filesAnalyzed": False,
        "homepage": known["homepage"] or NOTHING,
        "licenseConcluded": expression,
        "licenseDeclared": expression,
        "copyrightText": NOTHING,
        "sourceInfo": f"built by Debian from {known['source']} {known['source_version']}",
        "externalRefs": [{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                          "referenceLocator": where}],
    }


def _file(folder, path, expression):
    """path: below folder."""
    with open(os.path.join(folder, path), "rb") as file:
        content = file.read()
    return {
        "SPDXID": _id("File", path),
        "fileName": "./" + path,
        "checksums": [{"algorithm": "SHA1", "checksumValue": hashlib.sha1(content).hexdigest()},
                      {"algorithm": "SHA256", "checksumValue": hashlib.sha256(content).hexdigest()}],
        "licenseConcluded": expression,
        "licenseInfoInFiles": [NOTHING],
        "copyrightText": NOTHING,
    }


def document(folder, version, epoch, of_package, carried, headers):
    """folder: the AppDir. carried: file below it -> Debian's package, or "" for a program of ours."""
    created = datetime.datetime.fromtimestamp(epoch, datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
    program = {
        "SPDXID": "SPDXRef-Package-underact", "name": "underact", "versionInfo": version,
        "supplier": "Organization: Underact", "downloadLocation": NOTHING, "filesAnalyzed": False,
        "licenseConcluded": "BSD-3-Clause", "licenseDeclared": "BSD-3-Clause", "copyrightText": NOTHING,
        "primaryPackagePurpose": "APPLICATION",
    }
    packages, relations = [program], [("SPDXRef-DOCUMENT", "DESCRIBES", program["SPDXID"])]
    for name in sorted(set(carried.values()) - {""} | set(headers)):
        packages.append(_package(name, of_package[name]))
        kind = "STATIC_LINK" if name in headers else "DYNAMIC_LINK"
        relations.append((program["SPDXID"], kind, packages[-1]["SPDXID"]))
    files = []
    for path, name in sorted(carried.items()):
        files.append(_file(folder, path, of_package[name] if name else "BSD-3-Clause"))
        relations.append((_id("Package", name or "underact"), "CONTAINS", files[-1]["SPDXID"]))
    own = sorted({word for package in packages for word in re.findall(r"LicenseRef-[\w.-]+", package["licenseDeclared"])})
    content = hashlib.sha256("".join(file["checksums"][1]["checksumValue"] for file in files).encode()).hexdigest()
    return {
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT",
        "name": f"Underact-{version}-x86_64",
        "documentNamespace": f"https://spdx.org/spdxdocs/underact-{version}-{content[:32]}",
        "creationInfo": {"created": created, "creators": ["Tool: underact-packaging-sbom"]},
        "packages": packages, "files": files,
        "hasExtractedLicensingInfos": [
            {"licenseId": name, "name": name[len("LicenseRef-"):], "extractedText": _texts(packages, name)} for name in own],
        "relationships": [{"spdxElementId": a, "relationshipType": kind, "relatedSpdxElement": b}
                          for a, kind, b in relations],
    }


def _texts(packages, licence):
    for package in packages:
        if licence in package["licenseDeclared"]:
            with open(f"/usr/share/doc/{package['name']}/copyright", encoding="utf-8", errors="replace") as file:
                return file.read()
    return NOTHING


def write(path, content):
    """The same document gives the same bytes."""
    with open(path, "w", encoding="utf-8") as file:
        json.dump(content, file, indent=1, ensure_ascii=False)
        file.write("\n")
