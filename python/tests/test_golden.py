"""Comparison of pictures, and the pytest fixture."""

import struct
import zlib

import pytest
from detgl import digest, golden

pytest_plugins = ["pytester"]


def picture(text, shape):
    return memoryview(bytes(text)).cast("B", shape)


OLD = picture(range(24), (2, 4, 3))


@pytest.fixture
def blessed(tmp_path):
    golden.Golden(tmp_path / "golden", tmp_path / "failures", bless=True).check(OLD, "a")
    return golden.Golden(tmp_path / "golden", tmp_path / "failures")


def changed(at, value):
    text = bytearray(OLD.tobytes())
    text[at] = value
    return picture(text, OLD.shape)


def test_equal_pictures_pass(blessed):
    blessed.check(OLD, "a")
    assert not blessed.failures.exists()


def test_a_difference_says_how_many_how_much_and_where(blessed):
    with pytest.raises(golden.GoldenError, match=r"a: 1 pixels differ, by 2 at most, first at \(1, 1\)"):
        blessed.check(changed(17, 19), "a")
    apart = golden.read_png(blessed.failures / "a-difference.png")
    assert apart.data == bytes(17) + bytes([32]) + bytes(6)
    assert golden.read_png(blessed.failures / "a-old.png").data == OLD.tobytes()
    assert golden.read_png(blessed.failures / "a-new.png").data[17] == 19
    assert "<h1>1 pictures differ</h1>" in (blessed.failures / "index.html").read_text()


def test_a_tolerance_is_asked_for(blessed):
    blessed.check(changed(17, 19), "a", tolerance=2)
    with pytest.raises(golden.GoldenError):
        blessed.check(changed(17, 19), "a", tolerance=1)


def test_another_shape_and_no_picture_fail(blessed):
    with pytest.raises(golden.GoldenError, match="the old is 4×2 of 3 components, the new 3×2"):
        blessed.check(picture(range(18), (2, 3, 3)), "a")
    with pytest.raises(golden.GoldenError, match="no picture to compare with"):
        blessed.check(OLD, "b")


def test_a_difference_of_alpha_alone_is_seen():
    before, after = picture([9, 9, 9, 255], (1, 1, 4)), picture([9, 9, 9, 250], (1, 1, 4))
    assert golden.compare(before, after).picture().data == bytes([80, 80, 80])


@pytest.mark.parametrize("shape", [(2, 12), (2, 12, 1), (3, 4, 2), (2, 4, 3), (3, 2, 4)])
def test_pictures_are_read_as_they_were_written(tmp_path, shape):
    golden.write_png(tmp_path / "a.png", picture(range(24), shape))
    assert golden.read_png(tmp_path / "a.png").data == bytes(range(24))


def filtered(kind):
    """The picture of 3×2 RGB pixels 0, 40, 80, … with one of PNG's filters, as another program would write it."""
    rows = [bytes(range(0, 90, 10)), bytes(range(90, 180, 10))]
    text = b""
    for y, row in enumerate(rows):
        out = []
        for x, value in enumerate(row):
            left, up = (row[x - 3] if x > 2 else 0), (rows[0][x] if y else 0)
            corner = rows[0][x - 3] if y and x > 2 else 0
            guess = [0, left, up, (left + up) // 2, None][kind]
            if guess is None:
                base = left + up - corner
                guess = min((left, up, corner), key=lambda found: abs(base - found))
            out.append((value - guess) & 255)
        text += bytes([kind]) + bytes(out)
    return text, b"".join(rows)


@pytest.mark.parametrize("kind", range(5))
def test_filters_of_png_are_read(tmp_path, kind):
    text, expected = filtered(kind)
    chunk = lambda name, data: struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    header = chunk(b"IHDR", struct.pack(">IIBBBBB", 3, 2, 8, 2, 0, 0, 0))
    (tmp_path / "a.png").write_bytes(golden._SIGNATURE + header + chunk(b"IDAT", zlib.compress(text)) + chunk(b"IEND", b""))
    assert golden.read_png(tmp_path / "a.png").data == expected


def test_a_digest_is_of_size_format_and_bytes():
    # By printf '2x4x3 B\n\x00\x01…\x17' | sha256sum.
    assert digest(OLD) == "2db9f17b72bd6577fdec0ad5e75a1d3cfadb72b2d9dac27ea0b4f2da15c782e0"
    others = [picture(range(24), (4, 2, 3)), changed(0, 1), memoryview(bytes(range(24))).cast("b", (2, 4, 3))]
    assert len({digest(OLD), *map(digest, others)}) == 4


TESTS = """
def picture(text):
    return memoryview(bytes(text)).cast("B", (1, 2, 3))

def test_one(golden):
    golden.check(picture([0, 0, 0, 9, 9, VALUE]), "one")

def test_two(golden):
    golden.check(picture([1, 1, 1, 9, 9, VALUE]), "sub/two")
"""


def test_the_fixture_blesses_compares_and_reports(pytester):
    pytester.makepyfile(TESTS.replace("VALUE", "9"))
    pytester.runpytest_subprocess().assert_outcomes(failed=2)
    pytester.runpytest_subprocess("--bless").assert_outcomes(passed=2)
    pytester.runpytest_subprocess().assert_outcomes(passed=2)
    assert not (pytester.path / "golden-failures").exists()
    pytester.makepyfile(TESTS.replace("VALUE", "8"))
    result = pytester.runpytest_subprocess()
    result.assert_outcomes(failed=2)
    result.stdout.fnmatch_lines(["*GoldenError: one: 1 pixels differ, by 1 at most, first at (1, 0)*"])
    page = (pytester.path / "golden-failures" / "index.html").read_text()
    assert "2 pictures differ" in page and 'src="sub/two-difference.png"' in page
