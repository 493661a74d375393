"""Arcade, headless: shapes of its shape lists, whose geometry shaders make them of points, and a text. Writes the
picture as PPM: arcade_shapes.py OUT."""

import os
import sys

os.environ["ARCADE_HEADLESS"] = "True"

import arcade
import ppm

SIZE = (320, 240)


def main(out):
    window = arcade.Window(*SIZE, "arcade", antialiasing=False)
    window.clear()
    arcade.draw_circle_filled(160, 120, 60, arcade.color.RED)
    arcade.draw_lbwh_rectangle_filled(20, 30, 60, 40, arcade.color.TEAL)
    arcade.draw_line(10, 230, 310, 180, arcade.color.YELLOW, 5)
    arcade.Text("DetGL", 230, 20, font_size=16).draw()
    picture = arcade.get_image(0, 0, *SIZE).convert("RGB")
    ppm.write(out, *SIZE, picture.tobytes())


main(sys.argv[1])
