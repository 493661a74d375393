"""The build backend (PEP 517) of the wheel `detgl`: builds the libraries with cargo, and packs them with the module.

`python3 -m pip wheel ./python` takes these settings (`-C NAME=VALUE`):

target=TRIPLE   builds for another machine, as aarch64-unknown-linux-gnu, whose standard library rustup must have
native=1        builds with this machine's linker alone: for this machine and later ones, nothing is fetched for it
prebuilt=DIR    builds nothing: libdetgl.so and detgl are in DIR

The same commit gives the same bytes."""

import base64
import hashlib
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
# Zig links against the symbols of any version of glibc.
LINKER = ["cargo-zigbuild==0.24.1", "ziglang==0.17.1"]
# The oldest glibc that Rust's standard library runs on, and what `manylinux_2_17` promises.
OLDEST_GLIBC = (2, 17)
# manylinux_2_17 (PEP 599) lets these be needed.
ALLOWED = re.compile(r"lib(c|m|dl|pthread|rt|gcc_s)\.so\.\d+|ld-linux[-\w]*\.so\.\d+|libdetgl\.so")
# The instruction sets by their names in ELF files, in wheels' tags, and in Rust's targets.
MACHINES = {62: "x86_64", 183: "aarch64"}

VERSION = re.search(r'^version = "(.+?)"', (ROOT / "Cargo.toml").read_text(), re.M)[1]
METADATA = f"""Metadata-Version: 2.4
Name: detgl
Version: {VERSION}
Summary: OpenGL, EGL and OSMesa in software, with the same bits on every machine
License-Expression: MIT OR Apache-2.0
License-File: LICENSE-MIT
License-File: LICENSE-APACHE
Requires-Python: >=3.9
Classifier: Framework :: Pytest
Classifier: Operating System :: POSIX :: Linux
Classifier: Topic :: Multimedia :: Graphics :: 3D Rendering
Description-Content-Type: text/markdown

{(HERE / "README.md").read_text()}"""
ENTRY_POINTS = """[console_scripts]
detgl = detgl.__main__:main

[pytest11]
detgl = detgl.pytest_plugin
"""
TEXTS = {"METADATA": METADATA, "entry_points.txt": ENTRY_POINTS}
INFO = f"detgl-{VERSION}.dist-info"


def get_requires_for_build_wheel(config_settings=None):
    settings = config_settings or {}
    return [] if "prebuilt" in settings or "native" in settings else LINKER


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    folder = Path(metadata_directory) / INFO
    folder.mkdir()
    for name, text in TEXTS.items():
        (folder / name).write_text(text)
    return folder.name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    settings = config_settings or {}
    target = settings.get("target") or host()
    if "prebuilt" in settings:
        built = Path(settings["prebuilt"])
    else:
        built = compile_library(target, native="native" in settings)
    with tempfile.TemporaryDirectory() as folder:
        libraries = Path(folder)
        lay_out(built, libraries, target)
        tag = f"py3-none-{platform_of(libraries)}"
        path = Path(wheel_directory) / f"detgl-{VERSION}-{tag}.whl"
        pack(path, tag, libraries)
    return path.name


def host():
    text = subprocess.run(["rustc", "-vV"], cwd=ROOT, check=True, capture_output=True, text=True)
    return re.search(r"^host: (.+)$", text.stdout, re.M)[1]


def compile_library(target, native):
    """Builds the library and the command; the folder that they are in."""
    command, triple = ["cargo", "build"], target
    if not native:
        command = [shutil.which("cargo-zigbuild") or "cargo-zigbuild", "zigbuild"]
        triple = f"{target}.{OLDEST_GLIBC[0]}.{OLDEST_GLIBC[1]}"
    target_dir = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")).resolve()
    command += ["--release", "-p", "capi", "--locked", "--target", triple, "--target-dir", str(target_dir)]
    environment = dict(os.environ)
    # Zig is found as a module of this Python.
    environment["CARGO_ZIGBUILD_PYTHON_PATH"] = sys.executable
    subprocess.run(command, cwd=ROOT, check=True, env=environment)
    return target_dir / target / "release"


