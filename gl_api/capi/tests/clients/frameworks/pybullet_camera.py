"""PyBullet's EGL renderer: four bodies and their shadows. Writes the picture as PPM: pybullet_camera.py OUT."""

import importlib.util
import sys

import ppm
import pybullet as bullet

SIZE = (320, 240)


def body(shape, color, place, **size):
    shown = bullet.createVisualShape(shape, rgbaColor=color, **size)
    return bullet.createMultiBody(0, -1, shown, place)


def main(out):
    bullet.connect(bullet.DIRECT)
    plugin = importlib.util.find_spec("eglRenderer")
    assert bullet.loadPlugin(plugin.origin, "_eglRendererPlugin") >= 0
    body(bullet.GEOM_BOX, (0.6, 0.6, 0.5, 1), (0, 0, -0.1), halfExtents=(3, 3, 0.1))
    body(bullet.GEOM_SPHERE, (0.9, 0.2, 0.2, 1), (0, 0, 0.6), radius=0.5)
    body(bullet.GEOM_BOX, (0.2, 0.4, 0.9, 1), (1.1, -0.4, 0.4), halfExtents=(0.3, 0.4, 0.4))
    body(bullet.GEOM_CYLINDER, (0.2, 0.9, 0.3, 1), (-1.1, 0.3, 0.6), radius=0.3, length=1.2)
    view = bullet.computeViewMatrix((2.5, -3.0, 2.2), (0, 0, 0.4), (0, 0, 1))
    seen = bullet.computeProjectionMatrixFOV(50, SIZE[0] / SIZE[1], 0.1, 20)
    picture = bullet.getCameraImage(
        *SIZE, view, seen, lightDirection=(3, -1, 4), shadow=1,
        renderer=bullet.ER_BULLET_HARDWARE_OPENGL)
    rgba = bytes(bytearray(picture[2].flatten() if hasattr(picture[2], "flatten") else picture[2]))
    ppm.write(out, *SIZE, b"".join(rgba[at:at + 3] for at in range(0, len(rgba), 4)))


main(sys.argv[1])
