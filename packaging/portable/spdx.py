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
    source = f"https://snapshot.debian.org/package/{known['source']}/{known['source_version']}/"
    where = f"pkg:deb/debian/{name}@{known['version']}?arch=amd64"
    return {
        "SPDXID": _id("Package", name),
        "name": name,
        "versionInfo": known["version"],
        "supplier": "Organization: Debian",
        "downloadLocation": source,
        "filesAnalyzed": False,
        "homepage": known["homepage"] or NOTHING,
        "licenseConcluded": expression,
        "licenseDeclared": expression,
        "copyrightText": NOTHING,
        "sourceInfo": f"built by Debian from {known['source']} {known['source_version']}",
        "externalRefs": [
            {
                "referenceCategory": "PACKAGE-MANAGER",
                "referenceType": "purl",
                "referenceLocator": where,
            }
        ],
    }


def _file(folder, path, expression):
    """path: below folder."""
    with open(os.path.join(folder, path), "rb") as file:
        content = file.read()
    return {
        "SPDXID": _id("File", path),
        "fileName": "./" + path,
        "checksums": [
            {"algorithm": "SHA1", "checksumValue": hashlib.sha1(content).hexdigest()},
            {"algorithm": "SHA256", "checksumValue": hashlib.sha256(content).hexdigest()},
        ],
        "licenseConcluded": expression,
        "licenseInfoInFiles": [NOTHING],
        "copyrightText": NOTHING,
    }


def _verification(files):
    """SPDX 2.3, 7.9.4: of the sorted SHA1s, written one after the other."""
    sums = sorted(file["checksums"][0]["checksumValue"] for file in files)
    return hashlib.sha1("".join(sums).encode()).hexdigest()


def document(version, epoch, folder, origin, licence_of, linked):
    """folder: what is given away. origin: file below it -> Debian's package, or "" for a program of
    ours. linked: package -> how the programs need it, STATIC_LINK or DYNAMIC_LINK. licence_of:
    package -> licence.
    """
    created = datetime.datetime.fromtimestamp(epoch, datetime.timezone.utc).strftime(
        "%Y-%m-%dT%H:%M:%SZ"
    )
    files = [
        _file(folder, path, licence_of.get(name, NOTHING) if name else "BSD-3-Clause")
        for path, name in sorted(origin.items())
    ]
    code = _verification(files)
    program = {
        "SPDXID": "SPDXRef-Package-underact",
        "name": "underact",
        "versionInfo": version,
        "supplier": "Organization: Underact",
        "downloadLocation": NOTHING,
        "filesAnalyzed": True,
        "packageVerificationCode": {"packageVerificationCodeValue": code},
        "licenseInfoFromFiles": [NOTHING],
        "licenseConcluded": "BSD-3-Clause",
        "licenseDeclared": "BSD-3-Clause",
        "copyrightText": NOTHING,
        "primaryPackagePurpose": "APPLICATION",
    }
    packages, relations = [program], [("SPDXRef-DOCUMENT", "DESCRIBES", program["SPDXID"])]
    for name in sorted(linked):
        packages.append(_package(name, licence_of.get(name, NOTHING)))
        relations.append((program["SPDXID"], linked[name], packages[-1]["SPDXID"]))
    for path, name in sorted(origin.items()):
        relations.append((program["SPDXID"], "CONTAINS", _id("File", path)))
        if name:
            relations.append((_id("File", path), "GENERATED_FROM", _id("Package", name)))
    own = sorted(
        {
            word
            for package in packages
            for word in re.findall(r"LicenseRef-[\w.-]+", package["licenseDeclared"])
        }
    )
    return {
        "spdxVersion": "SPDX-2.3",
        "dataLicense": "CC0-1.0",
        "SPDXID": "SPDXRef-DOCUMENT",
        "name": f"Underact-{version}",
        "documentNamespace": f"https://spdx.org/spdxdocs/underact-{version}-{code}",
        "creationInfo": {"created": created, "creators": ["Tool: underact-packaging-sbom"]},
        "packages": packages,
        "files": files,
        "hasExtractedLicensingInfos": [
            {
                "licenseId": name,
                "name": name[len("LicenseRef-") :],
                "extractedText": _text(packages, name),
            }
            for name in own
        ],
        "relationships": [
            {"spdxElementId": a, "relationshipType": kind, "relatedSpdxElement": b}
            for a, kind, b in relations
        ],
    }


def _text(packages, licence):
    for package in packages:
        if licence in package["licenseDeclared"]:
            name = package["name"]
            path = licences.own_text(name) or f"/usr/share/doc/{name}/copyright"
            with open(path, encoding="utf-8", errors="replace") as file:
                return file.read()
    return NOTHING


def write(path, content):
    """The same document gives the same bytes."""
    with open(path, "w", encoding="utf-8") as file:
        json.dump(content, file, indent=1, ensure_ascii=False)
        file.write("\n")
