"""A lecture's triangle with PyOpenGL: a decal with mipmaps, bound under the name 666, in immediate mode.

lecture.py OUT.png"""

import sys

import detgl

detgl.use(platform="osmesa")

from OpenGL import arrays, osmesa  # noqa: E402
from OpenGL.GL import *  # noqa: E402, F403
from OpenGL.GLU import gluBuild2DMipmaps  # noqa: E402
from detgl import golden  # noqa: E402

SIZE = 256


def decal():
    """RGB8 image data of 128x128: rings and a checker."""
    texels = bytearray()
    for y in range(128):
        for x in range(128):
            ring = ((x - 64) ** 2 + (y - 64) ** 2) // 300 % 2
            texels += bytes([230 - 150 * ring, 40 + 40 * ((x // 16 + y // 16) % 2), 60 * ring])
    return bytes(texels)


def draw():
    context = osmesa.OSMesaCreateContextExt(GL_RGBA, 24, 8, 0, None)
    memory = arrays.GLubyteArray.zeros((SIZE, SIZE, 4))
    assert osmesa.OSMesaMakeCurrent(context, memory, GL_UNSIGNED_BYTE, SIZE, SIZE)
    osmesa.OSMesaPixelStore(osmesa.OSMESA_Y_UP, 0)
    glClearColor(0.12, 0.13, 0.16, 1)
    glClear(GL_COLOR_BUFFER_BIT)

    # Tightly packed texture data.
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1)
    glBindTexture(GL_TEXTURE_2D, 666)
    gluBuild2DMipmaps(GL_TEXTURE_2D, GL_RGB8, 128, 128, GL_RGB, GL_UNSIGNED_BYTE, decal())
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR)
    glTexEnvf(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE)
    glEnable(GL_TEXTURE_2D)

    glBegin(GL_TRIANGLES)
    glTexCoord2f(0, 0)
    glVertex2f(-0.8, 0.8)
    glTexCoord2f(1, 0)
    glVertex2f(0.8, 0.8)
    glTexCoord2f(0.5, 1)
    glVertex2f(0.0, -0.8)
    glEnd()
    glFinish()
    assert detgl.messages() == []
    osmesa.OSMesaDestroyContext(context)
    return memory


if __name__ == "__main__":
    golden.write_png(sys.argv[1], draw())
