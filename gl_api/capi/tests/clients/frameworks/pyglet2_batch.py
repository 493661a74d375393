"""pyglet 2, headless: shapes, a label and a sprite in one batch. Writes the picture as PPM: pyglet2_batch.py OUT."""

import sys

import pyglet

pyglet.options["headless"] = True

import ppm
from pyglet import shapes

SIZE = (320, 240)


def main(out):
    window = pyglet.window.Window(*SIZE)
    batch = pyglet.graphics.Batch()
    pattern = pyglet.image.CheckerImagePattern((255, 220, 0, 255), (30, 60, 200, 255))
    kept = [
        shapes.Circle(90, 120, 60, color=(255, 80, 0), batch=batch),
        shapes.Star(230, 140, 70, 30, 7, color=(80, 220, 120, 200), batch=batch),
        pyglet.sprite.Sprite(pyglet.image.create(64, 64, pattern), x=130, y=20, batch=batch),
        shapes.BezierCurve((10, 10), (100, 230), (220, 0), (310, 220), thickness=3, batch=batch),
    ]
    window.clear()
    batch.draw()
    picture = pyglet.image.get_buffer_manager().get_color_buffer().get_image_data()
    ppm.write(out, *SIZE, ppm.from_below(picture.get_data("RGBA", SIZE[0] * 4), SIZE[0], 4))
    assert kept


main(sys.argv[1])
