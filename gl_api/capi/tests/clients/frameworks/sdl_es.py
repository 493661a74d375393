"""A textured floor of OpenGL ES in a window of SDL's: GLSL ES 3.00, an ETC2 texture, a mipmap, a framebuffer object.
Writes the picture as PPM: sdl_es.py OUT."""

import ctypes
import os
import sys

os.environ["PYOPENGL_PLATFORM"] = "egl"

import ppm

SIZE = (240, 180)

VERTEX = """#version 300 es
layout(location = 0) in vec2 corner;
out vec2 st;
void main() {
    float depth = corner.y < 0.0 ? 1.0 : 6.0;
    st = vec2(corner.x * 4.0, corner.y) * depth;
    gl_Position = vec4(corner * depth, 0.0, depth);
}
"""

FRAGMENT = """#version 300 es
precision highp float;
uniform sampler2D floor_texture;
uniform sampler2D blocks;
in vec2 st;
layout(location = 0) out vec4 color;
void main() {
    vec4 tint = texture(blocks, fract(st * 0.25));
    color = mix(texture(floor_texture, st), tint, 0.5);
}
"""


def shader(gl, ty, text):
    name = gl.glCreateShader(ty)
    gl.glShaderSource(name, text)
    gl.glCompileShader(name)
    assert gl.glGetShaderiv(name, gl.GL_COMPILE_STATUS), gl.glGetShaderInfoLog(name)
    return name


def window(sdl):
    assert sdl.SDL_Init(sdl.SDL_INIT_VIDEO) == 0, sdl.SDL_GetError()
    for name, value in (
        (sdl.SDL_GL_CONTEXT_PROFILE_MASK, sdl.SDL_GL_CONTEXT_PROFILE_ES),
        (sdl.SDL_GL_CONTEXT_MAJOR_VERSION, 3),
        (sdl.SDL_GL_CONTEXT_MINOR_VERSION, 0),
    ):
        sdl.SDL_GL_SetAttribute(name, value)
    made = sdl.SDL_CreateWindow(b"es", 0, 0, *SIZE, sdl.SDL_WINDOW_OPENGL)
    assert made, sdl.SDL_GetError()
    context = sdl.SDL_GL_CreateContext(made)
    assert context, sdl.SDL_GetError()
    return made, context


def main(out):
    import sdl2 as sdl

    made = window(sdl)
    from OpenGL import GLES3 as gl

    version = ctypes.string_at(gl.glGetString(gl.GL_VERSION))
    assert version.startswith(b"OpenGL ES 3."), version
    program = gl.glCreateProgram()
    for ty, text in ((gl.GL_VERTEX_SHADER, VERTEX), (gl.GL_FRAGMENT_SHADER, FRAGMENT)):
        gl.glAttachShader(program, shader(gl, ty, text))
    gl.glLinkProgram(program)
    assert gl.glGetProgramiv(program, gl.GL_LINK_STATUS), gl.glGetProgramInfoLog(program)
    gl.glUseProgram(program)

    checkers, blocks, target = gl.glGenTextures(3)
    gl.glActiveTexture(gl.GL_TEXTURE0)
    gl.glBindTexture(gl.GL_TEXTURE_2D, checkers)
    side = 64
    texels = bytearray()
    for y in range(side):
        for x in range(side):
            light = 255 if (x // 8 + y // 8) % 2 else 40
            texels += bytes((light, x * 4, y * 4, 255))
    gl.glTexImage2D(
        gl.GL_TEXTURE_2D, 0, gl.GL_RGBA8, side, side, 0, gl.GL_RGBA, gl.GL_UNSIGNED_BYTE, bytes(texels)
    )
    gl.glGenerateMipmap(gl.GL_TEXTURE_2D)
    gl.glTexParameteri(gl.GL_TEXTURE_2D, gl.GL_TEXTURE_MIN_FILTER, gl.GL_LINEAR_MIPMAP_LINEAR)

    # Blocks of all modes of ETC2: individual, differential, T, H and planar.
    gl.glActiveTexture(gl.GL_TEXTURE1)
    gl.glBindTexture(gl.GL_TEXTURE_2D, blocks)
    state, words = 1, bytearray()
    for _ in range(64):
        word = bytearray()
        for _ in range(8):
            state = (state * 1103515245 + 12345) % (1 << 31)
            word.append(state >> 16 & 255)
        words += word
    gl.glCompressedTexImage2D(
        gl.GL_TEXTURE_2D, 0, gl.GL_COMPRESSED_RGB8_ETC2, 32, 32, 0, len(words), bytes(words)
    )
    gl.glTexParameteri(gl.GL_TEXTURE_2D, gl.GL_TEXTURE_MIN_FILTER, gl.GL_NEAREST)
    gl.glTexParameteri(gl.GL_TEXTURE_2D, gl.GL_TEXTURE_MAG_FILTER, gl.GL_NEAREST)
    gl.glUniform1i(gl.glGetUniformLocation(program, "blocks"), 1)

    gl.glActiveTexture(gl.GL_TEXTURE2)
    gl.glBindTexture(gl.GL_TEXTURE_2D, target)
    gl.glTexStorage2D(gl.GL_TEXTURE_2D, 1, gl.GL_RGBA8, *SIZE)
    framebuffer = gl.glGenFramebuffers(1)
    gl.glBindFramebuffer(gl.GL_FRAMEBUFFER, framebuffer)
    gl.glFramebufferTexture2D(
        gl.GL_FRAMEBUFFER, gl.GL_COLOR_ATTACHMENT0, gl.GL_TEXTURE_2D, target, 0
    )
    assert gl.glCheckFramebufferStatus(gl.GL_FRAMEBUFFER) == gl.GL_FRAMEBUFFER_COMPLETE

    gl.glViewport(0, 0, *SIZE)
    gl.glClearColor(0.1, 0.2, 0.3, 1.0)
    gl.glClear(gl.GL_COLOR_BUFFER_BIT)
    corners = (ctypes.c_float * 8)(-0.9, -0.9, 0.9, -0.9, -0.9, 0.9, 0.9, 0.9)
    buffer = gl.glGenBuffers(1)
    gl.glBindBuffer(gl.GL_ARRAY_BUFFER, buffer)
    gl.glBufferData(gl.GL_ARRAY_BUFFER, ctypes.sizeof(corners), corners, gl.GL_STATIC_DRAW)
    gl.glEnableVertexAttribArray(0)
    gl.glVertexAttribPointer(0, 2, gl.GL_FLOAT, False, 0, None)
    gl.glDrawArrays(gl.GL_TRIANGLE_STRIP, 0, 4)
    rows = (ctypes.c_ubyte * (4 * SIZE[0] * SIZE[1]))()
    gl.glReadPixels(0, 0, *SIZE, gl.GL_RGBA, gl.GL_UNSIGNED_BYTE, rows)
    assert gl.glGetError() == gl.GL_NO_ERROR
    sdl.SDL_GL_SwapWindow(made[0])
    ppm.write(out, *SIZE, ppm.from_below(rows, SIZE[0], 4))


main(*sys.argv[1:])
