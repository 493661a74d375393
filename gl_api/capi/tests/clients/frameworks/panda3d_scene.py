"""Panda3D's own models, lit and in fog by the fixed function, with a shader on one of them. Writes the
picture as PPM: panda3d_scene.py OUT."""

import sys

import ppm
from panda3d.core import Fog, PointLight, Shader, loadPrcFileData

VERTEX = """#version 120
uniform mat4 p3d_ModelViewProjectionMatrix;
uniform mat3 p3d_NormalMatrix;
attribute vec4 p3d_Vertex;
attribute vec3 p3d_Normal;
attribute vec4 p3d_Color;
attribute vec2 p3d_MultiTexCoord0;
varying vec3 normal;
varying vec3 fur;
varying vec2 coords;
void main() {
    fur = p3d_Color.rgb;
    normal = p3d_NormalMatrix * p3d_Normal;
    coords = p3d_MultiTexCoord0;
    gl_Position = p3d_ModelViewProjectionMatrix * p3d_Vertex;
}"""
FRAGMENT = """#version 120
uniform sampler2D p3d_Texture0;
varying vec3 normal;
varying vec3 fur;
varying vec2 coords;
void main() {
    float rim = 1.0 - abs(normalize(normal).z);
    vec3 color = fur * texture2D(p3d_Texture0, coords).rgb * (0.4 + 0.6 * (1.0 - rim));
    gl_FragColor = vec4(color + rim * vec3(0.5, 0.2, 0.1), 1.0);
}"""


def main(out):
    loadPrcFileData("", """
        window-type offscreen
        load-display p3headlessgl
        audio-library-name null
        win-size 320 240
    """)
    from direct.showbase.ShowBase import ShowBase

    base = ShowBase(windowType="offscreen")
    base.setBackgroundColor(0.3, 0.4, 0.5)
    panda = base.loader.loadModel("panda")
    panda.reparentTo(base.render)
    panda.setPos(-3, 0, 0)
    panda.setScale(0.5)
    other = base.loader.loadModel("panda")
    other.reparentTo(base.render)
    other.setPos(3, 0, 0)
    other.setScale(0.5)
    other.setShader(Shader.make(Shader.SL_GLSL, VERTEX, FRAGMENT))
    ground = base.loader.loadModel("environment")
    ground.reparentTo(base.render)
    ground.setScale(0.25)
    ground.setPos(-8, 42, 0)
    light = PointLight("light")
    light.setColor((0.9, 0.9, 0.8, 1))
    lamp = base.render.attachNewNode(light)
    lamp.setPos(6, -12, 15)
    panda.setLight(lamp)
    fog = Fog("fog")
    fog.setColor(0.3, 0.4, 0.5)
    fog.setExpDensity(0.02)
    panda.setFog(fog)
    base.camera.setPos(0, -22, 8)
    base.camera.lookAt(0, 0, 2.5)
    for _ in range(2):
        base.graphicsEngine.renderFrame()
    rows = base.win.getScreenshot().getRamImageAs("RGB").getData()
    ppm.write(out, 320, 240, ppm.from_below(rows, 320, 3))


main(*sys.argv[1:])
