#!/usr/bin/env python3
"""Builds detgl-VERSION-linux-MACHINE.tar.zst (.tar.gz where there is no zstd): libraries, headers, the command, and
files for pkg-config and CMake, which find each other wherever it is unpacked. The same commit gives the same bytes.

    pip install cargo-zigbuild ziglang        # for glibc 2.17 and later; else --native
    python3 package/build_tarball.py          # into dist/
"""

import gzip
import io
import shutil
import subprocess
import tarfile
import tempfile
from pathlib import Path

import headers
from build_libraries import (
    MACHINES, ROOT, VERSION, Build, exports, licences, packages, parser_of, platform_of, read_elf,
)

LIBRARIES = ["EGL", "GL", "OpenGL", "GLESv2", "OSMesa"]
# Names as pkg-config knows them, with what each library is.
PKG_CONFIG = {
    "egl": ("EGL", "EGL"),
    "gl": ("GL", "OpenGL"),
    "opengl": ("OpenGL", "OpenGL without GLX"),
    "glesv2": ("GLESv2", "OpenGL ES 2.0 and 3.0"),
    "osmesa": ("OSMesa", "contexts that draw into the program's memory"),
    "glu": ("GLU", "OpenGL's utility library without the tessellator and NURBS"),
}


def main():
    parser = parser_of(__doc__)
    parser.add_argument("--compress", default="19", metavar="LEVEL", help="zstd's level: 1 is fast")
    arguments = parser.parse_args()
    build = Build(arguments.target, arguments.prebuilt, arguments.native)
    with tempfile.TemporaryDirectory() as folder:
        tree = Path(folder) / "detgl"
        fill(tree, build)
        machine = MACHINES[read_elf((tree / "lib/libdetgl.so").read_bytes())[0]]
        print(f"for {platform_of(tree / 'lib')}")
        out = Path(arguments.out)
        out.mkdir(parents=True, exist_ok=True)
        print(pack(tree, out / f"detgl-{VERSION}-linux-{machine}.tar", arguments.compress))


def fill(tree, build):
    for name in ["bin", "lib/pkgconfig", "share/licenses/detgl"]:
        (tree / name).mkdir(parents=True)
    lib = tree / "lib"
    build.lay_out(lib, tree / "bin")
    for plain in [*lib.glob("*.so"), *lib.glob("glu/*.so")]:
        versioned = [path.name for path in plain.parent.glob(f"{plain.name}.*")]
        if versioned:
            # As `cc -l` wants it.
            plain.unlink()
            plain.symlink_to(versioned[0])
    shutil.copytree(Path(__file__).parent / "include", tree / "include")
    registry = next(one for (name, _), one in packages(build.target).items() if name == "khronos_api")
    headers.write(
        tree / "include", Path(registry["manifest_path"]).parent, exports((lib / "libdetgl.so").read_bytes()))
    for name, (library, text) in PKG_CONFIG.items():
        (lib / f"pkgconfig/{name}.pc").write_text(pkg_config(name, library, text))
    for package in ["OSMesa", "DetGL"]:
        folder = lib / "cmake" / package
        folder.mkdir(parents=True)
        (folder / f"{package}Config.cmake").write_text(cmake(package))
        (folder / f"{package}ConfigVersion.cmake").write_text(CMAKE_VERSION)
    (lib / "cmake/modules").mkdir()
    (lib / "cmake/modules/FindOpenGL.cmake").write_text(FIND_OPENGL)
    for name in ["LICENSE-MIT", "LICENSE-APACHE"]:
        shutil.copy(ROOT / name, tree / "share/licenses/detgl" / name)
    (tree / "share/licenses/detgl/LICENSES-CRATES").write_text(licences(build.target))


