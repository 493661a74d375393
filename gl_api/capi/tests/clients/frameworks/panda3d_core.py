"""Panda3D with a context of OpenGL 3.2, where its own shaders replace the fixed function. Writes the picture as PPM:
panda3d_core.py OUT."""

import sys

import ppm
from panda3d.core import Texture, loadPrcFileData

SIZE = (320, 240)
loadPrcFileData("", """
load-display p3headlessgl
window-type offscreen
gl-version 3 2
audio-library-name null
win-size %d %d
""" % SIZE)

from direct.showbase.ShowBase import ShowBase


def main(out):
    base = ShowBase()
    panda = base.loader.loadModel("models/panda")
    panda.reparentTo(base.render)
    panda.setPos(0, 30, -6)
    picture = Texture()
    base.win.addRenderTexture(picture, base.win.RTMCopyRam)
    base.graphicsEngine.renderFrame()
    base.graphicsEngine.renderFrame()
    rows = picture.getRamImageAs("RGB").getData()
    ppm.write(out, *SIZE, ppm.from_below(rows, SIZE[0], 3))


main(sys.argv[1])
