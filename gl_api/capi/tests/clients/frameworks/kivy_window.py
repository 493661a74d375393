"""Kivy in a window of SDL's: a button, a slider, a turned square. Writes the picture as
PPM: kivy_window.py OUT."""

import os
import sys

OUT = sys.argv[1]
os.environ.update(KIVY_NO_ARGS="1", KIVY_GL_BACKEND="sdl2",
                  KIVY_NO_CONFIG="1", KIVY_NO_FILELOG="1")

import ppm  # noqa: E402
from kivy.config import Config  # noqa: E402

SIZE = (320, 240)
Config.set("graphics", "width", str(SIZE[0]))
Config.set("graphics", "height", str(SIZE[1]))

from kivy.app import App  # noqa: E402
from kivy.core.window import Window  # noqa: E402
from kivy.graphics import Color, Rectangle, Rotate  # noqa: E402
from kivy.graphics.opengl import GL_RGBA, GL_UNSIGNED_BYTE, glReadPixels  # noqa: E402
from kivy.uix.boxlayout import BoxLayout  # noqa: E402
from kivy.uix.button import Button  # noqa: E402
from kivy.uix.slider import Slider  # noqa: E402


class Client(App):
    def build(self):
        box = BoxLayout(orientation="vertical")
        box.add_widget(Button(text="Hello, DetGL"))
        box.add_widget(Slider(value=30))
        with box.canvas.after:
            Color(1, 0.5, 0, 0.7)
            Rotate(angle=30, origin=(160, 120))
            Rectangle(pos=(130, 90), size=(60, 60))
        self.frames = 0
        Window.bind(on_flip=self.finish)
        return box

    def finish(self, _):
        """Before a frame is shown: the third has all that is laid out."""
        self.frames += 1
        if self.frames < 3:
            self.root.canvas.ask_update()
            return
        rows = glReadPixels(0, 0, *SIZE, GL_RGBA, GL_UNSIGNED_BYTE)
        ppm.write(OUT, *SIZE, ppm.from_below(rows, SIZE[0], 4))
        self.stop()


Client().run()
