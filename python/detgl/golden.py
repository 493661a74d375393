"""Pictures that are compared with those that somebody has looked at.

With pytest, the fixture `golden`:

    def test_scene(golden):
        golden.check(render(), "scene")

compares with golden/scene.png beside the test, exactly. `pytest --bless` writes that picture: look at it. For a
difference the old, the new and the difference × 16 are in golden-failures/, with a page, index.html.

Without pytest: Golden(folder, failures).check(…). Pictures are arrays of uint8, rows × columns (× 1 to 4 components)."""

import html
import struct
import zlib
from pathlib import Path

from .digest import digest

__all__ = ["Difference", "Golden", "GoldenError", "compare", "digest", "read_png", "write_png"]

_SIGNATURE = b"\x89PNG\r\n\x1a\n"
# Components by PNG's colour type (the PNG specification, section 11.2.2).
_COMPONENTS = {0: 1, 2: 3, 4: 2, 6: 4}
_AMPLIFIED = 16


class GoldenError(AssertionError):
    """A picture is not the one that was looked at."""


class Picture:
    """Rows of bytes, from the top."""

    def __init__(self, width, height, components, data):
        self.width, self.height, self.components, self.data = width, height, components, data

    @classmethod
    def of(cls, array):
        view = memoryview(array)
        if view.ndim not in (2, 3) or view.format.lstrip("<>=@") != "B":
            raise TypeError(
                f"golden: a picture has rows, columns and components of uint8, this has shape {view.shape} and "
                f"format {view.format!r}"
            )
        height, width, components = (*view.shape, 1)[:3]
        if not 1 <= components <= 4:
            raise TypeError(f"golden: a picture has 1 to 4 components, this has {components}")
        return cls(width, height, components, view.tobytes())

    def __str__(self):
        return f"{self.width}×{self.height} of {self.components} components"

    def shape(self):
        return self.width, self.height, self.components


def write_png(path, picture):
    """Writes an array as PNG."""
    _write(path, Picture.of(picture))


def _write(path, picture):
    kind = next(kind for kind, count in _COMPONENTS.items() if count == picture.components)
    size = picture.width * picture.components
    rows = b"".join(b"\0" + picture.data[at:at + size] for at in range(0, len(picture.data), size))
    header = struct.pack(">IIBBBBB", picture.width, picture.height, 8, kind, 0, 0, 0)
    chunks = [(b"IHDR", header), (b"IDAT", zlib.compress(rows, 9)), (b"IEND", b"")]
    text = _SIGNATURE
    for name, data in chunks:
        text += struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    Path(path).parent.mkdir(parents=True, exist_ok=True)
    Path(path).write_bytes(text)


def read_png(path):
    """Reads a PNG of 8 bits a component, without a palette and not interlaced: what write_png and most tools write."""
    text = Path(path).read_bytes()
    refuse = ValueError(f"{path}: must be a PNG of 8 bits a component, without a palette, not interlaced")
    if not text.startswith(_SIGNATURE):
        raise refuse
    at, packed = len(_SIGNATURE), b""
    while at < len(text):
        length, name = struct.unpack_from(">I4s", text, at)
        data = text[at + 8:at + 8 + length]
        if name == b"IHDR":
            width, height, depth, kind, _, _, interlaced = struct.unpack(">IIBBBBB", data)
        elif name == b"IDAT":
            packed += data
        at += length + 12
    if depth != 8 or kind not in _COMPONENTS or interlaced:
        raise refuse
    components = _COMPONENTS[kind]
    return Picture(width, height, components, _unfilter(zlib.decompress(packed), width * components, components))


def _unfilter(text, size, step):
    """PNG's filters (section 9.2), undone."""
    out, before = bytearray(), bytearray(size)
    for at in range(0, len(text), size + 1):
        kind, row = text[at], bytearray(text[at + 1:at + 1 + size])
        for x in range(size) if kind else ():
            left = row[x - step] if x >= step else 0
            up, corner = before[x], before[x - step] if x >= step else 0
            if kind == 1:
                guess = left
            elif kind == 2:
                guess = up
            elif kind == 3:
                guess = (left + up) // 2
            else:
                base = left + up - corner
                guess = min((abs(base - left), 0, left), (abs(base - up), 1, up), (abs(base - corner), 2, corner))[2]
            row[x] = (row[x] + guess) & 255
        out += row
        before = row
    return bytes(out)


