"""THIRD_PARTY.md is what packages.txt, CMake, the installed packages and the program itself say.

    third_party.py PROJECT_FOLDER PROGRAM

A package that is not installed is not compared; on systems without dpkg only the lists are.
"""

import pathlib
import re
import shutil
import subprocess
import sys

# What a copyright file contains if it grants the licence.
HALLMARKS = {
    "Apache-2.0": r"Apache License|Apache-2\.0",
    "BSD-2-Clause": r"Redistribution and use in source and binary forms",
    "BSD-3-Clause": r"Redistribution and use in source and binary forms",
    "BSL-1.0": r"Boost Software License",
    "FTL": r"FreeType Project LICENSE|License: FTL",
    "GPL-2": r"GPL-2|General Public License",
    "GPL-3+": r"GPL-3|General Public License",
    "GPL-3+ with the runtime exception": r"GCC Runtime Library Exception",
    "ISC": r"License: ISC|Permission to use, copy, modify, and(/or)? distribute",
    "LGPL-2+": r"Lesser General Public License|LGPL-2",
    "LGPL-2.1 or MPL-1.1": r"Lesser General Public License.*Mozilla Public License",
    "LGPL-2.1+": r"Lesser General Public License|LGPL-2\.1",
    "LGPL-3+ or GPL-2+": r"LGPL-3\+ or GPL-2\+|GPL-2\+ or LGPL-3\+",
    "MIT": r"Permission is hereby granted, free of charge|Permission to use, copy, modify, (and )?distribute",
    "MPL-2.0": r"Mozilla Public License|MPL-2",
    "OpenLDAP-2.8": r"OpenLDAP Public License|OpenLDAP-2\.8",
    "Zlib": r"License: Zlib|provided 'as-is'",
    "public domain": r"License: PD",
    "curl (MIT-like)": r"License: curl",
    "libpng": r"License: libpng",
}
RUN_ONLY = {"GPL-2", "GPL-3+"}  # allowed for programs that are run, not for what the program loads


def rows_of(page):
    """Cells of every row of the page's tables, without headers."""
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in page.splitlines() if line.startswith("|")]
    return [row for row in rows if row[0] not in ("what", "licence") and not row[0].startswith("---")]


def packages_in(cell):
    return re.findall(r"`([^`]+)`", cell)


def listed_packages(page):
    """Package -> (licence, how, version or None)."""
    listed = {}
    for row in rows_of(page):
        if len(row) == 7:
            listed.update({package: (row[2], row[3], row[1]) for package in packages_in(row[5])})
        else:
            listed.update({package: (row[0], "linked", None) for package in packages_in(row[1])})
    return listed


def wanted_packages(text):
    return [line.split("#")[0].strip() for line in text.splitlines() if line.split("#")[0].strip()]


def libraries_of_cmake(text):
    """Names by which cmake/FloesLibraries.cmake finds packages and files."""
    return re.findall(r"^\s*(?:find_package|pkg_\w+_modules?|find_file|find_path)\((\w+)", text, re.M)


def version_of(package):
    """Upstream version of an installed package; None if it is not installed."""
    form = "${db:Status-Status} ${source:Upstream-Version} ${Version}"
    found = subprocess.run(["dpkg-query", "-W", "-f", form, package], capture_output=True, text=True)
    words = found.stdout.split()
    if found.returncode or words[0] != "installed":
        return None
    # The compiler's own packages carry the version of what they depend on.
    return re.sub(r"^\d+:", "", words[2] if package == "g++" else words[1])


def copyright_of(package):
    path = pathlib.Path("/usr/share/doc") / package / "copyright"
    return re.sub(r"\s+", " ", path.read_text(encoding="utf-8", errors="replace")) if path.exists() else None


def loaded_packages(program):
    """Packages of the libraries that the dynamic linker loads for the program."""
    loaded = subprocess.run(["ldd", program], capture_output=True, text=True, check=True).stdout
    real = [str(pathlib.Path(path).resolve()) for path in re.findall(r"=> (/\S+)", loaded)]
    names = real + [path.removeprefix("/usr") for path in real]  # packages name some of them by /lib
    owners = subprocess.run(["dpkg-query", "-S", *names], capture_output=True, text=True).stdout
    owned = {line.split(": ")[1]: line.split(":")[0] for line in owners.splitlines()}
    for path in real:
        yield owned.get(path) or owned.get(path.removeprefix("/usr")) or f"no package ({path})"


def faults(project, program):
    """Sentences, one for each disagreement."""
    page = (project / "docs/THIRD_PARTY.md").read_text(encoding="utf-8")
    listed = listed_packages(page)
    for package in wanted_packages((project / "packaging/debian/packages.txt").read_text(encoding="utf-8")):
        if package not in listed:
            yield f"packages.txt has {package}, and THIRD_PARTY.md does not list it"
    named = {name for row in rows_of(page) if len(row) == 7 for name in re.findall(r"\w+", row[6])}
    for library in libraries_of_cmake((project / "cmake/FloesLibraries.cmake").read_text(encoding="utf-8")):
        if library not in named:
            yield f"cmake/FloesLibraries.cmake finds {library}, and THIRD_PARTY.md does not list it"
    for package, (licence, how, _) in listed.items():
        if licence not in HALLMARKS:
            yield f"{package} is under {licence}, a licence that this test does not know"
        elif licence in RUN_ONLY and how != "run":
            yield f"{package} is under {licence} alone and {how}"
    if not shutil.which("dpkg-query"):
        return
    for package, (licence, _, version) in listed.items():
        installed = version_of(package)
        if version and installed and not re.match(re.escape(version) + r"(?![\d])", installed):
            yield f"{package} is listed with version {version}, and {installed} is installed"
        text = copyright_of(package)
        # libboost-dev only names libboost1.74-dev; its copyright file is that of the naming.
        if installed and package != "libboost-dev" and not (text and re.search(HALLMARKS[licence], text, re.I)):
            yield f"{package} is listed under {licence}, and its copyright file does not grant that"
    for package in sorted(set(loaded_packages(program))):
        if package not in listed:
            yield f"the program loads a library of {package}, and THIRD_PARTY.md does not list it"
        elif listed[package][1] not in ("linked", "embedded"):
            yield f"the program loads a library of {package}, and THIRD_PARTY.md says that it is {listed[package][1]}"


def main():
    project, program = pathlib.Path(sys.argv[1]), sys.argv[2]
    found = list(faults(project, program))
    print("\n".join(found) or "THIRD_PARTY.md: all agrees")
    sys.exit(bool(found))


if __name__ == "__main__":
    main()
