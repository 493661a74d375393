"""The compositor Weston without a screen, its GL renderer (OpenGL ES), and a client that shows an image. Writes what the
screenshooter sees as PPM: weston_desktop.py OUT."""

import os
import struct
import subprocess
import sys
import tempfile
import time
import zlib

import ppm

SIZE = (320, 240)
CONFIG = """[core]
shell=desktop-shell.so
idle-time=0
[shell]
background-color=0xff336699
panel-position=none
animation=none
startup-animation=none
locking=false
"""


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def write_png(path, side=160):
    rows = b"".join(
        b"\0" + b"".join(bytes((x, y, 255 if (x // 8 + y // 8) % 2 else 60)) for x in range(side))
        for y in range(side))
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", side, side, 8, 2, 0, 0, 0))
                   + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def paeth(left, up, corner):
    far = [abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)]
    return (left, up, corner)[far.index(min(far))]


def read_png(path):
    """The RGB bytes of a PNG of 8 bits, of RGB or RGBA, not interlaced."""
    with open(path, "rb") as file:
        data = file.read()
    at, packed, header = 8, b"", None
    while at < len(data):
        size, name = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        header = struct.unpack(">IIBBBBB", body) if name == b"IHDR" else header
        packed += body if name == b"IDAT" else b""
        at += size + 12
    width, height, bits, kind, _, _, interlaced = header
    assert bits == 8 and interlaced == 0 and (width, height) == SIZE
    step = {2: 3, 6: 4}[kind]
    rows, above, out = zlib.decompress(packed), bytes(width * step), b""
    for y in range(height):
        start = y * (width * step + 1)
        kind, row = rows[start], bytearray(rows[start + 1:start + 1 + width * step])
        for x in range(len(row)):
            left, corner = (row[x - step], above[x - step]) if x >= step else (0, 0)
            row[x] = (row[x] + (0, left, above[x], (left + above[x]) // 2, paeth(left, above[x], corner))[kind]) & 255
        out += b"".join(bytes(row[x:x + 3]) for x in range(0, len(row), step))
        above = bytes(row)
    return out


def screenshot(folder):
    for name in os.listdir(folder):
        os.remove(os.path.join(folder, name))
    shot = subprocess.run(["weston-screenshooter"], cwd=folder, capture_output=True, timeout=30)
    files = os.listdir(folder)
    return read_png(os.path.join(folder, files[0])) if shot.returncode == 0 and files else None


def shown(folder):
    """What is seen once the window is there and nothing moves any more."""
    before = None
    for _ in range(100):
        time.sleep(0.3)
        seen = screenshot(folder)
        pixels = {seen[at:at + 3] for at in range(0, len(seen), 3)} if seen else set()
        if len(pixels) > 1000 and seen == before:
            return seen
        before = seen
    sys.exit("the window did not come")


def main(out):
    with tempfile.TemporaryDirectory() as folder:
        os.environ.update(XDG_RUNTIME_DIR=folder, WAYLAND_DISPLAY="wayland-test")
        config, image, shots = (os.path.join(folder, name) for name in ("weston.ini", "image.png", "shots"))
        os.mkdir(shots)
        with open(config, "w") as file:
            file.write(CONFIG)
        write_png(image)
        options = ["--backend=headless-backend.so", "--use-gl", "--width=%d" % SIZE[0], "--height=%d" % SIZE[1],
                   "--socket=wayland-test", "--config=" + config, "--log=" + os.path.join(folder, "log"), "--debug"]
        running = [subprocess.Popen(["weston", *options])]
        try:
            for _ in range(100):
                if os.path.exists(os.path.join(folder, "wayland-test")):
                    break
                time.sleep(0.1)
            running.append(subprocess.Popen(["weston-image", image], stderr=subprocess.DEVNULL))
            ppm.write(out, *SIZE, shown(shots))
        finally:
            for process in reversed(running):
                process.terminate()
                process.wait()


main(sys.argv[1])
