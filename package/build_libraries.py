"""Builds the libraries and the command with cargo, and reads what they need of a machine."""

import argparse
import json
import os
import re
import shutil
import struct
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
VERSION = re.search(r'^version = "(.+?)"', (ROOT / "Cargo.toml").read_text(), re.M)[1]
# Zig links against the symbols of any version of glibc.
LINKER = ["cargo-zigbuild==0.24.1", "ziglang==0.17.1"]
# The oldest glibc that Rust's standard library runs on, and what `manylinux_2_17` promises.
OLDEST_GLIBC = (2, 17)
# What may be needed: glibc's own files, fewer than manylinux_2_17 (PEP 599) lets, and the library itself.
ALLOWED = re.compile(r"lib(c|m|dl|pthread)\.so\.\d+|ld-linux[-\w]*\.so\.\d+|libdetgl\.so")
# Instruction sets by their numbers in ELF files.
MACHINES = {62: "x86_64", 183: "aarch64"}


def host():
    text = subprocess.run(["rustc", "-vV"], cwd=ROOT, check=True, capture_output=True, text=True)
    return re.search(r"^host: (.+)$", text.stdout, re.M)[1]


def packages(target):
    """The crates of the workspace and all that they use, by name and version."""
    command = ["cargo", "metadata", "--format-version=1", "--locked", "--filter-platform", target]
    text = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    return {(one["name"], one["version"]): one for one in json.loads(text)["packages"]}


def licences(target):
    """The licences of the crates that are linked in, each text once."""
    command = ["cargo", "tree", "-p", "capi", "-e", "normal,no-proc-macro", "--prefix", "none", "--format", "{p}"]
    command += ["--locked", "--target", target]
    text = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    linked = {(line.split()[0], line.split()[1].removeprefix("v")) for line in text.splitlines() if line}
    crates = packages(target)
    texts, terms = {}, []
    for name, version in sorted(linked):
        crate = crates[name, version]
        if crate["source"] is None:
            continue
        terms.append(f"{name} {version}: {crate['license']}")
        folder = Path(crate["manifest_path"]).parent
        for file in sorted(folder.iterdir()):
            if re.match(r"(LICEN[CS]E|COPYING|NOTICE|UNLICENSE)", file.name, re.I) and file.is_file():
                texts.setdefault(file.read_text(errors="replace").strip(), []).append(f"{name} {version}")
    parts = [f"{', '.join(names)}:\n\n{text}" for text, names in texts.items()]
    rule = "\n\n" + "-" * 80 + "\n\n"
    return rule.join(["DetGL's library has these crates in it:\n\n" + "\n".join(terms), *parts]) + "\n"


