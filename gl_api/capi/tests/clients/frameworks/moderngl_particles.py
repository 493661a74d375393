"""ModernGL with what it asks of an old context: a program, a buffer, 400 points into a framebuffer of its
own. Writes the picture as PPM: moderngl_particles.py OUT."""

import math
import struct
import sys

import moderngl
import ppm

SIZE = (320, 240)
VERTEX = """#version 130
in vec2 place;
in vec3 color;
out vec3 tint;
void main() {
    tint = color;
    gl_PointSize = 6.0;
    gl_Position = vec4(place, 0.0, 1.0);
}"""
FRAGMENT = """#version 130
in vec3 tint;
out vec4 result;
void main() {
    result = vec4(tint, 1.0);
}"""


def main(out):
    context = moderngl.create_standalone_context(backend="egl", require=210)
    program = context.program(vertex_shader=VERTEX, fragment_shader=FRAGMENT)
    points = b""
    for at in range(400):
        angle, radius = at * 2.399963, math.sqrt(at / 400) * 0.9
        place = (radius * math.cos(angle) * 0.75, radius * math.sin(angle))
        points += struct.pack("5f", *place, at / 400, 1 - at / 400, 0.5)
    buffer = context.buffer(points)
    array = context.vertex_array(program, [(buffer, "2f 3f", "place", "color")])
    target = context.simple_framebuffer(SIZE)
    target.use()
    target.clear(0.1, 0.1, 0.1, 1)
    context.enable(moderngl.PROGRAM_POINT_SIZE)
    array.render(moderngl.POINTS)
    ppm.write(out, *SIZE, ppm.from_below(target.read(alignment=1), SIZE[0], 3))


main(*sys.argv[1:])