def pkg_config(name, library, text):
    folders = "-L${libdir}/glu -L${libdir}" if library == "GLU" else "-L${libdir}"
    requires = "Requires: gl\n" if library == "GLU" else ""
    return (
        "prefix=${pcfiledir}/../..\nlibdir=${prefix}/lib\nincludedir=${prefix}/include\n\n"
        f"Name: {name}\nDescription: DetGL: {text}\nVersion: {VERSION}\n{requires}"
        f"Libs: {folders} -l{library}\nCflags: -I${{includedir}}\n"
    )


def cmake(package):
    """OSMesa::OSMesa, and DetGL::EGL, DetGL::GL, …; with the variables that older files use."""
    lines = ['get_filename_component(_detgl "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)']
    for library in LIBRARIES if package == "DetGL" else ["OSMesa"]:
        target = f"{package}::{library}"
        lines += [
            f"if(NOT TARGET {target})",
            f"  add_library({target} SHARED IMPORTED)",
            f"  set_target_properties({target} PROPERTIES",
            f'    IMPORTED_LOCATION "${{_detgl}}/lib/lib{library}.so"',
            '    INTERFACE_INCLUDE_DIRECTORIES "${_detgl}/include")',
            "endif()",
        ]
    if package == "OSMesa":
        lines += [
            'set(OSMESA_INCLUDE_DIR "${_detgl}/include")',
            'set(OSMESA_LIBRARY "${_detgl}/lib/libOSMesa.so")',
            "set(OSMESA_LIBRARIES ${OSMESA_LIBRARY})",
            "set(OSMESA_INCLUDE_DIRS ${OSMESA_INCLUDE_DIR})",
            # As a component of OpenGL, which CMake's module does not know: it takes the caller's word.
            "set(OpenGL_OSMesa_FOUND TRUE)",
            "if(NOT TARGET OpenGL::OSMesa)",
            "  add_library(OpenGL::OSMesa INTERFACE IMPORTED)",
            "  set_target_properties(OpenGL::OSMesa PROPERTIES INTERFACE_LINK_LIBRARIES OSMesa::OSMesa)",
            "endif()",
        ]
    return "\n".join([*lines, "unset(_detgl)", ""])


CMAKE_VERSION = f"""set(PACKAGE_VERSION {VERSION})
if(NOT PACKAGE_FIND_VERSION VERSION_GREATER PACKAGE_VERSION)
  set(PACKAGE_VERSION_COMPATIBLE TRUE)
endif()
"""
# In front of CMake's own module, for projects that ask for the component OSMesa and not for the package before.
FIND_OPENGL = """get_filename_component(_detgl_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
list(INSERT CMAKE_PREFIX_PATH 0 "${_detgl_prefix}")
include("${_detgl_prefix}/lib/cmake/OSMesa/OSMesaConfig.cmake")
include("${CMAKE_ROOT}/Modules/FindOpenGL.cmake")
unset(_detgl_prefix)
"""


def pack(tree, path, level):
    """Packs a folder; its files have no owner and no time."""
    text = io.BytesIO()
    with tarfile.open(fileobj=text, mode="w", format=tarfile.PAX_FORMAT) as archive:
        for file in [tree, *sorted(tree.rglob("*"))]:
            entry = archive.gettarinfo(file, arcname=file.relative_to(tree.parent).as_posix())
            entry.uid = entry.gid = entry.mtime = 0
            entry.uname = entry.gname = ""
            is_program = entry.isdir() or file.parent.name == "bin" or ".so" in file.name
            entry.mode = 0o755 if is_program else 0o644
            with file.open("rb") if entry.isfile() else io.BytesIO() as data:
                archive.addfile(entry, data if entry.isfile() else None)
    if shutil.which("zstd"):
        path = path.with_name(f"{path.name}.zst")
        subprocess.run(["zstd", f"-{level}", "-q", "-f", "-o", path], input=text.getvalue(), check=True)
    else:
        path = path.with_name(f"{path.name}.gz")
        path.write_bytes(gzip.compress(text.getvalue(), 9, mtime=0))
    return path


if __name__ == "__main__":
    main()
