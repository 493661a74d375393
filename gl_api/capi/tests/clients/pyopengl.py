"""A decal by PyOpenGL's GLU, and a shader over a buffer object beside it, without a window. Writes
the picture as PPM: pyopengl.py IMAGE OUT, where IMAGE has 128x128 RGB texels as raw bytes.

PYOPENGL_PLATFORM says how it gets its context: egl or osmesa."""

import ctypes
import os
import sys

SIZE = 256
VERTEX = """#version 120
attribute vec2 position;
varying vec2 place;
void main() {
    place = position;
    gl_Position = vec4(position, 0.0, 1.0);
}"""
FRAGMENT = """#version 120
uniform vec3 tint;
varying vec2 place;
void main() {
    float ring = 0.5 + 0.5 * sin(40.0 * length(place - vec2(0.5, 0.0)));
    gl_FragColor = vec4(tint * ring, 1.0);
}"""


def with_egl():
    from OpenGL import EGL

    display = EGL.eglGetDisplay(EGL.EGL_DEFAULT_DISPLAY)
    assert EGL.eglInitialize(display, EGL.EGLint(), EGL.EGLint())
    assert EGL.eglBindAPI(EGL.EGL_OPENGL_API)
    wanted = [EGL.EGL_SURFACE_TYPE, EGL.EGL_PBUFFER_BIT, EGL.EGL_RENDERABLE_TYPE,
              EGL.EGL_OPENGL_BIT, EGL.EGL_RED_SIZE, 8, EGL.EGL_NONE]
    config, count = (EGL.EGLConfig * 1)(), EGL.EGLint()
    wanted = (EGL.EGLint * len(wanted))(*wanted)
    assert EGL.eglChooseConfig(display, wanted, config, 1, count) and count.value == 1
    size = [EGL.EGL_WIDTH, SIZE, EGL.EGL_HEIGHT, SIZE, EGL.EGL_NONE]
    surface = EGL.eglCreatePbufferSurface(display, config[0], (EGL.EGLint * len(size))(*size))
    context = EGL.eglCreateContext(display, config[0], EGL.EGL_NO_CONTEXT, None)
    assert EGL.eglMakeCurrent(display, surface, surface, context)
    return context


def with_osmesa():
    from OpenGL import GL, arrays, osmesa

    context = osmesa.OSMesaCreateContextExt(GL.GL_RGBA, 24, 8, 0, None)
    memory = arrays.GLubyteArray.zeros((SIZE, SIZE, 4))
    assert osmesa.OSMesaMakeCurrent(context, memory, GL.GL_UNSIGNED_BYTE, SIZE, SIZE)
    return context, memory


def decal(texels):
    from OpenGL import GL as gl
    from OpenGL import GLU as glu

    gl.glPixelStorei(gl.GL_UNPACK_ALIGNMENT, 1)
    gl.glBindTexture(gl.GL_TEXTURE_2D, 666)
    glu.gluBuild2DMipmaps(gl.GL_TEXTURE_2D, gl.GL_RGB8, 128, 128, gl.GL_RGB, gl.GL_UNSIGNED_BYTE,
                          texels)
    gl.glTexParameteri(gl.GL_TEXTURE_2D, gl.GL_TEXTURE_MIN_FILTER, gl.GL_LINEAR_MIPMAP_LINEAR)
    gl.glTexEnvf(gl.GL_TEXTURE_ENV, gl.GL_TEXTURE_ENV_MODE, gl.GL_REPLACE)
    gl.glEnable(gl.GL_TEXTURE_2D)
    gl.glBegin(gl.GL_TRIANGLES)
    for (s, t), (x, y) in [((0, 0), (-1, 0.8)), ((1, 0), (0, 0.8)), ((0.5, 1), (-0.5, -0.8))]:
        gl.glTexCoord2f(s, t)
        gl.glVertex2f(x, y)
    gl.glEnd()


def shader():
    from OpenGL import GL as gl
    from OpenGL.GL import shaders

    program = shaders.compileProgram(
        shaders.compileShader(VERTEX, gl.GL_VERTEX_SHADER),
        shaders.compileShader(FRAGMENT, gl.GL_FRAGMENT_SHADER),
    )
    corners = (ctypes.c_float * 8)(0, -1, 1, -1, 0, 1, 1, 1)
    buffer = gl.glGenBuffers(1)
    gl.glBindBuffer(gl.GL_ARRAY_BUFFER, buffer)
    gl.glBufferData(gl.GL_ARRAY_BUFFER, ctypes.sizeof(corners), corners, gl.GL_STATIC_DRAW)
    gl.glUseProgram(program)
    gl.glUniform3f(gl.glGetUniformLocation(program, "tint"), 0.9, 0.6, 0.2)
    position = gl.glGetAttribLocation(program, "position")
    gl.glEnableVertexAttribArray(position)
    gl.glVertexAttribPointer(position, 2, gl.GL_FLOAT, False, 0, None)
    gl.glDrawArrays(gl.GL_TRIANGLE_STRIP, 0, 4)


def main(image, out):
    context = {"egl": with_egl, "osmesa": with_osmesa}[os.environ["PYOPENGL_PLATFORM"]]()
    from OpenGL import GL as gl

    with open(image, "rb") as file:
        decal(file.read())
    shader()
    gl.glPixelStorei(gl.GL_PACK_ALIGNMENT, 1)
    pixels = gl.glReadPixels(0, 0, SIZE, SIZE, gl.GL_RGB, gl.GL_UNSIGNED_BYTE, outputType=bytes)
    with open(out, "wb") as file:
        file.write(b"P6\n%d %d\n255\n" % (SIZE, SIZE))
        file.write(pixels)
    assert context


main(*sys.argv[1:])
