"""pyglet 1.5: text, shapes in a batch, a turned sprite. Writes the picture as PPM: pyglet_batch.py OUT."""

import sys

import ppm
import pyglet

pyglet.options["headless"] = True
SIZE = (320, 240)


def main(out):
    from pyglet import gl, image, shapes, sprite, text, window

    own = window.Window(*SIZE)
    own.switch_to()
    own.on_resize(*SIZE)
    gl.glClearColor(0.2, 0.3, 0.4, 1)
    own.clear()
    text.Label("Hello, DetGL", font_size=20, x=160, y=120, anchor_x="center",
               anchor_y="center").draw()
    batch = pyglet.graphics.Batch()
    drawn = [
        shapes.Circle(60, 60, 40, color=(255, 100, 0), batch=batch),
        shapes.Rectangle(200, 30, 80, 50, color=(0, 200, 100), batch=batch),
        shapes.Line(10, 230, 310, 150, width=4, color=(250, 250, 20), batch=batch),
        shapes.Star(250, 180, 40, 18, 5, color=(200, 80, 255), batch=batch),
    ]
    for shape in drawn:
        shape.opacity = 200
    batch.draw()
    white = image.SolidColorImagePattern((255, 255, 255, 128)).create_image(50, 50)
    turned = sprite.Sprite(white, x=130, y=20)
    turned.rotation = 30
    turned.draw()
    pixels = image.get_buffer_manager().get_color_buffer().get_image_data()
    rows = pixels.get_data("RGB", SIZE[0] * 3)
    ppm.write(out, *SIZE, ppm.from_below(rows, SIZE[0], 3))


main(*sys.argv[1:])
