"""pyrender offscreen: a lit sphere over a box, with the shadow map of a spot light. It asks for OpenGL 4.1 and uses no
more than 3.3, see DETGL_GL_VERSION. Writes the picture as PPM: pyrender_shadows.py OUT."""

import os
import sys

os.environ["PYOPENGL_PLATFORM"] = "egl"
os.environ["DETGL_GL_VERSION"] = "4.1"

import numpy as np

if not hasattr(np, "infty"):
    # pyrender 0.1.45 is older than NumPy 2.
    np.infty = np.inf

import ppm
import pyrender
import trimesh

SIZE = (320, 240)


def main(out):
    scene = pyrender.Scene(ambient_light=[0.1] * 3)
    sphere = trimesh.creation.icosphere(subdivisions=3, radius=0.5)
    scene.add(pyrender.Mesh.from_trimesh(sphere, smooth=True))
    below = np.eye(4)
    below[2, 3] = -0.6
    scene.add(pyrender.Mesh.from_trimesh(trimesh.creation.box((3, 3, 0.05))), pose=below)
    half = np.sqrt(0.5)
    camera = np.array(
        [[1, 0, 0, 0], [0, half, -half, -1.5], [0, half, half, 1.5], [0, 0, 0, 1.0]])
    scene.add(pyrender.PerspectiveCamera(yfov=1.0), pose=camera)
    light = np.eye(4)
    light[:3, 3] = [1, -1, 3]
    spot = pyrender.SpotLight(intensity=30, innerConeAngle=0.3, outerConeAngle=0.7)
    scene.add(spot, pose=light)
    scene.add(pyrender.DirectionalLight(intensity=1.0), pose=camera)
    renderer = pyrender.OffscreenRenderer(*SIZE)
    color, _ = renderer.render(scene, flags=pyrender.RenderFlags.SHADOWS_SPOT)
    ppm.write(out, *SIZE, np.ascontiguousarray(color).tobytes())


main(sys.argv[1])
