"""Tests of pictures: `pytest examples/python` compares with golden/, `pytest --bless` writes that."""

import subprocess
import sys
from pathlib import Path

import moderngl_rings
import pytest


def test_rings(golden):
    golden.check(moderngl_rings.draw(), "rings")


def test_rings_by_a_number(golden):
    # In place of a picture: size, format and bytes.
    assert golden.digest(moderngl_rings.draw()) == "3ee0148cd132a5b74ff121f53813c8248af3e3b9718fab7bfb47b7d85b0a27d9"


@pytest.mark.parametrize("name", ["lecture"])
def test_programs(golden, name, tmp_path):
    # In a process of its own: a process draws by EGL or by OSMesa.
    out = tmp_path / f"{name}.png"
    subprocess.run([sys.executable, Path(__file__).with_name(f"{name}.py"), out], check=True)
    golden.check_file(out, name)
