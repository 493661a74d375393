"""The backend of `python3 -m pip wheel ./python` (PEP 517): builds the libraries with cargo, packs them with the module.

These settings are taken (`-C NAME=VALUE`):

target=TRIPLE   builds for another machine, as aarch64-unknown-linux-gnu, whose standard library rustup must have
native=1        builds with this machine's linker alone: for this machine and later ones, nothing is fetched for it
prebuilt=DIR    builds nothing: libdetgl.so and detgl are in DIR

The same commit gives the same bytes."""

import base64
import hashlib
import sys
import tempfile
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "package"))

from build_libraries import LINKER, ROOT, VERSION, Build, licences, platform_of  # noqa: E402

METADATA = f"""Metadata-Version: 2.4
Name: detgl
Version: {VERSION}
Summary: OpenGL, EGL and OSMesa in software, with the same bits on every machine
License-Expression: MIT OR Apache-2.0
License-File: LICENSE-MIT
License-File: LICENSE-APACHE
License-File: LICENSES-CRATES
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
    build = Build(settings.get("target"), settings.get("prebuilt"), native="native" in settings)
    with tempfile.TemporaryDirectory() as folder:
        libraries = Path(folder)
        build.lay_out(libraries, libraries)
        tag = f"py3-none-{platform_of(libraries)}"
        path = Path(wheel_directory) / f"detgl-{VERSION}-{tag}.whl"
        pack(path, tag, libraries, licences(build.target))
    return path.name


def pack(path, tag, libraries, crates):
    """Writes the wheel."""
    wheel = f"Wheel-Version: 1.0\nGenerator: build_wheel\nRoot-Is-Purelib: false\nTag: {tag}\n"
    files = {f"detgl/{file.name}": file.read_bytes() for file in (HERE / "detgl").glob("*.py")}
    for file in libraries.rglob("*"):
        if file.is_file():
            files[f"detgl/lib/{file.relative_to(libraries).as_posix()}"] = file.read_bytes()
    for name in ["LICENSE-MIT", "LICENSE-APACHE"]:
        files[f"{INFO}/licenses/{name}"] = (ROOT / name).read_bytes()
    files[f"{INFO}/licenses/LICENSES-CRATES"] = crates.encode()
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
