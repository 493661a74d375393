"""The module in processes of their own, as what is loaded stays."""

import os
import subprocess
import sys

import pytest


def run(text, **variables):
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("DETGL_", "MUJOCO_", "PYOPENGL"))}
    command = [sys.executable, "-c", text]
    return subprocess.run(command, env={**environment, **variables}, capture_output=True, text=True)


def output(text, **variables):
    done = run(text, **variables)
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


def error(text, **variables):
    done = run(text, **variables)
    assert done.returncode != 0, done.stdout
    return done.stderr.strip().splitlines()[-1]


def test_names_that_are_loaded_later_are_detgls():
    names = ["libEGL.so.1", "libEGL.so", "libGL.so.1", "libGL.so", "libOSMesa.so.8", "libOSMesa.so", "libGLESv2.so.2"]
    text = f"""
import ctypes, ctypes.util, detgl
detgl.use()
own = ctypes.CDLL(str(detgl.libraries() / "libdetgl.so"))
address = lambda function: ctypes.cast(function, ctypes.c_void_p).value
for name in {names}:
    function = "eglInitialize" if "EGL" in name else "glFinish"
    assert address(getattr(ctypes.CDLL(name), function)) == address(getattr(own, function)), name
assert ctypes.util.find_library("GL") == "libGL.so.1"
assert ctypes.util.find_library("m")
"""
    assert output(text) == ""


@pytest.mark.parametrize("before, expected", [
    ({}, "egl egl"),
    ({"MUJOCO_GL": "osmesa"}, "osmesa osmesa"),
    ({"PYOPENGL_PLATFORM": "osmesa", "MUJOCO_GL": "egl"}, "osmesa egl"),
])
def test_a_platform_that_is_set_stays(before, expected):
    text = 'import os, detgl; detgl.use(); print(os.environ["PYOPENGL_PLATFORM"], os.environ["MUJOCO_GL"])'
    assert output(text, **before) == expected


def test_keywords_are_variables():
    text = 'import detgl; detgl.use(threads=3, isa="baseline"); found = detgl.info(); print(found["threads"], found["isa"])'
    assert output(text) == "3 baseline"


def test_every_variable_that_contexts_read_is_a_keyword():
    # As the README's table of variables has them, without those of the tests.
    words = dict(draw_budget=1000, gl_version="4.1", explain=0, leave_out=0, debug=0)
    text = f'import os, detgl; detgl.use(**{words}); print({{name: os.environ["DETGL_" + name.upper()] for name in {list(words)}}})'
    assert output(text) == str({name: str(value) for name, value in words.items()})


@pytest.mark.parametrize("text, said", [
    ("detgl.use(thread=1)", "no keyword thread"),
    ('detgl.use(platform="glx")', 'must be "egl" or "osmesa"'),
    ("detgl.use(threads=1); detgl.use(threads=2)", "called before, with other settings"),
    ('detgl.use(isa="mmx"); detgl.info()', "DETGL_ISA=mmx: this machine has"),
    ("import OpenGL.platform; detgl.use()", "came too late: OpenGL.platform was imported before"),
    ("import mujoco; detgl.use()", "mujoco w"),
])
def test_what_is_refused(text, said):
    for module in ("OpenGL", "mujoco"):
        if f"import {module}" in text:
            pytest.importorskip(module)
    assert said in error(f"import detgl; {text}")


def test_use_again_is_no_error():
    assert output("import detgl; detgl.use(threads=1); detgl.use(); detgl.use(threads=1)") == ""


def test_messages_are_those_of_the_current_context():
    text = """
import ctypes, detgl
detgl.use(platform="osmesa", debug=0)
gl = ctypes.CDLL("libOSMesa.so.8")
gl.OSMesaCreateContext.restype = ctypes.c_void_p
memory = (ctypes.c_ubyte * 64)()
gl.OSMesaMakeCurrent(ctypes.c_void_p(gl.OSMesaCreateContext(0x1908, None)), memory, 0x1401, 4, 4)
gl.glEnable(1)
(message,) = detgl.messages()
assert message.startswith("error: glEnable: "), message
assert detgl.messages() == []
"""
    assert output(text) == ""


def test_the_command_runs_scripts_and_programs(tmp_path):
    script = tmp_path / "script.py"
    script.write_text("import os; print(os.environ['LD_LIBRARY_PATH'])")
    folder = output("import detgl; print(detgl.libraries())")
    for arguments in (["run", str(script)], ["run", "--", sys.executable, str(script)], ["run", "--glu", str(script)]):
        done = subprocess.run([sys.executable, "-m", "detgl", *arguments], capture_output=True, text=True)
        assert folder in done.stdout.strip().split(":"), done.stderr


@pytest.mark.parametrize("call, said", [
    ("detgl.use(threads=2)", ""),
    ('detgl.use(platform="egl")', ""),
    ('detgl.use(platform="osmesa")', "came too late: OpenGL.platform was imported before"),
])
def test_a_script_that_the_command_runs_may_call_use_late(tmp_path, call, said):
    pytest.importorskip("OpenGL")
    script = tmp_path / "script.py"
    script.write_text(f"import OpenGL.platform, detgl\n{call}\n")
    done = subprocess.run([sys.executable, "-m", "detgl", "run", str(script)], capture_output=True, text=True)
    assert said in done.stderr and (done.returncode == 0) == (said == ""), done.stderr
