"""OpenGL, EGL and OSMesa in software, with the same bits on every machine.

    import detgl
    detgl.use()              # before what draws is imported: mujoco, OpenGL, moderngl, vtk, …

`python -m detgl run script.py` and `detgl run -- program` do the same for programs that are not changed."""

import ctypes
import ctypes.util
import os
import sys
from pathlib import Path

from .digest import digest

__all__ = ["DetGLError", "digest", "info", "libraries", "messages", "use", "version"]

# libGLU is the system's, if there is one.
_NAMES = ("EGL", "GL", "OpenGL", "GLESv2", "OSMesa")
# These choose or load a driver when they are imported, or soon after.
_CLIENTS = (
    "mujoco", "OpenGL.platform", "dm_control._render", "glcontext", "moderngl", "vtkmodules", "pyglet.gl", "pyrender",
    "vispy.gloo", "glfw", "sdl2", "pygame.display", "kivy.core.window", "panda3d.core", "arcade", "wgpu",
)
_VARIABLES = ("ISA", "THREADS", "DRAW_BUDGET", "GL_VERSION", "EXPLAIN", "LEAVE_OUT", "DEBUG")
# By these, clients choose between EGL and OSMesa.
_PLATFORMS = ("PYOPENGL_PLATFORM", "MUJOCO_GL")

_library = None
_asked = {}


class DetGLError(RuntimeError):
    """DetGL cannot be used: says what is in the way, and what helps."""


def libraries():
    """The folder of the libraries: for LD_LIBRARY_PATH."""
    return Path(__file__).resolve().parent / "lib"


def use(platform=None, **variables):
    """Has everything that is imported from now on draw with DetGL: loads the libraries under the names that other
    modules look for.

    platform is "egl" or "osmesa", what MUJOCO_GL and PYOPENGL_PLATFORM are set to; without it the one that is set in
    either, else "egl". Others are DETGL_* variables in small letters: threads=1, isa="baseline", debug=1,
    gl_version="4.1", draw_budget=…, explain=1, leave_out=0. The bits do not depend on threads, isa and leave_out."""
    global _library
    unknown = [name for name in variables if name.upper() not in _VARIABLES]
    if unknown:
        known = ", ".join(name.lower() for name in _VARIABLES)
        raise TypeError(f"detgl.use() has no keyword {unknown[0]}: there are platform, {known}")
    if platform not in (None, "egl", "osmesa"):
        raise ValueError(f'detgl.use(platform={platform!r}): must be "egl" or "osmesa"')
    asked = {f"DETGL_{name.upper()}": _text(value) for name, value in variables.items()}
    if _library is not None:
        if {**_asked, **asked} != _asked:
            raise DetGLError("detgl.use() was called before, with other settings: they are read once, so call it once")
        return
    _check_in_time(platform)
    os.environ.update(asked)
    _choose_platform(platform)
    folder = libraries()
    _library = ctypes.CDLL(str(folder / "libdetgl.so"), ctypes.RTLD_GLOBAL)
    _asked.update(asked)
    for name in _NAMES:
        for path in sorted(folder.glob(f"lib{name}.so*")):
            ctypes.CDLL(str(path), ctypes.RTLD_GLOBAL)
    try:
        # It works on top of DetGL, whose libGL.so.1 it finds loaded.
        ctypes.CDLL("libGLU.so.1", ctypes.RTLD_GLOBAL)
    except OSError:
        for path in sorted((folder / "glu").glob("libGLU.so*")):
            ctypes.CDLL(str(path), ctypes.RTLD_GLOBAL)
    os.environ.setdefault("__EGL_VENDOR_LIBRARY_FILENAMES", str(folder / "egl_vendor.json"))
    _answer_find_library(folder)


def _text(value):
    return str(int(value)) if isinstance(value, bool) else str(value)


def _check_in_time(platform):
    """Raises if other modules have chosen their driver already."""
    # In the order in which their imports ended: one that imports another comes after it.
    early = [name for name in sys.modules if name in _CLIENTS]
    loaded = _foreign_library()
    if loaded is None and (not early or _is_started_by_run(platform)):
        return
    are = "were" if len(early) > 1 else "was"
    what = f"{', '.join(early)} {are} imported" if early else "something has loaded OpenGL"
    where = f", and {loaded} is loaded" if loaded else ""
    script = Path(sys.argv[0]).name
    raise DetGLError(
        f"detgl.use() came too late: {what} before{where}. Call it first, or run the whole program by "
        f"`python -m detgl run {script if script.endswith('.py') else 'script.py'}`"
    )


def _is_started_by_run(platform):
    """Whether `detgl run` started this process, so that what was imported before has chosen these libraries, too, and the
    platform."""
    folders = os.environ.get("LD_LIBRARY_PATH", "").split(":")
    return str(libraries()) in folders and all(platform in (None, os.environ.get(name)) for name in _PLATFORMS)


def _foreign_library():
    """Another driver that this process has loaded already."""
    own = str(libraries())
    names = tuple(f"lib{name}.so" for name in _NAMES)
    try:
        lines = Path("/proc/self/maps").read_text().splitlines()
    except OSError:
        return None
    paths = [line.split(maxsplit=5)[5] for line in lines if line.count("/") and len(line.split(maxsplit=5)) == 6]
    found = (path for path in paths if Path(path).name.startswith(names) and not path.startswith(own))
    return next(found, None)


def _choose_platform(platform):
    if platform:
        os.environ.update(dict.fromkeys(_PLATFORMS, platform))
    # Clients that go through PyOpenGL need both to agree.
    chosen = next((os.environ[name] for name in _PLATFORMS if os.environ.get(name)), "egl")
    for name in _PLATFORMS:
        if not os.environ.get(name):
            os.environ[name] = chosen


def _answer_find_library(folder):
    """ctypes.util.find_library asks tools that do not know what is loaded."""
    before = ctypes.util.find_library
    names = {name: next(path.name for path in folder.glob(f"lib{name}.so.*")) for name in _NAMES}

    def find_library(name):
        return names.get(name) or before(name)

    ctypes.util.find_library = find_library


def _text_of(function, size=1 << 16):
    buffer = ctypes.create_string_buffer(size)
    function.argtypes, function.restype = (ctypes.c_char_p, ctypes.c_int), ctypes.c_int
    function(buffer, size)
    return buffer.value.decode()


def _loaded():
    return _library or ctypes.CDLL(str(libraries() / "libdetgl.so"))


def version():
    """DetGL's version."""
    return info()["version"]


def info():
    """What contexts of this process have: the version, the instruction set, the number of threads, the versions of
    OpenGL and OpenGL ES, and limits."""
    pairs = (line.split("=", 1) for line in _text_of(_loaded().detglInfo).splitlines())
    found = {name: int(value) if value.isdigit() else value for name, value in pairs}
    if "error" in found:
        raise DetGLError(found["error"])
    return found


def messages():
    """Takes the messages of the thread's current context, oldest first: what was refused, and why a picture may not be
    what was meant."""
    found = []
    while message := _text_of(_loaded().detglNextMessage):
        found.append(message)
    return found
