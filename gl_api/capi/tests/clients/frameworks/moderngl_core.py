"""ModernGL with the context that it asks for by default (OpenGL 3.3, core): instances whose places are in a buffer, a
uniform block, and a geometry shader that makes a fan of each. Writes the picture as PPM: moderngl_core.py OUT."""

import math
import struct
import sys

import moderngl
import ppm

SIZE = (320, 240)
VERTEX = """#version 330
in vec2 place;
in float turn;
out float angle;
void main() {
    angle = turn;
    gl_Position = vec4(place, 0.0, 1.0);
}"""
GEOMETRY = """#version 330
layout(points) in;
layout(triangle_strip, max_vertices = 18) out;
layout(std140) uniform Look { vec4 inner; vec4 rim; };
in float angle[];
out vec4 tint;
void corner(float a, float radius, vec4 color) {
    tint = color;
    gl_Position = gl_in[0].gl_Position + vec4(radius * cos(a) * 0.75, radius * sin(a), 0.0, 0.0);
    EmitVertex();
}
void main() {
    for (int i = 0; i < 6; i++) {
        float a = angle[0] + float(i) * 1.0471975512;
        corner(0.0, 0.0, inner);
        corner(a, 0.08, rim);
        corner(a + 0.8, 0.05, rim * 0.5);
        EndPrimitive();
    }
}"""
FRAGMENT = """#version 330
in vec4 tint;
layout(location = 0) out vec4 color;
void main() { color = vec4(tint.rgb, 1.0); }"""


def main(out):
    context = moderngl.create_standalone_context(backend="egl")
    assert context.version_code >= 330
    program = context.program(
        vertex_shader=VERTEX, geometry_shader=GEOMETRY, fragment_shader=FRAGMENT)
    points = b""
    for at in range(120):
        angle, radius = at * 2.399963, math.sqrt(at / 120) * 0.9
        points += struct.pack("3f", radius * math.cos(angle), radius * math.sin(angle), angle)
    look = context.buffer(struct.pack("8f", 1.0, 0.9, 0.4, 1.0, 0.2, 0.4, 0.9, 1.0))
    look.bind_to_uniform_block(0)
    program["Look"].binding = 0
    array = context.vertex_array(program, [(context.buffer(points), "2f 1f", "place", "turn")])
    target = context.simple_framebuffer(SIZE)
    target.use()
    target.clear(0.05, 0.05, 0.1, 1.0)
    array.render(moderngl.POINTS)
    ppm.write(out, *SIZE, ppm.from_below(target.read(components=3), SIZE[0], 3))


main(sys.argv[1])