def parser_of(doc):
    """The options of a script that packages a Build: its three arguments, and where it writes."""
    parser = argparse.ArgumentParser(description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--target", help="builds for another machine: aarch64-unknown-linux-gnu")
    parser.add_argument("--native", action="store_true", help="links with this machine's linker and its glibc")
    parser.add_argument("--prebuilt", metavar="DIR", help="builds nothing: libdetgl.so and detgl are in DIR")
    parser.add_argument("--out", default="dist", metavar="DIR")
    return parser


class Build:
    """libdetgl.so and detgl for a target, as cargo builds them; native is with this machine's linker alone, prebuilt
    a folder in which they are."""

    def __init__(self, target=None, prebuilt=None, native=False):
        self.host = host()
        self.native = native or prebuilt is not None
        self.target = target or self.host
        self.folder = Path(prebuilt) if prebuilt else self._compile(self.target, native)

    def _compile(self, target, native):
        command, triple = ["cargo", "build"], target
        if not native:
            command = [shutil.which("cargo-zigbuild") or "cargo-zigbuild", "zigbuild"]
            triple = f"{target}.{OLDEST_GLIBC[0]}.{OLDEST_GLIBC[1]}"
        target_dir = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")).resolve()
        # No path of this machine is in the files, so that two machines build the same.
        cargo_home = Path(os.environ.get("CARGO_HOME", Path.home() / ".cargo")).resolve()
        flags = [f"--remap-path-prefix={cargo_home}=cargo", f"--remap-path-prefix={ROOT}=detgl"]
        command += ["--config", f"target.{target}.rustflags={flags}"]
        command += ["--release", "-p", "capi", "--locked", "--target", triple, "--target-dir", str(target_dir)]
        # Zig is found as a module of this Python.
        environment = {**os.environ, "CARGO_ZIGBUILD_PYTHON_PATH": sys.executable}
        if not native:
            # A linker that is set for the target would be taken in place of Zig's.
            environment.pop(f"CARGO_TARGET_{target.upper().replace('-', '_')}_LINKER", None)
        subprocess.run(command, cwd=ROOT, check=True, env=environment)
        folder = target_dir / target / "release"
        if not native:
            require_portable([folder / "libdetgl.so", folder / "detgl"])
        return folder

    def lay_out(self, libraries, programs):
        """The libraries as `detgl install --no-links` lays them out, and the command."""
        command = [self.folder / "detgl", "install"]
        if self.target != self.host:
            # This machine's command lays out the other's library; its own package has the same build.
            own = self._compile(self.host, self.native) / "detgl"
            command = [own, "install", "--library", self.folder / "libdetgl.so"]
        subprocess.run([*command, "--no-links", libraries], check=True, stdout=subprocess.DEVNULL)
        shutil.copy(self.folder / "detgl", programs / "detgl")


def needs_of(files):
    """The machines of some files, the libraries that they need and may not, the newest version of glibc."""
    machines, newest, foreign = set(), (0, 0), set()
    for path in files:
        data = path.read_bytes() if path.is_file() else b""
        if data.startswith(b"\x7fELF"):
            machine, needed, versions = read_elf(data)
            machines.add(machine)
            foreign.update(name for name in needed if not ALLOWED.fullmatch(name))
            newest = max([newest, *versions])
    return machines, foreign, newest


def require_portable(files):
    """Ends where a file needs another library than glibc's, or a later glibc than the oldest."""
    _, foreign, newest = needs_of(files)
    if foreign or newest > OLDEST_GLIBC:
        found = ", ".join([*sorted(foreign), *([f"glibc {newest[0]}.{newest[1]}"] if newest > OLDEST_GLIBC else [])])
        names = ", ".join(path.name for path in files)
        raise SystemExit(f"{names} must need no library but glibc {OLDEST_GLIBC[0]}.{OLDEST_GLIBC[1]}: needs {found}")


def platform_of(libraries):
    """The platform of the tag, by what the files need of the machine."""
    machines, foreign, newest = needs_of(sorted(libraries.rglob("*")))
    (machine,) = machines
    name = MACHINES.get(machine) or os.uname().machine
    if foreign:
        print(f"not manylinux: needs {', '.join(sorted(foreign))}", file=sys.stderr)
        return f"linux_{name}"
    # That of the tag is the least version that the files run on.
    major, minor = max(newest, OLDEST_GLIBC)
    return f"manylinux_{major}_{minor}_{name}"


class Elf:
    """A 64-bit little-endian ELF file."""

    def __init__(self, data):
        if data[:6] != b"\x7fELF\x02\x01":
            raise SystemExit("the library is not a 64-bit little-endian ELF file")
        self.data = data
        self.machine, = struct.unpack_from("<H", data, 18)
        table, = struct.unpack_from("<Q", data, 40)
        size, count = struct.unpack_from("<HH", data, 58)
        self.sections = [struct.unpack_from("<IIQQQQIIQQ", data, table + size * at) for at in range(count)]

    def sections_of(self, wanted):
        """Where sections of a type lie, and the section of their texts."""
        for _, kind, _, _, offset, length, link, _, _, _ in self.sections:
            if kind == wanted:
                yield offset, length, link

    def text(self, link, at):
        start = self.sections[link][4] + at
        return self.data[start:self.data.index(b"\0", start)].decode()


def read_elf(data):
    """The machine, the libraries and the versions of glibc that a file needs."""
    elf = Elf(data)
    needed, versions = [], []
    for offset, length, link in elf.sections_of(6):  # SHT_DYNAMIC
        for tag, value in struct.iter_unpack("<QQ", data[offset:offset + length]):
            if tag == 1:  # DT_NEEDED
                needed.append(elf.text(link, value))
    for at, _, link in elf.sections_of(0x6FFFFFFE):  # SHT_GNU_verneed
        step = 1
        while step:
            _, parts, _, part, step = struct.unpack_from("<HHIII", data, at)
            part += at
            for _ in range(parts):
                _, _, _, name, next_part = struct.unpack_from("<IHHII", data, part)
                version = re.fullmatch(r"GLIBC_(\d+)\.(\d+)[.\d]*", elf.text(link, name))
                if version:
                    versions.append((int(version[1]), int(version[2])))
                part += next_part
            at += step
    return elf.machine, needed, versions


def exports(data):
    """The names of the functions that a library has for others."""
    elf = Elf(data)
    names = []
    for offset, length, link in elf.sections_of(11):  # SHT_DYNSYM
        for name, info, _, section, _, _ in struct.iter_unpack("<IBBHQQ", data[offset:offset + length]):
            if info == 0x12 and section:  # STB_GLOBAL, STT_FUNC
                names.append(elf.text(link, name))
    return names
