#!/usr/bin/env python3
"""Builds detgl_VERSION_MACHINE.deb with Debian's dpkg-deb: what the tarball has, in /opt/detgl, and the command in
/usr/bin. No program uses it that is not asked to: `detgl run -- PROGRAM`. The same commit gives the same bytes.

    pip install cargo-zigbuild ziglang        # for glibc 2.17 and later; else --native
    python3 package/build_deb.py              # into dist/
"""

import os
import subprocess
import tempfile
from pathlib import Path

from build_libraries import MACHINES, VERSION, Build, needs_of, parser_of
from build_tarball import fill

# Debian's names of instruction sets.
ARCHITECTURES = {"x86_64": "amd64", "aarch64": "arm64"}
PREFIX = "opt/detgl"


def main():
    parser = parser_of(__doc__)
    parser.add_argument("--compress", default="6", metavar="LEVEL", help="xz's level: 0 is fast")
    arguments = parser.parse_args()
    build = Build(arguments.target, arguments.prebuilt, arguments.native)
    with tempfile.TemporaryDirectory() as folder:
        tree = Path(folder) / "detgl"
        fill(tree / PREFIX, build)
        (machine,), _, newest = needs_of(sorted(tree.rglob("*")))
        architecture = ARCHITECTURES[MACHINES[machine]]
        (tree / "usr/bin").mkdir(parents=True)
        (tree / "usr/bin/detgl").symlink_to(f"/{PREFIX}/bin/detgl")
        size = sum(file.stat().st_size for file in tree.rglob("*") if file.is_file() and not file.is_symlink())
        glibc = ".".join(map(str, newest))
        # The prefix is known: no variable has to name it, and `__EGL_VENDOR_LIBRARY_FILENAMES` alone chooses DetGL.
        vendor = tree / PREFIX / "lib/egl_vendor.json"
        vendor.write_text(vendor.read_text().replace('"libdetgl.so"', f'"/{PREFIX}/lib/libdetgl.so"'))
        (tree / "DEBIAN").mkdir()
        (tree / "DEBIAN/control").write_text(control(architecture, glibc, size))
        plain(tree)
        out = Path(arguments.out)
        out.mkdir(parents=True, exist_ok=True)
        path = out / f"detgl_{VERSION}_{architecture}.deb"
        command = ["dpkg-deb", "--root-owner-group", "-Zxz", f"-z{arguments.compress}", "--build", tree, path]
        # The time in the archives.
        environment = {**os.environ, "SOURCE_DATE_EPOCH": "0"}
        subprocess.run(command, check=True, env=environment, stdout=subprocess.DEVNULL)
        print(path)


def control(architecture, glibc, size):
    return f"""Package: detgl
Version: {VERSION}
Architecture: {architecture}
Maintainer: The authors of DetGL <detgl@localhost>
Depends: libc6 (>= {glibc})
Section: libs
Priority: optional
Installed-Size: {(size + 1023) // 1024}
Description: OpenGL in software, with the same bits on every machine
 libOSMesa, libEGL, libGL, libOpenGL and libGLESv2 with headers and files for
 pkg-config and CMake, in /{PREFIX}, where no program finds them that is not
 told: "detgl run -- PROGRAM" does.
"""


def plain(tree):
    """Files have no time, and modes that do not depend on who builds."""
    for file in [tree, *sorted(tree.rglob("*"))]:
        if not file.is_symlink():
            is_program = file.is_dir() or file.parent.name == "bin" or ".so" in file.name
            file.chmod(0o755 if is_program else 0o644)
        os.utime(file, (0, 0), follow_symlinks=False)


if __name__ == "__main__":
    main()