class Difference:
    """How two pictures of one shape differ: count (pixels), largest (of a component), first (x, y from the top)."""

    def __init__(self, old, new):
        step = old.components
        apart = bytes(abs(a - b) for a, b in zip(old.data, new.data))
        wrong = [at // step for at in range(0, len(apart), step) if any(apart[at:at + step])]
        self.count, self.largest = len(wrong), max(apart, default=0)
        self.first = (wrong[0] % old.width, wrong[0] // old.width) if wrong else None
        self._apart = Picture(*old.shape(), apart)

    def picture(self):
        """The difference × 16, without alpha, which would hide it."""
        apart, step = self._apart, self._apart.components
        bright = bytes(min(value * _AMPLIFIED, 255) for value in apart.data)
        if step in (1, 3):
            return Picture(*apart.shape(), bright)
        colors = [bright[at:at + step - 1] for at in range(0, len(bright), step)]
        # What differs in alpha alone would be black.
        seen = (color if any(color) else bright[at * step + step - 1:at * step + step] * (step - 1)
                for at, color in enumerate(colors))
        return Picture(apart.width, apart.height, step - 1, b"".join(seen))

    def __str__(self):
        return f"{self.count} pixels differ, by {self.largest} at most, first at {self.first}"


def compare(old, new):
    """The difference of two arrays of one shape."""
    old, new = Picture.of(old), Picture.of(new)
    if old.shape() != new.shape():
        raise ValueError(f"compare(): one is {old}, the other {new}")
    return Difference(old, new)


class Golden:
    """Compares pictures with those of a folder.

    folder has the pictures that were looked at; what differs is written to failures. With bless the folder gets the
    new pictures instead."""

    def __init__(self, folder, failures, bless=False):
        self.folder, self.failures, self.bless = Path(folder), Path(failures), bless

    def check(self, picture, name, tolerance=0):
        """Raises GoldenError if a picture is not the one of this name. tolerance is how far a component may be away;
        DetGL's own pictures need none."""
        self._check(Picture.of(picture), name, tolerance)

    def check_file(self, path, name, tolerance=0):
        """As check, of a picture that a program has written as PNG."""
        self._check(read_png(path), name, tolerance)

    def _check(self, new, name, tolerance):
        path = self.folder / f"{name}.png"
        if self.bless:
            if not path.exists() or _bytes(read_png(path)) != _bytes(new):
                _write(path, new)
            return
        if not path.exists():
            self._fail(name, None, new, "there is no picture to compare with")
        old = read_png(path)
        if old.shape() != new.shape():
            self._fail(name, old, new, f"the old is {old}, the new {new}")
        if old.data == new.data:
            return
        difference = Difference(old, new)
        if difference.largest > tolerance:
            self._fail(name, old, new, str(difference), difference.picture())

    def _fail(self, name, old, new, why, difference=None):
        for kind, picture in [("old", old), ("new", new), ("difference", difference)]:
            path = self.failures / f"{name}-{kind}.png"
            if picture is not None:
                _write(path, picture)
            elif path.exists():
                path.unlink()
        (self.failures / f"{name}.txt").write_text(why + "\n")
        page = write_page(self.failures)
        raise GoldenError(f"{name}: {why}. See {page}; if it is right, look at it and run `pytest --bless`")


def _bytes(picture):
    return picture.shape(), picture.data


def write_page(failures):
    """Writes index.html of all failures in a folder."""
    rows = []
    for text in sorted(Path(failures).rglob("*.txt")):
        name = text.relative_to(failures).with_suffix("").as_posix()
        cells = "".join(
            f'<figure><img src="{html.escape(name)}-{kind}.png"><figcaption>{caption}</figcaption></figure>'
            for kind, caption in [("old", "old"), ("new", "new"), ("difference", f"difference × {_AMPLIFIED}")]
            if text.with_name(f"{text.stem}-{kind}.png").exists()
        )
        rows.append(f"<h2>{html.escape(name)}</h2><p>{html.escape(text.read_text())}</p><div>{cells}</div>")
    page = Path(failures) / "index.html"
    page.write_text(
        '<!doctype html><meta charset="utf-8"><title>Pictures that differ</title><style>'
        "body{font:15px sans-serif;margin:2em}div{display:flex;gap:1em;flex-wrap:wrap}figure{margin:0}"
        "img{image-rendering:pixelated;min-width:256px;border:1px solid #999}</style>"
        f"<h1>{len(rows)} pictures differ</h1>{''.join(rows)}\n",
        encoding="utf-8",
    )
    return page
