"""Pictures as the tests read them."""


def write(out, width, height, rgb):
    """Writes `rgb`, rows from the top, three bytes a pixel, as PPM."""
    rgb = bytes(rgb)
    assert len(rgb) == 3 * width * height
    with open(out, "wb") as file:
        file.write(b"P6\n%d %d\n255\n" % (width, height))
        file.write(rgb)


def from_below(rows, width, channels):
    """The RGB bytes, from the top, of rows from below with `channels` bytes a pixel."""
    rows = bytes(rows)
    size = width * channels
    up = [rows[at:at + size] for at in range(0, len(rows), size)]
    return b"".join(row[x:x + 3] for row in reversed(up) for x in range(0, size, channels))
