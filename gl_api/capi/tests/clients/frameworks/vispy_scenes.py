"""Four scenes of vispy's side by side: markers, a volume, a lit surface, an image with text over it.
Writes the picture as PPM: vispy_scenes.py OUT."""

import sys

import numpy as np
import ppm
from vispy import app, scene
from vispy.scene import visuals


def markers(view):
    points = np.random.default_rng(1).normal(size=(500, 3), scale=0.4)
    markers = visuals.Markers(parent=view.scene)
    markers.set_data(points, edge_width=1, face_color=(1, 0.3, 0.5, 0.6), size=9)
    visuals.XYZAxis(parent=view.scene)
    view.camera = "turntable"


def volume(view):
    z, y, x = np.mgrid[-1:1:32j, -1:1:32j, -1:1:32j]
    density = np.exp(-3 * (x * x + y * y + z * z)) * (1 + 0.3 * np.sin(8 * x))
    visuals.Volume(density.astype(np.float32), method="translucent", cmap="fire",
                   parent=view.scene)
    view.camera = "turntable"
    view.camera.set_range()


def surface(view):
    x = np.linspace(-3, 3, 40)
    z = np.exp(-x[:, None] ** 2 - x[None, :] ** 2) * 2
    visuals.SurfacePlot(x, x, z, color=(0.3, 0.5, 1, 1), shading="smooth", parent=view.scene)
    view.camera = "turntable"
    view.camera.set_range()


def image(view):
    texels = np.random.default_rng(2).random((16, 16)).astype(np.float32)
    visuals.Image(texels, cmap="viridis", interpolation="bicubic", parent=view.scene)
    visuals.Text("DetGL", pos=(8, 8), font_size=20, color="white", parent=view.scene)
    view.camera = "panzoom"
    view.camera.set_range()


def main(out):
    app.use_app("egl")
    canvas = scene.SceneCanvas(size=(320, 240), show=True, bgcolor="white")
    grid = canvas.central_widget.add_grid()
    for at, fill in enumerate([markers, volume, surface, image]):
        fill(grid.add_view(row=at // 2, col=at % 2))
    pixels = canvas.render(alpha=False)
    ppm.write(out, pixels.shape[1], pixels.shape[0], np.ascontiguousarray(pixels).tobytes())


main(*sys.argv[1:])