def lay_out(built, folder, target):
    """The libraries as `detgl install` lays them out, and the command beside them."""
    command = [built / "detgl", "install"]
    if target != host():
        # This machine's command lays out the other's library.
        command = [compile_library(host(), native=True) / "detgl", "install", "--library", built / "libdetgl.so"]
    subprocess.run([*command, "--no-links", folder], check=True, stdout=subprocess.DEVNULL)
    shutil.copy(built / "detgl", folder / "detgl")


def platform_of(libraries):
    """The platform of the tag, by what the files need of the machine."""
    machines, newest, foreign = set(), (0, 0), set()
    for path in sorted(libraries.rglob("*")):
        if path.is_file() and path.suffix != ".json":
            machine, needed, versions = read_elf(path.read_bytes())
            machines.add(machine)
            foreign.update(name for name in needed if not ALLOWED.fullmatch(name))
            newest = max([newest, *versions])
    (machine,) = machines
    name = MACHINES.get(machine) or os.uname().machine
    if foreign:
        print(f"not manylinux: needs {', '.join(sorted(foreign))}", file=sys.stderr)
        return f"linux_{name}"
    # That of the tag is the least version that the files run on.
    major, minor = max(newest, OLDEST_GLIBC)
    return f"manylinux_{major}_{minor}_{name}"


def read_elf(data):
    """The machine, the libraries and the versions of glibc that a 64-bit file needs."""
    if data[:6] != b"\x7fELF\x02\x01":
        raise SystemExit("the library is not a 64-bit little-endian ELF file")
    machine = struct.unpack_from("<H", data, 18)[0]
    table, = struct.unpack_from("<Q", data, 40)
    size, count = struct.unpack_from("<HH", data, 58)
    sections = [struct.unpack_from("<IIQQQQIIQQ", data, table + size * at) for at in range(count)]

    def text(link, at):
        start = sections[link][4] + at
        return data[start:data.index(b"\0", start)].decode()

    needed, versions = [], []
    for _, kind, _, _, offset, length, link, _, _, _ in sections:
        if kind == 6:  # SHT_DYNAMIC
            for tag, value in struct.iter_unpack("<QQ", data[offset:offset + length]):
                if tag == 1:  # DT_NEEDED
                    needed.append(text(link, value))
        elif kind == 0x6FFFFFFE:  # SHT_GNU_verneed
            at = offset
            while True:
                _, parts, _, part, step = struct.unpack_from("<HHIII", data, at)
                part += at
                for _ in range(parts):
                    _, _, _, name, next_part = struct.unpack_from("<IHHII", data, part)
                    version = re.fullmatch(r"GLIBC_(\d+)\.(\d+)[.\d]*", text(link, name))
                    if version:
                        versions.append((int(version[1]), int(version[2])))
                    part += next_part
                if step == 0:
                    break
                at += step
    return machine, needed, versions


def pack(path, tag, libraries):
    """Writes the wheel."""
    wheel = f"Wheel-Version: 1.0\nGenerator: build_wheel\nRoot-Is-Purelib: false\nTag: {tag}\n"
    files = {f"detgl/{file.name}": file.read_bytes() for file in (HERE / "detgl").glob("*.py")}
    for file in libraries.rglob("*"):
        if file.is_file():
            files[f"detgl/lib/{file.relative_to(libraries).as_posix()}"] = file.read_bytes()
    for name in ["LICENSE-MIT", "LICENSE-APACHE"]:
        files[f"{INFO}/licenses/{name}"] = (ROOT / name).read_bytes()
    for name, text in {**TEXTS, "WHEEL": wheel}.items():
        files[f"{INFO}/{name}"] = text.encode()
    record = ""
    for name in sorted(files):
        digest = base64.urlsafe_b64encode(hashlib.sha256(files[name]).digest()).rstrip(b"=").decode()
        record += f"{name},sha256={digest},{len(files[name])}\n"
    files[f"{INFO}/RECORD"] = f"{record}{INFO}/RECORD,,\n".encode()
    # RECORD is the last, as the format of wheels wants it.
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name in sorted(files, key=lambda name: (name.endswith("/RECORD"), name)):
            entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            is_program = name == "detgl/lib/detgl" or ".so" in name
            entry.external_attr = (0o100755 if is_program else 0o100644) << 16
            archive.writestr(entry, files[name])
